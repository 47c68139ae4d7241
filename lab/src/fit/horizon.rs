//! The circle that stands for a sphere which the horizon cuts.

use super::marquardt::minimise_in;
use super::row;
use sh_reference::horizon::share;
use std::f64::consts::PI;
use std::fmt::Write;

/// Coefficients of each polynomial in u, and their number.
const HEIGHT_POWERS: usize = 3;
const POLYNOMIALS: usize = 3;

/// Heights and distances that the fit sees.
const HEIGHTS: usize = 60;
const DISTANCES: usize = 60;

/// Rounds in which places that err most gain weight (Lawson 1961), towards the least largest error, and steps of each.
const ROUNDS: usize = 120;
const STEPS: usize = 10;

/// Of spheres that hide less of the sky than 1 over this, an error counts in parts of what they hide.
const SMALL: f64 = 12.0;

/// From this sine of the angular radius on, errors of spheres with a u below [`DEEP`] count less, down to a tenth: what a
/// receiver sees of a sphere that is nearly below changes with the root of the distance from it, an edge in the light that
/// nobody needs. For the same reason the divisor is held to this where u is 0 and x is 1.
const NEAR: f64 = 0.8;
const DEEP: f64 = 0.15;
const SOFT: f64 = 0.02;

/// A sphere of radius 1.
struct Case {
    /// (1 + the height of its centre)/2, the square of the sine of its angular radius, and that of the distance of the foot of
    /// its centre.
    u: f64,
    square: f64,
    foot: f64,
    /// The share of the sky that it hides, and what an error of that counts for.
    share: f64,
    counts: f64,
}

impl Case {
    fn new(i: usize) -> Self {
        let turn = PI * (i / DISTANCES) as f64 / (HEIGHTS - 1) as f64;
        let part = (i % DISTANCES) as f64 / (DISTANCES - 1) as f64;
        // Most of them nearly below and nearly above; from touching to a hundred radii, most of them near.
        let tilt = 0.5 * PI * (1.0 + turn.cos());
        let (height, own) = (-tilt.cos(), 1.0 - 1e-6 * 9.9e5_f64.powf(part));
        let u = (0.5 * tilt).sin().powi(2);
        let small = (SMALL * own.powi(3)).min(1.0);
        let soft = if own > NEAR { u / DEEP + 0.1 } else { 1.0 };
        Self {
            u,
            square: own * own,
            foot: (1.0 / (own * own) - height * height).max(0.0),
            share: share(height, 1.0 / own),
            counts: soft.min(1.0) / small,
        }
    }

    /// The share that numbers give: those of the divisor first.
    fn found(&self, x: &[f64]) -> f64 {
        let (divisor, polynomials) = x.split_at(2);
        let rest = 1.0 - self.u;
        let sum = polynomials.rchunks(HEIGHT_POWERS).fold(0.0, |sum, c| {
            let polynomial = c.iter().rev().fold(0.0, |p, c| p * self.u + c);
            sum * self.square + polynomial
        });
        let below =
            (1.0 - self.square) * (1.0 + divisor[0] * self.u) + rest * (SOFT + divisor[1] * self.u);
        let part = rest * sum / below.max(f64::MIN_POSITIVE);
        let radius = (self.u * (1.0 + part)).max(0.0);
        (radius / (self.foot + radius * radius).sqrt().max(f64::MIN_POSITIVE)).powi(3)
    }

    fn error(&self, x: &[f64]) -> f64 {
        self.counts * (self.found(x) - self.share)
    }
}

/// The numbers of the radius, fitted so that a sphere of it that touches the horizon hides [`share`]. It is 0 and 1 at the
/// ends whatever they are.
pub(super) fn text() -> String {
    let mut text = String::from(
        "# The radius of the sphere that stands for one which the horizon cuts, over the sphere's own:\n\
         # u (1 + (1 - u) (p_0 + x p_1 + x^2 p_2) / ((1 - x) (1 + a u) + (1 - u) (b + c u))), u = (1 + height / radius) / 2,\n\
         # x the square of the sine of the sphere's angular radius, p polynomials in u.\n\
         # Written by `gaunt-lab fit`. Columns: power of x, coefficients from the lowest power of u; or `divisor`, a, b, c.\n",
    );
    let cases: Vec<Case> = (0..HEIGHTS * DISTANCES).map(Case::new).collect();
    let mut weights = vec![1.0 / cases.len() as f64; cases.len()];
    let mut x = vec![0.0; 2 + HEIGHT_POWERS * POLYNOMIALS];
    // A divisor above 0.
    x[..2].copy_from_slice(&[-0.9, 0.05]);
    let (mut best, mut fitted) = (f64::INFINITY, x.clone());
    for _ in 0..ROUNDS {
        minimise_in(STEPS, &mut x, &weights, 1, &|x, i, r| {
            r[0] = cases[i].error(x);
        });
        let errors: Vec<f64> = cases.iter().map(|case| case.error(&x).abs()).collect();
        let largest = errors.iter().copied().fold(0.0, f64::max);
        if largest < best {
            (best, fitted) = (largest, x.clone());
        }
        for (weight, error) in weights.iter_mut().zip(&errors) {
            *weight *= (error / largest + 0.02).powf(0.7);
        }
        let sum: f64 = weights.iter().sum();
        weights.iter_mut().for_each(|w| *w /= sum);
    }
    let (mut largest, mut squares) = (0.0_f64, 0.0);
    for case in &cases {
        let off = case.found(&fitted) - case.share;
        largest = largest.max(off.abs());
        squares += off * off / cases.len() as f64;
    }
    let mean = squares.sqrt();
    writeln!(
        text,
        "# largest error of the share that is hidden {largest:.4}, root of its mean square {mean:.4}; over the whole sphere's\n\
         # where that hides less than 1/{SMALL}: {:.4}",
        best * SMALL
    )
    .expect("writing to a string");
    let (divisor, polynomials) = fitted.split_at(2);
    row(&mut text, "divisor", &[divisor[0], SOFT, divisor[1]]);
    for (power, polynomial) in polynomials.chunks(HEIGHT_POWERS).enumerate() {
        row(&mut text, &power.to_string(), polynomial);
    }
    text
}
