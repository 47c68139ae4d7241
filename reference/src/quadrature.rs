//! Integrals over the sphere: Gauss–Legendre in height times the trapezoid rule in azimuth.
//!
//! About any axis, a polynomial of degree d in (x, y, z) is a polynomial of degree ≤ d in the height z and
//! a trigonometric one of degree ≤ d in azimuth. ⌈(d+1)/2⌉ Gauss–Legendre heights integrate the first
//! exactly and d + 1 equidistant azimuths the second (Atkinson & Han, "Spherical Harmonics and
//! Approximations on the Unit Sphere", section 5.1; every odd power of sin θ comes with an azimuthal factor
//! whose sum is 0). Heights need not run from −1 to 1: [`Rule::zone`] is exact on a slice of the sphere,
//! so a function with an edge at constant height is integrated piece by piece.

use crate::basis::{basis, distance, norm};
use crate::vec3::{add, frame, scale};
use std::f64::consts::{PI, TAU};

/// Nodes and weights of Gauss–Legendre quadrature on `from..to`, ascending; exact for polynomials up to
/// degree `2·count − 1`. Nodes by Newton's method from Chebyshev's approximation, to rounding.
///
/// ```
/// let area: f64 = sh_reference::quadrature::gauss_legendre(3, 0.0, 2.0).iter().map(|(x, w)| w * x.powi(5)).sum();
/// assert!((area - 64.0 / 6.0).abs() < 1e-13);
/// ```
pub fn gauss_legendre(count: usize, from: f64, to: f64) -> Vec<(f64, f64)> {
    let (center, half) = (0.5 * (from + to), 0.5 * (to - from));
    (0..count)
        .rev()
        .map(|i| {
            let mut x = (PI * (i as f64 + 0.75) / (count as f64 + 0.5)).cos();
            // Converges quadratically; the start is good to a few digits.
            for _ in 0..8 {
                let (p, derivative) = legendre(count, x);
                x -= p / derivative;
            }
            let (_, derivative) = legendre(count, x);
            (
                center + half * x,
                half * 2.0 / ((1.0 - x * x) * derivative * derivative),
            )
        })
        .collect()
}

/// P_n(x) and its derivative, for |x| < 1.
fn legendre(n: usize, x: f64) -> (f64, f64) {
    let (mut before, mut p) = (0.0, 1.0);
    for k in 1..=n {
        (before, p) = (
            p,
            ((2 * k - 1) as f64 * x * p - (k - 1) as f64 * before) / k as f64,
        );
    }
    (p, n as f64 * (before - x * p) / (1.0 - x * x))
}

/// Directions and weights (in steradians) whose weighted sum is an integral over the sphere or a zone.
#[derive(Clone, Debug, PartialEq)]
pub struct Rule {
    /// Unit vectors.
    pub directions: Vec<[f64; 3]>,
    /// As many, positive, in steradians.
    pub weights: Vec<f64>,
}

impl Rule {
    /// Exact over the whole sphere for polynomials up to `degree` in the direction's coordinates. The
    /// product of vectors of orders a, b, … has degree (a−1) + (b−1) + ….
    ///
    /// ```
    /// use sh_reference::quadrature::Rule;
    /// let mean = Rule::sphere(4).integrate(|[x, y, _]| x * x * y * y) / (4.0 * std::f64::consts::PI);
    /// assert!((mean - 1.0 / 15.0).abs() < 1e-15);
    /// ```
    pub fn sphere(degree: usize) -> Self {
        Self::zone([0.0, 0.0, 1.0], -1.0, 1.0, degree)
    }

    /// Exact for polynomials up to `degree` over the half of the sphere around the unit vector `axis`.
    pub fn hemisphere(axis: [f64; 3], degree: usize) -> Self {
        Self::zone(axis, 0.0, 1.0, degree)
    }

    /// Exact for polynomials up to `degree` over the directions whose cosine with the unit vector `axis`
    /// lies in `from..to`.
    pub fn zone(axis: [f64; 3], from: f64, to: f64, degree: usize) -> Self {
        let [u, v] = frame(axis);
        let azimuths = degree + 1;
        let mut rule = Rule {
            directions: Vec::new(),
            weights: Vec::new(),
        };
        for (height, weight) in gauss_legendre(degree / 2 + 1, from, to) {
            let radius = ((1.0 - height) * (1.0 + height)).sqrt();
            for k in 0..azimuths {
                let (sin, cos) = (TAU * (k as f64 + 0.5) / azimuths as f64).sin_cos();
                let aside = add(scale(u, radius * cos), scale(v, radius * sin));
                rule.directions.push(add(scale(axis, height), aside));
                rule.weights.push(weight * TAU / azimuths as f64);
            }
        }
        rule
    }

    /// Direction and weight, one node after the other.
    pub fn nodes(&self) -> impl Iterator<Item = ([f64; 3], f64)> {
        self.directions
            .iter()
            .copied()
            .zip(self.weights.iter().copied())
    }

    /// The sum that stands for ∫ f(s) ds.
    pub fn integrate(&self, mut f: impl FnMut([f64; 3]) -> f64) -> f64 {
        self.nodes()
            .map(|(direction, weight)| weight * f(direction))
            .sum()
    }

    /// The SH vector of a function, ∫ f(s) y(s) ds (eq. 1 of Ren 2006). Exact if `f` is a polynomial and
    /// the rule's degree is at least its degree plus `order − 1`.
    pub fn project(&self, order: usize, mut f: impl FnMut([f64; 3]) -> f64) -> Vec<f64> {
        let mut sum = vec![0.0; order * order];
        for (direction, weight) in self.nodes() {
            accumulate(&mut sum, weight * f(direction), &basis(order, direction));
        }
        sum
    }
}

/// `sum += k · y`.
pub(crate) fn accumulate(sum: &mut [f64], k: f64, y: &[f64]) {
    for (sum, y) in sum.iter_mut().zip(y) {
        *sum += k * y;
    }
}

/// An SH vector found by quadrature, and how far from the truth it may be.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// `order²` coefficients.
    pub coefficients: Vec<f64>,
    /// L2 norm of the error: of the vector, so at least that of every coefficient. What it is (a bound, or
    /// an estimate) the function that returned it says.
    pub error: f64,
}

/// Projection of a smooth function that is no polynomial. The degree doubles from `4·order` until two
/// successive vectors differ by at most `tolerance` times their norm, or the degree would pass 1024.
///
/// `error` is that last difference: far above the truth for analytic functions, whose error drops faster
/// than geometrically with the degree, and honest for others.
///
/// ```
/// let smooth = sh_reference::quadrature::project_smooth(3, 1e-12, |[x, _, _]| (2.0 * x).exp());
/// let mean = 2f64.sinh() / 2.0;
/// assert!((smooth.coefficients[0] - mean * (4.0 * std::f64::consts::PI).sqrt()).abs() < 1e-12);
/// ```
pub fn project_smooth(
    order: usize,
    tolerance: f64,
    mut f: impl FnMut([f64; 3]) -> f64,
) -> Estimate {
    let mut degree = 4 * order;
    let mut coefficients = Rule::sphere(degree).project(order, &mut f);
    loop {
        degree *= 2;
        let finer = Rule::sphere(degree).project(order, &mut f);
        let error = distance(&finer, &coefficients);
        coefficients = finer;
        if error <= tolerance * norm(&coefficients) || degree > 512 {
            return Estimate {
                coefficients,
                error,
            };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{assert_close, numbers};
    use crate::vec3::normalize;

    #[test]
    fn gauss_legendre_with_three_nodes_is_the_known_one() {
        let nodes = gauss_legendre(3, -1.0, 1.0);
        let (x, w): (Vec<f64>, Vec<f64>) = nodes.into_iter().unzip();
        assert_close(&x, &[-0.6f64.sqrt(), 0.0, 0.6f64.sqrt()], 1e-15);
        assert_close(&w, &[5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0], 1e-15);
    }

    #[test]
    fn gauss_legendre_is_exact_to_its_degree_and_no_further() {
        for count in [1, 2, 5, 16, 40] {
            let power = |p: i32| -> f64 {
                gauss_legendre(count, 0.0, 1.0)
                    .iter()
                    .map(|(x, w)| w * x.powi(p))
                    .sum()
            };
            let degree = 2 * count as i32 - 1;
            for p in 0..=degree {
                assert!(
                    (power(p) - 1.0 / (p + 1) as f64).abs() < 1e-14,
                    "{count} nodes, degree {p}"
                );
            }
            if count < 6 {
                assert!((power(degree + 1) - 1.0 / (degree + 2) as f64).abs() > 1e-9);
            }
        }
    }

    /// ∫ x^a y^b z^c over the sphere: 2 Γ((a+1)/2) Γ((b+1)/2) Γ((c+1)/2) / Γ((a+b+c+3)/2) for even powers
    /// (Folland, "How to integrate a polynomial over a sphere", 2001), written with double factorials.
    fn monomial(a: i32, b: i32, c: i32) -> f64 {
        let odd = |n: i32| -> f64 { (1..n).step_by(2).map(f64::from).product() };
        if a % 2 + b % 2 + c % 2 > 0 {
            0.0
        } else {
            4.0 * PI * odd(a) * odd(b) * odd(c) / odd(a + b + c + 2)
        }
    }

    #[test]
    fn sphere_is_exact_for_every_monomial() {
        for degree in 0..=12 {
            let rule = Rule::sphere(degree);
            let total = degree as i32;
            for a in 0..=total {
                for b in 0..=total - a {
                    for c in 0..=total - a - b {
                        let found = rule.integrate(|[x, y, z]| x.powi(a) * y.powi(b) * z.powi(c));
                        assert!(
                            (found - monomial(a, b, c)).abs() < 1e-13,
                            "degree {degree}: {a} {b} {c}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn zones_about_any_axis_make_up_the_sphere() {
        let axis = normalize([0.3, -0.8, 0.5]);
        let f = |[x, y, z]: [f64; 3]| (1.0 + x - 2.0 * y * y) * z * z + x.powi(3) * y;
        let parts = [(-1.0, -0.2), (-0.2, 0.7), (0.7, 1.0)]
            .map(|(a, b)| Rule::zone(axis, a, b, 4).integrate(f));
        assert!((parts.iter().sum::<f64>() - Rule::sphere(4).integrate(f)).abs() < 1e-14);
        assert!((Rule::hemisphere(axis, 0).integrate(|_| 1.0) - TAU).abs() < 1e-14);
    }

    #[test]
    fn projection_of_a_band_limited_function_returns_it() {
        for order in [1, 2, 4, 6, 9] {
            let f = numbers(order as u64, order * order);
            let found =
                Rule::sphere(2 * (order - 1)).project(order, |s| crate::basis::evaluate(&f, s));
            assert_close(&found, &f, 1e-13);
        }
    }

    #[test]
    fn smooth_projection_says_when_it_does_not_converge() {
        let step = project_smooth(2, 1e-12, |[_, _, z]| if z > 0.1234 { 1.0 } else { 0.0 });
        // ∫ over the cap is 2π(1 - 0.1234), and y_0 = 1/√4π.
        let truth = TAU * (1.0 - 0.1234) / (4.0 * PI).sqrt();
        let off = (step.coefficients[0] - truth).abs();
        assert!(
            off > 1e-6 && step.error > off / 4.0,
            "off by {off:e}, said {:e}",
            step.error
        );
    }
}
