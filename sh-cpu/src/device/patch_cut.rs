//! The patches that light a cluster of receivers, and the spheres that may hide them.

use super::patch_lights::Placed;
use glam::Vec3;
use rayon::prelude::*;
use sh_core::constants::{
    BEHIND, COARSER, COARSEST, ENTIRE, JOINED, LIFTED, NEAR, REACH, REFINED, REGION_PATCHES, ROOM,
    SPLIT, WIDENED, WITHIN,
};
use sh_scene::basis::{Disc, Patch};
use sh_scene::{Blocker, Bounds, Forest, Limits, Receiver, Side};
use std::ops::Range;

/// The patches that light each cluster, and what hides them. Their memory is kept from frame to frame.
#[derive(Clone, Debug, Default)]
pub struct PatchCuts {
    pub clusters: Vec<PatchCut>,
    /// Whether they are those of what there is now.
    found: bool,
}

/// What lights a cluster.
#[derive(Clone, Debug, Default)]
pub struct PatchCut {
    pub sources: Vec<Source>,
    /// Spheres that may hide a part of them.
    pub hiders: Vec<Blocker>,
    /// For each part those that may hide it: the how many-th they are.
    pub hiding: Vec<u8>,
    pub parts: Vec<Part>,
    /// Patches around its receivers of the bodies that these are of.
    pub around: Vec<u32>,
    /// The bodies that its receivers are of.
    objects: Vec<u32>,
    /// The nodes of its cut.
    nodes: Vec<u32>,
    /// Those of the hiders that may hide a body at all.
    before: Vec<u8>,
}

/// A body that lights a cluster.
#[derive(Clone, Copy, Debug)]
pub struct Source {
    pub body: u32,
    /// Where its parts and what is around end in the lists of all; they begin where those of the one before it end.
    pub parts_end: u32,
    pub around_end: u32,
    /// Whether some receiver is of the body itself.
    pub own: bool,
}

/// A region of a body that some receiver may see.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    pub region: u32,
    /// Whether it counts as a whole for some receiver.
    pub whole: bool,
    /// Bit m: its patch m counts for some.
    pub patches: u32,
    /// Where those that may hide it end in the list of all; they begin where those of the part before it end.
    pub hiding_end: u32,
}

impl PatchCuts {
    /// Says that they have to be found anew.
    pub(crate) fn forget(&mut self) {
        self.found = false;
    }

    /// Whether they were found since they were to be.
    pub(crate) fn found(&self) -> bool {
        self.found
    }

    /// Finds what lights every cluster of receivers.
    pub fn find(
        &mut self,
        (receivers, clusters): (&[Receiver], &[Range<usize>]),
        forest: &Forest,
        bodies: &[Placed],
        limits: Limits,
    ) {
        self.found = true;
        self.clusters.resize_with(clusters.len(), PatchCut::default);
        let each = self.clusters.par_iter_mut().zip(clusters);
        each.for_each(|(own, range)| {
            let receivers = &receivers[range.clone()];
            own.clear();
            if let Some(bounds) = Bounds::of(receivers) {
                own.objects(receivers);
                own.cut(&bounds, forest, limits);
                own.see(&bounds, forest);
                own.find(&bounds, bodies);
            }
        });
    }

    pub(crate) fn bytes(&self) -> usize {
        let of = |cut: &PatchCut| {
            size_of_val(&cut.sources[..])
                + size_of_val(&cut.hiders[..])
                + size_of_val(&cut.hiding[..])
                + size_of_val(&cut.parts[..])
                + size_of_val(&cut.around[..])
                + size_of_val(&cut.nodes[..])
                + size_of_val(&cut.before[..])
        };
        self.clusters.iter().map(of).sum()
    }
}

impl PatchCut {
    fn clear(&mut self) {
        self.sources.clear();
        self.hiders.clear();
        self.hiding.clear();
        self.parts.clear();
        self.around.clear();
        self.objects.clear();
        self.nodes.clear();
    }

    /// The nodes of the cut: a coarser one where there would be more than are looked at.
    fn cut(&mut self, bounds: &Bounds, forest: &Forest, mut limits: Limits) {
        for _ in 0..COARSEST {
            self.nodes.clear();
            let nodes = &mut self.nodes;
            forest.cut(bounds.center, bounds.radius, limits, |at| {
                nodes.push(at as u32)
            });
            if nodes.len() <= ROOM {
                return;
            }
            limits.sin_max = (limits.sin_max * COARSER).max(COARSER - 1.0);
        }
        self.nodes.truncate(ROOM);
    }

    fn objects(&mut self, receivers: &[Receiver]) {
        for receiver in receivers.iter().filter(|r| r.covered != 0) {
            if self.objects.last() != Some(&receiver.object)
                && !self.objects.contains(&receiver.object)
            {
                self.objects.push(receiver.object);
            }
        }
    }

    fn find(&mut self, bounds: &Bounds, bodies: &[Placed]) {
        for (body, placed) in (0..).zip(bodies).filter(|(_, body)| body.placed) {
            let own = self.objects.contains(&placed.object);
            // To its own receivers a body gives what its functions say.
            let others = !own || self.objects.len() > 1;
            let before = self.parts.len();
            if others && bounds.side(placed.center, placed.radius) != Side::Behind {
                self.parts_of(placed, bounds);
            }
            let seen = self.parts.len() > before;
            if seen {
                self.hide(placed, bounds, before);
            }
            if own {
                self.around(placed, bounds);
            }
            if own || seen {
                self.sources.push(Source {
                    body,
                    parts_end: self.parts.len() as u32,
                    around_end: self.around.len() as u32,
                    own,
                });
            }
        }
    }

    /// Patches of a body that tell some receiver what it gives itself.
    fn around(&mut self, placed: &Placed, bounds: &Bounds) {
        let from = placed.local.transform_point3(bounds.center);
        let within = bounds.radius / placed.scale;
        let near = |patch: &Patch| {
            let disc = &patch.whole.disc;
            let reach = WITHIN as f32 * disc.area.sqrt();
            Vec3::from(disc.center).distance(from) < reach + within
        };
        let all = (0..).zip(placed.patches);
        let near = all.filter(|(_, patch)| near(patch));
        self.around.extend(near.map(|(at, _)| at));
    }

    fn parts_of(&mut self, placed: &Placed, bounds: &Bounds) {
        let shape = placed.shape;
        let from = placed.local.transform_point3(bounds.center);
        let within = bounds.radius / placed.scale;
        let patches = placed.patches.chunks_exact(REGION_PATCHES);
        for (index, (region, patches)) in (0..).zip(shape.regions.iter().zip(patches)) {
            let center = Vec3::from(region.center);
            let world = placed.world(center);
            if bounds.side(world, region.radius * placed.scale) == Side::Behind {
                continue;
            }
            let disc = &region.whole.disc;
            // How far it is, from where on it counts as a whole, and from where on as nothing else.
            let (far, [refined, entire]) = match disc.area > 0.0 {
                true => (
                    Vec3::from(disc.center).distance(from),
                    [SPLIT, JOINED].map(|roots| roots as f32 * disc.area.sqrt()),
                ),
                false => (
                    center.distance(from),
                    [REFINED, ENTIRE].map(|radii| radii as f32 * region.radius),
                ),
            };
            let whole = far + within > refined;
            let mut mask = 0;
            if far - within < entire {
                for (bit, patch) in patches.iter().enumerate() {
                    let faces = |disc: &Disc| {
                        let height = Vec3::from(disc.normal).dot(from - Vec3::from(disc.center));
                        let behind = BEHIND * LIFTED * f64::from(disc.area).sqrt();
                        height + within + behind as f32 > 0.0
                    };
                    let mut discs = std::iter::once(&patch.whole.disc).chain(&patch.discs);
                    mask |= u32::from(discs.any(faces)) << bit;
                }
            }
            if whole || mask != 0 {
                self.parts.push(Part {
                    region: index,
                    whole,
                    patches: mask,
                    hiding_end: 0,
                });
            }
        }
    }

    /// Spheres that some receiver may see. One that stands for several is as large as they are together.
    fn see(&mut self, bounds: &Bounds, forest: &Forest) {
        let balls = self.nodes.iter().map(|&at| {
            let node = &forest.nodes()[at as usize];
            Blocker {
                radius: node.radius.min(node.area.sqrt()),
                ..Blocker::of(node)
            }
        });
        let seen = |ball: &Blocker| bounds.side(ball.center.into(), ball.radius) != Side::Behind;
        self.hiders.extend(balls.filter(seen));
    }

    /// Spheres of other bodies that may hide a part of this one, whose parts begin at `first`, from some receiver.
    fn hide(&mut self, placed: &Placed, bounds: &Bounds, first: usize) {
        // There are no more than 128.
        let all = (0..=u8::MAX).zip(&self.hiders);
        let whole = (placed.center, placed.radius);
        let before =
            all.filter(|(_, ball)| ball.object != placed.object && may_hide(ball, whole, bounds));
        self.before.clear();
        self.before.extend(before.map(|(at, _)| at));
        for part in &mut self.parts[first..] {
            let region = &placed.shape.regions[part.region as usize];
            let ball = (
                placed.world(region.center.into()),
                region.radius * placed.scale,
            );
            let hiders = &self.hiders;
            let before = self.before.iter().copied();
            let hiding = before.filter(|&at| may_hide(&hiders[usize::from(at)], ball, bounds));
            self.hiding.extend(hiding);
            part.hiding_end = self.hiding.len() as u32;
        }
    }
}

/// Whether a sphere, or what stands for it where the horizon cuts it, may hide a part of a ball from some receiver of a cluster:
/// with radii larger by that of the cluster, seen from its middle, their discs meet, and it does not begin behind where the
/// ball ends.
fn may_hide(hider: &Blocker, (center, radius): (Vec3, f32), bounds: &Bounds) -> bool {
    let [to, towards] = [center, hider.center.into()].map(|p: Vec3| p - bounds.center);
    let [far, near] = [to, towards].map(Vec3::length);
    if near - hider.radius > far + radius + 2.0 * bounds.radius {
        return false;
    }
    let wide = [(radius, far), (REACH * hider.radius, near)];
    let [sine, other] = wide.map(|(radius, far)| (radius + WIDENED * bounds.radius) / far);
    // A cluster that reaches into a ball may see it anywhere, as one that is near a sphere may see what stands for it.
    if !(sine < 1.0 && other < 1.0 && near > NEAR * hider.radius + bounds.radius) {
        return true;
    }
    let [a, b] = [sine, other].map(|sine| (1.0 - sine * sine).max(0.0).sqrt());
    to.dot(towards) >= far * near * (a * b - sine * other)
}
