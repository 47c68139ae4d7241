//! What is seen of a body from outside, if its irradiance is one of the functions of its basis (Iwasaki et al. 2007,
//! section 4.3: "basis radiance"), as a series in place of the paper's 24,576 sample points:
//!
//! ```text
//! S(p) ≈ Σ_k Σ_q c[k, q] (R/r)^(2 + k) y_q(direction of p)        k < 3, q < 64
//! ```
//!
//! with r the distance of p from the middle of the body, R that of its farthest point, and c[k, q] an SH vector of order 4. It is
//! fitted to rays at places from 1.15 to 8 R, evenly in R/r; farther away its first terms are what there is. Nearer, where
//! the ball around the body cuts the body, a series like this does not hold.

use super::harmonics::harmonics;
use super::samples::{Lookup, even};
use crate::rays::Rays;
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use sh_core::Routines;
use sh_scene::{IrradianceBasis, Material, Mesh};
use std::f64::consts::TAU;

/// SH order of what is seen.
const ORDER: usize = 4;
const SEEN: usize = ORDER * ORDER;

/// SH order of places, and powers of R/r.
const PLACE: usize = 8;
const POWERS: usize = 3;
const TERMS: usize = PLACE * PLACE * POWERS;

/// Places that the series is fitted at, and rays from each.
const PLACES: usize = 2400;
const RAYS: usize = 1024;

/// Between which distances these lie, over the body's radius.
const RANGE: [f64; 2] = [1.15, 8.0];

/// What is seen of a body from outside of it, as SH vectors of order 4 of radiance, for each function of its basis.
///
/// ```
/// use sh_bake::{IrradianceField, irradiance_basis, shapes};
/// use sh_scene::Material;
/// let (ball, gray) = (shapes::ball(1.0, 3), Material::diffuse([0.5; 3]));
/// let parts = [(&ball, &gray)];
/// let basis = irradiance_basis(&parts, 4, &|_| {}).unwrap();
/// let field = IrradianceField::bake(&parts, &basis, &|_| {}).unwrap();
/// // In even light of radiance 1, from far above: half of what a disc of that size would give.
/// let seen = field.lit(&[[1.0; 3]]).seen([0.0, 5.0, 0.0]);
/// let disc = std::f32::consts::TAU * (1.0 - (1.0_f32 - 0.04).sqrt()) * 0.2820948;
/// assert!((seen[0][0] / (0.5 * disc) - 1.0).abs() < 0.03);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct IrradianceField {
    pub(super) center: Vec3,
    pub(super) radius: f32,
    /// For each function, channel and term an SH vector.
    series: Vec<[f32; SEEN]>,
}

/// What is seen of a body that is lit in one way: the sum of its functions' fields by their weights.
#[derive(Clone, Debug, PartialEq)]
pub struct LitField {
    center: Vec3,
    radius: f32,
    /// For each channel and term an SH vector.
    series: Vec<[f32; SEEN]>,
}

impl IrradianceField {
    /// Nearer to the middle than so many radii of the body, the field is not what is seen.
    pub const NEAREST: f32 = RANGE[0] as f32;

    /// Finds the field of a body, given as [`irradiance_basis`](crate::irradiance_basis) was; none for one without a triangle of any extent.
    /// Takes some seconds on two cores. Telling `progress` the part that is done, 0 to 1, from several threads.
    pub fn bake(
        parts: &[(&Mesh, &Material)],
        basis: &IrradianceBasis,
        progress: &(dyn Fn(f32) + Sync),
    ) -> Option<Self> {
        let rays = Rays::of(parts)?;
        let done = std::sync::atomic::AtomicUsize::new(0);
        let lookup = Lookup::new(basis.samples(), &rays);
        let look = |place: DVec3| {
            let seen = look(place, &rays, basis, &lookup);
            let done = 1 + done.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
            progress(0.9 * done as f32 / PLACES as f32);
            seen
        };
        let places: Vec<DVec3> = (0..PLACES).map(|k| place(k, &rays)).collect();
        let seen: Vec<Vec<[f64; SEEN]>> = places.par_iter().map(|p| look(*p)).collect();
        let rows: Vec<Vec<f64>> = places
            .iter()
            .map(|p| terms(*p - rays.center, rays.reach))
            .collect();
        let series = fitted(&rows, &seen, basis.count() * 3)?;
        progress(1.0);
        Some(Self {
            center: rays.center.as_vec3(),
            radius: rays.reach as f32,
            series,
        })
    }

    /// What is seen of the body where its irradiance has these weights ([`IrradianceBasis::weights`]), as what albedo 1
    /// reflects.
    pub fn lit(&self, weights: &[[f32; 3]]) -> LitField {
        let mut series = vec![[0.0; SEEN]; 3 * TERMS];
        for (function, weight) in self.series.chunks_exact(3 * TERMS).zip(weights) {
            let channels = function
                .chunks_exact(TERMS)
                .zip(series.chunks_exact_mut(TERMS));
            for ((function, sum), weight) in channels.zip(weight) {
                for (function, sum) in function.iter().zip(sum) {
                    for (function, sum) in function.iter().zip(sum) {
                        *sum += weight * function;
                    }
                }
            }
        }
        LitField {
            center: self.center,
            radius: self.radius,
            series,
        }
    }

    /// Its bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.series[..])
    }
}

impl LitField {
    /// Radiance that arrives at a place in the body's space, as a function of the direction that it comes from: an SH vector
    /// of order 4 for each channel. Nothing where the place is as near as [`IrradianceField::NEAREST`].
    pub fn seen(&self, place: [f32; 3]) -> [[f32; SEEN]; 3] {
        let mut seen = [[0.0; SEEN]; 3];
        let from = (Vec3::from(place) - self.center).as_dvec3();
        let near = self.radius * IrradianceField::NEAREST;
        // Nor where it is no place.
        if from.is_nan() || from.length() < f64::from(near) {
            return seen;
        }
        let terms = terms(from, f64::from(self.radius));
        for (seen, series) in seen.iter_mut().zip(self.series.chunks_exact(TERMS)) {
            for (term, vector) in terms.iter().zip(series) {
                for (seen, c) in seen.iter_mut().zip(vector) {
                    *seen += *term as f32 * c;
                }
            }
        }
        seen
    }
}

/// (R/r)^(2 + k) y_q, power by power.
fn terms(from: DVec3, radius: f64) -> Vec<f64> {
    let far = from.length();
    let mut all = vec![0.0; TERMS];
    let (first, rest) = all.split_at_mut(PLACE * PLACE);
    harmonics((from / far).to_array(), PLACE, first);
    let ratio = radius / far;
    first.iter_mut().for_each(|y| *y *= ratio * ratio);
    let mut before = first;
    for next in rest.chunks_exact_mut(PLACE * PLACE) {
        for (next, before) in next.iter_mut().zip(&*before) {
            *next = ratio * before;
        }
        before = next;
    }
    all
}

/// The k-th place, evenly in direction and in R/r.
fn place(k: usize, rays: &Rays) -> DVec3 {
    // Another irrational number than that of the turn.
    let part = (k as f64 * 0.754_877_666_246_693).fract();
    let [near, far] = RANGE.map(f64::recip);
    let inverse = far + (near - far) * part;
    rays.center + even(k, PLACES, -1.0) * (rays.reach / inverse)
}

/// What is seen from a place: for each function and channel an SH vector.
fn look(from: DVec3, rays: &Rays, basis: &IrradianceBasis, lookup: &Lookup) -> Vec<[f64; SEEN]> {
    let samples = basis.samples();
    let mut seen = vec![[0.0; SEEN]; basis.count() * 3];
    let to = rays.center - from;
    let axis = to.normalize();
    let (side, other) = axis.any_orthonormal_pair();
    // Only the cone around the body.
    let lowest = (1.0 - (rays.reach / to.length()).powi(2)).max(0.0).sqrt();
    let share = TAU * (1.0 - lowest) / RAYS as f64;
    for k in 0..RAYS {
        let around = even(k, RAYS, lowest);
        let direction = axis * around.y + side * around.x + other * around.z;
        let met = rays.first(from, direction);
        let Some(at) = met.and_then(|place| lookup.nearest(place, direction)) else {
            continue;
        };
        let y = <[f64; SEEN]>::basis(direction.to_array()).map(|y| y * share);
        let at = at as usize;
        for (function, seen) in seen.chunks_exact_mut(3).enumerate() {
            let value = f64::from(basis.function(function)[at]);
            for (seen, albedo) in seen.iter_mut().zip(samples[at].albedo) {
                let value = value * f64::from(albedo);
                for (seen, y) in seen.iter_mut().zip(y) {
                    *seen += value * y;
                }
            }
        }
    }
    seen
}

/// The series of each of `count` fields, by least squares of errors over (R/r)²: of what share of the field they are.
fn fitted(rows: &[Vec<f64>], seen: &[Vec<[f64; SEEN]>], count: usize) -> Option<Vec<[f32; SEEN]>> {
    // The first term of the first power is (R/r)² y₀.
    let scales: Vec<f64> = rows.iter().map(|row| 1.0 / row[0]).collect();
    let weighted: Vec<Vec<f64>> = (rows.iter().zip(&scales))
        .map(|(row, scale)| row.iter().map(|x| x * scale).collect())
        .collect();
    let square: Vec<Vec<f64>> = (0..TERMS)
        .into_par_iter()
        .map(|i| {
            let mut row = vec![0.0; i + 1];
            for terms in &weighted {
                for (sum, term) in row.iter_mut().zip(terms) {
                    *sum += terms[i] * term;
                }
            }
            row
        })
        .collect();
    let lower = cholesky(square)?;
    let field = |index: usize| {
        let mut sides = vec![[0.0; SEEN]; TERMS];
        for ((terms, seen), scale) in weighted.iter().zip(seen).zip(&scales) {
            for (side, term) in sides.iter_mut().zip(terms) {
                for (side, seen) in side.iter_mut().zip(seen[index]) {
                    *side += term * seen * scale;
                }
            }
        }
        solve(&lower, &mut sides);
        sides.into_iter().map(|vector| vector.map(|x| x as f32))
    };
    let fields: Vec<Vec<[f32; SEEN]>> = (0..count)
        .into_par_iter()
        .map(|i| field(i).collect())
        .collect();
    Some(fields.concat())
}

/// The lower triangle whose product with its transpose is a symmetric matrix, given by its own; a little is added to the
/// diagonal, for terms that the places do not tell apart. None where the matrix is no number.
fn cholesky(mut rows: Vec<Vec<f64>>) -> Option<Vec<Vec<f64>>> {
    let trace: f64 = rows.iter().map(|row| row[row.len() - 1]).sum();
    let little = 1e-10 * trace / rows.len() as f64;
    for i in 0..rows.len() {
        let (before, rest) = rows.split_at_mut(i);
        let row = &mut rest[0];
        row[i] += little;
        for j in 0..i {
            let known: f64 = row[..j].iter().zip(&before[j]).map(|(a, b)| a * b).sum();
            row[j] = (row[j] - known) / before[j][j];
        }
        let known: f64 = row[..i].iter().map(|x| x * x).sum();
        let left = row[i] - known;
        if left.is_nan() || left <= 0.0 {
            return None;
        }
        row[i] = left.sqrt();
    }
    Some(rows)
}

/// Solves for all sides at once.
fn solve(lower: &[Vec<f64>], sides: &mut [[f64; SEEN]]) {
    for (i, row) in lower.iter().enumerate() {
        let (before, rest) = sides.split_at_mut(i);
        for (known, factor) in before.iter().zip(row) {
            for (side, known) in rest[0].iter_mut().zip(known) {
                *side -= factor * known;
            }
        }
        rest[0].iter_mut().for_each(|x| *x /= row[i]);
    }
    for (i, row) in lower.iter().enumerate().rev() {
        let (rest, after) = sides.split_at_mut(i + 1);
        for (known, below) in after.iter().zip(&lower[i + 1..]) {
            for (side, known) in rest[i].iter_mut().zip(known) {
                *side -= below[i] * known;
            }
        }
        rest[i].iter_mut().for_each(|x| *x /= row[i]);
    }
}

/// The field itself, as rays find it: what the series is held against.
#[cfg(test)]
pub(super) fn by_rays(
    parts: &[(&Mesh, &Material)],
    basis: &IrradianceBasis,
    weights: &[[f32; 3]],
    place: [f32; 3],
) -> [[f64; SEEN]; 3] {
    let rays = Rays::of(parts).expect("it has triangles");
    let lookup = Lookup::new(basis.samples(), &rays);
    let all = look(Vec3::from(place).as_dvec3(), &rays, basis, &lookup);
    let mut sum = [[0.0; SEEN]; 3];
    for (fields, weight) in all.chunks_exact(3).zip(weights) {
        for ((sum, field), weight) in sum.iter_mut().zip(fields).zip(weight) {
            for (sum, x) in sum.iter_mut().zip(field) {
                *sum += f64::from(*weight) * x;
            }
        }
    }
    sum
}
