//! Irradiance that a body is taught by: what falls on it of many lights, in its own shadow.

use super::BasisSample;
use crate::rays::Rays;
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use sh_core::Routines;
use std::f64::consts::{PI, TAU};

/// Order of the lights that are far away: all of them that there are in that order.
const ORDER: usize = 4;
const FAR: usize = ORDER * ORDER;

/// Point lights around the body (Iwasaki et al. 2007, section 4.2): some on each of a few spheres around it.
const NEAR: usize = 64;
/// Radii of these, over the body's.
const SPHERES: [f64; 4] = [1.05, 1.25, 1.55, 2.0];

/// Rays a sample.
pub(super) const RAYS: usize = 256;

/// Where rays begin in front of the surface, over the body's radius.
const OFF: f64 = 1e-4;

/// What a sample sees of its own body.
struct Seen {
    /// Irradiance of each far light.
    far: [f64; FAR],
    /// Of each light near by, with the square of its distance as intensity.
    near: Vec<f64>,
    /// The samples that rays meet: each ray is 1 / RAYS of all that falls on it.
    met: Vec<u32>,
}

/// What lights give, and how a body lights itself.
pub(super) struct Training {
    /// Irradiance at all samples, light by light; each with a mean square of 1, or 0.
    pub columns: Vec<Vec<f64>>,
    /// For each sample those that it sees, one a ray.
    pub met: Vec<Vec<u32>>,
}

/// Irradiance of all lights at all samples.
pub(super) fn training(samples: &[BasisSample], rays: &Rays, tell: &(dyn Fn() + Sync)) -> Training {
    let lights = near_lights(rays);
    let apart = (rays.area() / samples.len() as f64).sqrt() as f32;
    let look = |index: usize| {
        let seen = look((samples, apart), index, rays, &lights);
        tell();
        seen
    };
    let seen: Vec<Seen> = (0..samples.len()).into_par_iter().map(look).collect();
    let far = (0..FAR).map(|i| seen.iter().map(|s| s.far[i]).collect());
    let near = (0..lights.len()).map(|i| seen.iter().map(|s| s.near[i]).collect());
    let mut columns: Vec<Vec<f64>> = far.chain(near).collect();
    let met: Vec<Vec<u32>> = seen.into_iter().map(|s| s.met).collect();
    for i in 0..FAR {
        columns.push(bounced(&columns[i], samples, &met));
    }
    for column in &mut columns {
        let mean = column.iter().map(|x| x * x).sum::<f64>() / column.len().max(1) as f64;
        if mean > 0.0 {
            let scale = mean.sqrt().recip();
            column.iter_mut().for_each(|x| *x *= scale);
        }
    }
    Training { columns, met }
}

/// What a body gives itself of an irradiance, in the mean of the three channels.
fn bounced(irradiance: &[f64], samples: &[BasisSample], met: &[Vec<u32>]) -> Vec<f64> {
    let gray = |i: usize| f64::from(samples[i].albedo.iter().sum::<f32>()) / 3.0;
    let sent = |i: &u32| gray(*i as usize) * irradiance[*i as usize];
    met.iter()
        .map(|all| all.iter().map(sent).sum::<f64>() / RAYS as f64)
        .collect()
}

fn near_lights(rays: &Rays) -> Vec<DVec3> {
    let on = |radius: &f64| {
        let radius = radius * rays.radius;
        (0..NEAR).map(move |k| rays.center + even(k, NEAR, -1.0) * radius)
    };
    SPHERES.iter().flat_map(on).collect()
}

/// The k-th of some directions that are spread evenly over heights from `low` to 1.
fn even(k: usize, count: usize, low: f64) -> DVec3 {
    let height = 1.0 - (1.0 - low) * (k as f64 + 0.5) / count as f64;
    let (sin, cos) = (k as f64 * TAU * 0.618_033_988_749_895).sin_cos();
    let wide = (1.0 - height * height).max(0.0).sqrt();
    DVec3::new(wide * cos, height, wide * sin)
}

fn look(
    (samples, apart): (&[BasisSample], f32),
    index: usize,
    rays: &Rays,
    lights: &[DVec3],
) -> Seen {
    let sample = &samples[index];
    let normal = Vec3::from(sample.normal).as_dvec3();
    let from = Vec3::from(sample.position).as_dvec3() + normal * (OFF * rays.radius);
    let (side, other) = normal.any_orthonormal_pair();
    // Another turn for each sample, so that what few rays miss is noise and no pattern.
    let (sin, cos) = (index as f64 * TAU * 0.414_213_562_373_095).sin_cos();
    let (side, other) = (side * cos + other * sin, other * cos - side * sin);
    let mut seen = Seen {
        far: [0.0; FAR],
        near: Vec::with_capacity(lights.len()),
        met: Vec::new(),
    };
    for k in 0..RAYS {
        // Evenly over the disc below the hemisphere: as many as there is cosine.
        let square = (k as f64 + 0.5) / RAYS as f64;
        let (sin, cos) = (k as f64 * TAU * 0.618_033_988_749_895).sin_cos();
        let flat = square.sqrt();
        let up = (1.0 - square).sqrt();
        let direction = side * (cos * flat) + other * (sin * flat) + normal * up;
        match rays.first(from, direction) {
            Some(place) => seen.met.extend(nearest(samples, place, direction, apart)),
            None => {
                let basis = <[f64; FAR]>::basis(direction.to_array());
                for (sum, y) in seen.far.iter_mut().zip(basis) {
                    *sum += y * PI / RAYS as f64;
                }
            }
        }
    }
    for light in lights {
        let to = *light - from;
        let (far, direction) = (to.length(), to.normalize_or_zero());
        let cosine = normal.dot(direction);
        let hidden = cosine <= 0.0 || rays.between(from, direction, far);
        let square = (rays.radius / far).powi(2);
        seen.near.push(if hidden { 0.0 } else { cosine * square });
    }
    seen
}

/// The sample nearest to a place that faces whoever looks along `direction`; none where one that does not is nearer by more
/// than points are apart: the back of an open mesh sends nothing.
fn nearest(samples: &[BasisSample], place: DVec3, direction: DVec3, apart: f32) -> Option<u32> {
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
