//! A clear sky with a sun, in closed form.
//!
//! The sky is the daylight model of Preetham, Shirley and Smits 1999 ("A practical analytic model for
//! daylight"): luminance and the two chromaticities each follow Perez' function
//! F(θ, γ) = (1 + A e^(B / cos θ)) (1 + C e^(D γ) + E cos² γ) of the angles from the zenith and from the
//! sun, scaled to a value at the zenith; A to E and the zenith are polynomials in turbidity and the sun's
//! height (their appendix A.2). The sun's irradiance is the solar illuminance constant, 128 klx, dimmed by
//! Rayleigh and aerosol scattering along the path through the atmosphere (their appendix A.1) at one
//! wavelength for each of red, green and blue.
//!
//! A texel is far wider than the sun and a spherical harmonic of order 6 wider still, so the disc is
//! widened to a few degrees with a soft rim; its irradiance is kept exactly.

use crate::EnvironmentMap;
use glam::{DMat3, DVec3, Vec3};
use std::f64::consts::{FRAC_PI_2, PI};

/// A clear sky with a sun.
///
/// ```
/// let sky = sh_scene::Sky::default().map(64, 32);
/// let horizontal = sky.upper_irradiance();
/// // Scaled so that a white horizontal surface in the open has luminance 1.
/// let [r, g, b] = horizontal;
/// assert!((0.2126 * r + 0.7152 * g + 0.0722 * b - 1.0).abs() < 1e-3);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sky {
    /// Towards the sun. Any length but zero; a sun below 3° is taken as standing at 3°, where the model
    /// ends.
    pub sun: Vec3,
    /// Haze: 2 is very clear, 6 is hazy. Held to 1.9..=10, where the model is valid.
    pub turbidity: f64,
    /// Reflectance of the land below the horizon, which the map shows as a plain colour.
    pub land: [f64; 3],
}

impl Default for Sky {
    /// A summer morning: the sun at 42°, behind the left shoulder of who looks along −Z.
    fn default() -> Self {
        Self {
            sun: Vec3::new(-0.62, 0.72, 0.50),
            turbidity: 2.2,
            land: [0.30, 0.29, 0.27],
        }
    }
}

/// Angular radius of the sun's widened disc, in radians; the rim fades over the outer half.
const DISC: f64 = 0.06;

/// Wavelengths that stand for linear Rec.709 red, green and blue, in micrometres.
const WAVELENGTHS: [f64; 3] = [0.610, 0.550, 0.465];

/// Illuminance of the sun outside the atmosphere, in kilolux.
const SOLAR_CONSTANT: f64 = 128.0;

impl Sky {
    /// The sky as a map of `width` by `height` texels (each at least 1), scaled so that a white horizontal
    /// surface in the open reflects luminance 1.
    pub fn map(&self, width: u32, height: u32) -> EnvironmentMap {
        let model = Model::new(self);
        let (width, height) = (width.max(1), height.max(1));
        let mut sky = Vec::with_capacity(width as usize * height as usize);
        let mut disc = Vec::with_capacity(sky.capacity());
        for y in 0..height {
            for x in 0..width {
                let d = EnvironmentMap::direction(
                    (x as f32 + 0.5) / width as f32,
                    (y as f32 + 0.5) / height as f32,
                );
                sky.push(model.radiance(d.as_dvec3()));
                disc.push(model.disc(d.as_dvec3()));
            }
        }
        add_sun(&mut sky, &disc, model.sun_irradiance(), width, height);

        let mut map = EnvironmentMap {
            width,
            height,
            pixels: sky.iter().map(|c| c.as_vec3().to_array()).collect(),
        };
        let up = map.upper_irradiance();
        let exposure = 1.0 / (0.2126 * up[0] + 0.7152 * up[1] + 0.0722 * up[2]);
        map = map.scaled(exposure as f32);
        let land = std::array::from_fn(|i| (self.land[i] * up[i] * exposure) as f32);
        // Rows whose centre lies below the horizon.
        let first_below = height.div_ceil(2) * width;
        map.pixels[first_below as usize..].fill(land);
        map
    }
}

/// Spreads the sun's irradiance (on a surface that faces it) over the texels of its disc.
fn add_sun(sky: &mut [DVec3], disc: &[f64], irradiance: DVec3, width: u32, height: u32) {
    let solid_angle = |texel: usize| {
        let edge = |y: usize| (PI * y as f64 / f64::from(height)).cos();
        let y = texel / width as usize;
        (edge(y) - edge(y + 1)) * 2.0 * PI / f64::from(width)
    };
    let total: f64 = disc
        .iter()
        .enumerate()
        .map(|(i, &d)| d * solid_angle(i))
        .sum();
    if total > 0.0 {
        for (texel, &d) in sky.iter_mut().zip(disc) {
            *texel += irradiance * (d / total);
        }
    } else if let Some(nearest) = (0..disc.len()).max_by(|&a, &b| disc[a].total_cmp(&disc[b])) {
        // Texels so wide that none has its centre in the disc.
        sky[nearest] += irradiance / solid_angle(nearest);
    }
}

/// Perez' five parameters.
struct Perez([f64; 5]);

impl Perez {
    fn new(turbidity: f64, slopes: [f64; 5], constants: [f64; 5]) -> Self {
        Self(std::array::from_fn(|i| {
            slopes[i] * turbidity + constants[i]
        }))
    }

    /// F(θ, γ) by their cosines and γ.
    fn at(&self, cos_theta: f64, gamma: f64) -> f64 {
        let [a, b, c, d, e] = self.0;
        (1.0 + a * (b / cos_theta).exp()) * (1.0 + c * (d * gamma).exp() + e * gamma.cos().powi(2))
    }
}

/// The model with everything that does not depend on the direction worked out.
struct Model {
    sun: DVec3,
    turbidity: f64,
    /// Luminance, then chromaticities x and y.
    perez: [Perez; 3],
    /// The zenith's, divided by F(0, θ_sun).
    scale: [f64; 3],
}

impl Model {
    fn new(sky: &Sky) -> Self {
        let t = sky.turbidity.clamp(1.9, 10.0);
        let lowest = 3.0_f64.to_radians().sin();
        let sun = sky.sun.as_dvec3().normalize_or(DVec3::Y);
        let y = sun.y.max(lowest);
        let flat =
            DVec3::new(sun.x, 0.0, sun.z).normalize_or_zero() * f64::max(1.0 - y * y, 0.0).sqrt();
        let sun = (flat + DVec3::Y * y).normalize();
        let s = sun.y.acos();

        let perez = [
            Perez::new(
                t,
                [0.1787, -0.3554, -0.0227, 0.1206, -0.0670],
                [-1.4630, 0.4275, 5.3251, -2.5771, 0.3703],
            ),
            Perez::new(
                t,
                [-0.0193, -0.0665, -0.0004, -0.0641, -0.0033],
                [-0.2592, 0.0008, 0.2125, -0.8989, 0.0452],
            ),
            Perez::new(
                t,
                [-0.0167, -0.0950, -0.0079, -0.0441, -0.0109],
                [-0.2608, 0.0092, 0.2102, -1.6537, 0.0529],
            ),
        ];
        let chi = (4.0 / 9.0 - t / 120.0) * (PI - 2.0 * s);
        let luminance = ((4.0453 * t - 4.9710) * chi.tan() - 0.2155 * t + 2.4192).max(0.0);
        let cubic = |c: [f64; 4]| ((c[0] * s + c[1]) * s + c[2]) * s + c[3];
        let x = t * t * cubic([0.00166, -0.00375, 0.00209, 0.0])
            + t * cubic([-0.02903, 0.06377, -0.03202, 0.00394])
            + cubic([0.11693, -0.21196, 0.06052, 0.25886]);
        let y = t * t * cubic([0.00275, -0.00610, 0.00317, 0.0])
            + t * cubic([-0.04214, 0.08970, -0.04153, 0.00516])
            + cubic([0.15346, -0.26756, 0.06670, 0.26688]);
        let zenith = [luminance, x, y];
        let scale = std::array::from_fn(|i| zenith[i] / perez[i].at(1.0, s));
        Self {
            sun,
            turbidity: t,
            perez,
            scale,
        }
    }

    /// Radiance of the sky, without the sun's disc, in kcd/m². Below the horizon it is that of the horizon.
    fn radiance(&self, direction: DVec3) -> DVec3 {
        let flat =
            DVec3::new(direction.x, direction.y.max(0.0), direction.z).normalize_or(DVec3::Y);
        let gamma = flat.dot(self.sun).clamp(-1.0, 1.0).acos();
        // Perez' 1 / cos θ: held away from the horizon's pole, where B < 0 has made the term vanish.
        let cos_theta = flat.y.max(0.01);
        let [luminance, x, y] =
            std::array::from_fn(|i| self.scale[i] * self.perez[i].at(cos_theta, gamma));
        rec709(x, y, luminance.max(0.0))
    }

    /// How bright the sun's disc is in `direction`, 1 in its middle.
    fn disc(&self, direction: DVec3) -> f64 {
        let gamma = direction.dot(self.sun).clamp(-1.0, 1.0).acos();
        let t = ((DISC - gamma) / (0.5 * DISC)).clamp(0.0, 1.0);
        t * t * (3.0 - 2.0 * t)
    }

    /// Irradiance of the sun on a surface that faces it, in klx, by colour.
    fn sun_irradiance(&self) -> DVec3 {
        let height = FRAC_PI_2 - self.sun.y.acos();
        // Relative optical mass, Kasten's formula as Preetham et al. give it (degrees).
        let mass = 1.0 / (self.sun.y + 0.15 * (height.to_degrees() + 3.885).powf(-1.253));
        let haze = 0.04608 * self.turbidity - 0.04586;
        DVec3::from(WAVELENGTHS.map(|w| {
            let rayleigh = 0.008735 * w.powf(-4.08);
            let aerosol = haze * w.powf(-1.3);
            SOLAR_CONSTANT * (-(rayleigh + aerosol) * mass).exp()
        }))
    }
}

/// Linear Rec.709 from CIE xyY; a colour outside the gamut is cut at its border.
fn rec709(x: f64, y: f64, luminance: f64) -> DVec3 {
    let xyz = DVec3::new(x, y, 1.0 - x - y) * (luminance / y);
    // Rows of IEC 61966-2-1's XYZ to RGB.
    let rgb_from_xyz = DMat3::from_cols(
        DVec3::new(3.2404542, -0.9692660, 0.0556434),
        DVec3::new(-1.5371385, 1.8760108, -0.2040259),
        DVec3::new(-0.4985314, 0.0415560, 1.0572252),
    );
    (rgb_from_xyz * xyz).max(DVec3::ZERO)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_sky_is_finite_positive_and_normalised() {
        for turbidity in [0.0, 1.9, 3.0, 10.0, 50.0] {
            for sun in [
                Vec3::Y,
                Vec3::new(1.0, 0.3, 0.2),
                Vec3::X,
                Vec3::NEG_Y,
                Vec3::ZERO,
            ] {
                let map = Sky {
                    sun,
                    turbidity,
                    ..Sky::default()
                }
                .map(64, 32);
                assert!(
                    map.pixels
                        .iter()
                        .flatten()
                        .all(|c| c.is_finite() && *c >= 0.0)
                );
                let up = map.upper_irradiance();
                let luminance = 0.2126 * up[0] + 0.7152 * up[1] + 0.0722 * up[2];
                assert!(
                    (luminance - 1.0).abs() < 1e-3,
                    "{sun} {turbidity}: {luminance}"
                );
            }
        }
    }

    #[test]
    fn the_sun_stands_where_it_was_put() {
        let sky = Sky::default();
        let map = sky.map(256, 128);
        let luminance = |p: &[f32; 3]| p[0] + p[1] + p[2];
        let brightest = (0..map.pixels.len())
            .max_by(|&a, &b| luminance(&map.pixels[a]).total_cmp(&luminance(&map.pixels[b])))
            .unwrap();
        let (x, y) = (brightest % 256, brightest / 256);
        let d = EnvironmentMap::direction((x as f32 + 0.5) / 256.0, (y as f32 + 0.5) / 128.0);
        assert!(d.angle_between(sky.sun) < DISC as f32, "{d}");
    }

    #[test]
    fn irradiance_does_not_depend_on_the_size_of_the_map() {
        let ratio = |w, h| {
            let up = Sky::default().map(w, h).upper_irradiance();
            up[2] / up[0]
        };
        let (coarse, fine) = (ratio(64, 32), ratio(512, 256));
        assert!((coarse / fine - 1.0).abs() < 0.03, "{coarse} {fine}");
    }

    #[test]
    fn the_sky_is_blue_and_the_sun_is_warm() {
        let model = Model::new(&Sky::default());
        let zenith = model.radiance(DVec3::Y);
        assert!(zenith.z > 1.5 * zenith.x, "{zenith}");
        let sun = model.sun_irradiance();
        assert!(sun.x > sun.y && sun.y > sun.z, "{sun}");
        // A clear day: 60 to 110 klx from the sun at 42°, some klx/sr from the zenith.
        assert!(sun.y > 60.0 && sun.y < 110.0, "{sun}");
    }
}
