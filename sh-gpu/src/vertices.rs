//! The vertices pass: a host's own vertex buffer as receivers.

use crate::pipeline::Kernel;
use crate::records::VertexSource;
use crate::scope::checked;
use crate::slot::Slot;
use crate::{Bound, Error, Pipelines};
use glam::{Affine3A, Mat4};
use sh_kernels::{MIN_ORDER, Pass};
use sh_scene::Receiver;
use std::sync::Arc;
use wgpu::{
    BindGroup, Buffer, BufferBinding, BufferUsages, CommandEncoder, ComputePassTimestampWrites,
    Device, Queue,
};

/// Where positions and normals lie in a vertex buffer: three `f32` each, in object space. All in bytes, all multiples
/// of 4.
///
/// ```
/// // Position, normal, texture coordinates, one vertex after another.
/// let interleaved = sh_gpu::VertexLayout { first: 0, stride: 32, normal: 12 };
/// // All positions of 1000 vertices, and then all normals.
/// let apart = sh_gpu::VertexLayout { first: 0, stride: 12, normal: 12_000 };
/// # assert_ne!(interleaved, apart);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VertexLayout {
    /// The first position, from where the binding begins.
    pub first: u32,
    /// From one vertex to the next.
    pub stride: u32,
    /// From a vertex's position to its normal, which need not have unit length.
    pub normal: u32,
}

/// A host's vertices as receivers: 64 bytes of traffic a vertex, next to nothing beside what lights them.
///
/// ```no_run
/// # use sh_gpu::{Error, ShadowPass, VertexLayout, VertexPass};
/// # fn frame(device: &wgpu::Device, queue: &wgpu::Queue, mesh: &wgpu::Buffer, receivers: &wgpu::Buffer,
/// #     radiance: &wgpu::Buffer, shadow: &ShadowPass, world: glam::Affine3A) -> Result<(), Error> {
/// let pass = VertexPass::new(device)?;
/// let layout = VertexLayout { first: 0, stride: 32, normal: 12 };
/// let (vertices, receivers) = (mesh.as_entire_buffer_binding(), receivers.as_entire_buffer_binding());
/// let bound = pass.bind(device, layout, vertices, receivers.clone())?;
/// let lit = shadow.bind(device, receivers, radiance.as_entire_buffer_binding())?;
/// // every frame
/// pass.prepare(queue, &bound, world, 0);
/// let mut encoder = device.create_command_encoder(&Default::default());
/// pass.record(&mut encoder, &bound, None);
/// shadow.record(&mut encoder, &lit, None); // `radiance` is a vertex buffer of 16 bytes a vertex
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct VertexPass {
    kernel: Arc<Kernel>,
}

/// One mesh's vertices and receivers, bound to a [`VertexPass`].
#[derive(Clone, Debug)]
pub struct VertexBound {
    bound: Bound,
    group: BindGroup,
    record: Buffer,
    layout: VertexLayout,
}

impl VertexBound {
    /// Bytes of GPU memory: one record.
    pub fn bytes(&self) -> u64 {
        self.record.size()
    }
}

impl VertexPass {
    /// Makes the pipeline.
    pub fn new(device: &Device) -> Result<Self, Error> {
        Self::with(&Pipelines::new(device))
    }

    /// As [`new`](Self::new), with a pipeline that is shared.
    pub fn with(pipelines: &Pipelines) -> Result<Self, Error> {
        let of = (Pass::Vertices, MIN_ORDER, MIN_ORDER);
        let kernel = checked(pipelines.device(), || pipelines.kernel(of, "from_vertices"))?;
        Ok(Self { kernel })
    }

    /// Binds vertices (read) and receivers ([`Receiver`], 32 bytes each, written; as many as there are vertices to
    /// take). Both need `BufferUsages::STORAGE`, beside what else they are used for. A mesh whose vertices exceed
    /// the device's `max_storage_buffer_binding_size` is bound in several parts of its own.
    pub fn bind(
        &self,
        device: &Device,
        layout: VertexLayout,
        vertices: BufferBinding<'_>,
        receivers: BufferBinding<'_>,
    ) -> Result<VertexBound, Error> {
        let receivers = Slot::counting("receivers", size_of::<Receiver>() as u64, receivers);
        let vertices = Slot::with("vertices", 4, 0, vertices);
        let words = self.kernel.elements(&vertices)?;
        let count = self.kernel.elements(&receivers)?;
        layout.check(count, words * 4)?;
        checked(device, || {
            let record = device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("gaunt vertex source"),
                size: size_of::<VertexSource>() as u64,
                usage: BufferUsages::UNIFORM | BufferUsages::COPY_DST,
                mapped_at_creation: false,
            });
            let source = ("source", record.as_entire_binding());
            Ok(VertexBound {
                bound: self.kernel.bind(device, &[receivers, vertices])?,
                group: self.kernel.own(device, &[source]),
                record,
                layout,
            })
        })
    }

    /// Uploads where the mesh stands, and which body it is of: 1 more than the index of its spheres among those of all
    /// objects, or 0 for none. For what is submitted next.
    pub fn prepare(
        &self,
        queue: &Queue,
        bound: &VertexBound,
        world_from_object: Affine3A,
        object: u32,
    ) {
        let VertexLayout {
            first,
            stride,
            normal,
        } = bound.layout;
        let record = VertexSource {
            world_from_object: Mat4::from(world_from_object),
            first: first / 4,
            stride: stride / 4,
            normal: normal / 4,
            object,
        };
        queue.write_buffer(&bound.record, 0, bytemuck::bytes_of(&record));
    }

    /// Records one compute pass that writes the receivers. Vertices without a normal are not covered.
    pub fn record(
        &self,
        encoder: &mut CommandEncoder,
        bound: &VertexBound,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) {
        let own = (&bound.group, &[][..]);
        self.kernel.record(encoder, own, &bound.bound, timestamps);
    }
}

impl VertexLayout {
    /// Whether so many vertices lie within so many bytes.
    fn check(&self, count: u64, bytes: u64) -> Result<(), Error> {
        let Self {
            first,
            stride,
            normal,
        } = *self;
        for (name, value) in [
            ("begin at byte", first),
            ("stride is", stride),
            ("normal is at byte", normal),
        ] {
            if value % 4 != 0 {
                return Err(Error::Vertices(format!(
                    "cannot be read: their {name} {value}, which has to be a multiple of 4"
                )));
            }
        }
        let [first, stride, normal] = [first, stride, normal].map(u64::from);
        let end = first + count.saturating_sub(1) * stride + normal + 12;
        match end <= bytes {
            true => Ok(()),
            false => Err(Error::Vertices(format!(
                "have {bytes} bytes; {count} receivers with a vertex every {stride} bytes from {first} on, and normals \
                 {normal} bytes after, need {end}"
            ))),
        }
    }
}
