//! Any visibility and any light, asked in many directions spread evenly over the sphere.
//!
//! For triangles ([`crate::raycast`]) and for light of texels, where nothing is known between two samples.
//! The directions are a spherical Fibonacci lattice (González, "Measurement of Areas on a Sphere Using
//! Fibonacci and Latitude–Longitude Lattices", 2010), all of equal weight: it is even, and unlike a grid it
//! has no lines that an edge could run along. For a cap at order 4 the error is at most 9·count^(−3/4).
//! Both functions also sum over a lattice of a quarter as many directions and give twice the difference as an
//! estimate of the error: several times the truth as a rule, and not below it for any of 160 caps tried.

use crate::basis::{basis, distance};
use crate::quadrature::{Estimate, accumulate};
use crate::vec3::dot;
use crate::visibility::Radiance;
use std::f64::consts::PI;

/// Unit vectors of which each stands for 4π/`count` steradians.
///
/// ```
/// let up = sh_reference::sampled::directions(1000).filter(|[_, y, _]| *y > 0.0).count();
/// assert!((499..=501).contains(&up));
/// ```
pub fn directions(count: usize) -> impl Iterator<Item = [f64; 3]> {
    // Azimuth grows by the golden angle from one direction to the next.
    let golden = PI * (3.0 - 5f64.sqrt());
    (0..count).map(move |i| {
        let z = 1.0 - (2 * i + 1) as f64 / count as f64;
        let (sin, cos) = (golden * i as f64).sin_cos();
        let r = ((1.0 - z) * (1.0 + z)).sqrt();
        [r * cos, r * sin, z]
    })
}

/// SH vector of a visibility (a share in 0..=1), sampled in `count` directions and a quarter as many again.
/// `error` is an estimate.
///
/// ```
/// let upper = |[_, y, _]: [f64; 3]| if y > 0.0 { 1.0 } else { 0.0 };
/// let half = sh_reference::sampled::project(2, 10_000, upper);
/// assert!(half.error < 1e-2);
/// assert!((half.coefficients[0] - std::f64::consts::PI.sqrt()).abs() < half.error);
/// ```
///
/// # Panics
/// If `count` is less than 4.
pub fn project(order: usize, count: usize, mut visible: impl FnMut([f64; 3]) -> f64) -> Estimate {
    let mut over = |count: usize| {
        let weight = 4.0 * PI / count as f64;
        let mut sum = vec![0.0; order * order];
        for s in directions(count) {
            accumulate(&mut sum, weight * visible(s), &basis(order, s));
        }
        sum
    };
    assert!(count >= 4, "{count} directions have no quarter");
    let (coefficients, coarse) = (over(count), over(count / 4));
    let error = 2.0 * distance(&coefficients, &coarse);
    Estimate {
        coefficients,
        error,
    }
}

/// ∫ light(s) V(s) max(s·N, 0)/π ds for the unit vector `normal`, sampled in those of `count` directions that
/// lie above the horizon, and a quarter as many again. `error` is an estimate.
///
/// ```
/// let white = sh_reference::sampled::irradiance([0.0, 1.0, 0.0], 10_000, |_| 1.0, |_| [1.0; 3]);
/// assert!((white.value[0] - 1.0).abs() < 1e-3);
/// ```
///
/// # Panics
/// If `count` is less than 4.
pub fn irradiance(
    normal: [f64; 3],
    count: usize,
    mut visible: impl FnMut([f64; 3]) -> f64,
    light: impl Fn([f64; 3]) -> [f64; 3],
) -> Radiance {
    let mut over = |count: usize| {
        // 4π/count steradians, over π.
        let weight = 4.0 / count as f64;
        let mut sum = [0.0; 3];
        for s in directions(count) {
            let cosine = dot(s, normal);
            if cosine > 0.0 {
                accumulate(&mut sum, weight * cosine * visible(s), &light(s));
            }
        }
        sum
    };
    assert!(count >= 4, "{count} directions have no quarter");
    let (value, coarse) = (over(count), over(count / 4));
    let off = |c: usize| 2.0 * (value[c] - coarse[c]).abs();
    Radiance {
        value,
        error: off(0).max(off(1)).max(off(2)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cap;
    use crate::environment::{map_of, project as project_map, radiance};
    use crate::testing::assert_close;
    use crate::vec3::angle;
    use crate::zonal::{cosine, rotated};

    #[test]
    fn directions_are_even() {
        // Their vector is nearly that of the constant function.
        let even = project(6, 4000, |_| 1.0);
        assert_close(&even.coefficients, &crate::product::one(6), 3e-3);
        assert!((even.coefficients[0] - (4.0 * PI).sqrt()).abs() < 1e-12);
    }

    #[test]
    fn caps_come_out_within_the_estimate() {
        for axis in directions(6) {
            for radius in [0.3, 0.7, 0.5 * PI, 2.0] {
                let found = project(
                    4,
                    20_000,
                    |s| if angle(s, axis) > radius { 1.0 } else { 0.0 },
                );
                let truth = rotated(&cap::visibility(4, radius), axis);
                let off = distance(&found.coefficients, &truth);
                assert!(off < found.error, "{off:e} above {:e}", found.error);
                assert!(off < 5e-3, "{off:e}");
            }
        }
    }

    #[test]
    fn an_unshadowed_white_sky_gives_one() {
        for normal in directions(5) {
            let found = irradiance(normal, 10_000, |_| 1.0, |_| [1.0, 2.0, 0.0]);
            assert_close(&found.value, &[1.0, 2.0, 0.0], 1e-3);
            assert!(found.error > 0.0 && found.error < 6e-3);
        }
    }

    #[test]
    fn a_map_lights_as_its_vector_does() {
        // A smooth sky, of which bands above order 5 carry next to nothing.
        let map = map_of(64, 32, |[x, y, z]| [2.0 + y, 1.0 + 0.5 * x * z, 0.3]);
        let vectors = project_map(5, &map);
        for normal in directions(4) {
            let found = irradiance(normal, 20_000, |_| 1.0, |s| radiance(&map, s));
            let lobe = cosine(5, normal);
            let expected = [0, 1, 2].map(|c| crate::basis::dot(&vectors[c], &lobe));
            assert_close(&found.value, &expected, 1e-3);
        }
    }
}
