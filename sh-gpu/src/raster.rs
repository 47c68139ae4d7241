//! What passes that draw do alike: targets, and pipelines over bodies' vertices.

use crate::records::Vertex;
use wgpu::{
    BindGroupLayout, Device, RenderPipeline, ShaderModule, TextureFormat, TextureUsages,
    TextureView, VertexAttribute, VertexFormat,
};

/// Format of depth, which is greater the nearer something is.
pub(crate) const DEPTH: TextureFormat = TextureFormat::Depth32Float;

/// What a pipeline draws, and into what.
pub(crate) struct Drawing<'a> {
    pub label: &'static str,
    /// The entry points of vertices and of fragments.
    pub entries: [&'a str; 2],
    pub groups: &'a [Option<&'a BindGroupLayout>],
    /// What it reads of a [`Vertex`]: formats, from its first byte on; nothing where it makes its vertices itself.
    pub attributes: &'a [VertexFormat],
    /// Besides depth.
    pub targets: &'a [TextureFormat],
}

/// A texture to draw into and to read.
pub(crate) fn target(
    device: &Device,
    label: &'static str,
    [width, height]: [u32; 2],
    format: TextureFormat,
) -> TextureView {
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d {
            width,
            height,
            depth_or_array_layers: 1,
        },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: TextureUsages::RENDER_ATTACHMENT | TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    });
    texture.create_view(&wgpu::TextureViewDescriptor {
        label: Some(label),
        ..Default::default()
    })
}

/// A pipeline that keeps what is nearest, of both sides of a surface, as rays hit both.
pub(crate) fn pipeline(
    device: &Device,
    module: &ShaderModule,
    drawing: &Drawing<'_>,
) -> RenderPipeline {
    let label = Some(drawing.label);
    let [vertex, fragment] = drawing.entries;
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label,
        bind_group_layouts: drawing.groups,
        immediate_size: 0,
    });
    let mut offset = 0;
    let attributes = (0..).zip(drawing.attributes).map(|(location, format)| {
        let attribute = VertexAttribute {
            format: *format,
            offset,
            shader_location: location,
        };
        offset += format.size();
        attribute
    });
    let attributes: Vec<_> = attributes.collect();
    let vertices = (!attributes.is_empty()).then_some(Some(wgpu::VertexBufferLayout {
        array_stride: size_of::<Vertex>() as u64,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes: &attributes,
    }));
    let targets = drawing.targets.iter().map(|format| {
        Some(wgpu::ColorTargetState {
            format: *format,
            blend: None,
            write_mask: wgpu::ColorWrites::ALL,
        })
    });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label,
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some(vertex),
            compilation_options: Default::default(),
            buffers: vertices.as_slice(),
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: Some(wgpu::DepthStencilState {
            format: DEPTH,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::Greater),
            stencil: Default::default(),
            bias: Default::default(),
        }),
        multisample: Default::default(),
        fragment: Some(wgpu::FragmentState {
            module,
            entry_point: Some(fragment),
            compilation_options: Default::default(),
            targets: &targets.collect::<Vec<_>>(),
        }),
        multiview_mask: None,
        cache: None,
    })
}
