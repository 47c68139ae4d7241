//! The factors of the optimal linear exponential, from circles of growing radius.

use super::marquardt::least_squares;
use super::row;
use gaunt::exponential::eigen_log;
use nalgebra::{DMatrix, DVector};
use sh_core::log::Logarithm;
use sh_core::{ROOT_FOUR_PI, Routines, cap};
use std::fmt::Write;

/// Degree of the polynomials for ‖f̂‖ ≤ 1/4.
const SMALL_DEGREE: usize = 3;

/// Degree of the polynomials over the whole range, where the curves bend.
const WIDE_DEGREE: usize = 8;

/// The largest norm that scaling leaves.
const SMALL: f64 = 0.25;

/// ‖f̂‖ of a circle's logarithm, and the factors that bring a·1 + b·f̂ nearest to its visibility (eq. 24).
struct Sample {
    norm: f64,
    a: f64,
    b: f64,
}

/// Samples of growing norm: up to 90 degrees, or to where the norm ceases to grow.
fn samples<const C: usize>() -> Vec<Sample>
where
    [f64; C]: Logarithm,
{
    let mut out: Vec<Sample> = Vec::new();
    for i in 1..=720 {
        let angle = f64::from(i).to_radians() / 8.0;
        let g = cap::visibility::<C>(angle);
        let f = eigen_log::<C>(angle);
        let square: f64 = f[1..].iter().map(|x| x * x).sum();
        let norm = square.sqrt();
        if out.last().is_some_and(|last| norm <= last.norm) {
            break;
        }
        let dc = (-f[0] / ROOT_FOUR_PI).exp();
        let along: f64 = g.as_ref()[1..]
            .iter()
            .zip(&f[1..])
            .map(|(g, f)| g * f)
            .sum();
        out.push(Sample {
            norm,
            a: dc * g.as_ref()[0] / ROOT_FOUR_PI,
            b: dc * along / square,
        });
    }
    out
}

/// Fits the factors on a range of norms and writes the rows, first a, then b. Coefficients count powers of
/// ‖f̂‖/`unit`; a(0) = b(0) = 1 exactly: an empty blocker leaves full visibility.
fn factors(text: &mut String, words: &str, samples: &[Sample], unit: f64, degree: usize) {
    let design = DMatrix::from_fn(samples.len(), degree, |i, k| {
        (samples[i].norm / unit).powi(k as i32 + 1)
    });
    let fit = |value: &dyn Fn(&Sample) -> f64| {
        let target = DVector::from_iterator(samples.len(), samples.iter().map(|s| value(s) - 1.0));
        let mut c = least_squares(design.clone(), &target);
        c.insert(0, 1.0);
        let error = samples.iter().fold(0.0_f64, |worst, s| {
            let p = c.iter().rev().fold(0.0, |p, c| p * s.norm / unit + c);
            worst.max((p - value(s)).abs())
        });
        (c, error)
    };
    let ((a, error_a), (b, error_b)) = (fit(&|s| s.a), fit(&|s| s.b));
    writeln!(text, "# {words}: largest error {error_a:.1e} {error_b:.1e}")
        .expect("writing to a string");
    row(text, words, &a);
    row(text, words, &b);
}

/// Both ranges of an order.
pub(super) fn optimal_linear<const C: usize>(text: &mut String)
where
    [f64; C]: Logarithm,
{
    let n = <[f64; C]>::ORDER;
    let samples = samples::<C>();
    let small = samples.partition_point(|s| s.norm <= SMALL);
    factors(
        text,
        &format!("small {n}"),
        &samples[..small],
        1.0,
        SMALL_DEGREE,
    );
    let range = samples.last().expect("a circle").norm;
    row(text, &format!("range {n}"), &[range]);
    factors(text, &format!("wide {n}"), &samples, range, WIDE_DEGREE);
}
