//! The tree of all blocker spheres.

use super::build::{Part, raise};
use super::{Blocker, Limits};
use crate::Sphere;
use bytemuck::{Pod, Zeroable};
use glam::Vec3;
use sh_core::constants::NEGLIGIBLE;
use std::ops::Range;

/// A node of the tree: 48 bytes, as `struct Node { center: vec3f, radius: f32, area: f32, parent: u32, skip: u32,
/// sphere: u32, weight: f32, object: u32 }` in WGSL.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Node {
    /// Centre of a ball that holds all leaves below, in metres.
    pub center: [f32; 3],
    /// Its radius.
    pub radius: f32,
    /// The sum of the squared radii of all leaves below: their joint cross-section over π.
    pub area: f32,
    /// Index of the node above; the root has its own.
    pub parent: u32,
    /// Index of the first node that is not below this one. The next one: this is a leaf.
    pub skip: u32,
    /// Which sphere of the scene a leaf is; `u32::MAX` for others.
    pub sphere: u32,
    /// What a leaf's log visibility is multiplied with; of others the mean of those below by their squared radii.
    pub weight: f32,
    /// The body that all leaves below are of, as [`crate::Receiver::object`] has it; 0 where they are of several.
    pub object: u32,
    /// 0.
    pub unused: [u32; 2],
}

impl Node {
    /// Whether the node of index `at` has nothing below it.
    pub fn is_leaf(&self, at: usize) -> bool {
        self.skip as usize == at + 1
    }
}

/// All blocker spheres of a scene in one tree, average branching 4: a tree for each object, and above them a tree of
/// objects.
///
/// ```text
/// nodes   | root | object 0 | a | leaf | leaf | b | leaf | object 1 …    parents before children, depth first
/// ```
/// Whatever lies below a node follows it directly, up to its `skip`. The topology stays as it was built; bounds are
/// renewed from below by [`Forest::update`] when spheres have moved (their memory is reused).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Forest {
    nodes: Vec<Node>,
    spheres: usize,
    /// What each sphere's log visibility is multiplied with.
    weights: Vec<f32>,
    /// The node that stands for each object; that of no spheres has none.
    roots: Vec<Option<u32>>,
}

impl Forest {
    /// Builds the tree. `spheres` are those of all objects, one object after another, in world space;
    /// `counts` says how many each object has.
    ///
    /// The time grows in proportion to the number of spheres.
    ///
    /// # Panics
    /// If the counts do not add up to the number of spheres.
    ///
    /// ```
    /// use sh_scene::{Forest, Limits, Sphere};
    /// let row: Vec<_> = (0..9).map(|i| Sphere { center: [i as f32, 0.0, 0.0], radius: 0.5 }).collect();
    /// let forest = Forest::new(&row, &[9]);
    /// assert_eq!(forest.nodes()[0].skip as usize, forest.nodes().len());
    /// assert!(forest.nodes()[0].radius >= 4.5);
    /// ```
    pub fn new(spheres: &[Sphere], counts: &[usize]) -> Self {
        Self::weighted(spheres, &vec![1.0; spheres.len()], counts)
    }

    /// As [`new`](Self::new), each sphere with a weight: what its log visibility is multiplied with. The logarithms of
    /// spheres that overlap add up, though each direction is hidden only once; with weights the sum hides what the body
    /// does that they stand for.
    ///
    /// # Panics
    /// If the counts do not add up to the number of spheres, or there are not as many weights.
    ///
    /// ```
    /// use sh_scene::{Forest, Sphere};
    /// let ball = Sphere { center: [0.0; 3], radius: 1.0 };
    /// // The same sphere twice hides what one does.
    /// let twice = Forest::weighted(&[ball, ball], &[0.5, 0.5], &[2]);
    /// assert_eq!(twice.nodes()[0].weight, 0.5);
    /// ```
    pub fn weighted(spheres: &[Sphere], weights: &[f32], counts: &[usize]) -> Self {
        assert_eq!(weights.len(), spheres.len(), "a weight for each sphere");
        let total: usize = counts.iter().sum();
        assert_eq!(total, spheres.len(), "spheres of all objects together");
        let mut roots = Vec::new();
        let mut first = 0;
        let mut ends = Vec::with_capacity(counts.len());
        for &count in counts {
            let leaves = (first..first + count)
                .map(|i| Part {
                    ball: spheres[i],
                    leaf: Some(i as u32),
                    children: Vec::new(),
                })
                .collect();
            roots.extend(raise(leaves));
            first += count;
            ends.push(first);
        }
        let mut nodes = Vec::new();
        if let Some(root) = raise(roots) {
            lay(&root, 0, &mut nodes);
        }
        let roots = roots_of(&mut nodes, &ends);
        let mut forest = Self {
            roots,
            nodes,
            spheres: total,
            weights: weights.to_vec(),
        };
        forest.update(spheres);
        forest
    }

    /// Moves the leaves to where the spheres are now, and renews the bounds of all other nodes from below by merging
    /// child after child (Ren et al. 2006, section 6.3).
    ///
    /// # Panics
    /// If there are not as many spheres as the tree was built from.
    pub fn update(&mut self, spheres: &[Sphere]) {
        assert_eq!(spheres.len(), self.spheres, "spheres of the tree");
        for at in (0..self.nodes.len()).rev() {
            self.refit(at, spheres);
        }
    }

    /// As [`update`](Self::update), where only the spheres of these `objects` have moved: only their branches, and what
    /// lies above them, are renewed, to the same bits. Appends to `changed` the ranges of nodes that were, and tells how
    /// many nodes these are. Nothing is allocated but for `changed`.
    ///
    /// # Panics
    /// If there are not as many spheres as the tree was built from, or an object is none of its.
    ///
    /// ```
    /// use sh_scene::{Forest, Sphere};
    /// let mut row: Vec<_> = (0..64).map(|i| Sphere { center: [i as f32, 0.0, 0.0], radius: 0.5 }).collect();
    /// let mut forest = Forest::new(&row, &[32, 32]);
    /// row[40].center[1] = 3.0;
    /// let mut changed = Vec::new();
    /// let nodes = forest.update_objects(&row, &[1], &mut changed);
    /// assert!(nodes < 50 && forest.nodes().len() > 80);
    /// ```
    pub fn update_objects(
        &mut self,
        spheres: &[Sphere],
        objects: &[usize],
        changed: &mut Vec<Range<u32>>,
    ) -> usize {
        assert_eq!(spheres.len(), self.spheres, "spheres of the tree");
        let own = changed.len();
        for &object in objects {
            let Some(root) = self.roots[object] else {
                continue;
            };
            let end = self.nodes[root as usize].skip;
            for at in (root..end).rev() {
                self.refit(at as usize, spheres);
            }
            changed.push(root..end);
        }
        let branches = changed.len();
        // Whatever lies above one of them, each once: from below, which is from the last on.
        for branch in own..branches {
            let mut at = changed[branch].start as usize;
            while self.nodes[at].parent as usize != at {
                at = self.nodes[at].parent as usize;
                changed.push(at as u32..at as u32 + 1);
            }
        }
        changed[branches..].sort_unstable_by_key(|range| std::cmp::Reverse(range.start));
        let mut kept = branches;
        for i in branches..changed.len() {
            let range = changed[i].clone();
            if kept == branches || changed[kept - 1] != range {
                self.refit(range.start as usize, spheres);
                changed[kept] = range;
                kept += 1;
            }
        }
        changed.truncate(kept);
        changed[own..].iter().map(ExactSizeIterator::len).sum()
    }

    /// Puts a leaf where its sphere is, or a ball around what lies directly below a node.
    fn refit(&mut self, at: usize, spheres: &[Sphere]) {
        let skip = self.nodes[at].skip as usize;
        let (ball, area, weight) = if skip == at + 1 {
            let index = self.nodes[at].sphere as usize;
            let sphere = if spheres[index].is_finite() {
                spheres[index]
            } else {
                Sphere::NONE
            };
            let area = sphere.radius * sphere.radius;
            (sphere, area, self.weights[index])
        } else {
            let mut child = at + 1;
            let (mut ball, mut area, mut weight) = (self.nodes[child].ball(), 0.0, 0.0);
            while child < skip {
                let below = &self.nodes[child];
                // What blocks nothing needs no room.
                ball = match (ball.radius > 0.0, below.radius > 0.0) {
                    (true, true) => enclosing(ball, below.ball()),
                    (false, true) => below.ball(),
                    _ => ball,
                };
                area += below.area;
                weight += below.area * below.weight;
                child = below.skip as usize;
            }
            let mean = weight / area;
            (ball, area, if mean.is_finite() { mean } else { 1.0 })
        };
        let node = &mut self.nodes[at];
        (node.center, node.radius, node.area) = (ball.center, ball.radius, area);
        node.weight = weight;
    }

    /// All nodes: the root first, each before those below it.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// How many leaves there are.
    pub fn spheres(&self) -> usize {
        self.spheres
    }

    /// Calls `take` with the index of every node of the cut for receivers within `radius` of `center`: the first on
    /// each way down from the root that is a leaf, or passes
    ///
    /// ```text
    /// r < sin θ_max (|P − center| − radius)       Ren et al. 2006, equation 36
    /// ```
    pub fn cut(&self, center: Vec3, radius: f32, limits: Limits, mut take: impl FnMut(usize)) {
        let mut at = 0;
        while let Some(node) = self.nodes.get(at) {
            let distance = Vec3::from(node.center).distance(center) - radius;
            if node.is_leaf(at) || node.radius < limits.sin_max * distance {
                take(at);
                at = node.skip as usize;
            } else {
                at += 1;
            }
        }
    }

    /// Whether the node at `at` of a cut is too small to matter to receivers within `radius` of `center`: what lies below
    /// it covers so little of their sky that all such nodes together cover less than [`NEGLIGIBLE`] of it, weighed with
    /// the cosine.
    ///
    /// ```text
    /// Σ r² / (|P − center| − radius)² < NEGLIGIBLE · (nodes from this one to what it skips to) / (all nodes)
    /// ```
    /// A ball of radius r at a distance d hides at most the share r²/d² of an even sky.
    pub fn is_negligible(&self, at: usize, center: Vec3, radius: f32) -> bool {
        let node = &self.nodes[at];
        let distance = Vec3::from(node.center).distance(center) - radius;
        let share = (node.skip as usize - at) as f32 * NEGLIGIBLE;
        // Beside its ball, so that no receiver is within.
        distance > node.radius && node.area * self.nodes.len() as f32 <= share * distance * distance
    }

    /// Every sphere as a blocker that stands for itself: the cut without a hierarchy.
    pub fn leaves(&self) -> impl Iterator<Item = Blocker> {
        let leaves = self.nodes.iter().enumerate();
        leaves
            .filter(|(at, node)| node.is_leaf(*at))
            .map(|(_, node)| Blocker::of(node))
    }
}

impl Node {
    pub(super) fn ball(&self) -> Sphere {
        Sphere {
            center: self.center,
            radius: self.radius,
        }
    }
}

/// The highest node of each object, of whose body all nodes below become; `ends` are the spheres up to each object's last.
fn roots_of(nodes: &mut [Node], ends: &[usize]) -> Vec<Option<u32>> {
    let mut roots = vec![None; ends.len()];
    let object = |leaf: &Node| ends.partition_point(|&end| end <= leaf.sphere as usize);
    // From the last node on the objects of each are known before those above it.
    let mut spans: Vec<(usize, usize)> = vec![(0, 0); nodes.len()];
    for at in (0..nodes.len()).rev() {
        let node = &nodes[at];
        spans[at] = if node.is_leaf(at) {
            (object(node), object(node))
        } else {
            let (mut low, mut high) = spans[at + 1];
            let mut child = at + 1;
            while child < node.skip as usize {
                (low, high) = (low.min(spans[child].0), high.max(spans[child].1));
                child = nodes[child].skip as usize;
            }
            (low, high)
        };
        if let (low, high) = spans[at]
            && low == high
        {
            roots[low] = Some(at as u32);
            nodes[at].object = low as u32 + 1;
        }
    }
    roots
}

/// Writes a part and all below it, depth first.
fn lay(part: &Part, parent: u32, nodes: &mut Vec<Node>) {
    let at = nodes.len();
    nodes.push(Node {
        center: part.ball.center,
        radius: part.ball.radius,
        area: 0.0,
        parent,
        skip: 0,
        sphere: part.leaf.unwrap_or(u32::MAX),
        weight: 1.0,
        object: 0,
        unused: [0; 2],
    });
    for child in &part.children {
        lay(child, at as u32, nodes);
    }
    nodes[at].skip = nodes.len() as u32;
}

/// The smallest ball around two, a little larger than that so that rounding leaves both within.
pub(super) fn enclosing(a: Sphere, b: Sphere) -> Sphere {
    /// Some units in the last place of every number that went into the radius.
    const SLACK: f32 = 4e-7;
    let (from, to) = (Vec3::from(a.center), Vec3::from(b.center));
    let distance = from.distance(to);
    if distance + b.radius <= a.radius {
        return a;
    }
    if distance + a.radius <= b.radius {
        return b;
    }
    let radius = (distance + a.radius + b.radius) * 0.5;
    let center = from + (to - from) * ((radius - a.radius) / distance.max(f32::MIN_POSITIVE));
    let reach = center.abs().max_element() + radius;
    Sphere {
        center: center.into(),
        radius: radius + SLACK * reach,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Spheres here and there, the same in every run.
    fn scattered(count: usize) -> Vec<Sphere> {
        (0..count)
            .map(|i| {
                let t = i as f32;
                Sphere {
                    center: [
                        7.0 * (1.3 * t).sin(),
                        (2.1 * t).cos() * 2.0,
                        9.0 * (0.7 * t).sin(),
                    ],
                    radius: 0.05 + 0.3 * (0.9 * t).sin().abs(),
                }
            })
            .collect()
    }

    #[test]
    fn every_ball_holds_those_below_it_and_still_does_after_moving() {
        for count in [1, 2, 3, 4, 5, 17, 100, 3000] {
            let mut spheres = scattered(count);
            let mut forest = Forest::new(&spheres, &[count / 3, count - count / 3]);
            for step in 0..3 {
                let mut found = vec![0; count];
                for (at, node) in forest.nodes().iter().enumerate() {
                    let parent = &forest.nodes()[node.parent as usize];
                    assert!(node.parent as usize <= at && at < parent.skip as usize);
                    let distance = Vec3::from(node.center).distance(parent.center.into());
                    assert!(distance + node.radius <= parent.radius * (1.0 + 1e-6) + 1e-6);
                    if node.is_leaf(at) {
                        found[node.sphere as usize] += 1;
                        assert_eq!(node.ball(), spheres[node.sphere as usize]);
                    }
                }
                assert!(found.iter().all(|&n| n == 1));
                let area: f32 = spheres.iter().map(|s| s.radius * s.radius).sum();
                assert!((forest.nodes()[0].area / area - 1.0).abs() < 1e-4);
                for (i, sphere) in spheres.iter_mut().enumerate() {
                    sphere.center[step] += (i as f32).sin();
                }
                forest.update(&spheres);
            }
        }
    }

    /// Whichever objects move, their branches alone give the bits of the whole tree.
    #[test]
    fn branches_are_renewed_as_the_whole_tree_is() {
        let counts = [30, 0, 1, 200, 7, 62];
        let mut spheres = scattered(300);
        let mut part = Forest::new(&spheres, &counts);
        for which in 0..64_usize {
            let objects: Vec<usize> = (0..6).filter(|i| which >> i & 1 == 1).collect();
            let mut first = 0;
            for (object, count) in counts.iter().enumerate() {
                if objects.contains(&object) {
                    for sphere in &mut spheres[first..first + count] {
                        sphere.center[which % 3] += 0.7;
                    }
                }
                first += count;
            }
            let mut whole = part.clone();
            let before = part.nodes().to_vec();
            let mut changed = Vec::new();
            let nodes = part.update_objects(&spheres, &objects, &mut changed);
            whole.update(&spheres);
            assert_eq!(part, whole, "{objects:?}");
            let inside = |at: usize| changed.iter().filter(|r| r.contains(&(at as u32))).count();
            for (at, node) in before.iter().enumerate() {
                assert!(inside(at) <= 1, "{at} is renewed twice");
                assert!(
                    *node == part.nodes()[at] || inside(at) == 1,
                    "{at} is not told"
                );
            }
            let moved: usize = objects.iter().map(|&object| counts[object]).sum();
            assert!(nodes <= 2 * moved + 6, "{nodes} for {moved} spheres");
        }
    }

    #[test]
    fn branching_is_about_four() {
        let spheres = scattered(4000);
        let forest = Forest::new(&spheres, &[4000]);
        let inner = forest.nodes().len() - 4000;
        let branching = (forest.nodes().len() - 1) as f32 / inner as f32;
        assert!((3.5..4.5).contains(&branching), "{branching}");
    }

    #[test]
    fn a_cut_holds_every_leaf_once_and_grows_towards_the_receivers() {
        let spheres = scattered(500);
        let forest = Forest::new(&spheres, &[200, 300]);
        let cut = |center: Vec3, limits: Limits| {
            let mut nodes = Vec::new();
            forest.cut(center, 0.5, limits, |at| nodes.push(at));
            let held: usize = nodes
                .iter()
                .map(|&at| {
                    (at..forest.nodes()[at].skip as usize)
                        .filter(|&i| forest.nodes()[i].is_leaf(i))
                        .count()
                })
                .sum();
            assert_eq!(held, 500);
            nodes.len()
        };
        let limits = Limits::default();
        let counts = [0.0, 10.0, 30.0, 1000.0].map(|x| cut(Vec3::new(x, 0.0, 0.0), limits));
        assert!(counts.is_sorted_by(|a, b| a > b), "{counts:?}");
        assert_eq!(counts[3], 1);
        assert_eq!(cut(Vec3::ZERO, Limits::LEAVES), 500);
    }

    /// What lets a shader decide node by node, without walking the tree: a node is in the cut if it passes and its
    /// parent does not.
    #[test]
    fn whatever_is_below_a_node_that_passes_passes_as_well() {
        let spheres = scattered(2000);
        let forest = Forest::new(&spheres, &[2000]);
        let sine = Limits::default().sin_max;
        for i in 0..50 {
            let t = i as f32;
            let center = Vec3::new(
                12.0 * t.sin(),
                5.0 * (1.7 * t).cos(),
                14.0 * (0.6 * t).sin(),
            );
            let passes =
                |node: &Node| node.radius < sine * (Vec3::from(node.center).distance(center) - 0.3);
            for node in forest.nodes() {
                let parent = &forest.nodes()[node.parent as usize];
                assert!(!passes(parent) || passes(node));
            }
        }
    }

    #[test]
    fn no_spheres_are_no_tree() {
        let mut forest = Forest::new(&[], &[0, 0]);
        forest.update(&[]);
        forest.cut(Vec3::ZERO, 1.0, Limits::default(), |_| panic!("a node"));
        assert_eq!(forest.leaves().count(), 0);
    }
}
