//! What is seen of a ball from outside.

use super::marquardt::least_squares;
use super::row;
use nalgebra::{DMatrix, DVector};
use sh_reference::ball::mean;
use std::f64::consts::FRAC_PI_2;
use std::fmt::Write;

/// The highest band that there are routines for.
const BANDS: usize = 5;

/// Powers of cos θ in P and in Q, from 0 on.
const POWERS: [usize; 2] = [5, 4];

/// Angular radii that the fit sees, denser at both ends.
const ANGLES: usize = 400;

/// The polynomials of `p_l = 1 + cos θ (P + sin θ Q)` for each band, fitted to [`mean`]. The form is 1 for θ = 90°, where
/// a single point is in sight; the mean is analytic in sine and cosine, so both are needed and few powers do.
pub(super) fn text() -> String {
    let mut text = String::from(
        "# What is seen of a ball: the mean of P_l over what is in sight by solid angle, p_l = 1 + c (P(c) + s Q(c)),\n\
         # with c and s the cosine and sine of the angular radius.\n\
         # Written by `gaunt-lab fit`. Columns: polynomial, band, coefficients from the lowest power.\n",
    );
    let angles: Vec<f64> = (1..ANGLES)
        .map(|i| {
            let t = std::f64::consts::PI * i as f64 / ANGLES as f64;
            FRAC_PI_2 * (1.0 - t.cos()) / 2.0
        })
        .collect();
    let [p, q] = POWERS;
    let design = DMatrix::from_fn(angles.len(), p + q, |i, k| {
        let (s, c) = angles[i].sin_cos();
        if k < p {
            c.powi(k as i32 + 1)
        } else {
            s * c.powi((k - p) as i32 + 1)
        }
    });
    for band in 1..=BANDS {
        let values = angles.iter().map(|angle| mean(band, angle.sin()) - 1.0);
        let target = DVector::from_iterator(angles.len(), values);
        let fitted = least_squares(design.clone(), &target);
        let off = &design * DVector::from_column_slice(&fitted) - target;
        writeln!(text, "# band {band}: largest error {:.1e}", off.amax())
            .expect("writing to a string");
        row(&mut text, &format!("P {band}"), &fitted[..p]);
        row(&mut text, &format!("Q {band}"), &fitted[p..]);
    }
    text
}
