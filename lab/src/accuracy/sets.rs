//! The sets of blockers that errors are measured on, with their truth.

use rayon::prelude::*;
use sh_core::Routines;
use sh_core::cap::{self, Fit};
use sh_reference::visibility::Cap;
use sh_reference::{arcs, blockers};
use std::array::from_fn;

/// Random sets of separate blockers.
pub const RANDOM_SETS: usize = 1000;

/// Sets of blockers that nearly coincide.
pub const HEAVY_SETS: usize = 200;

/// Angular radius of identical blockers, degrees.
const STACKED: f64 = 40.0;

/// Seed of the sets; other than that of the fits.
const SEED: u64 = 99;

/// The sets of blockers and the true visibility behind them.
pub struct Sets {
    /// 1,000 random sets, 200 heavy ones and 13 stacks.
    pub caps: Vec<Vec<Cap>>,
    /// Their true visibility at the highest order.
    pub truth: Vec<Vec<f64>>,
}

impl Sets {
    /// The same in every run.
    pub fn standard() -> Self {
        let caps: Vec<Vec<Cap>> = [
            blockers::random(SEED, RANDOM_SETS),
            blockers::heavy(SEED, HEAVY_SETS),
            (0..=12)
                .flat_map(|k| blockers::stacked(STACKED.to_radians(), 1 << k))
                .collect(),
        ]
        .concat();
        let truth = caps
            .par_iter()
            .map(|caps| arcs::project(6, caps).coefficients)
            .collect();
        Self { caps, truth }
    }

    /// Blockers a random set has on average.
    pub fn mean_blockers(&self) -> f64 {
        let count: usize = self.caps[..RANDOM_SETS].iter().map(Vec::len).sum();
        count as f64 / RANDOM_SETS as f64
    }

    /// The random sets.
    pub fn random(&self) -> &[Vec<Cap>] {
        &self.caps[..RANDOM_SETS]
    }
}

/// One log vector a random set, for timing.
pub fn logs<const C: usize>(sets: &Sets, fit: Fit) -> Vec<[f32; C]>
where
    [f64; C]: Routines<f64>,
{
    sets.random()
        .iter()
        .map(|caps| {
            let mut sum = [0.0; C];
            for cap in caps {
                let turned = <[f64; C]>::zonal(cap::log_fitted_to::<C>(fit, cap.angle), cap.axis);
                sum.iter_mut().zip(turned).for_each(|(s, t)| *s += t);
            }
            from_fn(|i| sum[i] as f32)
        })
        .collect()
}
