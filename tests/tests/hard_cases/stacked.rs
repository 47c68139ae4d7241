//! Many blockers in one place: the sum of their logarithms grows with their number, the truth does not change.

use crate::blockers::{FULL, NUMBERS, add, axes, error, log};
use sh_reference::{arcs, visibility::Cap};
use sh_tests::worst::worst as worst_of_all;

/// What 1 to 4,096 blockers of 40 degrees err by, at most.
#[derive(Clone, Copy, Debug, Default)]
struct Worst {
    /// One alone.
    one: f64,
    /// Any number.
    any: f64,
    /// By how much the mean visibility is too bright.
    brighter: f64,
}

/// Over blockers on an axis, and what no blocker at all would err by.
fn worst(order: usize, axis: [f64; 3]) -> (Worst, f64) {
    let cap = Cap {
        axis,
        angle: 40_f64.to_radians(),
    };
    let truth = arcs::project(order, &[cap]).coefficients;
    let mut worst = Worst::default();
    for (_, call) in NUMBERS {
        let mut sum = vec![0.0; order * order];
        for count in 1..=4096_usize {
            sum = add(call, order, sum, cap);
            if count.is_power_of_two() {
                let g = call("exp_saturating", order, std::slice::from_ref(&sum));
                let off = error(&g, &truth);
                if count == 1 {
                    worst.one = worst.one.max(off);
                }
                worst.any = worst.any.max(off);
                worst.brighter = worst.brighter.max((g[0] - truth[0]) / FULL);
            }
        }
    }
    (worst, error(&sh_reference::product::one(order), &truth))
}

/// What is promised for blockers of 40 degrees, by order: of one, and of any number. They are never too bright in the mean.
const PROMISED: [(usize, f64, f64); 5] = [
    (2, 0.022, 0.31),
    (3, 0.029, 0.20),
    (4, 0.016, 0.13),
    (5, 0.016, 0.11),
    (6, 0.016, 0.13),
];

/// One blocker is known to a tenth of what it takes, and no number of them takes less than that.
#[test]
fn identical_blockers_of_any_number() {
    for (order, one, any) in PROMISED {
        for axis in axes() {
            let (worst, none) = worst(order, axis);
            println!("order {order}, about {axis:?}: {worst:.3?}, of none {none:.3}");
            assert!(one < 0.11 * none, "{one} tells a blocker from none");
            assert!(
                worst.one <= one && worst.any <= any && worst.brighter < 1e-6,
                "order {order}, about {axis:?}: {worst:?}, {one} and {any} promised"
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
