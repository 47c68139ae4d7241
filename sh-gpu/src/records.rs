//! The uniform records of the kernels, laid out as WGSL lays them out (compared by a test).

use bytemuck::{Pod, Zeroable};
use glam::{Mat4, Vec3};

/// `struct Lighting`: what is the same for all receivers.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Lighting {
    /// How many blocker spheres there are.
    pub blockers: u32,
    /// Fills up to 16 bytes.
    pub padding: [u32; 3],
    /// SH coefficients of the environment's radiance: red, green, blue, 0. Those beyond the order are 0.
    pub coefficients: [[f32; 4]; 36],
}

/// `struct Band`: a horizontal band of the picture's grid of samples, and the camera.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Band {
    /// World to the clip space of this band alone; depth 1 at `near`, towards 0 at infinity.
    pub clip_from_world: Mat4,
    /// The eye, in metres.
    pub eye: Vec3,
    /// Distance of the near plane, in metres.
    pub near: f32,
    /// To the right, as long as half the picture is wide at distance 1.
    pub right: Vec3,
    /// The band's first row of samples, counted from the picture's top.
    pub first_row: u32,
    /// Upwards, as long as half the picture is tall at distance 1.
    pub up: Vec3,
    /// Rows of samples.
    pub rows: u32,
    /// Unit vector the camera looks along.
    pub forward: Vec3,
    /// 1 where there is a ground plane.
    pub ground: u32,
    /// Samples of the whole picture, across and down.
    pub grid: [u32; 2],
    /// Height of the ground, in metres.
    pub ground_height: f32,
    /// Aligns what follows.
    pub padding: u32,
    /// Linear reflectance of the ground.
    pub ground_albedo: Vec3,
    /// Fills up to a multiple of 16 bytes.
    pub tail: u32,
}

/// `struct Body`: where a body stands and how it reflects.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Body {
    /// World from object space.
    pub world_from_object: Mat4,
    /// Linear reflectance.
    pub albedo: Vec3,
    /// The index that receivers carry.
    pub object: u32,
}

/// A vertex of a body, as the G-buffer pass reads it: 32 bytes.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Vertex {
    /// In object space, in metres.
    pub position: [f32; 3],
    /// Unit normal, in object space.
    pub normal: [f32; 3],
    /// Texture coordinates.
    pub uv: [f32; 2],
}
