//! Weights by least squares on what spheres do to light.
//!
//! A receiver's transfer vector T is that of the sum of its blockers' logarithms, T(Σ w_s f_s) by
//! [`Routines::transfer`], and should be that of the mesh. Gauss's and Newton's method: T is taken as linear about the weights
//! found so far, and the weights that make its squared error least, none below 0, are the next ones. What light there will be
//! is not known; bands count as they do in skies with a bright spot. A weak pull holds weights that no receiver tells of.

use super::places::{Place, even, lobe};
use glam::DVec3;
use rayon::prelude::*;
use sh_core::Routines;
use sh_core::seen::Seen;
use sh_scene::Sphere;

/// Order 4.
type Vector = [f64; 16];

/// Rays of a receiver.
const RAYS: usize = 768;

/// A receiver that sees less than this is inside of the body, where nobody looks.
const OPEN: f64 = 0.005;

/// How much an error of each band counts: the mean size of a coefficient in half a sky of 0.35 over 0.1 all around, and a
/// spot of 15 degrees that is 6 bright.
const BANDS: [f64; 4] = [1.0, 0.36, 0.27, 0.27];

/// What weights are pulled to, and how strongly, for each thousand receivers.
const USUAL: f64 = 0.3;
const PULL: f64 = 3e-3;

/// Steps at most, and how much of each is taken; one that changes weights by less is the last.
const STEPS: usize = 16;
const PART: f64 = 0.7;
const SETTLED: f64 = 2e-3;

/// Sweeps over all weights until those of a step are found.
const SWEEPS: usize = 200;

/// Receivers whose equations are summed up together.
const BLOCK: usize = 32;

/// More spheres than this share weights with their neighbours.
const MOST: usize = 512;

/// What the body does to a receiver, and what its spheres do.
pub(super) struct Receiver {
    normal: [f64; 3],
    truth: Vector,
    /// The spheres that count here, with their logarithms on the scale of [`Routines::accumulate_blocker`].
    logs: Vec<(u32, Vector)>,
}

impl Receiver {
    /// None inside of the body.
    pub(super) fn new(
        index: usize,
        place: &Place,
        spheres: &[Sphere],
        blocked: &(dyn Fn(DVec3, DVec3) -> bool + Sync),
    ) -> Option<Self> {
        let normal = place.normal.to_array();
        let [u, v, ..] = even::<5>(7 * index + 3);
        let (mut hidden, mut count) = ([0.0; 16], 0);
        for direction in lobe(place.normal, RAYS, [u, v]) {
            if blocked(place.position, direction) {
                count += 1;
                let y = Vector::basis(direction.to_array());
                for (hidden, y) in hidden.iter_mut().zip(y) {
                    *hidden += y / RAYS as f64;
                }
            }
        }
        if f64::from(count) > (1.0 - OPEN) * RAYS as f64 {
            return None;
        }
        let mut truth = Vector::cosine(normal);
        for (truth, hidden) in truth.iter_mut().zip(hidden) {
            *truth -= hidden;
        }
        let own = f64::from(u8::from(place.own));
        let own_log = |(s, sphere): (usize, &Sphere)| {
            let center = DVec3::from(sphere.center.map(f64::from)) - place.position;
            let radius = f64::from(sphere.radius);
            let seen = Seen::above(center.to_array(), normal, radius, own);
            (seen.sine > 0.0).then(|| (s as u32, log(&seen)))
        };
        Some(Self {
            normal,
            truth,
            logs: spheres.iter().enumerate().filter_map(own_log).collect(),
        })
    }

    /// The transfer's error with these weights, and what it changes by with each weight.
    fn linear(&self, weights: &[f64], of: &[u32]) -> (Vector, Vec<(u32, Vector)>) {
        const STEP: f64 = 1e-4;
        let mut sum = [0.0; 16];
        for (s, log) in &self.logs {
            add(&mut sum, weights[of[*s as usize] as usize], log);
        }
        let now = transfer(&sum, self.normal);
        let mut slopes: Vec<(u32, Vector)> = Vec::new();
        for (s, log) in &self.logs {
            let mut moved = sum;
            add(&mut moved, STEP, log);
            let mut slope = transfer(&moved, self.normal);
            for (i, (slope, now)) in slope.iter_mut().zip(now).enumerate() {
                *slope = (*slope - now) / STEP * BANDS[i.isqrt()];
            }
            slopes.push((of[*s as usize], slope));
        }
        let mut error = now;
        for (i, (error, truth)) in error.iter_mut().zip(self.truth).enumerate() {
            *error = (*error - truth) * BANDS[i.isqrt()];
        }
        (error, slopes)
    }
}

/// The transfer behind a sum of logarithms. (Some thousand operations, compiled once.)
#[inline(never)]
pub(crate) fn transfer(sum: &Vector, normal: [f64; 3]) -> Vector {
    sum.accumulated_log().transfer(normal)
}

/// The logarithm of a sphere of weight 1.
#[inline(never)]
pub(crate) fn log(seen: &Seen<f64>) -> Vector {
    [0.0; 16].accumulate_blocker(seen.sine, seen.cosine, seen.direction, [1.0; 4])
}

fn add(sum: &mut Vector, weight: f64, log: &Vector) {
    for (sum, log) in sum.iter_mut().zip(log) {
        *sum += weight * log;
    }
}

/// The weights of `spheres`. Without receivers they are 1.
pub(super) fn solve(receivers: &[Receiver], spheres: &[Sphere]) -> Vec<f32> {
    if receivers.is_empty() {
        return vec![1.0; spheres.len()];
    }
    let of = groups(spheres, MOST);
    let shared = of.iter().max().map_or(0, |most| *most as usize + 1);
    let pull = PULL * receivers.len() as f64 / 1000.0;
    let mut weights = vec![USUAL; shared];
    for _ in 0..STEPS {
        let (matrix, slope) = equations(receivers, &weights, &of);
        let next = least(&matrix, &slope, &weights, pull);
        let mut change = 0.0_f64;
        for (weight, next) in weights.iter_mut().zip(next) {
            let step = PART * (next - *weight);
            change = change.max(step.abs());
            *weight += step;
        }
        if change < SETTLED {
            break;
        }
    }
    of.iter().map(|&w| weights[w as usize] as f32).collect()
}

/// Which weight each sphere has: one of its own, or, where there are more than `most`, one with its neighbours.
fn groups(spheres: &[Sphere], most: usize) -> Vec<u32> {
    let mut parts: Vec<Vec<usize>> = vec![(0..spheres.len()).collect()];
    while parts.len() < most {
        let Some((at, _)) = (parts.iter().enumerate())
            .filter(|(_, part)| part.len() > 1)
            .max_by_key(|(_, part)| part.len())
        else {
            break;
        };
        // The largest in two, across its longest side.
        let mut part = std::mem::take(&mut parts[at]);
        let along = |axis: usize| {
            let places = || part.iter().map(|&s| spheres[s].center[axis]);
            places().fold(f32::MIN, f32::max) - places().fold(f32::MAX, f32::min)
        };
        let axis = (0..3).max_by(|a, b| along(*a).total_cmp(&along(*b)));
        let axis = axis.unwrap_or_default();
        part.sort_by(|a, b| spheres[*a].center[axis].total_cmp(&spheres[*b].center[axis]));
        let rest = part.split_off(part.len() / 2);
        parts[at] = part;
        parts.push(rest);
    }
    let mut of = vec![0; spheres.len()];
    for (group, part) in (0..).zip(&parts) {
        part.iter().for_each(|&s| of[s] = group);
    }
    of
}

/// Σ JᵀJ and Σ Jᵀr over the receivers, summed in a fixed order.
fn equations(receivers: &[Receiver], weights: &[f64], of: &[u32]) -> (Vec<f64>, Vec<f64>) {
    let n = weights.len();
    let block = |receivers: &[Receiver]| {
        let (mut matrix, mut slope) = (vec![0.0; n * n], vec![0.0; n]);
        for receiver in receivers {
            let (error, slopes) = receiver.linear(weights, of);
            for (a, first) in &slopes {
                slope[*a as usize] += dot(first, &error);
                for (b, second) in &slopes {
                    matrix[*a as usize * n + *b as usize] += dot(first, second);
                }
            }
        }
        (matrix, slope)
    };
    let blocks: Vec<_> = receivers.par_chunks(BLOCK).map(block).collect();
    let mut all = (vec![0.0; n * n], vec![0.0; n]);
    for (matrix, slope) in blocks {
        all.0.iter_mut().zip(matrix).for_each(|(sum, m)| *sum += m);
        all.1.iter_mut().zip(slope).for_each(|(sum, s)| *sum += s);
    }
    all
}

fn dot(a: &Vector, b: &Vector) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The weights w ≥ 0 for which |r + J (w − now)|² + pull |w − usual|² is least: one after another, as long as that lowers it
/// (Franc, Hlaváč and Navara 2005, "Sequential coordinate-wise algorithm for the non-negative least squares problem").
fn least(matrix: &[f64], slope: &[f64], now: &[f64], pull: f64) -> Vec<f64> {
    let n = now.len();
    let mut weights = now.to_vec();
    // Half of the gradient there.
    let mut gradient: Vec<f64> = slope.to_vec();
    for (gradient, weight) in gradient.iter_mut().zip(&weights) {
        *gradient += pull * (weight - USUAL);
    }
    for _ in 0..SWEEPS {
        let mut moved = 0.0_f64;
        for k in 0..n {
            let row = &matrix[k * n..(k + 1) * n];
            let next = (weights[k] - gradient[k] / (row[k] + pull)).max(0.0);
            let step = next - weights[k];
            if step != 0.0 {
                weights[k] = next;
                moved = moved.max(step.abs());
                for (gradient, m) in gradient.iter_mut().zip(row) {
                    *gradient += m * step;
                }
                gradient[k] += pull * step;
            }
        }
        if moved < 1e-5 {
            break;
        }
    }
    weights
}
