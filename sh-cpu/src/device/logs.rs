//! Logarithms of circles' visibilities, band by band.

use super::vectors::dot;
use sh_core::{Lane, Routines};

/// Which logarithm of a circle's visibility is summed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Logs {
    /// [`Routines::cap_log_shading`], with the spheres' weights: for shadows.
    Shading,
    /// [`Routines::cap_log_saturating`], without: for what spheres send on.
    Saturating,
}

/// What [`crate::Outline::ratio_logs`] computes, to be inlined there: F_l(θ) P_l(s · axis) for each band, 0 beyond the
/// order.
#[inline(always)]
pub(crate) fn ratio_logs<L: Lane, const C: usize>(
    towards: [L; 3],
    radius: L,
    axis: [L; 3],
    of: Logs,
) -> [L; 6]
where
    [L; C]: Routines<L>,
{
    let (zero, one) = (radius.lift(0.0), radius.lift(1.0));
    let inverse = one / dot(towards, towards).sqrt().max(radius.lift(1e-30));
    let sine = (radius * inverse).min(one);
    let cosine = (-sine).mul_add(sine, one).max(zero).sqrt();
    let log = match of {
        Logs::Shading => <[L; C]>::cap_log_shading(sine, cosine),
        Logs::Saturating => <[L; C]>::cap_log_saturating(sine, cosine),
    };
    let x = (dot(towards, axis) * inverse).min(one).max(-one);
    let (mut before, mut now) = (zero, one);
    let mut out = [zero; 6];
    for (l, (out, log)) in out.iter_mut().zip(log.as_ref()).enumerate() {
        *out = *log * now;
        // (l + 1) P_(l+1) = (2l + 1) x P_l − l P_(l−1)
        let up = f64::from(2 * l as u32 + 1) / f64::from(l as u32 + 1);
        let down = f64::from(l as u32) / f64::from(l as u32 + 1);
        let next = (x * now).mul_add(zero.lift(up), -(before * zero.lift(down)));
        (before, now) = (now, next);
    }
    out
}
