//! Visibility by discs in the sky.
//!
//! A ball of angular radius θ in the direction s, wholly above the tangent plane, as the self-shadow rule makes it, gives
//! sin² θ (N · s) of what a sky of its radiance would: no approximation. A nearer sphere covers a part of its disc
//! ([`Routines::disc_covered`]), and leaves the rest; what several leave is the product of what each leaves, as if they
//! covered parts that have nothing to do with each other.
//!
//! Only spheres whose discs may meet somewhere in the cluster are looked at, of which there are few.

use super::At;
use crate::SphericalLights;
use crate::accumulate::{Seen, dot};
use crate::light_cut::{ALWAYS, LightCut, Met};
use sh_core::{Lane, Routines};
use std::f64::consts::PI;

/// Spheres whose discs are kept; those of further ones are computed anew for every pair.
pub(crate) const KEPT: usize = 96;

/// More than three angles err by together, in radians: discs that are apart by so much cover nothing of each other.
const ANGLES_ERR: f64 = 3e-4;

/// A sphere as a receiver sees it.
#[derive(Clone, Copy)]
pub struct Disc<L> {
    seen: Seen<L>,
    /// Angular radius, its cosine and its sine.
    angle: L,
    cosine: L,
    sine: L,
}

/// What [`crate::Outline::gathered_discs`] computes, to be inlined there.
#[inline(always)]
pub(crate) fn discs<L: Lane, const C: usize>(
    position: [L; 3],
    normal: [L; 3],
    cut: &LightCut,
    lights: &SphericalLights,
    kept: &mut [Disc<L>; KEPT],
) -> [L; 3]
where
    [L; C]: Routines<L>,
{
    let zero = position[0].lift(0.0);
    let mut at = At::new(position, normal, lights);
    for (kept, met) in kept.iter_mut().zip(&cut.spheres) {
        *kept = disc(&at, met);
    }
    let mut first = 0;
    for (i, met) in cut.spheres.iter().enumerate() {
        let hiders = &cut.hiders[first..met.hiders_end as usize];
        first = met.hiders_end as usize;
        if !lights.shines(met.node) {
            continue;
        }
        let own = match kept.get(i) {
            Some(kept) => *kept,
            None => disc(&at, met),
        };
        let Seen {
            sine, direction, ..
        } = own.seen;
        let mut visible = sine * sine * dot(direction, normal).max(zero);
        if !L::any(zero.lt(visible)) {
            continue;
        }
        for hider in hiders {
            let j = hider.sphere as usize;
            let anew;
            let other = match kept.get(j) {
                Some(kept) => kept,
                None => {
                    anew = disc(&at, &cut.spheres[j]);
                    &anew
                }
            };
            let towards = dot(direction, other.seen.direction);
            // cos (a + b) of both radii: beyond it the discs are apart.
            let reach = own.cosine * other.cosine - own.sine * other.sine;
            if !L::any((reach - zero.lift(ANGLES_ERR)).lt(towards)) {
                continue;
            }
            let away = angle(towards);
            let covered = <[L; C]>::disc_covered(own.angle, other.angle, away);
            let hidden = if hider.share == ALWAYS {
                covered
            } else {
                let (farther, nearer) = (at.power(met), at.power(&cut.spheres[j]));
                covered * at.share(hider.share, farther, nearer)
            };
            visible = (-visible).mul_add(hidden, visible);
        }
        at.add::<C>(met, &own.seen, visible);
    }
    at.bounded()
}

impl<L: Lane> Disc<L> {
    /// One that covers nothing.
    #[inline(always)]
    pub(crate) fn nothing(zero: L) -> Self {
        let one = zero.lift(1.0);
        Self {
            seen: Seen {
                sine: zero,
                cosine: one,
                direction: [zero; 3],
            },
            angle: zero,
            cosine: one,
            sine: zero,
        }
    }
}

#[inline(always)]
fn disc<L: Lane>(at: &At<L>, met: &Met) -> Disc<L> {
    let seen = at.look(met);
    let (zero, one) = (seen.sine.lift(0.0), seen.sine.lift(1.0));
    // What does not count has a sine of 0, and any cosine.
    let cosine = L::select(zero.lt(seen.sine), seen.cosine, one);
    Disc {
        seen,
        angle: angle(cosine),
        cosine,
        sine: (-cosine).mul_add(cosine, one).max(zero).sqrt(),
    }
}

/// The angle of a cosine, 0 to π, by Abramowitz and Stegun 1964, 4.4.45: it errs by at most 6.8e-5.
#[inline(always)]
fn angle<L: Lane>(cosine: L) -> L {
    let zero = cosine.lift(0.0);
    let one = cosine.lift(1.0);
    let x = cosine.abs().min(one);
    let p = x
        .mul_add(x.lift(-0.018_729_3), x.lift(0.074_261_0))
        .mul_add(x, x.lift(-0.212_114_4))
        .mul_add(x, x.lift(1.570_728_8));
    let acute = (one - x).sqrt() * p;
    L::select(cosine.lt(zero), cosine.lift(PI) - acute, acute)
}
