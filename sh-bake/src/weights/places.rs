//! Where the light of a body's shadow is looked at.

use glam::DVec3;
use sh_scene::Mesh;
use std::f64::consts::{PI, TAU};

/// Places around a body, and places on it.
const AROUND: usize = 512;
const ON: usize = 384;

/// A receiver of light.
pub(crate) struct Place {
    pub(crate) position: DVec3,
    /// A unit vector.
    pub(crate) normal: DVec3,
    /// Whether it is on the body itself.
    pub(crate) own: bool,
}

/// Number `i` of a sequence that fills the unit cube evenly, dimension by dimension (Roberts 2018, "The unreasonable
/// effectiveness of quasirandom sequences"): powers of the root of x⁶ = x + 1.
pub(super) fn even<const N: usize>(i: usize) -> [f64; N] {
    const ROOT: f64 = 1.134_724_138_401_519_5;
    std::array::from_fn(|k| (0.5 + (i + 1) as f64 * ROOT.powi(-(k as i32) - 1)).fract())
}

/// The unit vector of two numbers in 0..1, evenly over the sphere.
fn direction(u: f64, v: f64) -> DVec3 {
    let z = 1.0 - 2.0 * u;
    let flat = (1.0 - z * z).max(0.0).sqrt();
    let (sin, cos) = (TAU * v).sin_cos();
    DVec3::new(flat * cos, flat * sin, z)
}

/// Two unit vectors across one.
fn across(axis: DVec3) -> [DVec3; 2] {
    let x = axis.any_orthonormal_vector();
    [x, axis.cross(x)]
}

/// Half of the places are on the ground that the body stands on; a quarter on planes that it touches in other directions, as
/// walls and slopes are; the rest is in the open and faces anywhere. `lowest` tells how far the body reaches down along a
/// direction, seen from `center`.
pub(super) fn around(
    center: DVec3,
    radius: f64,
    lowest: impl Fn(DVec3) -> f64,
    up: DVec3,
) -> Vec<Place> {
    let up = up.normalize_or(DVec3::Y);
    let place = |i: usize| {
        let [a, b, c, d, e] = even(i);
        let normal = match i % 4 {
            0 | 1 => up,
            _ => direction(a, b),
        };
        let position = if i % 4 < 3 {
            let [x, y] = across(normal);
            let (sin, cos) = (TAU * d).sin_cos();
            let flat = (x * cos + y * sin) * (2.5 * radius * c.sqrt());
            center + flat + normal * lowest(normal)
        } else {
            center + direction(c, d) * (radius * (0.6 + 2.4 * e))
        };
        Place {
            // A little above what rays must not meet.
            position: position + normal * (1e-3 * radius),
            normal,
            own: false,
        }
    };
    (0..AROUND).map(place).collect()
}

/// Places on meshes, evenly over their area.
pub(super) fn on(meshes: &[Mesh], radius: f64) -> Vec<Place> {
    let corner = |mesh: &Mesh, i: u32| {
        let at = mesh.positions.get(i as usize)?;
        Some(DVec3::from(at.map(f64::from)))
    };
    let mut triangles = Vec::new();
    let mut total = 0.0;
    for (m, mesh) in meshes.iter().enumerate() {
        for (t, corners) in mesh.triangles.iter().enumerate() {
            let [Some(a), Some(b), Some(c)] = corners.map(|i| corner(mesh, i)) else {
                continue;
            };
            let area = (b - a).cross(c - a).length();
            if area > 0.0 && area.is_finite() {
                total += area;
                triangles.push((total, m, t));
            }
        }
    }
    let place = |i: usize| {
        let [u, across, along, ..] = even::<5>(i);
        let at = triangles.partition_point(|(until, ..)| *until < u * total);
        let (_, m, t) = *triangles.get(at)?;
        let (mesh, corners) = (&meshes[m], meshes[m].triangles[t]);
        let [a, b, c] = corners.map(|i| DVec3::from(mesh.positions[i as usize].map(f64::from)));
        let root = across.sqrt();
        let weights = [1.0 - root, root * (1.0 - along), root * along];
        let flat = (b - a).cross(c - a).normalize();
        let smooth = corners.iter().zip(weights).map(|(&i, w)| {
            let normal = mesh.normals.get(i as usize).copied().unwrap_or_default();
            DVec3::from(normal.map(f64::from)) * w
        });
        let normal = smooth.sum::<DVec3>().normalize_or(flat);
        let position = a * weights[0] + b * weights[1] + c * weights[2];
        let side = flat * flat.dot(normal).signum();
        Some(Place {
            position: position + side * (2e-3 * radius),
            normal,
            own: true,
        })
    };
    (0..ON).filter_map(place).collect()
}

/// Directions about a normal in proportion to the cosine with it, `count` of them, turned by two numbers in 0..1.
pub(super) fn lobe(normal: DVec3, count: usize, shift: [f64; 2]) -> impl Iterator<Item = DVec3> {
    let [x, y] = across(normal);
    (0..count).map(move |k| {
        let [u, v, ..] = even::<5>(k);
        let (u, v) = ((u + shift[0]).fract(), (v + shift[1]).fract());
        let (sin, cos) = (2.0 * PI * v).sin_cos();
        let flat = u.sqrt();
        (x * cos + y * sin) * flat + normal * (1.0 - u).max(0.0).sqrt()
    })
}
