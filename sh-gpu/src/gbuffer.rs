//! The G-buffer pass: position, normal and albedo where the camera's rays first meet a surface.

use crate::layout::Layout;
use crate::pipeline::{Kernel, texture_bytes};
use crate::raster::{self, Drawing, target};
use crate::scope::checked;
use crate::slot::Slot;
use crate::{Bands, Bodies, Bound, Error, Pipelines};
use sh_kernels::{MIN_ORDER, Pass};
use sh_scene::Receiver;
use std::sync::Arc;
use wgpu::{
    BindGroup, BindingResource, BufferBinding, CommandEncoder, Device, RenderPass, RenderPipeline,
    TextureFormat, TextureView, VertexFormat,
};

/// Rasterises the bands of a grid through a picture and packs them into receivers and albedo, tile by tile.
///
/// Cells are drawn as fragments, one each, into two textures as large as a band; what [`COLOR`](Self::COLOR)
/// holds is said in `kernels/gbuffer.wgsl`. A host with its own scene draws into them itself, through
/// [`record_with`](Self::record_with).
///
/// ```no_run
/// # use sh_gpu::{Bands, Bodies, Error, GbufferPass};
/// # fn frame(device: &wgpu::Device, queue: &wgpu::Queue, encoder: &mut wgpu::CommandEncoder, bands: &Bands,
/// #     bodies: &Bodies, receivers: &wgpu::Buffer, albedo: &wgpu::Buffer) -> Result<(), Error> {
/// let pass = GbufferPass::new(device, bands)?;
/// let (receivers, albedo) = (receivers.as_entire_buffer_binding(), albedo.as_entire_buffer_binding());
/// let bound = pass.bind(device, receivers, albedo)?;
/// // every frame, after `bands.prepare` and `bodies.prepare`; here the first band alone
/// pass.record(encoder, bands, 0, bodies, &bound, None);
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct GbufferPass {
    /// None where there is nothing of the kind.
    bodies: Option<RenderPipeline>,
    ground: Option<RenderPipeline>,
    pack: Arc<Kernel>,
    /// Group 0 of the raster pipelines: the band.
    band: BindGroup,
    /// Group 0 of `pack`: the band and both textures.
    sources: BindGroup,
    targets: [TextureView; 3],
}

/// What a [`GbufferPass`] draws: everything, unless said otherwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Drawn {
    /// Bodies with triangles.
    pub bodies: bool,
    /// The ground plane; where there is none in a frame nothing of it is drawn either.
    pub ground: bool,
}

impl Default for Drawn {
    fn default() -> Self {
        Self {
            bodies: true,
            ground: true,
        }
    }
}

/// When the pass begins and ends: the query set, and the indices of both timestamps.
pub type Timestamps<'a> = Option<(&'a wgpu::QuerySet, [u32; 2])>;

impl GbufferPass {
    /// Format of both colour targets. The first: position as three floats' bits, object index. The second:
    /// octahedral normal as two floats' bits, red and green, blue and 1 in 16 bits each.
    pub const COLOR: TextureFormat = TextureFormat::Rgba32Uint;

    /// Format of the depth target: 1 at the near plane, 0 infinitely far; nearer is greater.
    pub const DEPTH: TextureFormat = raster::DEPTH;

    /// Makes pipelines and targets for the bands of a picture.
    pub fn new(device: &Device, bands: &Bands) -> Result<Self, Error> {
        Self::with(&Pipelines::new(device), bands)
    }

    /// As [`new`](Self::new), with pipelines that are shared.
    pub fn with(pipelines: &Pipelines, bands: &Bands) -> Result<Self, Error> {
        Self::drawing(pipelines, bands, Drawn::default())
    }

    /// As [`with`](Self::with), where it is known what there is to be drawn: nothing is compiled for the rest.
    pub fn drawing(pipelines: &Pipelines, bands: &Bands, drawn: Drawn) -> Result<Self, Error> {
        let device = pipelines.device();
        let bytes = device.limits().max_color_attachment_bytes_per_sample.into();
        Error::within(
            "a sample",
            32,
            "max_color_attachment_bytes_per_sample",
            bytes,
        )?;
        checked(device, || {
            let of = (Pass::Gbuffer, MIN_ORDER, MIN_ORDER);
            let names = Bodies::ENTRIES;
            let [every, body] = Layout::of_raster(device, Pass::Gbuffer, names);
            let band = every.bind(device, &[("band", bands.binding())]);
            let both = [Some(&every.layout), Some(&body.layout)];
            let drawing = |entries, groups, attributes| Drawing {
                label: LABEL,
                entries,
                groups,
                attributes,
                targets: &[Self::COLOR, Self::COLOR],
            };
            let bodies = drawn.bodies.then(|| {
                pipelines.raster(of, names[1], |module| {
                    raster::pipeline(device, module, &drawing(names, &both, &VERTEX))
                })
            });
            let names = ["ground_vertex", "ground_fragment"];
            let ground = drawn.ground.then(|| {
                pipelines.raster(of, names[1], |module| {
                    raster::pipeline(device, module, &drawing(names, &both[..1], &[]))
                })
            });

            let pack = pipelines.kernel(of, "pack")?;
            let largest = [bands.columns(), bands.rows(0)];
            let targets = [Self::COLOR, Self::COLOR, Self::DEPTH]
                .map(|format| target(device, LABEL, largest, format));
            let [place, surface, _] = &targets;
            let own = [
                ("band", bands.binding()),
                ("places", BindingResource::TextureView(place)),
                ("surfaces", BindingResource::TextureView(surface)),
            ];
            let sources = pack.own(device, &own);
            Ok(Self {
                bodies: bodies.transpose()?,
                ground: ground.transpose()?,
                pack,
                band,
                sources,
                targets,
            })
        })
    }

    /// Bytes of GPU memory that the pass owns: 36 a cell of the largest band.
    pub fn bytes(&self) -> u64 {
        let bytes = |view: &TextureView| texture_bytes(view.texture());
        self.targets.iter().map(bytes).sum()
    }

    /// Binds receivers ([`Receiver`], 32 bytes each) and albedo (red, green, blue, 0 as `vec4f`, 16 bytes
    /// each), both written. The size of `receivers` must be that of the band's tiles
    /// ([`Bands::receivers`]); the part of these that lies beyond the grid is written as not covered.
    pub fn bind(
        &self,
        device: &Device,
        receivers: BufferBinding<'_>,
        albedo: BufferBinding<'_>,
    ) -> Result<Bound, Error> {
        let receivers = Slot::counting("receivers", size_of::<Receiver>() as u64, receivers);
        self.pack
            .bind(device, &[receivers, Slot::with("albedo", 16, 1, albedo)])
    }

    /// Records a render pass that draws one band of the ground (if there is one) and of the bodies, and a
    /// compute pass that packs it into the receivers that were bound.
    pub fn record(
        &self,
        encoder: &mut CommandEncoder,
        bands: &Bands,
        band: u32,
        bodies: &Bodies,
        bound: &Bound,
        timestamps: Timestamps<'_>,
    ) {
        let draw = |pass: &mut RenderPass<'_>| {
            pass.set_bind_group(0, &self.band, &[bands.offset(band)]);
            if let Some(pipeline) = &self.bodies {
                pass.set_pipeline(pipeline);
                bodies.draw(pass);
            }
            if let Some(pipeline) = &self.ground {
                pass.set_pipeline(pipeline);
                pass.draw(0..3, 0..1);
            }
        };
        self.record_with(encoder, bands, band, draw, bound, timestamps);
    }

    /// As [`record`](Self::record), but the host draws. `draw` is given the render pass with the viewport
    /// set to the band's cells, and has to write both targets as their formats say, through
    /// [`Bands::camera`]. What it leaves alone is sky.
    pub fn record_with(
        &self,
        encoder: &mut CommandEncoder,
        bands: &Bands,
        band: u32,
        draw: impl FnOnce(&mut RenderPass<'_>),
        bound: &Bound,
        timestamps: Timestamps<'_>,
    ) {
        let [place, surface, depth] = &self.targets;
        let cleared = |view| {
            Some(wgpu::RenderPassColorAttachment {
                view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                    store: wgpu::StoreOp::Store,
                },
            })
        };
        let far = wgpu::Operations {
            load: wgpu::LoadOp::Clear(0.0),
            store: wgpu::StoreOp::Discard,
        };
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(LABEL),
            color_attachments: &[cleared(place), cleared(surface)],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: depth,
                depth_ops: Some(far),
                stencil_ops: None,
            }),
            timestamp_writes: timestamps.map(|(query_set, [begin, _])| {
                wgpu::RenderPassTimestampWrites {
                    query_set,
                    beginning_of_pass_write_index: Some(begin),
                    end_of_pass_write_index: None,
                }
            }),
            occlusion_query_set: None,
            multiview_mask: None,
        });
        pass.push_debug_group(LABEL);
        let (columns, rows) = (bands.columns(), bands.rows(band));
        pass.set_viewport(0.0, 0.0, columns as f32, rows as f32, 0.0, 1.0);
        pass.set_scissor_rect(0, 0, columns, rows);
        draw(&mut pass);
        pass.pop_debug_group();
        drop(pass);
        let ended = timestamps.map(|(query_set, [_, end])| wgpu::ComputePassTimestampWrites {
            query_set,
            beginning_of_pass_write_index: None,
            end_of_pass_write_index: Some(end),
        });
        self.pack.record(
            encoder,
            (&self.sources, &[bands.offset(band)]),
            bound,
            ended,
        );
    }
}

const LABEL: &str = "gaunt gbuffer";

/// A body's vertices as they are uploaded: position, normal, texture coordinates, colour.
const VERTEX: [VertexFormat; 4] = [
    VertexFormat::Float32x3,
    VertexFormat::Float32x3,
    VertexFormat::Float32x2,
    VertexFormat::Float32x3,
];
