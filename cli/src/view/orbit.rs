//! The camera, moved by hand about the point it looks at.

use glam::{Quat, Vec3};
use sh_scene::{Camera, View};

/// A camera and where it started from.
#[derive(Clone, Copy, Debug)]
pub(super) struct Orbit {
    pub camera: Camera,
    start: Camera,
}

/// The camera never looks straighter down or up than this, in radians above or below the horizon.
const STEEPEST: f32 = 1.55;

impl Orbit {
    /// About where the camera looks.
    pub fn new(camera: Camera) -> Self {
        Self {
            camera,
            start: camera,
        }
    }

    /// Back to where it started from.
    pub fn reset(&mut self) {
        self.camera = self.start;
    }

    /// Moves the eye about the target: `right` and `up` in radians.
    pub fn turn(&mut self, right: f32, up: f32) {
        let away = self.camera.eye - self.camera.target;
        let distance = away.length();
        if !(distance > 0.0 && distance.is_finite()) {
            return;
        }
        let height = (away.y / distance).clamp(-1.0, 1.0).asin();
        let height = (height + up).clamp(-STEEPEST, STEEPEST);
        // Straight above the target no direction is nearer than another.
        let flat = Vec3::new(away.x, 0.0, away.z)
            .try_normalize()
            .unwrap_or(Vec3::Z);
        let flat = Quat::from_rotation_y(right) * flat;
        let away = flat * height.cos() + Vec3::Y * height.sin();
        self.camera.eye = self.camera.target + away * distance;
    }

    /// Moves the eye towards the target, or away where the factor is above 1.
    pub fn zoom(&mut self, factor: f32) {
        let away = self.camera.eye - self.camera.target;
        let start = (self.start.eye - self.start.target).length();
        let nearest = Camera::nearest(self.camera.target).max(1e-3 * start);
        let distance = (away.length() * factor).clamp(nearest, 1e3 * start);
        if let Some(direction) = away.try_normalize() {
            self.camera.eye = self.camera.target + direction * distance;
        }
    }

    /// Moves eye and target alike: parts of the picture's height to the right and up.
    pub fn shift(&mut self, right: f32, up: f32) {
        let view = View {
            camera: self.camera,
            width: 1,
            height: 1,
        };
        let [across, above, _] = view.axes();
        let distance = (self.camera.eye - self.camera.target).length();
        let height = 2.0 * (0.5 * self.camera.fov).tan() * distance;
        let by = (across * right + above * up) * height;
        self.camera.eye += by;
        self.camera.target += by;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn orbit() -> Orbit {
        Orbit::new(Camera {
            eye: Vec3::new(1.0, 2.0, 3.0),
            target: Vec3::new(0.0, 1.0, 0.0),
            fov: 0.6,
        })
    }

    #[test]
    fn turning_keeps_the_distance_and_never_tips_over() {
        let mut moved = orbit();
        for _ in 0..100 {
            moved.turn(0.3, 0.2);
            let away = moved.camera.eye - moved.camera.target;
            assert!((away.length() - 11.0_f32.sqrt()).abs() < 1e-3);
        }
        let away = (moved.camera.eye - moved.camera.target).normalize();
        assert!(away.y > 0.999 && away.y < 0.9999, "{away}");
        moved.turn(0.0, -10.0);
        assert!(moved.camera.eye.y < moved.camera.target.y);
    }

    #[test]
    fn a_turn_to_the_right_moves_what_is_seen_to_the_left() {
        let mut moved = orbit();
        let view = View {
            camera: moved.camera,
            width: 1,
            height: 1,
        };
        let [right, ..] = view.axes();
        moved.turn(0.1, 0.0);
        assert!((moved.camera.eye - orbit().camera.eye).dot(right) > 0.0);
    }

    #[test]
    fn zooming_stops_before_the_target() {
        let mut moved = orbit();
        for _ in 0..1000 {
            moved.zoom(0.5);
        }
        let away = (moved.camera.eye - moved.camera.target).length();
        assert!(away > 1e-3 && away < 1e-2, "{away}");
        moved.reset();
        assert_eq!(moved.camera, orbit().camera);
    }

    #[test]
    fn shifting_moves_by_parts_of_the_picture() {
        let mut moved = orbit();
        moved.shift(0.5, -0.25);
        let by = moved.camera.eye - orbit().camera.eye;
        assert!((by - (moved.camera.target - orbit().camera.target)).length() < 1e-5);
        let height = 2.0 * 0.3_f32.tan() * 11.0_f32.sqrt();
        assert!((by.length() - height * 0.3125_f32.sqrt()).abs() < 1e-4);
    }
}
