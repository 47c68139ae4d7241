//! In which order a cluster's receivers meet the spheres that light them, and which of these hide which.
//!
//! Of two disjoint spheres the one of the lesser *power* |c − p|² − r² cannot be hidden by the other from p: the plane on
//! which both powers are equal parts the spheres, and p lies on the side of the lesser. So the order by power is always
//! right, has no cycles, and where it swaps, for a receiver on that plane, neither sphere covers any of the other:
//! nothing jumps. Guerrero et al. 2008 go by the distance of centres instead, of spheres or of whole bodies, which can
//! be wrong for both (section 8.4). Spheres of different bodies that intersect change their order gradually, over the
//! width of the circle in which they cut each other. So do those of one body where lights are discs
//! ([`Blocking::within_bodies`]): each hides half of the lens in which both are seen from afar, and together they send on
//! what their union does. Otherwise they do not hide each other: what one hides of the other is dark in its samples
//! (section 4.2).
//!
//! A node of the forest that stands for several spheres gives each cluster what these give together: its *reflection
//! ratio* (equation 25) brings its light, seen from the middle of the cluster, to the sum of theirs, channel by channel.
//! So clusters whose cuts differ meet without a seam.
//!
//! Powers are compared over the whole cluster. Where lights are discs ([`Blocking::Discs`]), each has a list of the spheres
//! that may cover a part of it somewhere in the cluster: those nearer whose disc comes near enough.
//!
//! Where visibilities are differences of exponentials, all that is nearer is summed up. Sorted by them, spheres fall into *runs*: all of a run hide from all
//! receivers what they can of all of a later one. What was summed up for a run serves all that follow, as in the
//! paper's per-object blocking; only within a run pairs have to be looked at one by one, as in its per-sphere
//! blocking. Bodies apart are runs of their own, or several; bodies that interlock share one.

mod gain;
mod pairs;

use crate::cut::{CutOptions, Cuts};
use crate::{Path, SphericalLights};
use gain::gain;
use glam::Vec3;
use pairs::{by_bodies, by_spheres, joint, power};
use rayon::prelude::*;
use sh_scene::{Blocker, Blocking, Bounds, Forest, Receiver};
use std::ops::Range;

/// The spheres that light each cluster of receivers, in the order in which light meets them. Their memory is kept from
/// frame to frame.
#[derive(Clone, Debug, Default)]
pub struct LightCuts {
    cuts: Cuts,
    orders: Vec<LightCut>,
    blocking: Blocking,
}

/// The spheres of one cluster.
#[derive(Clone, Debug, Default)]
pub struct LightCut {
    pub(crate) spheres: Vec<Met>,
    /// What may cover a part of a sphere's disc.
    pub(crate) hiders: Vec<Hider>,
    /// Entry `i * spheres + j`: how much sphere j hides of sphere i, [`NEVER`] or [`ALWAYS`] or a number between.
    pub(crate) before: Vec<f32>,
    pub(crate) runs: Vec<Range<usize>>,
    /// Of each sphere, as the whole cluster sees it.
    caps: Vec<Cap>,
}

/// The directions in which some receiver of a cluster may see a sphere, from the cluster's centre.
#[derive(Clone, Copy, Debug)]
struct Cap {
    axis: Vec3,
    /// Of its angular radius. At least 1: every direction.
    sine: f32,
    cosine: f32,
}

/// A sphere that light meets on its way.
#[derive(Clone, Copy, Debug)]
pub struct Met {
    pub(crate) blocker: Blocker,
    /// The forest's node that it is.
    pub(crate) node: u32,
    /// Whether it lies wholly in front of all receivers' tangent planes.
    pub(crate) in_front: bool,
    /// What its light is multiplied with, in three channels.
    pub(crate) gain: [f32; 3],
    /// Where its hiders end in the list of all; they begin where those of the one before it end.
    pub(crate) hiders_end: u32,
    power: f32,
}

/// A sphere that hides a part of another.
#[derive(Clone, Copy, Debug)]
pub struct Hider {
    /// Which of the cluster's spheres.
    pub(crate) sphere: u32,
    /// How much of what it covers, as in [`LightCut::before`].
    pub(crate) share: f32,
}

/// One sphere hides nothing of another.
pub(crate) const NEVER: f32 = 0.0;
/// It hides all that it covers. Between the two, the share that it hides is ½ plus this times the difference of powers.
pub(crate) const ALWAYS: f32 = f32::INFINITY;

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
                order.find(cuts, cluster, forest, lights, options.blocking)
            });
    }

    /// How many clusters there are.
    pub fn clusters(&self) -> usize {
        self.orders.len()
    }

    /// How many pairs of a receiver and a sphere there are in all clusters together.
    pub fn pairs(&self) -> usize {
        self.cuts.pairs()
    }

    /// The mean number of spheres in a run, over all clusters: 1 where nothing interlocks, and what has been summed up
    /// always serves on. 0 where there are no runs.
    pub fn run_length(&self) -> f32 {
        let runs = self.orders.iter().flat_map(|order| &order.runs);
        let (count, spheres) = runs.fold((0, 0), |(count, spheres), run| {
            (count + 1, spheres + run.len())
        });
        spheres as f32 / count.max(1) as f32
    }

    /// The mean number of spheres that may hide a part of one, and are looked at for each receiver, over all clusters:
    /// where lights are discs those whose discs may meet, otherwise those that share its run.
    pub fn hiders_per_light(&self) -> f32 {
        let (mut hiders, mut spheres) = (0, 0);
        for order in &self.orders {
            let in_runs = order.runs.iter().map(|run| run.len() * (run.len() - 1));
            hiders += order.hiders.len() + in_runs.sum::<usize>();
            spheres += order.spheres.len();
        }
        hiders as f32 / spheres.max(1) as f32
    }

    /// What hides what.
    pub(crate) fn blocking(&self) -> Blocking {
        self.blocking
    }

    pub(crate) fn of(&self, cluster: usize) -> &LightCut {
        &self.orders[cluster]
    }
}

/// How the spheres that light a cluster are found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightCutOptions {
    /// How coarse they may be.
    pub cut: CutOptions,
    /// What hides what.
    pub blocking: Blocking,
}

impl LightCut {
    fn find(
        &mut self,
        cuts: &Cuts,
        cluster: usize,
        forest: &Forest,
        lights: &SphericalLights,
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
        lights: &SphericalLights,
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
                    power: power(bounds.center, blocker.center.into(), blocker.radius),
                });
            }
        }
    }

    /// How much each sphere hides of each other.
    fn compare(
        &mut self,
        bounds: &Bounds,
        forest: &Forest,
        lights: &SphericalLights,
        blocking: Blocking,
    ) {
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
    fn find_hiders(&mut self, bounds: &Bounds, lights: &SphericalLights) {
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
