//! The spheres that light clusters, as the passes read them.

use super::cut::Cuts;
use glam::Vec3;
use sh_scene::{Blocker, Blocking};
use std::ops::Range;

/// The spheres that light each cluster of receivers, in the order in which light meets them. Their memory is kept from
/// frame to frame.
#[derive(Clone, Debug, Default)]
pub struct LightCuts {
    pub(super) cuts: Cuts,
    pub(super) orders: Vec<LightCut>,
    pub(super) blocking: Blocking,
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
    pub(super) caps: Vec<Cap>,
}

/// The directions in which some receiver of a cluster may see a sphere, from the cluster's centre.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cap {
    pub(super) axis: Vec3,
    /// Of its angular radius. At least 1: every direction.
    pub(super) sine: f32,
    pub(super) cosine: f32,
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
    pub(super) power: f32,
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
