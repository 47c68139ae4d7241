//! The `light_gather` pass: light that spheres send on to receivers (Guerrero et al. 2008, section 6).
//!
//! For a receiver at p with normal N and each sphere:
//! 1. the self-shadow rule says which sphere counts in its place, as in the shadow pass,
//! 2. its mean radiance is that of what is seen of it, w(θ) · L turned to the receiver (equation 18),
//! 3. its visibility times the cosine, V · H(N), is found by one of two modules:
//!
//! | module | visibility |
//! |---|---|
//! | `light_discs` | the cosine over the sphere's disc, exactly, times what nearer discs leave of it |
//! | `light_sums` | the difference of two exponentials (equation 23) |
//!
//! The first is the default. Where 2 to 100 balls light a floor it errs by 1/14 to 1/29 of the other, whose visibilities
//! are functions of low order: they cannot tell a light that is hidden from one beside it. Of bars and links of a chain, whose
//! spheres overlap, it errs by two to three fifths of it. The second has what the
//! first lacks: what all spheres and the sky show adds up to one.

use crate::device::accumulate::Point;
use crate::device::drive::{Kernel, Place, Work, drive};
use crate::device::light_cuts::LightCuts;
use crate::device::light_discs::Disc;
use crate::device::outline::{Outline, OutlineAll};
use crate::device::spherical_lights::SphericalLights;
use crate::error::Error;
use crate::lanes::group::Group;
use crate::lanes::path::Path;
use sh_core::constants::ROOM;
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
    /// As [`Shadow::eye`](crate::Shadow::eye).
    pub eye: Option<[f32; 3]>,
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
        eye: gather.eye,
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
        let emission = &self.lights.emission;
        match self.cuts.blocking() {
            Blocking::Discs => <L as Outline<C>>::gathered_discs(point, cut, emission, kept),
            _ => <L as Outline<C>>::gathered_sums(point, cut, emission),
        }
    }
}
