//! Least squares, linear and not.

use nalgebra::{Cholesky, DMatrix, DVector};
use rayon::prelude::*;

/// Solves min ‖A x − b‖.
pub(super) fn least_squares(a: DMatrix<f64>, b: &DVector<f64>) -> Vec<f64> {
    let svd = a.svd(true, true);
    svd.solve(b, 1e-13)
        .expect("both sides of the decomposition were asked for")
        .as_slice()
        .to_vec()
}

/// Most steps of a fit.
const STEPS: usize = 60;

/// A step that gains less than this part of the sum is the last.
const GAIN: f64 = 1e-9;

/// How far a parameter is moved to see what it does.
const DIFFERENCE: f64 = 1e-6;

/// r_i of the parameters and i, written to the slice.
type Residual<'a> = &'a (dyn Fn(&[f64], usize, &mut [f64]) + Sync);

/// Minimises Σ_i w_i ‖r_i(x)‖² by Levenberg's and Marquardt's method (Moré 1978), from `x`, with derivatives by
/// differences. `residual(x, i)` writes r_i of `size` numbers. The sums run in a fixed order: the same result for
/// any number of threads. Gives back the last sum.
pub(super) fn minimise(x: &mut [f64], weights: &[f64], size: usize, residual: Residual<'_>) -> f64 {
    minimise_in(STEPS, x, weights, size, residual)
}

/// As [`minimise`], in at most so many steps.
pub(super) fn minimise_in(
    steps: usize,
    x: &mut [f64],
    weights: &[f64],
    size: usize,
    residual: Residual<'_>,
) -> f64 {
    let n = x.len();
    let sum = |x: &[f64]| -> f64 {
        let terms: Vec<f64> = (0..weights.len())
            .into_par_iter()
            .map(|i| {
                let mut r = vec![0.0; size];
                residual(x, i, &mut r);
                weights[i] * r.iter().map(|r| r * r).sum::<f64>()
            })
            .collect();
        terms.iter().sum()
    };
    let mut best = sum(x);
    let mut damping = 1e-3;
    for _ in 0..steps {
        // Normal equations, in blocks that are summed in order.
        let blocks: Vec<(DMatrix<f64>, DVector<f64>)> = (0..weights.len().div_ceil(64))
            .into_par_iter()
            .map(|block| {
                let range = 64 * block..weights.len().min(64 * (block + 1));
                let rows = range.len() * size;
                let mut jacobian = DMatrix::zeros(rows, n);
                let mut at = DVector::zeros(rows);
                for (slot, i) in range.clone().enumerate() {
                    residual(x, i, &mut at.as_mut_slice()[slot * size..(slot + 1) * size]);
                }
                let mut moved = x.to_vec();
                let mut r = vec![0.0; size];
                for k in 0..n {
                    let step = DIFFERENCE * x[k].abs().max(1.0);
                    moved[k] = x[k] + step;
                    for (slot, i) in range.clone().enumerate() {
                        residual(&moved, i, &mut r);
                        let root = weights[i].sqrt();
                        for (j, r) in r.iter().enumerate() {
                            let row = slot * size + j;
                            jacobian[(row, k)] = root * (r - at[row]) / step;
                        }
                    }
                    moved[k] = x[k];
                }
                for (slot, i) in range.enumerate() {
                    let root = weights[i].sqrt();
                    at.as_mut_slice()[slot * size..(slot + 1) * size]
                        .iter_mut()
                        .for_each(|r| *r *= root);
                }
                (jacobian.tr_mul(&jacobian), jacobian.tr_mul(&at))
            })
            .collect();
        let (mut normal, mut slope) = (DMatrix::zeros(n, n), DVector::zeros(n));
        for (m, v) in blocks {
            normal += m;
            slope += v;
        }
        let before = best;
        for _ in 0..10 {
            let mut damped = normal.clone();
            for k in 0..n {
                damped[(k, k)] += damping * (normal[(k, k)] + 1e-12);
            }
            let step = Cholesky::new(damped).map(|c| c.solve(&slope));
            let tried: Option<(Vec<f64>, f64)> = step.map(|step| {
                let to: Vec<f64> = x.iter().zip(step.iter()).map(|(x, s)| x - s).collect();
                let value = sum(&to);
                (to, value)
            });
            match tried {
                Some((to, value)) if value < best => {
                    x.copy_from_slice(&to);
                    best = value;
                    damping = (damping / 5.0).max(1e-9);
                    break;
                }
                _ => damping *= 4.0,
            }
        }
        if before - best <= GAIN * before {
            break;
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_the_parameters_that_made_the_data() {
        // y = a e^(b t), from a start far off.
        let data = |t: f64| 2.0 * (-1.5 * t).exp();
        let mut x = [0.5, 0.0];
        let weights = vec![1.0; 20];
        let left = minimise(&mut x, &weights, 1, &|x, i, r| {
            let t = i as f64 / 10.0;
            r[0] = x[0] * (x[1] * t).exp() - data(t);
        });
        assert!(left < 1e-15, "{left:e}");
        assert!(
            (x[0] - 2.0).abs() < 1e-7 && (x[1] + 1.5).abs() < 1e-7,
            "{x:?}"
        );
    }

    #[test]
    fn weights_count() {
        let mut x = [0.0];
        minimise(&mut x, &[1.0, 3.0], 1, &|x, i, r| r[0] = x[0] - i as f64);
        assert!((x[0] - 0.75).abs() < 1e-9);
    }
}
