//! The surfaces around spheres on the GPU: points as receivers, and what spheres make of the light on them.

mod kernels;
mod memory;

pub(crate) use memory::PointBuffers;

use crate::inputs::Inputs;
use crate::records::Sender;
use crate::scope::checked;
use crate::slot::Slot;
use crate::upload::{Kept, Known};
use crate::{Bound, ClusterBinding, Error, LightGatherPass};
use glam::Mat4;
use kernels::Kernels;
use memory::{Counts, Memory};
use sh_scene::surface::{DIRECTIONS, MOST_COEFFICIENTS, SurfacePoint};
use sh_scene::{Body, Forest, Node, Receiver};
use wgpu::{BindGroup, BufferBinding, CommandEncoder, ComputePassTimestampWrites, Device, Queue};

/// The surfaces of all bodies, and the kernels of the passes `points` and `light_update`. What is written of points is the
/// frame's, or the host's.
#[derive(Debug)]
pub(crate) struct Surfaces {
    kernels: Kernels,
    group: BindGroup,
    memory: Memory,
    raised: Bound,
    counts: Counts,
    within_bodies: bool,
    kept: Kept<Uploads>,
    /// What points, what stands for directions, points' runs, senders and what can be seen of them hold.
    known: [Known; 5],
}

/// What is uploaded, in memory that is kept.
#[derive(Default)]
struct Uploads {
    points: Vec<SurfacePoint>,
    /// For each of a sphere's directions the point that stands for it.
    stands: Vec<[u8; DIRECTIONS]>,
    /// How much can be seen of each sphere.
    exposed: Vec<[f32; MOST_COEFFICIENTS]>,
    clusters: Vec<[u32; 2]>,
    senders: Vec<Sender>,
    /// The node of each sphere.
    at: Vec<u32>,
}

impl Surfaces {
    /// Makes the pipelines and uploads the bodies' surface points.
    pub fn new<'a>(
        device: &Device,
        queue: &Queue,
        inputs: &Inputs,
        gather: &LightGatherPass,
        bodies: impl IntoIterator<Item = Body<'a>> + Clone,
    ) -> Result<Self, Error> {
        checked(device, || {
            let kernels = Kernels::new(inputs)?;
            let counts = Counts::of(bodies.clone());
            let memory = Memory::new(device, queue, counts)?;
            let group = memory.group(device, &kernels.place, inputs, gather);
            let nodes = inputs.nodes.as_entire_buffer_binding();
            let nodes = Slot::counting("nodes", size_of::<Node>() as u64, nodes);
            let nodes_of = u64::from(gather.max_nodes());
            let raised = kernels.raise.bind_groups(device, &[nodes], nodes_of, 1)?;
            let pass = Self {
                kernels,
                group,
                memory,
                raised,
                counts,
                within_bodies: gather.blocking().within_bodies(),
                kept: Kept::default(),
                known: Default::default(),
            };
            pass.update_surfaces(queue, bodies)?;
            Ok(pass)
        })
    }

    /// Bytes of GPU memory that it owns.
    pub fn bytes(&self) -> u64 {
        self.memory.bytes()
    }

    /// Bytes that have been uploaded since it was made.
    pub fn uploaded(&self) -> u64 {
        self.known.iter().map(Known::written).sum()
    }

    /// Each sphere's points are a cluster.
    pub fn clusters(&self) -> ClusterBinding<'_> {
        self.memory.clusters(self.counts)
    }

    /// Room for the points as receivers and for their light.
    pub fn point_buffers(&self, device: &Device) -> Result<PointBuffers, Error> {
        PointBuffers::new(device, self.counts)
    }

    /// Binds what the pass `points` writes.
    pub fn bind_points(
        &self,
        device: &Device,
        receivers: BufferBinding<'_>,
    ) -> Result<Bound, Error> {
        let slot = Slot::counting("receivers", size_of::<Receiver>() as u64, receivers);
        let spheres = self.counts.spheres as u64;
        self.kernels.place.bind_groups(device, &[slot], spheres, 1)
    }

    /// Binds what the pass `light_update` reads of points: light that comes directly, and light that spheres have sent.
    pub fn bind_update(
        &self,
        device: &Device,
        [radiance, gathered]: [BufferBinding<'_>; 2],
    ) -> Result<Bound, Error> {
        let slots = [
            Slot::counting("radiance", 16, radiance),
            Slot::with("gathered", 16, 1, gathered),
        ];
        let spheres = self.counts.spheres as u64;
        self.kernels.project.bind_groups(device, &slots, spheres, 1)
    }

    /// Uploads the surface points anew; there must be as many as there were.
    pub fn update_surfaces<'a>(
        &self,
        queue: &Queue,
        bodies: impl IntoIterator<Item = Body<'a>> + Clone,
    ) -> Result<(), Error> {
        self.check(bodies.clone())?;
        self.kept.with(|kept| {
            kept.points.clear();
            kept.stands.clear();
            kept.exposed.clear();
            kept.clusters.clear();
            for body in bodies {
                for sphere in 0..body.spheres {
                    let own = body.surface.of(sphere);
                    let run = [kept.points.len() as u32, own.len() as u32];
                    kept.clusters.push(run);
                    kept.points.extend(own.iter().map(|point| SurfacePoint {
                        albedo: point.reflectance(self.within_bodies),
                        ..*point
                    }));
                    let stands = body.surface.stands(sphere, self.within_bodies);
                    kept.stands.push(stands);
                    let exposed = body.surface.exposed(sphere, self.within_bodies);
                    kept.exposed.push(exposed);
                }
            }
            let [points, stands, clusters, _, exposed] = &self.known;
            points.write(queue, &self.memory.points, &kept.points);
            stands.write(queue, &self.memory.stands, &kept.stands);
            exposed.write(queue, &self.memory.exposed, &kept.exposed);
            clusters.write(queue, &self.memory.clusters, &kept.clusters);
        });
        Ok(())
    }

    /// Uploads where the bodies stand and how their spheres are turned.
    pub fn prepare<'a>(
        &self,
        queue: &Queue,
        bodies: impl IntoIterator<Item = Body<'a>> + Clone,
        blockers: &Forest,
    ) -> Result<(), Error> {
        self.check(bodies.clone())?;
        let (count, expected) = (self.counts.spheres, blockers.spheres());
        if count != expected {
            return Err(Error::Spheres { count, expected });
        }
        self.kept.with(|Uploads { at, senders, .. }| {
            at.clear();
            at.resize(count, 0);
            senders.clear();
            for (index, node) in (0..).zip(blockers.nodes()) {
                if let Some(at) = at.get_mut(node.sphere as usize) {
                    *at = index;
                }
            }
            let mut first = 0;
            for (object, body) in (1..).zip(bodies) {
                let turn = body.turn();
                for sphere in 0..body.spheres {
                    let count = body.surface.of(sphere).len() as u32;
                    senders.push(Sender {
                        world_from_object: Mat4::from(body.transform),
                        turn: turn.to_array(),
                        frame: body.frame(turn, sphere).to_array(),
                        first,
                        count,
                        object,
                        node: at[senders.len()],
                    });
                    first += count;
                }
            }
            self.known[3].write(queue, &self.memory.senders, senders);
        });
        Ok(())
    }

    /// Records the pass `points`.
    pub fn record_points(
        &self,
        encoder: &mut CommandEncoder,
        bound: &Bound,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) {
        let own = (&self.group, &[][..]);
        self.kernels.place.record(encoder, own, bound, timestamps);
    }

    /// Dispatches of [`record_update`](Self::record_update).
    pub fn update_dispatches(&self, bound: &Bound) -> usize {
        bound.dispatches() + self.raised.dispatches()
    }

    /// Records the pass `light_update`.
    pub fn record_update(
        &self,
        encoder: &mut CommandEncoder,
        bound: &Bound,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) {
        let [begin, end] = first_and_last(timestamps);
        let own = (&self.group, &[][..]);
        self.kernels.project.record(encoder, own, bound, begin);
        self.kernels.raise.record(encoder, own, &self.raised, end);
    }

    fn check<'a>(&self, bodies: impl IntoIterator<Item = Body<'a>>) -> Result<(), Error> {
        let (found, expected) = (Counts::of(bodies), self.counts);
        if found != expected {
            return Err(Error::Points {
                count: found.spheres,
                points: found.points,
                spheres: expected.spheres,
                expected: expected.points,
            });
        }
        Ok(())
    }
}

/// The timestamps of a first and of a last pass.
pub(crate) fn first_and_last(
    timestamps: Option<ComputePassTimestampWrites<'_>>,
) -> [Option<ComputePassTimestampWrites<'_>>; 2] {
    let Some(both) = timestamps else {
        return [None, None];
    };
    let begin = ComputePassTimestampWrites {
        end_of_pass_write_index: None,
        ..both.clone()
    };
    let end = ComputePassTimestampWrites {
        beginning_of_pass_write_index: None,
        ..both
    };
    [Some(begin), Some(end)]
}
