//! A cluster's spheres in their order, and who hides whom.

use super::gain::gain;
use super::pairs::{by_bodies, by_spheres, joint};
use crate::device::cut::{CutOptions, Cuts};
use crate::device::emission::Emission;
use crate::device::light_cut::{ALWAYS, Cap, Hider, LightCut, Met, NEVER};
use crate::device::light_cuts::LightCuts;
use crate::device::spherical_lights::SphericalLights;
use crate::lanes::path::Path;
use glam::Vec3;
use rayon::prelude::*;
use sh_scene::order::Ball;
use sh_scene::{Blocking, Bounds, Forest, Receiver};
use std::ops::Range;

/// How the spheres that light a cluster are found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightCutOptions {
    /// How coarse they may be.
    pub cut: CutOptions,
    /// What hides what.
    pub blocking: Blocking,
}

impl LightCuts {
    /// Finds the spheres that light every cluster of `receivers`, and their order.
    ///
    /// # Panics
    /// If the order of accumulation is not 2 to 6, or a cluster does not lie within the receivers.
    pub fn find(
        &mut self,
        path: Path,
        receivers: &[Receiver],
        clusters: &[Range<usize>],
        forest: &Forest,
        lights: &SphericalLights,
        options: LightCutOptions,
    ) {
        self.cuts.bound(receivers, clusters, 0..clusters.len());
        let cut = CutOptions {
            ratios: options.cut.ratios && options.blocking != Blocking::Discs,
            ..options.cut
        };
        self.cuts.find_all(path, forest, cut);
        self.orders.resize_with(clusters.len(), LightCut::default);
        self.blocking = options.blocking;
        let cuts = &self.cuts;
        self.orders
            .par_iter_mut()
            .enumerate()
            .for_each(|(cluster, order)| {
                order.find(cuts, cluster, forest, &lights.emission, options.blocking)
            });
    }
}

impl LightCut {
    fn find(
        &mut self,
        cuts: &Cuts,
        cluster: usize,
        forest: &Forest,
        lights: &Emission,
        blocking: Blocking,
    ) {
        self.spheres.clear();
        self.hiders.clear();
        self.before.clear();
        self.runs.clear();
        let Some(bounds) = cuts.bounds_of(cluster) else {
            return;
        };
        let discs = blocking == Blocking::Discs;
        self.meet(bounds, (cuts, cluster), forest, lights, discs);
        self.spheres
            .sort_unstable_by(|a, b| a.power.total_cmp(&b.power).then(a.node.cmp(&b.node)));
        if discs {
            self.find_hiders(bounds, lights);
        } else {
            self.compare(bounds, forest, lights, blocking);
            self.find_runs(blocking);
        }
    }

    /// The spheres of a cluster's cut, in any order.
    fn meet(
        &mut self,
        bounds: &Bounds,
        (cuts, cluster): (&Cuts, usize),
        forest: &Forest,
        lights: &Emission,
        discs: bool,
    ) {
        let blockers = cuts.of(cluster);
        let [front, across] = cuts.nodes_of(cluster);
        for (blockers, nodes, in_front) in [
            (blockers.front, front, true),
            (blockers.across, across, false),
        ] {
            for (&blocker, &node) in blockers.iter().zip(nodes) {
                let mut blocker = blocker;
                if discs {
                    // A node that stands for several is as large as they are together.
                    let together = forest.nodes()[node as usize].area.sqrt();
                    blocker.radius = blocker.radius.min(together);
                }
                self.spheres.push(Met {
                    blocker,
                    node,
                    in_front,
                    gain: gain(bounds.center, node as usize, blocker.radius, forest, lights),
                    hiders_end: 0,
                    power: Ball::new(blocker.center, blocker.radius).power(bounds.center),
                });
            }
        }
    }

    /// How much each sphere hides of each other.
    fn compare(&mut self, bounds: &Bounds, forest: &Forest, lights: &Emission, blocking: Blocking) {
        let Self {
            spheres, before, ..
        } = self;
        let count = spheres.len();
        before.resize(count * count, NEVER);
        for j in 0..count {
            for i in 0..j {
                let pair = [&spheres[i], &spheres[j]];
                let hidden = match blocking {
                    Blocking::Object => by_bodies(pair, bounds.center, forest, lights),
                    _ if joint(pair, lights) => [NEVER; 2],
                    _ => by_spheres(pair, bounds.radius),
                };
                [before[j * count + i], before[i * count + j]] = hidden;
            }
        }
    }

    /// A run ends where no sphere of it shares one with a later: where each hides from all receivers what it can of all
    /// that follow. By spheres there is one run of all.
    fn find_runs(&mut self, blocking: Blocking) {
        let count = self.spheres.len();
        let settled = |i: usize, j: usize| {
            blocking != Blocking::Sphere && self.before[j * count + i] == ALWAYS
        };
        let mut start = 0;
        // The last sphere that is known to be in the run.
        let mut last = 0;
        for i in 0..count {
            let sharing = (last.max(i) + 1..count).rfind(|&j| !settled(i, j));
            last = sharing.unwrap_or(last.max(i));
            if last == i {
                self.runs.push(start..i + 1);
                start = i + 1;
            }
        }
    }

    /// For each sphere those that may cover a part of it for a receiver of the cluster: with radii larger by that of the
    /// cluster, seen from its centre, their discs meet.
    fn find_hiders(&mut self, bounds: &Bounds, lights: &Emission) {
        let Self {
            spheres,
            hiders,
            caps,
            ..
        } = self;
        caps.clear();
        caps.extend(spheres.iter().map(|met| {
            let to = Vec3::from(met.blocker.center) - bounds.center;
            let distance = to.length();
            let sine = (met.blocker.radius + bounds.radius) / distance;
            Cap {
                axis: to / distance,
                sine,
                cosine: (1.0 - sine * sine).max(0.0).sqrt(),
            }
        }));
        for i in 0..spheres.len() {
            let own = caps[i];
            for (j, other) in spheres.iter().enumerate() {
                let cap = caps[j];
                // A cluster that reaches into a sphere may see it anywhere. The sum of both angles may be over 90°.
                let apart = own.sine < 1.0
                    && cap.sine < 1.0
                    && own.axis.dot(cap.axis) < own.cosine * cap.cosine - own.sine * cap.sine;
                if i == j || apart {
                    continue;
                }
                // A sphere without samples lies inside of its body, and is not seen.
                if !lights.shines(other.node) && joint([&spheres[i], other], lights) {
                    continue;
                }
                let share = if i < j {
                    by_spheres([&spheres[i], other], bounds.radius)[1]
                } else {
                    by_spheres([other, &spheres[i]], bounds.radius)[0]
                };
                if share != NEVER {
                    hiders.push(Hider {
                        sphere: j as u32,
                        share,
                    });
                }
            }
            spheres[i].hiders_end = hiders.len() as u32;
        }
    }
}
