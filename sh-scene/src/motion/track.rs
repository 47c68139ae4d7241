//! Values over time: glTF 2.0, section 3.11 and appendix C.

use super::MotionError;
use glam::{Quat, Vec3, Vec4};

/// How a track goes from key to key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpolation {
    /// Each value holds until the next key.
    Step,
    /// Straight; rotations along the shortest great circle.
    Linear,
    /// Cubic Hermite splines: three values a key, the tangent before it, the value, the tangent after it.
    Cubic,
}

/// What a track can hold: [`Vec3`] for translations and scales, [`Quat`] for rotations.
pub trait Value: Copy + std::fmt::Debug {
    /// The value `t` of the way from `self` to `to`, `t` in 0..=1.
    fn mix(self, to: Self, t: f32) -> Self;
    /// The sum of these values times these factors, made a value of its kind again.
    fn sum(terms: [(Self, f32); 4]) -> Self;
    /// Whether it can be used: as a tangent, or as a value.
    fn is_good(self, tangent: bool) -> bool;
}

impl Value for Vec3 {
    fn mix(self, to: Self, t: f32) -> Self {
        self + (to - self) * t
    }

    fn sum(terms: [(Self, f32); 4]) -> Self {
        terms.iter().map(|(value, factor)| *value * *factor).sum()
    }

    fn is_good(self, _: bool) -> bool {
        self.is_finite()
    }
}

impl Value for Quat {
    fn mix(self, to: Self, t: f32) -> Self {
        self.slerp(to, t)
    }

    fn sum(terms: [(Self, f32); 4]) -> Self {
        let sum: Vec4 = terms
            .iter()
            .map(|(value, factor)| Vec4::from(*value) * *factor)
            .sum();
        // A spline that passes through zero has no rotation there: that of the key before is as good as any.
        let [start, ..] = terms;
        sum.try_normalize().map_or(start.0, Quat::from_vec4)
    }

    fn is_good(self, tangent: bool) -> bool {
        // The length has to be one whose square is a normal number.
        let length = self.length_squared();
        self.is_finite() && (tangent || (1e-20..1e20).contains(&length))
    }
}

/// A value over time, with at least one key.
///
/// ```
/// use glam::Vec3;
/// use sh_scene::motion::{Interpolation, Track};
/// let track = Track::new(vec![1.0, 3.0], vec![Vec3::ZERO, Vec3::X], Interpolation::Linear)?;
/// assert_eq!(track.at(2.0), Vec3::X * 0.5);
/// assert_eq!(track.at(9.0), Vec3::X);
/// # Ok::<(), sh_scene::motion::MotionError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Track<T> {
    times: Vec<f32>,
    values: Vec<T>,
    interpolation: Interpolation,
}

impl<T: Value> Track<T> {
    /// A track of keys at rising times, in seconds. There is a value for each; with
    /// [`Interpolation::Cubic`], three. Rotations need not be unit quaternions.
    ///
    /// # Errors
    /// Where there are no keys, or not as many values as there have to be, or a time or value is none.
    pub fn new(
        times: Vec<f32>,
        mut values: Vec<T>,
        interpolation: Interpolation,
    ) -> Result<Self, MotionError> {
        let each = match interpolation {
            Interpolation::Cubic => 3,
            _ => 1,
        };
        if times.is_empty() {
            return Err(MotionError::Empty);
        }
        if values.len() != each * times.len() {
            return Err(MotionError::Count {
                times: times.len(),
                values: values.len(),
                expected: each * times.len(),
            });
        }
        rising(times.iter().copied())?;
        for (i, value) in values.iter_mut().enumerate() {
            let tangent = each == 3 && i % 3 != 1;
            if !value.is_good(tangent) {
                return Err(MotionError::Value {
                    key: i / each,
                    value: format!("{value:?}"),
                });
            }
            if !tangent {
                // What a value becomes by itself: unit length, for a rotation.
                *value = T::sum([(*value, 1.0), (*value, 0.0), (*value, 0.0), (*value, 0.0)]);
            }
        }
        Ok(Self {
            times,
            values,
            interpolation,
        })
    }

    /// The time of the last key, in seconds.
    pub fn duration(&self) -> f32 {
        self.times.last().copied().unwrap_or(0.0)
    }

    /// The value at a time in seconds: the first key's before it, the last one's after it.
    pub fn at(&self, seconds: f32) -> T {
        let value = |key: usize| match self.interpolation {
            Interpolation::Cubic => self.values[3 * key + 1],
            _ => self.values[key],
        };
        let after = self.times.partition_point(|time| *time <= seconds);
        if after == 0 {
            return value(0);
        }
        let before = after - 1;
        if after == self.times.len() || self.interpolation == Interpolation::Step {
            return value(before);
        }
        let span = self.times[after] - self.times[before];
        let t = (seconds - self.times[before]) / span;
        if self.interpolation == Interpolation::Linear {
            return value(before).mix(value(after), t);
        }
        let (t2, t3) = (t * t, t * t * t);
        T::sum([
            (value(before), 2.0 * t3 - 3.0 * t2 + 1.0),
            (self.values[3 * before + 2], span * (t3 - 2.0 * t2 + t)),
            (value(after), 3.0 * t2 - 2.0 * t3),
            (self.values[3 * after], span * (t3 - t2)),
        ])
    }
}

/// Checks that times can be those of keys.
pub(super) fn rising(times: impl Iterator<Item = f32>) -> Result<(), MotionError> {
    let mut last = None;
    for (key, time) in times.enumerate() {
        if !time.is_finite() || time < 0.0 || last.is_some_and(|last| time <= last) {
            return Err(MotionError::Time { key, time });
        }
        last = Some(time);
    }
    match last {
        Some(_) => Ok(()),
        None => Err(MotionError::Empty),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f32::consts::FRAC_PI_2;

    #[test]
    fn steps_hold_and_lines_are_straight() {
        let times = vec![0.5, 1.0, 2.0];
        let values = vec![Vec3::X, Vec3::Y, Vec3::Z];
        let step = Track::new(times.clone(), values.clone(), Interpolation::Step).unwrap();
        for (t, expected) in [
            (0.0, Vec3::X),
            (0.99, Vec3::X),
            (1.0, Vec3::Y),
            (1.99, Vec3::Y),
            (2.0, Vec3::Z),
            (9.0, Vec3::Z),
        ] {
            assert_eq!(step.at(t), expected, "{t}");
        }
        let line = Track::new(times, values, Interpolation::Linear).unwrap();
        assert_eq!(line.at(0.75), Vec3::new(0.5, 0.5, 0.0));
        assert_eq!(line.at(1.75), Vec3::new(0.0, 0.25, 0.75));
    }

    #[test]
    fn rotations_take_the_shorter_way_at_an_even_pace() {
        let quarter = Quat::from_rotation_y(FRAC_PI_2);
        // The same rotation under the other sign, and not of unit length.
        let values = vec![Quat::IDENTITY, quarter * -3.0];
        let track = Track::new(vec![0.0, 1.0], values, Interpolation::Linear).unwrap();
        for i in 0..=10 {
            let t = i as f32 / 10.0;
            let expected = Quat::from_rotation_y(FRAC_PI_2 * t);
            assert!(track.at(t).angle_between(expected) < 1e-3, "{t}");
        }
    }

    #[test]
    fn splines_follow_a_cubic() {
        // x = t³ − 2t² + 3, with its own tangents, at uneven keys.
        let (f, slope) = (
            |t: f32| Vec3::X * (t * t * t - 2.0 * t * t + 3.0),
            |t: f32| Vec3::X * (3.0 * t * t - 4.0 * t),
        );
        let times = vec![0.0, 0.5, 2.0];
        let values = times
            .iter()
            .flat_map(|&t| [slope(t), f(t), slope(t)])
            .collect();
        let track = Track::new(times, values, Interpolation::Cubic).unwrap();
        for i in 0..=40 {
            let t = i as f32 / 20.0;
            assert!(track.at(t).distance(f(t)) < 1e-5, "{t}: {}", track.at(t));
        }
        let turns = [0.0, 0.0, 1.0, 0.0].map(|y| Quat::from_xyzw(0.0, y, 0.0, 1.0 - y));
        let values = vec![
            turns[0] * 0.0,
            turns[0],
            turns[2],
            turns[2],
            turns[2],
            turns[0] * 0.0,
        ];
        let track = Track::new(vec![0.0, 1.0], values, Interpolation::Cubic).unwrap();
        for i in 0..=10 {
            let length = track.at(i as f32 / 10.0).length();
            assert!((length - 1.0).abs() < 1e-5, "{length}");
        }
    }

    #[test]
    fn what_is_no_track_is_refused() {
        let make = |times: &[f32], values: &[Vec3], kind| {
            Track::new(times.to_vec(), values.to_vec(), kind).map(|_| ())
        };
        let linear = Interpolation::Linear;
        assert_eq!(make(&[], &[], linear), Err(MotionError::Empty));
        for (times, key) in [
            (&[0.0, 0.0], 1),
            (&[1.0, 0.5], 1),
            (&[-1.0, 0.5], 0),
            (&[0.0, f32::NAN], 1),
        ] {
            let error = make(times, &[Vec3::X; 2], linear).unwrap_err();
            assert!(
                matches!(error, MotionError::Time { key: k, .. } if k == key),
                "{times:?}"
            );
        }
        let count = make(&[0.0, 1.0], &[Vec3::X; 3], Interpolation::Cubic).unwrap_err();
        assert_eq!(
            count.to_string(),
            "there are 3 values for 2 times, but 6 are needed"
        );
        let bad = make(&[0.0], &[Vec3::X / 0.0], linear).unwrap_err();
        assert!(matches!(bad, MotionError::Value { key: 0, .. }));
        let zero = Track::new(vec![0.0], vec![Quat::IDENTITY * 0.0], linear);
        assert!(matches!(zero, Err(MotionError::Value { key: 0, .. })));
    }
}
