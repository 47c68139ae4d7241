//! The shadow pass: light through the visibility of all blocker spheres (Ren et al. 2006,
//! "Real-time soft shadows in dynamic scenes using spherical harmonic exponentiation").
//!
//! For a receiver at p with normal N, with one blocker of its cluster's cut after another:
//! 1. the rule of [`sh_core::seen`] says what of the sphere is above its horizon,
//! 2. the logarithm of that sphere's visibility, a zonal function of its angular radius, is turned towards it
//!    and added with the blocker's ratio vector: f += W F(θ) y(s) (equation 38).
//!
//! Then g = exp(f) (section 4) is the visibility of all blockers together, and a channel's radiance is the triple product
//! of light, cosine lobe and visibility, (L, H(N), g) = L · (g * H(N)), held between 0 and the radiance without blockers,
//! for the environment and each analytic light apart. Exponential and lobe are multiplied at samples and projected once:
//! the transfer g * H(N) by [`Routines::transfer`].
//!
//! Steps 1 and 2 and the exponential may be of a higher order than the light, the order of accumulation. All of that
//! visibility is used: the lobe couples the light's bands with those of the visibility above them.
//!
//! A lamp is hidden by what is before it. Where a cluster may have a blocker behind one, the lamp has a sum of its own,
//! and with it a visibility of its own.
//!
//! Blockers that never move against a receiver can be summed up once ([`bake`]): the sum starts with their
//! logarithm. The paper keeps their visibility instead, and needs a general product to put them together with what
//! moves; a logarithm needs none, and gives what all blockers together would have given. They hide lamps wherever they are.

use crate::device::accumulate::{Blockers, Point};
use crate::device::behind::Behind;
use crate::device::check::{check_clusters, check_light};
use crate::device::cut::Cuts;
use crate::device::drive::{Kernel, Place, Work, drive};
use crate::device::lamps::with_emitters;
use crate::device::light::{reflected, unblocked};
use crate::device::outline::{Outline, OutlineAll};
use crate::error::Error;
use crate::lanes::group::Group;
use crate::lanes::path::Path;
use rayon::prelude::*;
use sh_core::constants::MAX_ORDER;
use sh_core::{Lane, OrderError, Routines, for_order};
use sh_scene::{Light, Receiver, Sphere};
use std::ops::Range;

/// What the shadow pass reads besides receivers.
#[derive(Clone, Copy, Debug)]
pub struct Shadow<'a> {
    /// Ranges of the receivers, one after another, together all of them.
    pub clusters: &'a [Range<usize>],
    /// The blockers of each cluster.
    pub cuts: &'a Cuts,
    /// The light.
    pub light: &'a Light,
    /// The order in which the blockers' logarithms are summed and exponentiated, from the light's order to 6; the
    /// cost of a blocker grows with its square.
    pub accumulation: usize,
    /// What [`bake`] found for each receiver: the sum of blockers to start with.
    pub baked: Option<&'a [f32]>,
    /// Where receivers are looked at from. Those that have a roughness ([`sh_scene::Finish::covered`]) then mirror light, and what is written
    /// is the mean of what they see in their lobe; all others get 0. None: all reflect diffusely.
    pub eye: Option<[f32; 3]>,
}

/// Writes the radiance that albedo 1 reflects at every receiver under `light`, shadowed by all `spheres`, without a
/// hierarchy. Receivers that are not covered get 0. Every value lies between 0 and that of [`crate::irradiance`].
///
/// `accumulation` as in [`Shadow`].
///
/// # Errors
/// Where an order is none that there is, or a length does not fit; nothing is written then.
pub fn shadow(
    receivers: &[Receiver],
    spheres: &[Sphere],
    light: &Light,
    accumulation: usize,
    radiance: &mut [[f32; 3]],
) -> Result<(), Error> {
    let path = Path::best();
    shadow_on(path, receivers, spheres, light, accumulation, radiance)
}

/// [`shadow`] on a vector path of the caller's choice.
pub fn shadow_on(
    path: Path,
    receivers: &[Receiver],
    spheres: &[Sphere],
    light: &Light,
    accumulation: usize,
    radiance: &mut [[f32; 3]],
) -> Result<(), Error> {
    let everyone = 0..receivers.len();
    let all = Shadow {
        clusters: std::slice::from_ref(&everyone),
        cuts: &Cuts::everything(spheres, receivers.len(), light),
        light,
        accumulation,
        baked: None,
        eye: None,
    };
    shadow_clusters(path, receivers, &all, radiance)
}

/// Writes the radiance that albedo 1 reflects at every receiver, each shadowed by the blockers of its cluster.
/// Receivers that are not covered get 0. Every value lies between 0 and that of [`crate::irradiance`]. Allocates
/// nothing.
///
/// # Errors
/// Where an order is none that there is, or a length does not fit; nothing is written then.
pub fn shadow_clusters(
    path: Path,
    receivers: &[Receiver],
    shadow: &Shadow,
    radiance: &mut [[f32; 3]],
) -> Result<(), Error> {
    let light = shadow.light;
    check_light(light)?;
    check_accumulation(light.order, shadow.accumulation)?;
    if shadow.cuts.clusters() != shadow.clusters.len() {
        return Err(Error::Length {
            buffer: "cuts",
            expected: shadow.clusters.len(),
            found: shadow.cuts.clusters(),
        });
    }
    if let Some(baked) = shadow.baked {
        let coefficients = shadow.accumulation * shadow.accumulation;
        let expected = receivers.len() * coefficients;
        if baked.len() != expected {
            return Err(Error::Baked {
                expected,
                found: baked.len(),
                coefficients,
            });
        }
    }
    let work = Work {
        path,
        receivers,
        clusters: shadow.clusters,
        radiance,
        eye: shadow.eye,
    };
    drive(work, light.order, shadow)
}

fn check_accumulation(order: usize, accumulation: usize) -> Result<(), Error> {
    if (order..=MAX_ORDER).contains(&accumulation) {
        Ok(())
    } else {
        Err(Error::Accumulation {
            order,
            accumulation,
        })
    }
}

/// The sum of each cluster's blockers, `accumulation²` numbers for each receiver on the scale of
/// [`Routines::accumulate_blocker`]: for blockers that do
/// not move against the receivers. [`Shadow::baked`] starts with it, and the cuts then hold the other blockers alone.
///
/// # Errors
/// Where the order is not 2 to 6, or clusters and cuts do not fit the receivers.
pub fn bake(
    receivers: &[Receiver],
    clusters: &[Range<usize>],
    cuts: &Cuts,
    accumulation: usize,
) -> Result<Vec<f32>, Error> {
    fn log<const A: usize>(receiver: &Receiver, blockers: Blockers, sum: &mut [f32])
    where
        f32: Outline<A>,
        [f32; A]: Routines<f32>,
    {
        let point = Point {
            position: receiver.position,
            normal: receiver.normal,
            object: receiver.object as f32,
            gloss: None,
        };
        sum.copy_from_slice(&f32::accumulate(&[0.0; A], &point, blockers));
    }
    let log = for_order!(
        accumulation, A => log::<A>,
        else => return Err(OrderError(accumulation).into())
    );
    check_clusters(clusters, receivers.len())?;
    if cuts.clusters() != clusters.len() {
        return Err(Error::Length {
            buffer: "cuts",
            expected: clusters.len(),
            found: cuts.clusters(),
        });
    }
    let coefficients = accumulation * accumulation;
    let mut sums = vec![0.0; receivers.len() * coefficients];
    for (cluster, range) in clusters.iter().enumerate() {
        let sums = &mut sums[range.start * coefficients..range.end * coefficients];
        receivers[range.clone()]
            .par_iter()
            .zip(sums.par_chunks_mut(coefficients))
            .filter(|(receiver, _)| receiver.covered != 0)
            .for_each(|(receiver, sum)| log(receiver, cuts.of(cluster), sum));
    }
    Ok(sums)
}

impl Kernel for Shadow<'_> {
    type Room<L: Lane> = ();

    #[inline(always)]
    fn room<L: Lane>(_: L) {}

    #[inline(always)]
    fn shade<L: Group + OutlineAll + Outline<C>, const C: usize>(
        &self,
        place: &Place<L>,
        point: &Point<L>,
        (): &mut (),
    ) -> [L; 3]
    where
        [L; C]: Routines<L>,
    {
        let coefficients = self.accumulation * self.accumulation;
        let start = self.baked.map(|baked| {
            move |i: usize| place.gather(|receiver| baked[receiver * coefficients + i])
        });
        let blockers = (self.cuts, place.cluster);
        shade::<L, C>(point, blockers, self.light, self.accumulation, start)
    }
}

/// The light, and which blockers of a cluster do not hide which of its lamps.
#[derive(Clone, Copy)]
struct Lamps<'a> {
    light: &'a Light,
    behind: &'a Behind,
}

/// Radiance of albedo 1 in three channels, for one group of receivers of a cluster under light of `C` coefficients;
/// `accumulation` as in [`Shadow`]. `start` tells the coefficients that the sum of logarithms starts with; none: 0.
///
/// # Panics
/// If the order of accumulation is not 2 to 6.
#[inline(always)]
pub fn shade<L: OutlineAll + Outline<C>, const C: usize>(
    point: &Point<L>,
    (cuts, cluster): (&Cuts, usize),
    light: &Light,
    accumulation: usize,
    start: Option<impl Fn(usize) -> L>,
) -> [L; 3]
where
    [L; C]: Routines<L>,
{
    let zero = point.object.lift(0.0);
    let blockers = cuts.of(cluster);
    let lamps = Lamps {
        light,
        behind: cuts.behind(cluster),
    };
    let done = cuts.dark(cluster) | lamps.behind.lamps();
    // Lamps are hidden as those who reflect diffusely have it: of a lobe little may be left where a lamp is.
    let mut transfer = [zero; C];
    let lobe = <[L; C]>::cosine(point.normal);
    let mut mirrored = [zero; 3];
    // What lamps give that are before some of the blockers.
    let mut before = [zero; 3];
    let mut add = |lamp: usize, transfer: &[L; C]| {
        let emitter = std::slice::from_ref(&lamps.light.emitters[lamp]);
        let given = L::emitted(transfer, &lobe, point, emitter, 0);
        for (sum, given) in before.iter_mut().zip(given) {
            *sum = *sum + given;
        }
    };
    for_order!(
        accumulation,
        A => accumulated::<L, A, C>(point, blockers, start, (&mut transfer, &mut mirrored), lamps, &mut add)
    );
    let [open, shadowed] = match &point.gloss {
        None => [
            unblocked(&lobe, &light.coefficients),
            reflected(&transfer, &light.coefficients),
        ],
        Some(gloss) => {
            let open: [L; C] = gloss.lobe();
            [unblocked(&open, &light.coefficients), mirrored]
        }
    };
    // What is not a number fails the comparison.
    let channel = |c: usize| L::select(zero.lt(shadowed[c]), shadowed[c].min(open[c]), zero);
    let environment = [channel(0), channel(1), channel(2)];
    let all = with_emitters(environment, &transfer, &lobe, point, (light, done));
    [all[0] + before[0], all[1] + before[1], all[2] + before[2]]
}

/// The transfer of light of `C` coefficients behind blockers that are accumulated with `A`, and, where that is asked for, what is
/// mirrored of the environment; `own` is told the transfer of each lamp that has one of its own. A light of a higher
/// order than the accumulation's is refused before.
#[inline(always)]
fn accumulated<L: Outline<A>, const A: usize, const C: usize>(
    point: &Point<L>,
    blockers: Blockers,
    start: Option<impl Fn(usize) -> L>,
    (transfer, mirrored): (&mut [L; C], &mut [L; 3]),
    lamps: Lamps,
    own: &mut impl FnMut(usize, &[L; C]),
) where
    [L; A]: Routines<L>,
{
    if const { C > A } {
        return;
    }
    let mut sum = [point.object.lift(0.0); A];
    if let Some(start) = start {
        for (i, slot) in sum.iter_mut().enumerate() {
            *slot = start(i);
        }
    }
    let sum = L::accumulate(&sum, point, blockers);
    for (lamp, changes) in lamps.behind.each() {
        let emitter = &lamps.light.emitters[lamp];
        let parted = L::parted(&sum, point, emitter, changes);
        own(lamp, &L::transfer(&parted, point.normal));
    }
    if let Some(gloss) = &point.gloss {
        // Light has the lower bands of it.
        *mirrored = reflected(&L::mirrored(&sum, gloss), &lamps.light.coefficients);
    }
    if point.gloss.is_none() || !lamps.light.emitters.is_empty() {
        *transfer = L::transfer(&sum, point.normal);
    }
}
