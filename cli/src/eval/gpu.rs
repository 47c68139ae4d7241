//! Requests on the GPU: the generated WGSL library with one small entry point a routine.

use super::{CapLog, Op, Request};
use crate::Error;
use crate::exponential::Exponential;
use crate::gpu::Gpu;
use sh_codegen::routines::{Shape, find};
use sh_codegen::sampled::Fineness;
use sh_core::cap::Fit;
use std::collections::HashMap;
use wgpu::{BindGroup, BindGroupLayout, Buffer, BufferUsages, ComputePipeline, ShaderModule};

/// Numbers that the largest request brings: three vectors of order 6.
const MOST_ARGUMENTS: u64 = 3 * 36 + 1;

/// Numbers of the largest answer.
const MOST_RESULTS: u64 = 36;

/// The functions of the library that requests can call: names of routines, and the exponentials that are none.
const FUNCTIONS: [&str; 19] = [
    "basis",
    "cosine",
    "product",
    "square",
    "triple",
    "rotate",
    "zonal",
    "cap_visibility",
    "cap_log",
    "cap_log_saturating",
    "window",
    "exp_saturating",
    "exp_sampled_coarse",
    "exp_sampled",
    "exp_sampled_fine",
    "exp_product_series",
    "exp_ps_star",
    "exp_hyb",
    "exp_optimal_linear",
];

/// Evaluates requests on a GPU, one at a time. Shaders are compiled when they are first needed.
pub struct Evaluator {
    gpu: Gpu,
    layout: BindGroupLayout,
    arguments: Buffer,
    results: Buffer,
    staging: Buffer,
    group: BindGroup,
    modules: HashMap<usize, ShaderModule>,
    pipelines: HashMap<(usize, &'static str), ComputePipeline>,
}

impl Evaluator {
    /// On the best adapter there is, hardware or software.
    pub fn new() -> Result<Self, Error> {
        let gpu = Gpu::open()?;
        let buffer = |label, count: u64, usage| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: count * 4,
                usage: BufferUsages::STORAGE | usage,
                mapped_at_creation: false,
            })
        };
        let arguments = buffer(
            "gaunt eval arguments",
            MOST_ARGUMENTS,
            BufferUsages::COPY_DST,
        );
        let results = buffer("gaunt eval results", MOST_RESULTS, BufferUsages::COPY_SRC);
        let entry = |binding, read_only| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::COMPUTE,
            ty: wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Storage { read_only },
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        };
        let layout = gpu
            .device
            .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: Some("gaunt eval"),
                entries: &[entry(0, true), entry(1, false)],
            });
        let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("gaunt eval"),
            layout: &layout,
            entries: &[
                wgpu::BindGroupEntry {
                    binding: 0,
                    resource: arguments.as_entire_binding(),
                },
                wgpu::BindGroupEntry {
                    binding: 1,
                    resource: results.as_entire_binding(),
                },
            ],
        });
        let staging = gpu.staging(MOST_RESULTS * 4);
        let (modules, pipelines) = (HashMap::new(), HashMap::new());
        Ok(Self {
            gpu,
            layout,
            arguments,
            results,
            staging,
            group,
            modules,
            pipelines,
        })
    }

    /// The name of the adapter.
    pub fn adapter(&self) -> &str {
        &self.gpu.name
    }

    /// Computes a request. The error is a sentence.
    pub fn evaluate(&mut self, request: &Request) -> Result<Vec<f64>, String> {
        let (function, arguments) = call(&request.op)?;
        self.run(request.order, function, &arguments)
            .map_err(|error| error.to_string())
    }

    fn run(
        &mut self,
        order: usize,
        function: &'static str,
        arguments: &[f64],
    ) -> Result<Vec<f64>, Error> {
        self.compile(order, function)?;
        let (_, result) = signature(function);
        let count = result.len(order);
        let bytes: Vec<u8> = arguments
            .iter()
            .flat_map(|x| (*x as f32).to_ne_bytes())
            .collect();
        self.gpu.queue.write_buffer(&self.arguments, 0, &bytes);
        self.gpu.submit(|encoder| {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            pass.set_pipeline(&self.pipelines[&(order, function)]);
            pass.set_bind_group(0, &self.group, &[]);
            pass.dispatch_workgroups(1, 1, 1);
            drop(pass);
            encoder.copy_buffer_to_buffer(&self.results, 0, &self.staging, 0, MOST_RESULTS * 4);
        })?;
        self.gpu.read(&self.staging, |bytes| {
            let numbers = bytes
                .as_chunks::<4>()
                .0
                .iter()
                .map(|b| f64::from(f32::from_ne_bytes(*b)));
            numbers.take(count).collect()
        })
    }

    fn compile(&mut self, order: usize, function: &'static str) -> Result<(), Error> {
        if self.pipelines.contains_key(&(order, function)) {
            return Ok(());
        }
        let device = &self.gpu.device;
        let module = self.modules.entry(order).or_insert_with(|| {
            device.create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some("gaunt eval"),
                source: wgpu::ShaderSource::Wgsl(source(order).into()),
            })
        });
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("gaunt eval"),
            bind_group_layouts: &[Some(&self.layout)],
            immediate_size: 0,
        });
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(function),
            layout: Some(&layout),
            module,
            entry_point: Some(&entry_point(function)),
            compilation_options: Default::default(),
            cache: None,
        });
        self.gpu.check()?;
        self.pipelines.insert((order, function), pipeline);
        Ok(())
    }
}

/// Which function computes an operation, and its arguments, one after the other.
fn call(op: &Op) -> Result<(&'static str, Vec<f64>), String> {
    let only = |what: &str| Err(format!("{what} has no WGSL: use the backend f64 or f32"));
    Ok(match op {
        Op::Basis(dir) => ("basis", dir.to_vec()),
        Op::Cosine(dir) => ("cosine", dir.to_vec()),
        Op::Product(f, g) => ("product", [f.as_slice(), g].concat()),
        Op::Square(f) => ("square", f.clone()),
        Op::Triple(f, g, h) => ("triple", [f.as_slice(), g, h].concat()),
        Op::Rotate(f, quat) => ("rotate", [f.as_slice(), quat].concat()),
        Op::Zonal(z, dir) => ("zonal", [z.as_slice(), dir].concat()),
        Op::Cap(angle) => ("cap_visibility", vec![angle.cos(), angle.sin()]),
        Op::CapLog(angle, CapLog::Fitted) => ("cap_log", vec![angle.sin(), angle.cos()]),
        Op::CapLog(angle, CapLog::Table) if *angle > std::f64::consts::FRAC_PI_2 => {
            return only("`cap_log` beyond π/2");
        }
        Op::CapLog(angle, CapLog::FittedTo(Fit::Saturating)) => {
            ("cap_log_saturating", vec![angle.sin(), angle.cos()])
        }
        Op::CapLog(..) => return only("`cap_log` by any method but fitted and fitted:saturating"),
        Op::Log(..) => return only("`log`"),
        Op::Exp(f, exponential) => match exponential {
            Exponential::Saturating => ("exp_saturating", f.clone()),
            Exponential::Sampled(Fineness::Coarse) => ("exp_sampled_coarse", f.clone()),
            Exponential::Sampled(Fineness::Medium) => ("exp_sampled", f.clone()),
            Exponential::Sampled(Fineness::Fine) => ("exp_sampled_fine", f.clone()),
            Exponential::Series(degree) => (
                "exp_product_series",
                [f.as_slice(), &[*degree as f64]].concat(),
            ),
            Exponential::Factored(degree) => {
                ("exp_ps_star", [f.as_slice(), &[*degree as f64]].concat())
            }
            Exponential::OptimalLinear => ("exp_optimal_linear", f.clone()),
            Exponential::Hybrid => ("exp_hyb", f.clone()),
            Exponential::Eigen => return only("`exp` by eigenanalysis"),
        },
        Op::Window(f, h) => ("window", [f.as_slice(), &[*h]].concat()),
    })
}

/// Shapes of a function's arguments and of its result.
fn signature(function: &str) -> (Vec<Shape>, Shape) {
    match find(function) {
        Some(routine) => (
            routine.arguments.iter().map(|a| a.1).collect(),
            routine.result,
        ),
        None if has_degree(function) => (vec![Shape::Vector, Shape::Scalar], Shape::Vector),
        None => (vec![Shape::Vector], Shape::Vector),
    }
}

/// Whether a function's last argument is a degree, a whole number.
fn has_degree(function: &str) -> bool {
    matches!(function, "exp_product_series" | "exp_ps_star")
}

fn entry_point(function: &str) -> String {
    format!("eval_{function}")
}

/// The library of an order and an entry point for each function: it takes the arguments from one buffer,
/// number by number, and puts the result into another.
fn source(order: usize) -> String {
    let mut text = sh_kernels::library(order).unwrap_or_default().to_string();
    text += "\n@group(0) @binding(0) var<storage, read> arguments: array<f32>;\
             \n@group(0) @binding(1) var<storage, read_write> results: array<f32>;\n";
    for (name, length) in [("zonal", order), ("vector", order * order)] {
        text += &format!(
            "\nfn {name}_at(first: u32) -> array<f32, {length}> {{\n    var a: array<f32, {length}>;\
             \n    for (var i = 0u; i < {length}u; i += 1u) {{\n        a[i] = arguments[first + i];\n    }}\
             \n    return a;\n}}\n"
        );
    }
    for function in FUNCTIONS {
        let (arguments, result) = signature(function);
        let mut first = 0;
        let arguments: Vec<_> = arguments
            .iter()
            .map(|shape| {
                let each = |count: usize| {
                    let all: Vec<_> = (first..first + count)
                        .map(|i| format!("arguments[{i}]"))
                        .collect();
                    all.join(", ")
                };
                let argument = match shape {
                    Shape::Zonal => format!("zonal_at({first}u)"),
                    Shape::Vector => format!("vector_at({first}u)"),
                    Shape::Direction => format!("vec3f({})", each(3)),
                    Shape::Quaternion => format!("vec4f({})", each(4)),
                    _ if has_degree(function) => format!("u32({})", each(1)),
                    _ => each(1),
                };
                first += shape.len(order);
                argument
            })
            .collect();
        let store = match result {
            Shape::Scalar => "    results[0] = r;\n".to_string(),
            _ => format!(
                "    for (var i = 0u; i < {}u; i += 1u) {{\n        results[i] = r[i];\n    }}\n",
                result.len(order)
            ),
        };
        text += &format!(
            "\n@compute @workgroup_size(1)\nfn {}() {{\n    var r = sh{order}_{function}({});\n{store}}}\n",
            entry_point(function),
            arguments.join(", ")
        );
    }
    text
}
