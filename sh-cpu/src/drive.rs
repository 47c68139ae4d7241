//! Running a kernel over receivers: lanes side by side, groups of lanes in chunks, chunks on threads.
//!
//! ```text
//! receivers  |---- cluster ----|------ cluster ------|--
//!            |-- chunk --|chunk|-- chunk --|- chunk -|      one task of the thread pool each
//!            |8|8|8|8|8|8|8|8|8|                            one call of the kernel each (4, 8 or 16 lanes)
//! ```
//! Chunks and groups lie at fixed places in their cluster, so the result does not depend on the number of threads.
//! Nothing is allocated.

use crate::accumulate::Point;
use crate::lanes::{Lanes1, Lanes4, Lanes8, Lanes16, enter};
use crate::outline::{Outline, OutlineAll};
use crate::resolve::check_length;
use crate::{Error, Path};
use fearless_simd::Simd;
use sh_core::constants::MAX_ORDER;
use sh_core::{Lane, Routines};
use sh_scene::{Light, Receiver};
use std::ops::Range;

/// Receivers a task: some hundred microseconds of work with a hundred blockers.
const CHUNK: usize = 256;

/// The lowest SH order that there are routines for.
const MIN_ORDER: usize = 2;

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

/// A lane type that is loaded and stored number by number.
pub(crate) trait Group: Lane {
    /// Numbers side by side.
    const COUNT: usize;
    /// Something of each lane.
    type Of<T: Copy + Sync>: Copy + AsRef<[T]> + Sync;
    /// The proof that the processor has the instructions.
    type Token: Copy + Sync;
    fn each<T: Copy + Sync>(value: impl Fn(usize) -> T) -> Self::Of<T>;
    fn gather(token: Self::Token, value: impl Fn(usize) -> f32) -> Self;
    fn store(self) -> Self::Of<f32>;
}

macro_rules! group {
    ($lanes:ident, $count:literal) => {
        impl<S: Simd> Group for $lanes<S> {
            const COUNT: usize = $count;
            type Of<T: Copy + Sync> = [T; $count];
            type Token = S;
            #[inline(always)]
            fn each<T: Copy + Sync>(value: impl Fn(usize) -> T) -> [T; $count] {
                let mut all = [value(0); $count];
                for (i, slot) in all.iter_mut().enumerate() {
                    *slot = value(i);
                }
                all
            }
            #[inline(always)]
            fn gather(token: S, value: impl Fn(usize) -> f32) -> Self {
                let mut values = [0.0; _];
                for (i, slot) in values.iter_mut().enumerate() {
                    *slot = value(i);
                }
                Self::from_array(token, values)
            }
            #[inline(always)]
            fn store(self) -> [f32; $count] {
                self.to_array()
            }
        }
    };
}

group!(Lanes1, 1);
group!(Lanes4, 4);
group!(Lanes8, 8);
group!(Lanes16, 16);

/// Work that is written once for every kind of lane.
pub(crate) trait Job {
    fn run<G: Group + OutlineAll + Outline<C>, const C: usize>(self, token: G::Token)
    where
        [G; C]: Routines<G>;
}

/// What runs one chunk with `$c` coefficients.
macro_rules! chunk_of {
    ($k:ty, $c:literal) => {
        |path, chunk, kernel| {
            let job = Groups { chunk, kernel };
            enter!(path, Lanes, simd => job.run::<Lanes<_>, $c>(simd))
        }
    };
}

/// Receivers of one cluster, and where their radiance goes.
pub(crate) struct Chunk<'a> {
    cluster: usize,
    /// Index of the first receiver.
    first: usize,
    receivers: &'a [Receiver],
    radiance: &'a mut [[f32; 3]],
}

/// What a run works on.
pub(crate) struct Work<'a> {
    pub(crate) path: Path,
    pub(crate) receivers: &'a [Receiver],
    /// Ranges of the receivers, one after another, together all of them.
    pub(crate) clusters: &'a [Range<usize>],
    pub(crate) radiance: &'a mut [[f32; 3]],
}

/// Runs `kernel` with the coefficients of an order for every receiver. Radiance is 0 where a receiver is not covered.
pub(crate) fn drive<K: Kernel>(work: Work, order: usize, kernel: &K) -> Result<(), Error> {
    check_length("radiance", work.receivers.len(), work.radiance.len())?;
    check_clusters(work.clusters, work.receivers.len())?;
    let run: fn(Path, Chunk, &K) = match order {
        2 => chunk_of!(K, 4),
        3 => chunk_of!(K, 9),
        4 => chunk_of!(K, 16),
        5 => chunk_of!(K, 25),
        6 => chunk_of!(K, 36),
        order => return Err(Error::Order { order }),
    };
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
    };
    let (a, b) = (
        part(chunk.first, near, low),
        part(chunk.first + half, far, high),
    );
    rayon::join(|| split_chunk(a, run), || split_chunk(b, run));
}

/// Whether clusters follow each other and hold all receivers.
pub(crate) fn check_clusters(clusters: &[Range<usize>], receivers: usize) -> Result<(), Error> {
    let mut next = 0;
    for (index, range) in clusters.iter().enumerate() {
        if range.start != next || range.end < next {
            return Err(Error::Clusters {
                index,
                range: range.clone(),
                next,
            });
        }
        next = range.end;
    }
    check_length("clusters", receivers, next)
}

/// Whether a light is of an order that there is, and whole.
pub(crate) fn check_light(light: &Light) -> Result<(), Error> {
    let (order, found) = (light.order, light.coefficients.len());
    if !(MIN_ORDER..=MAX_ORDER).contains(&order) {
        return Err(Error::Order { order });
    }
    if found != order * order {
        return Err(Error::Coefficients { order, found });
    }
    Ok(())
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
            let covered = |i: usize| i < count && receivers[i].covered != 0;
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
            let point = Point {
                position: [position(0), position(1), position(2)],
                normal: [normal(0), normal(1), normal(2)],
                // Exact up to some million bodies.
                object: G::gather(
                    token,
                    #[inline(always)]
                    |i| held[i].object as f32,
                ),
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
