//! Many blockers in one place: the sum of their logarithms grows with their number, the truth does not change.

use crate::blockers::{NUMBERS, add, axes, error, log};
use sh_reference::{arcs, visibility::Cap};
use sh_tests::worst::worst as worst_of_all;

/// The largest error over 1 to 4,096 blockers of 40 degrees on an axis.
fn worst(order: usize, axis: [f64; 3]) -> f64 {
    let cap = Cap {
        axis,
        angle: 40_f64.to_radians(),
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

/// What is promised for blockers of 40 degrees, by order.
const PROMISED: [(usize, f64); 5] = [(2, 0.31), (3, 0.20), (4, 0.13), (5, 0.11), (6, 0.13)];

#[test]
fn identical_blockers_of_any_number() {
    for (order, bound) in PROMISED {
        for axis in axes() {
            let worst = worst(order, axis);
            assert!(
                worst <= bound,
                "order {order}, about {axis:?}: {worst:.3}, {bound} promised"
            );
        }
    }
}

/// What is promised for any number of blockers of any radius about any axis up to a norm of their sum of 3e18, and beyond; by
/// order.
const SOUGHT: [(usize, f64, f64); 5] = [
    (2, 0.39, 0.79),
    (3, 0.40, 0.60),
    (4, 0.42, 0.64),
    (5, 0.41, 0.63),
    (6, 0.42, 0.67),
];

/// Searched for: the smallest blockers, of which very many are needed to be dark, are the worst.
#[test]
fn the_worst_of_stacks() {
    for (order, within, beyond) in SOUGHT {
        for (sizes, most) in [([0.0, 15.0], within), ([15.0, 36.0], beyond)] {
            let (off, at) = worst_of_all(order as u64, 150, |at| stack(order, sizes, at));
            println!("order {order}, {sizes:?}: {off:.3}");
            assert!(off <= most, "order {order}: {off:.3} at {at:?}");
            assert!(off > 0.8 * most, "order {order}: {off:.3}, {most} promised");
        }
    }
}

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
