//! Instructions a result, counted by valgrind: one result at a time, 8 and 16 side by side.
//!
//! ```text
//! cargo bench -p sh-benches --bench instructions [-- NAME…]
//! ```
//! The text of a routine is the same on every path, so a routine that vectorises takes an eighth of the
//! instructions a result in 8 lanes. Compare with `fused`, one result at a time with the same instruction set;
//! `scalar` lacks fused operations. Without valgrind nothing is measured, and that is said. Only routines whose
//! name is given are run, if any is.

use sh_benches::cases::{Path, all, is_here};
use std::process::Command;

/// Vectors a batch: what surrounds the batch is below a thousandth of it.
const VECTORS: usize = 256;

/// Instructions that `count` spends on a batch.
fn instructions(name: &str, order: usize, path: Path) -> Result<u64, String> {
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .args(["--collect-atstart=no", "--toggle-collect=count::measured*"])
        .arg(env!("CARGO_BIN_EXE_count"))
        .args([name, &order.to_string(), path.name(), &VECTORS.to_string()])
        .output()
        .map_err(|e| format!("valgrind: {e}"))?;
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    let count = text
        .lines()
        .find_map(|line| line.split_once("Collected :"))
        .and_then(|(_, count)| count.trim().parse().ok());
    match count {
        Some(count) if output.status.success() && count > 0 => Ok(count),
        _ => Err(format!(
            "valgrind counted nothing ({}):\n{text}",
            output.status
        )),
    }
}

fn main() -> Result<(), String> {
    if !is_here() {
        println!("skipped: this processor lacks the instructions that are measured (AVX2 on x86)");
        return Ok(());
    }
    if Command::new("valgrind").arg("--version").output().is_err() {
        println!("skipped: counting instructions needs valgrind, which is not installed");
        return Ok(());
    }
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let names: Vec<&String> = arguments.iter().filter(|a| !a.starts_with('-')).collect();
    let full = arguments.iter().any(|a| a == "--bench");
    print!("{:<16}{:>6}", "routine", "order");
    Path::ALL.iter().for_each(|p| print!("{:>10}", p.name()));
    println!(
        "{:>12}{:>12}    (instructions a result)",
        "scalar/8", "fused/8"
    );
    for case in all() {
        let chosen = names.is_empty() || names.iter().any(|n| *n == case.name);
        // A test run only shows that counting works.
        if !chosen || !(full || case.name == "product" && case.order == 3) {
            continue;
        }
        print!("{:<16}{:>6}", case.name, case.order);
        let mut of_path = std::collections::HashMap::new();
        for path in Path::ALL {
            if case.sweep(path).is_none() {
                print!("{:>10}", "-");
                continue;
            }
            let count = instructions(case.name, case.order, path)? as f64 / VECTORS as f64;
            print!("{count:>10.1}");
            of_path.insert(path, count);
        }
        let by_eight = |path| match (of_path.get(&path), of_path.get(&Path::Eight)) {
            (Some(one), Some(eight)) => format!("{:.2}", one / eight),
            _ => "-".to_string(),
        };
        println!(
            "{:>12}{:>12}",
            by_eight(Path::Scalar),
            by_eight(Path::Fused)
        );
    }
    Ok(())
}
