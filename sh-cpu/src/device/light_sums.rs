//! Visibility as what a sphere takes away from what is left to be seen behind all nearer ones.
//!
//! ```text
//! V = exp(Σ_nearer f) − exp(Σ_nearer f + f_this)        Guerrero et al. 2008, equation 23
//! ```
//! It telescopes: where each sphere hides all of those behind it, the visibilities of all of them and of the sky add up
//! to H · 1. A sphere behind a whole run of others needs their sum only, and one exponential a sphere is all there is;
//! within a run each needs two.

use super::accumulate::Point;
use super::emission::Emission;
use super::light_cut::{ALWAYS, LightCut, Met, NEVER};
use super::light_sent::At;
use super::order::share;
use sh_core::seen::Seen;
use sh_core::{Lane, ROOT_FOUR_PI, Routines};
use std::ops::Range;

/// Spheres of a run whose logarithms are kept while its pairs are looked at; those of further ones are computed anew
/// for every pair.
const KEPT: usize = 24;

/// What [`crate::Outline::gathered_sums`] computes, to be inlined there. `visibility` is [`crate::Outline::visibility`], which is above.
#[inline(always)]
pub(crate) fn sums<L: Lane, const C: usize>(
    point: &Point<L>,
    cut: &LightCut,
    lights: &Emission,
    visibility: impl Fn(&[L; C]) -> [L; C],
) -> [L; 3]
where
    [L; C]: Routines<L>,
    [L; 4]: Routines<L>,
{
    let zero = point.object.lift(0.0);
    let lobe: [L; C] = point.lobe();
    let mut all = Sums {
        at: At::new(point, lights),
        lobe,
        nearer: [zero; C],
        // Nothing is nearer: all of H · 1 is left.
        left: Some(lobe[0] * zero.lift(ROOT_FOUR_PI)),
        visibility,
    };
    for run in &cut.runs {
        if run.len() == 1 {
            all.one(cut, run.start);
        } else {
            all.several(cut, run.clone());
        }
    }
    all.at.bounded()
}

/// A sum of log visibilities plus that of a sphere.
#[inline(always)]
fn with<L: Lane, const C: usize>(sum: &[L; C], seen: &Seen<L>, weights: &[f32; 6]) -> [L; C]
where
    [L; C]: Routines<L>,
{
    let weights = <[L; C]>::zonal_from(
        #[inline(always)]
        |l| seen.sine.lift(f64::from(weights[l])),
    );
    sum.accumulate_blocker_saturating(seen.sine, seen.cosine, seen.direction, weights)
}

/// Receivers on their way from the nearest sphere to the farthest.
struct Sums<'a, L, V, const C: usize> {
    at: At<'a, L>,
    lobe: [L; C],
    /// Σ f of all runs that are done.
    nearer: [L; C],
    /// exp(nearer) · H, if somebody needed it already.
    left: Option<L>,
    visibility: V,
}

impl<L: Lane, V: Fn(&[L; C]) -> [L; C], const C: usize> Sums<'_, L, V, C>
where
    [L; C]: Routines<L>,
    [L; 4]: Routines<L>,
{
    /// exp(f) · H.
    #[inline(always)]
    fn visible(&self, sum: &[L; C]) -> L {
        (self.visibility)(sum).dot(&self.lobe)
    }

    /// A sphere's log visibility alone.
    #[inline(always)]
    fn log(&self, met: &Met) -> [L; C] {
        let none = [self.at.point.object.lift(0.0); C];
        with(&none, &self.at.look(met), &met.blocker.weights)
    }

    #[inline(always)]
    fn left(&mut self) -> L {
        match self.left {
            Some(left) => left,
            None => {
                let left = self.visible(&self.nearer);
                self.left = Some(left);
                left
            }
        }
    }

    /// A sphere that is a run.
    #[inline(always)]
    fn one(&mut self, cut: &LightCut, at: usize) {
        let met = &cut.spheres[at];
        let seen = self.at.look(met);
        if !L::any(seen.sine.lift(0.0).lt(seen.sine)) {
            return;
        }
        let with = with(&self.nearer, &seen, &met.blocker.weights);
        if self.at.lights.shines(met.node) {
            let left = self.left();
            let behind = self.visible(&with);
            self.at.add::<C>(met, &seen, left - behind);
            self.left = Some(behind);
        } else {
            self.left = None;
        }
        self.nearer = with;
    }

    /// Spheres that share a run.
    #[inline(always)]
    fn several(&mut self, cut: &LightCut, run: Range<usize>) {
        let zero = self.at.point.object.lift(0.0);
        let count = cut.spheres.len();
        let mut kept = [[zero; C]; KEPT];
        for (kept, met) in kept.iter_mut().zip(&cut.spheres[run.clone()]) {
            *kept = self.log(met);
        }
        let mut together = self.nearer;
        for i in run.clone() {
            let met = &cut.spheres[i];
            let seen = self.at.look(met);
            let own = match kept.get(i - run.start) {
                Some(kept) => *kept,
                None => self.log(met),
            };
            for (together, own) in together.iter_mut().zip(&own) {
                *together = *together + *own;
            }
            if !L::any(zero.lt(seen.sine)) || !self.at.lights.shines(met.node) {
                continue;
            }
            let mut nearer = self.nearer;
            for j in run.clone() {
                let slope = cut.before[i * count + j];
                if slope == NEVER {
                    continue;
                }
                let anew;
                let other = match kept.get(j - run.start) {
                    Some(kept) => kept,
                    None => {
                        anew = self.log(&cut.spheres[j]);
                        &anew
                    }
                };
                if slope == ALWAYS {
                    for (nearer, other) in nearer.iter_mut().zip(other) {
                        *nearer = *nearer + *other;
                    }
                } else {
                    let (own, others) = (self.at.power(met), self.at.power(&cut.spheres[j]));
                    let share = share(slope, own, others);
                    for (nearer, other) in nearer.iter_mut().zip(other) {
                        *nearer = share.mul_add(*other, *nearer);
                    }
                }
            }
            let left = self.visible(&nearer);
            for (nearer, own) in nearer.iter_mut().zip(&own) {
                *nearer = *nearer + *own;
            }
            let behind = self.visible(&nearer);
            self.at.add::<C>(met, &seen, left - behind);
        }
        self.nearer = together;
        self.left = None;
    }
}
