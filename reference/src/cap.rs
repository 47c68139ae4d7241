//! The visibility past one sphere: 0 inside a cap of the sphere of directions, 1 outside.
//!
//! About +Z, g(s) = 0 for s·z ≥ cos θ, else 1 (eq. 33 of Ren 2006), so with the edge as an end of the
//! interval the integrand is a polynomial in the height, and Gauss–Legendre is exact:
//! g_l = 2π ∫_{−1}^{cos θ} y_l0(z) dz.

use crate::basis::{basis, index};
use crate::quadrature::gauss_legendre;
use std::f64::consts::{PI, TAU};

/// Zonal coefficients of the visibility past a cap of angular radius `angle`, in 0..=π. Absolute error 5e-15
/// up to order 12.
///
/// ```
/// let half = sh_reference::cap::visibility(2, std::f64::consts::FRAC_PI_2);
/// assert!((half[0] - std::f64::consts::PI.sqrt()).abs() < 1e-15);
/// ```
///
/// # Panics
/// If the angle lies outside 0..=π.
pub fn visibility(order: usize, angle: f64) -> Vec<f64> {
    assert!(
        (0.0..=PI).contains(&angle),
        "a cap's angular radius lies in 0..=π, not {angle}"
    );
    integrate(order, -1.0, angle.cos())
}

/// Zonal coefficients of the cap itself: 1 inside, 0 outside; `visibility` + `blocked` = √4π, 0, 0, …. Near
/// an angle of 0 its relative error stays 1e-13, while in [`visibility`] nothing of the cap is left.
///
/// # Panics
/// If the angle lies outside 0..=π.
pub fn blocked(order: usize, angle: f64) -> Vec<f64> {
    assert!(
        (0.0..=PI).contains(&angle),
        "a cap's angular radius lies in 0..=π, not {angle}"
    );
    // 1 − cos θ without cancellation.
    let height = 2.0 * (0.5 * angle).sin().powi(2);
    let mut sum = vec![0.0; order];
    for (depth, weight) in gauss_legendre(order / 2 + 1, 0.0, height) {
        add_zonal(&mut sum, TAU * weight, 1.0 - depth);
    }
    sum
}

fn integrate(order: usize, from: f64, to: f64) -> Vec<f64> {
    let mut sum = vec![0.0; order];
    for (height, weight) in gauss_legendre(order / 2 + 1, from, to) {
        add_zonal(&mut sum, TAU * weight, height);
    }
    sum
}

fn add_zonal(sum: &mut [f64], weight: f64, height: f64) {
    let radius = ((1.0 - height) * (1.0 + height)).max(0.0).sqrt();
    let y = basis(sum.len(), [radius, 0.0, height]);
    for (l, sum) in sum.iter_mut().enumerate() {
        *sum += weight * y[index(l, 0)];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quadrature::Rule;
    use crate::testing::assert_close;
    use crate::zonal::axial;
    use std::f64::consts::FRAC_PI_2;

    /// ∫_{-1}^{c} P_l = (P_{l+1}(c) - P_{l-1}(c)) / (2l+1), P_{-1} = 1 standing in for -P_0's lower end.
    fn closed(order: usize, c: f64) -> Vec<f64> {
        let mut p = vec![1.0, c];
        for l in 1..order {
            p.push(((2 * l + 1) as f64 * c * p[l] - l as f64 * p[l - 1]) / (l + 1) as f64);
        }
        (0..order)
            .map(|l| {
                let integral = if l == 0 {
                    c + 1.0
                } else {
                    (p[l + 1] - p[l - 1]) / (2 * l + 1) as f64
                };
                TAU * ((2 * l + 1) as f64 / (4.0 * PI)).sqrt() * integral
            })
            .collect()
    }

    #[test]
    fn closed_form_at_any_angle() {
        for i in 0..=64 {
            let angle = PI * f64::from(i) / 64.0;
            assert_close(&visibility(8, angle), &closed(8, angle.cos()), 3e-15);
        }
    }

    #[test]
    fn nothing_half_and_all() {
        let full = (4.0 * PI).sqrt();
        assert_close(&visibility(4, 0.0), &[full, 0.0, 0.0, 0.0], 1e-14);
        assert_close(&visibility(4, PI), &[0.0; 4], 1e-15);
        // The lower half: y_1 integrates to -π √(3/4π); even bands vanish but for the first.
        let one = -PI * (3.0 / (4.0 * PI)).sqrt();
        let three = TAU * (7.0 / (4.0 * PI)).sqrt() / 8.0;
        assert_close(
            &visibility(4, FRAC_PI_2),
            &[0.5 * full, one, 0.0, three],
            1e-14,
        );
    }

    #[test]
    fn zones_agree() {
        let (order, angle) = (6, 0.8f64);
        let zone = Rule::zone([0.0, 0.0, 1.0], -1.0, angle.cos(), order).project(order, |_| 1.0);
        assert_close(&visibility(order, angle), &axial(&zone), 1e-14);
    }

    #[test]
    fn cap_and_visibility_make_up_the_sphere() {
        for angle in [0.0, 0.1, 1.0, 2.0, PI] {
            let sum: Vec<f64> = visibility(6, angle)
                .iter()
                .zip(blocked(6, angle))
                .map(|(a, b)| a + b)
                .collect();
            assert_close(&sum, &[(4.0 * PI).sqrt(), 0.0, 0.0, 0.0, 0.0, 0.0], 1e-14);
        }
        // A tiny cap: its solid angle times y_l0 at the pole.
        let angle: f64 = 1e-6;
        let area = PI * angle * angle;
        for (l, b) in blocked(6, angle).iter().enumerate() {
            let expected = area * ((2 * l + 1) as f64 / (4.0 * PI)).sqrt();
            assert!((b / expected - 1.0).abs() < 1e-10);
        }
    }
}
