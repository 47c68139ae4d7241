//! The logarithm and the exponential of the shadow pass, fitted in the measure of shading.
//!
//! What is minimised is the mean square error of transfer vectors, (g * H(N)) of what blockers leave, over sets of blockers
//! that lie wholly above the receiver's horizon ([`sh_reference::shaded`]): bands count as much as light has in them. The
//! polynomials of the logarithm are free but for one coefficient a band, which a small blocker fixes: it takes away what its
//! circle hides, to the last percent. Blockers of a body share a weight, the one that suits its set best: the fit need not
//! make up for spheres that overlap, which weights are for.

use super::marquardt::{least_squares, minimise_in};
use super::row;
use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;
use sh_codegen::octahedral;
use sh_codegen::sampled::{self, Fineness};
use sh_core::Routines;
use sh_reference::basis::basis;
use sh_reference::cap::blocked;
use sh_reference::shaded::{Kind, Set, sets, transfer};
use std::f64::consts::PI;
use std::fmt::Write;

/// Powers of u = 2 cos θ − 1 behind the constant. More gain nothing, and each is paid for by every receiver and blocker.
const DEGREE: usize = 3;

/// How many sets there are of each kind, and how much they count together.
const KINDS: [(Kind, usize, f64); 10] = [
    (Kind::Separate, 220, 1.0),
    (Kind::Few, 120, 6.0),
    (Kind::Single, 120, 0.6),
    (Kind::Large, 120, 0.8),
    (Kind::Touching, 120, 0.8),
    (Kind::Half, 30, 0.15),
    (Kind::Heavy, 120, 0.45),
    (Kind::Body, 250, 3.0),
    (Kind::Enclosing, 40, 0.05),
    (Kind::Stacked, 60, 0.12),
];

/// How much an error of a band counts: the size of a coefficient of half a sky of 0.35 over 0.1 all around and a spot of 15
/// degrees that is 6 bright, over that of the mean.
const BANDS: [f64; 6] = [1.0, 0.36, 0.27, 0.27, 0.26, 0.25];

/// Ratio vectors divide by the logarithm of circles up to this, in degrees: there it has to be at least a part of what the
/// circle hides.
const RATIOS: std::ops::RangeInclusive<u32> = 4..=34;
const PART: f64 = 0.35;

/// How strongly coefficients are held to 0, and the compression to which value: so weakly that only what the sets hardly
/// tell of is decided by it.
const SMOOTH: f64 = 2e-4;
const COMPRESSION: (f64, f64) = (0.1, 2e-3);

/// How often weights of bodies and polynomials take turns, and steps of each turn.
const ROUNDS: usize = 4;
const STEPS: usize = 12;

/// One set with what it asks.
struct Case<const C: usize> {
    /// Powers of u times sin² θ, summed over the blockers in every coefficient.
    powers: [[f64; C]; DEGREE + 1],
    /// The cosine lobe at the samples, times their weights.
    lobe: Vec<f64>,
    truth: Vec<f64>,
    body: bool,
}

/// The samples that the generated routine takes, for constants that are still moving.
struct Rule<const C: usize> {
    points: Vec<[f64; C]>,
    /// Where they are, and their weights.
    places: Vec<([f64; 3], f64)>,
    /// The lobe's bands.
    lobe: Vec<f64>,
}

impl<const C: usize> Rule<C>
where
    [f64; C]: Routines<f64>,
{
    fn new() -> Self {
        let order = <[f64; C]>::ORDER;
        let points = octahedral::points(sampled::points(order, Fineness::Medium));
        let last = 2 * order - 2;
        // The lobe's value from its bands, whatever the direction: that of a lobe about +Z.
        let lobe = sh_reference::zonal::cosine(last + 1, [0.0, 0.0, 1.0]);
        Self {
            points: points.iter().map(|p| <[f64; C]>::basis(p.0)).collect(),
            places: points,
            lobe: (0..=last).map(|l| lobe[l * l + l]).collect(),
        }
    }

    /// The lobe about a normal at the samples, times their weights.
    fn lobe(&self, normal: [f64; 3]) -> Vec<f64> {
        let at = |(point, weight): &([f64; 3], f64)| {
            let facing: f64 = point.iter().zip(normal).map(|(a, b)| a * b).sum();
            weight * sh_reference::zonal::evaluate(&self.lobe, facing.clamp(-1.0, 1.0))
        };
        self.places.iter().map(at).collect()
    }

    /// [`Routines::transfer`] with the compression β and such a lobe.
    fn transfer(&self, f: &[f64; C], lobe: &[f64], beta: f64) -> [f64; C] {
        let square: f64 = f[1..].iter().map(|f| f * f).sum();
        let factor = 1.0 / (1.0 + beta * square / (4.0 * PI)).sqrt();
        let mut out = [0.0; C];
        for (y, lobe) in self.points.iter().zip(lobe) {
            let x: f64 = f.iter().zip(y).map(|(f, y)| f * y).sum::<f64>() * factor;
            let root = (1.0 + x / 4.0).clamp(0.0, 1.0 + sampled::TRANSFER_BRIGHT / 4.0);
            let value = root.powi(4) * lobe;
            for (out, y) in out.iter_mut().zip(y) {
                *out += value * y;
            }
        }
        out
    }
}

impl<const C: usize> Case<C>
where
    [f64; C]: Routines<f64>,
{
    fn new(kind: Kind, set: &Set, rule: &Rule<C>) -> Self {
        let mut powers = [[0.0; C]; DEGREE + 1];
        for cap in &set.caps {
            let (sin, cos) = cap.angle.sin_cos();
            let y = basis(<[f64; C]>::ORDER, cap.axis);
            let mut value = sin * sin;
            for power in &mut powers {
                for (i, (p, y)) in power.iter_mut().zip(&y).enumerate() {
                    let l = i.isqrt();
                    *p += value * y * (4.0 * PI / (2 * l + 1) as f64).sqrt();
                }
                value *= 2.0 * cos - 1.0;
            }
        }
        Self {
            powers,
            lobe: rule.lobe(set.normal),
            truth: transfer(<[f64; C]>::ORDER, set),
            body: kind == Kind::Body,
        }
    }

    fn log(&self, bands: &[Vec<f64>], weight: f64) -> [f64; C] {
        let mut f = [0.0; C];
        for (i, f) in f.iter_mut().enumerate() {
            let terms = self.powers.iter().zip(&bands[i.isqrt()]);
            *f = weight * terms.map(|(p, c)| p[i] * c).sum::<f64>();
        }
        f
    }

    fn error(&self, rule: &Rule<C>, bands: &[Vec<f64>], weight: f64, beta: f64, r: &mut [f64]) {
        let found = rule.transfer(&self.log(bands, weight), &self.lobe, beta);
        for (i, (r, (found, truth))) in r.iter_mut().zip(found.iter().zip(&self.truth)).enumerate()
        {
            *r = (found - truth) * BANDS[i.isqrt()];
        }
    }

    /// The weight that suits a body best, from one that nearly does.
    fn weight(&self, rule: &Rule<C>, bands: &[Vec<f64>], beta: f64, mut weight: f64) -> f64 {
        const STEP: f64 = 1e-3;
        let (mut now, mut moved) = ([0.0; C], [0.0; C]);
        for _ in 0..4 {
            self.error(rule, bands, weight, beta, &mut now);
            self.error(rule, bands, weight + STEP, beta, &mut moved);
            let slopes = now.iter().zip(&moved).map(|(a, b)| (b - a) / STEP);
            let (mut down, mut across) = (0.0, 1e-4);
            for (slope, error) in slopes.zip(&now) {
                down += slope * error;
                across += slope * slope;
            }
            weight = (weight - (down / across).clamp(-0.2, 0.2)).clamp(0.02, 1.5);
        }
        weight
    }
}

/// Each band's polynomial: the free powers, and before them the constant with which a small circle hides what it does.
fn bands(order: usize, free: &[f64]) -> Vec<Vec<f64>> {
    let band = |(l, free): (usize, &[f64])| {
        let hidden = -(PI * (2 * l + 1) as f64).sqrt() / 2.0;
        let rest: f64 = free.iter().sum();
        [&[hidden - rest], free].concat()
    };
    free.chunks(DEGREE)
        .take(order)
        .enumerate()
        .map(band)
        .collect()
}

/// The polynomials that the fit starts from: a logarithm that is what the circle hides.
fn start(order: usize) -> Vec<f64> {
    let angles: Vec<f64> = (1..=70).map(|d| f64::from(d).to_radians()).collect();
    let hidden: Vec<Vec<f64>> = angles.iter().map(|a| blocked(order, *a)).collect();
    let design = DMatrix::from_fn(angles.len(), DEGREE + 1, |i, k| {
        (2.0 * angles[i].cos() - 1.0).powi(k as i32)
    });
    let band = |l: usize| {
        let values = angles.iter().zip(&hidden);
        let values = values.map(|(angle, hidden)| -1.5 * hidden[l] / angle.sin().powi(2));
        let target = DVector::from_iterator(angles.len(), values);
        least_squares(design.clone(), &target)[1..].to_vec()
    };
    (0..order).flat_map(band).collect()
}

/// The rows of an order.
pub(super) fn fit<const C: usize>(text: &mut String)
where
    [f64; C]: Routines<f64>,
{
    let n = <[f64; C]>::ORDER;
    let rule = Rule::<C>::new();
    let (mut cases, mut weights) = (Vec::new(), Vec::new());
    for (kind, count, counts) in KINDS {
        let made = sets(kind, 5, count).into_par_iter();
        cases.par_extend(made.map(|set| Case::<C>::new(kind, &set, &rule)));
        weights.extend(vec![counts / count as f64; count]);
    }
    let sum: f64 = weights.iter().sum();
    weights.iter_mut().for_each(|w| *w /= sum);
    // One more for each angle that ratio vectors ask for.
    let angles: Vec<f64> = RATIOS.map(|d| f64::from(d).to_radians()).collect();
    let hidden: Vec<Vec<f64>> = angles.iter().map(|a| blocked(n, *a)).collect();
    weights.extend(vec![0.3 / angles.len() as f64; angles.len()]);
    // And for each power, and the compression, which are held to what is usual where sets do not tell.
    weights.extend(vec![1.0; DEGREE + 1]);

    let polynomials = n * DEGREE;
    let mut x = start(n);
    x.push(COMPRESSION.0.ln());
    let mut of_bodies = vec![0.4; cases.len()];
    let mut error = 0.0;
    for _ in 0..ROUNDS {
        let (own, beta) = (bands(n, &x[..polynomials]), x[polynomials].exp());
        of_bodies = cases
            .par_iter()
            .zip(&of_bodies)
            .map(|(case, weight)| match case.body {
                true => case.weight(&rule, &own, beta, *weight),
                false => 1.0,
            })
            .collect();
        error = minimise_in(STEPS, &mut x, &weights, C, &|x, i, r| {
            let (own, beta) = (bands(n, &x[..polynomials]), x[polynomials].exp());
            match cases.get(i) {
                Some(case) => case.error(&rule, &own, of_bodies[i], beta, r),
                None if i >= cases.len() + angles.len() => {
                    let power = i - cases.len() - angles.len();
                    r.fill(0.0);
                    if power == DEGREE {
                        r[0] = COMPRESSION.1 * (x[polynomials] - COMPRESSION.0.ln());
                    } else {
                        for (r, band) in r.iter_mut().zip(x[..polynomials].chunks(DEGREE)) {
                            *r = SMOOTH * band[power];
                        }
                    }
                }
                None => {
                    let angle = angles[i - cases.len()];
                    let u = 2.0 * angle.cos() - 1.0;
                    for (l, r) in r.iter_mut().enumerate() {
                        *r = own.get(l).map_or(0.0, |band| {
                            let log = band.iter().rev().fold(0.0, |p, c| p * u + c);
                            let least = PART * hidden[i - cases.len()][l] / angle.sin().powi(2);
                            (log + least).max(0.0)
                        });
                    }
                }
            }
        })
        .sqrt();
    }
    let own = bands(n, &x[..polynomials]);
    writeln!(text, "# order {n}: root of the mean square {error:.4}").expect("writing to a string");
    row(text, &format!("compression {n}"), &[x[polynomials].exp()]);
    for band in &own {
        row(text, &format!("log {n}"), band);
    }
}
