//! Cap logarithms fitted to an exponential, against true visibilities.
//!
//! What is minimised is the mean square of ‖g − V‖/√4π, V being the projected visibility of a set of blockers
//! and g the exponential of the sum of their logarithms. The polynomials of the logarithm are free, and what the
//! exponential has of its own.

use super::marquardt::minimise;
use super::sets::{Sets, training};
use super::{Texts, row};
use sh_codegen::octahedral;
use sh_codegen::sampled::{self, Fineness};
use sh_core::exp::{self, Outlined};
use sh_core::log::Logarithm;
use sh_core::{ROOT_FOUR_PI, Routines};
use sh_reference::visibility::Cap;
use std::f64::consts::PI;
use std::fmt::Write;

/// Degree of the saturating exponential's logarithm. Higher ones gain nothing, and every power is paid for by
/// every receiver and blocker.
const SATURATING_DEGREE: usize = 4;

/// Powers of u = 2 cos θ − 1 times sin² θ, summed over the blockers of a set in every coefficient: a log vector
/// is linear in the polynomials' coefficients.
struct Powers<const C: usize>(Vec<[f64; C]>);

impl<const C: usize> Powers<C>
where
    [f64; C]: Routines<f64>,
{
    fn new(caps: &[Cap], degree: usize) -> Self {
        let mut powers = vec![[0.0; C]; degree + 1];
        for cap in caps {
            let (sin, cos) = cap.angle.sin_cos();
            let y = <[f64; C]>::basis(cap.axis);
            let mut value = sin * sin;
            for power in &mut powers {
                for (i, (p, y)) in power.iter_mut().zip(y).enumerate() {
                    let l = i.isqrt();
                    *p += value * y * (4.0 * PI / (2 * l + 1) as f64).sqrt();
                }
                value *= 2.0 * cos - 1.0;
            }
        }
        Self(powers)
    }

    /// The log vector for polynomials given band by band.
    fn log(&self, coefficients: &[f64]) -> [f64; C] {
        let mut f = [0.0; C];
        for (i, f) in f.iter_mut().enumerate() {
            let band = &coefficients[i.isqrt() * self.0.len()..];
            *f = self.0.iter().zip(band).map(|(p, c)| p[i] * c).sum();
        }
        f
    }
}

/// An exponential of a log vector, with parameters of its own.
type Exponential<'a, const C: usize> = &'a (dyn Fn(&[f64; C], &[f64]) -> [f64; C] + Sync);

/// Fits polynomials of `degree` and the parameters behind them, from `x`; gives back the root of the mean square.
fn run<const C: usize>(
    sets: &Sets,
    degree: usize,
    x: &mut [f64],
    exponential: Exponential<C>,
) -> f64
where
    [f64; C]: Routines<f64>,
{
    let powers: Vec<Powers<C>> = sets
        .caps
        .iter()
        .map(|caps| Powers::new(caps, degree))
        .collect();
    let polynomials = <[f64; C]>::ORDER * (degree + 1);
    minimise(x, &sets.weights, C, &|x, i, r| {
        let (log, own) = x.split_at(polynomials);
        let g = exponential(&powers[i].log(log), own);
        for ((r, g), truth) in r.iter_mut().zip(g).zip(&sets.truth[i]) {
            *r = (g - truth) / ROOT_FOUR_PI;
        }
    })
    .sqrt()
}

/// Samples, a function of each, and back: as the generated routines do, for parameters that are still moving.
struct Rule<const C: usize> {
    points: Vec<([f64; C], f64)>,
}

impl<const C: usize> Rule<C>
where
    [f64; C]: Routines<f64>,
{
    fn new() -> Self {
        let count = sampled::points(<[f64; C]>::ORDER, Fineness::Medium);
        let points = octahedral::points(count)
            .into_iter()
            .map(|(point, weight)| (<[f64; C]>::basis(point), weight))
            .collect();
        Self { points }
    }

    /// The saturating exponential with parameters ln β and the gains of bands 1 and up.
    fn saturating(&self, f: &[f64; C], own: &[f64]) -> [f64; C] {
        let square: f64 = f[1..].iter().map(|f| f * f).sum();
        let factor = 1.0 / (1.0 + own[0].exp() * square / (4.0 * PI)).sqrt();
        let mut g = [0.0; C];
        for (y, weight) in &self.points {
            let t = (f.dot(y) * factor).clamp(sampled::DARK, sampled::BRIGHT);
            let value = ((1.0 + t) * (1.0 - sampled::BEND * t)).powi(2);
            for (g, y) in g.iter_mut().zip(y) {
                *g += weight * value * y;
            }
        }
        for (i, g) in g.iter_mut().enumerate().skip(1) {
            *g *= own[i.isqrt()];
        }
        g
    }
}

/// The polynomials that the fits start from: those of the eigen logarithm, brought to another degree by least
/// squares over angles, times `scale`.
fn start(eigen: &[Vec<f64>], degree: usize, scale: f64) -> Vec<f64> {
    use nalgebra::{DMatrix, DVector};
    let u: Vec<f64> = (0..=60)
        .map(|i| 2.0 * f64::from(i).to_radians().cos() - 1.0)
        .collect();
    let design = DMatrix::from_fn(u.len(), degree + 1, |i, k| u[i].powi(k as i32));
    eigen
        .iter()
        .flat_map(|band| {
            let value = |u: &f64| scale * band.iter().rev().fold(0.0, |p, c| p * u + c);
            let target = DVector::from_iterator(u.len(), u.iter().map(value));
            super::marquardt::least_squares(design.clone(), &target)
        })
        .collect()
}

/// All fits of an order.
pub(super) fn fit<const C: usize>(
    eigen: &[Vec<f64>],
    texts: &mut Texts,
    progress: &(dyn Fn(f32) + Sync),
) where
    [f64; C]: Logarithm,
{
    let n = <[f64; C]>::ORDER;
    let write = |text: &mut String, name: &str, degree: usize, x: &[f64], error: f64| {
        writeln!(
            text,
            "# {name}, order {n}: root of the mean square {error:.4}"
        )
        .expect("writing to a string");
        for band in x[..n * (degree + 1)].chunks(degree + 1) {
            row(text, &format!("{name} {n}"), band);
        }
    };

    let stacked = training(n, true);
    let rule = Rule::<C>::new();
    let mut x = start(eigen, SATURATING_DEGREE, 0.4);
    x.push(0.0);
    x.extend(vec![0.9; n - 1]);
    let error = run(&stacked, SATURATING_DEGREE, &mut x, &|f, own| {
        rule.saturating(f, own)
    });
    write(
        &mut texts.cap_log,
        "saturating",
        SATURATING_DEGREE,
        &x,
        error,
    );
    let own = &x[n * (SATURATING_DEGREE + 1)..];
    let gains = [&[own[0].exp(), 1.0], &own[1..]].concat();
    row(&mut texts.saturating, &n.to_string(), &gains);
    progress(0.15);

    let separate = training(n, false);
    let methods: [(&str, &Sets, Exponential<C>); 6] = [
        ("sampled", &stacked, &|f, _| f.exp_sampled()),
        ("sampled_coarse", &stacked, &|f, _| f.exp_sampled_coarse()),
        ("sampled_fine", &stacked, &|f, _| f.exp_sampled_fine()),
        ("ps_star", &separate, &|f, _| {
            exp::ps_star_by::<Outlined, _, _>(f, 2)
        }),
        ("hyb", &separate, &|f, _| exp::hyb_by::<Outlined, _, _>(f)),
        ("optimal_linear", &separate, &|f, _| exp::optimal_linear(f)),
    ];
    let count = methods.len() as f32;
    for (done, (name, sets, exponential)) in methods.into_iter().enumerate() {
        let degree = eigen[0].len() - 1;
        let mut x = start(eigen, degree, 1.0);
        let error = run(sets, degree, &mut x, exponential);
        write(&mut texts.cap_log, name, degree, &x, error);
        progress(0.15 + 0.85 * (done + 1) as f32 / count);
    }
}
