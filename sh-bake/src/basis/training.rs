//! Irradiance that a body is taught by: what falls on it of many lights, in its own shadow.

use super::escape::{Ray, hidden};
use super::samples::{Lookup, even};
use crate::rays::Rays;
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use sh_core::Routines;
use sh_scene::BasisSample;
use sh_scene::basis::{Escape, MOST_COEFFICIENTS, PATCH_SAMPLES};
use std::f64::consts::{PI, TAU};

/// Order of the lights that are far away: all of them that there are in that order.
const ORDER: usize = 4;
const FAR: usize = ORDER * ORDER;

/// Point lights around the body (Iwasaki et al. 2007, section 4.2): some on each of a few spheres around it.
const NEAR: usize = 64;
/// Radii of these, over the body's.
const SPHERES: [f64; 4] = [1.05, 1.25, 1.55, 2.0];

/// How much more a light counts that is far away, in the mean of all of them: together as much as all near by, which are
/// more, and light a few points each.
const FAR_COUNTS: f64 = 4.0;

/// Rays a sample.
pub(super) const RAYS: usize = 256;

/// Where rays begin in front of the surface, over the body's radius.
const OFF: f64 = 1e-4;

/// What a sample sees of its own body.
struct Seen {
    /// Irradiance of each far light: of those of [`ORDER`] first, and the further ones that lobes need.
    far: [f64; MOST_COEFFICIENTS],
    /// Of each light near by, with the square of its distance as intensity.
    near: Vec<f64>,
    /// The samples that rays meet: each ray is 1 / RAYS of all that falls on it.
    met: Vec<u32>,
    /// Where rays go, and whether they meet the body.
    rays: Vec<Ray>,
}

/// What lights give, and how a body lights itself.
pub(super) struct Training {
    /// Irradiance at all samples, light by light, scaled by how much each counts.
    pub columns: Vec<Vec<f64>>,
    /// For each sample those that it sees, one a ray.
    pub met: Vec<Vec<u32>>,
    /// How much of each patch can be seen.
    pub escape: Vec<Escape>,
    /// What far lights give each patch, in the mean of its samples.
    pub lobes: Vec<[f32; MOST_COEFFICIENTS]>,
}

/// Irradiance of all lights at all samples.
pub(super) fn training(samples: &[BasisSample], rays: &Rays, tell: &(dyn Fn() + Sync)) -> Training {
    let lights = near_lights(rays);
    let lookup = Lookup::new(samples, rays);
    let look = |index: usize| {
        let seen = look((samples, &lookup), index, rays, &lights);
        tell();
        seen
    };
    let seen: Vec<Seen> = (0..samples.len()).into_par_iter().map(look).collect();
    let far = (0..FAR).map(|i| seen.iter().map(|s| s.far[i]).collect());
    let near = (0..lights.len()).map(|i| seen.iter().map(|s| s.near[i]).collect());
    let mut columns: Vec<Vec<f64>> = far.chain(near).collect();
    let patches = seen.chunks(PATCH_SAMPLES);
    let patches = patches.map(|patch| hidden(patch.iter().flat_map(|seen| &seen.rays)));
    let escape = patches.collect();
    let lobe = |patch: &[Seen]| {
        let mean = |i: usize| patch.iter().map(|s| s.far[i]).sum::<f64>() / patch.len() as f64;
        std::array::from_fn(|i| mean(i) as f32)
    };
    let lobes = seen.chunks(PATCH_SAMPLES).map(lobe).collect();
    let met: Vec<Vec<u32>> = seen.into_iter().map(|s| s.met).collect();
    for i in 0..FAR {
        columns.push(bounced(&columns[i], samples, &met));
    }
    let square = |c: &[f64]| c.iter().map(|x| x * x).sum::<f64>() / c.len().max(1) as f64;
    // One scale for all that is far away: what gives a body little counts for little.
    let far = columns[..FAR].iter().map(|c| square(c)).sum::<f64>() / FAR as f64;
    for (index, column) in columns.iter_mut().enumerate() {
        let scale = match index.checked_sub(FAR) {
            Some(near) if near < lights.len() => square(column).sqrt().recip(),
            _ => FAR_COUNTS / far.sqrt(),
        };
        if scale.is_finite() {
            column.iter_mut().for_each(|x| *x *= scale);
        }
    }
    Training {
        columns,
        met,
        escape,
        lobes,
    }
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
        let radius = radius * rays.reach;
        (0..NEAR).map(move |k| rays.center + even(k, NEAR, -1.0) * radius)
    };
    SPHERES.iter().flat_map(on).collect()
}

fn look(
    (samples, lookup): (&[BasisSample], &Lookup),
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
        far: [0.0; MOST_COEFFICIENTS],
        near: Vec::with_capacity(lights.len()),
        met: Vec::new(),
        rays: Vec::with_capacity(RAYS),
    };
    for k in 0..RAYS {
        // Evenly over the disc below the hemisphere: as many as there is cosine.
        let square = (k as f64 + 0.5) / RAYS as f64;
        let (sin, cos) = (k as f64 * TAU * 0.618_033_988_749_895).sin_cos();
        let flat = square.sqrt();
        let up = (1.0 - square).sqrt();
        let direction = side * (cos * flat) + other * (sin * flat) + normal * up;
        let first = rays.first(from, direction);
        seen.rays.push(Ray {
            direction,
            meets: first.is_some(),
        });
        match first {
            Some(place) => seen.met.extend(lookup.nearest(place, direction)),
            None => {
                let basis = <[f64; MOST_COEFFICIENTS]>::basis(direction.to_array());
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
        let square = (rays.reach / far).powi(2);
        seen.near.push(if hidden { 0.0 } else { cosine * square });
    }
    seen
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::basis::samples::spread;
    use sh_scene::{Material, Mesh};

    /// A floor under a smaller roof, both of which face up: what the roof hides of lights, near by and far away, is dark.
    #[test]
    fn bodies_are_taught_in_their_own_shadow() {
        let plate = |half: f32, height: f32| {
            [[-half, -half], [half, -half], [half, half], [-half, half]]
                .map(|[x, z]| [x, height, z])
        };
        let mesh = Mesh {
            positions: [plate(1.0, 0.0), plate(0.5, 0.3)].concat(),
            normals: vec![[0.0, 1.0, 0.0]; 8],
            triangles: vec![[0, 2, 1], [0, 3, 2], [4, 6, 5], [4, 7, 6]],
            ..Mesh::default()
        };
        let white = Material::diffuse([1.0; 3]);
        let parts = [(&mesh, &white)];
        let rays = Rays::of(&parts).unwrap();
        let points = spread(&parts, 400).samples;
        let taught = training(&points, &rays, &|| {});
        let (mut dark, mut lit) = (0, 0);
        for (k, light) in near_lights(&rays).iter().enumerate() {
            for (i, point) in points
                .iter()
                .enumerate()
                .filter(|(_, p)| p.position[1] < 0.1)
            {
                let from = Vec3::from(point.position).as_dvec3();
                let at = from + (*light - from) * (0.3 / light.y);
                let beside = at.x.abs().max(at.z.abs());
                let irradiance = taught.columns[FAR + k][i];
                // What is right at the roof's edge is left alone.
                if light.y > 0.35 && beside < 0.49 {
                    assert!(irradiance == 0.0, "{light}, {from}: {irradiance}");
                    dark += 1;
                } else if light.y > 0.35 && beside > 0.51 {
                    assert!(irradiance > 0.0, "{light}, {from}");
                    lit += 1;
                }
            }
        }
        assert!(dark > 1000 && lit > 1000, "{dark} {lit}");
        // The first far light is even: under the middle of the roof most of it is gone.
        let middle = |p: &BasisSample| p.position[0].abs().max(p.position[2].abs()) < 0.2;
        let mean = |on: &dyn Fn(&BasisSample) -> bool| {
            let some = points.iter().zip(&taught.columns[0]).filter(|(p, _)| on(p));
            let (sum, count) = some.fold((0.0, 0.0), |(s, n), (_, e)| (s + e, n + 1.0));
            sum / count
        };
        let [under, above] = [-0.1, 0.1]
            .map(|side: f32| mean(&|p| middle(p) && (p.position[1] - 0.15) * side > 0.0));
        assert!(under < 0.5 * above, "{under} {above}");
    }
}
