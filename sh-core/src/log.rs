//! The logarithm of a visibility vector, by eigenanalysis of its product matrix (feature `log`).
//!
//! Ren et al. 2006, section 5. With M_g = Rᵀ D R the product matrix of g,
//!
//! ```text
//! log(g) = Rᵀ q'(D) R (g − 1),     q'(x) = log(x)/(x − 1)          (eq. 30, 31)
//! ```
//!
//! inverts the product series of the exponential as far as it can be inverted. Eigenvalues are first
//! clipped to 0.02 of the largest (eq. 32): g is truncated, so M_g of a visibility may have eigenvalues at
//! or below zero. This is a preprocess: an eigenanalysis of an n² × n² matrix. [`Logarithm::exp`] is the product
//! series' limit by the same means (eq. 28).
//!
//! ```
//! use sh_core::{ROOT_FOUR_PI, Sh4d, cap, log::Logarithm};
//! // Two blockers side by side: their logarithms add up.
//! let past = |d| Sh4d::zonal(cap::visibility::<16>(0.5), d).0.log();
//! let (one, other) = (past([0.0, 0.6, 0.8]), past([0.0, 0.6, -0.8]));
//! let both = Sh4d::from(one) + Sh4d::from(other);
//! assert!(both.0.exp()[0] < one.exp()[0] && both.0.exp()[0] > 0.5 * ROOT_FOUR_PI);
//! ```

use crate::{ROOT_FOUR_PI, Routines, real};
use nalgebra::{SMatrix, SVector};

/// Eigenvalues below this part of the largest are raised to it.
///
/// Ren et al. 2006, eq. 32.
///
/// ```
/// use sh_core::{Sh2d, log::{CLIP, Logarithm}};
/// // Half dark: the least eigenvalue is clipped, and the logarithm stays finite.
/// let half = Sh2d::ONE * 0.5 + Sh2d::basis([0.0, 1.0, 0.0]) * 1.5;
/// assert!(half.0.log().iter().all(|c| c.is_finite() && c.abs() < -CLIP.ln() * 4.0));
/// ```
pub const CLIP: f64 = 0.02;

/// The least visibility that a logarithm is taken of.
const DARKEST: f64 = 1e-30;

/// An array of n² coefficients whose logarithm can be taken; implemented for orders 2 to 6.
///
/// ```
/// use sh_core::{Sh3d, log::Logarithm};
/// // The exponential takes the logarithm back, but for what both truncate.
/// let g = Sh3d::ONE * 0.7 + Sh3d::basis([0.0, 1.0, 0.0]) * 0.1;
/// assert!((Sh3d::from(g.0.log().exp()) - g).norm() < 1e-2);
/// ```
pub trait Logarithm: Routines<f64> {
    /// log(g). Finite for every finite g; a g whose product matrix has no positive eigenvalue (nothing is
    /// visible anywhere) gets the logarithm of 1e-30.
    ///
    /// ```
    /// use sh_core::{Sh4d, exp, log::Logarithm};
    /// let half = (Sh4d::ONE * 0.5).0.log();
    /// assert!((half[0] / Sh4d::ONE[0] - 0.5_f64.ln()).abs() < 1e-12);
    /// ```
    fn log(&self) -> Self;

    /// exp*(f) = 1 + Rᵀ q(D) R f with q(x) = (e^x − 1)/x, the limit of the product series (eq. 28, 29).
    ///
    /// ```
    /// use sh_core::{Sh4d, exp, log::Logarithm};
    /// let f = (Sh4d::basis([0.6, 0.0, 0.8]) * -0.2).0;
    /// let series = exp::product_series(&f, 24);
    /// assert!(f.exp().iter().zip(series).all(|(a, b)| (a - b).abs() < 1e-12));
    /// ```
    fn exp(&self) -> Self;
}

macro_rules! logarithm {
    ($($c:literal)*) => { $(
        impl Logarithm for [f64; $c] {
            fn log(&self) -> Self {
                let matrix = matrix(self);
                let mut rest = SVector::<f64, $c>::from_column_slice(self);
                rest[0] -= ROOT_FOUR_PI;
                if matrix.amax() == 0.0 {
                    // Any basis is one of eigenvectors, and the solver divides by the largest entry.
                    return (rest * inverse_growth(DARKEST)).into();
                }
                let eigen = matrix.symmetric_eigen();
                let largest = eigen.eigenvalues.max().max(DARKEST / CLIP);
                let mut along = eigen.eigenvectors.tr_mul(&rest);
                for (a, value) in along.iter_mut().zip(eigen.eigenvalues.iter()) {
                    *a *= inverse_growth(value.max(CLIP * largest));
                }
                (eigen.eigenvectors * along).into()
            }

            fn exp(&self) -> Self {
                // The mean goes aside, so that a deep shadow is not the difference of large numbers.
                let mut rest = *self;
                rest[0] = 0.0;
                let mean = real::exp(self[0] / ROOT_FOUR_PI);
                let mut g = [0.0; $c];
                g[0] = ROOT_FOUR_PI;
                let matrix = matrix(&rest);
                if matrix.amax() != 0.0 {
                    let eigen = matrix.symmetric_eigen();
                    let mut along = eigen.eigenvectors.tr_mul(&SVector::<f64, $c>::from_column_slice(&rest));
                    for (a, value) in along.iter_mut().zip(eigen.eigenvalues.iter()) {
                        *a *= growth(*value);
                    }
                    for (g, h) in g.iter_mut().zip((eigen.eigenvectors * along).iter()) {
                        *g += h;
                    }
                }
                g.map(|g| mean * g)
            }
        }
    )* };
}
logarithm!(4 9 16 25 36);

/// The product matrix of `f`, whole.
fn matrix<const C: usize>(f: &[f64; C]) -> SMatrix<f64, C, C>
where
    [f64; C]: Routines<f64>,
{
    let lower = f.product_matrix();
    let lower = lower.as_ref();
    SMatrix::from_fn(|i, j| {
        let (r, c) = (i.max(j), i.min(j));
        lower[r * (r + 1) / 2 + c]
    })
}

/// q(x) = (e^x − 1)/x, 1 at x = 0 (eq. 29).
fn growth(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { real::expm1(x) / x }
}

/// q'(x) = log(x)/(x − 1), 1 at x = 1. Near 1 the difference x − 1 is exact and keeps every digit; near 0 it
/// would lose x.
fn inverse_growth(x: f64) -> f64 {
    let d = x - 1.0;
    if d == 0.0 {
        1.0
    } else if x < 0.5 {
        real::log(x) / d
    } else {
        real::log1p(d) / d
    }
}

/// The naive logarithm of a zonal function about +Z: sampled, clipped to `floor` from below, projected back
/// (Ren et al. 2006, eq. 25). Kept for comparison: it ignores what the exponential truncates.
///
/// 4,096 midpoints in z: integration error below 1e-5 of ‖log‖.
///
/// ```
/// use sh_core::{ROOT_FOUR_PI, log};
/// // Everywhere 1/2.
/// let z = log::clipped_samples::<16>([0.5 * ROOT_FOUR_PI, 0.0, 0.0, 0.0], 0.02);
/// assert!((z[0] / ROOT_FOUR_PI - 0.5_f64.ln()).abs() < 1e-5);
/// ```
pub fn clipped_samples<const C: usize>(
    z: <[f64; C] as Routines<f64>>::Zonal,
    floor: f64,
) -> <[f64; C] as Routines<f64>>::Zonal
where
    [f64; C]: Routines<f64>,
{
    const COUNT: usize = 4096;
    let order = <[f64; C]>::ORDER;
    let mut out = z;
    out.as_mut().fill(0.0);
    for i in 0..COUNT {
        let height = (2 * i + 1) as f64 / COUNT as f64 - 1.0;
        let y = <[f64; C]>::basis([real::sqrt(1.0 - height * height), 0.0, height]);
        let value: f64 = (0..order).map(|l| z.as_ref()[l] * y[l * l + l]).sum();
        let log = real::log(value.max(floor));
        for l in 0..order {
            out.as_mut()[l] += log * y[l * l + l] * (4.0 * core::f64::consts::PI / COUNT as f64);
        }
    }
    out
}
