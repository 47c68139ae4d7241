//! Lights of a shape that is known: discs in the sky and glowing balls.

use crate::LightError;
use bytemuck::{Pod, Zeroable};
use glam::Vec3;

/// What a light is and where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AreaShape {
    /// A disc at infinity, such as the sun.
    Distant {
        /// Towards the disc's middle; of any length but 0.
        direction: Vec3,
        /// Its angular radius, in radians, above 0 and at most π/2.
        angle: f32,
    },
    /// A glowing ball in the scene. It casts no shadow.
    Local {
        /// Its centre, in metres.
        center: Vec3,
        /// Its radius, in metres, above 0.
        radius: f32,
    },
}

/// An analytic light: a disc of even radiance as every receiver sees it (Ren et al. 2006, section 7).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AreaLight {
    /// Where it is and how large.
    pub shape: AreaShape,
    /// The radiance of its surface, linear Rec.709.
    pub radiance: [f32; 3],
    /// Window width h of its SH vector; none: as wide as ringing allows ([`crate::ringing::width`]).
    pub window: Option<f32>,
}

/// An [`AreaLight`] as the passes read it: 64 bytes, as `struct Emitter { center: vec3f, radius: f32, radiance:
/// vec3f, local: f32, gains: array<vec4f, 2> }` in WGSL.
///
/// A receiver at p sees its middle at `center − local·p`, and its angular radius has the sine `radius` over that
/// vector's length, at most 1: for a distant light `local` is 0, `center` a unit vector and `radius` a sine.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Emitter {
    /// Centre in metres, or unit vector towards a distant light.
    pub center: [f32; 3],
    /// Radius in metres, or the sine of a distant light's angular radius.
    pub radius: f32,
    /// Radiance, linear Rec.709.
    pub radiance: [f32; 3],
    /// 1 for a local light, 0 for a distant one.
    pub local: f32,
    /// What each band of its SH vector is multiplied with: the window. Six bands; the rest is 0.
    pub gains: [f32; 8],
}

impl AreaLight {
    /// Whether it sends out any light: one of no radiance is no work for anybody.
    pub fn shines(&self) -> bool {
        self.radiance.iter().any(|c| *c > 0.0)
    }

    /// The light as the passes of an SH order read it.
    ///
    /// # Errors
    /// Where a number is not finite, a size is not above 0, an angle is above π/2, a radiance is negative, or a window
    /// has no width.
    pub fn emitter(&self, order: usize) -> Result<Emitter, LightError> {
        if self.radiance.iter().any(|c| !c.is_finite() || *c < 0.0) {
            return Err(LightError::Radiance(self.radiance));
        }
        let (center, radius, local) = match self.shape {
            AreaShape::Distant { direction, angle } => {
                if !(angle > 0.0 && angle <= std::f32::consts::FRAC_PI_2) {
                    return Err(LightError::Angle(angle));
                }
                let unit = direction.try_normalize().ok_or(LightError::Direction)?;
                (unit, angle.sin(), 0.0)
            }
            AreaShape::Local { center, radius } => {
                if !(radius > 0.0 && radius.is_finite() && center.is_finite()) {
                    return Err(LightError::Ball);
                }
                (center, radius, 1.0)
            }
        };
        let width = match self.window {
            Some(width) if width.is_nan() || width <= 0.0 => return Err(LightError::Window(width)),
            Some(width) => width,
            None => crate::ringing::of_small_light(order),
        };
        let mut gains = [0.0; 8];
        for (l, gain) in gains.iter_mut().enumerate().take(order) {
            *gain = crate::ringing::gain(l, width);
        }
        Ok(Emitter {
            center: center.into(),
            radius,
            radiance: self.radiance,
            local,
            gains,
        })
    }
}
