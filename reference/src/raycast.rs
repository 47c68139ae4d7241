//! Visibility past triangles, by casting rays in f64.
//!
//! The intersection is Möller and Trumbore's ("Fast, Minimum Storage Ray/Triangle Intersection", 1997),
//! both sides of a triangle counting. A hierarchy of boxes (obvhs, in f32) only decides which triangles are
//! asked; its boxes are padded by 1e-5 of the scene's extent, so that no f32 rounding hides a triangle from
//! rays that start within ten extents of the origin.

use crate::vec3::{Vec3, cross, dot, sub, widen};
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2;
use obvhs::ray::Ray;
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
    (u >= -SLACK && v >= -SLACK && u + v <= 1.0 + SLACK && distance > beyond).then_some(distance)
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
        let mut nearest = None;
        self.bvh
            .ray_traverse_anyhit(ray(origin, direction), |_, id| {
                let triangle = &self.triangles[self.bvh.primitive_indices[id] as usize];
                if let Some(distance) = intersect(triangle, origin, direction, beyond) {
                    nearest = Some(nearest.map_or(distance, |n: f64| n.min(distance)));
                }
            });
        nearest
    }

    /// Whether any triangle lies in a unit direction, farther than `beyond`.
    pub fn blocked(&self, origin: [f64; 3], direction: [f64; 3], beyond: f64) -> bool {
        !self.bvh.ray_traverse_miss(ray(origin, direction), |_, id| {
            let triangle = &self.triangles[self.bvh.primitive_indices[id] as usize];
            match intersect(triangle, origin, direction, beyond) {
                Some(_) => 0.0,
                None => f32::INFINITY,
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
mod tests {
    use super::*;
    use crate::sampled;
    use crate::testing::{assert_close, directions, numbers};
    use crate::visibility::{caps, project};
    use glam::{Affine3A, Quat};
    use sh_scene::{Material, Sphere};

    /// A ball of triangles: `rows` by `2·rows` quads.
    fn ball(center: Vec3, radius: f64, rows: usize) -> Vec<Triangle> {
        use std::f64::consts::{PI, TAU};
        let corner = |i: usize, j: usize| {
            let (a, b) = (
                PI * i as f64 / rows as f64,
                TAU * j as f64 / (2 * rows) as f64,
            );
            let s = [a.sin() * b.cos(), a.cos(), a.sin() * b.sin()];
            [0, 1, 2].map(|k| center[k] + radius * s[k])
        };
        let quads = (0..rows).flat_map(|i| (0..2 * rows).map(move |j| (i, j)));
        quads
            .flat_map(|(i, j)| {
                let [a, b, c, d] = [
                    corner(i, j),
                    corner(i + 1, j),
                    corner(i + 1, j + 1),
                    corner(i, j + 1),
                ];
                [[a, b, c], [a, c, d]]
            })
            .collect()
    }

    #[test]
    fn boxes_hide_no_triangle() {
        let corners = numbers(41, 9 * 300);
        let soup: Vec<Triangle> = corners
            .chunks(9)
            .map(|c| {
                let near = |i: usize| [0, 1, 2].map(|k| c[k] + 0.4 * c[3 * i + k]);
                [near(0), near(1), near(2)]
            })
            .collect();
        let caster = Caster::new(soup.clone());
        let mut hits = 0;
        for (i, s) in directions(400).into_iter().enumerate() {
            let start = numbers(i as u64, 3);
            let origin = [1.5 * start[0], 1.5 * start[1], 1.5 * start[2]];
            let brute = soup
                .iter()
                .filter_map(|t| intersect(t, origin, s, 0.0))
                .reduce(f64::min);
            assert_eq!(caster.nearest(origin, s, 0.0), brute);
            assert_eq!(caster.blocked(origin, s, 0.0), brute.is_some());
            hits += usize::from(brute.is_some());
        }
        assert!((50..350).contains(&hits), "{hits} rays hit");
    }

    #[test]
    fn no_ray_slips_between_triangles() {
        let triangles = ball([0.0; 3], 1.0, 12);
        let caster = Caster::new(triangles.clone());
        for s in directions(3000) {
            assert!(caster.blocked([0.0; 3], s, 0.0));
        }
        // Straight at the corners and the middles of the edges.
        for [a, b, _] in triangles {
            let middle = [0, 1, 2].map(|k| 0.5 * (a[k] + b[k]));
            for target in [a, middle] {
                assert!(caster.blocked([0.0; 3], crate::vec3::normalize(target), 0.0));
            }
        }
    }

    #[test]
    fn nothing_is_blocked_by_nothing() {
        let caster = Caster::new(Vec::new());
        assert!(!caster.blocked([0.0; 3], [0.0, 1.0, 0.0], 0.0));
        let flat = [[1.0, 1.0, 1.0]; 3];
        assert_eq!(
            Caster::new(vec![flat]).nearest([0.0; 3], [0.0, 1.0, 0.0], 0.0),
            None
        );
    }

    #[test]
    fn surfaces_do_not_block_their_own_points() {
        let floor = [[-9.0, 0.0, -9.0], [9.0, 0.0, -9.0], [0.0, 0.0, 9.0]];
        let caster = Caster::new(vec![floor]);
        assert!(!caster.blocked([0.0; 3], [0.0, 1.0, 0.0], 1e-6));
        // From a point that rounding put below its surface.
        assert!(caster.blocked([0.0, -1e-7, 0.0], [0.0, 1.0, 0.0], 0.0));
        assert!(!caster.blocked([0.0, -1e-7, 0.0], [0.0, 1.0, 0.0], 1e-6));
        let white = sampled::irradiance(
            [0.0, 1.0, 0.0],
            4000,
            |s| {
                if caster.blocked([0.0; 3], s, 1e-6) {
                    0.0
                } else {
                    1.0
                }
            },
            |_| [1.0; 3],
        );
        assert!((white.value[1] - 1.0).abs() < 1e-3);
    }

    #[test]
    fn a_ball_of_triangles_is_nearly_a_sphere() {
        let center = [0.5, 2.0, -0.5];
        let caster = Caster::new(ball(center, 1.0, 48));
        let dense = sampled::project(4, 50_000, |s| {
            if caster.blocked([0.0; 3], s, 0.0) {
                0.0
            } else {
                1.0
            }
        });
        let sphere = Sphere {
            center: center.map(|c| c as f32),
            radius: 1.0,
        };
        let exact = project(4, &caps([0.0; 3], &[sphere]), 1e-2);
        let off = crate::basis::distance(&dense.coefficients, &exact.coefficients);
        assert!(off < 5e-3, "{off:e}");
    }

    #[test]
    fn world_triangles_are_transformed() {
        let mesh = Mesh {
            positions: vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            triangles: vec![[2, 0, 1]],
            ..Mesh::default()
        };
        let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert_eq!(triangles(&mesh), [[z, x, y]]);
        // A quarter turn about +Z takes x to y and y to -x; then twice as large, then moved.
        let object = Object {
            name: String::from("triangle"),
            mesh,
            material: Material {
                albedo: [1.0; 3],
                texture: None,
            },
            transform: Affine3A::from_scale_rotation_translation(
                glam::Vec3::splat(2.0),
                Quat::from_rotation_z(std::f32::consts::FRAC_PI_2),
                glam::Vec3::new(10.0, 20.0, 30.0),
            ),
            spheres: Vec::new(),
        };
        let expected = [[10.0, 20.0, 32.0], [10.0, 22.0, 30.0], [8.0, 20.0, 30.0]];
        let found = world_triangles(&object);
        assert_eq!(found.len(), 1);
        for (corner, expected) in found[0].iter().zip(expected) {
            assert_close(corner, &expected, 1e-6);
        }
    }
}
