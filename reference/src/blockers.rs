//! The random sets of circular blockers that every figure of accuracy is measured on.
//!
//! A seed gives the same sets everywhere, and the first of many are the few: `random(1, 10)` begins
//! `random(1, 1000)`. The numbers are SplitMix64 (Steele, Lea & Flood, "Fast Splittable Pseudorandom Number
//! Generators", 2014), 53 bits each, uniform in 0..1.

use crate::vec3::{Vec3, add, frame, normalize, scale};
use crate::visibility::Cap;
use std::f64::consts::TAU;

/// `count` sets of separate blockers. The number of caps in each is uniform in 1..=12, their axes are uniform on
/// the upper half of the sphere (z ≥ 0), their angular radii uniform in 3°..45°, all independent.
///
/// ```
/// let sets = sh_reference::blockers::random(1, 100);
/// assert!(sets.iter().all(|caps| (1..=12).contains(&caps.len())));
/// ```
pub fn random(seed: u64, count: usize) -> Vec<Vec<Cap>> {
    let mut numbers = Numbers { state: seed };
    (0..count)
        .map(|_| {
            let caps = numbers.whole(1, 12);
            (0..caps)
                .map(|_| Cap {
                    axis: numbers.upper(),
                    angle: numbers.between(3.0, 45.0).to_radians(),
                })
                .collect()
        })
        .collect()
}

/// `count` sets of blockers that nearly coincide, as the spheres of a solid body do: where a logarithm of the
/// visibility that is summed over them grows large. The number of caps in each is uniform in 2..=24. A set has a
/// middle uniform on the upper half of the sphere (z ≥ 0) and a radius R uniform in 32/3°..36°. Each cap's
/// radius r is R times a number uniform in 0.75..1.25 (so it lies in 8°..45°), its axis the middle turned by an
/// angle uniform in 0..0.35 r in a direction uniform in 0..2π (so an axis may lie a little below z = 0).
///
/// ```
/// let sets = sh_reference::blockers::heavy(1, 100);
/// assert!(sets.iter().flatten().all(|cap| (8.0..45.0).contains(&cap.angle.to_degrees())));
/// ```
pub fn heavy(seed: u64, count: usize) -> Vec<Vec<Cap>> {
    let mut numbers = Numbers { state: seed };
    (0..count)
        .map(|_| {
            let caps = numbers.whole(2, 24);
            let middle = numbers.upper();
            let common = numbers.between(32.0 / 3.0, 36.0).to_radians();
            let [u, v] = frame(middle);
            (0..caps)
                .map(|_| {
                    let angle = common * numbers.between(0.75, 1.25);
                    let (far, near) = (angle * numbers.between(0.0, 0.35)).sin_cos();
                    let (sin, cos) = numbers.between(0.0, TAU).sin_cos();
                    let aside = add(scale(u, far * cos), scale(v, far * sin));
                    Cap {
                        axis: normalize(add(scale(middle, near), aside)),
                        angle,
                    }
                })
                .collect()
        })
        .collect()
}

/// `count` sets of blockers all around, which leave little or nothing of the sky. The number of caps in each is
/// uniform in 24..=64, their axes are uniform on the whole sphere, their angular radii uniform in 25°..60°.
///
/// ```
/// let sets = sh_reference::blockers::enclosing(1, 10);
/// assert!(sets.iter().all(|caps| (24..=64).contains(&caps.len())));
/// ```
pub fn enclosing(seed: u64, count: usize) -> Vec<Vec<Cap>> {
    let mut numbers = Numbers { state: seed };
    (0..count)
        .map(|_| {
            let caps = numbers.whole(24, 64);
            (0..caps)
                .map(|_| {
                    let [x, y, z] = numbers.upper();
                    let z = if numbers.between(0.0, 1.0) < 0.5 {
                        z
                    } else {
                        -z
                    };
                    Cap {
                        axis: [x, y, z],
                        angle: numbers.between(25.0, 60.0).to_radians(),
                    }
                })
                .collect()
        })
        .collect()
}

/// One set of `count` identical caps of radius `angle` (radians) about +Z, which cover no more than one of them.
pub fn stacked(angle: f64, count: usize) -> Vec<Vec<Cap>> {
    let axis = [0.0, 0.0, 1.0];
    vec![vec![Cap { axis, angle }; count]]
}

pub(crate) struct Numbers {
    state: u64,
}

impl Numbers {
    pub(crate) fn new(seed: u64) -> Self {
        Self { state: seed }
    }

    /// Uniform on the sphere.
    pub(crate) fn direction(&mut self) -> Vec3 {
        let [x, y, z] = self.upper();
        let below = self.between(0.0, 1.0) < 0.5;
        [x, y, if below { -z } else { z }]
    }

    /// Uniform in `from..to`.
    pub(crate) fn between(&mut self, from: f64, to: f64) -> f64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        from + (to - from) * ((z >> 11) as f64 / (1u64 << 53) as f64)
    }

    /// Uniform in `from..=to`.
    pub(crate) fn whole(&mut self, from: usize, to: usize) -> usize {
        from + self.between(0.0, (to - from + 1) as f64) as usize
    }

    /// Uniform on the half of the unit sphere with z ≥ 0, on which heights are uniform (Archimedes).
    fn upper(&mut self) -> Vec3 {
        let z = self.between(0.0, 1.0);
        let (sin, cos) = self.between(0.0, TAU).sin_cos();
        let r = ((1.0 - z) * (1.0 + z)).sqrt();
        [r * cos, r * sin, z]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vec3::{angle, dot};

    /// Mean of a number over all caps.
    fn mean(sets: &[Vec<Cap>], of: impl Fn(&Cap) -> f64) -> f64 {
        let caps = sets.iter().flatten();
        caps.clone().map(of).sum::<f64>() / caps.count() as f64
    }

    #[test]
    fn split_mix_is_the_published_one() {
        // First output for seed 1234567, from the author's C code.
        let first = Numbers { state: 1_234_567 }.between(0.0, 1.0);
        let expected = (6_457_827_717_110_365_317u64 >> 11) as f64 / (1u64 << 53) as f64;
        assert_eq!(first, expected);
    }

    #[test]
    fn few_are_the_first_of_many() {
        assert_eq!(random(3, 10), random(3, 1000)[..10]);
        assert_eq!(heavy(3, 10), heavy(3, 1000)[..10]);
        assert_ne!(random(3, 1), random(4, 1));
    }

    #[test]
    fn random_sets_are_distributed_as_stated() {
        let sets = random(1, 4000);
        for size in 1..=12 {
            let share = sets.iter().filter(|caps| caps.len() == size).count();
            assert!((250..420).contains(&share), "{share} sets of {size}");
        }
        // Some 26000 caps: standard errors of the means are 0.002, 0.004 and 0.08.
        assert!((mean(&sets, |cap| cap.axis[2]) - 0.5).abs() < 0.01);
        assert!(mean(&sets, |cap| cap.axis[0]).abs() < 0.02);
        assert!((mean(&sets, |cap| cap.angle.to_degrees()) - 24.0).abs() < 0.4);
        for cap in sets.iter().flatten() {
            assert!((dot(cap.axis, cap.axis) - 1.0).abs() < 1e-14 && cap.axis[2] >= 0.0);
            assert!((3.0..45.0).contains(&cap.angle.to_degrees()));
        }
    }

    #[test]
    fn heavy_sets_are_distributed_as_stated() {
        let sets = heavy(1, 2000);
        for size in 2..=24 {
            let share = sets.iter().filter(|caps| caps.len() == size).count();
            assert!((45..135).contains(&share), "{share} sets of {size}");
        }
        assert!((mean(&sets, |cap| cap.angle.to_degrees()) - 70.0 / 3.0).abs() < 0.5);
        for caps in &sets {
            let (a, b) = (caps[0], caps[1]);
            assert!(angle(a.axis, b.axis) < 0.35 * (a.angle + b.angle));
            assert!(a.angle / b.angle < 1.25 / 0.75 + 1e-12);
        }
    }

    #[test]
    fn stacked_sets_are_one_cap() {
        let sets = stacked(0.5, 7);
        assert_eq!((sets.len(), sets[0].len()), (1, 7));
        assert!(
            sets[0]
                .iter()
                .all(|cap| *cap == sets[0][0] && cap.angle == 0.5)
        );
    }
}
