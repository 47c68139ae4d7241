//! What passes over receivers are given: light and the tree of blockers on the device, with the pipelines that are shared.

use crate::lighting::{Lit, buffer, room};
use crate::scope::checked;
use crate::upload::{Kept, Known};
use crate::{Error, Pipelines, ShadowOptions};
use sh_scene::{Forest, Light, Limits, Node, Sphere};
use wgpu::{BindingResource, Buffer, BufferUsages, Queue};

/// The resources `light` and `blockers` of a plan, or of a host's passes.
#[derive(Debug)]
pub(crate) struct Inputs {
    pub pipelines: Pipelines,
    /// The SH order of the light.
    pub order: usize,
    pub lit: Lit,
    pub nodes: Buffer,
    /// The most blocker spheres.
    pub max_blockers: u32,
    kept: Kept<Vec<Node>>,
    known: Known,
}

impl Inputs {
    /// Room for as much as options say.
    pub fn new(pipelines: &Pipelines, options: ShadowOptions) -> Result<Self, Error> {
        let device = pipelines.device();
        let ShadowOptions {
            order,
            max_blockers,
            max_emitters,
            distributions,
            ..
        } = options;
        checked(device, || {
            let max_nodes = max_blockers.saturating_mul(2);
            let room = room(device, "room for blockers", max_nodes, size_of::<Node>())?;
            Ok(Self {
                pipelines: pipelines.clone(),
                order,
                lit: Lit::new(device, order, max_emitters, distributions)?,
                nodes: buffer(device, "gaunt blockers", room, BufferUsages::STORAGE),
                max_blockers,
                kept: Kept::default(),
                known: Known::default(),
            })
        })
    }

    /// The tree, as kernels name it.
    pub fn tree(&self) -> (&'static str, BindingResource<'_>) {
        ("nodes", self.nodes.as_entire_binding())
    }

    /// Bytes of GPU memory.
    pub fn bytes(&self) -> u64 {
        self.lit.bytes() + self.nodes.size()
    }

    /// Bytes that have been uploaded since it was made.
    pub fn uploaded(&self) -> u64 {
        self.known.written() + self.lit.uploaded()
    }

    /// Uploads the blockers and the light for what is submitted next.
    pub fn prepare(
        &self,
        queue: &Queue,
        blockers: &Forest,
        limits: Limits,
        light: &Light,
    ) -> Result<(), Error> {
        let nodes = blockers.nodes();
        self.check(blockers.spheres(), nodes.len())?;
        self.lit.prepare(queue, light, nodes.len() as u32, limits)?;
        self.known.write(queue, &self.nodes, nodes);
        Ok(())
    }

    /// As [`prepare`](Self::prepare), without a hierarchy: every sphere counts for every receiver.
    pub fn prepare_spheres(
        &self,
        queue: &Queue,
        blockers: &[Sphere],
        light: &Light,
    ) -> Result<(), Error> {
        let count = blockers.len();
        self.check(count, count)?;
        self.lit
            .prepare(queue, light, count as u32, Limits::LEAVES)?;
        // Every leaf a tree of its own.
        let nodes = (0..).zip(blockers).map(|(at, sphere)| {
            // One that is nowhere, or endless, blocks nothing.
            let sphere = Some(sphere)
                .filter(|s| s.is_finite())
                .unwrap_or(&Sphere::NONE);
            Node {
                center: sphere.center,
                radius: sphere.radius,
                area: sphere.radius * sphere.radius,
                parent: at,
                skip: at + 1,
                sphere: at,
                weight: 1.0,
                object: 0,
                unused: [0; 2],
            }
        });
        self.kept.with(|kept| {
            kept.clear();
            kept.extend(nodes);
            self.known.write(queue, &self.nodes, kept);
        });
        Ok(())
    }

    /// As [`prepare`](Self::prepare), where somebody has written so many nodes to `nodes` already.
    pub fn prepare_light(
        &self,
        queue: &Queue,
        nodes: u32,
        limits: Limits,
        light: &Light,
    ) -> Result<(), Error> {
        self.known.forget();
        self.check(nodes.div_ceil(2) as usize, nodes as usize)?;
        self.lit.prepare(queue, light, nodes, limits)
    }

    fn check(&self, spheres: usize, nodes: usize) -> Result<(), Error> {
        let capacity = self.max_blockers;
        if spheres > capacity as usize || nodes > 2 * capacity as usize {
            return Err(Error::Blockers {
                count: spheres,
                capacity,
            });
        }
        Ok(())
    }
}
