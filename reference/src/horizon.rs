//! What a receiver sees of a sphere that its horizon cuts.

use std::f64::consts::PI;

/// The share of an even sky, weighted by the cosine with the normal, that a sphere hides: `height` of its centre over the
/// tangent plane and `distance` of its centre, both over its radius. The form factor of a sphere, in closed form where the
/// plane cuts it (Snyder 1996, "Area light sources for real-time graphics"). From inside (`distance` below 1) a half space is
/// seen towards the centre.
///
/// ```
/// use sh_reference::horizon::share;
/// // Straight above, wholly below, and a half space overhead.
/// assert_eq!(share(2.0, 2.0), 0.25);
/// assert_eq!(share(-1.0, 3.0), 0.0);
/// assert!((share(1.0, 1.0) - 1.0).abs() < 1e-12);
/// ```
pub fn share(height: f64, distance: f64) -> f64 {
    if distance <= 1.0 {
        return (1.0 + height / distance.max(f64::MIN_POSITIVE)) / 2.0;
    }
    let facing = height / distance;
    let square = distance * distance;
    if height.abs() >= 1.0 {
        return facing.max(0.0) / square;
    }
    // k² = 1 − h²ν², and the tangent's length over the radius.
    let (cut, tangent) = (1.0 - height * height, square - 1.0);
    let inside = -facing * (tangent / (1.0 - facing * facing)).sqrt();
    let arc = facing * inside.clamp(-1.0, 1.0).acos() - (cut * tangent).sqrt();
    ((arc / square + (cut / tangent).sqrt().atan()) / PI).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against a sum over directions.
    #[test]
    fn shares_are_those_of_rays() {
        const STEPS: usize = 1500;
        for (height, distance) in [
            (-0.8, 1.05),
            (-0.3, 1.3),
            (0.0, 1.01),
            (0.0, 4.0),
            (0.5, 1.1),
            (0.9, 2.0),
            (1.4, 3.0),
        ] {
            let facing: f64 = height / distance;
            let flat = (1.0 - facing * facing).sqrt();
            let edge = (1.0 - 1.0 / (distance * distance)).sqrt();
            let mut hidden = 0;
            for i in 0..STEPS {
                for j in 0..STEPS {
                    // Evenly over the disc under the hemisphere: in proportion to the cosine.
                    let at = |k: usize| (k as f64 + 0.5) / STEPS as f64;
                    let (radius, turn) = (at(i).sqrt(), 2.0 * PI * at(j));
                    let up = (1.0 - radius * radius).sqrt();
                    hidden += u32::from(up * facing + radius * turn.cos() * flat > edge);
                }
            }
            let found = f64::from(hidden) / (STEPS * STEPS) as f64;
            let exact = share(height, distance);
            assert!(
                (found - exact).abs() < 1e-3,
                "{height} {distance}: {found} {exact}"
            );
        }
    }

    #[test]
    fn shares_join_where_the_plane_touches() {
        for distance in [1.0001, 1.2, 2.0, 10.0] {
            let [cut, whole] = [1.0 - 1e-9, 1.0].map(|height| share(height, distance));
            assert!((cut - whole).abs() < 1e-6, "{distance}: {cut} {whole}");
            assert!(share(-1.0 + 1e-6, distance) < 1e-6, "{distance}");
        }
    }
}
