//! The cut pass: which blockers a cluster of receivers needs, and how much each of them weighs.
//!
//! A node of the cut that is no leaf stands for all leaves below it, with a ratio vector that makes it weigh as much
//! as they do, seen from the middle p* of the cluster (Ren et al. 2006, section 6.3). A group of leaves that is smaller
//! than θ_min counts as one cap of their joint cross-section, to which its log visibility is in proportion.

use super::accumulate::Blockers;
use super::behind::Behind;
use super::horizon::{is_below, is_far};
use super::logs::Logs;
use super::ratio::{Detail, Ratios};
use crate::lanes::path::Path;
use glam::Vec3;
use rayon::prelude::*;
use sh_core::{ORDERS, OrderError};
use sh_scene::order::MOST_LAMPS;
use sh_scene::{Blocker, Bounds, Forest, Light, Limits, Node, Receiver, Side, Sphere};
use std::ops::Range;

/// The blockers of each cluster of receivers. Their memory is kept from frame to frame.
#[derive(Clone, Debug, Default)]
pub struct Cuts {
    cuts: Vec<Cut>,
}

/// The blockers of one cluster.
#[derive(Clone, Debug, Default)]
struct Cut {
    front: Vec<Blocker>,
    across: Vec<Blocker>,
    /// Which nodes of the forest those in front are, and those across.
    nodes: [Vec<u32>; 2],
    receivers: usize,
    ratios: Ratios,
    /// None where nothing is covered.
    bounds: Option<Bounds>,
    /// Bit i: the light's emitter i gives nothing to any receiver.
    dark: u64,
    /// What does not hide lamps that are before it.
    behind: Behind,
    /// Nodes that were left out because they are too small.
    small: usize,
}

/// How a cut is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CutOptions {
    /// How coarse it may be.
    pub limits: Limits,
    /// Whether nodes that are no leaves get ratio vectors. Without them they count as they are, larger than what they
    /// stand for, and clusters that differ in their cuts differ in their shadows: for comparison only.
    pub ratios: bool,
    /// The order of accumulation, 2 to 6.
    pub accumulation: usize,
}

impl Cuts {
    /// Measures clusters, which are ranges of `receivers`: where they are and which way they face. `which` of them: all
    /// at first, and then those whose receivers have moved.
    ///
    /// # Panics
    /// If a range does not lie within the receivers, or `which` within the clusters.
    pub fn bound(
        &mut self,
        receivers: &[Receiver],
        clusters: &[Range<usize>],
        which: Range<usize>,
    ) {
        self.cuts.resize_with(clusters.len(), Cut::default);
        self.cuts[which.clone()]
            .par_iter_mut()
            .zip(&clusters[which])
            .for_each(|(cut, range)| {
                let receivers = &receivers[range.clone()];
                cut.bounds = Bounds::of(receivers);
                cut.dark = 0;
                cut.receivers = receivers.iter().filter(|r| r.covered != 0).count();
            });
    }

    /// Finds the blockers of every cluster that has been measured; with a hierarchy those are left out that are
    /// [too small to matter](Forest::is_negligible). Of the light's lamps it finds out which may have blockers behind them,
    /// that do not hide them then; those beyond the [32nd](MOST_LAMPS) are hidden by all. Clusters are spread
    /// over the threads of the current rayon pool.
    ///
    /// # Panics
    /// If the order of accumulation is not 2 to 6.
    pub fn find(&mut self, path: Path, forest: &Forest, light: &Light, options: CutOptions) {
        self.find_with(path, forest, options, Logs::Shading);
        self.part(light, forest);
    }

    /// As [`find`](Self::find), with those that are too small and without lamps: for spheres that are lights, which may be
    /// small and bright.
    ///
    /// # Panics
    /// As [`find`](Self::find).
    pub fn find_all(&mut self, path: Path, forest: &Forest, options: CutOptions) {
        self.find_with(path, forest, options, Logs::Saturating);
    }

    fn find_with(&mut self, path: Path, forest: &Forest, options: CutOptions, of: Logs) {
        assert!(
            ORDERS.contains(&options.accumulation),
            "{}",
            OrderError(options.accumulation)
        );
        self.cuts
            .par_iter_mut()
            .for_each(|cut| cut.find(path, forest, options, of));
    }

    /// Finds out which lamps are below the horizon of every receiver of a cluster that has been measured, so that nothing is
    /// computed for them there: those of which each receiver would get nothing, to the bit. To be called after
    /// [`bound`](Self::bound), which forgets about it, and before [`find`](Self::find). Lamps beyond the 64th are always
    /// computed.
    pub fn dim(&mut self, light: &Light) {
        if light.emitters.is_empty() {
            return;
        }
        self.cuts.par_iter_mut().for_each(|cut| {
            let Some(bounds) = &cut.bounds else {
                return;
            };
            for (i, emitter) in light.emitters.iter().enumerate().take(64) {
                let dark = is_below(emitter, bounds);
                cut.dark |= u64::from(dark) << i;
            }
        });
    }

    fn part(&mut self, light: &Light, forest: &Forest) {
        if light.emitters.is_empty() {
            return;
        }
        self.cuts.par_iter_mut().for_each(|cut| {
            let Some(bounds) = &cut.bounds else {
                return;
            };
            let blockers = Blockers {
                front: &cut.front,
                across: &cut.across,
            };
            let nodes = cut.nodes.each_ref().map(|nodes| &nodes[..]);
            for (i, emitter) in light.emitters.iter().enumerate().take(MOST_LAMPS) {
                if cut.dark >> i & 1 == 0 {
                    cut.behind
                        .find((i, emitter), bounds, forest, blockers, nodes);
                }
            }
        });
    }

    /// Which lamps give nothing to a cluster.
    pub(crate) fn dark(&self, cluster: usize) -> u64 {
        self.cuts[cluster].dark
    }

    /// Which blockers do not hide which lamps of a cluster.
    pub(crate) fn behind(&self, cluster: usize) -> &Behind {
        &self.cuts[cluster].behind
    }

    /// How many pairs of a cluster and a lamp below its horizon there are.
    pub fn lamps_below(&self) -> usize {
        let dark = self.cuts.iter().map(|cut| cut.dark.count_ones() as usize);
        dark.sum()
    }

    /// How many nodes were left out of the clusters' cuts, because they are too small to matter there.
    pub fn too_small(&self) -> usize {
        self.cuts.iter().map(|cut| cut.small).sum()
    }

    /// One cluster of so many receivers, with every sphere as a blocker that each receiver looks at itself, and every lamp
    /// of `light` by itself.
    pub fn everything(spheres: &[Sphere], receivers: usize, light: &Light) -> Self {
        let finite = spheres.iter().copied().filter(Sphere::is_finite);
        let mut cut = Cut {
            front: Vec::new(),
            across: finite.map(Blocker::new).collect(),
            receivers,
            ..Cut::default()
        };
        for lamp in light.emitters.iter().enumerate() {
            cut.behind.take_all(lamp, &cut.across);
        }
        Self { cuts: vec![cut] }
    }

    /// The blockers of a cluster.
    pub fn of(&self, cluster: usize) -> Blockers<'_> {
        let cut = &self.cuts[cluster];
        Blockers {
            front: &cut.front,
            across: &cut.across,
        }
    }

    /// Which nodes of the forest the blockers of a cluster are: those in front, and those across.
    pub(crate) fn nodes_of(&self, cluster: usize) -> [&[u32]; 2] {
        self.cuts[cluster].nodes.each_ref().map(|nodes| &nodes[..])
    }

    /// Where a cluster is, if anything in it is covered.
    pub(crate) fn bounds_of(&self, cluster: usize) -> Option<&Bounds> {
        self.cuts[cluster].bounds.as_ref()
    }

    /// How many clusters there are.
    pub fn clusters(&self) -> usize {
        self.cuts.len()
    }

    /// Bytes that all cuts take.
    pub fn bytes(&self) -> usize {
        let lists = |cut: &Cut| {
            let [front, across] = cut.nodes.each_ref().map(|nodes| size_of_val(&nodes[..]));
            let blockers = size_of_val(&cut.front[..]) + size_of_val(&cut.across[..]);
            blockers + front + across + cut.behind.bytes()
        };
        size_of_val(&self.cuts[..]) + self.cuts.iter().map(lists).sum::<usize>()
    }

    /// How many receivers there are in all clusters together.
    pub fn receivers(&self) -> usize {
        self.cuts.iter().map(|cut| cut.receivers).sum()
    }

    /// How many pairs of a receiver and a blocker there are in all clusters together.
    pub fn pairs(&self) -> usize {
        let of = |cut: &Cut| (cut.front.len() + cut.across.len()) * cut.receivers;
        self.cuts.iter().map(of).sum()
    }
}

impl Cut {
    fn find(&mut self, path: Path, forest: &Forest, options: CutOptions, of: Logs) {
        let Self {
            front,
            across,
            nodes: [nodes_front, nodes_across],
            ratios,
            bounds,
            behind,
            small,
            ..
        } = self;
        *small = 0;
        behind.clear();
        front.clear();
        across.clear();
        nodes_front.clear();
        nodes_across.clear();
        ratios.clear();
        let Some(bounds) = bounds else {
            return;
        };
        let nodes = forest.nodes();
        let limits = options.limits;
        let shading = of == Logs::Shading;
        let skip_small = shading && limits.sin_max > 0.0;
        forest.cut(bounds.center, bounds.radius, limits, |at| {
            let node = &nodes[at];
            if skip_small && forest.is_negligible(at, bounds.center, bounds.radius) {
                *small += 1;
                return;
            }
            let side = bounds.side(node.center.into(), node.radius);
            let (list, names, in_front) = match side {
                Side::Behind => return,
                Side::Front if is_far(node, bounds) => (&mut *front, &mut *nodes_front, true),
                _ => (&mut *across, &mut *nodes_across, false),
            };
            if !node.is_leaf(at) && options.ratios {
                ratios.start(bounds.center, node, in_front, list.len());
                details(bounds.center, nodes, at, limits.sin_min, shading, ratios);
            }
            names.push(at as u32);
            let mut blocker = Blocker::of(node);
            if !(shading && node.is_leaf(at)) {
                blocker.weights = [1.0; 6];
            }
            list.push(blocker);
        });
        ratios.find(path, options.accumulation, of, front, across);
    }
}

/// What is summed up for the node at `at`: leaves, and groups of them that are small.
fn details(
    from: Vec3,
    nodes: &[Node],
    at: usize,
    sin_min: f32,
    weighted: bool,
    ratios: &mut Ratios,
) {
    let end = nodes[at].skip as usize;
    let mut at = at + 1;
    while at < end {
        let node = &nodes[at];
        let towards = Vec3::from(node.center) - from;
        let small = node.radius * node.radius < sin_min * sin_min * towards.length_squared();
        if small || node.is_leaf(at) {
            ratios.add(Detail {
                towards: towards.into(),
                radius: node.area.sqrt().min(node.radius),
                weight: if weighted { node.weight } else { 1.0 },
            });
            at = node.skip as usize;
        } else {
            at += 1;
        }
    }
}
