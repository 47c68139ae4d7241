//! The eigen logarithm of a circle's visibility: its table and its polynomials.

use super::marquardt::least_squares;
use super::row;
use gaunt::exponential::eigen_log;
use nalgebra::{DMatrix, DVector};
use sh_core::Routines;
use sh_core::log::Logarithm;
use std::fmt::Write;

/// Degree of the polynomials that follow the eigen logarithm, which has kinks.
const DEGREE: usize = 7;

/// Fits every band, writes the rows and gives them back.
pub(super) fn cap_log<const C: usize>(text: &mut String) -> Vec<Vec<f64>>
where
    [f64; C]: Logarithm,
{
    let n = <[f64; C]>::ORDER;
    let angles: Vec<f64> = (1..=180).map(|i| f64::from(i).to_radians() / 2.0).collect();
    let truth: Vec<Vec<f64>> = angles.iter().map(|t| eigen_log::<C>(*t)).collect();
    // Weighted with 1/sin² θ, that is with one over the solid angle: a distant blocker must cast its shadow as
    // exactly, for its size, as a near one.
    let design = DMatrix::from_fn(angles.len(), DEGREE + 1, |i, k| {
        (2.0 * angles[i].cos() - 1.0).powi(k as i32)
    });
    let fits: Vec<Vec<f64>> = (0..n)
        .map(|l| {
            let target = DVector::from_iterator(
                angles.len(),
                angles
                    .iter()
                    .zip(&truth)
                    .map(|(t, f)| f[l] / t.sin().powi(2)),
            );
            least_squares(design.clone(), &target)
        })
        .collect();
    let error = |l: usize| {
        angles.iter().zip(&truth).fold(0.0_f64, |worst, (t, f)| {
            let u = 2.0 * t.cos() - 1.0;
            let p = fits[l].iter().rev().fold(0.0, |p, c| p * u + c);
            worst.max((t.sin().powi(2) * p - f[l]).abs())
        })
    };
    let errors: Vec<String> = (0..n).map(|l| format!("{:.3}", error(l))).collect();
    writeln!(
        text,
        "# eigen, order {n}: largest error by band {}",
        errors.join(" ")
    )
    .expect("writing to a string");
    for fit in &fits {
        row(text, &format!("eigen {n}"), fit);
    }
    fits
}

/// Writes the table at whole degrees.
pub(super) fn cap_log_table<const C: usize>(text: &mut String)
where
    [f64; C]: Logarithm,
{
    for degree in 0..180 {
        row(
            text,
            &<[f64; C]>::ORDER.to_string(),
            &eigen_log::<C>(f64::from(degree).to_radians()),
        );
    }
}
