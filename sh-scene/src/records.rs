//! The records that both backends read, laid out as WGSL lays them out.

use bytemuck::{Pod, Zeroable};

/// A point that is lit: 32 bytes, as `struct Receiver { position: vec3f, covered: u32, normal: vec3f,
/// object: u32 }` in WGSL.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Receiver {
    /// Where, in metres, world space.
    pub position: [f32; 3],
    /// 1 for a surface, 0 for a place with nothing to light (the sky in a picture); such a receiver gets
    /// radiance 0. Above 1 for a surface that mirrors light as well: [`crate::Finish::covered`].
    pub covered: u32,
    /// Unit normal.
    pub normal: [f32; 3],
    /// Which body it belongs to: 1 more than the index of its object ([`crate::Scene::body`]), or 0 for none, as the ground
    /// has it.
    /// Blockers of a receiver's own body count otherwise than those of others ([`sh_core::seen`]).
    pub object: u32,
}

/// A sphere that blocks light: 16 bytes, as `vec4f` (centre, radius) in WGSL.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Sphere {
    /// Centre, in metres.
    pub center: [f32; 3],
    /// Radius, in metres, not negative.
    pub radius: f32,
}

impl Sphere {
    /// One that blocks nothing.
    pub const NONE: Self = Self {
        center: [0.0; 3],
        radius: 0.0,
    };

    /// Metres beyond which squares of distances may leave single precision.
    pub const FARTHEST: f32 = 1e18;

    /// Whether all its numbers are finite, and below [`FARTHEST`](Self::FARTHEST). One that is nowhere, or endless, blocks
    /// nothing.
    ///
    /// ```
    /// use sh_scene::Sphere;
    /// assert!(Sphere::NONE.is_finite());
    /// assert!(!Sphere { radius: f32::INFINITY, ..Sphere::NONE }.is_finite());
    /// ```
    pub fn is_finite(&self) -> bool {
        // What is not a number fails the comparison.
        let numbers = self.center.iter().chain([&self.radius]);
        numbers.copied().all(|x| x.abs() < Self::FARTHEST)
    }
}
