//! Functions that are symmetric about an axis, the cosine lobe, and the window.
//!
//! A zonal vector holds the coefficients z_l of y_l0 about +Z, one a band. Turned to the unit vector d it
//! stands for the function Σ_l z_l y_l0(t), t = the cosine of the angle with d; here that function is
//! sampled and projected, while the routines under test use the rotation rule z_l·√(4π/(2l+1))·y_lm(d)
//! (section 6.1 of Ren 2006, after Sloan et al. 2005).

use crate::basis::{band, basis, index, order_of};
use crate::quadrature::{Rule, accumulate};
use crate::vec3::dot;
use std::f64::consts::{FRAC_PI_2, PI};

/// The zonal function in a direction whose cosine with the axis is `t`.
pub fn evaluate(z: &[f64], t: f64) -> f64 {
    let y = basis(z.len(), [((1.0 - t) * (1.0 + t)).max(0.0).sqrt(), 0.0, t]);
    z.iter().enumerate().map(|(l, z)| z * y[index(l, 0)]).sum()
}

/// The SH vector of a zonal function about the unit vector `direction`; order n from n coefficients.
///
/// ```
/// let f = sh_reference::zonal::rotated(&[0.0, 1.0], [1.0, 0.0, 0.0]);
/// assert!((f[3] - 1.0).abs() < 1e-14 && f[2].abs() < 1e-14);
/// ```
pub fn rotated(z: &[f64], direction: [f64; 3]) -> Vec<f64> {
    let order = z.len();
    Rule::sphere(2 * (order - 1)).project(order, |s| evaluate(z, dot(s, direction)))
}

/// The SH vector of a zonal function about +Z: z_l at m = 0, nothing elsewhere.
pub fn upright(z: &[f64]) -> Vec<f64> {
    let mut f = vec![0.0; z.len() * z.len()];
    for (l, z) in z.iter().enumerate() {
        f[index(l, 0)] = *z;
    }
    f
}

/// The coefficients at m = 0, one a band: the zonal vector of a function that is symmetric about +Z.
pub fn axial(f: &[f64]) -> Vec<f64> {
    (0..order_of(f.len())).map(|l| f[index(l, 0)]).collect()
}

/// H(N): ∫ max(s·N, 0)/π y(s) ds (eq. 9 of Ren 2006) for the unit vector `normal`. A rule over the
/// hemisphere about N, where the integrand is a polynomial, so it is exact.
///
/// ```
/// let h = sh_reference::zonal::cosine(3, [0.0, 0.0, 1.0]);
/// let y1 = (3.0 / (4.0 * std::f64::consts::PI)).sqrt();
/// assert!((h[2] - 2.0 / 3.0 * y1).abs() < 1e-15);
/// ```
pub fn cosine(order: usize, normal: [f64; 3]) -> Vec<f64> {
    let mut sum = vec![0.0; order * order];
    for (direction, weight) in Rule::hemisphere(normal, order).nodes() {
        accumulate(
            &mut sum,
            weight * dot(direction, normal) / PI,
            &basis(order, direction),
        );
    }
    sum
}

/// The window of section 7 of Ren 2006: band l times cos(π/2 · l/h), and 0 from l = h on, where the cosine
/// would turn negative.
pub fn window(f: &[f64], h: f64) -> Vec<f64> {
    let factor = |l: f64| {
        if l < h {
            (FRAC_PI_2 * l / h).cos()
        } else {
            0.0
        }
    };
    f.iter()
        .enumerate()
        .map(|(i, f)| f * factor(band(i) as f64))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rotation::{about, rotate, turn};
    use crate::testing::{assert_close, directions, numbers};

    #[test]
    fn rotated_follows_the_rotation_rule() {
        for order in [1, 2, 4, 6, 10] {
            let z = numbers(order as u64, order);
            for d in directions(8) {
                let y = basis(order, d);
                let rule: Vec<f64> = (0..order * order)
                    .map(|i| z[band(i)] * (4.0 * PI / (2 * band(i) + 1) as f64).sqrt() * y[i])
                    .collect();
                assert_close(&rotated(&z, d), &rule, 1e-13);
            }
        }
    }

    #[test]
    fn rotated_is_upright_turned() {
        let z = numbers(9, 5);
        let q = about([0.6, 0.8, 0.0], 1.1);
        assert_close(
            &rotate(&upright(&z), q),
            &rotated(&z, turn(q, [0.0, 0.0, 1.0])),
            1e-13,
        );
        assert_eq!(axial(&upright(&z)), z);
    }

    #[test]
    fn cosine_lobe_has_the_known_factors() {
        // A_l/π of Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment Maps",
        // eq. 8: 1, 2/3, 1/4, 0, -1/24, 0, 1/64, 0, -1/128.
        let factors = [
            1.0,
            2.0 / 3.0,
            0.25,
            0.0,
            -1.0 / 24.0,
            0.0,
            1.0 / 64.0,
            0.0,
            -1.0 / 128.0,
        ];
        for normal in directions(12) {
            let expected: Vec<f64> = basis(9, normal)
                .iter()
                .enumerate()
                .map(|(i, y)| factors[band(i)] * y)
                .collect();
            assert_close(&cosine(9, normal), &expected, 1e-14);
        }
    }

    #[test]
    fn window_ends_at_h() {
        let f = vec![1.0; 36];
        let wide = window(&f, 12.0);
        assert_eq!(wide[0], 1.0);
        assert!((wide[35] - (5.0 / 12.0 * FRAC_PI_2).cos()).abs() < 1e-15);
        let narrow = window(&f, 2.5);
        assert!(narrow[8] > 0.0 && narrow[9..].iter().all(|&v| v == 0.0));
        assert!(window(&f, 2.0)[4..].iter().all(|&v| v == 0.0));
    }
}
