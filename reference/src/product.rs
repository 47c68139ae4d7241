//! Products of SH vectors, by sampling both functions and projecting what their product is.
//!
//! (f∗g)_i = ∫ f(s) g(s) y_i(s) ds = Σ_jk Γ_ijk f_j g_k, Γ_ijk = ∫ y_i y_j y_k ds (eq. 3, 4 of Ren 2006).
//! All integrands are polynomials of degree ≤ 3(n−1), so the rules are exact: errors are rounding, some
//! 1e-15·|f||g| per coefficient. The product of two order n functions has order 2n − 1; projecting it to
//! order n again cuts that off, which makes the product commutative but not associative.

use crate::basis::{basis, dot, evaluate, order_of};
use crate::quadrature::Rule;
use std::f64::consts::PI;

/// The vector of the constant function 1, (√4π, 0, 0, …): neutral for the product.
pub fn one(order: usize) -> Vec<f64> {
    let mut one = vec![0.0; order * order];
    one[0] = (4.0 * PI).sqrt();
    one
}

/// The tensor Γ_ijk of one order: `order⁶` numbers, symmetric in all three indices, mostly 0.
#[derive(Clone, Debug)]
pub struct Gaunt {
    count: usize,
    entries: Vec<f64>,
}

impl Gaunt {
    /// Computes all entries. Error at most 1e-14; entries that are 0 come out as less than 1e-15.
    ///
    /// ```
    /// let gaunt = sh_reference::product::Gaunt::new(2);
    /// assert!((gaunt.get(0, 3, 3) - 0.5 / std::f64::consts::PI.sqrt()).abs() < 1e-15);
    /// ```
    pub fn new(order: usize) -> Self {
        let count = order * order;
        let mut entries = vec![0.0; count * count * count];
        for (direction, weight) in Rule::sphere(3 * (order - 1)).nodes() {
            let y = basis(order, direction);
            for i in 0..count {
                for j in 0..=i {
                    for k in 0..=j {
                        entries[(i * count + j) * count + k] += weight * y[i] * y[j] * y[k];
                    }
                }
            }
        }
        Gaunt { count, entries }
    }

    /// Γ_ijk.
    ///
    /// # Panics
    /// If an index is `order²` or more.
    pub fn get(&self, i: usize, j: usize, k: usize) -> f64 {
        let mut indices = [i, j, k];
        indices.sort_unstable();
        let [k, j, i] = indices;
        assert!(
            i < self.count,
            "index {i} of a tensor over {} functions",
            self.count
        );
        self.entries[(i * self.count + j) * self.count + k]
    }

    /// How many of the `order⁶` entries are not 0 (that is, above 1e-13).
    pub fn nonzero(&self) -> usize {
        let all = 0..self.count;
        all.clone()
            .map(|i| {
                let row = |j| {
                    all.clone()
                        .filter(|&k| self.get(i, j, k).abs() > 1e-13)
                        .count()
                };
                all.clone().map(row).sum::<usize>()
            })
            .sum()
    }
}

/// f∗g (eq. 3).
///
/// ```
/// use sh_reference::{basis::basis, product::*};
/// let (f, g) = (basis(3, [0.6, 0.0, 0.8]), basis(3, [0.0, 1.0, 0.0]));
/// assert!((product(&f, &g)[5] - product(&g, &f)[5]).abs() < 1e-15);
/// ```
///
/// # Panics
/// If the orders differ.
pub fn product(f: &[f64], g: &[f64]) -> Vec<f64> {
    assert_eq!(
        f.len(),
        g.len(),
        "a product of two SH vectors of different order"
    );
    product_to(order_of(f.len()), f, g)
}

/// The product of two vectors of any orders, projected to a third: with `order` = (order of f) + (order of
/// g) − 1 nothing is cut off.
pub fn product_to(order: usize, f: &[f64], g: &[f64]) -> Vec<f64> {
    let degree = order_of(f.len()) + order_of(g.len()) + order - 3;
    Rule::sphere(degree).project(order, |s| evaluate(f, s) * evaluate(g, s))
}

/// f∗f.
pub fn square(f: &[f64]) -> Vec<f64> {
    let order = order_of(f.len());
    Rule::sphere(3 * (order - 1)).project(order, |s| evaluate(f, s).powi(2))
}

/// (a, b, c) = ∫ a(s) b(s) c(s) ds, for vectors of any orders.
pub fn triple(a: &[f64], b: &[f64], c: &[f64]) -> f64 {
    let degree = order_of(a.len()) + order_of(b.len()) + order_of(c.len()) - 3;
    Rule::sphere(degree).integrate(|s| evaluate(a, s) * evaluate(b, s) * evaluate(c, s))
}

/// The product matrix M_f (eq. 5), dense, row by row: M_f g = f∗g. Symmetric bit by bit.
pub fn product_matrix(f: &[f64]) -> Vec<f64> {
    let order = order_of(f.len());
    let count = f.len();
    let mut matrix = vec![0.0; count * count];
    for (direction, weight) in Rule::sphere(3 * (order - 1)).nodes() {
        let y = basis(order, direction);
        let weighted = weight * dot(f, &y);
        for i in 0..count {
            for j in 0..count {
                matrix[i * count + j] += weighted * (y[i] * y[j]);
            }
        }
    }
    matrix
}

/// A square matrix, row by row, times a vector.
pub fn matrix_apply(matrix: &[f64], g: &[f64]) -> Vec<f64> {
    assert_eq!(
        matrix.len(),
        g.len() * g.len(),
        "a matrix and a vector of different size"
    );
    matrix.chunks(g.len()).map(|row| dot(row, g)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{assert_close, numbers};

    #[test]
    fn as_many_entries_as_are_known_not_to_vanish() {
        let found = [2, 3, 4, 5, 6].map(|order| Gaunt::new(order).nonzero());
        assert_eq!(found, [10, 83, 353, 1158, 2907]);
    }

    #[test]
    fn entries_with_closed_forms() {
        let gaunt = Gaunt::new(3);
        let y0 = (0.25 / PI).sqrt();
        for i in 0..9 {
            for j in 0..9 {
                assert!((gaunt.get(0, i, j) - if i == j { y0 } else { 0.0 }).abs() < 1e-15);
            }
        }
        // ∫ y_10 y_10 y_20 = √(3/4π)² √(5/16π) · 2π ∫ z² (3z² - 1) dz.
        let expected =
            3.0 / (4.0 * PI) * (5.0 / (16.0 * PI)).sqrt() * 2.0 * PI * (6.0 / 5.0 - 2.0 / 3.0);
        assert!((gaunt.get(2, 6, 2) - expected).abs() < 1e-15);
        // ∫ y_1,-1 y_11 y_2,-2 = (3/4π) √(15/4π) ∫ x² y² = (3/4π) √(15/4π) 4π/15.
        let expected = 3.0 / (4.0 * PI) * (15.0 / (4.0 * PI)).sqrt() * 4.0 * PI / 15.0;
        assert!((gaunt.get(4, 1, 3) - expected).abs() < 1e-15);
    }

    #[test]
    fn product_is_the_tensors() {
        for order in [2, 3, 4, 5] {
            let gaunt = Gaunt::new(order);
            let count = order * order;
            let (f, g) = (numbers(1, count), numbers(2, count));
            let expected: Vec<f64> = (0..count)
                .map(|i| {
                    let row = |j: usize| {
                        (0..count)
                            .map(|k| gaunt.get(i, j, k) * f[j] * g[k])
                            .sum::<f64>()
                    };
                    (0..count).map(row).sum()
                })
                .collect();
            assert_close(&product(&f, &g), &expected, 1e-13);
            assert!((triple(&f, &g, &f) - dot(&expected, &f)).abs() < 1e-12);
        }
    }

    #[test]
    fn one_is_neutral_and_squares_are_products() {
        for order in [1, 2, 4, 6, 8] {
            let f = numbers(order as u64, order * order);
            assert_close(&product(&f, &one(order)), &f, 1e-13);
            assert_close(&square(&f), &product(&f, &f), 1e-13);
        }
    }

    #[test]
    fn matrix_is_the_product() {
        for order in [2, 4, 6] {
            let count = order * order;
            let (f, g) = (numbers(3, count), numbers(4, count));
            let matrix = product_matrix(&f);
            assert_close(&matrix_apply(&matrix, &g), &product(&f, &g), 1e-13);
            for i in 0..count {
                for j in 0..count {
                    assert_eq!(matrix[i * count + j], matrix[j * count + i]);
                }
            }
        }
    }

    #[test]
    fn the_whole_product_multiplies_values() {
        let (f, g) = (numbers(5, 9), numbers(6, 16));
        let whole = product_to(6, &f, &g);
        for s in crate::testing::directions(20) {
            assert!((evaluate(&whole, s) - evaluate(&f, s) * evaluate(&g, s)).abs() < 1e-13);
        }
    }
}
