//! What is seen of a body, as both backends read it: in its own space.

use super::escape::Escape;
use bytemuck::{Pod, Zeroable};
use glam::Vec3;
use sh_core::constants::PATCH_SAMPLES;

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

/// A part of a body's surface: as a disc, and, for who is near, as several: 208 bytes, as `struct Patch { whole: Disc, discs:
/// array<Disc, 4>, escape: array<vec4f, 3> }` in WGSL.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Patch {
    /// All of it.
    pub whole: Disc,
    /// Its parts, one a sample.
    pub discs: [Disc; PATCH_SAMPLES],
    /// What of it is seen ([`Escape`]): b; xx, yy, zz; xy, yz, zx.
    pub escape: [[f32; 4]; 3],
}

/// Patches that lie together: 16 bytes, as `vec4f` in WGSL.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Region {
    /// The mean of its samples, in metres.
    pub center: [f32; 3],
    /// How far the farthest of them is from it.
    pub radius: f32,
}

impl Patch {
    /// Of these discs, of which so much is seen.
    pub fn new(whole: Disc, discs: [Disc; PATCH_SAMPLES], escape: &Escape) -> Self {
        let ([a, b, c], [xx, yy, zz, xy, yz, zx]) = (escape.linear, escape.square);
        Self {
            whole,
            discs,
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
}
