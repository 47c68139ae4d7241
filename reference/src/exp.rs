//! The SH exponential: exact, and by the approximations of section 4 of Ren 2006 in plain f64.
//!
//! | function | is | equation |
//! |---|---|---|
//! | [`exact`], [`by_quadrature`] | ∫ exp(f(s)) y(s) ds | 10 |
//! | [`series`] | PS-p: 1 + f + f²∗/2 + … with products truncated to order n | 17 |
//! | [`ps_star`] | PS*-p: DC isolation, scaling and squaring, factored series | 19–22 |
//! | [`hyb`] | HYB: DC isolation, scaling and squaring, a·1 + b·f̂ | 21, 23 |
//!
//! The series approximate the *product exponential*, which truncates after every product and so differs from
//! [`exact`] even with infinitely many terms; both differences are what accuracy tables should report.

use crate::basis::{evaluate, norm, order_of};
use crate::product::{one, product, square};
use crate::quadrature::{Estimate, Rule, accumulate, project_smooth};
use std::f64::consts::PI;

/// ∫ exp(f(s)) y(s) ds on a rule of the given degree: exact for as many terms of the power series as have
/// degree ≤ `degree`, that is up to f^k with (k+1)(n−1) ≤ degree.
pub fn by_quadrature(f: &[f64], degree: usize) -> Vec<f64> {
    Rule::sphere(degree).project(order_of(f.len()), |s| evaluate(f, s).exp())
}

/// ∫ exp(f(s)) y(s) ds with the degree doubled until nothing changes any more (relative 1e-13). The error
/// it returns is an overestimate; it stays large only where f spans hundreds of e-foldings.
///
/// ```
/// use sh_reference::{exp, product::one};
/// let exact = exp::exact(&one(3));
/// assert!((exact.coefficients[0] - std::f64::consts::E * one(3)[0]).abs() < 1e-13);
/// ```
pub fn exact(f: &[f64]) -> Estimate {
    project_smooth(order_of(f.len()), 1e-13, |s| evaluate(f, s).exp())
}

/// PS-p, the plain product series (eq. 17) with terms up to degree `p`, amassed from left to right.
///
/// ```
/// let f = [0.1, 0.0, 0.2, 0.0];
/// let two_terms = sh_reference::exp::series(&f, 1);
/// assert_eq!(two_terms[2], 0.2);
/// ```
pub fn series(f: &[f64], p: usize) -> Vec<f64> {
    let mut sum = one(order_of(f.len()));
    let mut term = sum.clone();
    for k in 1..=p {
        term = if k == 1 {
            f.to_vec()
        } else {
            product(&term, f)
        };
        term.iter_mut().for_each(|c| *c /= k as f64);
        accumulate(&mut sum, 1.0, &term);
    }
    sum
}

/// The product series up to degree `p` with even and odd powers apart (eq. 22):
/// (1 + f²∗/2! + f⁴∗/4! + …) + f ∗ (1 + f²∗/3! + f⁴∗/5! + …), powers f⁴∗ = f²∗ ∗ f²∗, f⁶∗ = f⁴∗ ∗ f²∗, ….
pub fn factored(f: &[f64], p: usize) -> Vec<f64> {
    let order = order_of(f.len());
    let (mut even, mut odd) = (vec![0.0; f.len()], vec![0.0; f.len()]);
    let mut power = one(order);
    let mut squared = None;
    let mut factorial = 1.0;
    for k in (0..=p).step_by(2) {
        if k > 0 {
            let squared: &Vec<f64> = squared.get_or_insert_with(|| square(f));
            power = if k == 2 {
                squared.clone()
            } else {
                product(&power, squared)
            };
            factorial *= (k * (k - 1)) as f64;
        }
        accumulate(&mut even, 1.0 / factorial, &power);
        if k < p {
            accumulate(&mut odd, 1.0 / (factorial * (k + 1) as f64), &power);
        }
    }
    if p > 0 {
        accumulate(&mut even, 1.0, &product(f, &odd));
    }
    even
}

/// f without its mean: f̂ of eq. 19.
pub fn without_mean(f: &[f64]) -> Vec<f64> {
    let mut rest = f.to_vec();
    rest[0] = 0.0;
    rest
}

/// How often [`ps_star`] halves f̂ and squares the result: max(0, ⌊log₂ ‖f̂‖⌋ + 3), for the vector after DC
/// isolation, without the upper limit of 3 that the paper found enough for its scenes.
///
/// ```
/// assert_eq!(sh_reference::exp::squarings(&[100.0, 0.0, 1.0, 0.0]), 3);
/// assert_eq!(sh_reference::exp::squarings(&[100.0, 0.0, 0.1, 0.0]), 0);
/// ```
pub fn squarings(f: &[f64]) -> u32 {
    let norm = norm(&without_mean(f));
    if norm > 0.0 {
        // 1026 is what the largest finite norm gives; more would only be an overflow squared again.
        (norm.log2().floor() + 3.0).clamp(0.0, 1026.0) as u32
    } else {
        0
    }
}

/// PS*-p: exp(f₀/√4π) · (factored series of degree `p` of f̂/2^k, squared k times), k = [`squarings`]
/// (eq. 20, 21, 22).
///
/// ```
/// let f = [-1.0, 0.0, -0.5, 0.0];
/// let close = sh_reference::exp::ps_star(&f, 8);
/// assert!((close[0] - sh_reference::exp::exact(&f).coefficients[0]).abs() < 0.01);
/// ```
pub fn ps_star(f: &[f64], p: usize) -> Vec<f64> {
    scaled(f, squarings(f), |reduced| factored(reduced, p))
}

/// HYB: exp(f₀/√4π) · (a·1 + b·f̂/2^k, squared `k` times), with `(a, b) = coefficients(‖f̂/2^k‖)` (eq. 21,
/// 23). The paper tabulates a and b by the norm; see [`fit_linear`].
pub fn hyb(f: &[f64], k: u32, coefficients: impl Fn(f64) -> (f64, f64)) -> Vec<f64> {
    scaled(f, k, |reduced| {
        let (a, b) = coefficients(norm(reduced));
        let mut sum = vec![0.0; f.len()];
        accumulate(&mut sum, a, &one(order_of(f.len())));
        accumulate(&mut sum, b, reduced);
        sum
    })
}

/// DC isolation and scaling/squaring around any approximation for short vectors.
fn scaled(f: &[f64], k: u32, approximate: impl Fn(&[f64]) -> Vec<f64>) -> Vec<f64> {
    let reduced: Vec<f64> = without_mean(f)
        .iter()
        .map(|c| c * 0.5f64.powi(k as i32))
        .collect();
    let mut g = approximate(&reduced);
    for _ in 0..k {
        g = square(&g);
    }
    let mean = (f[0] / (4.0 * PI).sqrt()).exp();
    g.iter().map(|c| mean * c).collect()
}

/// The pair (a, b) for which a·1 + b·f̂ is nearest to ĝ = exp(−f₀/√4π)·g, given a vector `g` and its logarithm
/// `f` (eq. 24). `b` is 0 where f̂ is.
pub fn fit_linear(g: &[f64], f: &[f64]) -> (f64, f64) {
    let shrink = (-f[0] / (4.0 * PI).sqrt()).exp();
    let rest = without_mean(f);
    let squared = norm(&rest).powi(2);
    let b = if squared > 0.0 {
        shrink * crate::basis::dot(g, &rest) / squared
    } else {
        0.0
    };
    (shrink * g[0] / (4.0 * PI).sqrt(), b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::basis::distance;
    use crate::testing::{assert_close, numbers};
    use crate::{cap, log, zonal};

    fn vector(seed: u64, order: usize, size: f64) -> Vec<f64> {
        let f = numbers(seed, order * order);
        let k = size / norm(&f);
        f.iter().map(|c| k * c).collect()
    }

    #[test]
    fn a_constant() {
        for value in [-3.0f64, 0.0, 1.5] {
            let f: Vec<f64> = one(4).iter().map(|c| value * c).collect();
            let expected: Vec<f64> = one(4).iter().map(|c| value.exp() * c).collect();
            assert_close(&exact(&f).coefficients, &expected, 1e-12);
            assert_close(&ps_star(&f, 2), &expected, 1e-12);
            assert_close(&series(&f, 40), &expected, 1e-12);
            assert_close(&hyb(&f, 2, |_| (1.0, 1.0)), &expected, 1e-12);
        }
    }

    #[test]
    fn a_linear_function_has_a_closed_form() {
        // exp(k z): the mean is sinh(k)/k, and the mean of z exp(k z) is cosh(k)/k - sinh(k)/k².
        let k = 2.5f64;
        let y1 = (3.0 / (4.0 * PI)).sqrt();
        let found = exact(&[0.0, 0.0, k / y1, 0.0]);
        let mean = k.sinh() / k;
        let first = k.cosh() / k - k.sinh() / (k * k);
        let expected = [(4.0 * PI).sqrt() * mean, 0.0, 4.0 * PI * y1 * first, 0.0];
        assert_close(&found.coefficients, &expected, 1e-12);
        assert!(found.error < 1e-10);
    }

    #[test]
    fn quadrature_of_known_degree() {
        let f = vector(1, 4, 1.5);
        let found = by_quadrature(&f, 60);
        assert_close(&found, &exact(&f).coefficients, 1e-12);
        let low = by_quadrature(&f, 6);
        assert!(
            (low[3] - found[3]).abs() > 1e-9,
            "too low a degree must show"
        );
    }

    #[test]
    fn series_written_out() {
        let f = vector(2, 4, 1.0);
        let f2 = product(&f, &f);
        let f3 = product(&f2, &f);
        let f4 = product(&f2, &f2);
        let one = one(4);
        let plain: Vec<f64> = (0..16)
            .map(|i| one[i] + f[i] + f2[i] / 2.0 + f3[i] / 6.0)
            .collect();
        assert_close(&series(&f, 3), &plain, 1e-14);
        // In eq. 22 the odd part of degree 5 is f ∗ (1 + f²/6 + f⁴/120).
        let odd: Vec<f64> = (0..16)
            .map(|i| one[i] + f2[i] / 6.0 + f4[i] / 120.0)
            .collect();
        let odd = product(&f, &odd);
        let five: Vec<f64> = (0..16)
            .map(|i| one[i] + f2[i] / 2.0 + f4[i] / 24.0 + odd[i])
            .collect();
        assert_close(&factored(&f, 5), &five, 1e-14);
        assert_close(&factored(&f, 1), &series(&f, 1), 1e-14);
        assert_close(&factored(&f, 2), &series(&f, 2), 1e-14);
        assert_close(&factored(&f, 3), &plain, 1e-14);
        assert_eq!(factored(&f, 0), one);
    }

    #[test]
    fn squarings_follow_the_norm_without_the_mean() {
        let by_norm = |norm: f64| squarings(&[1e9, norm, 0.0, 0.0]);
        assert_eq!(
            [0.0, 0.124, 0.126, 0.25, 0.5, 1.0, 4.8, 1000.0].map(by_norm),
            [0, 0, 0, 1, 2, 3, 5, 12]
        );
    }

    #[test]
    fn approximations_approach_the_exact_one_for_short_vectors() {
        for order in [2, 4, 6] {
            let f = vector(3, order, 0.1);
            let exact = exact(&f).coefficients;
            // Terms from degree 3 on suffer truncation; f³/6 and all after are below 1e-4 here.
            assert_close(&series(&f, 8), &exact, 2e-4);
            assert_close(&ps_star(&f, 8), &exact, 2e-4);
            assert_close(&series(&f, 2), &exact, 2e-4);
        }
    }

    #[test]
    fn no_overflow_for_deep_shadow() {
        let f = vector(4, 4, 300.0);
        assert!(ps_star(&f, 2).iter().all(|c| c.is_finite()));
        let mut dark = f.clone();
        dark[0] = -1e4;
        assert!(norm(&ps_star(&dark, 2)) < 1e-300);
    }

    #[test]
    fn fitted_pair_is_the_best_one() {
        let g = zonal::upright(&cap::visibility(4, 0.5));
        let f = log::eigen(&g, log::CLIP).unwrap();
        let (a, b) = fit_linear(&g, &f);
        let off = |a: f64, b: f64| {
            let found = hyb(&f, 0, |_| (a, b));
            distance(&found, &g)
        };
        let best = off(a, b);
        assert!(best < 0.1 * norm(&g));
        for (da, db) in [(1e-3, 0.0), (-1e-3, 0.0), (0.0, 1e-3), (0.0, -1e-3)] {
            assert!(off(a + da, b + db) > best);
        }
    }
}
