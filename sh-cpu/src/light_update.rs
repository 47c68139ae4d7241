//! The `light_update` pass: what every sphere of a body sends on (Guerrero et al. 2008, section 5).
//!
//! Points of the surface around a sphere are receivers like any others: the shadow pass lights them, all at once. Each
//! sends on its radiance times the albedo of its direction's Voronoi cell, and the sum over all of them, in spherical
//! harmonics, is what the sphere emits (equation 10), turned to world space. The paper leaves it as it is and turns the
//! weights at every receiver; there are many more receivers than spheres.
//!
//! A node of the forest that stands for several spheres emits their mean by cross-section; what is left between its light
//! and theirs is made up for each cluster (section 7.3, [`crate::LightCuts`]).
//!
//! With several bounces the light that spheres send on is gathered at the points as well, once a bounce.

mod emit;

use crate::irradiance::reflected;
use crate::light_cut::{LightCutOptions, LightCuts};
use crate::light_gather::{LightGather, light_gather};
use crate::shadow::{Shadow, shadow_clusters};
use crate::{CutOptions, Cuts, Error, Path};
use glam::{Affine3A, Quat, Vec3};
use sh_core::Routines;
use sh_core::constants::NO_BODY;
use sh_scene::surface::SurfaceSamples;
use sh_scene::{Forest, Indirect, Light, Limits, Object, Receiver};
use std::ops::Range;

/// A body whose spheres send light on.
#[derive(Clone, Copy, Debug)]
pub struct Body<'a> {
    /// Points on its surface, sphere by sphere.
    pub surface: &'a SurfaceSamples,
    /// World from the space that they are in: a rotation, a uniform scale and a translation.
    pub transform: Affine3A,
    /// How many spheres it has: a body without a surface has black ones.
    pub spheres: usize,
}

impl<'a> From<&'a Object> for Body<'a> {
    fn from(object: &'a Object) -> Self {
        Self {
            surface: &object.surface,
            transform: object.transform,
            spheres: object.spheres.len(),
        }
    }
}

/// How light is sent on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightUpdate {
    /// How often, and what hides what.
    pub indirect: Indirect,
    /// How coarse the spheres may be that shade and light the points.
    pub limits: Limits,
    /// The order of accumulation of the points' shadows, from the light's order to 6.
    pub accumulation: usize,
}

/// What the spheres of all bodies send on, as SH vectors in world space: for every node of a forest. Its memory is kept
/// from frame to frame.
#[derive(Clone, Debug, Default)]
pub struct SphericalLights {
    order: usize,
    /// `order²` coefficients a node, in three channels.
    emission: Vec<[f32; 3]>,
    /// The brightest of each node's points.
    brightest: Vec<[f32; 3]>,
    most: [f32; 3],
    /// The body of each node; [`NO_BODY`] where it stands for several.
    bodies: Vec<u32>,
    /// The node that stands for each body.
    roots: Vec<u32>,
    /// The node of each sphere.
    leaves: Vec<u32>,
    /// How much of each sphere its body's other spheres leave to be seen ([`SurfaceSamples::exposed`]): `order²`
    /// coefficients a node, in world space.
    exposed: Vec<f32>,
    points: Points,
    light_cuts: LightCuts,
}

/// Points of surfaces as receivers.
#[derive(Clone, Debug, Default)]
struct Points {
    receivers: Vec<Receiver>,
    /// Those of each sphere.
    clusters: Vec<Range<usize>>,
    cuts: Cuts,
    direct: Vec<[f32; 3]>,
    indirect: Vec<[f32; 3]>,
}

impl SphericalLights {
    /// The SH order of what is sent on: that of the light.
    pub fn order(&self) -> usize {
        self.order
    }

    /// What a node of the forest emits: radiance as a function of the direction from its centre, coefficient by
    /// coefficient in three channels.
    pub fn emission(&self, node: u32) -> &[[f32; 3]] {
        let count = self.order * self.order;
        &self.emission[node as usize * count..][..count]
    }

    /// Bytes of what nodes emit and of the points that light them.
    pub(crate) fn bytes(&self) -> usize {
        let emitted = size_of_val(&self.emission[..]) + size_of_val(&self.brightest[..]);
        let lit = 2 * size_of_val(&self.points.direct[..]);
        emitted + size_of_val(&self.points.receivers[..]) + lit
    }

    /// No part of any surface sends on more radiance than this.
    pub fn brightest(&self) -> [f32; 3] {
        self.most
    }

    pub(crate) fn brightest_of(&self, node: u32) -> &[f32; 3] {
        &self.brightest[node as usize]
    }

    /// The mean radiance of a ball in a node's place that appears under this sine, `towards` whoever looks at it.
    pub(crate) fn radiance(&self, node: u32, sine: f32, towards: Vec3) -> [f32; 3] {
        match self.order {
            2 => self.radiance_in::<4>(node, sine, towards),
            3 => self.radiance_in::<9>(node, sine, towards),
            4 => self.radiance_in::<16>(node, sine, towards),
            5 => self.radiance_in::<25>(node, sine, towards),
            _ => self.radiance_in::<36>(node, sine, towards),
        }
    }

    fn radiance_in<const C: usize>(&self, node: u32, sine: f32, towards: Vec3) -> [f32; 3]
    where
        [f32; C]: Routines<f32>,
    {
        let cosine = (1.0 - sine * sine).max(0.0).sqrt();
        let weights = <[f32; C]>::ball_average(sine, cosine, towards.to_array());
        let mean = reflected(&weights, self.emission(node));
        let most = self.brightest_of(node);
        std::array::from_fn(|c| mean[c].max(0.0).min(most[c]))
    }

    /// How much of a sphere its body's other spheres leave to be seen from a direction; `node` is a leaf.
    pub(crate) fn exposed(&self, node: u32, from: Vec3) -> f32 {
        let count = self.order * self.order;
        let own = &self.exposed[node as usize * count..][..count];
        let share = match self.order {
            2 => share_in::<4>(own, from),
            3 => share_in::<9>(own, from),
            4 => share_in::<16>(own, from),
            5 => share_in::<25>(own, from),
            _ => share_in::<36>(own, from),
        };
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

    /// Finds what every node of `forest` sends on of `light`, as everything stands now. The forest is that of all
    /// `bodies`' spheres.
    ///
    /// # Errors
    /// Where the light is none, or the bodies do not have the forest's spheres.
    pub fn update<'a>(
        &mut self,
        path: Path,
        bodies: impl IntoIterator<Item = Body<'a>> + Clone,
        forest: &Forest,
        light: &Light,
        update: LightUpdate,
    ) -> Result<(), Error> {
        let spheres: usize = bodies.clone().into_iter().map(|body| body.spheres).sum();
        if spheres != forest.spheres() {
            return Err(Error::Length {
                buffer: "bodies",
                expected: forest.spheres(),
                found: spheres,
            });
        }
        self.order = light.order;
        self.points.place(bodies.clone());
        self.own(bodies.clone(), forest);
        let cut = CutOptions {
            limits: update.limits,
            ratios: true,
            accumulation: update.accumulation,
        };
        self.points.shade(path, forest, light, cut)?;
        let within_bodies = update.indirect.blocking.within_bodies();
        self.emit(bodies.clone(), forest, within_bodies)?;
        for _ in 1..update.indirect.bounces {
            let mut cuts = std::mem::take(&mut self.light_cuts);
            let mut points = std::mem::take(&mut self.points);
            let Points {
                receivers,
                clusters,
                indirect,
                ..
            } = &mut points;
            let options = LightCutOptions {
                cut: CutOptions {
                    accumulation: light.order,
                    ..cut
                },
                blocking: update.indirect.blocking,
            };
            cuts.find(path, receivers, clusters, forest, self, options);
            let gather = LightGather {
                clusters,
                cuts: &cuts,
                lights: self,
            };
            let gathered = light_gather(path, receivers, &gather, indirect);
            (self.light_cuts, self.points) = (cuts, points);
            gathered?;
            self.emit(bodies.clone(), forest, within_bodies)?;
        }
        Ok(())
    }

    /// Bodies of so many spheres, each of one radiance in every direction; nodes above bodies have the brightest.
    #[cfg(test)]
    pub(crate) fn even(forest: &Forest, order: usize, bodies: &[(usize, [f32; 3])]) -> Self {
        use sh_core::ROOT_FOUR_PI;
        let surface = SurfaceSamples::default();
        let body = |&(spheres, _): &(usize, [f32; 3])| Body {
            surface: &surface,
            transform: Affine3A::IDENTITY,
            spheres,
        };
        let mut lights = Self {
            order,
            ..Self::default()
        };
        lights.own(bodies.iter().map(body), forest);
        for (_, radiance) in bodies {
            for (most, c) in lights.most.iter_mut().zip(radiance) {
                *most = most.max(*c);
            }
        }
        for &body in &lights.bodies {
            let radiance = bodies.get(body as usize).map_or(lights.most, |body| body.1);
            lights
                .emission
                .push(radiance.map(|c| c * ROOT_FOUR_PI as f32));
            let rest = std::iter::repeat_n([0.0; 3], order * order - 1);
            lights.emission.extend(rest);
            lights.brightest.push(radiance);
            lights.exposed.push(ROOT_FOUR_PI as f32);
            let rest = std::iter::repeat_n(0.0, order * order - 1);
            lights.exposed.extend(rest);
        }
        lights
    }

    /// Which body each node belongs to.
    fn own<'a>(&mut self, bodies: impl IntoIterator<Item = Body<'a>>, forest: &Forest) {
        let nodes = forest.nodes();
        self.bodies.clear();
        self.bodies.resize(nodes.len(), NO_BODY);
        self.roots.clear();
        self.leaves.clear();
        self.leaves.resize(forest.spheres(), 0);
        let mut ends = Vec::new();
        let mut end = 0;
        for body in bodies {
            end += body.spheres;
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

impl Points {
    /// Puts all points where they are now.
    fn place<'a>(&mut self, bodies: impl IntoIterator<Item = Body<'a>>) {
        self.receivers.clear();
        self.clusters.clear();
        for (object, body) in bodies.into_iter().enumerate() {
            let turn = rotation(&body.transform);
            for sphere in 0..body.spheres {
                let first = self.receivers.len();
                let points = body.surface.of(sphere).iter().map(|point| Receiver {
                    position: body
                        .transform
                        .transform_point3(point.position.into())
                        .into(),
                    covered: 1,
                    normal: (turn * Vec3::from(point.normal)).into(),
                    object: object as u32 + 1,
                });
                self.receivers.extend(points);
                self.clusters.push(first..self.receivers.len());
            }
        }
        let count = self.receivers.len();
        self.direct.resize(count, [0.0; 3]);
        self.indirect.clear();
        self.indirect.resize(count, [0.0; 3]);
    }

    /// Lights them.
    fn shade(
        &mut self,
        path: Path,
        forest: &Forest,
        light: &Light,
        cut: CutOptions,
    ) -> Result<(), Error> {
        self.cuts
            .bound(&self.receivers, &self.clusters, 0..self.clusters.len());
        self.cuts.dim(light);
        self.cuts.find(path, forest, light, cut);
        let shadow = Shadow {
            clusters: &self.clusters,
            cuts: &self.cuts,
            light,
            accumulation: cut.accumulation,
            baked: None,
        };
        shadow_clusters(path, &self.receivers, &shadow, &mut self.direct)
    }
}

/// The rotation of a transform that turns, scales evenly and moves.
fn rotation(transform: &Affine3A) -> Quat {
    let (_, turn, _) = transform.to_scale_rotation_translation();
    // A body without extent faces nowhere.
    Some(turn).filter(|q| q.is_finite()).unwrap_or_default()
}
