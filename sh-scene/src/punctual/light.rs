//! Spots, points and suns as a scene has them.

use super::record::PunctualRecord;
use crate::{LightError, Object};
use glam::{Quat, Vec3};
use std::f32::consts::PI;

/// What a light is, where, and of which size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PunctualShape {
    /// A ball that shines into a cone.
    Spot {
        /// Its centre, in metres.
        position: Vec3,
        /// The way that it shines; of any length but 0.
        towards: Vec3,
        /// The angle of the whole cone, from edge to edge, in radians, above 0 and below π.
        angle: f32,
        /// The part of the cone's angle over which it fades to its edge, 0..=1.
        blend: f32,
        /// Its radius, in metres; 0: its shadows have sharp edges.
        radius: f32,
    },
    /// A ball that shines in all directions.
    Point {
        /// Its centre, in metres.
        position: Vec3,
        /// Its radius, in metres; 0: its shadows have sharp edges.
        radius: f32,
    },
    /// A disc at infinity.
    Sun {
        /// Towards it; of any length but 0.
        direction: Vec3,
        /// Its angular radius, in radians, from 0 to π/4; that of the sun is .00465.
        angle: f32,
    },
}

/// A light with sharp shadows: a spot, a point or a sun. It is not among the [`crate::Light`] in spherical harmonics, and is hidden
/// by surfaces themselves instead of by their spheres.
///
/// ```
/// use glam::Vec3;
/// use sh_scene::{PunctualLight, PunctualShape};
/// let shape = PunctualShape::Point { position: 2.0 * Vec3::Y, radius: 0.0 };
/// let bulb = PunctualLight::new(shape, [40.0; 3]);
/// // The irradiance is 40 / 2², of which white reflects 1/π.
/// let below = bulb.record()?.radiance(Vec3::ZERO, Vec3::Y);
/// assert!((below[0] - 10.0 / std::f32::consts::PI).abs() < 1e-5);
/// # Ok::<(), sh_scene::LightError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PunctualLight {
    /// What it is and where.
    pub shape: PunctualShape,
    /// How bright it is, linear Rec.709: of a spot and a point the radiant intensity, radiance times square metres, in the middle of
    /// its cone; of a sun the irradiance of what faces it, radiance times steradians. Where a radiance of 1 is a candela a square
    /// metre, that is candela and lux.
    pub intensity: [f32; 3],
    /// The object of the scene that a spot or a point is bound to: position, direction and radius are then in its space, and move,
    /// turn and grow with it.
    pub object: Option<usize>,
}

impl PunctualLight {
    /// A light bound to nothing.
    pub const fn new(shape: PunctualShape, intensity: [f32; 3]) -> Self {
        Self {
            shape,
            intensity,
            object: None,
        }
    }

    /// The light where it is in the world: as it is, or as the object has it that it is bound to.
    ///
    /// ```
    /// use glam::{Affine3A, Vec3};
    /// use sh_scene::{Object, PunctualLight, PunctualShape};
    /// let car = Object { transform: Affine3A::from_translation(Vec3::X), ..Object::default() };
    /// let shape = PunctualShape::Point { position: Vec3::Y, radius: 0.1 };
    /// let lamp = PunctualLight { object: Some(0), ..PunctualLight::new(shape, [1.0; 3]) };
    /// let PunctualShape::Point { position, .. } = lamp.placed(&[car])?.shape else { unreachable!() };
    /// assert_eq!(position, Vec3::new(1.0, 1.0, 0.0));
    /// # Ok::<(), sh_scene::LightError>(())
    /// ```
    ///
    /// # Errors
    /// Where there is no such object, or a sun is bound to one.
    pub fn placed(&self, objects: &[Object]) -> Result<Self, LightError> {
        let Some(index) = self.object else {
            return Ok(*self);
        };
        let bound = LightError::Bound {
            object: index,
            objects: objects.len(),
        };
        let transform = objects.get(index).ok_or(bound)?.transform;
        let scale = transform.matrix3.x_axis.length();
        let shape = match self.shape {
            PunctualShape::Spot {
                position,
                towards,
                angle,
                blend,
                radius,
            } => PunctualShape::Spot {
                position: transform.transform_point3(position),
                towards: transform.transform_vector3(towards),
                angle,
                blend,
                radius: radius * scale,
            },
            PunctualShape::Point { position, radius } => PunctualShape::Point {
                position: transform.transform_point3(position),
                radius: radius * scale,
            },
            PunctualShape::Sun { .. } => return Err(bound),
        };
        Ok(Self {
            shape,
            object: None,
            ..*self
        })
    }

    /// The light turned about the origin.
    ///
    /// ```
    /// use glam::{Quat, Vec3};
    /// use sh_scene::{PunctualLight, PunctualShape};
    /// let sun = PunctualShape::Sun { direction: Vec3::X, angle: 0.0 };
    /// let turned = PunctualLight::new(sun, [1.0; 3]).turned(Quat::from_rotation_z(1.570_796_4));
    /// let PunctualShape::Sun { direction, .. } = turned.shape else { unreachable!() };
    /// assert!(direction.abs_diff_eq(Vec3::Y, 1e-6));
    /// ```
    pub fn turned(&self, by: Quat) -> Self {
        let shape = match self.shape {
            PunctualShape::Spot {
                position,
                towards,
                angle,
                blend,
                radius,
            } => PunctualShape::Spot {
                position: by * position,
                towards: by * towards,
                angle,
                blend,
                radius,
            },
            PunctualShape::Point { position, radius } => PunctualShape::Point {
                position: by * position,
                radius,
            },
            PunctualShape::Sun { direction, angle } => PunctualShape::Sun {
                direction: by * direction,
                angle,
            },
        };
        Self { shape, ..*self }
    }

    /// The light so many times as bright.
    ///
    /// ```
    /// use glam::Vec3;
    /// use sh_scene::{PunctualLight, PunctualShape};
    /// let sun = PunctualShape::Sun { direction: Vec3::X, angle: 0.0 };
    /// assert_eq!(PunctualLight::new(sun, [1.0; 3]).scaled(2.0).intensity, [2.0; 3]);
    /// ```
    pub fn scaled(&self, factor: f32) -> Self {
        Self {
            intensity: self.intensity.map(|c| c * factor),
            ..*self
        }
    }

    /// Whether it sends out any light: one of no intensity is no work for anybody.
    pub fn shines(&self) -> bool {
        self.intensity.iter().any(|c| *c > 0.0)
    }

    /// How many pictures are taken from it of what it shines on: one of a sun and of a spot, five of one whose cone is wider than 100°,
    /// six of a point.
    ///
    /// ```
    /// use glam::Vec3;
    /// use sh_scene::{PunctualLight, PunctualShape};
    /// let sun = PunctualShape::Sun { direction: Vec3::Y, angle: 0.005 };
    /// assert_eq!(PunctualLight::new(sun, [1.0; 3]).views(), 1);
    /// ```
    pub fn views(&self) -> usize {
        match self.shape {
            PunctualShape::Spot { angle, .. } if angle <= WIDEST => 1,
            PunctualShape::Spot { .. } => 5,
            PunctualShape::Point { .. } => 6,
            PunctualShape::Sun { .. } => 1,
        }
    }

    /// The light as the passes read it; its views come first where the record is alone.
    ///
    /// # Errors
    /// Where a number is not finite, an intensity is negative, a cone, a sun or a ball has a size that it cannot have, a direction has no
    /// length, or it is bound to an object and has not been [placed](Self::placed).
    pub fn record(&self) -> Result<PunctualRecord, LightError> {
        if self.object.is_some() {
            return Err(LightError::Unplaced);
        }
        if self.intensity.iter().any(|c| !c.is_finite() || *c < 0.0) {
            return Err(LightError::Intensity(self.intensity));
        }
        let unit = |direction: Vec3| direction.try_normalize().ok_or(LightError::Direction);
        let ball = |position: Vec3, radius: f32| match position.is_finite()
            && (0.0..f32::INFINITY).contains(&radius)
        {
            true => Ok((position, radius)),
            false => Err(LightError::Size),
        };
        // What a point has in the place of a cone: no direction is outside of it.
        const ALL: [f32; 2] = [3.0, 1.0];
        let ([x, y, z], radius, axis, [outer, steep], distant) = match self.shape {
            PunctualShape::Spot {
                position,
                towards,
                angle,
                blend,
                radius,
            } => {
                if !(angle > 0.0 && angle < PI && (0.0..=1.0).contains(&blend)) {
                    return Err(LightError::Cone { angle, blend });
                }
                let (position, radius) = ball(position, radius)?;
                // 1 − the cosine, without cancellation.
                let versine = |angle: f32| 2.0 * (0.5 * angle).sin().powi(2);
                let outer = versine(0.5 * angle);
                let inner = versine(0.5 * angle * (1.0 - blend));
                let steep = 1.0 / (outer - inner).max(outer * STEEPEST);
                (
                    position.to_array(),
                    radius,
                    unit(towards)?,
                    [outer, steep],
                    0.0,
                )
            }
            PunctualShape::Point { position, radius } => {
                let (position, radius) = ball(position, radius)?;
                (position.to_array(), radius, Vec3::NEG_Y, ALL, 0.0)
            }
            PunctualShape::Sun { direction, angle } => {
                if !(0.0..=std::f32::consts::FRAC_PI_4).contains(&angle) {
                    return Err(LightError::Sun(angle));
                }
                let unit = unit(direction)?;
                (unit.to_array(), angle.tan(), -unit, ALL, 1.0)
            }
        };
        Ok(PunctualRecord {
            position: [x, y, z],
            radius,
            axis: axis.into(),
            outer,
            radiance: self.intensity.map(|c| c / PI),
            steep,
            distant,
            first: 0,
            views: self.views() as u32,
            unused: 0,
        })
    }
}

/// The part of a cone's versine over which its edge fades at least: a thousandth, so that it is no step of a pixel.
const STEEPEST: f32 = 1e-3;

/// The widest cone, in radians from edge to edge, that one view looks at: 100°.
pub(super) const WIDEST: f32 = 100.0 * std::f32::consts::PI / 180.0;
