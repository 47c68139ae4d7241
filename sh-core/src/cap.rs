//! A circular blocker by its angular radius: visibility and its logarithm.
//!
//! Ways to the logarithm: the eigenanalysis itself ([`crate::log`], feature `log`), its table at whole degrees
//! ([`log_table`]), and fitted polynomials that need no table look-up: one for each exponential
//! ([`log_fitted_to`]), of which [`Routines::cap_log`] and
//! [`Routines::cap_log_saturating`] are for vector lanes and shaders.
//!
//! ```
//! use sh_core::{Routines, Sh4d, cap};
//! // A quarter of the sky around +Y is hidden; the shadow of its fitted logarithm is nearly that.
//! let (angle, up) = (std::f64::consts::FRAC_PI_3, [0.0, 1.0, 0.0]);
//! let exact = Sh4d::zonal(cap::visibility::<16>(angle), up);
//! let log = Sh4d::zonal(cap::log_fitted_to::<16>(cap::Fit::Saturating, angle), up);
//! assert!((log.0.exp_saturating()[0] - exact[0]).abs() < 0.05 * exact[0]);
//! ```

use crate::{Routines, generated, real};

/// Zonal coefficients of the visibility past a circular blocker of angular radius `angle` (0..π) about +Z:
/// 0 inside the circle, 1 outside (Ren et al. 2006, eq. 33).
///
/// ```
/// let half = sh_core::cap::visibility::<16>(std::f64::consts::FRAC_PI_2);
/// assert!((half[0] - std::f64::consts::PI.sqrt()).abs() < 1e-15);
/// ```
pub fn visibility<const C: usize>(angle: f64) -> <[f64; C] as Routines<f64>>::Zonal
where
    [f64; C]: Routines<f64>,
{
    <[f64; C]>::cap_visibility(real::cos(angle), real::sin(angle))
}

/// Zonal coefficients of the fitted logarithm of [`visibility`], `angle` in 0..π/2; larger angles are
/// answered as π/2. [`Routines::cap_log`] by the angle in radians, with its source and errors.
///
/// ```
/// let z = sh_core::cap::log_fitted::<16>(0.5);
/// assert!(z[0] < 0.0);
/// assert_eq!(sh_core::cap::log_fitted::<16>(9.0), sh_core::cap::log_fitted::<16>(std::f64::consts::FRAC_PI_2));
/// ```
pub fn log_fitted<const C: usize>(angle: f64) -> <[f64; C] as Routines<f64>>::Zonal
where
    [f64; C]: Routines<f64>,
{
    let angle = angle.min(core::f64::consts::FRAC_PI_2);
    <[f64; C]>::cap_log(real::sin(angle), real::cos(angle))
}

/// Zonal coefficients of the eigen logarithm of [`visibility`], interpolated between whole degrees; angles
/// beyond 179° are answered as 179°.
///
/// Interpolation errs by at most 0.11 up to 150° (at the kinks where a further eigenvalue is clipped) and by
/// 0.42 from there to 179°, where its DC coefficient is below −10. Ren et al. 2006, eq. 30–34.
///
/// ```
/// // Whole degrees are rows of the table, and a half degree is the mean of two.
/// let at = |degrees: f64| sh_core::cap::log_table::<16>(degrees.to_radians())[0];
/// assert!((at(30.5) - 0.5 * (at(30.0) + at(31.0))).abs() < 1e-9);
/// // A larger circle hides more.
/// assert!(at(31.0) < at(30.0) && at(30.0) < at(29.0));
/// ```
pub fn log_table<const C: usize>(angle: f64) -> <[f64; C] as Routines<f64>>::Zonal
where
    [f64; C]: Routines<f64>,
{
    let degrees = (angle * (180.0 / core::f64::consts::PI)).clamp(0.0, 179.0);
    let row = (degrees as usize).min(178);
    let t = degrees - row as f64;
    let mut out = <[f64; C]>::cap_visibility(1.0, 0.0);
    for (l, value) in out.as_mut().iter_mut().enumerate() {
        let at = |row| table(<[f64; C]>::ORDER, row)[l];
        *value = at(row) * (1.0 - t) + at(row + 1) * t;
    }
    out
}

/// What a fitted logarithm is fitted to: the exponential that takes it back, or the eigen logarithm.
///
/// ```
/// use sh_core::cap::{Fit, log_fitted_to};
/// // Each exponential has a logarithm of its own.
/// let of = |fit| log_fitted_to::<16>(fit, 0.7)[0];
/// assert!(of(Fit::Saturating) != of(Fit::Eigen));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Fit {
    /// [`Routines::transfer`]; the fit of [`Routines::cap_log_shading`].
    Shading,
    /// [`Routines::exp_saturating`]; the fit of [`Routines::cap_log_saturating`].
    Saturating,
    /// [`Routines::exp_sampled`].
    Sampled,
    /// [`Routines::exp_sampled_coarse`].
    SampledCoarse,
    /// [`Routines::exp_sampled_fine`].
    SampledFine,
    /// PS*-2, [`crate::exp::ps_star`].
    Series,
    /// HYB, [`crate::exp::hyb`].
    Hybrid,
    /// OL, [`crate::exp::optimal_linear`].
    OptimalLinear,
    /// The eigen logarithm, as nearly as a polynomial follows it; the fit of [`Routines::cap_log`].
    Eigen,
}

/// Zonal coefficients of a fitted logarithm of [`visibility`], `angle` in 0..π/2; larger angles are answered as
/// π/2.
///
/// ```
/// use sh_core::cap::{Fit, log_fitted, log_fitted_to};
/// let (a, b) = (log_fitted::<16>(0.7), log_fitted_to::<16>(Fit::Eigen, 0.7));
/// assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-13));
/// ```
pub fn log_fitted_to<const C: usize>(fit: Fit, angle: f64) -> <[f64; C] as Routines<f64>>::Zonal
where
    [f64; C]: Routines<f64>,
{
    let angle = angle.min(core::f64::consts::FRAC_PI_2);
    let (sin, u) = (real::sin(angle), 2.0 * real::cos(angle) - 1.0);
    let mut out = <[f64; C]>::cap_visibility(1.0, 0.0);
    for (l, value) in out.as_mut().iter_mut().enumerate() {
        let powers = fitted(<[f64; C]>::ORDER, fit as usize)[l];
        *value = sin * sin * powers.iter().rev().fold(0.0, |p, c| p * u + c);
    }
    out
}

/// The polynomials of a fit, band by band. The generated tables are in the order of [`Fit`].
fn fitted(order: usize, fit: usize) -> &'static [&'static [f64]] {
    match order {
        2 => &generated::CAP_LOG_FITS_2[fit].1,
        3 => &generated::CAP_LOG_FITS_3[fit].1,
        4 => &generated::CAP_LOG_FITS_4[fit].1,
        5 => &generated::CAP_LOG_FITS_5[fit].1,
        _ => &generated::CAP_LOG_FITS_6[fit].1,
    }
}

fn table(order: usize, row: usize) -> &'static [f64] {
    match order {
        2 => &generated::CAP_LOG_TABLE_2[row],
        3 => &generated::CAP_LOG_TABLE_3[row],
        4 => &generated::CAP_LOG_TABLE_4[row],
        5 => &generated::CAP_LOG_TABLE_5[row],
        _ => &generated::CAP_LOG_TABLE_6[row],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fits_are_in_the_order_of_the_tables() {
        let names = generated::CAP_LOG_FITS_4.map(|(name, _)| name);
        for (fit, name) in [
            (Fit::Shading, "shading"),
            (Fit::Saturating, "saturating"),
            (Fit::Sampled, "sampled"),
            (Fit::SampledCoarse, "sampled_coarse"),
            (Fit::SampledFine, "sampled_fine"),
            (Fit::Series, "ps_star"),
            (Fit::Hybrid, "hyb"),
            (Fit::OptimalLinear, "optimal_linear"),
            (Fit::Eigen, "eigen"),
        ] {
            assert_eq!(names[fit as usize], name);
        }
    }
}
