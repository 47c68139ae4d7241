//! How a search begins: clusters of pieces, from which the first balls are made.

use super::fit::Fit;
use super::place::{Priced, farthest};
use glam::DVec3;
use rayon::prelude::*;

/// Clusters of pieces, and a ball about each.
#[derive(Clone)]
pub(super) struct Beginning {
    pub(super) clusters: Vec<Vec<u32>>,
    pub(super) balls: Vec<Priced>,
}

impl Fit<'_> {
    /// Clusters by halving: of the clusters the one whose ball has most volume outside is cut across its longest
    /// side, until there are `count`.
    pub(super) fn halved_often(&self, count: usize) -> Beginning {
        let rated = |pieces: Vec<u32>| (self.place(&pieces, None, true), pieces);
        let mut clusters = vec![rated((0..self.pieces.len() as u32).collect())];
        while clusters.len() < count {
            let many = (0..clusters.len()).filter(|&i| clusters[i].1.len() > 1);
            let worst =
                many.max_by(|&a, &b| clusters[a].0.outside.total_cmp(&clusters[b].0.outside));
            let Some(worst) = worst else { break };
            let (_, pieces) = clusters.swap_remove(worst);
            clusters.extend(self.cut_across(pieces).map(rated));
        }
        let (balls, clusters) = clusters.into_iter().unzip();
        Beginning { clusters, balls }
    }

    /// Pieces on either side of the middle of their longest extent; neither side is empty where there are two.
    fn cut_across(&self, mut pieces: Vec<u32>) -> [Vec<u32>; 2] {
        let middle = |i: u32| self.pieces.middles[i as usize];
        let low = pieces
            .iter()
            .fold(DVec3::INFINITY, |a, &i| a.min(middle(i)));
        let high = pieces
            .iter()
            .fold(DVec3::NEG_INFINITY, |a, &i| a.max(middle(i)));
        let axis = (high - low).max_position();
        let cut = 0.5 * (low[axis] + high[axis]);
        let (mut lower, mut upper): (Vec<u32>, Vec<u32>) =
            pieces.iter().partition(|&&i| middle(i)[axis] <= cut);
        if upper.is_empty() {
            upper = pieces.split_off(pieces.len() / 2);
            lower = pieces;
        }
        [lower, upper]
    }

    /// Clusters about seeds as far from each other as can be, after a few rounds of k-means over the middles of the
    /// pieces.
    pub(super) fn scattered(&self, count: usize) -> Beginning {
        let middles = &self.pieces.middles;
        let middle = middles.iter().sum::<DVec3>() / middles.len() as f64;
        let mut centers = vec![farthest(middles, middle)];
        let mut distance = vec![f64::INFINITY; middles.len()];
        while centers.len() < count {
            let newest = centers[centers.len() - 1];
            for (d, m) in distance.iter_mut().zip(middles) {
                *d = d.min(m.distance_squared(newest));
            }
            let next = (0..distance.len()).max_by(|&a, &b| distance[a].total_cmp(&distance[b]));
            centers.extend(next.map(|i| middles[i]));
        }
        let mut clusters = Vec::new();
        for _ in 0..4 {
            let nearest: Vec<usize> = middles
                .par_iter()
                .map(|m| least(centers.iter().map(|c| m.distance_squared(*c))))
                .collect();
            clusters = grouped(&nearest, count);
            for (center, pieces) in centers.iter_mut().zip(&clusters) {
                if !pieces.is_empty() {
                    let sum: DVec3 = pieces.iter().map(|&i| middles[i as usize]).sum();
                    *center = sum / pieces.len() as f64;
                }
            }
        }
        let place = |pieces: &Vec<u32>| self.place(pieces, None, true);
        let balls = clusters.par_iter().map(place).collect();
        Beginning { clusters, balls }
    }
}

/// Where the least value stands; the first of equals.
pub(super) fn least(values: impl Iterator<Item = f64>) -> usize {
    values
        .enumerate()
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map_or(0, |(i, _)| i)
}

/// Indices by the group they belong to.
pub(super) fn grouped(group: &[usize], count: usize) -> Vec<Vec<u32>> {
    let mut groups = vec![Vec::new(); count];
    for (i, &g) in group.iter().enumerate() {
        groups[g].push(i as u32);
    }
    groups
}
