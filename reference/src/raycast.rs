//! Visibility past triangles, by casting rays in f64.
//!
//! The intersection is Möller and Trumbore's ("Fast, Minimum Storage Ray/Triangle Intersection", 1997),
//! both sides of a triangle counting. A hierarchy of boxes (obvhs, in f32) only decides which triangles are
//! asked; its boxes are padded by 1e-5 of the scene's extent, so that no f32 rounding hides a triangle from
//! rays that start within ten extents of the origin.

use crate::vec3::{Vec3, cross, dot, sub, widen};
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2;
use obvhs::ray::{Ray, RayHit};
use obvhs::{Boundable, BvhBuildParams, aabb::Aabb};
use sh_scene::{Mesh, Object};
use std::time::Duration;

/// Corners of a triangle.
pub type Triangle = [[f64; 3]; 3];

/// The triangles of a mesh in its own space.
///
/// # Panics
/// If an index is out of range.
pub fn triangles(mesh: &Mesh) -> Vec<Triangle> {
    mesh.triangles
        .iter()
        .map(|t| t.map(|i| widen(mesh.positions[i as usize])))
        .collect()
}

/// The triangles of an object in world space, transformed in f64.
///
/// # Panics
/// If an index is out of range.
pub fn world_triangles(object: &Object) -> Vec<Triangle> {
    let m = object.transform.to_cols_array().map(f64::from);
    let place =
        |[x, y, z]: Vec3| [0, 1, 2].map(|i| m[i] * x + m[3 + i] * y + m[6 + i] * z + m[9 + i]);
    triangles(&object.mesh)
        .into_iter()
        .map(|t| t.map(place))
        .collect()
}

/// Distance along a ray (unit `direction`) to a triangle, if it meets it farther than `beyond`. Edges count as
/// inside, with 1e-12 of slack in barycentric coordinates, so that no ray slips between neighbours.
pub fn intersect(
    triangle: &Triangle,
    origin: [f64; 3],
    direction: [f64; 3],
    beyond: f64,
) -> Option<f64> {
    meet(triangle, origin, direction, beyond).map(|[distance, ..]| distance)
}

/// The same with the weights of the second and the third corner.
fn meet(triangle: &Triangle, origin: Vec3, direction: Vec3, beyond: f64) -> Option<[f64; 3]> {
    const SLACK: f64 = 1e-12;
    let [edge_1, edge_2] = [sub(triangle[1], triangle[0]), sub(triangle[2], triangle[0])];
    let p = cross(direction, edge_2);
    let determinant = dot(edge_1, p);
    if determinant == 0.0 {
        return None;
    }
    let to = sub(origin, triangle[0]);
    let q = cross(to, edge_1);
    let u = dot(to, p) / determinant;
    let v = dot(direction, q) / determinant;
    let distance = dot(edge_2, q) / determinant;
    (u >= -SLACK && v >= -SLACK && u + v <= 1.0 + SLACK && distance > beyond)
        .then_some([distance, u, v])
}

/// Where a ray meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Metres along the ray.
    pub distance: f64,
    /// Which triangle, in the order they were given.
    pub triangle: usize,
    /// How much each corner counts there; they add up to 1.
    pub weights: [f64; 3],
}

/// Triangles, ready for many rays.
pub struct Caster {
    triangles: Vec<Triangle>,
    bvh: Bvh2,
}

impl Caster {
    /// Sorts the triangles into boxes; some microseconds each.
    pub fn new(triangles: Vec<Triangle>) -> Self {
        let extent = triangles
            .iter()
            .flatten()
            .flatten()
            .fold(0.0, |a: f64, b| a.max(b.abs()));
        let boxes: Vec<Padded> = triangles
            .iter()
            .map(|t| Padded::new(t, 1e-5 * extent))
            .collect();
        let bvh = build_bvh2(
            &boxes,
            BvhBuildParams::medium_build(),
            &mut Duration::default(),
        );
        Caster { triangles, bvh }
    }

    /// Distance to the nearest triangle in a unit direction, if there is one farther than `beyond`; give
    /// rays that start on a surface some slack there.
    ///
    /// ```
    /// use sh_reference::raycast::Caster;
    /// let floor = [[-9.0, 0.0, -9.0], [9.0, 0.0, -9.0], [0.0, 0.0, 9.0]];
    /// let caster = Caster::new(vec![floor]);
    /// let found = caster.nearest([0.0, 2.0, 0.0], [0.0, -1.0, 0.0], 1e-6);
    /// assert_eq!(found, Some(2.0));
    /// ```
    pub fn nearest(&self, origin: [f64; 3], direction: [f64; 3], beyond: f64) -> Option<f64> {
        self.nearest_hit(origin, direction, beyond)
            .map(|hit| hit.distance)
    }

    /// As [`nearest`](Self::nearest), and which triangle that is, and where on it.
    ///
    /// ```
    /// use sh_reference::raycast::Caster;
    /// let floor = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 0.0, 4.0]];
    /// let hit = Caster::new(vec![floor]).nearest_hit([1.0, 2.0, 2.0], [0.0, -1.0, 0.0], 0.0);
    /// assert_eq!(hit.map(|hit| hit.weights), Some([0.25, 0.25, 0.5]));
    /// ```
    pub fn nearest_hit(&self, origin: [f64; 3], direction: [f64; 3], beyond: f64) -> Option<Hit> {
        let mut nearest: Option<Hit> = None;
        let shorten = |_: &Ray, id| {
            let index = self.bvh.primitive_indices[id] as usize;
            let Some([distance, u, v]) = meet(&self.triangles[index], origin, direction, beyond)
            else {
                return f32::INFINITY;
            };
            if nearest.is_none_or(|hit| distance < hit.distance) {
                nearest = Some(Hit {
                    distance,
                    triangle: index,
                    weights: [1.0 - u - v, u, v],
                });
            }
            // Boxes that begin farther away are left out from here on: not by rounding, though.
            (distance as f32).next_up()
        };
        self.bvh
            .ray_traverse(ray(origin, direction), &mut RayHit::none(), shorten);
        nearest
    }

    /// Whether any triangle lies in a unit direction, farther than `beyond`.
    pub fn blocked(&self, origin: [f64; 3], direction: [f64; 3], beyond: f64) -> bool {
        self.blocked_within(origin, direction, beyond, f64::INFINITY)
    }

    /// Whether any triangle lies in a unit direction, farther than `beyond` and nearer than `limit`.
    pub fn blocked_within(
        &self,
        origin: [f64; 3],
        direction: [f64; 3],
        beyond: f64,
        limit: f64,
    ) -> bool {
        let mut ray = ray(origin, direction);
        ray.tmax = (limit as f32).next_up();
        !self.bvh.ray_traverse_miss(ray, |_, id| {
            let triangle = &self.triangles[self.bvh.primitive_indices[id] as usize];
            match intersect(triangle, origin, direction, beyond) {
                Some(distance) if distance < limit => 0.0,
                _ => f32::INFINITY,
            }
        })
    }
}

fn ray(origin: Vec3, direction: Vec3) -> Ray {
    Ray::new_inf(narrow(origin).into(), narrow(direction).into())
}

fn narrow(v: Vec3) -> [f32; 3] {
    v.map(|c| c as f32)
}

/// A triangle's box, made larger on all sides.
struct Padded(Aabb);

impl Padded {
    fn new(triangle: &Triangle, pad: f64) -> Self {
        let along = |pick: fn(f64, f64) -> f64, shift: f64| {
            narrow([0, 1, 2].map(|i| {
                triangle
                    .iter()
                    .map(|v| v[i])
                    .reduce(pick)
                    .unwrap_or_default()
                    + shift
            }))
        };
        Padded(Aabb::new(
            along(f64::min, -pad).into(),
            along(f64::max, pad).into(),
        ))
    }
}

impl Boundable for Padded {
    fn aabb(&self) -> Aabb {
        self.0
    }
}

#[cfg(test)]
mod tests;
