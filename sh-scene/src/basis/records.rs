//! What is seen of a body, as both backends read it: in its own space.

use super::escape::Escape;
use bytemuck::{Pod, Zeroable};
use glam::Vec3;
use sh_core::constants::{PATCH_SAMPLES, QUARTERS, REGION_PATCHES};

/// A flat part of a surface: 32 bytes, as `struct Disc { center: vec3f, area: f32, normal: vec3f, unused: f32 }` in WGSL.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Disc {
    /// Its middle, in metres.
    pub center: [f32; 3],
    /// Its area as it is seen from its normal, in square metres: of a surface that is curved less than there is.
    pub area: f32,
    /// Unit normal.
    pub normal: [f32; 3],
    /// Fills the place up.
    pub unused: f32,
}

impl Disc {
    /// That of this middle and vector area.
    pub fn new(center: Vec3, facing: Vec3) -> Self {
        Self {
            center: center.into(),
            area: facing.length(),
            normal: facing.normalize_or_zero().into(),
            unused: 0.0,
        }
    }
}

/// A flat part of a surface, and how much of it its body leaves to be seen: 80 bytes, as `struct Facet { disc: Disc, escape:
/// array<vec4f, 3> }` in WGSL.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Facet {
    /// Where it is.
    pub disc: Disc,
    /// What of it is seen ([`Escape`]): b; xx, yy, zz; xy, yz, zx.
    pub escape: [[f32; 4]; 3],
}

/// A part of a body's surface: as a whole, and, for who is near, as several: 208 bytes, as `struct Patch { whole: Facet, discs:
/// array<Disc, 4> }` in WGSL.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Patch {
    /// All of it.
    pub whole: Facet,
    /// Its parts, one a sample.
    pub discs: [Disc; PATCH_SAMPLES],
}

/// Patches that lie together: 416 bytes, as `struct Region { center: vec3f, radius: f32, whole: Facet, quarters: array<Facet, 4> }`
/// in WGSL.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Region {
    /// The mean of its samples, in metres.
    pub center: [f32; 3],
    /// How far the farthest of them is from it.
    pub radius: f32,
    /// All of its patches as one; without an area where they are not flat enough for that.
    pub whole: Facet,
    /// As many of them in a row as one each, likewise.
    pub quarters: [Facet; QUARTERS],
}

/// Patches of a quarter of a region.
pub(super) const QUARTER: usize = REGION_PATCHES / QUARTERS;

/// How much of the area of its patches a part of a region has at least, as it is seen from its normal: they face the same
/// way to within some degrees. What is curved sends light to where its mean does not face.
const FLAT: f32 = 0.995;

impl Facet {
    /// Of this disc, of which so much is seen.
    pub fn new(disc: Disc, escape: &Escape) -> Self {
        let ([a, b, c], [xx, yy, zz, xy, yz, zx]) = (escape.linear, escape.square);
        Self {
            disc,
            escape: [[a, b, c, 0.0], [xx, yy, zz, 0.0], [xy, yz, zx, 0.0]],
        }
    }

    /// How much of it is seen.
    pub fn escape(&self) -> Escape {
        let [[a, b, c, _], [xx, yy, zz, _], [xy, yz, zx, _]] = self.escape;
        Escape {
            linear: [a, b, c],
            square: [xx, yy, zz, xy, yz, zx],
        }
    }

    /// Several as one, without an area where they are not flat together.
    pub(super) fn of(patches: &[Patch]) -> Self {
        let facets = || patches.iter().map(|patch| &patch.whole);
        let area: f32 = facets().map(|f| f.disc.area).sum();
        let share = |f: &Facet| f.disc.area / area.max(f32::MIN_POSITIVE);
        let facing: Vec3 = facets()
            .map(|f| f.disc.area * Vec3::from(f.disc.normal))
            .sum();
        let center = facets().map(|f| share(f) * Vec3::from(f.disc.center)).sum();
        let mut escape = [[0.0; 4]; 3];
        for facet in facets() {
            for (sum, of) in escape.iter_mut().zip(&facet.escape) {
                for (sum, of) in sum.iter_mut().zip(of) {
                    *sum += share(facet) * of;
                }
            }
        }
        let mut disc = Disc::new(center, facing);
        if disc.area < FLAT * area {
            disc.area = 0.0;
        }
        Self { disc, escape }
    }
}
