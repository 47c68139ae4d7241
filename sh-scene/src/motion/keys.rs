//! A body that moves as a whole.

use super::MotionError;
use super::track::rising;
use glam::{Affine3A, Quat, Vec3};

/// Where a body stands: turned and scaled evenly, then moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// In metres.
    pub translation: Vec3,
    /// A unit quaternion.
    pub rotation: Quat,
    /// Above 0.
    pub scale: f32,
}

impl From<Place> for Affine3A {
    fn from(place: Place) -> Self {
        let scale = Vec3::splat(place.scale);
        Self::from_scale_rotation_translation(scale, place.rotation, place.translation)
    }
}

/// Places over time: straight lines, even turns by the shorter way, and scales between them.
#[derive(Clone, Debug)]
pub struct Keys {
    keys: Vec<(f32, Place)>,
    repeat: bool,
}

impl Keys {
    /// Places at rising times, in seconds. After the last one the keys begin anew from time 0 where they
    /// `repeat`; otherwise the body stays.
    ///
    /// # Errors
    /// Where there are no keys, the times do not rise, or a place is none.
    pub fn new(keys: Vec<(f32, Place)>, repeat: bool) -> Result<Self, MotionError> {
        rising(keys.iter().map(|(time, _)| *time))?;
        for (key, (_, place)) in keys.iter().enumerate() {
            let scale = place.scale.is_finite() && place.scale > 0.0;
            if !(scale && place.translation.is_finite() && place.rotation.is_normalized()) {
                let value = format!("{place:?}");
                return Err(MotionError::Value { key, value });
            }
        }
        Ok(Self { keys, repeat })
    }

    /// The time of the last key, in seconds.
    pub fn duration(&self) -> f32 {
        self.keys.last().map_or(0.0, |(time, _)| *time)
    }

    /// World from object at a time, in seconds.
    pub fn at(&self, seconds: f64) -> Affine3A {
        let duration = f64::from(self.duration());
        let seconds = match self.repeat && duration > 0.0 {
            true => seconds.rem_euclid(duration) as f32,
            false => seconds as f32,
        };
        let after = self.keys.partition_point(|(time, _)| *time <= seconds);
        if after == 0 || after == self.keys.len() {
            return self.keys[after.saturating_sub(1)].1.into();
        }
        let ((start, a), (end, b)) = (self.keys[after - 1], self.keys[after]);
        let t = (seconds - start) / (end - start);
        Affine3A::from(Place {
            translation: a.translation.lerp(b.translation, t),
            rotation: a.rotation.slerp(b.rotation, t),
            scale: a.scale + (b.scale - a.scale) * t,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn place(x: f32, degrees: f32, scale: f32) -> Place {
        Place {
            translation: Vec3::X * x,
            rotation: Quat::from_rotation_y(degrees.to_radians()),
            scale,
        }
    }

    #[test]
    fn keys_are_met_and_the_middle_is_between() {
        let keys = vec![(1.0, place(0.0, 0.0, 1.0)), (3.0, place(4.0, 90.0, 2.0))];
        for repeat in [false, true] {
            let keys = Keys::new(keys.clone(), repeat).unwrap();
            let near = |seconds: f64, expected: Place| {
                let (found, expected) = (keys.at(seconds), Affine3A::from(expected));
                assert!(found.abs_diff_eq(expected, 1e-5), "{seconds}: {found:?}");
            };
            near(0.5, place(0.0, 0.0, 1.0));
            near(2.0, place(2.0, 45.0, 1.5));
            let late = if repeat {
                place(2.0, 45.0, 1.5)
            } else {
                place(4.0, 90.0, 2.0)
            };
            near(5.0, late);
            // A minute of whole turns loses nothing.
            near(60.0 * 3.0 + 2.0, late);
        }
    }

    #[test]
    fn what_is_no_key_is_refused() {
        let good = place(0.0, 0.0, 1.0);
        assert!(Keys::new(vec![], true).is_err());
        assert!(Keys::new(vec![(1.0, good), (1.0, good)], true).is_err());
        for bad in [
            Place { scale: 0.0, ..good },
            Place {
                rotation: Quat::IDENTITY * 2.0,
                ..good
            },
            Place {
                translation: Vec3::NAN,
                ..good
            },
        ] {
            let error = Keys::new(vec![(0.0, good), (1.0, bad)], false).unwrap_err();
            assert!(
                matches!(error, MotionError::Value { key: 1, .. }),
                "{error}"
            );
        }
        assert_eq!(
            Keys::new(vec![(0.0, good)], true).unwrap().at(7.0),
            good.into()
        );
    }
}
