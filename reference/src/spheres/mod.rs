//! What spheres leave outside a body, exactly, and the sphere sets that a fit has to beat.
//!
//! [`outside`] is the measure: the volume of a ball outside a closed mesh, in closed form. [`octree`] and
//! [`lloyd`] are two simple ways to bound a mesh by spheres, both sound: every point of every triangle lies in
//! one of the spheres, and so does the inside.

pub mod lloyd;
pub mod octree;
pub mod outside;

use crate::vec3::{Vec3, add, dot, scale, sub};

/// A ball in f64.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// The centre.
    pub center: [f64; 3],
    /// The radius, at least 0.
    pub radius: f64,
}

impl Ball {
    /// The ball around the given centre that reaches the farthest of the points.
    fn reaching(center: Vec3, points: &[Vec3]) -> Self {
        let radius = points
            .iter()
            .map(|p| squared_distance(*p, center))
            .fold(0.0, f64::max)
            .sqrt();
        Self { center, radius }
    }

    /// The smallest ball around the points, to a thousandth of its radius: Bădoiu and Clarkson 2003, "Smaller
    /// core-sets for balls", who step towards the farthest point by 1 / (k + 1) of the way. It holds all points
    /// exactly. None for no points.
    pub fn around(points: &[[f64; 3]]) -> Option<Self> {
        Self::nearly_around(points, 1000)
    }

    /// The same in fewer steps: to one part in as many.
    fn nearly_around(points: &[Vec3], steps: u32) -> Option<Self> {
        let mut center = *points.first()?;
        let mut best = Self::reaching(center, points);
        for k in 1..=steps {
            let far = points.iter().copied().max_by(|a, b| {
                squared_distance(*a, center).total_cmp(&squared_distance(*b, center))
            })?;
            center = add(center, scale(sub(far, center), 1.0 / f64::from(k + 1)));
            // The step overshoots at first, so that the best is not always the last.
            if k > steps - steps / 10 {
                let ball = Self::reaching(center, points);
                if ball.radius < best.radius {
                    best = ball;
                }
            }
        }
        Some(best)
    }
}

fn squared_distance(a: Vec3, b: Vec3) -> f64 {
    let d = sub(a, b);
    dot(d, d)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ball_around_a_cube_ends_in_its_corners() {
        let corners: Vec<Vec3> = (0..8)
            .map(|i| [0, 1, 2].map(|k| f64::from(i >> k & 1)))
            .collect();
        let ball = Ball::around(&corners).unwrap();
        assert!((ball.radius - 0.75_f64.sqrt()).abs() < 1e-3, "{ball:?}");
        assert!(
            corners
                .iter()
                .all(|p| squared_distance(*p, ball.center) <= ball.radius.powi(2) * (1.0 + 1e-15))
        );
        assert_eq!(Ball::around(&[]), None);
        assert_eq!(Ball::around(&[[1.0; 3]]).unwrap().radius, 0.0);
    }
}
