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
//! What stands for a cell in which the sphere has no surface of its own, since another of the body's spheres is before it,
//! depends on what hides lights ([`SurfaceSamples::stands`]):
//!
//! - Where the other sphere hides it from whoever looks, the cell is not seen, but counts in the mean of what is seen
//!   around it. So it is as bright as the nearest cell that has a point, as textures are padded beyond their seams.
//! - Where intersecting spheres do not hide each other, it is black, and does not brighten its neighbours.
//!
//! The paper multiplies SH vectors of light and albedo instead (eq. 11), which cuts off the product; here the mean
//! albedo of each cell is part of its point.

mod directions;
mod exposed;

pub use directions::{cell_of, cell_sums, directions, stratified};
#[doc(inline)]
pub use sh_core::constants::{DIRECTIONS, MOST_COEFFICIENTS, NO_POINT};

use directions::neighbors;

use bytemuck::{Pod, Zeroable};

/// A point of a body's surface: 48 bytes, as `struct SurfacePoint { position: vec3f, direction: u32, normal: vec3f,
/// share: f32, albedo: vec3f }` in WGSL.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct SurfacePoint {
    /// Where, in metres, object space.
    pub position: [f32; 3],
    /// Which of its sphere's directions it stands for: an index into [`directions`].
    pub direction: u32,
    /// Unit normal, object space, outwards.
    pub normal: [f32; 3],
    /// In how much of the direction's Voronoi cell the sphere has surface of its own, 0 to 1.
    pub share: f32,
    /// Mean reflectance of that, linear Rec.709, each in 0..=1.
    pub albedo: [f32; 3],
    /// Fills the place up.
    pub _pad: u32,
}

impl Default for SurfacePoint {
    /// A black point that stands for all of its cell.
    fn default() -> Self {
        Self {
            share: 1.0,
            ..Self::zeroed()
        }
    }
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
    /// A sphere's point nearest to each direction.
    nearest: Vec<[u8; DIRECTIONS]>,
    /// Of each sphere, where it has been found.
    exposed: Vec<[f32; MOST_COEFFICIENTS]>,
}

impl SurfaceSamples {
    /// Adds a sphere with its points.
    pub fn push(&mut self, points: impl IntoIterator<Item = SurfacePoint>) {
        if self.starts.is_empty() {
            self.starts.push(0);
        }
        let first = self.points.len();
        self.points.extend(points);
        self.nearest.push(nearest(&self.points[first..]));
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

    /// Which of a sphere's points, an index into [`of`](Self::of), stands for each of the directions, or [`NO_POINT`]: that of
    /// the direction itself, and, where `within_bodies` ([`Blocking::within_bodies`](crate::Blocking::within_bodies)),
    /// for a direction that has none the one that is nearest.
    ///
    /// ```
    /// use sh_scene::surface::{NO_POINT, SurfacePoint, SurfaceSamples};
    /// let mut samples = SurfaceSamples::default();
    /// samples.push([SurfacePoint { direction: 3, ..Default::default() }]);
    /// assert_eq!(samples.stands(0, true), [0; 92]);
    /// let alone = samples.stands(0, false);
    /// assert_eq!((alone[2], alone[3]), (NO_POINT, 0));
    /// ```
    pub fn stands(&self, sphere: usize, within_bodies: bool) -> [u8; DIRECTIONS] {
        let points = self.of(sphere);
        let nearest = self.nearest.get(sphere).copied();
        let mut stands = nearest.unwrap_or([NO_POINT; DIRECTIONS]);
        if !within_bodies {
            for (j, stands) in stands.iter_mut().enumerate() {
                let point = points.get(usize::from(*stands));
                if point.is_some_and(|point| point.direction as usize != j) {
                    *stands = NO_POINT;
                }
            }
        }
        stands
    }

    /// How many bytes the samples take.
    ///
    /// ```
    /// use sh_scene::surface::{DIRECTIONS, SurfaceSamples};
    /// let mut samples = SurfaceSamples::default();
    /// samples.push([Default::default(); DIRECTIONS]);
    /// assert_eq!(samples.bytes(), 92 * 48 + 2 * 4 + 16 + 92);
    /// ```
    pub fn bytes(&self) -> usize {
        size_of_val(&self.points[..])
            + size_of_val(&self.starts[..])
            + size_of_val(&self.rotations[..])
            + size_of_val(&self.nearest[..])
            + size_of_val(&self.exposed[..])
    }
}

impl SurfacePoint {
    /// What the point's cell reflects: its albedo within 0 and 1, black where it is no number; and, unless the cells
    /// around it stand for what is missing (`within_bodies`), only so much of it as there is.
    ///
    /// ```
    /// use sh_scene::SurfacePoint;
    /// let half = SurfacePoint { share: 0.5, albedo: [0.8, 2.0, f32::NAN], ..Default::default() };
    /// assert_eq!(half.reflectance(true), [0.8, 1.0, 0.0]);
    /// assert_eq!(half.reflectance(false), [0.4, 0.5, 0.0]);
    /// ```
    pub fn reflectance(&self, within_bodies: bool) -> [f32; 3] {
        let share = if within_bodies { 1.0 } else { self.share };
        // What is no number is not above 0.
        self.albedo
            .map(|c| share * if c > 0.0 { c.min(1.0) } else { 0.0 })
    }
}

/// For each direction which of a sphere's points is nearest to it.
fn nearest(points: &[SurfacePoint]) -> [u8; DIRECTIONS] {
    let mut own = [NO_POINT; DIRECTIONS];
    for (i, point) in (0..NO_POINT).zip(points) {
        if let Some(own) = own.get_mut(point.direction as usize)
            && *own == NO_POINT
        {
            *own = i;
        }
    }
    std::array::from_fn(|j| {
        let around = neighbors()[j].iter().map(|&k| own[usize::from(k)]);
        around
            .into_iter()
            .find(|&i| i != NO_POINT)
            .unwrap_or(NO_POINT)
    })
}
