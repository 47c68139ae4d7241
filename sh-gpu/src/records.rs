//! The uniform records of the kernels, laid out as WGSL lays them out (compared by a test): for hosts that bind a kernel
//! of `sh-kernels` themselves.
//!
//! ```
//! use bytemuck::Zeroable;
//! let lighting = sh_gpu::records::Lighting { nodes: 3, ..Zeroable::zeroed() };
//! assert_eq!(bytemuck::bytes_of(&lighting).len(), 592);
//! ```

use bytemuck::{Pod, Zeroable};
use glam::{Mat4, Vec3};
use sh_core::constants::MOST_COEFFICIENTS;
use sh_scene::upsample;

/// `struct Lighting`: what is the same for all receivers.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Lighting {
    /// How many nodes the tree of blockers has.
    pub nodes: u32,
    /// How many analytic lights there are.
    pub emitters: u32,
    /// [`sh_scene::Limits::sin_max`].
    pub sin_max: f32,
    /// [`sh_scene::Limits::sin_min`].
    pub sin_min: f32,
    /// SH coefficients of the environment's radiance: red, green, blue, 0. Those beyond the order are 0.
    pub coefficients: [[f32; 4]; MOST_COEFFICIENTS],
}

/// `struct PunctualScene`: how many lights with sharp shadows there are, and where the pictures of what they see lie.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct PunctualScene {
    /// Lights.
    pub lights: u32,
    /// Views from them.
    pub views: u32,
    /// Texels along the side of a view.
    pub side: u32,
    /// Views along the side of the picture that holds them all.
    pub across: u32,
    /// 1 where there is a ground plane.
    pub ground: u32,
    /// Its height, in metres.
    pub ground_height: f32,
    /// 0.
    pub tail: [u32; 2],
}

/// `struct Band`: a horizontal band of a grid of rays through the picture, and the camera.
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
    /// The band's first row of cells, counted from the picture's top.
    pub first_row: u32,
    /// Upwards, as long as half the picture is tall at distance 1.
    pub up: Vec3,
    /// Rows of cells.
    pub rows: u32,
    /// Unit vector the camera looks along.
    pub forward: Vec3,
    /// 1 where there is a ground plane.
    pub ground: u32,
    /// The picture's extent in cells, across and down. Cells at the right and at the bottom may reach beyond it.
    pub extent: [f32; 2],
    /// Cells across.
    pub columns: u32,
    /// Height of the ground, in metres.
    pub ground_height: f32,
    /// Linear reflectance of the ground.
    pub ground_albedo: Vec3,
    /// What two pixels cover at distance 1: [`sh_scene::upsample::footprint`].
    pub footprint: f32,
    /// Columns of the grid at half resolution.
    pub half_columns: u32,
    /// Its rows.
    pub half_rows: u32,
    /// The first row of those that lie under this band, in whole rows of tiles.
    pub half_first_row: u32,
    /// Fills up to a multiple of 16 bytes.
    pub tail: u32,
}

/// `struct Basis`: a rigid body whose light is told in few functions, and where it is.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Basis {
    /// World from its own space.
    pub world_from_object: Mat4,
    /// Its own space from the world.
    pub object_from_world: Mat4,
    /// Centre of the ball around it, in metres, world space.
    pub center: Vec3,
    /// Radius of that.
    pub radius: f32,
    /// Metres of the world a metre of its own; 0 where it is nowhere to be seen.
    pub scale: f32,
    /// The body, as receivers carry it.
    pub object: u32,
    /// Its first patch.
    pub first: u32,
    /// How many it has.
    pub patches: u32,
    /// How many functions.
    pub functions: u32,
    /// Where their weights begin.
    pub weights: u32,
    /// Where what tells weights begins.
    pub duals: u32,
    /// Where what patches send on of functions begins.
    pub sends: u32,
    /// Where what they send on begins: two elements a patch, then coefficients of regions, then the brightest.
    pub light: u32,
    /// 1 where it sends itself light.
    pub own: u32,
    /// How many of its points take light that bodies have sent.
    pub few: u32,
    /// Where they begin: those of all bodies come first.
    pub first_few: u32,
}

/// `struct UpsampleRule`: where light at half resolution will do for a sample.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct UpsampleRule {
    /// The least sum of weights.
    pub min_weight: f32,
    /// The largest difference of shares.
    pub max_spread: f32,
    /// The cosine between normals from which on a receiver weighs.
    pub normal_from: f32,
    /// The weight from which on a receiver's share has a say in the difference.
    pub corner: f32,
}

impl UpsampleRule {
    /// The constants of [`sh_scene::upsample`].
    pub const OURS: Self = Self {
        min_weight: upsample::MIN_WEIGHT,
        max_spread: upsample::MAX_SPREAD,
        normal_from: upsample::NORMAL_FROM,
        corner: upsample::CORNER,
    };
}

/// `struct Sender`: a sphere that sends light on.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Sender {
    /// World from object space.
    pub world_from_object: Mat4,
    /// The rotation in that, as a unit quaternion (x, y, z, w).
    pub turn: [f32; 4],
    /// World from the frame of the sphere's directions, a unit quaternion.
    pub frame: [f32; 4],
    /// Its first point.
    pub first: u32,
    /// How many it has.
    pub count: u32,
    /// Its body, as receivers carry it: 1 more than its index.
    pub object: u32,
    /// Which node of the tree of blockers it is.
    pub node: u32,
}

/// `struct Body`: where a body stands and how it reflects.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Body {
    /// World from object space.
    pub world_from_object: Mat4,
    /// Linear reflectance.
    pub albedo: Vec3,
    /// Which it is, as receivers carry it: 1 more than its index.
    pub object: u32,
    /// 1 where it mirrors light.
    pub glossy: u32,
    /// [`sh_scene::Finish::roughness`].
    pub roughness: f32,
    /// [`sh_scene::Finish::metallic`].
    pub metallic: f32,
    /// Fills up to a multiple of 16 bytes.
    pub tail: u32,
}

/// `struct VertexSource`: where a host's vertices lie, in words of 4 bytes, and where they stand.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct VertexSource {
    /// World from object space.
    pub world_from_object: Mat4,
    /// The first position.
    pub first: u32,
    /// From one vertex to the next.
    pub stride: u32,
    /// From a position to its normal.
    pub normal: u32,
    /// The body, as receivers carry it: 1 more than its index, or 0 for none.
    pub object: u32,
}

/// `struct ScreenSource`: how a part of a host's G-buffer is read.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct ScreenSource {
    /// From clip space to the world.
    pub world_from_clip: Mat4,
    /// Pixels across and down.
    pub size: [u32; 2],
    /// The first row of pixels of this part.
    pub first_row: u32,
    /// The depth of what is not covered.
    pub empty: f32,
    /// What a normal's texel is multiplied with.
    pub scale: f32,
    /// What is added to that.
    pub bias: f32,
    /// Fills up to a multiple of 16 bytes.
    pub tail: [u32; 2],
}

/// A vertex of a body, as the G-buffer pass reads it: 44 bytes.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Vertex {
    /// In object space, in metres.
    pub position: [f32; 3],
    /// Unit normal, in object space.
    pub normal: [f32; 3],
    /// Texture coordinates.
    pub uv: [f32; 2],
    /// What the albedo is multiplied with.
    pub color: [f32; 3],
}
