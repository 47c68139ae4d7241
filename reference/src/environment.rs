//! Projection of an equirectangular map to SH vectors, texel by texel.
//!
//! Row v runs from +Y down (polar angle θ = π v), column u turns from +Z over −X, −Z and +X, so that −Z is in
//! the middle: the direction is (sin φ sin θ, cos θ, −cos φ sin θ) with φ = 2π u − π, as
//! `sh_scene::EnvironmentMap` has it. Texel (i, j) of a map W wide and H high covers u in i/W..(i+1)/W and v
//! in j/H..(j+1)/H, and its solid angle is exactly (2π/W)·(cos(π j/H) − cos(π (j+1)/H)).
//!
//! [`project`] takes radiance as constant over each texel's area; [`project_centers`] takes the basis as
//! constant too, at the texel's centre, as fast routines do. Both weigh by exact solid angles, so a
//! constant map projects exactly, and for maps of a smooth function both converge as 1/(W·H).

use crate::basis::basis;
use crate::quadrature::{accumulate, gauss_legendre};
use sh_scene::EnvironmentMap;
use std::f64::consts::{PI, TAU};

/// The direction seen at column `u` and row `v`, both in 0..=1.
///
/// ```
/// let ahead = sh_reference::environment::direction(0.5, 0.5);
/// assert!((ahead[2] + 1.0).abs() < 1e-15);
/// ```
pub fn direction(u: f64, v: f64) -> [f64; 3] {
    let ((sin_phi, cos_phi), (sin, cos)) = ((TAU * u - PI).sin_cos(), (PI * v).sin_cos());
    [sin_phi * sin, cos, -cos_phi * sin]
}

/// Column and row, in texels from the top left, of the texel that a direction falls into.
pub fn texel([x, y, z]: [f64; 3], width: usize, height: usize) -> [usize; 2] {
    let u = (x.atan2(-z) + PI) / TAU;
    let v = x.hypot(z).atan2(y) / PI;
    let place = |along: f64, count: usize| ((along * count as f64) as usize).min(count - 1);
    [place(u, width), place(v, height)]
}

/// Solid angle of any texel in a row, in steradians; exact, by a product that does not cancel at the poles.
pub fn solid_angle(row: usize, width: usize, height: usize) -> f64 {
    // cos a − cos b = 2 sin((a+b)/2) sin((b−a)/2)
    let middle = PI * (row as f64 + 0.5) / height as f64;
    TAU / width as f64 * 2.0 * middle.sin() * (PI / (2 * height) as f64).sin()
}

/// SH vectors of a map's red, green and blue, radiance being constant over each texel. The basis is
/// integrated over the texel by Gauss–Legendre in both angles with so many nodes that its error stays
/// below 1e-12 relative, however coarse the map.
///
/// ```
/// use sh_reference::environment;
/// let white = sh_scene::EnvironmentMap { width: 4, height: 2, pixels: vec![[1.0; 3]; 8] };
/// let vectors = environment::project(3, &white);
/// assert!((vectors[0][0] - (4.0 * std::f64::consts::PI).sqrt()).abs() < 1e-12);
/// assert!(vectors[0][1..].iter().all(|c| c.abs() < 1e-12));
/// ```
///
/// # Panics
/// If the map does not have `width · height` pixels.
pub fn project(order: usize, map: &EnvironmentMap) -> [Vec<f64>; 3] {
    let across = gauss_legendre(nodes(order, TAU / f64::from(map.width)), 0.0, 1.0);
    let down = gauss_legendre(nodes(order, PI / f64::from(map.height)), 0.0, 1.0);
    sum_texels(order, map, |column, row, width, height| {
        let (columns, rows) = (width as f64, height as f64);
        let mut integral = vec![0.0; order * order];
        for (j, dj) in &down {
            let v = (row as f64 + j) / rows;
            for (i, di) in &across {
                let u = (column as f64 + i) / columns;
                let area = PI * dj / rows * TAU * di / columns * (PI * v).sin();
                accumulate(&mut integral, area, &basis(order, direction(u, v)));
            }
        }
        integral
    })
}

/// Nodes for a trigonometric polynomial of degree `order` over an interval of so many radians: its error
/// falls as (e·order·radians/8k)^2k.
fn nodes(order: usize, radians: f64) -> usize {
    3 + (1.5 * order as f64 * radians) as usize
}

/// SH vectors of a map's red, green and blue: Σ radiance · solid angle · basis at the texel's centre.
///
/// # Panics
/// If the map does not have `width · height` pixels.
pub fn project_centers(order: usize, map: &EnvironmentMap) -> [Vec<f64>; 3] {
    sum_texels(order, map, |column, row, width, height| {
        let center = direction(
            (column as f64 + 0.5) / width as f64,
            (row as f64 + 0.5) / height as f64,
        );
        let area = solid_angle(row, width, height);
        basis(order, center).iter().map(|y| area * y).collect()
    })
}

fn sum_texels(
    order: usize,
    map: &EnvironmentMap,
    integral: impl Fn(usize, usize, usize, usize) -> Vec<f64>,
) -> [Vec<f64>; 3] {
    let (width, height) = (map.width as usize, map.height as usize);
    assert_eq!(
        map.pixels.len(),
        width * height,
        "a map of {width} by {height} texels"
    );
    let mut sums = [(); 3].map(|()| vec![0.0; order * order]);
    for (i, pixel) in map.pixels.iter().enumerate() {
        let y = integral(i % width, i / width, width, height);
        for (sum, radiance) in sums.iter_mut().zip(pixel) {
            accumulate(sum, f64::from(*radiance), &y);
        }
    }
    sums
}

/// A map of a function, sampled at the centres of its texels and rounded to f32.
pub fn map_of(width: u32, height: u32, mut f: impl FnMut([f64; 3]) -> [f64; 3]) -> EnvironmentMap {
    let mut pixels = Vec::new();
    for row in 0..height {
        for column in 0..width {
            let u = (f64::from(column) + 0.5) / f64::from(width);
            let v = (f64::from(row) + 0.5) / f64::from(height);
            pixels.push(f(direction(u, v)).map(|c| c as f32));
        }
    }
    EnvironmentMap {
        width,
        height,
        pixels,
    }
}

/// Radiance in a direction, constant over each texel.
///
/// # Panics
/// If the map does not have `width · height` pixels.
pub fn radiance(map: &EnvironmentMap, direction: [f64; 3]) -> [f64; 3] {
    let [column, row] = texel(direction, map.width as usize, map.height as usize);
    map.pixels[row * map.width as usize + column].map(f64::from)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::basis::{distance, evaluate, norm};
    use crate::quadrature::project_smooth;
    use crate::testing::{assert_close, directions, numbers};

    #[test]
    fn directions_are_those_of_the_convention() {
        assert_close(&direction(0.3, 0.0), &[0.0, 1.0, 0.0], 1e-15);
        assert_close(&direction(0.3, 1.0), &[0.0, -1.0, 0.0], 1e-15);
        assert_close(&direction(0.5, 0.5), &[0.0, 0.0, -1.0], 1e-15);
        assert_close(&direction(0.75, 0.5), &[1.0, 0.0, 0.0], 1e-15);
        assert_close(&direction(0.0, 0.5), &[0.0, 0.0, 1.0], 1e-15);
    }

    #[test]
    fn directions_are_those_of_the_scene() {
        for i in 0..=20u8 {
            for j in 0..=20u8 {
                let (u, v) = (f32::from(i) / 20.0, f32::from(j) / 20.0);
                let theirs = EnvironmentMap::direction(u, v).to_array().map(f64::from);
                assert_close(&theirs, &direction(f64::from(u), f64::from(v)), 1e-6);
            }
        }
    }

    #[test]
    fn every_direction_falls_into_a_texel_that_sees_it() {
        let (width, height) = (37, 18);
        for s in directions(500) {
            let [column, row] = texel(s, width, height);
            let center = direction(
                (column as f64 + 0.5) / width as f64,
                (row as f64 + 0.5) / height as f64,
            );
            // Half a texel's diagonal.
            let reach = 0.5 * (TAU / width as f64).hypot(PI / height as f64);
            assert!(crate::vec3::angle(s, center) <= reach);
        }
    }

    #[test]
    fn solid_angles_make_up_the_sphere() {
        for (width, height) in [(1, 1), (4, 2), (64, 32), (7, 101)] {
            let sum: f64 = (0..height)
                .map(|row| width as f64 * solid_angle(row, width, height))
                .sum();
            assert!((sum - 4.0 * PI).abs() < 1e-13);
        }
    }

    #[test]
    fn one_bright_texel_is_its_area() {
        // A map of 2 by 1 texels: the right one is the half sphere of +X.
        let map = EnvironmentMap {
            width: 2,
            height: 1,
            pixels: vec![[0.0; 3], [1.0, 2.0, 0.0]],
        };
        let [red, green, blue] = project(4, &map);
        let half = crate::zonal::rotated(&crate::cap::blocked(4, 0.5 * PI), [1.0, 0.0, 0.0]);
        assert_close(&red, &half, 1e-11);
        assert_close(
            &green,
            &half.iter().map(|c| 2.0 * c).collect::<Vec<_>>(),
            1e-11,
        );
        assert_eq!(blue, vec![0.0; 16]);
    }

    #[test]
    fn areas_of_coarse_maps_are_integrated_to_rounding() {
        // All texels of the same radiance: every coefficient but the first must vanish, for any order.
        let map = EnvironmentMap {
            width: 3,
            height: 2,
            pixels: vec![[1.0; 3]; 6],
        };
        let [red, ..] = project(8, &map);
        assert!((red[0] - (4.0 * PI).sqrt()).abs() < 1e-11);
        assert!(red[1..].iter().all(|c| c.abs() < 1e-11));
    }

    #[test]
    fn maps_of_band_limited_functions_return_them() {
        let f = numbers(21, 16);
        let map = map_of(128, 64, |s| [evaluate(&f, s), 1.0, 0.0]);
        for [red, green, _] in [project(4, &map), project_centers(4, &map)] {
            let off = distance(&red, &f);
            assert!(off < 2e-3 * norm(&f), "{:e}", off);
            assert!((green[0] - (4.0 * PI).sqrt()).abs() < 1e-12);
        }
    }

    #[test]
    fn finer_maps_of_smooth_functions_are_nearer_the_truth() {
        let sky = |s: [f64; 3]| (2.0 * s[0] + s[1]).exp();
        let truth = project_smooth(3, 1e-12, sky).coefficients;
        let off = |width: u32| {
            let [red, ..] = project(3, &map_of(width, width / 2, |s| [sky(s); 3]));
            distance(&red, &truth) / norm(&truth)
        };
        let (coarse, fine) = (off(16), off(64));
        assert!(
            fine < coarse / 12.0 && fine < 1e-3,
            "{coarse:e} to {fine:e}"
        );
    }

    #[test]
    fn radiance_reads_the_map() {
        let map = map_of(16, 8, |[x, y, z]| [x, y, z]);
        for s in directions(50) {
            let found = radiance(&map, s);
            assert!(crate::vec3::length(crate::vec3::sub(found, s)) < 0.4);
        }
    }
}
