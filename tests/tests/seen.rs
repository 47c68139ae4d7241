//! What of a sphere is above a horizon, against its form factor, and without jumps.

use sh_core::Routines;
use sh_core::seen::{OWN, Seen};
use sh_reference::horizon::share;
use sh_scene::{Light, Receiver, Sphere};
use std::f64::consts::PI;

const UP: [f64; 3] = [0.0, 1.0, 0.0];

/// A sphere of radius 1 at a height and a distance of its centre.
fn at(height: f64, distance: f64) -> Seen<f64> {
    let aside = (distance * distance - height * height).max(0.0).sqrt();
    Seen::above([0.6 * aside, height, 0.8 * aside], UP, 1.0, 0.0)
}

/// From touching to far, from wholly below to wholly above: the cap hides what the sphere does. A sphere that vanishes near
/// by, as by the rule of Ren et al. 2006, misses by up to .33.
#[test]
fn caps_hide_what_is_above_the_horizon() {
    let (mut worst, mut high, mut squares, mut count) = (0.0_f64, 0.0_f64, 0.0, 0.0);
    for i in 0..=80 {
        // Most of them nearly below and nearly above.
        let height = -(f64::from(i) / 80.0 * PI).cos();
        for j in 0..60 {
            let distance = 1.0 + 1e-6 * 1.3_f64.powi(j);
            if height.abs() >= distance {
                continue;
            }
            let seen = at(height, distance);
            // A cap of that radius hides sin² θ times the sine of its elevation.
            let elevation = seen.direction[1];
            let off = seen.sine.powi(2) * elevation - share(height, distance);
            worst = worst.max(off.abs());
            if height > -0.5 {
                high = high.max(off.abs());
            }
            squares += off * off;
            count += 1.0;
            assert!(
                elevation >= seen.sine - 1e-9,
                "{height} {distance}: cut again"
            );
        }
    }
    let mean = f64::sqrt(squares / count);
    println!("largest {worst:.4}, above -1/2 {high:.4}, root of the mean square {mean:.4}");
    assert!(
        worst < 0.0135 && high < 0.0106 && mean < 0.006,
        "{worst} {high} {mean}"
    );
}

/// Wholly above it is as it is, wholly below it is not there.
#[test]
fn what_is_not_cut_is_as_it_is() {
    for distance in [1.5, 3.0, 40.0] {
        let (above, whole) = (at(1.0, distance), 1.0 / distance);
        assert!((above.sine - whole).abs() < 1e-12);
        assert_eq!(at(-1.0, distance).sine, 0.0);
        assert_eq!(Seen::above([0.3, -4.0, 0.1], UP, 1.0, 0.0).sine, 0.0);
    }
}

/// Spheres of the receiver's own body do not count inside of them, and count as others do from a fifth of a radius outside.
#[test]
fn own_spheres_come_gradually() {
    let own = |distance: f64| Seen::above([0.0, distance, 0.0], UP, 1.0, 1.0).sine;
    assert_eq!(own(0.5), 0.0);
    let full = (1.0 - OWN).sqrt().recip() + 1e-9;
    assert_eq!(own(full), Seen::whole([0.0, full, 0.0], 1.0).sine);
    let steps: Vec<f64> = (0..=50)
        .map(|i| own(1.0 + 0.19 * f64::from(i) / 50.0))
        .collect();
    assert!(steps.is_sorted() && steps[0] == 0.0, "{steps:?}");
}

/// The largest change of any log coefficient between neighbouring steps of a receiver's way past a sphere of radius 1 around
/// the origin.
fn largest_step(steps: u32, own: f64, line: fn(f64) -> [[f64; 3]; 2]) -> f64 {
    let at = |i: u32| {
        let [position, normal] = line(f64::from(i) / f64::from(steps));
        let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
        let normal = normal.map(|x| x / length);
        let seen = Seen::above(position.map(|x| -x), normal, 1.0, own);
        [0.0; 16].accumulate_blocker(seen.sine, seen.cosine, seen.direction, [1.0; 4])
    };
    let change = |i: u32| {
        let pairs = at(i).into_iter().zip(at(i + 1));
        pairs.map(|(a, b)| f64::abs(a - b)).fold(0.0, f64::max)
    };
    (0..steps).map(change).fold(0.0, f64::max)
}

#[test]
fn a_way_over_into_and_out_of_a_sphere_has_no_jump() {
    type Line = fn(f64) -> [[f64; 3]; 2];
    let lines: [(&str, Line); 7] = [
        ("out along the plane, centre in front", |t| {
            [[0.05 + 3.0 * t, -0.4, 0.1], UP]
        }),
        ("out along the plane, centre behind", |t| {
            [[0.05 + 3.0 * t, 0.4, 0.1], UP]
        }),
        ("from wholly in front to wholly behind, inside", |t| {
            [[0.3, -1.5 + 3.0 * t, 0.2], UP]
        }),
        ("from wholly in front to wholly behind, beside", |t| {
            [[1.4, -1.5 + 3.0 * t, 0.2], UP]
        }),
        ("out through the side at a slant", |t| {
            [[-0.2 + 2.0 * t, -0.5 + t, 0.3], [0.3, 1.0, -0.2]]
        }),
        ("into the sphere and out again, facing along", |t| {
            [[-2.0 + 4.0 * t, 0.3, 0.2], [1.0, 0.2, 0.1]]
        }),
        ("turning in place", |t| {
            let (sin, cos) = (6.0 * t).sin_cos();
            [[1.3, 0.2, 0.0], [sin, cos, 0.2]]
        }),
    ];
    for own in [0.0, 1.0] {
        for (name, line) in lines {
            // 64 times finer steps: a slope's steps become 64 times smaller, those of a square root 8 times, those of a
            // jump stay.
            let [coarse, fine] = [500, 32_000].map(|steps| largest_step(steps, own, line));
            assert!(
                fine < coarse / 7.0 || fine < 1e-5,
                "{name}, {own}: {coarse} then {fine}"
            );
            assert!(own > 0.0 || coarse > 1e-4, "{name}: nothing happens");
        }
    }
}

/// The light of an even sky on the ground around a ball that rests on it or is sunk into it, from where the ground cuts it to a
/// radius farther: near the truth where feet used to have no shadow at all (off by .24 to .33).
#[test]
fn the_ground_around_a_sunk_ball_is_dark() {
    for accumulation in 4..=6 {
        let mut worst = (0.0_f64, 0.0, 0.0);
        for height in [0.0_f32, 0.25, 0.5, 0.75, 1.0] {
            let ball = Sphere {
                center: [0.0, height, 0.0],
                radius: 1.0,
            };
            let foot = (1.0 - height * height).sqrt();
            let receivers: Vec<Receiver> = (1..=64)
                .map(|i| Receiver {
                    position: [foot.max(0.05) + i as f32 / 64.0, 0.0, 0.0],
                    covered: 1,
                    normal: [0.0, 1.0, 0.0],
                    object: 0,
                })
                .collect();
            let light = Light {
                order: 4,
                coefficients: (0..16)
                    .map(|i| [if i == 0 { 1.0 } else { 0.0 }; 3])
                    .collect(),
                emitters: Vec::new(),
            };
            let mut found = vec![[0.0; 3]; receivers.len()];
            sh_cpu::shadow(&receivers, &[ball], &light, accumulation, &mut found)
                .expect("orders fit");
            let open = light.irradiance([0.0, 1.0, 0.0])[0];
            for (receiver, found) in receivers.iter().zip(&found) {
                let distance = f64::from(receiver.position[0].hypot(height));
                let truth = 1.0 - sh_reference::horizon::share(f64::from(height), distance);
                let off = (f64::from(found[0] / open) - truth).abs();
                if off > worst.0 {
                    worst = (off, height.into(), distance);
                }
            }
        }
        println!("{accumulation}: {worst:?}");
        assert!(worst.0 < 0.02, "order {accumulation}: {worst:?}");
    }
}
