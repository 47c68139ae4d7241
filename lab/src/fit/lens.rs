//! The part that one disc covers of another.

use super::marquardt::least_squares;
use super::row;
use nalgebra::{DMatrix, DVector};
use sh_reference::lens::covered;
use std::fmt::Write;

/// Ratios of radii, and depths, that the fit sees.
const RATIOS: usize = 50;
const DEPTHS: usize = 101;

/// `f(t, q) = A t + B t² + (1 − A − B) t³` with A and B linear in q, fitted to [`covered`]: 0 and 1 at the ends whatever
/// the coefficients.
pub(super) fn text() -> String {
    let mut text = String::from(
        "# The part of the smaller of two discs that the larger covers: f = A t + B t^2 + (1 - A - B) t^3, with t how far\n\
         # it has entered over its diameter, and A and B polynomials in q, the ratio of the radii.\n\
         # Written by `gaunt-lab fit`. Columns: power of t, coefficients from the lowest power of q.\n",
    );
    let at = |i: usize| {
        let ratio = 0.02 + 0.98 * (i / DEPTHS) as f64 / (RATIOS - 1) as f64;
        (ratio, (i % DEPTHS) as f64 / (DEPTHS - 1) as f64)
    };
    let design = DMatrix::from_fn(RATIOS * DEPTHS, 4, |i, k| {
        let (q, t) = at(i);
        (t.powi(1 + k as i32 / 2) - t.powi(3)) * q.powi(k as i32 % 2)
    });
    let values = (0..RATIOS * DEPTHS).map(|i| {
        let (q, t) = at(i);
        covered(q, t) - t.powi(3)
    });
    let target = DVector::from_iterator(RATIOS * DEPTHS, values);
    let fitted = least_squares(design.clone(), &target);
    let off = &design * DVector::from_column_slice(&fitted) - target;
    writeln!(text, "# largest error {:.4}", off.amax()).expect("writing to a string");
    row(&mut text, "1", &fitted[..2]);
    row(&mut text, "2", &fitted[2..]);
    text
}
