//! Points on a body's surface that say how bright its spheres are as lights (Guerrero et al. 2008, section 4.2).
//!
//! A sphere that stands for a part of a body is seen in 92 directions, the vertices of an icosahedron's geodesic sphere
//! of frequency 3. In each of them it has at most one point of the surface: where light is looked up that stands for
//! all of the direction's Voronoi cell. With the radiance Lⱼ that leaves point j at albedo 1, its albedo aⱼ, and the
//! cell's integral of the basis,
//!
//! ```text
//! emission = Σⱼ Lⱼ aⱼ Yⱼ        Yⱼ = ∫ over cell j of y_lm        (eq. 10, with its 4π/N inside Yⱼ)
//! ```
//!
//! Cells are those of all 92 directions, so that one without a point stays dark and does not brighten its neighbours.
//! The paper multiplies SH vectors of light and albedo instead (eq. 11), which cuts off the product; here the mean
//! albedo of each cell is part of its point.

mod directions;

pub use directions::{cell_of, cell_sums, directions, stratified};

use bytemuck::{Pod, Zeroable};

/// How many directions a sphere is seen in.
pub const DIRECTIONS: usize = 92;

/// Coefficients of [`cell_sums`]: those of order 6. A lower order's come first.
pub const COEFFICIENTS: usize = 36;

/// A point of a body's surface: 48 bytes, as `struct SurfacePoint { position: vec3f, direction: u32, normal: vec3f,
/// albedo: vec3f }` in WGSL.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct SurfacePoint {
    /// Where, in metres, object space.
    pub position: [f32; 3],
    /// Which of its sphere's directions it stands for: an index into [`directions`].
    pub direction: u32,
    /// Unit normal, object space, outwards.
    pub normal: [f32; 3],
    /// Fills the place up.
    pub _pad: u32,
    /// Mean reflectance over the direction's Voronoi cell, linear Rec.709, each in 0..=1. Where the sphere has no
    /// surface of its own it counts as black.
    pub albedo: [f32; 3],
    /// Fills the place up.
    pub _pad1: u32,
}

/// The points of one object's spheres; empty where nothing was sampled.
///
/// ```
/// use sh_scene::surface::{SurfacePoint, SurfaceSamples};
/// let mut samples = SurfaceSamples::default();
/// samples.push([SurfacePoint { direction: 3, ..Default::default() }]);
/// samples.push([]);
/// assert_eq!((samples.spheres(), samples.points.len()), (2, 1));
/// assert_eq!(samples.of(0)[0].direction, 3);
/// assert!(samples.of(1).is_empty() && samples.of(2).is_empty());
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SurfaceSamples {
    /// Sphere by sphere, each sphere's in the order of their directions.
    pub points: Vec<SurfacePoint>,
    /// Where each sphere's points start, and one entry more for where the last one's end; empty where there is no
    /// sphere.
    pub starts: Vec<u32>,
    /// A unit quaternion (x, y, z, w) a sphere: object space from the frame of its directions. Identity until a skin
    /// turns it.
    pub rotations: Vec<[f32; 4]>,
}

impl SurfaceSamples {
    /// Adds a sphere with its points.
    pub fn push(&mut self, points: impl IntoIterator<Item = SurfacePoint>) {
        if self.starts.is_empty() {
            self.starts.push(0);
        }
        self.points.extend(points);
        self.starts.push(self.points.len() as u32);
        self.rotations.push([0.0, 0.0, 0.0, 1.0]);
    }

    /// How many spheres there are.
    pub fn spheres(&self) -> usize {
        self.rotations.len()
    }

    /// Whether no sphere was sampled.
    pub fn is_empty(&self) -> bool {
        self.rotations.is_empty()
    }

    /// A sphere's points; none of a sphere that is not there.
    pub fn of(&self, sphere: usize) -> &[SurfacePoint] {
        match self.starts.get(sphere..).unwrap_or_default() {
            [start, end, ..] => &self.points[*start as usize..*end as usize],
            _ => &[],
        }
    }

    /// How many bytes the samples take.
    ///
    /// ```
    /// use sh_scene::surface::{DIRECTIONS, SurfaceSamples};
    /// let mut samples = SurfaceSamples::default();
    /// samples.push([Default::default(); DIRECTIONS]);
    /// assert_eq!(samples.bytes(), 92 * 48 + 2 * 4 + 16);
    /// ```
    pub fn bytes(&self) -> usize {
        size_of_val(&self.points[..])
            + size_of_val(&self.starts[..])
            + size_of_val(&self.rotations[..])
    }
}
