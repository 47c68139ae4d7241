//! Which form of product and square is the faster: term by term, or on rings.
//!
//! ```text
//! cargo bench -p sh-benches --bench forms
//! ```
//! Both run in turns. A ratio is direct by rings: below 1, the term-by-term form is the faster. The form whose
//! fastest round is faster counts.

use sh_benches::batch::numbers;
use sh_benches::cases::{Path, all, find, is_here};
use sh_benches::timing::{in_turns, median_ratio, minimum};
use std::hint::black_box;

/// Few enough that both forms' data stay in the first or second cache: what is compared is arithmetic.
const VECTORS: usize = 256;

fn main() {
    if !is_here() {
        println!("skipped: this processor lacks the instructions that are measured (AVX2 on x86)");
        return;
    }
    let rounds = if std::env::args().any(|a| a == "--bench") {
        301
    } else {
        3
    };
    println!(
        "{:<10}{:>6}{:>8}{:>12}{:>12}{:>18}{:>14}  faster",
        "routine", "order", "path", "direct ns", "rings ns", "ratio of fastest", "median ratio"
    );
    for direct in all().iter().filter(|case| case.name.ends_with("/direct")) {
        let routine = direct.name.trim_end_matches("/direct");
        let rings =
            find(&format!("{routine}/rings"), direct.order).expect("both forms, for every order");
        for path in [Path::Scalar, Path::Eight, Path::Sixteen] {
            let input = numbers(direct.inputs * VECTORS);
            let mut runs: Vec<Box<dyn FnMut() + '_>> = Vec::new();
            for case in [direct, &rings] {
                let sweep = case.sweep(path).expect("forms are measured on these paths");
                let input = input.as_slice();
                let mut output = vec![0.0; case.outputs * VECTORS];
                runs.push(Box::new(move || {
                    sweep(black_box(input), &mut output);
                    black_box(&output);
                }));
            }
            let samples = in_turns(&mut runs, rounds);
            let time = |s: &[f64]| minimum(s) * 1e9 / VECTORS as f64;
            let [a, b] = [time(&samples[0]), time(&samples[1])];
            let ratio = median_ratio(&samples[0], &samples[1]);
            println!(
                "{routine:<10}{:>6}{:>8}{a:>12.2}{b:>12.2}{:>18.3}{ratio:>14.3}  {}",
                direct.order,
                path.name(),
                a / b,
                if a < b { "direct" } else { "rings" }
            );
        }
    }
}
