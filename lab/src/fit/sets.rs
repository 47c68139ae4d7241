//! The sets of blockers that fits are made on, with their truth.

use rayon::prelude::*;
use sh_reference::blockers;
use sh_reference::visibility::Cap;

/// A share of the weight for a kind of sets.
struct Kind {
    sets: Vec<Vec<Cap>>,
    weight: f64,
}

/// Sets of blockers with weights that sum to 1.
pub(super) struct Sets {
    pub caps: Vec<Vec<Cap>>,
    pub weights: Vec<f64>,
    /// SH vectors of the true visibility.
    pub truth: Vec<Vec<f64>>,
}

/// What a fit is made on: mostly separate blockers, with a little weight on blockers that nearly coincide, on
/// single circles up to 90 degrees and on many around the receiver. `stacks` adds identical blockers, up to
/// 1,024 of them, which product series cannot take.
pub(super) fn training(order: usize, stacks: bool) -> Sets {
    let degrees =
        |from: i32, step: usize| (from..=90).step_by(step).map(|d| f64::from(d).to_radians());
    let mut kinds = vec![
        Kind {
            sets: blockers::random(7, 600),
            weight: 0.93,
        },
        Kind {
            sets: blockers::heavy(7, 300),
            weight: 0.03,
        },
        Kind {
            sets: degrees(2, 2)
                .flat_map(|angle| blockers::stacked(angle, 1))
                .collect(),
            weight: 0.02,
        },
    ];
    if stacks {
        kinds.push(Kind {
            sets: degrees(4, 4)
                .flat_map(|angle| [2, 4, 16, 64, 1024].map(|m| blockers::stacked(angle, m)))
                .flatten()
                .collect(),
            weight: 0.01,
        });
        kinds.push(Kind {
            sets: blockers::enclosing(7, 60),
            weight: 0.01,
        });
    }
    let total: f64 = kinds.iter().map(|kind| kind.weight).sum();
    let weights = kinds
        .iter()
        .flat_map(|kind| {
            let each = kind.weight / total / kind.sets.len() as f64;
            vec![each; kind.sets.len()]
        })
        .collect();
    let caps: Vec<Vec<Cap>> = kinds.into_iter().flat_map(|kind| kind.sets).collect();
    let truth = caps
        .par_iter()
        .map(|caps| sh_reference::arcs::project(order, caps).coefficients)
        .collect();
    Sets {
        caps,
        weights,
        truth,
    }
}
