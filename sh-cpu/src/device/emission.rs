//! What the nodes of a forest emit.

use super::light::reflected;
use glam::Vec3;
use sh_core::constants::NO_BODY;
use sh_core::{ROOT_FOUR_PI, Routines, for_order};
use sh_scene::Forest;

/// What every node of a forest emits, as SH vectors in world space.
#[derive(Clone, Debug, Default)]
pub struct Emission {
    pub(crate) order: usize,
    /// `order²` coefficients a node, in three channels.
    pub(crate) coefficients: Vec<[f32; 3]>,
    /// The brightest of each node's points.
    pub(crate) brightest: Vec<[f32; 3]>,
    pub(crate) most: [f32; 3],
    /// The body of each node; [`NO_BODY`] where it stands for several.
    bodies: Vec<u32>,
    /// The node that stands for each body.
    roots: Vec<u32>,
    /// The node of each sphere.
    pub(crate) leaves: Vec<u32>,
    /// How much of each sphere its body's other spheres leave to be seen, as
    /// [`sh_scene::surface::SurfaceSamples::exposed`] has it: `order²` coefficients a node, in world space.
    pub(crate) exposed: Vec<f32>,
}

impl Emission {
    /// The SH order of what is sent on: that of the light.
    pub(crate) fn order(&self) -> usize {
        self.order
    }

    /// What a node of the forest emits: radiance as a function of the direction from its centre, coefficient by
    /// coefficient in three channels.
    pub(crate) fn of(&self, node: u32) -> &[[f32; 3]] {
        let count = self.order * self.order;
        &self.coefficients[node as usize * count..][..count]
    }

    /// No part of any surface sends on more radiance than this.
    pub(crate) fn brightest(&self) -> [f32; 3] {
        self.most
    }

    pub(crate) fn brightest_of(&self, node: u32) -> &[f32; 3] {
        &self.brightest[node as usize]
    }

    /// The mean radiance of a ball in a node's place that appears under this sine, `towards` whoever looks at it.
    pub(crate) fn radiance(&self, node: u32, sine: f32, towards: Vec3) -> [f32; 3] {
        for_order!(self.order, C => self.radiance_in::<C>(node, sine, towards))
    }

    fn radiance_in<const C: usize>(&self, node: u32, sine: f32, towards: Vec3) -> [f32; 3]
    where
        [f32; C]: Routines<f32>,
    {
        let cosine = (1.0 - sine * sine).max(0.0).sqrt();
        let weights = <[f32; C]>::ball_average(sine, cosine, towards.to_array());
        let mean = reflected(&weights, self.of(node));
        let most = self.brightest_of(node);
        std::array::from_fn(|c| mean[c].max(0.0).min(most[c]))
    }

    /// How much of a sphere its body's other spheres leave to be seen from a direction; `node` is a leaf.
    pub(crate) fn exposed(&self, node: u32, from: Vec3) -> f32 {
        let count = self.order * self.order;
        let own = &self.exposed[node as usize * count..][..count];
        let share = for_order!(self.order, C => share_in::<C>(own, from));
        share.clamp(0.0, 1.0)
    }

    /// Whether a node emits anything.
    pub(crate) fn shines(&self, node: u32) -> bool {
        self.brightest[node as usize].iter().any(|&c| c > 0.0)
    }

    /// The one body that a node is part of.
    pub(crate) fn body(&self, node: u32) -> Option<u32> {
        Some(self.bodies[node as usize]).filter(|&body| body != NO_BODY)
    }

    /// The node that stands for a body.
    pub(crate) fn root(&self, body: u32) -> u32 {
        self.roots[body as usize]
    }

    /// Of bodies of so many spheres, each of one radiance in every direction; nodes above bodies have the brightest.
    pub(crate) fn even(forest: &Forest, order: usize, bodies: &[(usize, [f32; 3])]) -> Self {
        let mut emission = Self {
            order,
            ..Self::default()
        };
        emission.own(bodies.iter().map(|body| body.0), forest);
        for (_, radiance) in bodies {
            for (most, c) in emission.most.iter_mut().zip(radiance) {
                *most = most.max(*c);
            }
        }
        let rest = order * order - 1;
        for &body in &emission.bodies {
            let own = bodies.get(body as usize);
            let radiance = own.map_or(emission.most, |body| body.1);
            let root = ROOT_FOUR_PI as f32;
            emission.coefficients.push(radiance.map(|c| c * root));
            let zeros = std::iter::repeat_n([0.0; 3], rest);
            emission.coefficients.extend(zeros);
            emission.brightest.push(radiance);
            emission.exposed.push(root);
            emission.exposed.extend(std::iter::repeat_n(0.0, rest));
        }
        emission
    }

    /// Its bytes.
    pub(crate) fn bytes(&self) -> usize {
        size_of_val(&self.coefficients[..]) + size_of_val(&self.brightest[..])
    }

    /// Which body each node belongs to, of bodies of so many spheres.
    pub(crate) fn own(&mut self, bodies: impl IntoIterator<Item = usize>, forest: &Forest) {
        let nodes = forest.nodes();
        self.bodies.clear();
        self.bodies.resize(nodes.len(), NO_BODY);
        self.roots.clear();
        self.leaves.clear();
        self.leaves.resize(forest.spheres(), 0);
        let mut ends = Vec::new();
        let mut end = 0;
        for spheres in bodies {
            end += spheres;
            ends.push(end);
            self.roots.push(0);
        }
        for (at, node) in nodes.iter().enumerate().rev() {
            if node.is_leaf(at) {
                let body = ends.partition_point(|&end| end <= node.sphere as usize);
                self.bodies[at] = body as u32;
                self.leaves[node.sphere as usize] = at as u32;
            } else {
                // All children's, if they agree.
                let mut child = at + 1;
                let body = self.bodies[child];
                let mut one = true;
                while child < node.skip as usize {
                    one &= self.bodies[child] == body;
                    child = nodes[child].skip as usize;
                }
                self.bodies[at] = if one { body } else { NO_BODY };
            }
            if let Some(root) = self.roots.get_mut(self.bodies[at] as usize) {
                *root = at as u32;
            }
        }
    }
}

fn share_in<const C: usize>(coefficients: &[f32], from: Vec3) -> f32
where
    [f32; C]: Routines<f32>,
{
    let basis = <[f32; C]>::basis(from.to_array());
    basis.iter().zip(coefficients).map(|(y, c)| y * c).sum()
}
