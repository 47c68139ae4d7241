//! The `basis_gather` pass: light that patches send on to receivers (Iwasaki et al. 2007, equation 4). What a patch and a
//! region give, and what hides them, is in `device/patches.rs`.

use crate::device::accumulate::Point;
use crate::device::drive::{Kernel, Place, Work, drive};
use crate::device::outline::{Outline, OutlineAll};
use crate::device::patch_cut::PatchCuts;
use crate::device::patch_hiding::Hidden;
use crate::device::patch_lights::{PatchLights, Placed};
use crate::error::Error;
use crate::lanes::group::Group;
use crate::lanes::path::Path;
use sh_core::constants::ROOM;
use sh_core::{Lane, Routines};
use sh_scene::Receiver;
use std::ops::Range;

/// What the pass reads besides receivers.
pub(crate) struct BasisGather<'a> {
    /// Ranges of the receivers, one after another, together all of them.
    pub clusters: &'a [Range<usize>],
    /// What lights each cluster.
    pub cuts: &'a PatchCuts,
    /// The bodies, and what they send on.
    pub bodies: &'a [Placed<'a>],
    pub lights: &'a PatchLights,
    /// Whether receivers get what their own body gives itself.
    pub own: bool,
    /// As [`Shadow::eye`](crate::Shadow::eye).
    pub eye: Option<[f32; 3]>,
}

/// Writes the radiance that albedo 1 reflects of the light that comes by way of patches, at every receiver. Receivers that
/// are not covered get 0. Every value lies between 0 and the brightest radiance of any patch. Allocates nothing.
///
/// # Errors
/// Where a length does not fit; nothing is written then.
pub(crate) fn basis_gather(
    path: Path,
    receivers: &[Receiver],
    gather: &BasisGather,
    radiance: &mut [[f32; 3]],
) -> Result<(), Error> {
    let work = Work {
        path,
        receivers,
        clusters: gather.clusters,
        radiance,
        eye: gather.eye,
    };
    drive(work, gather.lights.coefficients.isqrt(), gather)
}

impl Kernel for BasisGather<'_> {
    type Room<L: Lane> = [Hidden<L>; ROOM];

    #[inline(always)]
    fn room<L: Lane>(zero: L) -> [Hidden<L>; ROOM] {
        [Hidden::nothing(zero); ROOM]
    }

    #[inline(always)]
    fn shade<L: Group + OutlineAll + Outline<C>, const C: usize>(
        &self,
        place: &Place<L>,
        point: &Point<L>,
        kept: &mut [Hidden<L>; ROOM],
    ) -> [L; 3]
    where
        [L; C]: Routines<L>,
    {
        let cut = &self.cuts.clusters[place.cluster];
        let sending = (self.bodies, self.lights);
        <L as Outline<C>>::gathered_patches(point, cut, sending, self.own, kept)
    }
}
