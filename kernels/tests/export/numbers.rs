//! What the exported GLSL and SPIR-V compute, against the truth in double precision.
//!
//! GLSL is exported routine by routine, each inside a compute shader of its own, and compiled by glslang; of SPIR-V the
//! module with all entry points is run. Neither goes through naga again.

use crate::compilers::{folder, run};
use crate::device::Device;
use crate::files::whole;
use libtest_mimic::Failed;
use sh_codegen::{fits, routines};
use sh_kernels::export::{Language, Request, Signature, export, signature};
use sh_reference::exp;
use sh_tests::accuracy::{Number, Table, error};
use sh_tests::{case, truth::truth};

/// Which orders are run. Software drivers take a minute to compile the highest orders, whose text is compiled by
/// `compiles::…` and whose numbers are those of the same graph in `tests/tests/gpu.rs`.
pub const RUNS: [(Language, &[usize]); 2] =
    [(Language::Glsl450, &[2, 4]), (Language::Spirv, &[3, 4])];

/// Invocations: more than one workgroup, and not a whole number of them.
const CASES: usize = 70;

/// What the exponentials that are made of products may be off by, and the table's interpolation; in parts of the largest
/// number of the result, at least 1.
const TOLERANCE: f64 = 2e-5;

/// All routines of an order.
pub fn check(device: &Device, language: Language, order: usize) -> Result<(), Failed> {
    let whole = match language {
        Language::Spirv => {
            let file = whole(language, order);
            let names = sh_kernels::export::routines();
            let entries: Vec<_> = names.iter().map(|n| format!("sh{order}_{n}")).collect();
            Some(device.module(&words(&file.bytes), &entries))
        }
        _ => None,
    };
    for name in sh_kernels::export::routines() {
        let signature = signature(order, &name).ok_or("a routine has a signature")?;
        let cases: Vec<_> = cases(&name, order, &signature);
        let numbers = cases.iter().flat_map(|arguments| {
            let each = arguments.iter().zip(&signature.arguments);
            each.flat_map(|(numbers, argument)| numbers.iter().map(|x| encoded(*x, argument.whole)))
        });
        let numbers: Vec<u32> = numbers.collect();
        let count = signature.result.count;
        let compiled;
        let (module, entry) = match &whole {
            Some(module) => (module, format!("sh{order}_{name}")),
            None => {
                compiled = device.module(&glsl(&name, order, &signature)?, &["main".into()]);
                (&compiled, "main".to_string())
            }
        };
        let got = device.run(module, &entry, &numbers, count * CASES, CASES);
        for (arguments, got) in cases.iter().zip(got.chunks(count)) {
            let got = got
                .iter()
                .map(|word| decoded(*word, signature.result.whole));
            let got: Vec<f64> = got.collect();
            compare(&name, order, arguments, &got)?;
        }
    }
    Ok(())
}

fn words(bytes: &[u8]) -> Vec<u32> {
    bytemuck::pod_collect_to_vec(bytes)
}

fn encoded(x: f64, whole: bool) -> u32 {
    match whole {
        true => x as u32,
        false => (x as f32).to_bits(),
    }
}

fn decoded(word: u32, whole: bool) -> f64 {
    match whole {
        true => f64::from(word),
        false => f64::from(f32::from_bits(word)),
    }
}

/// Arguments as the f32 that they become, the same in every run.
fn cases(name: &str, order: usize, signature: &Signature) -> Vec<Vec<Vec<f64>>> {
    let mut random = case::Random::new(order as u64 + 77);
    let mut one = |i| match routines::find(name) {
        Some(routine) => case::arguments(routine, order, &mut random, i),
        None => signature
            .arguments
            .iter()
            .map(|argument| match argument.name.as_str() {
                "degree" => vec![(i % 8) as f64],
                "row" => vec![(i * 3) as f64],
                "angle" => vec![3.3 * random.unit()],
                // Pairs of halves: any bits but those of infinities and NaN.
                "words" => {
                    let halves = (0..argument.count).map(|_| {
                        let bits = (random.unit() * f64::from(1 << 23)) as u32;
                        bits & 0x3fff | (bits << 9 & 0xbfff_0000)
                    });
                    halves.map(f64::from).collect()
                }
                _ => (0..argument.count).map(|_| 0.7 * random.signed()).collect(),
            })
            .collect(),
    };
    let rounded = |numbers: Vec<f64>| numbers.iter().map(|x| f64::from(*x as f32)).collect();
    (0..CASES)
        .map(|i| match name {
            "unpack_half" => one(i),
            _ => one(i).into_iter().map(rounded).collect(),
        })
        .collect()
}

fn compare(name: &str, order: usize, arguments: &[Vec<f64>], got: &[f64]) -> Result<(), Failed> {
    let (worst, permitted) = match routines::find(name) {
        Some(routine) => {
            let want = truth(name, order, arguments).ok_or("every routine has a truth")?;
            let scale = case::scale(routine, arguments);
            let permitted = Table::load().permitted(name, Number::Gpu);
            (error(got, &want, Number::Gpu, scale), permitted)
        }
        None if name == "pack_half" => {
            let unpacked = halves(got);
            let ulps = arguments[0].iter().zip(&unpacked).map(|(want, got)| {
                // Half of the distance between neighbours: 2^-11 of the power of two below, at least 2^-25.
                let half = 2.0_f64.powi((want.abs().log2().floor() as i32).max(-14) - 11);
                (want - got).abs() / half
            });
            let padding = unpacked.get(arguments[0].len()).is_some_and(|x| *x != 0.0);
            (ulps.fold(if padding { 9.0 } else { 0.0 }, f64::max), 1.0)
        }
        None if name == "unpack_half" => {
            let want = halves(&arguments[0]);
            let wrong = got.iter().zip(&want).any(|(got, want)| got != want);
            (if wrong { 1.0 } else { 0.0 }, 0.0)
        }
        None => {
            let want = of_products(name, order, arguments);
            let scale = want.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
            let far = got.iter().zip(&want).map(|(a, b)| (a - b).abs() / scale);
            (far.fold(0.0, f64::max), TOLERANCE)
        }
    };
    match worst <= permitted {
        true => Ok(()),
        false => Err(format!(
            "sh{order}_{name}{arguments:?}: {got:?}, off by {worst}, {permitted} permitted"
        )
        .into()),
    }
}

/// Words as the halves in them, the lower one first.
fn halves(words: &[f64]) -> Vec<f64> {
    let bits = words
        .iter()
        .flat_map(|word| [*word as u32 & 0xffff, *word as u32 >> 16]);
    let value = |bits: u32| {
        let sign = if bits >> 15 == 1 { -1.0 } else { 1.0 };
        let (exponent, fraction) = ((bits >> 10 & 31) as i32, f64::from(bits & 1023) / 1024.0);
        match exponent {
            0 => sign * fraction * 2.0_f64.powi(-14),
            _ => sign * (1.0 + fraction) * 2.0_f64.powi(exponent - 15),
        }
    };
    bits.map(value).collect()
}

/// The truth of what is no generated routine.
fn of_products(name: &str, order: usize, arguments: &[Vec<f64>]) -> Vec<f64> {
    let f = &arguments[0];
    let polynomial = |c: &[f64], x: f64| c.iter().rev().fold(0.0, |sum, c| sum * x + c);
    match name {
        "exp_product_series" => exp::series(f, arguments[1][0] as usize),
        "exp_ps_star" => exp::ps_star(f, arguments[1][0] as usize),
        "exp_hyb" => {
            let factors = fits::optimal_linear_coefficients(order);
            exp::hyb(f, exp::squarings(f), |norm| {
                (polynomial(&factors[0], norm), polynomial(&factors[1], norm))
            })
        }
        "exp_optimal_linear" => {
            let (range, factors) = fits::optimal_linear_wide(order);
            exp::hyb(f, 0, |norm| {
                let x = norm.min(range) / range;
                (polynomial(&factors[0], x), polynomial(&factors[1], x))
            })
        }
        "cap_log_row" => fits::cap_log_table(order)[(f[0] as usize).min(179)].clone(),
        "cap_log_table" => {
            let rows = fits::cap_log_table(order);
            let degrees = f[0].to_degrees().min(179.0);
            let row = (degrees as usize).min(178);
            let share = degrees - row as f64;
            let pairs = rows[row].iter().zip(&rows[row + 1]);
            pairs.map(|(a, b)| a * (1.0 - share) + b * share).collect()
        }
        _ => panic!("nobody has written the truth of {name}"),
    }
}

/// One routine in a compute shader like those of the SPIR-V file, by glslang.
fn glsl(name: &str, order: usize, signature: &Signature) -> Result<Vec<u32>, Failed> {
    let routines = [name];
    let request = Request {
        routines: &routines,
        ..Request::new(Language::Glsl450, order)
    };
    let file = export(&request)?;
    let folder = folder(&format!("run_{order}_{name}"));
    std::fs::write(folder.join(&file.name), &file.bytes)?;
    let from_bits = |whole: bool, at: String| {
        if whole {
            at
        } else {
            format!("uintBitsToFloat({at})")
        }
    };
    let (mut reads, mut first, mut names) = (String::new(), 0, Vec::new());
    for (i, argument) in signature.arguments.iter().enumerate() {
        let kind = if argument.whole { "uint" } else { "float" };
        let at = |k: usize| from_bits(argument.whole, format!("arguments[first + {}u]", first + k));
        let all: Vec<_> = (0..argument.count).map(at).collect();
        let all = all.join(", ");
        let (kind, size) = match (argument.wgsl.starts_with("array"), argument.count) {
            (true, count) => (kind.to_string(), format!("[{count}]")),
            (false, 1) => (kind.to_string(), String::new()),
            (false, count) => (format!("vec{count}"), String::new()),
        };
        reads += &format!("    {kind} a{i}{size} = {kind}{size}({all});\n");
        names.push(format!("a{i}"));
        first += argument.count;
    }
    let result = &signature.result;
    let kind = if result.whole { "uint" } else { "float" };
    let (kind, size) = match (result.wgsl.starts_with("array"), result.count) {
        (true, count) => (kind.to_string(), format!("[{count}]")),
        (false, 1) => (kind.to_string(), String::new()),
        (false, count) => (format!("vec{count}"), String::new()),
    };
    let bits = |value: &str| {
        if result.whole {
            value.to_string()
        } else {
            format!("floatBitsToUint({value})")
        }
    };
    let writes: String = (0..result.count)
        .map(|i| {
            let element = if result.count == 1 {
                "r".to_string()
            } else {
                format!("r[{i}]")
            };
            format!(
                "    results[id * {}u + {i}u] = {};\n",
                result.count,
                bits(&element)
            )
        })
        .collect();
    let shader = format!(
        "#version 450\n#extension GL_GOOGLE_include_directive : require\n#include \"{}\"\n\
         layout(local_size_x = 64) in;\n\
         layout(std430, set = 0, binding = 0) readonly buffer Arguments {{ uint arguments[]; }};\n\
         layout(std430, set = 0, binding = 1) buffer Results {{ uint results[]; }};\n\
         void main() {{\n    uint id = gl_GlobalInvocationID.x;\n    if (id >= {CASES}u) return;\n    \
         uint first = id * {first}u;\n{reads}    {kind} r{size} = sh{order}_{name}({});\n{writes}}}\n",
        file.name,
        names.join(", ")
    );
    std::fs::write(folder.join("run.comp"), shader)?;
    let arguments = [
        "-V",
        "--target-env",
        "vulkan1.1",
        "-I.",
        "run.comp",
        "-o",
        "run.spv",
    ];
    run(&folder, "glslangValidator", &arguments)?;
    Ok(words(&std::fs::read(folder.join("run.spv"))?))
}
