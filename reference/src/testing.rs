//! Inputs the unit tests share: deterministic, without structure that could hide a mistake.

use crate::vec3::Vec3;

/// A spiral of `count` directions over the whole sphere.
pub(crate) fn directions(count: usize) -> Vec<Vec3> {
    crate::sampled::directions(count).collect()
}

/// `count` numbers in -1..1 (a linear congruential generator, top bits).
pub(crate) fn numbers(seed: u64, count: usize) -> Vec<f64> {
    let mut state = seed
        .wrapping_mul(2862933555777941757)
        .wrapping_add(3037000493);
    (0..count)
        .map(|_| {
            state = state
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        })
        .collect()
}

/// Panics unless both have the same length and differ by at most `tolerance` anywhere.
#[track_caller]
pub(crate) fn assert_close(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    for (i, (a, b)) in found.iter().zip(expected).enumerate() {
        // Written so that a NaN fails.
        assert!(
            (a - b).abs() <= tolerance,
            "coefficient {i}: {a} instead of {b}, off by {:e}",
            a - b
        );
    }
}
