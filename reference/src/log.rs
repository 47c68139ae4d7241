//! The SH logarithm: the vector f whose exponential is near a given g.
//!
//! *By eigenvalues* (section 5 of Ren 2006): with M_g = Rᵀ D R the product matrix and D clipped from below,
//! log g = Rᵀ q′(D) R (g − 1), q′(x) = log(x)/(x − 1) (eq. 30–32). It inverts the truncated product series,
//! so the exponential gives g back. *By samples*: log of the reconstructed function, clipped at ε, and
//! projected (eq. 25); what one would try first, worse in both of the paper's regards.

use crate::basis::{basis, dot, evaluate, order_of};
use crate::cap;
use crate::product::{one, product_matrix};
use crate::quadrature::{Rule, accumulate, gauss_legendre};
use crate::zonal::{axial, evaluate as evaluate_zonal, upright};
use nalgebra::DMatrix;
use std::f64::consts::TAU;

/// Eigenvalues below this fraction of the largest are raised to it (section 5 of Ren 2006).
pub const CLIP: f64 = 0.02;

/// q′(x) = log(x)/(x − 1) for x > 0, 1 at x = 1 (eq. 31); relative error a few units in the last place.
///
/// ```
/// assert!((sh_reference::log::quotient(2.0) - 2f64.ln()).abs() < 1e-15);
/// assert_eq!(sh_reference::log::quotient(1.0), 1.0);
/// ```
pub fn quotient(x: f64) -> f64 {
    // x − 1 is exact from ½ to 2, and ln_1p accurate everywhere.
    let t = x - 1.0;
    if t == 0.0 {
        1.0
    } else if t.abs() < 0.5 {
        t.ln_1p() / t
    } else {
        x.ln() / t
    }
}

/// Eigenvalues of the product matrix M_g, ascending: values that the product can tell g to take.
pub fn spectrum(g: &[f64]) -> Vec<f64> {
    let mut values: Vec<f64> = decompose(g).eigenvalues.iter().copied().collect();
    values.sort_by(f64::total_cmp);
    values
}

fn decompose(g: &[f64]) -> nalgebra::SymmetricEigen<f64, nalgebra::Dyn> {
    DMatrix::from_row_slice(g.len(), g.len(), &product_matrix(g)).symmetric_eigen()
}

/// The logarithm by eigenvalues, clipped at `clip` times the largest; [`CLIP`] is the paper's. Nothing where
/// the largest eigenvalue is not positive (g has no logarithm) or not finite.
///
/// ```
/// use sh_reference::{basis::basis, log, product::one};
/// let e: Vec<f64> = one(4).iter().map(|c| c * std::f64::consts::E).collect();
/// let log = log::eigen(&e, log::CLIP).unwrap();
/// assert!(log.iter().zip(one(4)).all(|(a, b)| (a - b).abs() < 1e-13));
/// ```
pub fn eigen(g: &[f64], clip: f64) -> Option<Vec<f64>> {
    let order = order_of(g.len());
    if !g.iter().all(|c| c.is_finite()) {
        return None;
    }
    let decomposed = decompose(g);
    let largest = decomposed.eigenvalues.max();
    if largest.is_nan() || largest <= 0.0 {
        return None;
    }
    let difference: Vec<f64> = g.iter().zip(one(order)).map(|(g, one)| g - one).collect();
    let mut log = vec![0.0; g.len()];
    for (value, vector) in decomposed
        .eigenvalues
        .iter()
        .zip(decomposed.eigenvectors.column_iter())
    {
        let factor = quotient(value.max(clip * largest)) * dot(&difference, vector.as_slice());
        accumulate(&mut log, factor, vector.as_slice());
    }
    Some(log)
}

/// The logarithm by samples, ∫ log(max(g(s), ε)) y(s) ds (eq. 25), on a rule of the given degree. The
/// clipped integrand has kinks, where its slope jumps by |∇g|/ε, so the error falls only slowly: about
/// |∇g|/(ε·degree²).
///
/// ```
/// let quarter: Vec<f64> = sh_reference::product::one(2).iter().map(|c| 0.25 * c).collect();
/// let log = sh_reference::log::samples(&quarter, 1e-3, 20);
/// assert!((sh_reference::basis::evaluate(&log, [1.0, 0.0, 0.0]) - 0.25f64.ln()).abs() < 1e-13);
/// ```
pub fn samples(g: &[f64], epsilon: f64, degree: usize) -> Vec<f64> {
    Rule::sphere(degree).project(order_of(g.len()), |s| evaluate(g, s).max(epsilon).ln())
}

/// Zonal logarithm by eigenvalues of the visibility past a cap, `angle` in 0..π; nothing at π, where all is
/// blocked.
pub fn cap_eigen(order: usize, angle: f64, clip: f64) -> Option<Vec<f64>> {
    eigen(&upright(&cap::visibility(order, angle)), clip).map(|log| axial(&log))
}

/// Zonal logarithm by samples of the *reconstructed* visibility past a cap: 2π ∫ log(max(g(z), ε)) y_l0 dz,
/// with panels that end at the kinks (bisected), so that the error is about 1e-12.
pub fn cap_samples(order: usize, angle: f64, epsilon: f64) -> Vec<f64> {
    let g = cap::visibility(order, angle);
    let above = |z: f64| evaluate_zonal(&g, z) > epsilon;
    let mut ends: Vec<f64> = (0..=256)
        .map(|i| -(std::f64::consts::PI * f64::from(i) / 256.0).cos())
        .collect();
    for i in 0..256 {
        if above(ends[i]) != above(ends[i + 1]) {
            ends.push(bisect(ends[i], ends[i + 1], above));
        }
    }
    ends.sort_by(f64::total_cmp);
    let mut sum = vec![0.0; order];
    for panel in ends.windows(2) {
        for (z, weight) in gauss_legendre(8, panel[0], panel[1]) {
            let y = axial(&basis(order, [((1.0 - z) * (1.0 + z)).sqrt(), 0.0, z]));
            accumulate(
                &mut sum,
                TAU * weight * evaluate_zonal(&g, z).max(epsilon).ln(),
                &y,
            );
        }
    }
    sum
}

/// Where a predicate changes between `from` and `to`, to rounding.
fn bisect(mut from: f64, mut to: f64, holds: impl Fn(f64) -> bool) -> f64 {
    let start = holds(from);
    for _ in 0..60 {
        let middle = 0.5 * (from + to);
        if holds(middle) == start {
            from = middle
        } else {
            to = middle
        }
    }
    0.5 * (from + to)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::basis::{distance, norm};
    use crate::exp;
    use crate::rotation::{about, rotate};
    use crate::testing::{assert_close, numbers};
    use crate::zonal;

    #[test]
    fn quotient_is_smooth_through_one() {
        // log(1+t)/t = 1 - t/2 + t²/3 - ...
        for t in [1e-3f64, 1e-6, 1e-9, 1e-13, -1e-3, -1e-9] {
            let x = 1.0 + t;
            let t = x - 1.0;
            assert!((quotient(x) - (1.0 - t / 2.0 + t * t / 3.0 - t.powi(3) / 4.0)).abs() < 1e-12);
        }
        for x in [0.49999, 0.50001, 1.49999, 1.50001] {
            assert!((quotient(x) - x.ln() / (x - 1.0)).abs() < 1e-15);
        }
    }

    #[test]
    fn constants() {
        for value in [0.1f64, 0.5, 1.0, 7.0] {
            let scaled = |k: f64| one(4).iter().map(|c| k * c).collect::<Vec<_>>();
            assert_close(
                &eigen(&scaled(value), CLIP).unwrap(),
                &scaled(value.ln()),
                1e-12,
            );
            assert_close(
                &samples(&scaled(value), 1e-6, 12),
                &scaled(value.ln()),
                1e-12,
            );
        }
    }

    #[test]
    fn order_two_has_a_closed_form_clipped_or_not() {
        // For g = (g₀, 0, g₂, 0), M_g has eigenvalues (g₀ ± g₂)/√4π on (1, 0, ±1, 0)/√2.
        let root = (4.0 * std::f64::consts::PI).sqrt();
        // At 0.3 nothing is clipped at any fraction tried, at 1.99 and 2.5 (a negative value) the lower is.
        for (g2, clip) in [(0.3, CLIP), (1.99, CLIP), (1.99, 0.1), (2.5, CLIP)] {
            let upper = (2.0 + g2) / root;
            let lower = ((2.0 - g2) / root).max(clip * upper);
            let (plus, minus) = (2.0 - root + g2, 2.0 - root - g2);
            let (plus, minus) = (quotient(upper) * plus, quotient(lower) * minus);
            let expected = [0.5 * (plus + minus), 0.0, 0.5 * (plus - minus), 0.0];
            assert_close(
                &eigen(&[2.0, 0.0, g2, 0.0], clip).unwrap(),
                &expected,
                1e-12,
            );
            let spectrum = spectrum(&[2.0, 0.0, g2, 0.0]);
            assert_close(
                &[spectrum[0], spectrum[3]],
                &[(2.0 - g2) / root, upper],
                1e-14,
            );
        }
    }

    #[test]
    fn no_logarithm_of_what_is_not_positive() {
        let minus: Vec<f64> = one(3).iter().map(|c| -c).collect();
        assert_eq!(eigen(&minus, CLIP), None);
        assert_eq!(eigen(&[0.0; 9], CLIP), None);
        assert_eq!(eigen(&[f64::NAN; 9], CLIP), None);
    }

    #[test]
    fn eigen_inverts_the_exponential_of_mild_vectors() {
        for order in [2, 4, 6] {
            let f: Vec<f64> = numbers(11, order * order)
                .iter()
                .map(|c| 0.02 * c)
                .collect();
            let back = eigen(&exp::series(&f, 20), CLIP).unwrap();
            // Only approximately, because the product is not associative (eq. 18): third order in f.
            let off = distance(&back, &f);
            assert!(
                off < 2.0 * norm(&f).powi(3),
                "{:e} at norm {:e}",
                off,
                norm(&f)
            );
        }
    }

    #[test]
    fn logarithm_turns_with_its_argument() {
        let q = about([0.0, 0.6, 0.8], 0.9);
        let g = zonal::upright(&cap::visibility(4, 0.6));
        let turned = eigen(&rotate(&g, q), CLIP).unwrap();
        assert_close(&turned, &rotate(&eigen(&g, CLIP).unwrap(), q), 1e-12);
    }

    #[test]
    fn logs_of_caps_are_zonal_and_come_back() {
        for order in [2, 4, 6] {
            for angle in [0.05, 0.2, 0.5] {
                let g = zonal::upright(&cap::visibility(order, angle));
                let full = eigen(&g, CLIP).unwrap();
                let log = cap_eigen(order, angle, CLIP).unwrap();
                assert_close(&zonal::upright(&log), &full, 1e-12);
                // Ren 2006: the exponential of the logarithm is near its argument.
                let back = exp::ps_star(&full, 9);
                let off = distance(&back, &g);
                assert!(off < 0.15 * norm(&g), "{:e}", off / norm(&g));
            }
        }
        assert_eq!(cap_eigen(4, std::f64::consts::PI, CLIP).map(|_| ()), None);
    }

    #[test]
    fn samples_of_caps_agree_with_a_rule_over_the_sphere() {
        for (order, angle) in [(2, 0.3), (4, 0.7), (6, 1.2)] {
            let panels = cap_samples(order, angle, 0.2);
            let rule = samples(&zonal::upright(&cap::visibility(order, angle)), 0.2, 400);
            assert_close(&panels, &axial(&rule), 3e-4);
        }
        let smooth = cap_samples(3, 0.1, 1e-3);
        let rule = samples(&zonal::upright(&cap::visibility(3, 0.1)), 1e-3, 60);
        assert_close(&smooth, &axial(&rule), 1e-12);
    }
}
