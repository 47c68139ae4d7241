//! Bending along a circle.

use glam::{Quat, Vec3};

/// What stands along +Y, bent about an axis along Z: the piece of the Y axis between `-length / 2` and `length / 2`
/// becomes the arc of a circle that turns by `angle` in all, towards +X, and stays as long as it was. Its middle stays
/// in the origin; what is beyond its ends goes on in a straight line.
///
/// ```
/// use glam::Vec3;
/// let bend = sh_bake::shapes::Bend { length: 2.0, angle: std::f32::consts::PI };
/// let radius = 2.0 / std::f32::consts::PI;
/// assert!(bend.place(Vec3::Y).distance(Vec3::new(radius, radius, 0.0)) < 1e-6);
/// assert!((bend.turn(1.0) * Vec3::Y).distance(Vec3::X) < 1e-6);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bend {
    /// Metres of the axis that are bent.
    pub length: f32,
    /// By how much, in radians.
    pub angle: f32,
}

impl Bend {
    /// How much what stands at a height is turned.
    pub fn turn(&self, height: f32) -> Quat {
        let half = self.length / 2.0;
        Quat::from_rotation_z(-self.angle * height.clamp(-half, half) / self.length)
    }

    /// Where a point goes.
    pub fn place(&self, point: Vec3) -> Vec3 {
        let half = self.length / 2.0;
        let height = point.y.clamp(-half, half);
        // The axis' own point: (1 − cos a)/c, sin a / c with the curvature c, in a form that holds for a straight one.
        let a = self.angle * height / self.length;
        let (sinc, half_sinc) = (sinc(a), sinc(a / 2.0));
        let axis = Vec3::new(height * a / 2.0 * half_sinc * half_sinc, height * sinc, 0.0);
        axis + self.turn(height) * (point - Vec3::Y * height)
    }
}

/// sin x / x.
fn sinc(x: f32) -> f32 {
    if x == 0.0 { 1.0 } else { x.sin() / x }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_are_the_slopes_of_places() {
        for angle in [0.0, 0.3, 1.57, 3.1] {
            let bend = Bend { length: 1.6, angle };
            for height in [-1.0, -0.7, 0.0, 0.2, 0.79] {
                let at = |y: f32| bend.place(Vec3::Y * y);
                let slope = (at(height + 5e-3) - at(height - 5e-3)) / 1e-2;
                let turned = bend.turn(height) * Vec3::Y;
                assert!(
                    slope.distance(turned) < 2e-3,
                    "{angle} {height}: {slope} {turned}"
                );
            }
        }
    }
}
