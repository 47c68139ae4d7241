//! Many blockers in one place: the sum of their logarithms grows with their number, the truth does not change.

use crate::blockers::{NUMBERS, add, axes, error, log};
use sh_reference::{arcs, visibility::Cap};

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
