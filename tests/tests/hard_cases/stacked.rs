//! Many blockers in one place: the sum of their logarithms grows with their number, the truth does not change.

use crate::blockers::{NUMBERS, add, axes, error, log};
use sh_reference::{arcs, visibility::Cap};
use sh_tests::worst::worst as worst_of_all;

/// The largest error over 1 to 4,096 blockers of a radius in degrees on an axis.
fn worst(order: usize, degrees: f64, axis: [f64; 3]) -> f64 {
    let cap = Cap {
        axis,
        angle: degrees.to_radians(),
    };
    let truth = arcs::project(order, &[cap]).coefficients;
    let mut worst = 0.0_f64;
    for (_, call) in NUMBERS {
        let mut sum = vec![0.0; order * order];
        for count in 1..=4096_usize {
            sum = add(call, order, sum, cap);
            if count.is_power_of_two() {
                let g = call("exp_saturating", order, std::slice::from_ref(&sum));
                worst = worst.max(error(&g, &truth));
            }
        }
    }
    worst
}

/// What is promised for blockers of 40 degrees and for any of 5 to 80, by order.
const PROMISED: [(usize, f64, f64); 5] = [
    (2, 0.31, 0.39),
    (3, 0.20, 0.40),
    (4, 0.13, 0.40),
    (5, 0.11, 0.40),
    (6, 0.13, 0.40),
];

#[test]
fn identical_blockers_of_any_number() {
    for (order, at_40, anywhere) in PROMISED {
        for degrees in [5.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0] {
            let bound = if degrees == 40.0 { at_40 } else { anywhere };
            for axis in axes() {
                let worst = worst(order, degrees, axis);
                assert!(
                    worst <= bound,
                    "order {order}, {degrees} degrees about {axis:?}: {worst:.3}, {bound} promised"
                );
            }
        }
    }
}

/// Blockers so many that the sum of their logarithms nears the end of f32's range leave what a few thousand do;
/// beyond a norm of 3e18, where sums are no longer told apart, they leave at least something bounded.
#[test]
fn a_sum_beyond_any_scene() {
    for (order, at_40, _) in PROMISED {
        for axis in axes() {
            let cap = Cap {
                axis,
                angle: 40_f64.to_radians(),
            };
            let truth = arcs::project(order, &[cap]).coefficients;
            for (number, call) in NUMBERS {
                let one = log(call, order, &[cap]);
                for (factor, bound) in [(1e4, at_40), (1e12, at_40), (1e17, at_40), (1e30, 0.6)] {
                    let sum = one.iter().map(|x| x * factor).collect();
                    let off = error(&call("exp_saturating", order, &[sum]), &truth);
                    assert!(
                        off <= bound,
                        "order {order}, {number}, {factor:e}: {off:.3}"
                    );
                }
            }
        }
    }
}

/// Any number of blockers of any radius about any axis, looked for: up to a norm of 3e18, and beyond.
#[test]
fn the_worst_of_stacks() {
    for (order, within, beyond) in SOUGHT {
        for (sizes, most) in [([0.0, 15.0], within), ([15.0, 36.0], beyond)] {
            let (off, at) = worst_of_all(order as u64, 400, |[z, turn, angle, size]| {
                stack(order, sizes, [z, turn, angle, size])
            });
            println!("order {order} {sizes:?}: {off:.3} {at:?}");
            assert!(off <= most, "order {order}: {off:.3} at {at:?}");
        }
    }
}

/// By order, up to a norm of 3e18 and beyond.
const SOUGHT: [(usize, f64, f64); 5] = [
    (2, 1.0, 1.0),
    (3, 1.0, 1.0),
    (4, 1.0, 1.0),
    (5, 1.0, 1.0),
    (6, 1.0, 1.0),
];

/// The error of 10^size blockers in one place, told by four numbers in 0..1.
fn stack(order: usize, sizes: [f64; 2], [z, turn, angle, size]: [f64; 4]) -> f64 {
    let (z, turn) = (2.0 * z - 1.0, std::f64::consts::TAU * turn);
    let flat = (1.0 - z * z).max(0.0).sqrt();
    let cap = Cap {
        axis: [flat * turn.cos(), flat * turn.sin(), z],
        angle: (90.0 * angle).to_radians(),
    };
    let truth = arcs::project(order, &[cap]).coefficients;
    let count = 10_f64.powf(sizes[0] + (sizes[1] - sizes[0]) * size);
    NUMBERS
        .map(|(_, call)| {
            let sum = log(call, order, &[cap]).iter().map(|x| x * count).collect();
            error(&call("exp_saturating", order, &[sum]), &truth)
        })
        .into_iter()
        .fold(0.0, f64::max)
}
