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
    /// radiance 0.
    pub covered: u32,
    /// Unit normal.
    pub normal: [f32; 3],
    /// Which body it belongs to: an index into [`crate::Scene::objects`], or `u32::MAX` for the ground.
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
