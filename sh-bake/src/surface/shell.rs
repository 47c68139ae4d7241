//! A body's triangles, and where lines go through them.
//!
//! The intersection is Möller and Trumbore's ("Fast, Minimum Storage Ray/Triangle Intersection", 1997) in double
//! precision. A hierarchy of boxes in single precision only decides which triangles are asked: it is built over the
//! body moved into the cube -1..1, and its boxes are a little larger than the triangles.

use super::part::Part;
use glam::DVec3;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2;
use obvhs::ray::Ray;
use obvhs::{Boundable, BvhBuildParams};
use std::time::Duration;

/// Barycentric coordinates below zero that still count as inside, so that nothing slips between neighbours.
const SLACK: f64 = 1e-12;
/// How much larger boxes are, where the body is 2 across.
const PAD: f32 = 2e-5;

/// All triangles of a body.
pub(super) struct Shell {
    /// Which part and triangle each is.
    sources: Vec<[u32; 2]>,
    corners: Vec<[DVec3; 3]>,
    hierarchy: Bvh2,
    /// The cube's middle, and what takes distances to it.
    middle: DVec3,
    scale: f64,
}

/// A place where a line goes through a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Crossing {
    /// Along the line's direction, below 0 behind its origin.
    pub(crate) distance: f64,
    pub(crate) part: u32,
    pub(crate) triangle: u32,
    /// What the place has of each corner.
    pub(crate) weights: [f64; 3],
    /// Whether the line leaves by it, where triangles turn counter-clockwise seen from outside.
    pub(crate) leaves: bool,
}

struct Bounds(Aabb);

impl Boundable for Bounds {
    fn aabb(&self) -> Aabb {
        self.0
    }
}

impl Shell {
    /// Sorts the triangles into boxes; some microseconds each. Those with corners that are missing or no numbers are
    /// left out.
    pub(super) fn new(parts: &[Part]) -> Self {
        let (mut sources, mut corners) = (Vec::new(), Vec::new());
        for (p, (mesh, _)) in parts.iter().enumerate() {
            let point = |i: u32| {
                let p = DVec3::from(mesh.positions.get(i as usize)?.map(f64::from));
                p.is_finite().then_some(p)
            };
            for (t, [a, b, c]) in mesh.triangles.iter().enumerate() {
                if let (Some(a), Some(b), Some(c)) = (point(*a), point(*b), point(*c)) {
                    sources.push([p as u32, t as u32]);
                    corners.push([a, b, c]);
                }
            }
        }
        let all = || corners.iter().flatten().copied();
        let (low, high) = match corners.is_empty() {
            true => (DVec3::ZERO, DVec3::ZERO),
            false => (
                all().fold(DVec3::INFINITY, DVec3::min),
                all().fold(DVec3::NEG_INFINITY, DVec3::max),
            ),
        };
        let middle = 0.5 * (low + high);
        let half = 0.5 * (high - low).max_element();
        let scale = if half > 0.0 { 1.0 / half } else { 1.0 };
        let bounds: Vec<Bounds> = corners
            .iter()
            .map(|triangle| {
                let points = triangle.map(|p| ((p - middle) * scale).as_vec3a());
                let tight = Aabb::from_points(&points);
                Bounds(Aabb {
                    min: tight.min - PAD,
                    max: tight.max + PAD,
                })
            })
            .collect();
        let hierarchy = build_bvh2(
            &bounds,
            BvhBuildParams::medium_build(),
            &mut Duration::default(),
        );
        let order = &hierarchy.primitive_indices;
        Self {
            sources: order.iter().map(|&i| sources[i as usize]).collect(),
            corners: order.iter().map(|&i| corners[i as usize]).collect(),
            hierarchy,
            middle,
            scale,
        }
    }

    /// The volume that the triangles enclose, below 0 where they face inwards; of a closed surface.
    pub(super) fn volume(&self) -> f64 {
        let volume = |[a, b, c]: &[DVec3; 3]| {
            let [a, b, c] = [a - self.middle, b - self.middle, c - self.middle];
            a.dot(b.cross(c)) / 6.0
        };
        // In the order of the mesh, so that rounding does not depend on the hierarchy.
        let mut order: Vec<usize> = (0..self.corners.len()).collect();
        order.sort_by_key(|&i| self.sources[i]);
        order.iter().map(|&i| volume(&self.corners[i])).sum()
    }

    /// Adds where a ray with a unit direction goes through triangles, its origin included, in any order.
    pub(super) fn crossings(&self, origin: DVec3, direction: DVec3, found: &mut Vec<Crossing>) {
        let start = ((origin - self.middle) * self.scale).as_vec3a();
        if !start.is_finite() {
            return;
        }
        let ray = Ray::new_inf(start, direction.as_vec3a());
        self.hierarchy.ray_traverse_anyhit(ray, |_, id| {
            let Some((distance, weights, leaves)) = cross(&self.corners[id], origin, direction)
            else {
                return;
            };
            if distance >= 0.0 {
                let [part, triangle] = self.sources[id];
                found.push(Crossing {
                    distance,
                    part,
                    triangle,
                    weights,
                    leaves,
                });
            }
        });
    }
}

/// Where a line meets a triangle, what the place has of each corner, and whether it leaves there.
fn cross([a, b, c]: &[DVec3; 3], origin: DVec3, direction: DVec3) -> Option<(f64, [f64; 3], bool)> {
    let (ab, ac) = (b - a, c - a);
    let p = direction.cross(ac);
    let determinant = ab.dot(p);
    if determinant == 0.0 {
        return None;
    }
    let to = origin - a;
    let q = to.cross(ab);
    let u = to.dot(p) / determinant;
    let v = direction.dot(q) / determinant;
    let distance = ac.dot(q) / determinant;
    let inside = u >= -SLACK && v >= -SLACK && u + v <= 1.0 + SLACK && distance.is_finite();
    inside.then_some((distance, [1.0 - u - v, u, v], determinant < 0.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes;
    use sh_scene::Material;
    use sh_scene::surface::stratified;

    const GREY: Material = Material::diffuse([0.5; 3]);

    #[test]
    fn a_ball_is_left_once_from_within_and_crossed_twice_from_without() {
        let mesh = shapes::ball(2.0, 3);
        let shell = Shell::new(&[(&mesh, &GREY)]);
        let exact = 4.0 / 3.0 * std::f64::consts::PI * 8.0;
        assert!((shell.volume() / exact - 1.0).abs() < 0.02);
        let mut found = Vec::new();
        for d in stratified(8, 16).map(|d| d.as_dvec3().normalize()) {
            found.clear();
            shell.crossings(DVec3::ZERO, d, &mut found);
            assert_eq!(found.iter().filter(|c| c.leaves).count(), found.len());
            assert!(!found.is_empty() && (found[0].distance - 2.0).abs() < 0.05);
            found.clear();
            shell.crossings(d * 5.0, -d, &mut found);
            let mut ways: Vec<(f64, bool)> = found.iter().map(|c| (c.distance, c.leaves)).collect();
            ways.sort_by(|a, b| a.0.total_cmp(&b.0));
            assert!(!ways[0].1 && (ways[0].0 - 3.0).abs() < 0.05);
            let last = ways[ways.len() - 1];
            assert!(last.1 && (last.0 - 7.0).abs() < 0.05);
            found.clear();
            shell.crossings(d * 5.0, d, &mut found);
            assert_eq!(found, []);
        }
    }

    #[test]
    fn every_triangle_that_a_line_meets_is_found() {
        let mesh = shapes::torus_knot(2, 3, 1.0, 0.4, 0.15);
        let shell = Shell::new(&[(&mesh, &GREY)]);
        let mut found = Vec::new();
        for (k, d) in stratified(6, 7).enumerate() {
            let d = d.as_dvec3().normalize();
            let origin = DVec3::new(0.3, -0.1, 0.02 * k as f64);
            found.clear();
            shell.crossings(origin, d, &mut found);
            let met =
                |t: &[DVec3; 3]| cross(t, origin, d).is_some_and(|(distance, ..)| distance >= 0.0);
            assert_eq!(found.len(), shell.corners.iter().filter(|t| met(t)).count());
        }
    }

    #[test]
    fn nothing_is_met_where_there_is_nothing() {
        for mesh in [
            sh_scene::Mesh::default(),
            sh_scene::Mesh {
                positions: vec![[f32::NAN; 3], [0.0; 3], [1.0, 0.0, 0.0]],
                triangles: vec![[0, 1, 2], [1, 2, 7]],
                ..Default::default()
            },
        ] {
            let mut found = Vec::new();
            let shell = Shell::new(&[(&mesh, &GREY)]);
            shell.crossings(DVec3::ZERO, DVec3::X, &mut found);
            assert!(found.is_empty() && shell.volume() == 0.0);
        }
    }
}
