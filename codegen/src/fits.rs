//! Fitted functions: polynomials whose coefficients are data, rewritten by `gaunt fit`.
//!
//! The files in `codegen/data/` hold one row of numbers a line; `#` starts a comment. They are compiled in,
//! so that nobody who builds this crate runs a fit.

use crate::expr::{Graph, Value};

const CAP_LOG: &str = include_str!("../data/cap_log.txt");
const CAP_LOG_TABLE: &str = include_str!("../data/cap_log_table.txt");
const OPTIMAL_LINEAR: &str = include_str!("../data/optimal_linear.txt");

/// The rows of a data file that start with `key`, without it.
fn rows(text: &str, key: usize) -> Vec<Vec<f64>> {
    text.lines()
        .filter_map(|line| line.split('#').next())
        .map(|line| {
            line.split_whitespace()
                .map(|word| {
                    word.parse()
                        .unwrap_or_else(|_| panic!("fitted data: `{word}` is no number"))
                })
                .collect::<Vec<f64>>()
        })
        .filter(|row| row.first() == Some(&(key as f64)))
        .map(|row| row[1..].to_vec())
        .collect()
}

/// Coefficients of the fitted cap logarithm: for each band, powers of u = 2 cos θ − 1, lowest first.
pub fn cap_log_coefficients(order: usize) -> Vec<Vec<f64>> {
    rows(CAP_LOG, order)
}

/// The eigen logarithm of a cap's visibility at every whole degree 0..=179: n zonal coefficients each.
pub fn cap_log_table(order: usize) -> Vec<Vec<f64>> {
    rows(CAP_LOG_TABLE, order)
}

/// Coefficients of a and b of the optimal linear exponential, powers of ‖f̂‖, lowest first.
pub fn optimal_linear_coefficients(order: usize) -> Vec<Vec<f64>> {
    rows(OPTIMAL_LINEAR, order)
}

/// `f_l(θ) = sin²θ · p_l(2 cos θ − 1)`: exactly 0 for θ = 0, and in proportion to the solid angle near it.
pub fn cap_log(g: &mut Graph, order: usize, sin: Value, cos: Value) -> Vec<Value> {
    bands(g, &cap_log_coefficients(order), sin, cos)
}

fn bands(g: &mut Graph, coefficients: &[Vec<f64>], sin: Value, cos: Value) -> Vec<Value> {
    let two = g.constant(2.0);
    let minus_one = g.constant(-1.0);
    let u = g.mul_add(two, cos, minus_one);
    let s2 = g.mul(sin, sin);
    coefficients
        .iter()
        .map(|c| {
            let p = g.horner(c, u);
            g.mul(s2, p)
        })
        .collect()
}

/// `f + zonal(cap_log(θ), d)`: what one blocker adds to a receiver's log visibility. The factors that turn a
/// zonal vector are multiplied into the fitted coefficients, and those of the basis stay with the basis.
pub fn add_cap_log(
    g: &mut Graph,
    order: usize,
    f: &[Value],
    sin: Value,
    cos: Value,
    d: &[Value],
) -> Vec<Value> {
    let mut coefficients = cap_log_coefficients(order);
    for (l, band) in coefficients.iter_mut().enumerate() {
        for c in band {
            *c *= crate::basis::turn(l).to_f64();
        }
    }
    let weights = bands(g, &coefficients, sin, cos);
    let y = crate::basis::basis(g, order, d);
    (0..order * order)
        .map(|i| g.mul_add(weights[i.isqrt()], y[i], f[i]))
        .collect()
}

/// `[a, b]` as polynomials in the norm.
pub fn optimal_linear(g: &mut Graph, order: usize, norm: Value) -> Vec<Value> {
    optimal_linear_coefficients(order)
        .iter()
        .map(|c| g.horner(c, norm))
        .collect()
}
