//! How a lamp's brightness is spread over its surface.
//!
//! A glowing ball is a spherical light whose emission is given instead of gathered (Guerrero et al. 2008, section 7.3):
//! an SH function of the direction from its centre says how bright the surface is there. What a receiver gets is the mean
//! over what it sees of the ball (equations 16 to 18), weighed band by band, which dims what the order cannot show
//! anyway: no window is needed. Where a sum of bands is below 0 it counts as 0.

use crate::{EnvironmentMap, LightError};
use glam::{Quat, Vec3};
use sh_core::constants::{MAX_ORDER, MOST_COEFFICIENTS};
use sh_core::{Routines, ShRgb, cap, project};
use std::f64::consts::PI;

/// How bright each part of a ball's surface is, in parts of its light's radiance: red, green and blue, as SH functions of
/// the direction from the ball's centre.
///
/// ```
/// use glam::Vec3;
/// use sh_scene::Distribution;
/// let lower_half = Distribution::cap(Vec3::NEG_Y, std::f32::consts::FRAC_PI_2)?;
/// assert!(lower_half.at(Vec3::NEG_Y)[0] > 0.9 && lower_half.at(Vec3::Y)[0] < 0.1);
/// # Ok::<(), sh_scene::LightError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distribution {
    coefficients: [[f32; 3]; MOST_COEFFICIENTS],
}

impl Distribution {
    /// That of these coefficients, index l·l + l + m: 1, 4, 9, 16, 25 or 36 of them. √4π, alone, is an even ball.
    ///
    /// # Errors
    /// Where there are not as many as an order from 1 to 6 has, or one is not finite.
    pub fn new(coefficients: &[[f32; 3]]) -> Result<Self, LightError> {
        let count = coefficients.len();
        let is_order = (1..=MAX_ORDER).any(|order| order * order == count);
        if !is_order || coefficients.iter().flatten().any(|c| !c.is_finite()) {
            return Err(LightError::Distribution);
        }
        let mut all = [[0.0; 3]; MOST_COEFFICIENTS];
        all[..count].copy_from_slice(coefficients);
        Ok(Self { coefficients: all })
    }

    /// A ball that glows within an angle about a direction, and is dark elsewhere: a lamp with a shade.
    ///
    /// # Errors
    /// Where the direction has no length, or the angle is not above 0 and at most π.
    pub fn cap(direction: Vec3, angle: f32) -> Result<Self, LightError> {
        let unit = direction.try_normalize().ok_or(LightError::Direction)?;
        if !(angle > 0.0 && angle <= std::f32::consts::PI) {
            return Err(LightError::Spread(angle));
        }
        // What a cap hides of the sky is what it shows of the ball.
        let dark = cap::visibility::<MOST_COEFFICIENTS>(f64::from(angle));
        let zonal = std::array::from_fn(|l| match l {
            0 => PI.sqrt() * (1.0 - f64::from(angle).cos()),
            l => -dark[l],
        });
        let lit = <[f64; MOST_COEFFICIENTS]>::zonal(zonal, unit.to_array().map(f64::from));
        Ok(Self {
            coefficients: lit.map(|c| [c as f32; 3]),
        })
    }

    /// As bright in every direction as a map is there.
    ///
    /// ```
    /// # use sh_scene::{Distribution, EnvironmentMap};
    /// let gray = Distribution::of_map(&EnvironmentMap::constant([0.5; 3]));
    /// assert!((gray.at(glam::Vec3::X)[1] - 0.5).abs() < 1e-6);
    /// ```
    pub fn of_map(map: &EnvironmentMap) -> Self {
        let (width, height) = (map.width as usize, map.height as usize);
        let texel = |x: usize, y: usize| map.pixels[x + y * width];
        let ShRgb { r, g, b } = project::equirectangular::<MOST_COEFFICIENTS>(width, height, texel);
        Self {
            coefficients: std::array::from_fn(|i| [r.0[i], g.0[i], b.0[i]].map(|c| c as f32)),
        }
    }

    /// All 36 coefficients.
    pub fn coefficients(&self) -> &[[f32; 3]; MOST_COEFFICIENTS] {
        &self.coefficients
    }

    /// The brightness in a direction from the centre, of unit length; not below 0.
    pub fn at(&self, direction: Vec3) -> [f32; 3] {
        let basis = <[f32; MOST_COEFFICIENTS]>::basis(direction.to_array());
        let mut sum = [0.0; 3];
        for (y, coefficient) in basis.iter().zip(&self.coefficients) {
            for (sum, c) in sum.iter_mut().zip(coefficient) {
                *sum += y * c;
            }
        }
        sum.map(|c: f32| c.max(0.0))
    }

    /// The same on a ball that is turned.
    pub fn turned(&self, rotation: Quat) -> Self {
        let channel = |c: usize| -> [f32; MOST_COEFFICIENTS] {
            let own: [f32; MOST_COEFFICIENTS] = self.coefficients.map(|k| k[c]);
            own.rotate(rotation.to_array())
        };
        let [red, green, blue] = [0, 1, 2].map(channel);
        Self {
            coefficients: std::array::from_fn(|i| [red[i], green[i], blue[i]]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cap_is_what_a_map_of_it_gives() {
        let (direction, angle) = (Vec3::new(0.3, -0.8, 0.5).normalize(), 1.1_f32);
        let (width, height) = (512, 256);
        let pixels = (0..width * height).map(|i| {
            let (u, v) = ((i % width) as f32 + 0.5, (i / width) as f32 + 0.5);
            let d = EnvironmentMap::direction(u / width as f32, v / height as f32);
            [f32::from(u8::from(d.dot(direction) > angle.cos())); 3]
        });
        let map = EnvironmentMap {
            width: width as u32,
            height: height as u32,
            pixels: pixels.collect(),
        };
        let cap = Distribution::cap(direction * 7.0, angle).unwrap();
        let of_map = Distribution::of_map(&map);
        for (a, b) in cap.coefficients().iter().zip(of_map.coefficients()) {
            // The map's edge of whole texels.
            assert!((a[0] - b[0]).abs() < 4e-3, "{a:?} {b:?}");
        }
        // All of the ball is an even one.
        let all = Distribution::cap(Vec3::X, std::f32::consts::PI).unwrap();
        assert!((all.coefficients()[0][0] - (4.0 * PI).sqrt() as f32).abs() < 1e-6);
        assert!(
            all.coefficients()[1..]
                .iter()
                .flatten()
                .all(|c| c.abs() < 1e-6)
        );
    }

    #[test]
    fn turning_takes_the_bright_side_along() {
        let lit = Distribution::cap(Vec3::Z, 0.7).unwrap();
        let turn = Quat::from_rotation_y(1.0) * Quat::from_rotation_x(0.4);
        let turned = lit.turned(turn);
        let direct = Distribution::cap(turn * Vec3::Z, 0.7).unwrap();
        for (a, b) in turned.coefficients().iter().zip(direct.coefficients()) {
            assert!((a[1] - b[1]).abs() < 2e-6, "{a:?} {b:?}");
        }
    }

    #[test]
    fn what_is_no_distribution_is_refused() {
        for count in [0, 2, 3, 5, 15, 37, 49] {
            let many = vec![[1.0; 3]; count];
            assert_eq!(
                Distribution::new(&many),
                Err(LightError::Distribution),
                "{count}"
            );
        }
        assert!(Distribution::new(&[[1.0; 3]]).is_ok());
        assert!(Distribution::new(&[[f32::NAN, 0.0, 0.0]]).is_err());
        assert!(Distribution::cap(Vec3::ZERO, 1.0).is_err());
        for angle in [0.0, -1.0, 3.2, f32::NAN] {
            assert!(Distribution::cap(Vec3::X, angle).is_err(), "{angle}");
        }
    }
}
