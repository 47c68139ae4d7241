//! The buffers of the pass.

use super::Shining;
use crate::lighting::{buffer, room};
use crate::pipeline::Kernel;
use crate::records::Sender;
use crate::slot::Slot;
use crate::{ClusterBinding, Error, LightGatherPass, ShadowPass};
use sh_scene::Receiver;
use sh_scene::surface::{DIRECTIONS, MOST_COEFFICIENTS, SurfacePoint, cell_sums};
use wgpu::{BindGroup, Buffer, BufferUsages, Device, Queue};

/// What a pass was made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Counts {
    pub spheres: usize,
    pub points: usize,
    /// Points of the sphere that has most.
    pub largest: usize,
}

impl Counts {
    pub fn of<'a>(bodies: impl IntoIterator<Item = Shining<'a>>) -> Self {
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

/// What spheres and their points are, and the points as receivers with their light.
#[derive(Debug)]
pub(super) struct Memory {
    pub senders: Buffer,
    pub points: Buffer,
    pub stands: Buffer,
    pub exposed: Buffer,
    pub clusters: Buffer,
    pub receivers: Buffer,
    cells: Buffer,
    /// Radiance of the points by the shadow pass.
    pub direct: Buffer,
}

impl Memory {
    /// Room for so many, and what directions' cells are.
    pub fn new(device: &Device, queue: &Queue, counts: Counts) -> Result<Self, Error> {
        let none = BufferUsages::empty();
        let (spheres, points) = (counts.spheres, counts.points);
        let of_spheres =
            |label, size| make(device, label, "room for spheres", (spheres, size), none);
        let of_points = |label, size| make(device, label, POINTS, (points, size), none);
        let by_sphere = |label, size| make(device, label, POINTS, (spheres, size), none);
        let sums = cell_sums();
        let cells = (sums.len(), size_of_val(&sums[0]));
        let memory = Self {
            senders: of_spheres("gaunt senders", size_of::<Sender>())?,
            points: of_points("gaunt surface points", size_of::<SurfacePoint>())?,
            receivers: of_points("gaunt surface receivers", size_of::<Receiver>())?,
            stands: by_sphere("gaunt standing points", DIRECTIONS)?,
            exposed: by_sphere(
                "gaunt exposed spheres",
                MOST_COEFFICIENTS * size_of::<f32>(),
            )?,
            clusters: by_sphere("gaunt surface clusters", 8)?,
            direct: lights(device, "gaunt surface light", counts)?,
            cells: make(device, "gaunt cells", POINTS, cells, none)?,
        };
        queue.write_buffer(&memory.cells, 0, bytemuck::cast_slice(&sums[..]));
        Ok(memory)
    }

    /// What all kernels are bound to.
    pub fn group(
        &self,
        device: &Device,
        kernel: &Kernel,
        shadow: &ShadowPass,
        gather: &LightGatherPass,
    ) -> BindGroup {
        let [lighting, _] = shadow.lit.bindings();
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
    pub fn all_clusters(&self, counts: Counts) -> ClusterBinding<'_> {
        ClusterBinding {
            clusters: whole(&self.clusters),
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
            &self.receivers,
            &self.cells,
            &self.direct,
        ];
        own.into_iter().map(Buffer::size).sum()
    }
}

/// What an error calls what is made by points.
const POINTS: &str = "room for surface points";

/// Radiance of all points.
pub(super) fn lights(device: &Device, label: &str, counts: Counts) -> Result<Buffer, Error> {
    let copied = BufferUsages::COPY_SRC;
    make(device, label, POINTS, (counts.points, 16), copied)
}

/// Room for a count of records of a size.
fn make(
    device: &Device,
    label: &str,
    what: &'static str,
    (count, size): (usize, usize),
    usage: BufferUsages,
) -> Result<Buffer, Error> {
    let room = room(device, what, number(count), size)?;
    Ok(buffer(device, label, room, usage | BufferUsages::STORAGE))
}

fn number(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(u32::MAX)
}

/// All of a buffer of such records.
pub(super) fn of<'a>(buffer: &'a Buffer, name: &'static str, stride: u64) -> Slot<'a> {
    Slot::counting(name, stride, whole(buffer))
}

pub(super) fn whole(buffer: &Buffer) -> wgpu::BufferBinding<'_> {
    buffer.as_entire_buffer_binding()
}
