//! Light from all around, as a map of radiance over directions.
//!
//! The convention, stated once: texture coordinates (u, v) in 0..1, u to the right, v downwards, see
//!
//! ```text
//! φ = 2π (u − ½)   θ = π v   direction = (sin θ sin φ, cos θ, −sin θ cos φ)
//! ```
//!
//! so the top row is +Y, the bottom row −Y, the middle of the picture −Z, and the view turns towards +X to
//! the right. The centre of texel (x, y) is u = (x + ½) / width, v = (y + ½) / height.

use glam::{Vec2, Vec3};
use std::f32::consts::{PI, TAU};

/// An equirectangular map of radiance that covers the whole sphere; see [`EnvironmentMap::direction`]
/// for which texel sees what.
///
/// ```
/// use glam::Vec3;
/// let sky = sh_scene::EnvironmentMap::constant([1.0, 2.0, 3.0]);
/// assert_eq!(sky.sample(Vec3::Y), [1.0, 2.0, 3.0]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct EnvironmentMap {
    /// Texels across.
    pub width: u32,
    /// Texels down.
    pub height: u32,
    /// Radiance, linear Rec.709, `width * height` texels, row by row from the top.
    pub pixels: Vec<[f32; 3]>,
}

impl EnvironmentMap {
    /// The same radiance from everywhere.
    pub fn constant(radiance: [f32; 3]) -> Self {
        Self {
            width: 2,
            height: 1,
            pixels: vec![radiance; 2],
        }
    }

    /// The unit direction that texture coordinates (u, v) see: φ = 2π (u − ½), θ = π v,
    /// (sin θ sin φ, cos θ, −sin θ cos φ).
    pub fn direction(u: f32, v: f32) -> Vec3 {
        let (sin_phi, cos_phi) = (TAU * (u - 0.5)).sin_cos();
        let (sin_theta, cos_theta) = (PI * v).sin_cos();
        Vec3::new(sin_theta * sin_phi, cos_theta, -sin_theta * cos_phi)
    }

    /// The texture coordinates that see `direction` (any length but zero), both in 0..=1; the inverse of
    /// [`EnvironmentMap::direction`]. θ is taken by `atan2`, which is exact at the poles where `acos` is
    /// not.
    pub fn uv(direction: Vec3) -> Vec2 {
        let across = (direction.x * direction.x + direction.z * direction.z).sqrt();
        let u = 0.5 + direction.x.atan2(-direction.z) / TAU;
        let v = across.atan2(direction.y) / PI;
        Vec2::new(u, v)
    }

    /// Radiance from `direction`: bilinear between the four nearest texel centres, around the seam in u,
    /// clamped at the poles in v.
    pub fn sample(&self, direction: Vec3) -> [f32; 3] {
        let uv = Self::uv(direction);
        let x = uv.x * self.width as f32 - 0.5;
        let y = (uv.y * self.height as f32 - 0.5).clamp(0.0, (self.height - 1) as f32);
        let (left, top) = (x.floor(), y.floor());
        let (fx, fy) = (x - left, y - top);
        // left lies in -1..=width: one turn too many or too few at most.
        let x0 = (left as i32 + self.width as i32) as u32 % self.width;
        let x1 = (x0 + 1) % self.width;
        let y0 = top as u32;
        let y1 = (y0 + 1).min(self.height - 1);
        let texel = |x: u32, y: u32| self.pixels[(y * self.width + x) as usize];
        let [a, b, c, d] = [texel(x0, y0), texel(x1, y0), texel(x0, y1), texel(x1, y1)];
        std::array::from_fn(|i| {
            let upper = a[i] + (b[i] - a[i]) * fx;
            let lower = c[i] + (d[i] - c[i]) * fx;
            upper + (lower - upper) * fy
        })
    }

    /// The map turned about +Y by `angle` radians, counter-clockwise seen from above: what was in direction
    /// d is then in direction R d. Between two columns the turned map interpolates.
    pub fn rotated(&self, angle: f32) -> Self {
        let mut turned = Self {
            width: 0,
            height: 0,
            pixels: Vec::new(),
        };
        self.rotated_into(angle, &mut turned);
        turned
    }

    /// As [`rotated`](Self::rotated), written over `turned`, whose room is used again.
    pub fn rotated_into(&self, angle: f32, turned: &mut Self) {
        // R turns +Z towards +X and with it φ to φ − angle: output column x shows column x + shift.
        let shift = (angle / TAU).rem_euclid(1.0) * self.width as f32;
        let (whole, part) = (shift.floor() as usize, shift - shift.floor());
        let width = self.width as usize;
        let whole = whole % width;
        (turned.width, turned.height) = (self.width, self.height);
        turned.pixels.clear();
        turned.pixels.reserve(self.pixels.len());
        let mix = |a: &[f32; 3], b: &[f32; 3]| std::array::from_fn(|i| a[i] + (b[i] - a[i]) * part);
        for row in self.pixels.chunks_exact(width) {
            // The columns from `whole` on, the seam, and those before it, each with its right neighbour.
            let pairs = row.array_windows().map(|[a, b]| mix(a, b));
            turned.pixels.extend(pairs.clone().skip(whole));
            turned.pixels.push(mix(&row[width - 1], &row[0]));
            turned.pixels.extend(pairs.take(whole));
        }
    }

    /// The map with every texel multiplied by `factor`.
    pub fn scaled(mut self, factor: f32) -> Self {
        for pixel in &mut self.pixels {
            *pixel = pixel.map(|c| c * factor);
        }
        self
    }

    /// Irradiance that the half of the map above the horizon gives a horizontal surface, divided by π: the
    /// radiance reflected by albedo 1. Texels count as constant, cosine and solid angle are integrated
    /// exactly over each: ∫∫ cos θ sin θ dθ dφ = ½ [sin² θ] Δφ. A row that straddles the horizon counts with
    /// its upper part.
    pub fn upper_irradiance(&self) -> [f64; 3] {
        let mut sum = [0.0; 3];
        let rows = self.pixels.chunks_exact(self.width as usize).enumerate();
        for (y, row) in rows {
            let edge =
                |y: usize| std::f64::consts::PI * (y as f64 / f64::from(self.height)).min(0.5);
            let (upper, lower) = (edge(y).sin(), edge(y + 1).sin());
            let weight = (lower * lower - upper * upper) / f64::from(self.width);
            for pixel in row {
                for (sum, &value) in sum.iter_mut().zip(pixel) {
                    *sum += weight * f64::from(value);
                }
            }
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbered(width: u32, height: u32) -> EnvironmentMap {
        let pixels = (0..width * height)
            .map(|i| [i as f32, (i * i % 17) as f32, 1.0])
            .collect();
        EnvironmentMap {
            width,
            height,
            pixels,
        }
    }

    #[test]
    fn axes_are_where_the_convention_puts_them() {
        let near = |a: Vec3, b: Vec3| assert!(a.distance(b) < 1e-6, "{a} is not {b}");
        near(EnvironmentMap::direction(0.5, 0.5), Vec3::NEG_Z);
        near(EnvironmentMap::direction(0.75, 0.5), Vec3::X);
        near(EnvironmentMap::direction(0.25, 0.5), Vec3::NEG_X);
        near(EnvironmentMap::direction(0.3, 0.0), Vec3::Y);
        near(EnvironmentMap::direction(0.3, 1.0), Vec3::NEG_Y);
    }

    #[test]
    fn uv_undoes_direction() {
        for (u, v) in [
            (0.01, 0.02),
            (0.3, 0.5),
            (0.99, 0.9),
            (0.5, 0.25),
            (0.7, 0.999),
        ] {
            let back = EnvironmentMap::uv(EnvironmentMap::direction(u, v) * 3.0);
            assert!(
                (back - Vec2::new(u, v)).length() < 1e-5,
                "({u}, {v}) became {back}"
            );
        }
    }

    #[test]
    fn a_texel_centre_gives_its_texel() {
        let map = numbered(8, 5);
        for y in 0..5 {
            for x in 0..8 {
                let (u, v) = ((x as f32 + 0.5) / 8.0, (y as f32 + 0.5) / 5.0);
                let seen = map.sample(EnvironmentMap::direction(u, v));
                let texel = map.pixels[y * 8 + x];
                assert!((seen[0] - texel[0]).abs() < 1e-3, "({x}, {y}): {seen:?}");
                assert!((seen[1] - texel[1]).abs() < 1e-3, "({x}, {y}): {seen:?}");
            }
        }
    }

    #[test]
    fn the_seam_is_interpolated_and_the_poles_are_clamped() {
        let map = EnvironmentMap {
            width: 2,
            height: 1,
            pixels: vec![[0.0; 3], [4.0; 3]],
        };
        let seam = map.sample(Vec3::new(1e-6, 0.0, 1.0))[0];
        assert!((seam - 2.0).abs() < 1e-3, "{seam}");
        assert!(map.sample(Vec3::Y)[0].is_finite());
        assert!(map.sample(Vec3::NEG_Y)[0].is_finite());
    }

    #[test]
    fn rotation_carries_directions_along() {
        let map = numbered(12, 4);
        let angle = TAU * 5.0 / 12.0;
        let turned = map.rotated(angle);
        let rotation = glam::Quat::from_rotation_y(angle);
        for i in 0..12 {
            let d = EnvironmentMap::direction((i as f32 + 0.5) / 12.0, 0.6);
            let (before, after) = (map.sample(d), turned.sample(rotation * d));
            assert!(
                (before[0] - after[0]).abs() < 1e-2,
                "column {i}: {before:?} {after:?}"
            );
        }
        assert_eq!(map.rotated(0.0), map);
    }

    #[test]
    fn irradiance_from_a_constant_sky_is_its_radiance() {
        for height in [1, 2, 5, 64] {
            let map = EnvironmentMap {
                width: 3,
                height,
                pixels: vec![[2.0; 3]; 3 * height as usize],
            };
            for c in map.upper_irradiance() {
                assert!((c - 2.0).abs() < 1e-12, "{height} rows: {c}");
            }
        }
    }
}
