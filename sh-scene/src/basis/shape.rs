//! Where a body's regions are.

use super::parts::{BasisParts, BasisSample};
use super::records::{Facet, Patch, QUARTER, Region};
use glam::Vec3;
use sh_core::constants::{PATCH_SAMPLES, REGION_PATCHES};

/// What is seen of a body, and from where.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Its regions.
    pub regions: Vec<Region>,
    /// The ball around all samples: its centre, in metres.
    pub center: Vec3,
    /// Its radius.
    pub radius: f32,
}

impl Shape {
    pub(super) fn of(parts: &BasisParts) -> Self {
        let place = |sample: &BasisSample| Vec3::from(sample.position);
        let all = || parts.samples.iter().map(place);
        let low = all().reduce(Vec3::min).unwrap_or_default();
        let high = all().reduce(Vec3::max).unwrap_or_default();
        let center = 0.5 * (low + high);
        let region = |(samples, patches): (&[BasisSample], &[Patch])| {
            let center = samples.iter().map(place).sum::<Vec3>() / samples.len() as f32;
            Region {
                center: center.into(),
                radius: farthest(samples.iter().map(place), center),
                whole: Facet::of(patches),
                quarters: std::array::from_fn(|k| Facet::of(&patches[k * QUARTER..][..QUARTER])),
            }
        };
        let samples = parts.samples.chunks_exact(PATCH_SAMPLES * REGION_PATCHES);
        let regions = samples.zip(parts.patches.chunks_exact(REGION_PATCHES));
        Self {
            regions: regions.map(region).collect(),
            center,
            radius: farthest(all(), center),
        }
    }

    /// Bytes that it takes.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&self.regions[..])
    }
}

fn farthest(all: impl Iterator<Item = Vec3>, from: Vec3) -> f32 {
    all.map(|p| p.distance(from)).fold(0.0, f32::max)
}
