//! Every generated routine on the GPU against the truth. Without an adapter the tests show as ignored, never
//! as passed; with `GAUNT_REQUIRE_GPU=1` a missing adapter is a failure.

use gaunt::gpu::Gpu;
use libtest_mimic::{Arguments, Failed, Trial};
use sh_codegen::emit::wgsl;
use sh_codegen::routines::{ORDERS, ROUTINES, Routine, Shape};
use sh_tests::accuracy::{Number, Table, error};
use sh_tests::promises::{LONGEST, Poison, Promise, enlarge, promised};
use sh_tests::{case, truth::truth};
use std::collections::HashMap;
use std::sync::{Arc, Mutex};
use wgpu::{BufferUsages, ComputePipeline};

const CASES: usize = 60;

/// Numbers of one case: all arguments one after the other.
fn stride(routine: &Routine, order: usize) -> usize {
    routine
        .arguments
        .iter()
        .map(|(_, shape)| shape.len(order))
        .sum()
}

/// A compute shader that calls the routine once an invocation, on flat arguments.
fn shader(routine: &Routine, order: usize) -> String {
    let mut offset = 0;
    let (mut reads, mut names) = (String::new(), Vec::new());
    for (i, (_, shape)) in routine.arguments.iter().enumerate() {
        let count = shape.len(order);
        let at = |k: usize| format!("arguments[first + {}u]", offset + k);
        let name = format!("argument_{}_", ["a", "b", "c", "d", "e"][i]);
        let value = match shape {
            Shape::Scalar => at(0),
            Shape::Direction => format!("vec3f({}, {}, {})", at(0), at(1), at(2)),
            Shape::Quaternion => format!("vec4f({}, {}, {}, {})", at(0), at(1), at(2), at(3)),
            _ => {
                reads += &format!(
                    "    var {name}: array<f32, {count}>;\n    for (var i = 0u; i < {count}u; i++) {{ {name}[i] = arguments[first + {offset}u + i]; }}\n"
                );
                name
            }
        };
        names.push(value);
        offset += count;
    }
    let results = routine.result.len(order);
    let call = format!("sh{order}_{}({})", routine.name, names.join(", "));
    let write = match routine.result {
        Shape::Scalar => format!("    results[id.x] = {call};\n"),
        _ => format!(
            "    var result = {call};\n    for (var i = 0u; i < {results}u; i++) {{ results[id.x * {results}u + i] = result[i]; }}\n"
        ),
    };
    format!(
        "{}\n@group(0) @binding(0) var<storage, read> arguments: array<f32>;\n\
         @group(0) @binding(1) var<storage, read_write> results: array<f32>;\n\
         @compute @workgroup_size(1)\nfn main(@builtin(global_invocation_id) id: vec3u) {{\n    let first = id.x * {offset}u;\n{reads}{write}}}\n",
        wgsl::function(routine, order)
    )
}

/// A device, and a pipeline for each routine and order that was run: compiling one takes longer than all else.
struct Bench {
    gpu: Gpu,
    pipelines: Mutex<HashMap<(&'static str, usize), ComputePipeline>>,
}

impl Bench {
    fn pipeline(&self, routine: &Routine, order: usize) -> ComputePipeline {
        let key = (routine.name, order);
        let known = self.pipelines.lock().unwrap().get(&key).cloned();
        known.unwrap_or_else(|| {
            let pipeline = self.compile(routine, order);
            let mut pipelines = self.pipelines.lock().unwrap();
            pipelines.insert(key, pipeline.clone());
            pipeline
        })
    }

    fn compile(&self, routine: &Routine, order: usize) -> ComputePipeline {
        let device = &self.gpu.device;
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(routine.name),
            source: wgpu::ShaderSource::Wgsl(shader(routine, order).into()),
        });
        device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(routine.name),
            layout: None,
            module: &module,
            entry_point: None,
            compilation_options: Default::default(),
            cache: None,
        })
    }
}

/// Runs the routine on all cases, one invocation each.
fn run(bench: &Bench, routine: &Routine, order: usize, arguments: &[f32]) -> Vec<f32> {
    let count = arguments.len() / stride(routine, order);
    let size = (count * routine.result.len(order) * 4) as u64;
    let (gpu, pipeline) = (&bench.gpu, bench.pipeline(routine, order));
    let buffer = |size, usage| {
        gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size,
            usage: BufferUsages::STORAGE | usage,
            mapped_at_creation: false,
        })
    };
    let input = buffer(arguments.len() as u64 * 4, BufferUsages::COPY_DST);
    let output = buffer(size, BufferUsages::COPY_SRC);
    let staging = gpu.staging(size);
    gpu.queue
        .write_buffer(&input, 0, bytemuck::cast_slice(arguments));
    let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout: &pipeline.get_bind_group_layout(0),
        entries: &[
            wgpu::BindGroupEntry {
                binding: 0,
                resource: input.as_entire_binding(),
            },
            wgpu::BindGroupEntry {
                binding: 1,
                resource: output.as_entire_binding(),
            },
        ],
    });
    gpu.submit(|encoder| {
        let mut pass = encoder.begin_compute_pass(&Default::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.dispatch_workgroups(count as u32, 1, 1);
        drop(pass);
        encoder.copy_buffer_to_buffer(&output, 0, &staging, 0, size);
    })
    .expect("the shader runs");
    gpu.read(&staging, bytemuck::pod_collect_to_vec)
        .expect("results come back")
}

/// All orders of one routine within what `accuracy.toml` permits.
fn check(bench: &Bench, routine: &Routine) -> Result<(), Failed> {
    let table = Table::load();
    let permitted = table.permitted(routine.name, Number::Gpu);
    let mut worst = 0.0_f64;
    for order in ORDERS {
        let mut random = case::Random::new(order as u64);
        let cases: Vec<Vec<Vec<f64>>> = (0..CASES)
            .map(|i| case::arguments(routine, order, &mut random, i))
            .map(|c| {
                c.into_iter()
                    .map(|a| a.into_iter().map(|x| f64::from(x as f32)).collect())
                    .collect()
            })
            .collect();
        let flat: Vec<f32> = cases
            .iter()
            .flatten()
            .flatten()
            .map(|x| *x as f32)
            .collect();
        let got = run(bench, routine, order, &flat);
        for (arguments, got) in cases.iter().zip(got.chunks(routine.result.len(order))) {
            let want = truth(routine.name, order, arguments).expect("every routine has a truth");
            let got: Vec<f64> = got.iter().map(|x| f64::from(*x)).collect();
            worst = worst.max(error(
                &got,
                &want,
                Number::Gpu,
                case::scale(routine, arguments),
            ));
        }
    }
    println!("{:16} {worst:6.2} of {permitted} units", routine.name);
    if worst > permitted {
        return Err(format!("{}: {worst:.1} units, {permitted} permitted", routine.name).into());
    }
    Ok(())
}

/// Vectors of zeros and denormals, and as large as the routine promises to take them: finite, and as accurate as
/// at any size, or within the routine's bound.
fn check_extremes(bench: &Bench, routine: &Routine) -> Result<(), Failed> {
    let permitted = Table::load().permitted(routine.name, Number::Gpu);
    let Promise {
        largest,
        accurate,
        poison,
        ..
    } = *promised(routine);
    for order in ORDERS {
        let mut random = case::Random::new(31);
        let mut cases: Vec<Vec<Vec<f32>>> = Vec::new();
        for i in 0..12 {
            let mut arguments: Vec<Vec<f32>> = case::arguments(routine, order, &mut random, i)
                .into_iter()
                .map(|a| a.into_iter().map(|x| x as f32).collect())
                .collect();
            let replaced = [0.0, -0.0, 1e-40].get(i);
            for (a, (_, shape)) in arguments.iter_mut().zip(routine.arguments) {
                if let (true, Some(value)) = (case::is_vector(*shape), replaced) {
                    a.fill(*value);
                }
            }
            if replaced.is_none() {
                let size = if i % 2 == 0 { largest } else { accurate };
                enlarge(routine, &mut arguments, size);
            }
            cases.push(arguments);
        }
        let flat: Vec<f32> = cases.iter().flatten().flatten().copied().collect();
        let got = run(bench, routine, order, &flat);
        for (arguments, got) in cases.iter().zip(got.chunks(routine.result.len(order))) {
            let wide: Vec<Vec<f64>> = arguments
                .iter()
                .map(|a| a.iter().copied().map(f64::from).collect())
                .collect();
            let got: Vec<f64> = got.iter().copied().map(f64::from).collect();
            // Denormals may be flushed to zero; what is added to, and an exponential, has a size of its own.
            let bounded = matches!(poison, Poison::Bounded(_));
            let least = match routine.name.starts_with("add_") || bounded {
                true => 1.0,
                false => 1e-30,
            };
            let most = if bounded { LONGEST } else { f64::INFINITY };
            let scale = case::scale(routine, &wide).clamp(least, most);
            let size = wide
                .iter()
                .flatten()
                .fold(0.0, |most: f64, x| most.max(x.abs()));
            let is_accurate = || {
                let want = truth(routine.name, order, &wide).expect("a truth");
                error(&got, &want, Number::Gpu, scale) <= permitted
            };
            let holds = match poison {
                Poison::Bounded(bound) => {
                    let within = got.iter().map(|x| x * x).sum::<f64>().sqrt() <= bound;
                    within && (size > f64::from(accurate).max(2.0) || is_accurate())
                }
                Poison::Shows => is_accurate(),
            };
            if !holds {
                return Err(format!("order {order}: {got:?} of {arguments:?}").into());
            }
        }
    }
    Ok(())
}

fn main() {
    let arguments = Arguments::from_args();
    let required = std::env::var_os("GAUNT_REQUIRE_GPU").is_some_and(|value| value != "0");
    // A device compiles one pipeline at a time, so there are two; both checks of a routine are on the same.
    let open = || match Gpu::open() {
        Ok(gpu) => Ok(Arc::new(Bench {
            gpu,
            pipelines: Mutex::default(),
        })),
        Err(error) => Err(error.to_string()),
    };
    let benches = [open(), open()];
    type Check = fn(&Bench, &Routine) -> Result<(), Failed>;
    let checks: [(&str, Check); 2] = [("", check), ("hard_cases::", check_extremes)];
    let trials = checks.iter().flat_map(|&(prefix, check)| {
        let benches = benches.iter().cycle();
        ROUTINES.iter().zip(benches).map(move |(routine, bench)| {
            let bench = bench.clone();
            let missing = bench.is_err();
            Trial::test(format!("{prefix}{}", routine.name), move || {
                let bench = bench?;
                check(&bench, routine)
            })
            .with_ignored_flag(missing && !required)
        })
    });
    libtest_mimic::run(&arguments, trials.collect()).exit();
}
