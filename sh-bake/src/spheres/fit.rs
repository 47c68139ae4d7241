//! What the search for spheres works on.

use super::pieces::Pieces;
use super::place::{Placing, Priced};
use super::proof::Ball;
use super::solid::{Disc, Solid};
use glam::DVec3;

/// What the search works on.
pub(super) struct Fit<'a> {
    pub(super) pieces: &'a Pieces,
    pub(super) placing: Placing<'a>,
}

impl<'a> Fit<'a> {
    pub(super) fn new(pieces: &'a Pieces, solid: &'a Solid, coarse: Disc) -> Self {
        let fine = Disc::new(600);
        Self {
            pieces,
            placing: Placing {
                solid,
                coarse,
                fine,
            },
        }
    }

    /// The ball that holds the given pieces with least outside volume that a search finds, from `old` among
    /// other places; one of radius 0 for no pieces.
    pub(super) fn place(&self, pieces: &[u32], old: Option<Ball>, thorough: bool) -> Priced {
        let points = self.pieces.points_of(pieces);
        let normal: DVec3 = pieces
            .iter()
            .map(|&i| self.pieces.normals[i as usize])
            .sum();
        self.placing
            .place(&points, normal.normalize_or_zero(), old, thorough)
    }
}
