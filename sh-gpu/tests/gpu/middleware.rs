//! The passes in other people's renderers: their vertices and G-buffers, small devices, shared pipelines.

use crate::gpu::Gpu;
use crate::scenes::{Numbers, lamps};
use crate::shading::shadow;
use glam::camera::rh::{proj::directx::perspective_infinite_reverse, view::look_at_mat4};
use glam::{Affine3A, Mat3, Quat, Vec3};
use sh_core::Sh4;
use sh_gpu::{
    Bound, Error, IrradiancePass, LightGatherPass, Output, Pipelines, Position, ScreenCamera,
    ScreenPart, ScreenPass, ScreenTextures, ShadowOptions, ShadowPass, VertexLayout, VertexPass,
};
use sh_scene::{Blocking, Light, Receiver, Sphere, Tiles};
use wgpu::util::{DeviceExt, TextureDataOrder};
use wgpu::{BufferUsages, TextureFormat, TextureUsages, TextureView};

/// The light itself, dotted with the cosine lobe of a receiver's normal, is what the shadow pass says it reflects,
/// before that is bounded.
pub fn shadowed_light_is_what_the_lobe_meets(gpu: &Gpu) {
    let mut numbers = Numbers(77);
    let receivers = numbers.receivers(300);
    let covered = receivers.iter().filter(|r| r.covered == 1).count();
    let sky = numbers.light(4);
    let hidden = both(gpu, &receivers, &numbers.spheres(40), &sky);
    // Each has an exponential of its own: one is fitted to the visibility, the other to what is reflected.
    let most = hidden.iter().map(|[_, b]| *b).fold(0.0, f32::max);
    let near = 0.15 * most;
    let alike = |of: &[[f32; 2]]| of.iter().filter(|[a, b]| (a - b).abs() < near).count();
    assert_eq!(hidden.len(), covered * 3);
    assert!(
        alike(&hidden) > hidden.len() * 9 / 10,
        "{} of {}",
        alike(&hidden),
        hidden.len()
    );
    // Of lamps, what comes from behind is bounded by 0.
    let open = both(
        gpu,
        &receivers,
        &[],
        &sky.clone().with_lights(&lamps()).unwrap(),
    );
    assert!(open.iter().all(|[light, radiance]| light - radiance < near));
    assert!(
        alike(&open) > open.len() / 4,
        "{} of {}",
        alike(&open),
        open.len()
    );
    let without = both(gpu, &receivers, &[], &sky);
    assert!(alike(&without) == without.len());
    let brighter = open.iter().zip(&without).filter(|(a, b)| a[0] > b[0] + 0.1);
    assert!(brighter.count() > open.len() / 4);
}

/// For every channel of every receiver that is covered: the light dotted with the lobe, and the radiance.
fn both(gpu: &Gpu, receivers: &[Receiver], spheres: &[Sphere], light: &Light) -> Vec<[f32; 2]> {
    let order = light.order;
    let run = |output: Output| -> Vec<[f32; 4]> {
        let options = ShadowOptions {
            order,
            accumulation: order,
            max_blockers: 40,
            max_emitters: 2,
            distributions: true,
            output,
        };
        let pass = ShadowPass::new(&gpu.device, options).unwrap();
        let size = receivers.len() as u64 * output.elements(order) * 16;
        let (input, output) = (gpu.buffer(receivers), gpu.room(size));
        let [input, binding] = [&input, &output].map(|buffer| buffer.as_entire_buffer_binding());
        let bound = pass.bind(&gpu.device, input, binding).unwrap();
        pass.prepare_spheres(&gpu.queue, spheres, light).unwrap();
        gpu.submit(|encoder| pass.record(encoder, &bound, None));
        gpu.read(&output)
    };
    let (vectors, radiance) = (run(Output::Light), run(Output::Radiance));
    let vectors = vectors.chunks_exact(order * order);
    let mut pairs = Vec::new();
    for ((receiver, vector), radiance) in receivers.iter().zip(vectors).zip(&radiance) {
        if receiver.covered == 0 {
            assert!(vector.iter().all(|value| *value == [0.0; 4]));
            continue;
        }
        let lobe = Sh4::cosine(receiver.normal).0;
        for c in 0..3 {
            let dot = vector.iter().zip(&lobe).map(|(v, l)| v[c] * l).sum();
            pairs.push([dot, radiance[c]]);
        }
    }
    pairs
}

/// Interleaved vertices that begin anywhere, and streams apart, under any matrix.
pub fn vertices_are_receivers(gpu: &Gpu) {
    let mut numbers = Numbers(5);
    let count = 130;
    let points: Vec<[Vec3; 2]> = (0..count)
        .map(|_| [numbers.vector(), numbers.vector() * 3.0])
        .collect();
    let turn = Mat3::from_quat(Quat::from_rotation_y(0.7))
        * Mat3::from_diagonal(Vec3::new(2.0, 0.5, -1.0));
    let world = Affine3A::from_mat3_translation(turn, Vec3::new(3.0, -1.0, 2.0));
    let normals = turn.inverse().transpose();
    let mut interleaved = vec![9.0_f32; 5];
    for [position, normal] in &points {
        interleaved.extend(position.to_array());
        interleaved.extend([0.25; 2]);
        interleaved.extend(normal.to_array());
    }
    let apart: Vec<f32> = (0..2)
        .flat_map(|k| points.iter().flat_map(move |point| point[k].to_array()))
        .collect();
    let layouts = [
        (
            interleaved,
            VertexLayout {
                first: 20,
                stride: 32,
                normal: 20,
            },
        ),
        (
            apart,
            VertexLayout {
                first: 0,
                stride: 12,
                normal: count * 12,
            },
        ),
    ];
    let pass = VertexPass::new(&gpu.device).unwrap();
    for (words, layout) in layouts {
        let vertices = gpu
            .device
            .create_buffer_init(&wgpu::util::BufferInitDescriptor {
                label: Some("tests"),
                contents: bytemuck::cast_slice(&words),
                usage: BufferUsages::VERTEX | BufferUsages::STORAGE,
            });
        let output = gpu.room(u64::from(count) * 32);
        let [input, receivers] =
            [&vertices, &output].map(|buffer| buffer.as_entire_buffer_binding());
        let bound = pass
            .bind(&gpu.device, layout, input.clone(), receivers.clone())
            .unwrap();
        pass.prepare(&gpu.queue, &bound, world, 7);
        gpu.submit(|encoder| pass.record(encoder, &bound, None));
        for (found, [position, normal]) in gpu.read::<Receiver>(&output).iter().zip(&points) {
            let away = Vec3::from(found.position).distance(world.transform_point3(*position));
            let turned = Vec3::from(found.normal).distance((normals * *normal).normalize());
            assert!(away < 1e-5 && turned < 1e-5, "{found:?}");
            assert_eq!((found.covered, found.object), (1, 7));
        }
        let short = VertexLayout {
            normal: layout.normal + 4,
            ..layout
        };
        let error = pass
            .bind(&gpu.device, short, input.clone(), receivers.clone())
            .unwrap_err();
        assert!(matches!(error, Error::Vertices(_)), "{error}");
        let odd = VertexLayout {
            stride: 13,
            ..layout
        };
        let error = pass.bind(&gpu.device, odd, input, receivers).unwrap_err();
        assert!(
            error
                .to_string()
                .contains("stride is 13, which has to be a multiple of 4"),
            "{error}"
        );
    }
}

const SIZE: [u32; 2] = [37, 50];

fn texture(
    gpu: &Gpu,
    format: TextureFormat,
    usage: TextureUsages,
    bytes: Option<&[u8]>,
) -> TextureView {
    let descriptor = wgpu::TextureDescriptor {
        label: Some("tests"),
        size: wgpu::Extent3d {
            width: SIZE[0],
            height: SIZE[1],
            depth_or_array_layers: 1,
        },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    };
    let texture = match bytes {
        Some(bytes) => gpu.device.create_texture_with_data(
            &gpu.queue,
            &descriptor,
            TextureDataOrder::LayerMajor,
            bytes,
        ),
        None => gpu.device.create_texture(&descriptor),
    };
    texture.create_view(&Default::default())
}

/// The texels of a `Rgba16Float` texture.
fn halves(gpu: &Gpu, view: &TextureView) -> Vec<[f32; 4]> {
    let across = u64::from(SIZE[0] * 8).next_multiple_of(256);
    let copy = gpu.room(across * u64::from(SIZE[1]));
    gpu.submit(|encoder| {
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(across as u32),
            rows_per_image: None,
        };
        let target = wgpu::TexelCopyBufferInfo {
            buffer: &copy,
            layout,
        };
        encoder.copy_texture_to_buffer(
            view.texture().as_image_copy(),
            target,
            view.texture().size(),
        );
    });
    let rows: Vec<[u16; 4]> = gpu.read(&copy);
    let row = |y: u32| &rows[(across / 8 * u64::from(y)) as usize..][..SIZE[0] as usize];
    let value = |bits: u16| {
        let (exponent, mantissa) = (i32::from(bits >> 10 & 31), f32::from(bits & 1023));
        match exponent {
            0 => mantissa * 2.0_f32.powi(-24),
            _ => (1.0 + mantissa / 1024.0) * 2.0_f32.powi(exponent - 15),
        }
    };
    (0..SIZE[1])
        .flat_map(row)
        .map(|texel| texel.map(value))
        .collect()
}

/// A G-buffer of positions, on a device whose bindings hold two rows of tiles: it is lit in parts, each pixel as the
/// shadow pass alone lights it.
pub fn screens_are_lit_in_parts(_: &Gpu) {
    let gpu = &Gpu::with(wgpu::Limits {
        max_storage_buffer_binding_size: 3 * Tiles::AREA as u64 * 32 * 2,
        ..wgpu::Limits::default()
    })
    .unwrap();
    let mut numbers = Numbers(31);
    let all = (SIZE[0] * SIZE[1]) as usize;
    let receivers = numbers.receivers(all);
    let (spheres, light) = (numbers.spheres(20), numbers.light(4));
    let positions: Vec<[f32; 4]> = receivers
        .iter()
        .map(|r| {
            [
                r.position[0],
                r.position[1],
                r.position[2],
                r.covered as f32,
            ]
        })
        .collect();
    let normals: Vec<[f32; 4]> = receivers
        .iter()
        .map(|r| {
            [
                r.normal[0] * 0.5 + 0.5,
                r.normal[1] * 0.5 + 0.5,
                r.normal[2] * 0.5 + 0.5,
                0.0,
            ]
        })
        .collect();
    let (float, read) = (TextureFormat::Rgba32Float, TextureUsages::TEXTURE_BINDING);
    let position = texture(gpu, float, read, Some(bytemuck::cast_slice(&positions)));
    let normal = texture(gpu, float, read, Some(bytemuck::cast_slice(&normals)));
    let usage = TextureUsages::STORAGE_BINDING | TextureUsages::COPY_SRC;
    let radiance = texture(gpu, ScreenPass::RADIANCE, usage, None);
    let pipelines = Pipelines::new(&gpu.device);
    let textures = ScreenTextures {
        position: Position::Texture(&position),
        normal: &normal,
        radiance: &radiance,
    };
    let screen = ScreenPass::with(&pipelines, textures).unwrap();
    let options = ShadowOptions {
        max_blockers: 20,
        max_emitters: 0,
        ..ShadowOptions::default()
    };
    let shadow = ShadowPass::with(&pipelines, options).unwrap();
    let bind = |part: ScreenPart| shadow.bind(&gpu.device, part.receivers, part.radiance);
    let lit: Bound = screen.parts().map(bind).collect::<Result<_, _>>().unwrap();
    // 50 rows of pixels are four of tiles.
    assert_eq!((screen.parts().count(), lit.dispatches()), (2, 2));
    assert_eq!(screen.bytes(), 2 * 256 + 3 * 4 * 256 * 48);
    let camera = ScreenCamera {
        normal_scale: 2.0,
        normal_bias: -1.0,
        ..ScreenCamera::default()
    };
    screen.prepare(&gpu.queue, &camera);
    shadow
        .prepare_spheres(&gpu.queue, &spheres, &light)
        .unwrap();
    gpu.submit(|encoder| {
        screen.record_receivers(encoder, None);
        shadow.record(encoder, &lit, None);
        screen.record_radiance(encoder, None);
    });
    let found = halves(gpu, &radiance);
    let alone = crate::shading::shadow(gpu, &receivers, &spheres, &light);
    assert!(alone.iter().any(|value| value[0] > 0.5));
    for (found, alone) in found.iter().zip(&alone) {
        for c in 0..4 {
            // Half precision, and normals that went through a texture.
            assert!(
                (found[c] - alone[c]).abs() < 2e-3 * alone[c].max(0.1),
                "{found:?}, not {alone:?}"
            );
        }
    }

    let target = texture(gpu, ScreenPass::RADIANCE, TextureUsages::COPY_SRC, None);
    let error = ScreenPass::new(
        &gpu.device,
        ScreenTextures {
            radiance: &target,
            ..textures
        },
    )
    .unwrap_err();
    assert!(
        error.to_string().contains("`radiance` needs the usage"),
        "{error}"
    );
    let target = texture(gpu, float, TextureUsages::STORAGE_BINDING, None);
    let error = ScreenPass::new(
        &gpu.device,
        ScreenTextures {
            radiance: &target,
            ..textures
        },
    )
    .unwrap_err();
    assert!(
        error.to_string().contains("Rgba16Float is needed"),
        "{error}"
    );
    gpu.errors().unwrap();
}

/// Positions by way of the depth buffer, where they are along the pixels' rays.
pub fn depth_leads_back_to_the_world(gpu: &Gpu) {
    let usage = TextureUsages::TEXTURE_BINDING | TextureUsages::RENDER_ATTACHMENT;
    let depth = texture(gpu, TextureFormat::Depth32Float, usage, None);
    let up: Vec<[i8; 4]> = vec![[0, 127, 0, 0]; (SIZE[0] * SIZE[1]) as usize];
    let read = TextureUsages::TEXTURE_BINDING;
    let normal = texture(
        gpu,
        TextureFormat::Rgba8Snorm,
        read,
        Some(bytemuck::cast_slice(&up)),
    );
    let radiance = texture(
        gpu,
        ScreenPass::RADIANCE,
        TextureUsages::STORAGE_BINDING,
        None,
    );
    let textures = ScreenTextures {
        position: Position::Depth(&depth),
        normal: &normal,
        radiance: &radiance,
    };
    let screen = ScreenPass::new(&gpu.device, textures).unwrap();
    let eye = Vec3::new(1.0, 2.0, 3.0);
    let view = look_at_mat4(eye, Vec3::ZERO, Vec3::Y);
    let aspect = SIZE[0] as f32 / SIZE[1] as f32;
    let clip = perspective_infinite_reverse(1.0, aspect, 0.1) * view;
    for (value, covered) in [(0.02_f32, 1), (0.0, 0)] {
        let camera = ScreenCamera {
            world_from_clip: clip.inverse(),
            ..ScreenCamera::default()
        };
        screen.prepare(&gpu.queue, &camera);
        let copy = gpu.room(3 * 4 * 256 * 32);
        gpu.submit(|encoder| {
            encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                    view: &depth,
                    depth_ops: Some(wgpu::Operations {
                        load: wgpu::LoadOp::Clear(value),
                        store: wgpu::StoreOp::Store,
                    }),
                    stencil_ops: None,
                }),
                ..Default::default()
            });
            screen.record_receivers(encoder, None);
            let receivers = screen.parts().next().unwrap().receivers.buffer;
            encoder.copy_buffer_to_buffer(receivers, 0, &copy, 0, copy.size());
        });
        let found: Vec<Receiver> = gpu.read(&copy);
        assert_eq!(
            found.iter().filter(|r| r.covered == 1).count(),
            covered * (SIZE[0] * SIZE[1]) as usize
        );
        if covered == 1 {
            // The second pixel of the second row of the tile beside the first, 17 across and 1 down.
            let receiver = found[256 + 17];
            let at = clip * Vec3::from(receiver.position).extend(1.0);
            let pixel = [
                (at.x / at.w + 1.0) * 0.5 * SIZE[0] as f32,
                (1.0 - at.y / at.w) * 0.5 * SIZE[1] as f32,
            ];
            assert!(
                (pixel[0] - 17.5).abs() < 1e-3 && (pixel[1] - 1.5).abs() < 1e-3,
                "{pixel:?}"
            );
            assert!((0.1 / at.w - value).abs() < 1e-5, "{receiver:?}");
            assert_eq!(receiver.normal, [0.0, 1.0, 0.0]);
        }
    }
}

/// What is too large for a binding is lit part by part, to the same bits.
pub fn parts_leave_no_seam(gpu: &Gpu) {
    let small = Gpu::with(wgpu::Limits {
        max_storage_buffer_binding_size: 1 << 16,
        ..wgpu::Limits::default()
    })
    .unwrap();
    let mut numbers = Numbers(12);
    let receivers = numbers.receivers(5000);
    let (spheres, light) = (numbers.spheres(30), numbers.light(3));
    let whole = shadow(gpu, &receivers, &spheres, &light);
    assert_eq!(whole, shadow(&small, &receivers, &spheres, &light));

    let options = ShadowOptions {
        order: 3,
        accumulation: 3,
        max_blockers: 30,
        max_emitters: 1,
        distributions: true,
        output: Output::Light,
    };
    let pass = ShadowPass::new(&small.device, options).unwrap();
    let (input, output) = (small.buffer(&receivers), small.room(5000 * 16 * 9));
    let [input, output] = [&input, &output].map(|buffer| buffer.as_entire_buffer_binding());
    // 65536 bytes are 455 vectors of nine, of which 256 are whole tiles.
    assert_eq!(
        pass.bind(&small.device, input.clone(), output.clone())
            .unwrap()
            .dispatches(),
        20
    );
    let irradiance = IrradiancePass::new(&small.device, 3, 0).unwrap();
    assert_eq!(
        irradiance
            .bind(&small.device, input, output)
            .unwrap()
            .dispatches(),
        3
    );
    small.errors().unwrap();
}

/// Devices with less than WebGPU's defaults are told so, or are served.
pub fn small_devices_are_told(_: &Gpu) {
    let older = Gpu::with(wgpu::Limits::downlevel_defaults()).unwrap();
    // Three storage buffers of the four that there are.
    IrradiancePass::new(&older.device, 4, 1).unwrap();
    let refused = |result: Result<ShadowPass, Error>, sentence: &str| {
        let error = result.expect_err("this has to be refused");
        assert_eq!(error.to_string(), sentence);
    };
    refused(
        ShadowPass::new(&older.device, ShadowOptions::default()),
        "the number of storage buffers needs 5, but the device's limit `max_storage_buffers_per_shader_stage` is 4",
    );
    older.errors().unwrap();
    let web = Gpu::with(wgpu::Limits::downlevel_webgl2_defaults()).unwrap();
    let error = IrradiancePass::new(&web.device, 4, 1).unwrap_err();
    assert!(
        matches!(error, Error::Limit { available: 0, .. }),
        "{error}"
    );
    web.errors().unwrap();
}

/// A specialisation is compiled once, however many passes ask for it.
pub fn pipelines_are_shared(gpu: &Gpu) {
    let pipelines = Pipelines::new(&gpu.device);
    let made = || (pipelines.shader_modules(), pipelines.count());
    let options = ShadowOptions {
        order: 2,
        accumulation: 2,
        max_blockers: 9,
        ..ShadowOptions::default()
    };
    let shadow = ShadowPass::with(&pipelines, options).unwrap();
    assert_eq!(made(), (1, 1));
    ShadowPass::with(
        &pipelines,
        ShadowOptions {
            max_blockers: 5,
            ..options
        },
    )
    .unwrap();
    assert_eq!(made(), (1, 1), "another size is no other specialisation");
    ShadowPass::with(
        &pipelines,
        ShadowOptions {
            accumulation: 3,
            ..options
        },
    )
    .unwrap();
    ShadowPass::with(
        &pipelines,
        ShadowOptions {
            output: Output::Light,
            ..options
        },
    )
    .unwrap();
    assert_eq!(made(), (3, 3));
    LightGatherPass::new(&gpu.device, &shadow, Blocking::Discs).unwrap();
    LightGatherPass::new(&gpu.device, &shadow, Blocking::Runs).unwrap();
    LightGatherPass::new(&gpu.device, &shadow, Blocking::Object).unwrap();
    assert_eq!(made(), (4, 6), "three methods of one module");
    // 96 bytes a blocker; a record, an eye, and 16 emitters.
    assert_eq!(shadow.bytes(), 9 * 96 + 592 + 16 + 16 * 640);
}
