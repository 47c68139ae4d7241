//! Rays and a body: whether it blocks them, and where they meet it.

use crate::surface::Part;
use glam::{DVec3, Vec3A};
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2;
use obvhs::ray::{Ray, RayHit};
use obvhs::triangle::Triangle;
use obvhs::{Boundable, BvhBuildParams};
use sh_scene::Mesh;
use std::time::Duration;

/// How much larger boxes are than triangles, over the body's radius.
const PAD: f32 = 1e-5;

/// All triangles of a body, and the ball that they are looked at in.
pub(crate) struct Rays {
    triangles: Vec<Triangle>,
    hierarchy: Bvh2,
    pub(crate) center: DVec3,
    pub(crate) radius: f64,
    /// How far the farthest corner is from the centre.
    pub(crate) reach: f64,
    /// Of all corners, from the centre.
    corners: Vec<DVec3>,
}

struct Bounds(Aabb);

impl Boundable for Bounds {
    fn aabb(&self) -> Aabb {
        self.0
    }
}

impl Rays {
    /// None where there is no triangle of any extent.
    pub(crate) fn new(meshes: &[Mesh]) -> Option<Self> {
        let mut corners: Vec<[DVec3; 3]> = Vec::new();
        for mesh in meshes {
            let at = |i: u32| {
                let p = DVec3::from(mesh.positions.get(i as usize)?.map(f64::from));
                p.is_finite().then_some(p)
            };
            for triangle in &mesh.triangles {
                if let [Some(a), Some(b), Some(c)] = triangle.map(at) {
                    corners.push([a, b, c]);
                }
            }
        }
        let all = || corners.iter().flatten().copied();
        let low = all().reduce(DVec3::min)?;
        let high = all().reduce(DVec3::max)?;
        let center = 0.5 * (low + high);
        let radius = 0.5 * (high - low).length();
        if !(radius > 0.0 && radius.is_finite()) {
            return None;
        }
        let local: Vec<DVec3> = all().map(|p| p - center).collect();
        // In a space of its own, so that single precision does for bodies of any size anywhere.
        let triangle = |[a, b, c]: &[DVec3; 3]| {
            let [v0, v1, v2] = [a, b, c].map(|p| ((*p - center) / radius).as_vec3a());
            Triangle { v0, v1, v2 }
        };
        let triangles: Vec<Triangle> = corners.iter().map(triangle).collect();
        let bounds: Vec<Bounds> = triangles
            .iter()
            .map(|t| {
                let tight = t.aabb();
                Bounds(Aabb {
                    min: tight.min - PAD,
                    max: tight.max + PAD,
                })
            })
            .collect();
        let params = BvhBuildParams::medium_build();
        let hierarchy = build_bvh2(&bounds, params, &mut Duration::default());
        let order = &hierarchy.primitive_indices;
        Some(Self {
            triangles: order.iter().map(|&i| triangles[i as usize]).collect(),
            hierarchy,
            center,
            radius,
            reach: local.iter().map(|p| p.length()).fold(0.0, f64::max),
            corners: local,
        })
    }

    /// How far the body reaches along a direction at its lowest, from the centre.
    pub(crate) fn lowest(&self, direction: DVec3) -> f64 {
        let along = self.corners.iter().map(|p| p.dot(direction));
        along.fold(f64::INFINITY, f64::min)
    }

    /// Of the parts of a body.
    pub(crate) fn of(parts: &[Part]) -> Option<Self> {
        let meshes: Vec<Mesh> = parts.iter().map(|(mesh, _)| Mesh::clone(mesh)).collect();
        Self::new(&meshes)
    }

    /// Of all triangles together.
    pub(crate) fn area(&self) -> f64 {
        let of = |t: &Triangle| 0.5 * (t.v1 - t.v0).cross(t.v2 - t.v0).as_dvec3().length();
        self.triangles.iter().map(of).sum::<f64>() * self.radius.powi(2)
    }

    /// Where a ray first meets the body.
    pub(crate) fn first(&self, from: DVec3, direction: DVec3) -> Option<DVec3> {
        let origin: Vec3A = ((from - self.center) / self.radius).as_vec3a();
        let ray = Ray::new_inf(origin, direction.as_vec3a());
        let mut nearest = RayHit::none();
        let found = self.hierarchy.ray_traverse(ray, &mut nearest, |ray, id| {
            self.triangles[id].intersect(ray)
        });
        found.then(|| from + direction * (f64::from(nearest.t) * self.radius))
    }

    /// Whether a ray meets the body.
    pub(crate) fn meet(&self, from: DVec3, direction: DVec3) -> bool {
        self.between(from, direction, f64::INFINITY)
    }

    /// Whether a ray meets the body before it has come so far.
    pub(crate) fn between(&self, from: DVec3, direction: DVec3, far: f64) -> bool {
        let origin: Vec3A = ((from - self.center) / self.radius).as_vec3a();
        let far = (far / self.radius) as f32;
        let ray = Ray::new(origin, direction.as_vec3a(), 0.0, far);
        !self
            .hierarchy
            .ray_traverse_miss(ray, |ray, id| self.triangles[id].intersect(ray))
    }
}
