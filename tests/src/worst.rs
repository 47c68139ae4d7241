//! The worst of all cases, found by looking for it.

use crate::case::Random;

/// Looks for the point of the unit cube where `measure` is largest: random points, then steps from the best of them that
/// grow where they help and shrink where they do not (Rechenberg 1973's rule of one in five). `tries` is how often it asks;
/// the variable `GAUNT_SEARCH` multiplies it, for a search that is worth more than the seconds of a test. The same in every run.
///
/// ```
/// use sh_tests::worst::worst;
/// let (most, [x, y]) = worst(1, 2000, |[x, y]| -(x - 0.3).powi(2) - (y - 0.9).powi(2));
/// assert!(most > -1e-4 && (x - 0.3).abs() < 0.01 && (y - 0.9).abs() < 0.01);
/// ```
pub fn worst<const N: usize>(
    seed: u64,
    tries: usize,
    mut measure: impl FnMut([f64; N]) -> f64,
) -> (f64, [f64; N]) {
    let tries = tries * more();
    let mut random = Random::new(seed);
    let mut found: Vec<(f64, [f64; N])> = (0..tries.div_ceil(3))
        .map(|_| std::array::from_fn(|_| random.unit()))
        .map(|at| (measure(at), at))
        .collect();
    found.sort_by(|a, b| b.0.total_cmp(&a.0));
    found.truncate(STARTS);
    let each = tries * 2 / 3 / STARTS;
    for (most, best) in &mut found {
        let mut size = 0.2;
        for _ in 0..each {
            // A step changes some of the numbers, by little or much.
            let some = random.unit();
            let at = best.map(|x| {
                let moved = x + size * (random.signed() + random.signed());
                if random.unit() < some {
                    moved.clamp(0.0, 1.0)
                } else {
                    x
                }
            });
            let value = measure(at);
            if value > *most {
                (*most, *best) = (value, at);
                size = f64::min(size * 1.5, 0.5);
            } else {
                size = f64::max(size * 0.9, 1e-4);
            }
        }
    }
    found
        .into_iter()
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .expect("it starts somewhere")
}

/// How many of the random points steps start from.
const STARTS: usize = 4;

fn more() -> usize {
    std::env::var("GAUNT_SEARCH").map_or(1, |text| text.parse().expect("GAUNT_SEARCH is a number"))
}
