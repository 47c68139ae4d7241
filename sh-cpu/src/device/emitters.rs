//! Radiance from analytic lights (Ren et al. 2006, section 7).
//!
//! The paper tabulates the product of a light's vector L(θ, d) with the cosine lobe over θ and the normal's angle, and
//! fits each entry with one zonal lobe, so that it can be turned to the receiver. Here the product of visibility and cosine lobe is at
//! hand already, since the environment needs it: (L, H(N), g) = L · (g * H(N)). What is left of a light is a
//! zonal vector in closed form, turned and dotted: exact, and cheaper than a look-up.
//!
//! A light without blockers is known to better than its few bands and their window say: what of the cap is above the
//! horizon, weighted by the cosine ([`sh_core::seen`]). So SH vectors tell only which share of that blockers leave,
//!
//! ```text
//! radiance = F (L · (g * H(N))) / (L · H(N))
//! ```
//! open ground is as bright as it is at every order, and what faces away from a light gets none.
//!
//! A ball that is not equally bright all over gives the mean radiance of what the receiver sees of it, as spheres do
//! that send light on (Guerrero et al. 2008, equations 16 to 18 and section 7.3).

use super::accumulate::Point;
use super::light::reflected;
use super::vectors::{dot, each};
use sh_core::constants::NEAREST;
use sh_core::{Lane, ROOT_FOUR_PI, Routines};
use sh_scene::Emitter;

/// Which share a cap of an even sky's light is, weighted by the cosine with the normal, as far as it is above the horizon:
/// sin² θ (N · s), or that of the cap in its place.
#[inline(always)]
fn share<L: Lane>(sine: L, facing: L) -> L
where
    [L; 4]: Routines<L>,
{
    let (zero, one, tiny) = (sine.lift(0.0), sine.lift(1.0), sine.lift(NEAREST));
    // A sphere of this sine at the distance 1, and the one that touches the horizon in its place.
    let counted = sine * <[L; 4]>::horizon_radius(facing / sine.max(tiny), sine * sine);
    let along = (-facing).mul_add(facing, one).max(zero);
    let part = counted / counted.mul_add(counted, along).sqrt().max(tiny);
    let above = sine.lt(facing);
    L::select(above, sine * sine * facing, part * part * part)
}

/// What [`crate::Outline::emitted`] computes, to be inlined there: for each light what it gives in the open, times
/// L · transfer over L · open held within 0 and 1, so that what one light lacks is not taken from another. Bit i of `dark`
/// says that light i gives 0.
#[inline(always)]
pub(crate) fn emitted<L: Lane, const C: usize>(
    transfer: &[L; C],
    open: &[L; C],
    point: &Point<L>,
    emitters: &[Emitter],
    dark: u64,
) -> [L; 3]
where
    [L; C]: Routines<L>,
    [L; 4]: Routines<L>,
{
    let Point {
        position, normal, ..
    } = *point;
    let zero = position[0].lift(0.0);
    let one = zero.lift(1.0);
    let mut sum = [zero; 3];
    for (i, emitter) in emitters.iter().enumerate() {
        if i < 64 && dark >> i & 1 == 1 {
            continue;
        }
        let local = zero.lift(f64::from(-emitter.local));
        let center = |k: usize| zero.lift(f64::from(emitter.center[k]));
        let towards = each(|k| local.mul_add(position[k], center(k)));
        let inverse = one / dot(towards, towards).sqrt().max(zero.lift(NEAREST));
        let sine = (zero.lift(f64::from(emitter.radius)) * inverse).min(one);
        let cosine = (-sine).mul_add(sine, one).max(zero).sqrt();
        let direction = each(|k| towards[k] * inverse);
        // What a cap hides of the sky is what it shows of a light: 1 − visibility. The mean of that is
        // √π (1 − cos θ), in a form that does not cancel for small lights.
        let hidden = <[L; C]>::cap_visibility(cosine, sine);
        let mean = sine * sine / (one + cosine) * zero.lift(0.5 * ROOT_FOUR_PI);
        let zonal = <[L; C]>::zonal_from(
            #[inline(always)]
            |l| match l {
                0 => mean * zero.lift(f64::from(emitter.gains[0])),
                l => -hidden.as_ref()[l] * zero.lift(f64::from(emitter.gains[l])),
            },
        );
        let light = <[L; C]>::zonal(zonal, direction);
        let shown = share(sine, dot(direction, normal));
        // What is not a number fails the comparison.
        let (lit, all) = (light.dot(transfer), light.dot(open));
        let lit = L::select(zero.lt(lit), lit.min(all), zero);
        let shown = point.reflects(shown, direction, sine * sine);
        let lit = L::select(zero.lt(all), shown * (lit / all), zero);
        let mut radiance = emitter.radiance.map(
            #[inline(always)]
            |c| zero.lift(f64::from(c)),
        );
        if emitter.order > 0 {
            let back = direction.map(
                #[inline(always)]
                |c| -c,
            );
            let mean = reflected(
                &<[L; C]>::ball_average(sine, cosine, back),
                &emitter.distribution,
            );
            for (radiance, mean) in radiance.iter_mut().zip(mean) {
                *radiance = *radiance * mean.max(zero);
            }
        }
        for (sum, radiance) in sum.iter_mut().zip(radiance) {
            *sum = lit.mul_add(radiance, *sum);
        }
    }
    sum
}
