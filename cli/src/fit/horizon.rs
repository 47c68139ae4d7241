//! The circle that stands for a sphere which the horizon cuts.

use super::marquardt::minimise_in;
use super::row;
use sh_reference::horizon::share;
use std::f64::consts::PI;
use std::fmt::Write;

/// Powers of u, and of the square of the sine.
const HEIGHT_POWERS: usize = 4;
const POWERS: [i32; 3] = [0, 1, 8];

/// Heights and distances that the fit sees.
const HEIGHTS: usize = 60;
const DISTANCES: usize = 60;

/// Rounds in which places that err most gain weight (Lawson 1961), towards the least largest error, and steps of each.
const ROUNDS: usize = 120;
const STEPS: usize = 10;

/// A sphere of radius 1.
struct Case {
    /// (1 + the height of its centre)/2, the square of the sine of its angular radius, and that of the distance of the foot of
    /// its centre.
    u: f64,
    square: f64,
    foot: f64,
    /// The sine that stands for it.
    sine: f64,
    /// What an error counts for: that of small spheres in parts of them, that of large ones in parts of the sky.
    counts: f64,
}

impl Case {
    fn new(i: usize) -> Self {
        let turn = PI * (i / DISTANCES) as f64 / (HEIGHTS - 1) as f64;
        let part = (i % DISTANCES) as f64 / (DISTANCES - 1) as f64;
        // From touching to a hundred radii, most of them near.
        let (height, own) = (turn.cos(), 1.0 - 1e-4 * 9900.0_f64.powf(part));
        let sine = share(height, 1.0 / own).cbrt();
        Self {
            u: ((1.0 + height) / 2.0).max(0.0),
            square: own * own,
            foot: (1.0 / (own * own) - height * height).max(0.0),
            sine,
            counts: (0.6 / own.sqrt()).max(1.2 * sine * sine),
        }
    }

    /// The sine that coefficients give.
    fn found(&self, x: &[f64]) -> f64 {
        let terms = x.chunks(HEIGHT_POWERS).zip(POWERS);
        let sum: f64 = terms
            .map(|(c, power)| {
                let polynomial = c.iter().rev().fold(0.0, |p, c| p * self.u + c);
                polynomial * self.square.powi(power)
            })
            .sum();
        let radius = (self.u * (1.0 + (1.0 - self.u) * sum)).max(0.0);
        radius / (self.foot + radius * radius).sqrt().max(f64::MIN_POSITIVE)
    }
}

/// The polynomials of `u (1 + (1 − u) Σ x^k p_k(u))`, fitted so that the sphere of that radius has the sine
/// [`share`]^(1/3): 0 and 1 at the ends whatever the coefficients.
pub(super) fn text() -> String {
    let mut text = String::from(
        "# The radius of the sphere that stands for one which the horizon cuts, over the sphere's own:\n\
         # u (1 + (1 - u) (p_0 + x p_1 + x^8 p_8)), u = (1 + height / radius) / 2, x the square of the sine of the sphere's\n\
         # angular radius, p polynomials in u.\n\
         # Written by `gaunt fit`. Columns: power of x, coefficients from the lowest power of u.\n",
    );
    let cases: Vec<Case> = (0..HEIGHTS * DISTANCES).map(Case::new).collect();
    let mut weights = vec![1.0 / cases.len() as f64; cases.len()];
    let mut x = vec![0.0; HEIGHT_POWERS * POWERS.len()];
    let (mut best, mut fitted) = (f64::INFINITY, x.clone());
    for _ in 0..ROUNDS {
        minimise_in(STEPS, &mut x, &weights, 1, &|x, i, r| {
            r[0] = cases[i].counts * (cases[i].found(x) - cases[i].sine);
        });
        let error = |case: &Case| case.counts * (case.found(&x) - case.sine).abs();
        let errors: Vec<f64> = cases.iter().map(error).collect();
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
    let (mut sine, mut hidden, mut squares) = (0.0_f64, 0.0_f64, 0.0);
    for case in &cases {
        let found = case.found(&fitted);
        let off = found.powi(3) - case.sine.powi(3);
        sine = sine.max((found - case.sine).abs());
        hidden = hidden.max(off.abs());
        squares += off * off / cases.len() as f64;
    }
    let mean = squares.sqrt();
    writeln!(
        text,
        "# largest error of the sine {sine:.4}, of the share that is hidden {hidden:.4}, root of its mean square {mean:.4}"
    )
    .expect("writing to a string");
    for (power, polynomial) in POWERS.iter().zip(fitted.chunks(HEIGHT_POWERS)) {
        row(&mut text, &power.to_string(), polynomial);
    }
    text
}
