//! Points spread over a body's surface.

use crate::rays::Rays;
use crate::surface::{Crossing, Part, albedo, normal};
use glam::{DVec3, Vec3};
use std::f64::consts::TAU;

/// A point of a body's surface at which irradiance is looked up; each stands for as much area as the others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BasisSample {
    /// Where, in metres, object space.
    pub position: [f32; 3],
    /// Unit normal, object space.
    pub normal: [f32; 3],
    /// Linear Rec.709 reflectance, each in 0..=1.
    pub albedo: [f32; 3],
}

/// So many points, each for as much area as the others; none where there is no triangle of any extent.
pub(super) fn samples(parts: &[Part], count: usize) -> Vec<BasisSample> {
    let mut ends = Vec::new();
    let mut area = 0.0;
    for (part, (mesh, _)) in parts.iter().enumerate() {
        for (triangle, corners) in mesh.triangles.iter().enumerate() {
            let at = |i: u32| {
                let p = DVec3::from(mesh.positions.get(i as usize)?.map(f64::from));
                p.is_finite().then_some(p)
            };
            if let [Some(a), Some(b), Some(c)] = corners.map(at) {
                let across = (b - a).cross(c - a);
                if across.length() > 0.0 && across.is_finite() {
                    area += 0.5 * across.length();
                    ends.push((area, part, triangle, [a, b, c]));
                }
            }
        }
    }
    let spread = |k: usize| {
        let wanted = area * (k as f64 + 0.5) / count as f64;
        let at = ends.partition_point(|(end, ..)| *end <= wanted);
        let (_, part, triangle, [a, b, c]) = *ends.get(at.min(ends.len().checked_sub(1)?))?;
        // A sequence that fills a square evenly, however many of its points in a row are taken (Roberts 2018, R2), and the
        // square as a triangle.
        let [u, v] =
            [0.754_877_666_246_693, 0.569_840_290_998_053].map(|r: f64| (r * k as f64).fract());
        let root = u.sqrt();
        let weights = [1.0 - root, root * (1.0 - v), root * v];
        let crossing = Crossing {
            distance: 0.0,
            part: part as u32,
            triangle: triangle as u32,
            weights,
            leaves: false,
        };
        let [wa, wb, wc] = weights;
        let outward = (b - a).cross(c - a).normalize();
        Some(BasisSample {
            position: (a * wa + b * wb + c * wc).as_vec3().into(),
            normal: outside(&parts[part], &crossing, outward).into(),
            albedo: albedo(&parts[part], &crossing).into(),
        })
    };
    (0..count).filter_map(spread).collect()
}

/// The normal, on the side to which the vertices' normals point, or, without these, that of the triangle's winding.
fn outside(part: &Part, crossing: &Crossing, winding: DVec3) -> Vec3 {
    let (mesh, _) = part;
    let corners = mesh.triangles[crossing.triangle as usize];
    let normals = corners.map(|i| mesh.normals.get(i as usize).copied());
    let sum: Vec3 = normals.iter().flatten().map(|n| Vec3::from(*n)).sum();
    let outward = match winding.as_vec3().dot(sum) < 0.0 {
        true => -winding,
        false => winding,
    };
    normal(part, crossing, outward).as_vec3()
}

/// How far so many points of a body are apart.
pub(super) fn apart(rays: &Rays, count: usize) -> f32 {
    (rays.area() / count as f64).sqrt() as f32
}

/// The sample nearest to a place that faces whoever looks along `direction`; none where one that does not is nearer by more
/// than points are apart: the back of an open mesh sends nothing.
pub(super) fn nearest(
    samples: &[BasisSample],
    place: DVec3,
    direction: DVec3,
    apart: f32,
) -> Option<u32> {
    let (place, direction) = (place.as_vec3(), direction.as_vec3());
    let mut nearest = f32::INFINITY;
    let mut facing = (f32::INFINITY, None);
    for (at, sample) in (0..).zip(samples) {
        let far = Vec3::from(sample.position).distance_squared(place);
        nearest = nearest.min(far);
        if far < facing.0 && Vec3::from(sample.normal).dot(direction) < 0.0 {
            facing = (far, Some(at));
        }
    }
    let near = facing.0.sqrt() <= nearest.sqrt() + 2.0 * apart;
    facing.1.filter(|_| near)
}

/// The k-th of some directions that are spread evenly over heights from `low` to 1.
pub(super) fn even(k: usize, count: usize, low: f64) -> DVec3 {
    let height = 1.0 - (1.0 - low) * (k as f64 + 0.5) / count as f64;
    let (sin, cos) = (k as f64 * TAU * 0.618_033_988_749_895).sin_cos();
    let wide = (1.0 - height * height).max(0.0).sqrt();
    DVec3::new(wide * cos, height, wide * sin)
}
