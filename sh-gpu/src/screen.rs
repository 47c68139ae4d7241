//! The screen pass: a host's own G-buffer as receivers, and radiance back into its texture.

use crate::pipeline::Kernel;
use crate::records::ScreenSource;
use crate::scope::checked;
use crate::upload::{Kept, write};
use crate::{Bound, Error, Pipelines, Position, ScreenCamera, ScreenTextures};
use bytemuck::Zeroable;
use sh_kernels::{MIN_ORDER, Pass};
use sh_scene::{Receiver, Tiles};
use std::sync::Arc;
use wgpu::{
    BindGroup, BindingResource, Buffer, BufferBinding, BufferUsages, CommandEncoder,
    ComputePassTimestampWrites, Device, Queue, TextureFormat,
};

/// Bytes from one part's record to the next: the alignment that every device grants for dynamic offsets.
const STRIDE: u64 = 256;

/// Receivers and radiance of a part of the screen: whole rows of tiles.
#[derive(Clone, Debug)]
pub struct ScreenPart<'a> {
    /// [`Receiver`] records, 32 bytes each, tile by tile ([`Tiles`]).
    pub receivers: BufferBinding<'a>,
    /// A `vec4f` each, 16 bytes.
    pub radiance: BufferBinding<'a>,
}

/// A host's own G-buffer as receivers, and their radiance as a texture of the host's.
///
/// Receivers lie tile by tile, 16 by 16 pixels, so that each tile is a cluster of the passes that shade them. They
/// and their radiance take 48 bytes a pixel, in as many parts as the device's largest binding asks for: one up to
/// 2.7 million pixels with WebGPU's default limits, and so two at 2560 by 1440.
///
/// ```no_run
/// # use sh_gpu::{Bound, Error, Position, ScreenCamera, ScreenPass, ScreenTextures, ShadowPass};
/// # fn frame(device: &wgpu::Device, queue: &wgpu::Queue, depth: &wgpu::TextureView, normal: &wgpu::TextureView,
/// #     radiance: &wgpu::TextureView, shadow: &ShadowPass, camera: &ScreenCamera) -> Result<(), Error> {
/// // once, and when the size changes
/// let textures = ScreenTextures { position: Position::Depth(depth), normal, radiance };
/// let screen = ScreenPass::new(device, textures)?;
/// let bind = |part: sh_gpu::ScreenPart| shadow.bind(device, part.receivers, part.radiance);
/// let lit: Bound = screen.parts().map(bind).collect::<Result<_, _>>()?;
/// // every frame, once the G-buffer is drawn
/// screen.prepare(queue, camera);
/// let mut encoder = device.create_command_encoder(&Default::default());
/// screen.record_receivers(&mut encoder, None);
/// shadow.record(&mut encoder, &lit, None);
/// screen.record_radiance(&mut encoder, None);
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct ScreenPass {
    from: Arc<Kernel>,
    to: Arc<Kernel>,
    record: Buffer,
    /// Group 0 of both kernels.
    groups: [BindGroup; 2],
    parts: Vec<Part>,
    size: [u32; 2],
    kept: Kept<Vec<u8>>,
}

#[derive(Debug)]
struct Part {
    first_row: u32,
    receivers: Buffer,
    radiance: Buffer,
    from: Bound,
    to: Bound,
}

impl ScreenPass {
    /// The format of the radiance texture: linear red, green, blue, and 0.
    pub const RADIANCE: TextureFormat = TextureFormat::Rgba16Float;

    /// Makes pipelines, receivers and radiance for a G-buffer's textures, and binds these.
    pub fn new(device: &Device, textures: ScreenTextures<'_>) -> Result<Self, Error> {
        Self::with(&Pipelines::new(device), textures)
    }

    /// As [`new`](Self::new), with pipelines that are shared.
    pub fn with(pipelines: &Pipelines, textures: ScreenTextures<'_>) -> Result<Self, Error> {
        let device = pipelines.device();
        let size = textures.check()?;
        let grid = Tiles {
            columns: size[0].div_ceil(Tiles::SIDE),
            rows: size[1].div_ceil(Tiles::SIDE),
        };
        let row = u64::from(grid.columns) * Tiles::AREA as u64 * size_of::<Receiver>() as u64;
        let limits = device.limits();
        let most = limits.max_storage_buffer_binding_size;
        let name = "max_storage_buffer_binding_size";
        Error::within("a row of receivers", row, name, most)?;
        let most = most.min(limits.max_buffer_size);
        Error::within("a row of receivers", row, "max_buffer_size", most)?;
        let rows = (most / row).min(u64::from(grid.rows)) as u32;
        checked(device, || {
            let (from, to) = kernels(pipelines, textures.position)?;
            let count = grid.rows.div_ceil(rows);
            let record = device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("gaunt screen source"),
                size: u64::from(count) * STRIDE,
                usage: BufferUsages::UNIFORM | BufferUsages::COPY_DST,
                mapped_at_creation: false,
            });
            let source = BindingResource::Buffer(BufferBinding {
                buffer: &record,
                offset: 0,
                size: wgpu::BufferSize::new(size_of::<ScreenSource>() as u64),
            });
            let own = [("source", source)];
            let groups = [&from, &to].map(|kernel| kernel.own(device, &own));
            let parts = (0..count).map(|part| {
                let first = part * rows;
                let tiles = u64::from(grid.columns) * u64::from(rows.min(grid.rows - first));
                let pixels = tiles * Tiles::AREA as u64;
                Part::new(device, [&from, &to], first * Tiles::SIDE, pixels, textures)
            });
            Ok(Self {
                parts: parts.collect::<Result<_, Error>>()?,
                from,
                to,
                record,
                groups,
                size,
                kept: Kept::default(),
            })
        })
    }

    /// Receivers and radiance, part by part, for the passes that shade them.
    pub fn parts(&self) -> impl Iterator<Item = ScreenPart<'_>> {
        self.parts.iter().map(|part| ScreenPart {
            receivers: part.receivers.as_entire_buffer_binding(),
            radiance: part.radiance.as_entire_buffer_binding(),
        })
    }

    /// Bytes of GPU memory that the pass owns.
    pub fn bytes(&self) -> u64 {
        let of = |part: &Part| part.receivers.size() + part.radiance.size();
        self.record.size() + self.parts.iter().map(of).sum::<u64>()
    }

    /// Uploads how the G-buffer is to be read, for what is submitted next.
    pub fn prepare(&self, queue: &Queue, camera: &ScreenCamera) {
        self.kept.with(|bytes| {
            bytes.clear();
            for part in &self.parts {
                let record = ScreenSource {
                    world_from_clip: camera.world_from_clip,
                    size: self.size,
                    first_row: part.first_row,
                    empty: camera.empty_depth,
                    scale: camera.normal_scale,
                    bias: camera.normal_bias,
                    ..ScreenSource::zeroed()
                };
                bytes.extend_from_slice(bytemuck::bytes_of(&record));
                bytes.resize(bytes.len().next_multiple_of(STRIDE as usize), 0);
            }
            write(queue, &self.record, bytes);
        });
    }

    /// Records one compute pass that reads the G-buffer and writes the receivers. Pixels without depth, alpha or normal
    /// are not covered.
    pub fn record_receivers(
        &self,
        encoder: &mut CommandEncoder,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) {
        let parts = self.offsets().map(|(part, offset)| (offset, &part.from));
        self.from
            .record_parts(encoder, &self.groups[0], parts, timestamps);
    }

    /// Records one compute pass that writes radiance to the texture; 0 for what is not covered.
    pub fn record_radiance(
        &self,
        encoder: &mut CommandEncoder,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) {
        let parts = self.offsets().map(|(part, offset)| (offset, &part.to));
        self.to
            .record_parts(encoder, &self.groups[1], parts, timestamps);
    }

    /// The parts, each with the offset of its record.
    fn offsets(&self) -> impl Iterator<Item = (&Part, u32)> {
        self.parts.iter().zip((0..).step_by(STRIDE as usize))
    }
}

impl Part {
    fn new(
        device: &Device,
        [from, to]: [&Arc<Kernel>; 2],
        first_row: u32,
        pixels: u64,
        textures: ScreenTextures<'_>,
    ) -> Result<Self, Error> {
        let buffer = |label, stride| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: pixels * stride,
                usage: BufferUsages::STORAGE | BufferUsages::COPY_SRC,
                mapped_at_creation: false,
            })
        };
        let receivers = buffer("gaunt screen receivers", size_of::<Receiver>() as u64);
        let radiance = buffer("gaunt screen radiance", 16);
        let view = |name, view| (name, BindingResource::TextureView(view));
        let position = match textures.position {
            Position::Texture(position) => view("positions", position),
            Position::Depth(depth) => view("depths", depth),
        };
        let bound = |kernel: &Kernel, all: &[(&str, BindingResource<'_>)]| {
            let group = kernel.host(device, all);
            Ok::<_, Error>(Bound::new(group, kernel.workgroups(pixels)?))
        };
        let read = [
            ("receivers", receivers.as_entire_binding()),
            view("normals", textures.normal),
            position,
        ];
        let written = [
            ("radiance", radiance.as_entire_binding()),
            view("target_texture", textures.radiance),
        ];
        Ok(Self {
            first_row,
            from: bound(from, &read)?,
            to: bound(to, &written)?,
            receivers,
            radiance,
        })
    }
}

/// The kernels that read a G-buffer and write radiance.
fn kernels(
    pipelines: &Pipelines,
    position: Position<'_>,
) -> Result<(Arc<Kernel>, Arc<Kernel>), Error> {
    let name = match position {
        Position::Texture(_) => "from_positions",
        Position::Depth(_) => "from_depth",
    };
    let of = (Pass::Screen, MIN_ORDER, MIN_ORDER);
    Ok((
        pipelines.kernel(of, name)?,
        pipelines.kernel(of, "to_texture")?,
    ))
}
