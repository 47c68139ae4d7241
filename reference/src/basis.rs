//! The real spherical-harmonic basis, any order, by the associated-Legendre recurrence.
//!
//! With P̂_l^m(z) = P_l^m(z) / (1 − z²)^{m/2}, free of the Condon–Shortley phase,
//!
//! ```text
//! P̂_m^m     = 1·3·5·…·(2m−1)
//! P̂_{m+1}^m = (2m+1) z P̂_m^m
//! (l−m) P̂_l^m = (2l−1) z P̂_{l−1}^m − (l+m−1) P̂_{l−2}^m
//!
//! y_lm = K_l^|m| P̂_l^|m|(z) · { Re (x+iy)^m,  1,  Im (x+iy)^|m| }   for m > 0, m = 0, m < 0
//! K_l^m = √((2l+1)/(4π) · (l−m)!/(l+m)! · (2 if m > 0))
//! ```
//!
//! (Abramowitz & Stegun 8.5.3, with the sine powers moved into x + iy so that the poles need no care.)

use std::f64::consts::PI;

/// Position of the coefficient of band `l` and component `m` (−l to l) in an SH vector.
///
/// ```
/// assert_eq!(sh_reference::basis::index(2, -2), 4);
/// ```
pub fn index(l: usize, m: isize) -> usize {
    (l * l + l).strict_add_signed(m)
}

/// The band `l` that coefficient `i` belongs to.
pub fn band(i: usize) -> usize {
    i.isqrt()
}

/// The order of an SH vector with so many coefficients.
///
/// # Panics
/// If `coefficients` is 0 or no square.
pub fn order_of(coefficients: usize) -> usize {
    let order = coefficients.isqrt();
    assert!(
        order > 0 && order * order == coefficients,
        "an SH vector has 1, 4, 9, 16, ... coefficients, not {coefficients}"
    );
    order
}

/// All `order²` basis functions in one unit direction. Error a few units in the last place of each band's
/// largest value, √((2l+1)/4π), up to order 12 at least.
///
/// ```
/// let y = sh_reference::basis::basis(2, [0.0, 0.0, 1.0]);
/// assert!((y[2] - (3.0 / (4.0 * std::f64::consts::PI)).sqrt()).abs() < 1e-15);
/// ```
pub fn basis(order: usize, direction: [f64; 3]) -> Vec<f64> {
    assert!(order > 0, "an SH vector has order 1 or more");
    let [x, y, z] = direction;
    let mut values = vec![0.0; order * order];
    // (x + iy)^m, of which the real part is sin^m θ cos mφ and the imaginary part sin^m θ sin mφ.
    let (mut re, mut im) = (1.0, 0.0);
    let mut p = vec![0.0; order];
    for m in 0..order {
        column(m, z, &mut p);
        for l in m..order {
            let k = normalisation(l, m);
            values[index(l, m as isize)] = k * p[l] * re;
            if m > 0 {
                values[index(l, -(m as isize))] = k * p[l] * im;
            }
        }
        (re, im) = (re * x - im * y, re * y + im * x);
    }
    values
}

/// How fast every basis function grows in `direction` on the way along `tangent`, a vector at right angles to
/// it: ∇y·t. Error a few units in the last place of √(l(l+1)(2l+1)/4π), up to order 12 at least.
///
/// P̂_l^m is the m-th derivative of P_l, so that dP̂_l^m/dz = P̂_l^{m+1}, and that of (x+iy)^m along t is
/// m (x+iy)^{m−1} (t_x + i t_y). No pole needs care.
///
/// ```
/// // Along x, y_3 = √(3/4π) x grows by √(3/4π), and nothing else of the first two bands does.
/// let slopes = sh_reference::basis::derivative(2, [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
/// assert_eq!(slopes[..3], [0.0; 3]);
/// assert!((slopes[3] - (3.0 / (4.0 * std::f64::consts::PI)).sqrt()).abs() < 1e-15);
/// ```
pub fn derivative(order: usize, direction: [f64; 3], tangent: [f64; 3]) -> Vec<f64> {
    assert!(order > 0, "an SH vector has order 1 or more");
    let ([x, y, z], [tx, ty, tz]) = (direction, tangent);
    let mut values = vec![0.0; order * order];
    // (x + iy)^m, and its derivative.
    let (mut re, mut im) = (1.0, 0.0);
    let (mut re_t, mut im_t) = (0.0, 0.0);
    let (mut p, mut p_z) = (vec![0.0; order], vec![0.0; order]);
    column(0, z, &mut p);
    for m in 0..order {
        column(m + 1, z, &mut p_z);
        for l in m..order {
            let k = normalisation(l, m);
            values[index(l, m as isize)] = k * (p_z[l] * tz * re + p[l] * re_t);
            if m > 0 {
                values[index(l, -(m as isize))] = k * (p_z[l] * tz * im + p[l] * im_t);
            }
        }
        std::mem::swap(&mut p, &mut p_z);
        let next = (m + 1) as f64;
        (re_t, im_t) = (next * (re * tx - im * ty), next * (re * ty + im * tx));
        (re, im) = (re * x - im * y, re * y + im * x);
    }
    values
}

/// P̂_l^m(z) for every l, by the recurrence; 0 for l < m.
fn column(m: usize, z: f64, p: &mut [f64]) {
    let diagonal: f64 = (1..=m).map(|k| (2 * k - 1) as f64).product();
    let (mut before, mut now) = (0.0, diagonal);
    for (l, p) in p.iter_mut().enumerate() {
        if l > m {
            let next =
                ((2 * l - 1) as f64 * z * now - (l + m - 1) as f64 * before) / (l - m) as f64;
            (before, now) = (now, next);
        }
        *p = if l < m { 0.0 } else { now };
    }
}

/// K_l^m, which makes the basis orthonormal.
fn normalisation(l: usize, m: usize) -> f64 {
    // (l-m)! / (l+m)! as a quotient of few factors.
    let factorials: f64 = (l - m + 1..=l + m).map(|k| k as f64).product();
    let both_signs = if m == 0 { 1.0 } else { 2.0 };
    (both_signs * (2 * l + 1) as f64 / (4.0 * PI * factorials)).sqrt()
}

/// The function an SH vector stands for, in one direction (eq. 2 of Ren 2006).
///
/// ```
/// use sh_reference::{basis::evaluate, product::one};
/// assert!((evaluate(&one(3), [0.6, 0.0, 0.8]) - 1.0).abs() < 1e-15);
/// ```
pub fn evaluate(f: &[f64], direction: [f64; 3]) -> f64 {
    dot(f, &basis(order_of(f.len()), direction))
}

/// Σ f_i g_i, the integral of the product of both functions.
///
/// # Panics
/// If the lengths differ.
pub fn dot(f: &[f64], g: &[f64]) -> f64 {
    assert_eq!(f.len(), g.len(), "two SH vectors of different order");
    f.iter().zip(g).map(|(a, b)| a * b).sum()
}

/// √(f·f), the L2 norm of the function over the sphere.
pub fn norm(f: &[f64]) -> f64 {
    dot(f, f).sqrt()
}

/// ‖f − g‖, the L2 norm of the difference of both functions.
///
/// # Panics
/// If the lengths differ.
pub fn distance(f: &[f64], g: &[f64]) -> f64 {
    assert_eq!(f.len(), g.len(), "two SH vectors of different order");
    f.iter()
        .zip(g)
        .map(|(a, b)| (a - b).powi(2))
        .sum::<f64>()
        .sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quadrature::Rule;
    use crate::testing::{assert_close, directions};

    #[test]
    fn first_band_is_y_z_x() {
        let k = (3.0 / (4.0 * PI)).sqrt();
        for [x, y, z] in directions(20) {
            let values = basis(2, [x, y, z]);
            assert_close(&values, &[(0.25 / PI).sqrt(), k * y, k * z, k * x], 1e-15);
        }
    }

    #[test]
    fn second_band_is_its_polynomials() {
        let k = (15.0 / (4.0 * PI)).sqrt();
        for [x, y, z] in directions(20) {
            let zonal = (5.0 / (16.0 * PI)).sqrt() * (3.0 * z * z - 1.0);
            let expected = [
                k * x * y,
                k * y * z,
                zonal,
                k * x * z,
                0.5 * k * (x * x - y * y),
            ];
            assert_close(&basis(3, [x, y, z])[4..], &expected, 1e-15);
        }
    }

    #[test]
    fn derivative_is_the_slope_of_the_basis() {
        let h = 1e-3;
        for (i, s) in directions(30)
            .into_iter()
            .chain([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]])
            .enumerate()
        {
            let [u, v] = crate::vec3::frame(s);
            let (sin, cos) = (i as f64).sin_cos();
            let t = [0, 1, 2].map(|c| cos * u[c] + sin * v[c]);
            // Values along the great circle; the five-point difference is off by h⁴/30 of the fifth derivative,
            // which is 8⁵ times a value at most.
            let at = |a: f64| {
                basis(
                    9,
                    [0, 1, 2].map(|c| (a * h).cos() * s[c] + (a * h).sin() * t[c]),
                )
            };
            let [a, b, c, d] = [at(-2.0), at(-1.0), at(1.0), at(2.0)];
            let slope: Vec<f64> = (0..81)
                .map(|i| (a[i] - 8.0 * b[i] + 8.0 * c[i] - d[i]) / (12.0 * h))
                .collect();
            assert_close(&derivative(9, s, t), &slope, 3e-9);
        }
    }

    #[test]
    fn orthonormal_up_to_order_12() {
        let order = 12;
        let count = order * order;
        let mut gram = vec![0.0; count * count];
        for (direction, weight) in Rule::sphere(2 * (order - 1)).nodes() {
            let y = basis(order, direction);
            for i in 0..count {
                for j in 0..count {
                    gram[i * count + j] += weight * y[i] * y[j];
                }
            }
        }
        for i in 0..count {
            for j in 0..count {
                let expected = if i == j { 1.0 } else { 0.0 };
                assert!((gram[i * count + j] - expected).abs() < 1e-13, "{i}, {j}");
            }
        }
    }

    #[test]
    fn addition_theorem_up_to_order_14() {
        // Σ_m y_lm² = (2l+1)/4π in every direction.
        for direction in directions(30)
            .into_iter()
            .chain([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]])
        {
            let y = basis(14, direction);
            for l in 0..14 {
                let sum: f64 = y[l * l..(l + 1) * (l + 1)].iter().map(|v| v * v).sum();
                let expected = (2 * l + 1) as f64 / (4.0 * PI);
                assert!(
                    (sum / expected - 1.0).abs() < 1e-13,
                    "band {l}: {sum} instead of {expected}"
                );
            }
        }
    }

    #[test]
    fn indices_and_bands() {
        let all: Vec<usize> = (0..6)
            .flat_map(|l| (-(l as isize)..=l as isize).map(move |m| index(l, m)))
            .collect();
        assert_eq!(all, (0..36).collect::<Vec<_>>());
        assert_eq!([0, 1, 3, 4, 8, 9, 35].map(band), [0, 1, 1, 2, 2, 3, 5]);
    }

    #[test]
    #[should_panic(expected = "not 5")]
    fn five_coefficients_are_no_vector() {
        evaluate(&[0.0; 5], [0.0, 0.0, 1.0]);
    }
}
