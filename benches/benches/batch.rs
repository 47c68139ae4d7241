//! Nanoseconds a result: product, square and basis in batches, one at a time and in lanes.
//!
//! ```text
//! cargo bench -p sh-benches --bench batch [-- --json]
//! ```
//! The paths of one routine run in turns, and the fastest round of each counts. *gain* is scalar time by 8-lane
//! time; above 8 it owes the rest to fused operations, which the scalar path of a plain build does not have
//! and `fused` has.

use sh_benches::batch::numbers;
use sh_benches::cases::{Case, Path, all, is_here};
use sh_benches::timing::{in_turns, minimum};
use std::hint::black_box;

/// Vectors a batch: more than a frame's pass keeps in registers, less than the second cache holds for the
/// routines of order 2 to 4.
const VECTORS: usize = 2048;

/// Seconds a batch, for every round, on each of the case's paths.
fn measure(case: &Case, rounds: usize) -> Vec<Vec<f64>> {
    let input = numbers(case.inputs * VECTORS);
    let mut runs: Vec<Box<dyn FnMut() + '_>> = Vec::new();
    for (_, sweep) in &case.sweeps {
        let input = input.as_slice();
        let mut output = vec![0.0; case.outputs * VECTORS];
        runs.push(Box::new(move || {
            sweep(black_box(input), &mut output);
            black_box(&output);
        }));
    }
    in_turns(&mut runs, rounds)
}

fn main() {
    if !is_here() {
        println!("skipped: this processor lacks the instructions that are measured (AVX2 on x86)");
        return;
    }
    let given = |flag: &str| std::env::args().any(|a| a == flag);
    // `cargo bench` says `--bench`; without it this is a test run that only shows that all is well.
    let rounds = if given("--bench") { 101 } else { 3 };
    let mut json = Vec::new();
    if !given("--json") {
        print!("{:<14}{:>6}", "routine", "order");
        Path::ALL.iter().for_each(|p| print!("{:>10}", p.name()));
        println!("{:>10}    (nanoseconds a result)", "gain");
    }
    for case in all().iter().filter(|case| !case.name.contains('/')) {
        let samples = measure(case, rounds);
        let of = |path| {
            let place = case.sweeps.iter().position(|(p, _)| *p == path);
            &samples[place.expect("the routines themselves are measured on every path")]
        };
        let time = |path| minimum(of(path)) * 1e9 / VECTORS as f64;
        let gain = time(Path::Scalar) / time(Path::Eight);
        if given("--json") {
            let times = Path::ALL.map(|path| format!("\"{}\":{:.3}", path.name(), time(path)));
            json.push(format!(
                "{{\"routine\":\"{}\",\"order\":{},\"nanoseconds\":{{{}}},\"gain\":{gain:.3}}}",
                case.name,
                case.order,
                times.join(",")
            ));
        } else {
            print!("{:<14}{:>6}", case.name, case.order);
            Path::ALL.iter().for_each(|p| print!("{:>10.2}", time(*p)));
            println!("{gain:>10.2}");
        }
    }
    if given("--json") {
        println!("[{}]", json.join(",\n "));
    }
}
