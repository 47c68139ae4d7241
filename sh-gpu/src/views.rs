//! Lights with sharp shadows on the GPU, and what they see: pictures of all views side by side, drawn anew where a light or a body has moved.

use crate::layout::Layout;
use crate::lighting::{buffer, room};
use crate::pipeline::{Kernel, texture_bytes};
use crate::raster::{self, Drawing, target};
use crate::records::PunctualScene;
use crate::scope::checked;
use crate::upload::{Kept, Known};
use crate::{Bodies, Bound, Error, Pipelines};
use sh_core::constants::{NOWHERE, VIEW_BLOCK};
use sh_kernels::{MIN_ORDER, Pass};
use sh_scene::{LightView, LightViews, PunctualRecord, Scene};
use std::sync::Arc;
use wgpu::{
    BindGroup, BindingResource, Buffer, BufferUsages, CommandEncoder, ComputePassTimestampWrites,
    Queue, RenderPipeline, TextureFormat, TextureView, VertexFormat,
};

/// Bytes from one view's record to the next: the alignment that every device grants for dynamic offsets.
const STRIDE: u64 = 256;

/// What is drawn: how near something is, and the depth that decides what is nearest.
const FORMATS: [TextureFormat; 2] = [TextureFormat::R32Float, raster::DEPTH];

/// The entry points that find what is nearest, level by level.
const LEVELS: [&str; 3] = ["coarsen", "coarsen_again", "coarsen_last"];

/// Lights, views from them and their pictures.
#[derive(Debug)]
pub(crate) struct Views {
    /// As many of both as there were.
    counts: [usize; 2],
    side: u32,
    across: u32,
    source: Buffer,
    lights: Buffer,
    /// For whoever looks up one.
    views: Buffer,
    /// For whoever draws one.
    view: Buffer,
    eye: Buffer,
    coarse: Buffer,
    targets: [TextureView; 2],
    known: [Known; 4],
    known_eye: Known,
    kept: Kept<Vec<u8>>,
    /// None where nothing is looked at.
    draws: Option<Draws>,
}

/// How pictures are made.
#[derive(Debug)]
struct Draws {
    pipeline: RenderPipeline,
    group: BindGroup,
    levels: Vec<(Arc<Kernel>, BindGroup, Bound)>,
}

impl Views {
    /// Of a scene's lights, with pictures of what they see if anything may be in the way (`draws`).
    pub fn new(pipelines: &Pipelines, scene: &Scene, draws: bool) -> Result<Self, Error> {
        let device = pipelines.device();
        let seen = LightViews::of(scene)?;
        let count = match draws {
            true => seen.views.len(),
            false => 0,
        };
        let (side, across) = match count {
            0 => (1, 1),
            _ => (seen.side as u32, (count as f64).sqrt().ceil() as u32),
        };
        let most = device.limits().max_texture_dimension_2d.into();
        let texels = u64::from(side * across);
        Error::within(
            "the pictures from lights",
            texels,
            "max_texture_dimension_2d",
            most,
        )?;
        let records = |what, count: usize, size| {
            let count = u32::try_from(count).unwrap_or(u32::MAX);
            room(device, what, count, size)
        };
        let (uniform, storage) = (BufferUsages::UNIFORM, BufferUsages::STORAGE);
        let lights = records(
            "room for lights",
            seen.lights.len(),
            size_of::<PunctualRecord>(),
        )?;
        let views = records("room for views", count, size_of::<LightView>())?;
        let blocks = (side / VIEW_BLOCK).pow(2) as usize;
        let coarse = count * (blocks + blocks / (VIEW_BLOCK * VIEW_BLOCK) as usize + 1);
        let coarse = records("room for pictures from lights", coarse, 4)?;
        checked(device, || {
            let mut all = Self {
                counts: [seen.lights.len(), count],
                side,
                across,
                source: buffer(
                    device,
                    "gaunt lights",
                    size_of::<PunctualScene>() as u64,
                    uniform,
                ),
                lights: buffer(device, "gaunt lights", lights, storage),
                views: buffer(device, "gaunt views", views, storage),
                view: buffer(
                    device,
                    "gaunt views",
                    (count.max(1) as u64) * STRIDE,
                    uniform,
                ),
                eye: buffer(device, "gaunt eye", 16, uniform),
                coarse: buffer(device, "gaunt views", coarse, storage),
                targets: FORMATS.map(|format| target(device, LABEL, [side * across; 2], format)),
                known: Default::default(),
                known_eye: Known::default(),
                kept: Kept::default(),
                draws: None,
            };
            if count > 0 {
                all.draws = Some(all.drawn(pipelines)?);
            }
            Ok(all)
        })
    }

    fn drawn(&self, pipelines: &Pipelines) -> Result<Draws, Error> {
        let device = pipelines.device();
        let of = (Pass::LightView, MIN_ORDER, MIN_ORDER);
        let names = ["view_vertex", "view_fragment"];
        let [own, _] = Layout::of_raster(device, Pass::LightView, names);
        // Bodies are bound as they are where a camera sees them.
        let [_, body] = Layout::of_raster(device, Pass::Gbuffer, Bodies::ENTRIES);
        let pipeline = pipelines.raster(of, names[1], |module| {
            let drawing = Drawing {
                label: LABEL,
                entries: names,
                groups: &[Some(&own.layout), Some(&body.layout)],
                attributes: &[VertexFormat::Float32x3],
                targets: &FORMATS[..1],
            };
            raster::pipeline(device, module, &drawing)
        })?;
        let record = BindingResource::Buffer(wgpu::BufferBinding {
            buffer: &self.view,
            offset: 0,
            size: wgpu::BufferSize::new(size_of::<LightView>() as u64),
        });
        let group = own.bind(device, &[("view", record)]);
        let blocks = u64::from(self.side / VIEW_BLOCK).pow(2);
        let each = [blocks, blocks / u64::from(VIEW_BLOCK * VIEW_BLOCK), 1];
        let levels = LEVELS.into_iter().zip(each).map(|(name, each)| {
            let kernel = pipelines.kernel(of, name)?;
            let group = kernel.own(
                device,
                &[
                    ("source", self.source.as_entire_binding()),
                    ("nearest", BindingResource::TextureView(&self.targets[0])),
                    ("coarse", self.coarse.as_entire_binding()),
                ],
            );
            let workgroups = kernel.workgroups(each * self.counts[1] as u64)?;
            let bound = Bound::new(kernel.host(device, &[]), workgroups);
            Ok((kernel, group, bound))
        });
        Ok(Draws {
            pipeline,
            group,
            levels: levels.collect::<Result<_, Error>>()?,
        })
    }

    /// Whether anything may be in the way.
    pub fn draws(&self) -> bool {
        self.draws.is_some()
    }

    /// What the passes that light receivers by it are bound to in group 0.
    pub fn bindings(&self) -> [(&'static str, BindingResource<'_>); 6] {
        [
            ("source", self.source.as_entire_binding()),
            ("lights", self.lights.as_entire_binding()),
            ("views", self.views.as_entire_binding()),
            ("nearest", BindingResource::TextureView(&self.targets[0])),
            ("coarse", self.coarse.as_entire_binding()),
            ("eye", self.eye.as_entire_binding()),
        ]
    }

    /// Uploads lights and views for what is submitted next.
    pub fn prepare(&self, queue: &Queue, scene: &Scene) -> Result<(), Error> {
        let seen = LightViews::of(scene)?;
        let [lights, views] = self.counts;
        if seen.lights.len() != lights || (views > 0 && seen.views.len() != views) {
            return Err(Error::Punctual {
                lights: seen.lights.len(),
                views: seen.views.len(),
                expected: lights,
                made_for: views,
            });
        }
        let [source, known_lights, known_views, known_view] = &self.known;
        let record = PunctualScene {
            lights: lights as u32,
            views: views as u32,
            side: self.side,
            across: self.across,
            ground: u32::from(scene.ground.is_some()),
            ground_height: scene.ground.map_or(0.0, |ground| ground.height),
            tail: [0; 2],
        };
        source.write(queue, &self.source, &[record]);
        known_lights.write(queue, &self.lights, &seen.lights);
        if views == 0 {
            return Ok(());
        }
        known_views.write(queue, &self.views, &seen.views);
        self.kept.with(|bytes| {
            bytes.clear();
            bytes.resize(self.view.size() as usize, 0);
            for (view, bytes) in seen.views.iter().zip(bytes.chunks_mut(STRIDE as usize)) {
                bytes[..size_of::<LightView>()].copy_from_slice(bytemuck::bytes_of(view));
            }
            known_view.write(queue, &self.view, bytes);
        });
        Ok(())
    }

    /// Uploads from where what is mirrored is seen.
    pub fn look_from(&self, queue: &Queue, [x, y, z]: [f32; 3]) {
        self.known_eye.write(queue, &self.eye, &[[x, y, z, 0.0]]);
    }

    /// Bytes that have been uploaded since it was made.
    pub fn uploaded(&self) -> u64 {
        self.known.iter().map(Known::written).sum()
    }

    /// Bytes of GPU memory.
    pub fn bytes(&self) -> u64 {
        let buffers = [
            &self.source,
            &self.lights,
            &self.views,
            &self.view,
            &self.eye,
            &self.coarse,
        ];
        let buffers: u64 = buffers.into_iter().map(Buffer::size).sum();
        let targets = self.targets.iter();
        buffers
            + targets
                .map(|view| texture_bytes(view.texture()))
                .sum::<u64>()
    }

    /// How many draws and dispatches a frame records, with so many bodies that are drawn.
    pub fn dispatches(&self, bodies: usize) -> usize {
        let levels = self.draws.as_ref().map_or(0, |draws| draws.levels.len());
        self.counts[1] * bodies + levels
    }

    /// Records a render pass that draws all views, and compute passes that find what is nearest in them.
    pub fn record(
        &self,
        encoder: &mut CommandEncoder,
        bodies: &Bodies,
        stamps: Option<(&wgpu::QuerySet, [u32; 2])>,
    ) {
        let Some(draws) = &self.draws else {
            return;
        };
        let [color, depth] = &self.targets;
        let nothing = wgpu::Color {
            r: f64::from(NOWHERE),
            ..wgpu::Color::TRANSPARENT
        };
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(LABEL),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: color,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(nothing),
                    store: wgpu::StoreOp::Store,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(0.0),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            timestamp_writes: stamps.map(|(query_set, [begin, _])| {
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
        pass.set_pipeline(&draws.pipeline);
        for view in 0..self.counts[1] as u32 {
            let corner = [view % self.across, view / self.across].map(|at| at * self.side);
            let [x, y, side] = [corner[0], corner[1], self.side].map(|n| n as f32);
            pass.set_viewport(x, y, side, side, 0.0, 1.0);
            pass.set_scissor_rect(corner[0], corner[1], self.side, self.side);
            pass.set_bind_group(0, &draws.group, &[view * STRIDE as u32]);
            bodies.draw(&mut pass);
        }
        pass.pop_debug_group();
        drop(pass);
        let last = draws.levels.len() - 1;
        for (level, (kernel, group, bound)) in draws.levels.iter().enumerate() {
            let ended = stamps.filter(|_| level == last);
            let ended = ended.map(|(query_set, [_, end])| ComputePassTimestampWrites {
                query_set,
                beginning_of_pass_write_index: None,
                end_of_pass_write_index: Some(end),
            });
            kernel.record(encoder, (group, &[]), bound, ended);
        }
    }
}

const LABEL: &str = "gaunt light view";
