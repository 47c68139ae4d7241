//! Sphere sets: the balls that block light in a mesh's place.
//!
//! A set bounds the mesh (every point of every triangle lies in one of the spheres, and so do the points of a grid
//! inside) and has little volume outside it, because that volume is where shadows are too large. docs/SPHERES.md has
//! figures, and how they compare with simpler sets.

mod closed;
mod fit;
mod flood;
mod memory;
mod moves;
mod pieces;
mod place;
pub(crate) mod proof;
mod random;
mod search;
mod solid;
mod start;
mod state;
pub(crate) mod winding;

use glam::DVec3;
use pieces::Pieces;
use proof::Ball;
use sh_scene::{Mesh, Sphere};
use solid::{Disc, Solid};

/// Changes whenever the same mesh may get other spheres than before: sets that were kept are then of no use.
pub(crate) const FIT_VERSION: u32 = 1;

/// Spheres that bound a mesh, and how tightly.
#[derive(Clone, Debug, PartialEq)]
pub struct SphereSet {
    /// The spheres, in the mesh's own space; never more than were asked for, and at least one.
    pub spheres: Vec<Sphere>,
    /// Outside volume E = Σ V(Sᵢ − T) divided by the volume of the mesh (Ren et al. 2006, equation 35 and
    /// figure 4). The solid of an open mesh is what it encloses by more than half; none where it encloses nothing.
    pub outside_volume_ratio: Option<f32>,
}

impl SphereSet {
    /// That of a body that blocks no light.
    pub(crate) fn none() -> Self {
        Self {
            spheres: Vec::new(),
            outside_volume_ratio: None,
        }
    }

    /// Fits at most `count` spheres (at least one) to the triangles of `meshes` together, which must share
    /// one space. The same input gives the same spheres, whatever the number of threads. Takes about a second
    /// and a half for 64 spheres on two cores; a mesh without triangles has no spheres. Reads and writes no file.
    ///
    /// ```
    /// use sh_bake::{SphereSet, shapes};
    /// let mesh = shapes::ball(1.0, 3);
    /// let set = SphereSet::fit(&[&mesh], 4);
    /// assert!(set.outside_volume_ratio.unwrap() < 0.1);
    /// assert_eq!(set.uncovered(&[&mesh]), None);
    /// ```
    pub fn fit(meshes: &[&Mesh], count: usize) -> Self {
        Self::fit_with(meshes, count, &|_| {})
    }

    /// [`SphereSet::fit`], telling `progress` the part that is done, 0 to 1: from several threads, in any order.
    pub fn fit_with(meshes: &[&Mesh], count: usize, progress: &(dyn Fn(f32) + Sync)) -> Self {
        let (points, triangles) = joined(meshes);
        if triangles.is_empty() {
            return Self {
                spheres: Vec::new(),
                outside_volume_ratio: None,
            };
        }
        let count = count.max(1);
        let solid = Solid::new(&points, &triangles);
        let target = (120 * count)
            .clamp(3_000, 8_000)
            .max(40 * count)
            .min(60_000);
        let pieces = Pieces::new(&points, &triangles, &solid, target);
        let mut balls = search::fit(&pieces, &solid, count, progress);

        if balls.is_empty() {
            // All triangles are one point, which a ball without extent holds.
            balls.push(Ball {
                center: points[triangles[0][0] as usize],
                radius: 0.0,
            });
        }

        // What the pieces did not show (triangles left out of a large mesh), and then the rounding to f32,
        // is made up for by growing.
        let size = extent(&points, &triangles);
        for ball in &mut balls {
            ball.center = ball.center.as_vec3().as_dvec3();
        }
        for t in &triangles {
            proof::ensure(&mut balls, t.map(|i| points[i as usize]), 2e-3 * size);
        }
        let spheres: Vec<Sphere> = balls
            .iter()
            .map(|ball| Sphere {
                center: ball.center.as_vec3().to_array(),
                radius: (ball.radius * (1.0 + 1e-6) + 1e-6 * size) as f32,
            })
            .collect();
        let disc = Disc::new(4096);
        let outside: f64 = spheres
            .iter()
            .map(|s| {
                solid.outside(
                    DVec3::from(s.center.map(f64::from)),
                    f64::from(s.radius),
                    &disc,
                )
            })
            .sum();
        let volume = solid.volume();
        let outside_volume_ratio = (volume > 0.0).then(|| (outside / volume) as f32);
        Self {
            spheres,
            outside_volume_ratio,
        }
    }

    /// A point of the surface near which the spheres are not proven to hold it, or none if every triangle is
    /// wholly in them. The proof cuts a triangle into pieces until each has its three corners in one sphere.
    pub fn uncovered(&self, meshes: &[&Mesh]) -> Option<[f32; 3]> {
        let (points, triangles) = joined(meshes);
        let balls: Vec<Ball> = self
            .spheres
            .iter()
            .map(|s| Ball {
                center: DVec3::from(s.center.map(f64::from)),
                radius: f64::from(s.radius),
            })
            .collect();
        triangles
            .iter()
            .find_map(|t| proof::uncovered(&balls, t.map(|i| points[i as usize]), 40))
            .map(|p| p.as_vec3().to_array())
    }
}

/// Whether meshes together, in one space, are closed: whether no edge is a border, so that it is beyond doubt what is
/// inside. Vertices within a millionth of the meshes' size of each other count as one.
///
/// ```
/// let mut mesh = sh_bake::shapes::ball(1.0, 2);
/// assert!(sh_bake::is_closed(&[&mesh]));
/// mesh.triangles.pop();
/// assert!(!sh_bake::is_closed(&[&mesh]));
/// ```
pub fn is_closed(meshes: &[&Mesh]) -> bool {
    let (points, triangles) = joined(meshes);
    closed::is_closed(&points, &triangles)
}

/// All triangles over one list of points.
pub(crate) fn joined(meshes: &[&Mesh]) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let (mut points, mut triangles) = (Vec::new(), Vec::new());
    for mesh in meshes {
        let first = points.len() as u32;
        points.extend(mesh.positions.iter().map(|p| DVec3::from(p.map(f64::from))));
        triangles.extend(mesh.triangles.iter().map(|t| t.map(|i| i + first)));
    }
    (points, triangles)
}

/// The longest edge of the bounding box.
pub(crate) fn extent(points: &[DVec3], triangles: &[[u32; 3]]) -> f64 {
    let used = || triangles.iter().flatten().map(|&i| points[i as usize]);
    let low = used().fold(DVec3::INFINITY, DVec3::min);
    let high = used().fold(DVec3::NEG_INFINITY, DVec3::max);
    (high - low).max_element()
}
