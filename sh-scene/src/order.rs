//! In which order spheres hide each other.
//!
//! Of two disjoint spheres the one of the lesser *power* |c − p|² − r² is in front, seen from p. Where two intersect,
//! the order changes gradually about the plane on which both powers are equal, over the width of the circle in which
//! they cut each other.

use glam::Vec3;

/// A sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// Its centre.
    pub center: Vec3,
    /// Its radius.
    pub radius: f32,
}

/// The least width over which an order changes, over the radius of the smaller sphere.
pub const SHARPEST: f32 = 0.01;

/// Half of the distance over which the order of two spheres changes, whose centres are so far `apart`: the radius of the
/// circle in which they cut each other, at least [`SHARPEST`] of the smaller one's radius.
///
/// ```
/// use sh_scene::order::swap_width;
/// assert_eq!(swap_width(0.5, 0.5, 3.0), 0.005);
/// assert!((swap_width(1.0, 1.0, 1.0) - 0.75_f32.sqrt()).abs() < 1e-6);
/// assert_eq!(swap_width(2.0, 0.5, 0.1), 0.5);
/// ```
pub fn swap_width(a: f32, b: f32, apart: f32) -> f32 {
    let smaller = a.min(b);
    let circle = if apart >= a + b {
        0.0
    } else if apart <= (a - b).abs() {
        smaller
    } else {
        let along = (apart * apart + a * a - b * b) / (2.0 * apart);
        (a * a - along * along).max(0.0).sqrt()
    };
    circle.max(SHARPEST * smaller)
}

/// The share of what the second of two spheres covers of the first that it hides from a place: 0 where it is behind, 1
/// where it is in front.
///
/// ```
/// use sh_scene::order::{Ball, share_of};
/// use glam::Vec3;
/// let [near, far] = [1.0, 4.0].map(|z| Ball { center: Vec3::Z * z, radius: 0.5 });
/// assert_eq!(share_of([&far, &near], Vec3::ZERO), 1.0);
/// assert_eq!(share_of([&near, &far], Vec3::ZERO), 0.0);
/// assert_eq!(share_of([&near, &near], Vec3::ZERO), 0.5);
/// ```
pub fn share_of([hidden, hider]: [&Ball; 2], from: Vec3) -> f32 {
    let power = |ball: &Ball| ball.center.distance_squared(from) - ball.radius * ball.radius;
    let apart = hidden.center.distance(hider.center);
    let width = swap_width(hidden.radius, hider.radius, apart);
    let slope = 1.0 / (4.0 * width * apart).max(f32::MIN_POSITIVE);
    let lead = power(hidden) - power(hider);
    (0.5 + lead * slope.min(f32::MAX)).clamp(0.0, 1.0)
}
