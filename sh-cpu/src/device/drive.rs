//! Running a kernel over receivers: lanes side by side, groups of lanes in chunks, chunks on threads.
//!
//! ```text
//! receivers  |---- cluster ----|------ cluster ------|--
//!            |-- chunk --|chunk|-- chunk --|- chunk -|      one task of the thread pool each
//!            |8|8|8|8|8|8|8|8|8|                            one call of the kernel each (4, 8 or 16 lanes)
//! ```
//! Chunks and groups lie at fixed places in their cluster, so the result does not depend on the number of threads.
//! Nothing is allocated.

use super::accumulate::Point;
use super::check::{check_clusters, check_length};
use super::outline::{Outline, OutlineAll};
use crate::error::Error;
use crate::lanes::enter;
use crate::lanes::group::Group;
use crate::lanes::path::Path;
use sh_core::{Lane, OrderError, Routines, for_order};
use sh_scene::Receiver;
use std::ops::Range;

/// Receivers a task: some hundred microseconds of work with a hundred blockers.
const CHUNK: usize = 256;

/// What is computed for a receiver.
pub(crate) trait Kernel: Sync {
    /// What the groups of a chunk write over one after another: too large to be cleared for each.
    type Room<L: Lane>;

    /// It, with anything in it.
    fn room<L: Lane>(zero: L) -> Self::Room<L>;

    /// Red, green and blue radiance reflected by albedo 1. `C` is the number of SH coefficients.
    fn shade<L: Group + OutlineAll + Outline<C>, const C: usize>(
        &self,
        at: &Place<L>,
        point: &Point<L>,
        room: &mut Self::Room<L>,
    ) -> [L; 3]
    where
        [L; C]: Routines<L>;
}

/// Which receivers a group of lanes holds.
pub(crate) struct Place<L: Group> {
    /// The cluster they belong to.
    pub(crate) cluster: usize,
    /// The receiver of each lane.
    receivers: L::Of<usize>,
    token: L::Token,
}

impl<L: Group> Place<L> {
    /// A number for each lane's receiver.
    #[inline(always)]
    pub(crate) fn gather(&self, value: impl Fn(usize) -> f32) -> L {
        let receivers = self.receivers.as_ref();
        L::gather(
            self.token,
            #[inline(always)]
            |i| value(receivers[i]),
        )
    }
}

/// Work that is written once for every kind of lane.
pub(crate) trait Job {
    fn run<G: Group + OutlineAll + Outline<C>, const C: usize>(self, token: G::Token)
    where
        [G; C]: Routines<G>;
}

/// Receivers of one cluster, and where their radiance goes.
pub(crate) struct Chunk<'a> {
    cluster: usize,
    /// Index of the first receiver.
    first: usize,
    receivers: &'a [Receiver],
    radiance: &'a mut [[f32; 3]],
    eye: Option<[f32; 3]>,
}

/// What a run works on.
pub(crate) struct Work<'a> {
    pub(crate) path: Path,
    pub(crate) receivers: &'a [Receiver],
    /// Ranges of the receivers, one after another, together all of them.
    pub(crate) clusters: &'a [Range<usize>],
    pub(crate) radiance: &'a mut [[f32; 3]],
    /// Where receivers are looked at from, which then mirror light; none: they reflect it diffusely.
    pub(crate) eye: Option<[f32; 3]>,
}

/// Runs `kernel` with the coefficients of an order for every receiver. Radiance is 0 where a receiver is not covered.
pub(crate) fn drive<K: Kernel>(work: Work, order: usize, kernel: &K) -> Result<(), Error> {
    check_length("radiance", work.receivers.len(), work.radiance.len())?;
    check_clusters(work.clusters, work.receivers.len())?;
    let run: fn(Path, Chunk, &K) = for_order!(
        order,
        C => |path, chunk, kernel| {
            let job = Groups { chunk, kernel };
            enter!(path, Lanes, simd => job.run::<Lanes<_>, C>(simd))
        },
        else => return Err(OrderError(order).into())
    );
    let path = work.path;
    split(work, 0, &|chunk| run(path, chunk, kernel));
    Ok(())
}

/// Halves the clusters, and then a cluster's receivers, until there are chunks.
fn split(work: Work, cluster: usize, run: &(impl Fn(Chunk) + Sync)) {
    let Work {
        path,
        receivers,
        clusters,
        radiance,
        eye,
    } = work;
    let Some(first) = clusters.first().map(|range| range.start) else {
        return;
    };
    if clusters.len() == 1 {
        let chunk = Chunk {
            cluster,
            first,
            receivers,
            radiance,
            eye,
        };
        return split_chunk(chunk, run);
    }
    let half = clusters.len() / 2;
    let (left, right) = clusters.split_at(half);
    let (near, far) = receivers.split_at(right[0].start - first);
    let (low, high) = radiance.split_at_mut(right[0].start - first);
    let part = |receivers, clusters, radiance| Work {
        path,
        receivers,
        clusters,
        radiance,
        eye,
    };
    let (a, b) = (part(near, left, low), part(far, right, high));
    rayon::join(|| split(a, cluster, run), || split(b, cluster + half, run));
}

fn split_chunk(chunk: Chunk, run: &(impl Fn(Chunk) + Sync)) {
    let count = chunk.receivers.len();
    if count <= CHUNK {
        return run(chunk);
    }
    // Halves that are whole groups of lanes.
    let half = count.div_ceil(2).next_multiple_of(16);
    let (near, far) = chunk.receivers.split_at(half);
    let (low, high) = chunk.radiance.split_at_mut(half);
    let part = |first, receivers, radiance| Chunk {
        cluster: chunk.cluster,
        first,
        receivers,
        radiance,
        eye: chunk.eye,
    };
    let (a, b) = (
        part(chunk.first, near, low),
        part(chunk.first + half, far, high),
    );
    rayon::join(|| split_chunk(a, run), || split_chunk(b, run));
}

/// One chunk, group by group. A lane whose receiver is not covered, or missing at the end, repeats the
/// group's first covered one, so that it neither adds work nor brings in numbers that mean nothing.
struct Groups<'a, K> {
    chunk: Chunk<'a>,
    kernel: &'a K,
}

impl<K: Kernel> Job for Groups<'_, K> {
    #[inline(always)]
    fn run<G: Group + OutlineAll + Outline<C>, const C: usize>(self, token: G::Token)
    where
        [G; C]: Routines<G>,
    {
        let Self { chunk, kernel } = self;
        let zero = G::gather(
            token,
            #[inline(always)]
            |_| 0.0,
        );
        let mut room = K::room(zero);
        let groups = chunk.receivers.chunks(G::COUNT);
        for (index, (receivers, radiance)) in
            groups.zip(chunk.radiance.chunks_mut(G::COUNT)).enumerate()
        {
            let count = receivers.len();
            let covered = |i: usize| {
                i < count
                    && match chunk.eye {
                        None => receivers[i].covered != 0,
                        Some(_) => receivers[i].roughness().is_some(),
                    }
            };
            let Some(spare) = (0..count).find(|&i| covered(i)) else {
                radiance.fill([0.0; 3]);
                continue;
            };
            let lanes = G::each(
                #[inline(always)]
                |i| if covered(i) { i } else { spare },
            );
            let held = G::each(
                #[inline(always)]
                |i| receivers[lanes.as_ref()[i]],
            );
            let held = held.as_ref();
            let first = chunk.first + index * G::COUNT;
            let place = Place {
                cluster: chunk.cluster,
                receivers: G::each(
                    #[inline(always)]
                    |i| first + lanes.as_ref()[i],
                ),
                token,
            };
            // Plain loops and array literals: closures of the standard library's array functions are not always
            // inlined, and would be compiled without the instruction set.
            let position = |k: usize| {
                G::gather(
                    token,
                    #[inline(always)]
                    |i| held[i].position[k],
                )
            };
            let normal = |k: usize| {
                G::gather(
                    token,
                    #[inline(always)]
                    |i| held[i].normal[k],
                )
            };
            let position = [position(0), position(1), position(2)];
            let normal = [normal(0), normal(1), normal(2)];
            let gloss = match chunk.eye {
                None => None,
                Some([x, y, z]) => {
                    let eye = [
                        zero.lift(f64::from(x)),
                        zero.lift(f64::from(y)),
                        zero.lift(f64::from(z)),
                    ];
                    let roughness = G::gather(
                        token,
                        #[inline(always)]
                        |i| held[i].roughness().unwrap_or(1.0),
                    );
                    Some(<G as Outline<C>>::gloss(position, normal, eye, roughness))
                }
            };
            let point = Point {
                position,
                normal,
                // Exact up to some million bodies.
                object: G::gather(
                    token,
                    #[inline(always)]
                    |i| held[i].object as f32,
                ),
                gloss,
            };
            let [red, green, blue] = kernel.shade::<G, C>(&place, &point, &mut room);
            let (red, green, blue) = (red.store(), green.store(), blue.store());
            let (red, green, blue) = (red.as_ref(), green.as_ref(), blue.as_ref());
            for (i, radiance) in radiance.iter_mut().enumerate() {
                *radiance = if covered(i) {
                    [red[i], green[i], blue[i]]
                } else {
                    [0.0; 3]
                };
            }
        }
    }
}
