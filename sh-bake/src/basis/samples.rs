//! Points spread over a body's surface.

use crate::rays::Rays;
use crate::surface::{Crossing, Part, albedo, normal};
use glam::{DVec3, Vec3};
use sh_scene::BasisSample;
use sh_scene::basis::PATCH_SAMPLES;
use std::f64::consts::TAU;

/// Points for each sample: of these one stands for all.
const EACH: usize = 16;

/// The fewest samples of a body, and the most.
const SAMPLES: [usize; 2] = [1024, 4096];

/// How many patches there are across a body's thickness, at least, if that is no more than the most: what is smaller than
/// a patch does not look like it.
const ACROSS: f64 = 3.0;

/// Points whose chords tell how thick a body is.
const CHORDS: usize = 512;

/// How many samples a body needs: a power of two. Thin ones need more: of a closed body chords have a mean length of 4 V / A
/// (Cauchy), as a ball of three quarters of that in radius has.
pub(super) fn needed(parts: &[Part], rays: &Rays) -> usize {
    let points = points(parts, CHORDS);
    let chord = |(k, point): (usize, &BasisSample)| {
        let normal = Vec3::from(point.normal).as_dvec3();
        let (side, other) = normal.any_orthonormal_pair();
        let square = (k as f64 + 0.5) / CHORDS as f64;
        let (sin, cos) = (k as f64 * TAU * 0.618_033_988_749_895).sin_cos();
        let inward = (side * cos + other * sin) * square.sqrt() - normal * (1.0 - square).sqrt();
        let from = Vec3::from(point.position).as_dvec3() + inward * (1e-4 * rays.radius);
        // Whoever leaves an open mesh meets nothing.
        rays.first(from, inward)
            .map_or(2.0 * rays.radius, |to| to.distance(from))
    };
    let all = points.iter().enumerate().map(chord).sum::<f64>();
    let thickness = 0.75 * all / points.len().max(1) as f64;
    let patches = rays.area() * (ACROSS / thickness).powi(2);
    let [least, most] = SAMPLES;
    let samples = patches.min(most as f64) as usize * PATCH_SAMPLES;
    samples.next_power_of_two().clamp(least, most)
}

/// A body's surface, spread over few points.
pub(super) struct Spread {
    /// Each for as much area as the others, patch by patch.
    pub samples: Vec<BasisSample>,
    /// Of each sample the part of the surface that it stands for, and of each patch: the mean place, and the mean normal,
    /// which is shorter where the surface is curved.
    pub parts: Vec<(Vec3, Vec3)>,
    pub patches: Vec<(Vec3, Vec3)>,
}

/// So many samples; none where there is no triangle of any extent.
pub(super) fn spread(parts: &[Part], count: usize) -> Spread {
    let mut all = points(parts, count * EACH);
    let scale = scale(&all);
    let place = |sample: &BasisSample| by_place_and_facing(sample, scale);
    halve(&mut all, EACH, &place);
    let mean = |of: fn(&BasisSample) -> [f32; 3], some: &[BasisSample]| {
        some.iter().map(|s| Vec3::from(of(s))).sum::<Vec3>() / some.len() as f32
    };
    let flat = |some: &[BasisSample]| (mean(|s| s.position, some), mean(|s| s.normal, some));
    let parts = all.chunks(EACH).map(flat).collect();
    let patches = all.chunks(EACH * PATCH_SAMPLES).map(flat).collect();
    let mut samples: Vec<BasisSample> = all.chunks(EACH).map(|some| middle(some, &place)).collect();
    // Light is looked up in the middle of a patch.
    for own in samples.chunks_mut(PATCH_SAMPLES) {
        let first = middle(own, &place);
        let at = own.iter().position(|sample| *sample == first);
        own.swap(0, at.unwrap_or(0));
    }
    Spread {
        samples,
        parts,
        patches,
    }
}

/// So many points, each for as much area as the others; none where there is no triangle of any extent.
fn points(parts: &[Part], count: usize) -> Vec<BasisSample> {
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

/// How much facing another way counts, for being of another patch, over being a radius apart.
const FACING: f32 = 0.7;

/// What tells points apart, in a body whose places are multiplied with `scale`.
fn by_place_and_facing(sample: &BasisSample, scale: f32) -> [f32; 6] {
    let [x, y, z] = sample.position.map(|x| x * scale);
    let [a, b, c] = sample.normal.map(|x| x * FACING);
    [x, y, z, a, b, c]
}

/// One over half of the box around all.
fn scale(all: &[BasisSample]) -> f32 {
    let places = || all.iter().map(|s| Vec3::from(s.position));
    let [low, high] = [places().reduce(Vec3::min), places().reduce(Vec3::max)];
    let across = high.unwrap_or_default() - low.unwrap_or_default();
    2.0 / across.length().max(f32::MIN_POSITIVE)
}

/// Puts points that are near each other and face the same way side by side: halves of halves, across what they differ in
/// most, down to so many.
fn halve(some: &mut [BasisSample], least: usize, place: &impl Fn(&BasisSample) -> [f32; 6]) {
    if some.len() <= least {
        return;
    }
    let means = means(some, place);
    let spread: [f32; 6] =
        std::array::from_fn(|k| some.iter().map(|s| (place(s)[k] - means[k]).powi(2)).sum());
    let widest = (0..6)
        .max_by(|a, b| spread[*a].total_cmp(&spread[*b]))
        .unwrap_or(0);
    some.sort_by(|a, b| place(a)[widest].total_cmp(&place(b)[widest]));
    let (low, high) = some.split_at_mut(some.len() / 2);
    halve(low, least, place);
    halve(high, least, place);
}

fn means(some: &[BasisSample], place: &impl Fn(&BasisSample) -> [f32; 6]) -> [f32; 6] {
    std::array::from_fn(|k| some.iter().map(|s| place(s)[k]).sum::<f32>() / some.len() as f32)
}

/// The one that is nearest to the mean.
fn middle(some: &[BasisSample], place: &impl Fn(&BasisSample) -> [f32; 6]) -> BasisSample {
    let means = means(some, place);
    let far = |s: &BasisSample| -> f32 {
        place(s)
            .iter()
            .zip(means)
            .map(|(x, mean)| (x - mean).powi(2))
            .sum()
    };
    let nearest = some.iter().min_by(|a, b| far(a).total_cmp(&far(b)));
    *nearest.unwrap_or(&some[0])
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

/// Samples of a body, to be found by place.
pub(super) struct Lookup<'a> {
    samples: &'a [BasisSample],
    /// Balls around runs of samples, which lie together.
    balls: Vec<(Vec3, f32)>,
    /// How far samples are apart.
    apart: f32,
}

/// Samples a ball.
const RUN: usize = 32;

impl<'a> Lookup<'a> {
    pub fn new(samples: &'a [BasisSample], rays: &Rays) -> Self {
        let ball = |run: &[BasisSample]| {
            let places = || run.iter().map(|s| Vec3::from(s.position));
            let center = places().sum::<Vec3>() / run.len() as f32;
            (
                center,
                places().map(|p| p.distance(center)).fold(0.0, f32::max),
            )
        };
        Self {
            samples,
            balls: samples.chunks(RUN).map(ball).collect(),
            apart: (rays.area() / samples.len() as f64).sqrt() as f32,
        }
    }

    /// The sample nearest to a place that faces whoever looks along `direction`; none where one that does not is nearer by
    /// some times what samples are apart: the back of an open mesh sends nothing.
    pub fn nearest(&self, place: DVec3, direction: DVec3) -> Option<u32> {
        let (place, direction) = (place.as_vec3(), direction.as_vec3());
        let mut nearest = f32::INFINITY;
        let mut facing = (f32::INFINITY, None);
        for ((center, radius), first) in self.balls.iter().zip((0..).step_by(RUN)) {
            // No sample of the run is nearer than this.
            if center.distance(place) - radius > facing.0 {
                continue;
            }
            let run = &self.samples[first..self.samples.len().min(first + RUN)];
            for (at, sample) in (first as u32..).zip(run) {
                let far = Vec3::from(sample.position).distance(place);
                nearest = nearest.min(far);
                if far < facing.0 && Vec3::from(sample.normal).dot(direction) < 0.0 {
                    facing = (far, Some(at));
                }
            }
        }
        let near = facing.0 <= nearest + 4.0 * self.apart;
        facing.1.filter(|_| near)
    }
}

/// The k-th of some directions that are spread evenly over heights from `low` to 1.
pub(super) fn even(k: usize, count: usize, low: f64) -> DVec3 {
    let height = 1.0 - (1.0 - low) * (k as f64 + 0.5) / count as f64;
    let (sin, cos) = (k as f64 * TAU * 0.618_033_988_749_895).sin_cos();
    let wide = (1.0 - height * height).max(0.0).sqrt();
    DVec3::new(wide * cos, height, wide * sin)
}
