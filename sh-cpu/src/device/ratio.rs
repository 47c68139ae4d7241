//! Ratio vectors: how much a node weighs that stands for the leaves below it.
//!
//! The vector w makes the node's log visibility f_b, seen from the middle of a cluster, the best match of its leaves'
//! sum f_d, band by band (Ren et al. 2006, equation 37). Both are sums of zonal functions about directions s, and the
//! dot product of two of them over a band is P_l of the cosine between their directions, so that no basis function has to
//! be evaluated:
//!
//! ```text
//! w_l = Σ_m (f_b)_lm (f_d)_lm / Σ_m (f_b)²_lm = Σ_i F_l(θ_i) P_l(s_i · s_b) / F_l(θ_b)
//! ```
//! F_l has no zero for angular radii up to 30°, which limits θ_max. Vector lanes go over the leaves of all nodes of a
//! cut together.

use super::drive::Job;
use super::logs::Logs;
use super::outline::{Outline, OutlineAll};
use crate::lanes::enter;
use crate::lanes::group::Group;
use crate::lanes::path::Path;
use glam::Vec3;
use sh_core::{Routines, for_order};
use sh_scene::{Blocker, Node};

/// A ball as the middle of the cluster sees it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Detail {
    /// Its centre from there, in metres.
    pub(crate) towards: [f32; 3],
    /// Its radius, in metres.
    pub(crate) radius: f32,
    /// What its logarithm is multiplied with.
    pub(crate) weight: f32,
}

/// A detail, and the direction s_b of the node that it is a part of.
#[derive(Clone, Copy, Debug, Default)]
struct Entry {
    detail: Detail,
    axis: [f32; 3],
}

/// A node that needs a ratio vector.
#[derive(Clone, Copy, Debug)]
struct Owner {
    /// Whether its blocker is among those in front, and where there.
    in_front: bool,
    blocker: usize,
    /// The entry of the node itself; those of its details follow.
    first: usize,
}

/// The nodes of a cut that need ratio vectors, and what is below them. Its memory is kept.
#[derive(Clone, Debug, Default)]
pub(crate) struct Ratios {
    entries: Vec<Entry>,
    owners: Vec<Owner>,
    /// F_l(θ) P_l(s · s_b) of each entry.
    logs: Vec<[f32; 8]>,
}

impl Ratios {
    pub(crate) fn clear(&mut self) {
        self.entries.clear();
        self.owners.clear();
    }

    /// Begins a node: its own entry is the first. `blocker` is the place that it will have among those in front or
    /// those across.
    pub(crate) fn start(&mut self, from: Vec3, node: &Node, in_front: bool, blocker: usize) {
        let towards = Vec3::from(node.center) - from;
        self.owners.push(Owner {
            in_front,
            blocker,
            first: self.entries.len(),
        });
        self.entries.push(Entry {
            detail: Detail {
                towards: towards.into(),
                radius: node.radius,
                weight: 1.0,
            },
            axis: towards.normalize_or_zero().into(),
        });
    }

    /// Adds what stands below the node that was begun last.
    pub(crate) fn add(&mut self, detail: Detail) {
        let axis = self
            .owners
            .last()
            .map_or([0.0; 3], |owner| self.entries[owner.first].axis);
        self.entries.push(Entry { detail, axis });
    }

    /// Writes the ratio vectors into the blockers.
    pub(crate) fn find(
        &mut self,
        path: Path,
        accumulation: usize,
        of: Logs,
        front: &mut [Blocker],
        across: &mut [Blocker],
    ) {
        if self.owners.is_empty() {
            return;
        }
        self.logs.resize(self.entries.len(), [0.0; 8]);
        let job = Bands {
            of,
            entries: &self.entries,
            logs: &mut self.logs,
        };
        for_order!(
            accumulation, A => enter!(path, Lanes, simd => job.run::<Lanes<_>, A>(simd))
        );
        let ends = self.owners.iter().skip(1).map(|owner| owner.first);
        let ends = ends.chain([self.entries.len()]);
        for (owner, end) in self.owners.iter().zip(ends) {
            let mut sum = [0.0; 8];
            let below = owner.first + 1..end;
            for (log, entry) in self.logs[below.clone()].iter().zip(&self.entries[below]) {
                for (sum, log) in sum.iter_mut().zip(log) {
                    *sum += entry.detail.weight * log;
                }
            }
            let own = &self.logs[owner.first];
            let list = if owner.in_front {
                &mut *front
            } else {
                &mut *across
            };
            let weights = &mut list[owner.blocker].weights;
            for l in 0..accumulation {
                // Leaves without extent block nothing.
                weights[l] = if own[l] == 0.0 { 0.0 } else { sum[l] / own[l] };
            }
        }
    }
}

/// The entries' logarithms, in lanes.
struct Bands<'a> {
    of: Logs,
    entries: &'a [Entry],
    logs: &'a mut [[f32; 8]],
}

impl Job for Bands<'_> {
    #[inline(always)]
    fn run<G: Group + OutlineAll + Outline<C>, const C: usize>(self, token: G::Token)
    where
        [G; C]: Routines<G>,
    {
        let Self { of, entries, logs } = self;
        for (entries, logs) in entries.chunks(G::COUNT).zip(logs.chunks_mut(G::COUNT)) {
            let last = entries.len() - 1;
            let held = G::each(
                #[inline(always)]
                |i| entries[i.min(last)],
            );
            let held = held.as_ref();
            let towards = |k: usize| {
                G::gather(
                    token,
                    #[inline(always)]
                    |i| held[i].detail.towards[k],
                )
            };
            let axis = |k: usize| {
                G::gather(
                    token,
                    #[inline(always)]
                    |i| held[i].axis[k],
                )
            };
            let towards = [towards(0), towards(1), towards(2)];
            let axis = [axis(0), axis(1), axis(2)];
            let radius = G::gather(
                token,
                #[inline(always)]
                |i| held[i].detail.radius,
            );
            let bands = G::ratio_logs(towards, radius, axis, of);
            for (l, band) in bands.iter().enumerate().take(<[G; C]>::ORDER) {
                let band = band.store();
                for (log, value) in logs.iter_mut().zip(band.as_ref()) {
                    log[l] = *value;
                }
            }
        }
    }
}
