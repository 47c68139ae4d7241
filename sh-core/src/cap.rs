//! A circular blocker by its angular radius: visibility and its logarithm.
//!
//! Three ways to the logarithm: the eigenanalysis itself ([`crate::log`], feature `log`), its table at whole
//! degrees ([`log_table`]), and the fitted polynomial that needs no table look-up
//! ([`Routines::cap_log`]), for vector lanes and shaders.

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
/// answered as π/2.
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
/// 0.42 from there to 179°, where its DC coefficient is below −10.
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

fn table(order: usize, row: usize) -> &'static [f64] {
    match order {
        2 => &generated::CAP_LOG_TABLE_2[row],
        3 => &generated::CAP_LOG_TABLE_3[row],
        4 => &generated::CAP_LOG_TABLE_4[row],
        5 => &generated::CAP_LOG_TABLE_5[row],
        _ => &generated::CAP_LOG_TABLE_6[row],
    }
}
