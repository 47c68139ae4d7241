//! The sun of an environment map as a light of its own: what spherical harmonics blur over a quarter of the sky.

use crate::{EnvironmentMap, PunctualLight, PunctualShape};
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// Within this of the brightest texel lies the sun, in radians: 5°. Glare around it may reach as far.
const REACH: f64 = 5.0 * PI / 180.0;

/// The ring up to here, twice as wide, says how bright the sky is that the sun stands before.
const RING: f64 = 2.0 * REACH;

/// How many times as bright as that a texel of the sun is.
const TIMES: f64 = 4.0;

/// The least part of a map's light that is a sun: less is a lamp or a cloud's edge, and may stay where it is.
const LEAST: f64 = 0.02;

/// The angular radius of the sun, in radians: none is smaller, whatever texels say.
const SUN: f64 = 0.00465;

/// A map without its sun, and that as a light.
#[derive(Clone, Debug, PartialEq)]
pub struct Lifted {
    /// The sky behind it in its place.
    pub map: EnvironmentMap,
    /// The sun, with the irradiance that the map has lost.
    pub sun: PunctualLight,
    /// The part of the map's light that it was, in all directions together, 0 to 1.
    pub share: f64,
}

impl EnvironmentMap {
    /// The map's sun taken out of it: what within 5° of its brightest texel is four times as bright as the sky around. None where that is less
    /// than a fiftieth of the map's light.
    ///
    /// ```
    /// use sh_scene::{PunctualShape, Sky};
    /// let sky = Sky::default();
    /// let lifted = sky.map(256, 128).lift_sun().expect("it shines");
    /// let PunctualShape::Sun { direction, .. } = lifted.sun.shape else { unreachable!() };
    /// assert!(direction.angle_between(sky.sun) < 0.01);
    /// ```
    pub fn lift_sun(&self) -> Option<Lifted> {
        let brightest = |pixel: &[f32; 3]| luminance(pixel.map(f64::from));
        let brightest = (0..self.pixels.len())
            .max_by(|a, b| brightest(&self.pixels[*a]).total_cmp(&brightest(&self.pixels[*b])))?;
        let middle = self.seen(brightest);
        let (mut sky, mut around, mut whole) = ([0.0; 3], 0.0, 0.0);
        for (index, pixel) in self.pixels.iter().enumerate() {
            let (pixel, size) = (pixel.map(f64::from), self.size(index));
            whole += luminance(pixel) * size;
            let cosine = self.seen(index).dot(middle);
            if cosine <= REACH.cos() && cosine > RING.cos() {
                around += size;
                for (sky, pixel) in sky.iter_mut().zip(pixel) {
                    *sky += size * pixel;
                }
            }
        }
        if around == 0.0 {
            return None;
        }
        let sky = sky.map(|c| c / around);
        let mut map = self.clone();
        let (mut towards, mut taken) = (DVec3::ZERO, Vec::new());
        for (index, pixel) in map.pixels.iter_mut().enumerate() {
            let (radiance, direction) = (pixel.map(f64::from), self.seen(index));
            let bright = luminance(radiance) > TIMES * luminance(sky);
            if !bright || direction.dot(middle) < REACH.cos() {
                continue;
            }
            let size = self.size(index);
            let over = [0, 1, 2].map(|c| (radiance[c] - sky[c]).max(0.0) * size);
            *pixel = [0, 1, 2].map(|c| radiance[c].min(sky[c]) as f32);
            towards += direction * luminance(over);
            taken.push((direction, over));
        }
        let direction = towards.try_normalize()?;
        let (mut irradiance, mut lost, mut spread) = ([0.0; 3], 0.0, 0.0);
        for (from, over) in taken {
            let cosine = from.dot(direction);
            lost += luminance(over);
            spread += luminance(over) * 2.0 * (1.0 - cosine);
            for (sum, over) in irradiance.iter_mut().zip(over) {
                *sum += over * cosine;
            }
        }
        let share = lost / whole;
        if share.is_nan() || share < LEAST {
            return None;
        }
        // The mean square of the angle is half that of a disc's radius; a texel's own is a sixth of its square.
        let texel = PI / f64::from(self.height);
        let square = 2.0 * (spread / lost - texel * texel / 6.0);
        let shape = PunctualShape::Sun {
            direction: direction.as_vec3(),
            angle: square.max(SUN * SUN).sqrt().min(REACH) as f32,
        };
        let sun = PunctualLight::new(shape, irradiance.map(|c| c as f32));
        Some(Lifted { map, sun, share })
    }

    /// The direction that the middle of a texel sees.
    fn seen(&self, index: usize) -> DVec3 {
        let (width, height) = (self.width as usize, self.height as usize);
        let turn = TAU * ((index % width) as f64 + 0.5) / width as f64 - PI;
        let tilt = PI * ((index / width) as f64 + 0.5) / height as f64;
        let ((sin, cos), (flat, up)) = (turn.sin_cos(), tilt.sin_cos());
        DVec3::new(flat * sin, up, -flat * cos)
    }

    /// The solid angle of a texel.
    fn size(&self, index: usize) -> f64 {
        let edge = |row: usize| (PI * row as f64 / f64::from(self.height)).cos();
        let row = index / self.width as usize;
        TAU / f64::from(self.width) * (edge(row) - edge(row + 1))
    }
}

/// Of linear Rec.709.
fn luminance([r, g, b]: [f64; 3]) -> f64 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Sky;

    fn irradiance(map: &EnvironmentMap, normal: DVec3) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (index, pixel) in map.pixels.iter().enumerate() {
            let cosine = map.seen(index).dot(normal).max(0.0) * map.size(index);
            for (sum, pixel) in sum.iter_mut().zip(pixel) {
                *sum += cosine * f64::from(*pixel);
            }
        }
        sum
    }

    /// What surfaces get of both together is what they got of the map, wherever they face.
    #[test]
    fn a_sun_that_is_lifted_keeps_its_light() {
        let map = Sky::default().map(512, 256);
        let lifted = map.lift_sun().unwrap();
        let PunctualShape::Sun { direction, angle } = lifted.sun.shape else {
            panic!("{:?}", lifted.sun);
        };
        assert!((0.02..0.06).contains(&angle), "{angle}");
        assert!((0.2..0.9).contains(&lifted.share), "{}", lifted.share);
        for normal in [
            DVec3::Y,
            direction.as_dvec3(),
            DVec3::new(-0.8, 0.1, 0.6).normalize(),
        ] {
            let (before, after) = (irradiance(&map, normal), irradiance(&lifted.map, normal));
            let cosine = direction.as_dvec3().dot(normal).max(0.0);
            for c in 0..3 {
                let both = after[c] + cosine * f64::from(lifted.sun.intensity[c]);
                assert!(
                    (both / before[c] - 1.0).abs() < 2e-3,
                    "{both} of {}",
                    before[c]
                );
                assert!(after[c] < 0.8 * before[c] || cosine < 0.3);
            }
        }
        // Nothing is left to lift.
        assert!(lifted.map.lift_sun().is_none());
    }

    #[test]
    fn skies_without_a_sun_have_none() {
        assert!(EnvironmentMap::constant([1.0; 3]).lift_sun().is_none());
        assert!(EnvironmentMap::constant([0.0; 3]).lift_sun().is_none());
        let mut lamp = EnvironmentMap {
            width: 64,
            height: 32,
            pixels: vec![[1.0; 3]; 64 * 32],
        };
        lamp.pixels[64 * 16 + 9] = [9.0; 3];
        assert!(lamp.lift_sun().is_none(), "a small lamp");
        lamp.pixels[64 * 16 + 9] = [2e3; 3];
        let lifted = lamp.lift_sun().unwrap();
        assert!(lifted.map.pixels.iter().all(|p| p[1] <= 1.0));
        let PunctualShape::Sun { angle, .. } = lifted.sun.shape else {
            panic!("{:?}", lifted.sun);
        };
        // A texel alone is as small as may be.
        assert!((angle - SUN as f32).abs() < 1e-4, "{angle}");
    }
}
