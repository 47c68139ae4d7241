//! One receiver's sum of logarithms.

use sh_cpu::{Blockers, Outline, Point};
use sh_scene::{Blocker, Sphere};

const BALL: Sphere = Sphere {
    center: [0.4, 3.0, -0.2],
    radius: 1.2,
};

fn sum(front: &[Blocker], across: &[Blocker], object: f64) -> [f64; 25] {
    let point = Point {
        position: [0.1_f64, 0.2, 0.3],
        normal: [0.0, 1.0, 0.0],
        object,
        gloss: None,
    };
    <f64 as Outline<25>>::accumulate(&[0.5; 25], &point, Blockers { front, across })
}

#[test]
fn in_front_both_ways_agree() {
    let ball = [Blocker::new(BALL)];
    for (a, b) in sum(&ball, &[], 0.0).iter().zip(sum(&[], &ball, 0.0)) {
        assert!((a - b).abs() < 1e-12, "{a} {b}");
    }
}

/// A ball of another body, of none, and far enough away counts whole; one of the receiver's own body, near by, less.
#[test]
fn only_a_ball_of_the_own_body_counts_less_near_by() {
    let of = |object: u32, center: [f32; 3]| {
        let sphere = Sphere { center, ..BALL };
        [Blocker {
            object,
            ..Blocker::new(sphere)
        }]
    };
    let near = [0.4, 1.5, -0.2];
    let whole = sum(&[], &of(0, near), 7.0);
    assert_eq!(sum(&[], &of(3, near), 7.0), whole);
    assert_eq!(sum(&[], &of(0, near), 0.0), whole);
    assert!(sum(&[], &of(7, near), 7.0)[0] > whole[0]);
    let far = |object: u32| sum(&[], &of(object, BALL.center), 7.0);
    assert_eq!(far(7), far(3));
}
