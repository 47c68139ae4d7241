//! The spheres that light a cluster, as receivers meet them.

use glam::Vec3;
use sh_scene::Blocker;
use std::ops::Range;

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
