//! Lights of a shape that is known: discs in the sky and glowing balls.

use crate::{Distribution, LightError, Object};
use bytemuck::{Pod, Zeroable};
use glam::Vec3;
use sh_core::constants::{MAX_ORDER, MOST_COEFFICIENTS};

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
    /// How bright each part of a ball is, in parts of `radiance`; none: all of it alike. A disc has none.
    pub distribution: Option<Distribution>,
    /// The object of the scene that a ball is bound to: centre, radius and distribution are then in its space, and move,
    /// grow and turn with it.
    pub object: Option<usize>,
}

/// An [`AreaLight`] as the passes read it: 640 bytes, as `struct Emitter { center: vec3f, radius: f32, radiance:
/// vec3f, local: f32, gains: array<f32, 6>, order: u32, distribution: array<vec4f, 36> }` in WGSL. Of an even one nothing
/// beyond its order is read.
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
    /// What each band of its SH vector is multiplied with: the window.
    pub gains: [f32; MAX_ORDER],
    /// The order of its distribution; 0: it is even.
    pub order: u32,
    /// 0.
    pub unused: u32,
    /// How bright each part of a ball is, in parts of the radiance: order² coefficients of red, green and blue; the rest
    /// is 0.
    pub distribution: [[f32; 4]; MOST_COEFFICIENTS],
}

impl AreaLight {
    /// An even disc at infinity, towards `direction`, of an angular radius in radians.
    ///
    /// ```
    /// use glam::Vec3;
    /// let sun = sh_scene::AreaLight::distant(Vec3::new(0.3, 1.0, 0.2), 0.05, [40.0, 36.0, 30.0]);
    /// assert!(sun.emitter(4).is_ok());
    /// ```
    pub const fn distant(direction: Vec3, angle: f32, radiance: [f32; 3]) -> Self {
        Self::of(AreaShape::Distant { direction, angle }, radiance)
    }

    /// An even ball in the scene, bound to nothing.
    ///
    /// ```
    /// use glam::Vec3;
    /// use sh_scene::{AreaLight, Distribution};
    /// let lamp = AreaLight {
    ///     distribution: Some(Distribution::cap(Vec3::NEG_Y, 1.0)?),
    ///     ..AreaLight::local(Vec3::new(0.0, 2.0, 0.0), 0.1, [40.0; 3])
    /// };
    /// assert_eq!(lamp.emitter(4)?.order, 4);
    /// # Ok::<(), sh_scene::LightError>(())
    /// ```
    pub const fn local(center: Vec3, radius: f32, radiance: [f32; 3]) -> Self {
        Self::of(AreaShape::Local { center, radius }, radiance)
    }

    /// An even light of a shape, bound to nothing, with the window that ringing asks for.
    pub const fn of(shape: AreaShape, radiance: [f32; 3]) -> Self {
        Self {
            shape,
            radiance,
            window: None,
            distribution: None,
            object: None,
        }
    }

    /// The light where it is in the world: as it is, or as the object has it that it is bound to.
    ///
    /// # Errors
    /// Where there is no such object, or a disc at infinity is bound to one.
    pub fn placed(&self, objects: &[Object]) -> Result<Self, LightError> {
        let Some(index) = self.object else {
            return Ok(*self);
        };
        let (Some(object), AreaShape::Local { center, radius }) = (objects.get(index), self.shape)
        else {
            return Err(LightError::Bound {
                object: index,
                objects: objects.len(),
            });
        };
        let (scale, turn, _) = object.transform.to_scale_rotation_translation();
        Ok(Self {
            shape: AreaShape::Local {
                center: object.transform.transform_point3(center),
                radius: radius * scale.x,
            },
            distribution: self.distribution.map(|own| own.turned(turn)),
            object: None,
            ..*self
        })
    }

    /// Whether it sends out any light: one of no radiance is no work for anybody.
    pub fn shines(&self) -> bool {
        self.radiance.iter().any(|c| *c > 0.0)
    }

    /// The light as the passes of an SH order read it.
    ///
    /// # Errors
    /// Where a number is not finite, a size is not above 0, an angle is above π/2, a radiance is negative, a window
    /// has no width, a disc has a distribution, or it is bound to an object and has not been [placed](Self::placed).
    pub fn emitter(&self, order: usize) -> Result<Emitter, LightError> {
        if self.object.is_some() {
            return Err(LightError::Unplaced);
        }
        if self.radiance.iter().any(|c| !c.is_finite() || *c < 0.0) {
            return Err(LightError::Radiance(self.radiance));
        }
        let (center, radius, local) = match self.shape {
            AreaShape::Distant { direction, angle } => {
                if !(angle > 0.0 && angle <= std::f32::consts::FRAC_PI_2) {
                    return Err(LightError::Angle(angle));
                }
                let unit = direction.try_normalize().ok_or(LightError::Direction)?;
                if self.distribution.is_some() {
                    return Err(LightError::Distribution);
                }
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
        let mut gains = [0.0; MAX_ORDER];
        for (l, gain) in gains.iter_mut().enumerate().take(order) {
            *gain = crate::ringing::gain(l, width);
        }
        let mut distribution = [[0.0; 4]; MOST_COEFFICIENTS];
        if let Some(own) = &self.distribution {
            let count = order * order;
            for (out, [r, g, b]) in distribution.iter_mut().zip(own.coefficients()).take(count) {
                *out = [*r, *g, *b, 0.0];
            }
        }
        Ok(Emitter {
            center: center.into(),
            radius,
            radiance: self.radiance,
            local,
            gains,
            order: self.distribution.map_or(0, |_| order as u32),
            unused: 0,
            distribution,
        })
    }
}
