//! A steady frame costs what the bare calls of wgpu cost: the same allocations, and no GPU object of ours.
//!
//! A binary of its own, because its allocator counts.

#[allow(dead_code, reason = "shared with the other tests")]
#[path = "gpu/gpu.rs"]
mod gpu;
#[allow(dead_code, reason = "shared with the other tests")]
#[path = "gpu/scenes.rs"]
mod scenes;

use allocation_counter::measure;
use bytemuck::Zeroable;
use gpu::Gpu;
use libtest_mimic::{Arguments, Failed, Trial};
use scenes::{Numbers, bouncing, view};
use sh_gpu::{Renderer, ShadowOptions, ShadowPass, records::Lighting};
use sh_scene::{Emitter, Forest, Limits, Node, Plan, Tiles};
use wgpu::{BindGroup, Buffer, CommandEncoder, ComputePipeline};

/// Frames before counting begins: memory that is kept has grown to its size by then, wgpu's as well.
const WARM: usize = 20;

/// Frames that are counted.
const FRAMES: usize = 10;

const RECEIVERS: usize = 1000;

fn main() {
    let required = std::env::var_os("GAUNT_REQUIRE_GPU").is_some_and(|value| value != "0");
    let missing = Gpu::new().err();
    let trials = TESTS.map(|(name, test)| {
        Trial::test(name, move || {
            let gpu = Gpu::new().map_err(Failed::from)?;
            test(&gpu);
            gpu.errors()
        })
        .with_ignored_flag(missing.is_some() && !required)
    });
    let arguments = Arguments {
        test_threads: Some(1),
        ..Arguments::from_args()
    };
    libtest_mimic::run(&arguments, trials.into()).exit();
}

/// A name and what it runs.
type Test = (&'static str, fn(&Gpu));

const TESTS: [Test; 2] = [
    (
        "a_pass_costs_what_its_calls_cost",
        a_pass_costs_what_its_calls_cost,
    ),
    (
        "preparing_costs_what_its_uploads_cost",
        preparing_costs_what_its_uploads_cost,
    ),
];

/// What a frame's calls cost.
#[derive(Debug, PartialEq)]
struct Cost {
    /// Allocations of `prepare` and `record`, over all frames that were counted.
    allocations: u64,
    /// Objects that these made, before anything was submitted. wgpu keeps what it uploads in buffers of its own.
    objects: Vec<(&'static str, isize)>,
}

/// The cost of frames that upload and record so.
fn cost(gpu: &Gpu, upload: impl Fn(), record: impl Fn(&mut CommandEncoder)) -> Cost {
    let mut cost = Cost {
        allocations: 0,
        objects: Vec::new(),
    };
    for frame in 0..WARM + FRAMES {
        let before = held(gpu);
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        let made = measure(|| {
            upload();
            record(&mut encoder);
        });
        let made_objects = held(gpu).into_iter().zip(before);
        let objects = made_objects.map(|((name, now), (_, then))| (name, now - then));
        if frame >= WARM {
            cost.allocations += made.count_total;
            cost.objects = objects.collect();
        }
        gpu.queue.submit([encoder.finish()]);
        gpu.device
            .poll(wgpu::PollType::wait_indefinitely())
            .unwrap();
    }
    cost
}

/// What the device holds of everything.
fn held(gpu: &Gpu) -> Vec<(&'static str, isize)> {
    let hub = gpu.instance.generate_report().unwrap().hub;
    [
        ("bind group layouts", hub.bind_group_layouts),
        ("bind groups", hub.bind_groups),
        ("buffers", hub.buffers),
        ("compute pipelines", hub.compute_pipelines),
        ("pipeline layouts", hub.pipeline_layouts),
        ("query sets", hub.query_sets),
        ("render pipelines", hub.render_pipelines),
        ("samplers", hub.samplers),
        ("shader modules", hub.shader_modules),
        ("texture views", hub.texture_views),
        ("textures", hub.textures),
    ]
    .map(|(name, report)| (name, report.num_allocated as isize))
    .into()
}

/// The shadow pass against a host that makes pipeline and bind groups of the same kernel itself, and makes the same
/// three uploads and the same dispatch.
fn a_pass_costs_what_its_calls_cost(gpu: &Gpu) {
    let mut numbers = Numbers(3);
    let spheres = numbers.spheres(50);
    let (light, forest) = (numbers.light(4), Forest::new(&spheres, &[50]));
    let receivers = gpu.buffer(&numbers.receivers(RECEIVERS));
    let radiance = gpu.room(RECEIVERS as u64 * 16);

    let options = ShadowOptions {
        max_blockers: 50,
        max_emitters: 0,
        ..ShadowOptions::default()
    };
    let pass = ShadowPass::new(&gpu.device, options).unwrap();
    let [input, output] = [&receivers, &radiance].map(|buffer| buffer.as_entire_buffer_binding());
    let bound = pass.bind(&gpu.device, input, output).unwrap();
    let ours = cost(
        gpu,
        || {
            pass.prepare(&gpu.queue, &forest, Limits::default(), &light)
                .unwrap()
        },
        |encoder| pass.record(encoder, &bound, None),
    );
    let found: Vec<[f32; 4]> = gpu.read(&radiance);

    let bare = Bare::new(gpu, &receivers, &radiance);
    let mut record = Lighting {
        nodes: forest.nodes().len() as u32,
        sin_max: Limits::default().sin_max,
        sin_min: Limits::default().sin_min,
        ..Lighting::zeroed()
    };
    for (slot, [r, g, b]) in record.coefficients.iter_mut().zip(&light.coefficients) {
        *slot = [*r, *g, *b, 0.0];
    }
    gpu.queue
        .write_buffer(&radiance, 0, &vec![0; RECEIVERS * 16]);
    let bare = cost(
        gpu,
        || {
            gpu.queue
                .write_buffer(&bare.lighting, 0, bytemuck::bytes_of(&record));
            gpu.queue
                .write_buffer(&bare.nodes, 0, bytemuck::cast_slice(forest.nodes()));
        },
        |encoder| bare.record(encoder),
    );
    let expected: Vec<[f32; 4]> = gpu.read(&radiance);
    assert_eq!(found, expected, "both compute the same");
    println!(
        "{FRAMES} frames of the shadow pass: {ours:?}\n{FRAMES} frames of bare wgpu: {bare:?}"
    );
    assert!(bare.allocations > 0, "the allocator counts");
    assert!(
        ours.allocations <= bare.allocations,
        "{ours:?}, but bare wgpu {bare:?}"
    );
    assert_eq!(ours.objects, bare.objects);
}

/// A host's own use of the kernel.
struct Bare {
    pipeline: ComputePipeline,
    groups: [BindGroup; 2],
    lighting: Buffer,
    nodes: Buffer,
}

impl Bare {
    fn new(gpu: &Gpu, receivers: &Buffer, radiance: &Buffer) -> Self {
        let source = sh_kernels::shadow(4, 4).unwrap();
        let module = gpu
            .device
            .create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some("bare"),
                source: wgpu::ShaderSource::Wgsl(source.into()),
            });
        let pipeline = gpu
            .device
            .create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                label: Some("bare"),
                layout: None,
                module: &module,
                entry_point: Some("shadow"),
                compilation_options: Default::default(),
                cache: None,
            });
        let lighting = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("bare"),
            size: size_of::<Lighting>() as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let emitters = gpu.room(size_of::<Emitter>() as u64);
        let nodes = gpu.room(100 * size_of::<Node>() as u64);
        let runs: Vec<[u32; 2]> = (0..RECEIVERS as u32)
            .step_by(Tiles::AREA)
            .map(|first| [first, Tiles::AREA as u32])
            .collect();
        let runs = gpu.buffer(&runs);
        // From where what is mirrored is seen: nothing is.
        let eye = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("bare"),
            size: 16,
            usage: wgpu::BufferUsages::UNIFORM,
            mapped_at_creation: false,
        });
        let group = |index: u32, buffers: &[&Buffer]| {
            let entries: Vec<_> = (0..)
                .zip(buffers)
                .map(|(binding, buffer)| wgpu::BindGroupEntry {
                    binding,
                    resource: buffer.as_entire_binding(),
                })
                .collect();
            gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("bare"),
                layout: &pipeline.get_bind_group_layout(index),
                entries: &entries,
            })
        };
        Self {
            groups: [
                group(0, &[&lighting, &emitters, &nodes, &eye]),
                group(1, &[receivers, &runs, radiance]),
            ],
            pipeline,
            lighting,
            nodes,
        }
    }

    fn record(&self, encoder: &mut CommandEncoder) {
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
            label: Some("bare"),
            timestamp_writes: None,
        });
        pass.push_debug_group("bare");
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.groups[0], &[]);
        pass.set_bind_group(1, &self.groups[1], &[]);
        pass.dispatch_workgroups(
            Tiles::AREA as u32 / 64,
            RECEIVERS.div_ceil(Tiles::AREA) as u32,
            1,
        );
        pass.pop_debug_group();
    }
}

/// A whole frame's `prepare`, of a scene that has every pass, against as many uploads of some bytes; and what recording
/// it makes.
fn preparing_costs_what_its_uploads_cost(gpu: &Gpu) {
    let scene = bouncing();
    let view = view(&scene, 40, 40);
    let renderer =
        Renderer::new(&gpu.device, &gpu.queue, &scene, &Plan::new(&scene), &view).unwrap();
    let (light, forest) = (Numbers(4).light(4), scene.forest());
    let prepare = || {
        renderer
            .prepare(&gpu.queue, &scene, &forest, &light, &view)
            .unwrap()
    };
    let ours = cost(gpu, prepare, |_| ());
    // Bands at both resolutions, bodies, light, blockers, members of bodies, senders.
    let buffers: Vec<Buffer> = (0..7).map(|_| gpu.room(256)).collect();
    let write = || {
        buffers
            .iter()
            .for_each(|buffer| gpu.queue.write_buffer(buffer, 0, &[0; 256]))
    };
    let bare = cost(gpu, write, |_| ());
    println!("{FRAMES} times prepare: {ours:?}\n{FRAMES} times seven uploads: {bare:?}");
    assert!(
        ours.allocations <= bare.allocations,
        "{ours:?}, but bare wgpu {bare:?}"
    );
    assert_eq!(ours.objects, bare.objects);

    let recorded = cost(gpu, || (), |encoder| renderer.record(encoder, None));
    println!("{FRAMES} times record: {recorded:?}");
    assert!(
        recorded.objects.iter().all(|(_, made)| *made == 0),
        "{recorded:?}"
    );
}
