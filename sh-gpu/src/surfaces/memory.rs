//! The buffers of the pass.

use crate::inputs::Inputs;
use crate::lighting::{buffer, room};
use crate::pipeline::Kernel;
use crate::records::Sender;
use crate::scope::checked;
use crate::{ClusterBinding, Error, LightGatherPass};
use sh_scene::surface::{DIRECTIONS, MOST_COEFFICIENTS, SurfacePoint, cell_sums};
use sh_scene::{Body, Receiver};
use wgpu::{BindGroup, Buffer, BufferBinding, BufferUsages, CommandEncoder, Device, Queue};

/// What a pass was made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Counts {
    pub spheres: usize,
    pub points: usize,
    /// Points of the sphere that has most.
    pub largest: usize,
}

impl Counts {
    pub fn of<'a>(bodies: impl IntoIterator<Item = Body<'a>>) -> Self {
        let mut counts = Self {
            spheres: 0,
            points: 0,
            largest: 0,
        };
        for body in bodies {
            counts.spheres += body.spheres;
            for sphere in 0..body.spheres {
                let points = body.surface.of(sphere).len();
                counts.points += points;
                counts.largest = counts.largest.max(points);
            }
        }
        counts
    }
}

/// What spheres and their points are.
#[derive(Debug)]
pub(super) struct Memory {
    pub senders: Buffer,
    pub points: Buffer,
    pub stands: Buffer,
    pub exposed: Buffer,
    pub clusters: Buffer,
    cells: Buffer,
}

impl Memory {
    /// Room for so many, and what directions' cells are.
    pub fn new(device: &Device, queue: &Queue, counts: Counts) -> Result<Self, Error> {
        let (spheres, points) = (counts.spheres, counts.points);
        let of_spheres = |label, size| make(device, label, "room for spheres", (spheres, size));
        let of_points = |label, size| make(device, label, POINTS, (points, size));
        let by_sphere = |label, size| make(device, label, POINTS, (spheres, size));
        let sums = cell_sums();
        let cells = (sums.len(), size_of_val(&sums[0]));
        let memory = Self {
            senders: of_spheres("gaunt senders", size_of::<Sender>())?,
            points: of_points("gaunt surface points", size_of::<SurfacePoint>())?,
            stands: by_sphere("gaunt standing points", DIRECTIONS)?,
            exposed: by_sphere(
                "gaunt exposed spheres",
                MOST_COEFFICIENTS * size_of::<f32>(),
            )?,
            clusters: by_sphere("gaunt surface clusters", 8)?,
            cells: make(device, "gaunt cells", POINTS, cells)?,
        };
        queue.write_buffer(&memory.cells, 0, bytemuck::cast_slice(&sums[..]));
        Ok(memory)
    }

    /// What all kernels are bound to.
    pub fn group(
        &self,
        device: &Device,
        kernel: &Kernel,
        inputs: &Inputs,
        gather: &LightGatherPass,
    ) -> BindGroup {
        let [lighting, _] = inputs.lit.bindings();
        let own = [
            lighting,
            ("senders", self.senders.as_entire_binding()),
            ("points", self.points.as_entire_binding()),
            ("cells", self.cells.as_entire_binding()),
            ("emission", gather.emission().as_entire_binding()),
            ("stands", self.stands.as_entire_binding()),
            ("exposed", self.exposed.as_entire_binding()),
        ];
        kernel.own(device, &own)
    }

    /// Each sphere's points are a cluster.
    pub fn clusters(&self, counts: Counts) -> ClusterBinding<'_> {
        ClusterBinding {
            clusters: self.clusters.as_entire_buffer_binding(),
            largest: number(counts.largest).max(1),
        }
    }

    pub fn bytes(&self) -> u64 {
        let own = [
            &self.senders,
            &self.points,
            &self.stands,
            &self.exposed,
            &self.clusters,
            &self.cells,
        ];
        own.into_iter().map(Buffer::size).sum()
    }
}

/// Points as receivers and their light, for whoever works off no plan.
#[derive(Debug)]
pub(crate) struct PointBuffers {
    receivers: Buffer,
    radiance: Buffer,
    sent: Buffer,
}

impl PointBuffers {
    pub(super) fn new(device: &Device, counts: Counts) -> Result<Self, Error> {
        let of = |label, size| make(device, label, POINTS, (counts.points, size));
        checked(device, || {
            Ok(Self {
                receivers: of("gaunt surface receivers", size_of::<Receiver>())?,
                radiance: of("gaunt surface light", 16)?,
                sent: of("gaunt surface light sent on", 16)?,
            })
        })
    }

    /// Receivers, light that comes directly, and light that spheres have sent.
    pub fn all(&self) -> [BufferBinding<'_>; 3] {
        [&self.receivers, &self.radiance, &self.sent].map(|b| b.as_entire_buffer_binding())
    }

    /// Spheres have sent nothing.
    pub fn clear_sent(&self, encoder: &mut CommandEncoder) {
        encoder.clear_buffer(&self.sent, 0, None);
    }

    pub fn bytes(&self) -> u64 {
        self.receivers.size() + self.radiance.size() + self.sent.size()
    }
}

/// What an error calls what is made by points.
const POINTS: &str = "room for surface points";

/// Room for a count of records of a size.
fn make(
    device: &Device,
    label: &str,
    what: &'static str,
    (count, size): (usize, usize),
) -> Result<Buffer, Error> {
    let room = room(device, what, number(count), size)?;
    Ok(buffer(device, label, room, BufferUsages::STORAGE))
}

fn number(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(u32::MAX)
}
