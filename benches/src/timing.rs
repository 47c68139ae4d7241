//! Time, on machines that do other work as well.

use std::time::{Duration, Instant};

/// How long one sample should take: long against the clock's resolution, short against the time slices of
/// the system, so that the fastest rounds are undisturbed.
const SAMPLE: Duration = Duration::from_micros(300);

/// Runs all in turns, `rounds` times; seconds a call for every round, for each.
pub fn in_turns(runs: &mut [Box<dyn FnMut() + '_>], rounds: usize) -> Vec<Vec<f64>> {
    let calls: Vec<u32> = runs
        .iter_mut()
        .map(|run| {
            run();
            // The fastest of a few: one that was interrupted would make the samples too short.
            let fastest = (0..5)
                .map(|_| {
                    let start = Instant::now();
                    run();
                    start.elapsed()
                })
                .min()
                .unwrap_or_default();
            (SAMPLE.as_nanos() / fastest.as_nanos().max(1)).clamp(1, 10_000) as u32
        })
        .collect();
    let mut samples = vec![Vec::with_capacity(rounds); runs.len()];
    for _ in 0..rounds {
        for ((run, calls), samples) in runs.iter_mut().zip(&calls).zip(&mut samples) {
            let start = Instant::now();
            for _ in 0..*calls {
                run();
            }
            samples.push(start.elapsed().as_secs_f64() / f64::from(*calls));
        }
    }
    samples
}

/// The smallest of all; infinity for none.
pub fn minimum(samples: &[f64]) -> f64 {
    samples.iter().copied().fold(f64::INFINITY, f64::min)
}

/// The middle one; NaN for none.
pub fn median(samples: &[f64]) -> f64 {
    let mut sorted = samples.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(f64::NAN)
}

/// The median of `a / b` over the rounds.
pub fn median_ratio(a: &[f64], b: &[f64]) -> f64 {
    let ratios: Vec<f64> = a.iter().zip(b).map(|(a, b)| a / b).collect();
    median(&ratios)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_disturbed_round_does_not_count() {
        let (a, b) = ([2.0, 90.0, 2.2], [1.0, 1.1, 1.0]);
        assert_eq!((minimum(&a), median(&a)), (2.0, 2.2));
        assert_eq!(median_ratio(&a, &b), 2.2);
    }

    #[test]
    fn every_round_has_one_sample_of_each() {
        let (mut first, mut second) = (0, 0);
        let mut runs: Vec<Box<dyn FnMut() + '_>> =
            vec![Box::new(|| first += 1), Box::new(|| second += 1)];
        let samples = in_turns(&mut runs, 4);
        drop(runs);
        assert_eq!(samples.iter().map(Vec::len).collect::<Vec<_>>(), [4, 4]);
        assert!(first > 4 && second > 4);
    }
}
