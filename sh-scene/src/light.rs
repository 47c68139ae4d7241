//! Environment light as SH vectors.

use crate::{AreaLight, Emitter, EnvironmentMap, Ground};
use sh_core::{OrderError, Routines, ShRgb, for_order, project};

/// All light of a scene, ready for the passes: an environment's radiance as three SH vectors of one order,
/// windowed, and analytic lights.
///
/// Nothing in it is tabulated: an environment that changes every frame costs no more than one that stands still.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// SH order, 2 to 6.
    pub order: usize,
    /// `order²` coefficients, each red, green and blue.
    pub coefficients: Vec<[f32; 3]>,
    /// Discs in the sky and glowing balls.
    pub emitters: Vec<Emitter>,
}

/// Why there is no light of the kind asked for.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LightError {
    /// An order without routines.
    #[error(transparent)]
    Order(#[from] OrderError),
    /// A window without width.
    #[error("the window's width is {0}, but it has to be above 0 (twice the order is usual)")]
    Window(f32),
    /// A light whose radiance is none.
    #[error("a light's radiance is {0:?}, but it has to be finite and not negative")]
    Radiance([f32; 3]),
    /// A distant light that is no disc.
    #[error("a light's angular radius is {} degrees, but it has to be above 0 and at most 90", .0.to_degrees())]
    Angle(f32),
    /// A distant light that is nowhere.
    #[error("a light's direction has no length, or one that is not finite")]
    Direction,
    /// A local light that is no ball.
    #[error("a light's centre and radius have to be finite, and its radius above 0")]
    Ball,
    /// A distribution that is none, or that a distant light has.
    #[error(
        "a light's distribution has to be 1, 4, 9, 16, 25 or 36 finite SH coefficients, and only a ball has one"
    )]
    Distribution,
    /// The part of a ball that glows is none.
    #[error("the glowing part of a light spreads over {} degrees, but it has to be above 0 and at most 180", .0.to_degrees())]
    Spread(f32),
    /// A light with sharp shadows that is darker than dark.
    #[error("a light's intensity is {0:?}, but it has to be finite and not negative")]
    Intensity([f32; 3]),
    /// A spot that has no cone.
    #[error("a spot's cone is {} degrees wide and fades over {blend} of that, but it has to be above 0 and below 180, over 0 to 1", .angle.to_degrees())]
    Cone {
        /// The angle of the cone, in radians.
        angle: f32,
        /// The part over which it fades.
        blend: f32,
    },
    /// A spot or point that is no ball.
    #[error("a light's position and radius have to be finite, and its radius not negative")]
    Size,
    /// A sun that is too large.
    #[error("a sun's angular radius is {} degrees, but it has to be 0 to 45", .0.to_degrees())]
    Sun(f32),
    /// A light that is bound to an object, where it has to be placed in the world.
    #[error(
        "a light is bound to an object, but its place in the world is needed: `placed` tells it"
    )]
    Unplaced,
    /// A light that is bound to what is not there, or that is at infinity.
    #[error(
        "a light is bound to object {object} of {objects}, counted from 0, but it has to be a ball and an object that there is"
    )]
    Bound {
        /// Which object it names.
        object: usize,
        /// How many there are.
        objects: usize,
    },
}

impl Light {
    /// Projects a map. Where there is a `ground`, everything below the horizon is what the ground shows:
    /// its albedo times the unshadowed irradiance from the upper half, over π. `window` is the width h of
    /// the cosine window cos(π/2 · l/h) of Ren et al. 2006, section 7; infinity leaves the light as it is.
    ///
    /// # Errors
    /// For an order other than 2 to 6, or a window that is not above 0.
    ///
    /// ```
    /// use sh_scene::{EnvironmentMap, Light};
    /// let light = Light::project(&EnvironmentMap::constant([2.0; 3]), None, 4, 8.0)?;
    /// // A white surface under a constant sky is as bright as the sky.
    /// assert!((light.irradiance([0.0, 1.0, 0.0])[0] - 2.0).abs() < 1e-6);
    /// # Ok::<(), sh_scene::LightError>(())
    /// ```
    pub fn project(
        map: &EnvironmentMap,
        ground: Option<Ground>,
        order: usize,
        window: f32,
    ) -> Result<Self, LightError> {
        // Written so that NaN is refused as well.
        if window.is_nan() || window <= 0.0 {
            return Err(LightError::Window(window));
        }
        let coefficients = for_order!(
            order, C => coefficients::<C>(map, ground, window),
            else => return Err(OrderError(order).into())
        );
        Ok(Self {
            order,
            coefficients,
            emitters: Vec::new(),
        })
    }

    /// The same light and these lights besides; those without radiance are left out.
    ///
    /// # Errors
    /// Where one of them is none, or is bound to an object; see [`AreaLight::emitter`] and [`AreaLight::placed`].
    pub fn with_lights(mut self, lights: &[AreaLight]) -> Result<Self, LightError> {
        for light in lights {
            let emitter = light.emitter(self.order)?;
            if light.shines() {
                self.emitters.push(emitter);
            }
        }
        Ok(self)
    }

    /// Radiance that a surface of albedo 1 with this unit normal reflects, in the open: (L, H(N)), which is
    /// irradiance over π. Not below 0, where the window leaves some ringing.
    ///
    /// # Panics
    /// If `order` is not 2 to 6 or there are not `order²` coefficients, which [`Light::project`] never makes.
    pub fn irradiance(&self, normal: [f32; 3]) -> [f32; 3] {
        for_order!(self.order, C => self.against(&<[f32; C]>::cosine(normal)))
    }

    fn against(&self, lobe: &[f32]) -> [f32; 3] {
        assert_eq!(
            self.coefficients.len(),
            lobe.len(),
            "coefficients of a light of this order"
        );
        let mut sum = [0.0; 3];
        for (light, h) in self.coefficients.iter().zip(lobe) {
            for (sum, light) in sum.iter_mut().zip(light) {
                *sum += light * h;
            }
        }
        sum.map(|c: f32| c.max(0.0))
    }
}

fn coefficients<const C: usize>(
    map: &EnvironmentMap,
    ground: Option<Ground>,
    window: f32,
) -> Vec<[f32; 3]>
where
    [f64; C]: Routines<f64>,
{
    let below: Option<[f32; 3]> = ground.map(|ground| {
        let up = map.upper_irradiance();
        std::array::from_fn(|i| ground.albedo[i] * up[i] as f32)
    });
    // Rows are cut in two where their number is odd: then the horizon is an edge between rows. A texel is
    // constant, so this changes nothing else.
    let cut = if below.is_some() {
        1 + map.height as usize % 2
    } else {
        1
    };
    let (width, height) = (map.width as usize, map.height as usize * cut);
    let ShRgb { r, g, b } = project::equirectangular::<C>(width, height, |x, y| match below {
        Some(below) if 2 * y >= height => below,
        _ => map.pixels[x + y / cut * width],
    });
    let [r, g, b] = [r, g, b].map(|channel| {
        if window.is_finite() {
            channel.0.window(f64::from(window))
        } else {
            channel.0
        }
    });
    (0..C)
        .map(|i| [r[i], g[i], b[i]].map(|c| c as f32))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Sky;
    use glam::Vec3;

    #[test]
    fn half_a_sky_over_black_ground_gives_what_the_map_gives_directly() {
        let map = Sky::default().map(128, 64);
        let up = map.upper_irradiance();
        let ground = Some(Ground {
            height: 0.0,
            albedo: [0.0; 3],
        });
        for order in 2..=6 {
            let light = Light::project(&map, ground, order, f32::INFINITY).unwrap();
            let seen = light.irradiance([0.0, 1.0, 0.0]);
            for c in 0..3 {
                // What a cosine lobe of this order misses of half a sky with a sun.
                assert!(
                    (f64::from(seen[c]) / up[c] - 1.0).abs() < 0.1,
                    "{order}: {seen:?} {up:?}"
                );
            }
        }
    }

    #[test]
    fn ground_lights_from_below_with_its_albedo() {
        let ground = Some(Ground {
            height: 0.0,
            albedo: [0.5, 0.25, 0.0],
        });
        let light = Light::project(
            &EnvironmentMap::constant([2.0; 3]),
            ground,
            5,
            f32::INFINITY,
        )
        .unwrap();
        let down = light.irradiance([0.0, -1.0, 0.0]);
        let up = light.irradiance([0.0, 1.0, 0.0]);
        let expected = [1.0, 0.5, 0.0];
        for c in 0..3 {
            // A step at the horizon, in 5 bands: even bands other than 0 cancel, odd ones but 1 are not seen.
            assert!((down[c] - expected[c]).abs() < 1e-5, "{down:?}");
            assert!((up[c] - 2.0).abs() < 1e-5, "{up:?}");
        }
    }

    #[test]
    fn odd_heights_split_the_row_at_the_horizon() {
        let pixels = vec![[1.0; 3]; 5 * 3];
        let map = EnvironmentMap {
            width: 5,
            height: 3,
            pixels,
        };
        let ground = Some(Ground {
            height: 0.0,
            albedo: [0.0; 3],
        });
        let light = Light::project(&map, ground, 2, f32::INFINITY).unwrap();
        // Half the sphere of radiance 1: y₀₀ · 2π.
        let expected = (std::f32::consts::PI).sqrt();
        assert!(
            (light.coefficients[0][0] - expected).abs() < 1e-5,
            "{:?}",
            light.coefficients[0]
        );
    }

    #[test]
    fn the_window_dims_band_by_band() {
        let map = Sky::default().map(64, 32);
        let plain = Light::project(&map, None, 4, f32::INFINITY).unwrap();
        let windowed = Light::project(&map, None, 4, 8.0).unwrap();
        for l in 0..4 {
            let factor = (std::f32::consts::FRAC_PI_2 * l as f32 / 8.0).cos();
            for i in l * l..(l + 1) * (l + 1) {
                let expected = plain.coefficients[i][1] * factor;
                assert!((windowed.coefficients[i][1] - expected).abs() < 1e-5);
            }
        }
        // Narrower than the order: the bands from h on are gone.
        let narrow = Light::project(&map, None, 4, 2.0).unwrap();
        assert!(narrow.coefficients[4..].iter().all(|c| *c == [0.0; 3]));
    }

    #[test]
    fn light_comes_from_where_the_map_has_it() {
        let mut map = EnvironmentMap {
            width: 16,
            height: 8,
            pixels: vec![[0.0; 3]; 128],
        };
        map.pixels[16 * 2 + 13] = [10.0; 3];
        let d = EnvironmentMap::direction(13.5 / 16.0, 2.5 / 8.0);
        let light = Light::project(&map, None, 6, f32::INFINITY).unwrap();
        let facing = light.irradiance(d.to_array())[0];
        for other in [
            Vec3::X,
            Vec3::NEG_X,
            Vec3::Y,
            Vec3::NEG_Y,
            Vec3::Z,
            Vec3::NEG_Z,
        ] {
            assert!(light.irradiance(other.to_array())[0] < facing, "{other}");
        }
    }

    #[test]
    fn what_cannot_be_is_refused() {
        let map = EnvironmentMap::constant([1.0; 3]);
        for order in [0, 1, 7, 100] {
            assert_eq!(
                Light::project(&map, None, order, 8.0),
                Err(LightError::Order(OrderError(order)))
            );
        }
        for window in [0.0, -1.0, f32::NAN] {
            assert!(Light::project(&map, None, 4, window).is_err(), "{window}");
        }
    }
}
