//! In which order spheres hide each other.
//!
//! Of two disjoint spheres the one of the lesser *power* |c − p|² − r² is in front, seen from p. Where two intersect,
//! the order changes gradually about the plane on which both powers are equal, over the width of the circle in which
//! they cut each other.

use glam::Vec3;

#[doc(inline)]
pub use sh_core::constants::{MOST_LAMPS, SHARPEST};

/// A sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// Its centre.
    pub center: Vec3,
    /// Its radius.
    pub radius: f32,
}

impl Ball {
    /// The ball about a centre.
    pub fn new(center: [f32; 3], radius: f32) -> Self {
        Self {
            center: center.into(),
            radius,
        }
    }

    /// The power of a point against it, |c − p|² − r²: the square of a tangent's length.
    ///
    /// ```
    /// use sh_scene::order::Ball;
    /// use glam::Vec3;
    /// let ball = Ball::new([0.0, 0.0, 5.0], 3.0);
    /// assert_eq!(ball.power(Vec3::ZERO), 4.0 * 4.0);
    /// assert_eq!(ball.power(ball.center), -3.0 * 3.0);
    /// ```
    pub fn power(&self, from: Vec3) -> f32 {
        self.center.distance_squared(from) - self.radius * self.radius
    }
}

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

/// The slope with which the order of two spheres changes, whose centres are so far `apart`, over the `width` to each side of
/// the plane of equal power: that of the share ½ + slope · (power of the hidden − power of the hider). The difference of
/// powers changes by twice the distance of the centres a metre. Finite where there is no distance, too.
///
/// ```
/// use sh_scene::order::swap_slope;
/// // All is hidden from a width of 0.25 on, where the powers differ by 2 · 4 · 0.25.
/// assert_eq!(swap_slope(0.25, 4.0) * 2.0, 0.5);
/// assert!(swap_slope(0.25, 0.0).is_finite());
/// ```
pub fn swap_slope(width: f32, apart: f32) -> f32 {
    1.0 / (2.0 * width * (2.0 * apart)).max(f32::MIN_POSITIVE)
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
    let apart = hidden.center.distance(hider.center);
    let width = swap_width(hidden.radius, hider.radius, apart);
    let lead = hidden.power(from) - hider.power(from);
    (0.5 + lead * swap_slope(width, apart)).clamp(0.0, 1.0)
}

/// How a lamp and a blocker stand to each other, wherever they are seen from.
///
/// A blocker hides a lamp that it is nearer than, and not one that is nearer. Here it does so less and less while the
/// receiver moves from one to the other past the plane of equal power, since visibility of a finite order has the
/// blocker's shadow beside it as well, and would jump if it went all at once. A lamp within a blocker shines through it.
///
/// ```
/// use sh_scene::order::{Ball, Pair};
/// use glam::Vec3;
/// let lamp = Ball { center: Vec3::Y * 3.0, radius: 0.1 };
/// let at = |y: f32| Ball { center: Vec3::Y * y, radius: 0.5 };
/// assert_eq!(Pair::of(&lamp, &at(1.0)).hides(&lamp, &at(1.0), Vec3::ZERO), 1.0);
/// assert_eq!(Pair::of(&lamp, &at(5.0)).hides(&lamp, &at(5.0), Vec3::ZERO), 0.0);
/// assert_eq!(Pair::of(&lamp, &at(3.2)).hides(&lamp, &at(3.2), Vec3::ZERO), 0.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// The most that the blocker hides of what it covers: 1, less where it holds a part of the lamp, 0 where all of it.
    pub most: f32,
    /// Of that, the share ½ + slope · (power of the lamp − power of the blocker) is hidden, at least 0 and at most all.
    pub slope: f32,
    /// The difference of powers, at the middle of a cluster and less its slack over the cluster's radius, from which on
    /// the blocker hides all that it covers.
    settled: f32,
    /// Twice the distance of both centres: how fast the difference of powers changes.
    twice: f32,
}

impl Pair {
    /// That of a lamp and a blocker.
    pub fn of(lamp: &Ball, blocker: &Ball) -> Self {
        let apart = lamp.center.distance(blocker.center);
        let out = apart - blocker.radius + lamp.radius;
        let twice = 2.0 * apart;
        // From the lamp to the plane of equal power: whoever is behind the lamp, or behind the blocker, has it settled.
        let radii = lamp.radius * lamp.radius - blocker.radius * blocker.radius;
        let ahead = 0.5 * (apart + radii / apart.max(f32::MIN_POSITIVE));
        let gradual = ahead.min(apart - ahead);
        let width = swap_width(lamp.radius, blocker.radius, apart).max(gradual);
        Self {
            most: (out / (2.0 * lamp.radius)).clamp(0.0, 1.0),
            slope: swap_slope(width, apart),
            settled: twice * width,
            twice,
        }
    }

    /// How much of what the blocker covers of the lamp it hides from a place.
    pub fn hides(&self, lamp: &Ball, blocker: &Ball, from: Vec3) -> f32 {
        let lead = lamp.power(from) - blocker.power(from);
        self.most * (0.5 + lead * self.slope).clamp(0.0, 1.0)
    }

    /// Whether the blocker hides all that it covers from every place of a cluster.
    pub fn is_settled(&self, lamp: &Ball, blocker: &Ball, middle: Vec3, radius: f32) -> bool {
        let lead = lamp.power(middle) - blocker.power(middle);
        self.most >= 1.0 && lead >= self.settled + self.twice * radius
    }
}

/// Whether a lamp lies wholly outside of a blocker.
pub fn is_clear(lamp: &Ball, blocker: &Ball) -> bool {
    let reach = lamp.radius + blocker.radius;
    lamp.center.distance_squared(blocker.center) >= reach * reach
}
