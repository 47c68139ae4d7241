//! A minimal renderer with its own device, raster pass and G-buffer, and Gaunt's shadows in it (`shadows.rs`).
//!
//!     cargo run -p host -- -o host.png

mod shadows;

use glam::camera::rh::{proj::directx::perspective_infinite_reverse, view::look_at_mat4};
use glam::{Mat4, Vec3};
use sh_gpu::{Position, ScreenTextures, Watch};
use sh_scene::{Light, Sky, Sphere};
use shadows::Shadows;
use std::error::Error;
use std::path::Path;
use wgpu::{CommandEncoder, Device, RenderPass, TextureFormat, TextureUsages, TextureView};

/// The picture's pixels.
const SIZE: [u32; 2] = [640, 400];

/// Centre, radius and albedo of every ball.
const BALLS: [([f32; 3], f32, [f32; 3]); 5] = [
    ([-0.5, 0.9, 0.0], 0.9, [0.7, 0.3, 0.2]),
    ([-0.6, 2.35, 0.1], 0.6, [0.75, 0.65, 0.5]),
    ([1.5, 0.5, 0.6], 0.5, [0.25, 0.45, 0.65]),
    ([0.75, 0.3, 1.5], 0.3, [0.65, 0.65, 0.65]),
    ([-1.9, 0.4, 1.3], 0.4, [0.4, 0.55, 0.3]),
];

fn main() {
    let path = std::env::args_os().nth(2).unwrap_or("host.png".into()); // after `-o`
    if let Err(error) = pollster::block_on(render(Path::new(&path))) {
        eprintln!("host: {error}");
        std::process::exit(1);
    }
}

async fn render(path: &Path) -> Result<(), Box<dyn Error>> {
    // The host's own device, with nothing but what every WebGPU device has.
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = instance.request_adapter(&Default::default()).await;
    let adapter = adapter.map_err(|error| format!("there is no GPU adapter: {error}"))?;
    let (device, queue) = adapter.request_device(&Default::default()).await?;
    let watch = Watch::new(&device);

    // Its G-buffer, two by two samples a pixel, and the picture.
    let (large, read, drawn) = (SIZE.map(|s| 2 * s), TextureUsages::TEXTURE_BINDING, TextureUsages::RENDER_ATTACHMENT);
    let [half, byte] = [TextureFormat::Rgba16Float, TextureFormat::Rgba8Unorm];
    let normal = texture(&device, "normal", large, half, read | drawn);
    let albedo = texture(&device, "albedo", large, byte, read | drawn);
    let depth = texture(&device, "depth", large, TextureFormat::Depth32Float, read | drawn);
    let radiance = texture(&device, "radiance", large, half, read | TextureUsages::STORAGE_BINDING);
    let srgb = TextureFormat::Rgba8UnormSrgb;
    let picture = texture(&device, "picture", SIZE, srgb, drawn | TextureUsages::COPY_SRC);

    // Its scene, camera and passes.
    let spheres = BALLS.map(|(center, radius, _)| Sphere { center, radius });
    let eye = look_at_mat4(Vec3::new(0.4, 2.9, 6.5), Vec3::new(-0.1, 1.05, 0.0), Vec3::Y);
    let clip_from_world = perspective_infinite_reverse(0.62, SIZE[0] as f32 / SIZE[1] as f32, 0.1) * eye;
    let frame = frame_record(clip_from_world);
    let uniform = wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST;
    let uniform = buffer(&device, "frame", size_of_val(&frame[..]) as u64, uniform);
    let shader = device.create_shader_module(wgpu::include_wgsl!("host.wgsl"));
    let bodies = Draw::new(&device, &shader, "body", &[half, byte], true, &[uniform.as_entire_binding()]);
    let views = [&albedo, &depth, &radiance].map(wgpu::BindingResource::TextureView);
    let compose = Draw::new(&device, &shader, "picture", &[srgb], false, &views);

    // Gaunt.
    let textures = ScreenTextures { position: Position::Depth(&depth), normal: &normal, radiance: &radiance };
    let mut shadows = Shadows::new(&device, textures, &spheres)?;
    // A clear sky with the sun at the right. Projected again only when it changes.
    let sky = Sky { sun: Vec3::new(0.8, 0.6, 0.35), ..Sky::default() };
    let light = Light::project(&sky.map(128, 64), None, 4, f32::INFINITY)?;

    // A frame: the host draws, Gaunt shades, the host composes.
    queue.write_buffer(&uniform, 0, bytemuck::cast_slice(&frame));
    shadows.prepare(&queue, clip_from_world, &spheres, &light)?;
    let mut encoder = device.create_command_encoder(&Default::default());
    bodies.record(&mut encoder, &[&normal, &albedo], Some(&depth), |pass| {
        pass.draw(0..6, 0..1);
        pass.draw(0..6 * 96 * 48, 1..1 + BALLS.len() as u32);
    });
    shadows.record(&mut encoder);
    compose.record(&mut encoder, &[&picture], None, |pass| pass.draw(0..3, 0..1));

    // Into a file.
    let usage = wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST;
    let pixels = buffer(&device, "pixels", u64::from(SIZE[0] * SIZE[1] * 4), usage);
    let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(SIZE[0] * 4), rows_per_image: None };
    let target = wgpu::TexelCopyBufferInfo { buffer: &pixels, layout };
    encoder.copy_texture_to_buffer(picture.texture().as_image_copy(), target, picture.texture().size());
    queue.submit([encoder.finish()]);
    pixels.map_async(wgpu::MapMode::Read, .., |_| ());
    device.poll(wgpu::PollType::wait_indefinitely())?;
    watch.check()?;
    save(path, &pixels.slice(..).get_mapped_range()?)
}

/// `struct Frame` of `host.wgsl`: camera, ground and balls, and their albedos.
fn frame_record(clip_from_world: Mat4) -> Vec<f32> {
    let places = BALLS.iter().flat_map(|([x, y, z], radius, _)| [*x, *y, *z, *radius]);
    let colors = BALLS.iter().flat_map(|(_, _, [r, g, b])| [*r, *g, *b, 1.0]);
    let [ground, grey] = [[0.0, 0.0, 0.0, 300.0], [0.45, 0.45, 0.45, 1.0]];
    clip_from_world.to_cols_array().into_iter().chain(ground).chain(places).chain(grey).chain(colors).collect()
}

fn buffer(device: &Device, name: &str, size: u64, usage: wgpu::BufferUsages) -> wgpu::Buffer {
    device.create_buffer(&wgpu::BufferDescriptor { label: Some(name), size, usage, mapped_at_creation: false })
}

fn texture(device: &Device, name: &str, size: [u32; 2], format: TextureFormat, usage: TextureUsages) -> TextureView {
    let descriptor = wgpu::TextureDescriptor {
        label: Some(name),
        size: wgpu::Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    };
    device.create_texture(&descriptor).create_view(&Default::default())
}

/// A raster pass: the entry points `NAME_vertex` and `NAME_fragment`, and what they bind.
struct Draw {
    pipeline: wgpu::RenderPipeline,
    group: wgpu::BindGroup,
}

impl Draw {
    fn new(
        device: &Device, module: &wgpu::ShaderModule, name: &str, formats: &[TextureFormat], with_depth: bool,
        resources: &[wgpu::BindingResource<'_>],
    ) -> Self {
        let [vertex, fragment] = ["vertex", "fragment"].map(|stage| format!("{name}_{stage}"));
        let targets: Vec<_> = formats.iter().map(|format| Some((*format).into())).collect();
        let depth = wgpu::DepthStencilState {
            format: TextureFormat::Depth32Float,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::Greater),
            stencil: Default::default(),
            bias: Default::default(),
        };
        let options = wgpu::PipelineCompilationOptions::default;
        let (compilation_options, entry_point) = (options(), Some(&vertex[..]));
        let vertex = wgpu::VertexState { module, entry_point, compilation_options, buffers: &[] };
        let (compilation_options, entry_point) = (options(), Some(&fragment[..]));
        let fragment = wgpu::FragmentState { module, entry_point, compilation_options, targets: &targets };
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(name),
            layout: None,
            vertex,
            primitive: Default::default(),
            depth_stencil: with_depth.then_some(depth),
            multisample: Default::default(),
            fragment: Some(fragment),
            multiview_mask: None,
            cache: None,
        });
        let resources = (0..).zip(resources.iter().cloned());
        let entries: Vec<_> = resources.map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource }).collect();
        let layout = &pipeline.get_bind_group_layout(0);
        let group = wgpu::BindGroupDescriptor { label: Some(name), layout, entries: &entries };
        Self { group: device.create_bind_group(&group), pipeline }
    }

    /// Clears the targets and draws.
    fn record(
        &self, encoder: &mut CommandEncoder, targets: &[&TextureView], depth_view: Option<&TextureView>,
        draws: impl FnOnce(&mut RenderPass<'_>),
    ) {
        let ops = wgpu::Operations::default();
        let clear = |view| wgpu::RenderPassColorAttachment { view, depth_slice: None, resolve_target: None, ops };
        let colors: Vec<_> = targets.iter().map(|view| Some(clear(*view))).collect();
        let far = Some(wgpu::Operations { load: wgpu::LoadOp::Clear(0.0), store: wgpu::StoreOp::Store });
        let depth = |view| wgpu::RenderPassDepthStencilAttachment { view, depth_ops: far, stencil_ops: None };
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &colors,
            depth_stencil_attachment: depth_view.map(depth),
            ..Default::default()
        });
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.group, &[]);
        draws(&mut pass);
    }
}

/// Writes a PNG file beside its place and moves it there, so that nothing half written is ever seen.
fn save(path: &Path, pixels: &[u8]) -> Result<(), Box<dyn Error>> {
    let part = path.with_extension("part");
    let mut encoder = png::Encoder::new(std::fs::File::create(&part)?, SIZE[0], SIZE[1]);
    encoder.set_color(png::ColorType::Rgba);
    encoder.write_header()?.write_image_data(pixels)?;
    Ok(std::fs::rename(&part, path)?)
}
