//! Receivers in clusters that share one cut of blockers.

use crate::Receiver;
use crate::lloyd::{curve, lloyd};
use glam::Vec3;
use std::ops::Range;

/// Receivers grouped by where they are and where they face (Ren et al. 2006, section 6.3).
///
/// The passes want the receivers of a cluster side by side: a host puts them in [`Clusters::order`] once and keeps
/// them so.
#[derive(Clone, Debug, PartialEq)]
pub struct Clusters {
    /// What stands where: entry k is the index of the receiver that comes to place k.
    pub order: Vec<u32>,
    /// The places of each cluster, one after another, together all of them.
    pub ranges: Vec<Range<usize>>,
}

/// Receivers that a pass computes at once, or a whole part of them.
const SIDE_BY_SIDE: usize = 8;

impl Clusters {
    /// At most `count` clusters by Lloyd's algorithm over positions and normals. A turn of the normal by 60° counts as
    /// much as the extent of a cluster. Within a cluster those stand side by side that need the
    /// same blockers, since they are computed together.
    ///
    /// The time grows with the product of both numbers.
    ///
    /// ```
    /// use sh_scene::{Clusters, Receiver};
    /// let floor: Vec<_> = (0..400)
    ///     .map(|i| Receiver {
    ///         position: [(i % 20) as f32, 0.0, (i / 20) as f32],
    ///         covered: 1,
    ///         normal: [0.0, 1.0, 0.0],
    ///         object: 0,
    ///     })
    ///     .collect();
    /// let clusters = Clusters::new(&floor, 4);
    /// assert_eq!(clusters.ranges.len(), 4);
    /// let sorted = clusters.sorted(&floor);
    /// assert_eq!(sorted.len(), floor.len());
    /// ```
    pub fn new(receivers: &[Receiver], count: usize) -> Self {
        let positions: Vec<[f32; 3]> = receivers.iter().map(|r| r.position).collect();
        let along = curve(&positions);
        let size = typical_size(&positions, count);
        let features: Vec<[f32; 6]> = receivers
            .iter()
            .map(|r| {
                let ([x, y, z], n) = (r.position, Vec3::from(r.normal) * size);
                [x, y, z, n.x, n.y, n.z]
            })
            .collect();
        let mut order = Vec::with_capacity(receivers.len());
        let mut ranges = Vec::new();
        for mut group in lloyd(&features, &along, count.max(1)) {
            let first = order.len();
            halve(&features, &mut group);
            order.extend(group.into_iter().map(|i| i as u32));
            ranges.push(first..order.len());
        }
        Self { order, ranges }
    }

    /// What belongs to the receivers, in the order of the clusters.
    pub fn sorted<T: Copy>(&self, of_receivers: &[T]) -> Vec<T> {
        self.order
            .iter()
            .map(|&i| of_receivers[i as usize])
            .collect()
    }
}

/// Sorts a group into halves of halves, across the direction in which each is the longest, down to [`SIDE_BY_SIDE`].
fn halve(features: &[[f32; 6]], group: &mut [usize]) {
    if group.len() <= SIDE_BY_SIDE {
        return;
    }
    let extent = |k: usize| {
        let values = || group.iter().map(|&i| features[i][k]);
        values().fold(f32::NEG_INFINITY, f32::max) - values().fold(f32::INFINITY, f32::min)
    };
    let extents: [f32; 6] = std::array::from_fn(extent);
    let longest = (0..6).fold(
        0,
        |best, k| if extents[k] > extents[best] { k } else { best },
    );
    // A whole number of the smallest pieces, so that no piece mixes both halves.
    let middle = (group.len() / 2).next_multiple_of(SIDE_BY_SIDE);
    if middle < group.len() {
        group.select_nth_unstable_by(middle, |&a, &b| {
            features[a][longest]
                .total_cmp(&features[b][longest])
                .then(a.cmp(&b))
        });
    }
    let (low, high) = group.split_at_mut(middle);
    halve(features, low);
    halve(features, high);
}

/// The extent that a cluster has if all cover the same area of the box around the positions.
fn typical_size(positions: &[[f32; 3]], count: usize) -> f32 {
    let all = || positions.iter().map(|p| Vec3::from(*p));
    let low = all().fold(Vec3::INFINITY, Vec3::min);
    let high = all().fold(Vec3::NEG_INFINITY, Vec3::max);
    let size = (high - low).max(Vec3::ZERO);
    let area = size.x * size.y + size.y * size.z + size.z * size.x;
    if area.is_finite() {
        (area / count.max(1) as f32).sqrt()
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Bounds;

    fn ball(count: usize) -> Vec<Receiver> {
        (0..count)
            .map(|i| {
                let z = 1.0 - 2.0 * (i as f32 + 0.5) / count as f32;
                let turn = 2.399_963_2 * i as f32;
                let flat = (1.0 - z * z).sqrt();
                let n = [flat * turn.cos(), flat * turn.sin(), z];
                Receiver {
                    position: n,
                    covered: 1,
                    normal: n,
                    object: 0,
                }
            })
            .collect()
    }

    #[test]
    fn every_receiver_is_in_one_cluster_and_clusters_are_compact() {
        let receivers = ball(3000);
        for count in [1, 2, 7, 40, 200] {
            let clusters = Clusters::new(&receivers, count);
            assert!(clusters.ranges.len() <= count && clusters.ranges.len() * 2 >= count);
            let mut order = clusters.order.clone();
            order.sort_unstable();
            assert!(order.iter().enumerate().all(|(i, &o)| i == o as usize));
            let mut next = 0;
            let sorted = clusters.sorted(&receivers);
            for range in &clusters.ranges {
                assert_eq!(range.start, next);
                next = range.end;
                let bounds = Bounds::of(&sorted[range.clone()]).unwrap();
                // The radius of a cap of that share of the sphere is 2/√count; twice that is compact enough.
                assert!(
                    bounds.radius < 4.0 / (count as f32).sqrt(),
                    "{count}: {bounds:?}"
                );
            }
            assert_eq!(next, receivers.len());
        }
    }

    #[test]
    fn two_sides_of_a_plate_are_apart() {
        let plate: Vec<Receiver> = (0..800)
            .map(|i| Receiver {
                position: [(i % 20) as f32, 0.0, (i / 2 % 20) as f32],
                covered: 1,
                normal: [0.0, if i < 400 { 1.0 } else { -1.0 }, 0.0],
                object: 0,
            })
            .collect();
        let clusters = Clusters::new(&plate, 16);
        for range in &clusters.ranges {
            let sides = clusters.order[range.clone()].iter().map(|&i| i < 400);
            assert!(sides.clone().all(|s| s) || sides.clone().all(|s| !s));
        }
    }

    #[test]
    fn nothing_has_no_clusters() {
        assert_eq!(Clusters::new(&[], 4).ranges.len(), 0);
    }
}
