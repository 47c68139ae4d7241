//! Which ball holds which pieces of the surface, kept up to date ball by ball.

use super::fit::Fit;
use super::place::Priced;
use rayon::prelude::*;

/// Which ball holds which pieces.
#[derive(Clone)]
pub(super) struct Cover {
    /// The pieces each ball holds.
    held: Vec<Vec<u32>>,
    /// How many balls hold each piece.
    holders: Vec<u32>,
}

impl Cover {
    pub(super) fn new(fit: &Fit, balls: &[Priced]) -> Self {
        let held: Vec<Vec<u32>> = balls.par_iter().map(|b| fit.held(&b.ball)).collect();
        let mut holders = vec![0; fit.middles.len()];
        for &piece in held.iter().flatten() {
            holders[piece as usize] += 1;
        }
        Self { held, holders }
    }

    /// The pieces that ball `i` alone holds.
    pub(super) fn own(&self, i: usize) -> Vec<u32> {
        self.held[i]
            .iter()
            .copied()
            .filter(|&piece| self.holders[piece as usize] == 1)
            .collect()
    }

    /// Enters ball `i`, which has changed.
    pub(super) fn update(&mut self, fit: &Fit, balls: &[Priced], i: usize) {
        for &piece in &self.held[i] {
            self.holders[piece as usize] -= 1;
        }
        self.held[i] = fit.held(&balls[i].ball);
        for &piece in &self.held[i] {
            self.holders[piece as usize] += 1;
        }
    }
}
