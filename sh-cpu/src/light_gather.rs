//! The `light_gather` pass: light that spheres send on to receivers (Guerrero et al. 2008, section 6).
//!
//! For a receiver at p with normal N and each sphere:
//! 1. the self-shadow rule says which sphere counts in its place, as in the shadow pass,
//! 2. its mean radiance is that of what is seen of it, w(θ) · L turned to the receiver (equation 18),
//! 3. its visibility times the cosine, V · H(N), is found by one of two modules:
//!
//! | module | visibility |
//! |---|---|
//! | [`discs`] | the cosine over the sphere's disc, exactly, times what nearer discs leave of it |
//! | [`sums`] | the difference of two exponentials (equation 23) |
//!
//! The first is the default. Where 2 to 100 balls light a floor it errs by 1/14 to 1/29 of the other, whose visibilities
//! are functions of low order: they cannot tell a light that is hidden from one beside it. Of bars and links of a chain, whose
//! spheres overlap, it errs by two to three fifths of it. The second has what the
//! first lacks: what all spheres and the sky show adds up to one.

mod discs;
mod sums;

pub(crate) use discs::{Disc, discs};
pub(crate) use sums::sums;

use crate::accumulate::{Point, dot, each, look, seen_from};
use crate::drive::{Group, Kernel, Place, Work, drive};
use crate::irradiance::reflected;
use crate::light_cut::Met;
use crate::outline::{Outline, OutlineAll};
use crate::{Error, LightCuts, Path, SphericalLights};
use sh_core::constants::ROOM;
use sh_core::seen::Seen;
use sh_core::{Lane, Routines};
use sh_scene::{Blocking, Receiver};
use std::ops::Range;

/// What the pass reads besides receivers.
#[derive(Clone, Copy, Debug)]
pub struct LightGather<'a> {
    /// Ranges of the receivers, one after another, together all of them.
    pub clusters: &'a [Range<usize>],
    /// The spheres that light each cluster.
    pub cuts: &'a LightCuts,
    /// What they send on.
    pub lights: &'a SphericalLights,
}

/// Writes the radiance that albedo 1 reflects of the light that comes by way of spheres, at every receiver. Receivers
/// that are not covered get 0. Every value lies between 0 and the brightest radiance of any surface that sends light on.
/// Allocates nothing.
///
/// # Errors
/// Where a length does not fit; nothing is written then.
pub fn light_gather(
    path: Path,
    receivers: &[Receiver],
    gather: &LightGather,
    radiance: &mut [[f32; 3]],
) -> Result<(), Error> {
    if gather.cuts.clusters() != gather.clusters.len() {
        return Err(Error::Length {
            buffer: "cuts",
            expected: gather.clusters.len(),
            found: gather.cuts.clusters(),
        });
    }
    let work = Work {
        path,
        receivers,
        clusters: gather.clusters,
        radiance,
    };
    drive(work, gather.lights.order(), gather)
}

impl Kernel for LightGather<'_> {
    type Room<L: Lane> = [Disc<L>; ROOM];

    #[inline(always)]
    fn room<L: Lane>(zero: L) -> [Disc<L>; ROOM] {
        [Disc::nothing(zero); ROOM]
    }

    #[inline(always)]
    fn shade<L: Group + OutlineAll + Outline<C>, const C: usize>(
        &self,
        place: &Place<L>,
        point: &Point<L>,
        kept: &mut [Disc<L>; ROOM],
    ) -> [L; 3]
    where
        [L; C]: Routines<L>,
    {
        let cut = self.cuts.of(place.cluster);
        match self.cuts.blocking() {
            Blocking::Discs => <L as Outline<C>>::gathered_discs(point, cut, self.lights, kept),
            _ => <L as Outline<C>>::gathered_sums(point, cut, self.lights),
        }
    }
}

/// Receivers that light comes to.
#[derive(Clone, Copy)]
struct At<'a, L> {
    point: Point<L>,
    lights: &'a SphericalLights,
    sum: [L; 3],
}

impl<'a, L: Lane> At<'a, L> {
    #[inline(always)]
    fn new(point: &Point<L>, lights: &'a SphericalLights) -> Self {
        Self {
            point: *point,
            lights,
            sum: [point.object.lift(0.0); 3],
        }
    }

    #[inline(always)]
    fn look(&self, met: &Met) -> Seen<L>
    where
        [L; 4]: Routines<L>,
    {
        look(&met.blocker, met.in_front, &self.point)
    }

    /// |c − p|² − r².
    #[inline(always)]
    fn power(&self, met: &Met) -> L {
        let away = seen_from(&met.blocker.center, &self.point);
        let radius = f64::from(met.blocker.radius);
        dot(away, away) - self.point.object.lift(radius * radius)
    }

    /// The share of what a nearer sphere covers that it hides of a farther one.
    #[inline(always)]
    fn share(&self, share: f32, farther: L, nearer: L) -> L {
        let half = farther.lift(0.5);
        let share = (farther - nearer).mul_add(farther.lift(f64::from(share)), half);
        share.max(farther.lift(0.0)).min(farther.lift(1.0))
    }

    /// Adds what a sphere gives of which `visible` is seen, the cosine included.
    #[inline(always)]
    fn add<const C: usize>(&mut self, met: &Met, seen: &Seen<L>, visible: L)
    where
        [L; C]: Routines<L>,
    {
        let zero = visible.lift(0.0);
        let back = [-seen.direction[0], -seen.direction[1], -seen.direction[2]];
        let weights = <[L; C]>::ball_average(seen.sine, seen.cosine, back);
        let mean = reflected(&weights, self.lights.emission(met.node));
        let most = self.lights.brightest_of(met.node);
        let visible = visible.max(zero);
        for (c, sum) in self.sum.iter_mut().enumerate() {
            let mean = mean[c].max(zero).min(zero.lift(f64::from(most[c])));
            *sum = (visible * zero.lift(f64::from(met.gain[c]))).mul_add(mean, *sum);
        }
    }

    /// What was added, between 0 and the brightest of all lights.
    #[inline(always)]
    fn bounded(&self) -> [L; 3] {
        let zero = self.point.object.lift(0.0);
        let brightest = self.lights.brightest();
        each(
            #[inline(always)]
            |c| {
                let most = zero.lift(f64::from(brightest[c]));
                // What is not a number fails the comparison.
                L::select(zero.lt(self.sum[c]), self.sum[c].min(most), zero)
            },
        )
    }
}

#[cfg(test)]
mod tests;
