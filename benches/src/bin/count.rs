//! Runs one routine over a batch once, to be watched by a profiler: `count ROUTINE ORDER PATH [VECTORS]`.
//!
//! ```text
//! valgrind --tool=callgrind --collect-atstart=no --toggle-collect='count::measured*' count product 4 8 256
//! ```
//! PATH is `scalar`, `fused`, `8` or `16`; see [`sh_benches::cases::Path`].

use sh_benches::batch::numbers;
use sh_benches::cases::{Path, Sweep, find, is_here};
use std::hint::black_box;
use std::process::ExitCode;

/// What the profiler looks for by name.
#[inline(never)]
fn measured(sweep: Sweep, input: &[f32], output: &mut [f32]) {
    sweep(input, output);
}

fn run() -> Result<(), String> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [name, order, path, rest @ ..] = arguments.as_slice() else {
        return Err("usage: count ROUTINE ORDER PATH [VECTORS]".to_string());
    };
    let order: usize = order
        .parse()
        .map_err(|_| format!("order: `{order}` is no whole number"))?;
    let case = find(name, order)
        .ok_or_else(|| format!("no routine `{name}` of order {order} is measured"))?;
    let path = Path::ALL
        .into_iter()
        .find(|p| p.name() == path)
        .ok_or_else(|| format!("path: `{path}` is none of scalar, fused, 8, 16"))?;
    if !is_here() {
        return Err("this processor lacks the instructions that are measured".to_string());
    }
    let sweep = case
        .sweep(path)
        .ok_or_else(|| format!("`{name}` is not measured on path {}", path.name()))?;
    let vectors: usize = match rest.first() {
        Some(text) => text
            .parse()
            .map_err(|_| format!("vectors: `{text}` is no whole number"))?,
        None => 256,
    };
    let input = numbers(case.inputs * vectors);
    let mut output = vec![0.0; case.outputs * vectors];
    measured(sweep, black_box(&input), &mut output);
    black_box(&output);
    Ok(())
}

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("count: {message}");
            ExitCode::FAILURE
        }
    }
}
