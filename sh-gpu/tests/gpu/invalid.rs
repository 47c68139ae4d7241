//! Samples that are no numbers, infinite or negative are counted on the GPU as on the CPU, whatever its compiler takes for
//! granted of numbers.

use crate::gpu::Gpu;
use crate::scenes::{standing_quad, view};
use bytemuck::Zeroable;
use glam::Vec3;
use sh_cpu::{Gbuffer, invalid};
use sh_gpu::records::Band;
use sh_gpu::{Bands, Renderer};
use sh_kernels::{MIN_ORDER, Pass, WORKGROUP, source};
use sh_scene::passes::INVALID_SAMPLES;
use sh_scene::{AreaLight, Camera, Plan, Receiver, Scene, View};
use wgpu::{BindGroup, BindGroupEntry, Buffer, BufferUsages, ComputePipeline};

/// What a channel may be, with its bits as they are.
const CHANNELS: [f32; 11] = [
    0.0,
    -0.0,
    1.0,
    f32::MAX,
    f32::MIN_POSITIVE / 2.0,
    -1.0,
    -1e-45,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::NAN,
    -f32::NAN,
];

pub fn counts_are_those_of_the_cpu(gpu: &Gpu) {
    let view = View {
        camera: Camera {
            eye: Vec3::Z,
            target: Vec3::ZERO,
            fov: 1.0,
        },
        width: 41,
        height: 25,
    };
    let tiles = view.samples().tiles();
    // Every triple of channels comes up.
    assert!(tiles.len() > CHANNELS.len().pow(3));
    let channel = |i: usize, step: usize| CHANNELS[i / step % CHANNELS.len()];
    let radiance: Vec<[f32; 3]> = (0..tiles.len())
        .map(|i| [channel(i, 1), channel(i, 11), channel(i, 121)])
        .collect();
    let receivers: Vec<Receiver> = (0..tiles.len())
        .map(|i| Receiver {
            covered: u32::from(i % 13 != 5),
            ..Receiver::zeroed()
        })
        .collect();
    let pixels = view.width as usize * view.height as usize;
    let mut expected = vec![[0; 4]; pixels];
    let samples = Gbuffer {
        albedo: Vec::new(),
        receivers,
    };
    invalid(&view, 0..tiles.rows, &samples, &radiance, &mut expected).unwrap();

    let padded: Vec<[f32; 4]> = radiance.iter().map(|&[r, g, b]| [r, g, b, -1.0]).collect();
    let band = Band {
        columns: view.samples().columns,
        ..Band::zeroed()
    };
    let record = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("tests"),
        size: size_of::<Band>() as u64,
        usage: BufferUsages::UNIFORM | BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    gpu.queue
        .write_buffer(&record, 0, bytemuck::bytes_of(&band));
    let counts = gpu.room(pixels as u64 * 16);
    let (receivers, radiance) = (gpu.buffer(&samples.receivers), gpu.buffer(&padded));
    let pipeline = pipeline(gpu);
    let groups = [
        group(gpu, &pipeline, 0, &[&record]),
        group(gpu, &pipeline, 1, &[&receivers, &radiance, &counts]),
    ];
    gpu.submit(|encoder| {
        let mut pass = encoder.begin_compute_pass(&Default::default());
        pass.set_pipeline(&pipeline);
        for (index, group) in (0..).zip(&groups) {
            pass.set_bind_group(index, group, &[]);
        }
        pass.dispatch_workgroups((pixels as u32).div_ceil(WORKGROUP), 1, 1);
    });
    let found: Vec<[u32; 4]> = gpu.read(&counts);
    assert_eq!(found, expected);
    // All of them come up.
    let sums = (0..4).map(|what| expected.iter().map(|count| count[what]).sum::<u32>());
    assert!(sums.min() > Some(100));
}

fn pipeline(gpu: &Gpu) -> ComputePipeline {
    let text = source(Pass::Invalid, MIN_ORDER).unwrap();
    let module = gpu
        .device
        .create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("tests"),
            source: wgpu::ShaderSource::Wgsl(text.into()),
        });
    gpu.device
        .create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some("tests"),
            layout: None,
            module: &module,
            entry_point: Some("invalid"),
            compilation_options: Default::default(),
            cache: None,
        })
}

fn group(gpu: &Gpu, pipeline: &ComputePipeline, index: u32, buffers: &[&Buffer]) -> BindGroup {
    let entries = (0..).zip(buffers).map(|(binding, buffer)| BindGroupEntry {
        binding,
        resource: buffer.as_entire_binding(),
    });
    gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("tests"),
        layout: &pipeline.get_bind_group_layout(index),
        entries: &entries.collect::<Vec<_>>(),
    })
}

/// A frame counts what it is asked to count, and nothing otherwise: none in an ordinary scene, and some where two lamps are
/// together brighter than single precision holds.
pub fn a_frame_counts_where_somebody_asks(gpu: &Gpu) {
    let mut scene = standing_quad();
    scene.settings.shadows = false;
    let plan = Plan::giving(&scene, &[INVALID_SAMPLES]);
    let view = view(&scene, 40, 30);
    let seen = sh_cpu::render(&scene, &plan, (40, 30), &|_| {}).unwrap();
    let expected = &seen.given[&INVALID_SAMPLES];
    let rendered = |scene: &Scene, plan: &Plan| {
        let bands = Bands::MAX_SAMPLES;
        let (pipelines, queue) = (&gpu.pipelines, &gpu.queue);
        let made = Renderer::with_pipelines(pipelines, queue, scene, plan, &view, bands);
        let (renderer, light) = (made.unwrap(), scene.light().unwrap());
        let prepared = renderer.prepare(queue, scene, &scene.forest(), &light, &view);
        prepared.unwrap();
        gpu.submit(|encoder| renderer.record(encoder, None));
        let given = renderer.given(INVALID_SAMPLES);
        given.map(|counts| gpu.read::<[u32; 4]>(counts))
    };
    assert_eq!(rendered(&scene, &Plan::new(&scene)), None);
    assert_eq!(rendered(&scene, &plan).as_ref(), Some(expected));

    let lamp = AreaLight::distant(Vec3::Y, 1.5, [3e38; 3]);
    scene.lights = vec![lamp, lamp];
    let plan = Plan::giving(&scene, &[INVALID_SAMPLES]);
    let counts = rendered(&scene, &plan).unwrap();
    let invalid = counts.iter().map(|[nan, infinite, ..]| nan + infinite);
    let covered = expected.iter().map(|count| count[3]).sum::<u32>();
    assert!(invalid.sum::<u32>() > covered / 4);
}
