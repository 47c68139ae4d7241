//! Where one ball around given points has least volume outside the solid.
//!
//! The price of a centre is the outside volume of the smallest ball about it that holds all points. It has
//! many local minima: near the points the ball is small, deeper in the body it is large but mostly inside.
//! So a pattern search (Hooke and Jeeves 1961) starts from the best of several depths. It looks only at
//! points that stand out in some direction; a point that is missed by that is added, and the search goes on.

use super::proof::Ball;
use super::solid::{Disc, Solid, greater};
use glam::DVec3;

/// A ball with its volume outside the solid.
#[derive(Clone, Copy, Debug)]
pub(super) struct Priced {
    pub(super) ball: Ball,
    pub(super) outside: f64,
}

/// Share of a ball's r³ that is added to its price, so that among balls inside the solid the smallest wins.
pub(super) const TIE: f64 = 1e-3;

/// What outside volumes are measured with.
pub(super) struct Placing<'a> {
    pub(super) solid: &'a Solid,
    /// Few chords, for the many places that a search looks at.
    pub(super) coarse: Disc,
    /// More chords, for what is kept: a search finds the place where few chords err most.
    pub(super) fine: Disc,
}

impl Placing<'_> {
    /// The best ball found around `points`. The search starts in `old` and from the middle of the points against
    /// `normal`, which is their mean normal or zero. Around no points it is a ball of radius 0.
    pub(super) fn place(
        &self,
        points: &[DVec3],
        normal: DVec3,
        old: Option<Ball>,
        thorough: bool,
    ) -> Priced {
        let old = old.map(|ball| ball.center);
        if points.is_empty() {
            let center = old.unwrap_or_default();
            return self.priced(Ball {
                center,
                radius: 0.0,
            });
        }
        let mut active = outstanding(points);
        let middle = enclosing_center(&active, if thorough { 32 } else { 12 });
        let searched = self.search(points, &mut active, middle, normal, old, thorough);
        let mut best = self.priced(searched);
        if thorough {
            // Two more candidates, which few chords may have passed over.
            for center in [Some(middle), old].into_iter().flatten() {
                let other = self.priced(around(points, center));
                if other.outside < best.outside {
                    best = other;
                }
            }
        }
        best
    }

    fn search(
        &self,
        points: &[DVec3],
        active: &mut Vec<DVec3>,
        middle: DVec3,
        normal: DVec3,
        old: Option<DVec3>,
        thorough: bool,
    ) -> Ball {
        let finest = if thorough { 0.005 } else { 0.02 };
        let size = around(active, middle).radius;
        let starts = [0.0, 0.35, 0.8, 1.5, 3.0].map(|depth| middle - normal * (size * depth));
        let mut best = self.price(active, middle);
        for start in starts[1..].iter().copied().chain(old) {
            best = cheaper(best, self.price(active, start));
        }
        let mut step = 0.3 * size.min(best.1.radius);
        // Where the search has come from, which is dearer.
        let mut left = None;
        for _ in 0..10 {
            while step > finest * size {
                let before = best.0;
                let center = best.1.center;
                for offset in [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| axis * step) {
                    for place in [center + offset, center - offset] {
                        if Some(place) != left {
                            best = cheaper(best, self.price(active, place));
                        }
                    }
                }
                // The radius has a crease wherever two points are equally far. Along it no axis need lead down, but
                // the way to the middle of the points that are nearly farthest does.
                let Ball { center, radius } = best.1;
                let inward = inward(active, center, radius - step);
                best = cheaper(best, self.price(active, center + inward * step));
                if best.0 >= before {
                    step *= 0.5;
                } else {
                    left = Some(center);
                }
            }
            let missed = farthest(points, best.1.center);
            if missed.distance(best.1.center) <= best.1.radius {
                return best.1;
            }
            active.push(missed);
            left = None;
            best = self.price(active, best.1.center);
            step = 0.05 * size;
        }
        around(points, best.1.center)
    }

    /// The price of a centre, with its ball.
    fn price(&self, points: &[DVec3], center: DVec3) -> (f64, Ball) {
        let ball = around(points, center);
        (
            self.rough(center, ball.radius) + TIE * ball.radius.powi(3),
            ball,
        )
    }

    /// A ball's outside volume, roughly.
    pub(super) fn rough(&self, center: DVec3, radius: f64) -> f64 {
        self.solid.outside(center, radius, &self.coarse)
    }

    /// A ball with its outside volume.
    pub(super) fn priced(&self, ball: Ball) -> Priced {
        Priced {
            ball,
            outside: self.solid.outside(ball.center, ball.radius, &self.fine),
        }
    }
}

fn cheaper(a: (f64, Ball), b: (f64, Ball)) -> (f64, Ball) {
    if b.0 < a.0 { b } else { a }
}

/// The ball about a centre that reaches all points.
fn around(points: &[DVec3], center: DVec3) -> Ball {
    let squared = points
        .iter()
        .map(|p| p.distance_squared(center))
        .fold(0.0, greater);
    Ball {
        center,
        radius: squared.sqrt(),
    }
}

/// The direction to the middle of the points at least `least` away.
fn inward(points: &[DVec3], center: DVec3, least: f64) -> DVec3 {
    let squared = least.max(0.0).powi(2);
    let far = points
        .iter()
        .filter(|p| p.distance_squared(center) >= squared);
    far.map(|p| p - center).sum::<DVec3>().normalize_or_zero()
}

/// The points that lie farthest in one of 26 directions; all of them where they are few.
fn outstanding(points: &[DVec3]) -> Vec<DVec3> {
    if points.len() <= 32 {
        return points.to_vec();
    }
    let mut found: Vec<usize> = Vec::with_capacity(26);
    for k in 14..27 {
        let direction = DVec3::new(
            f64::from(k % 3 - 1),
            f64::from(k / 3 % 3 - 1),
            f64::from(k / 9 - 1),
        );
        let (mut least, mut most) = ((0, f64::INFINITY), (0, f64::NEG_INFINITY));
        for (i, p) in points.iter().enumerate() {
            let at = p.dot(direction);
            if at < least.1 {
                least = (i, at);
            }
            if at > most.1 {
                most = (i, at);
            }
        }
        for i in [least.0, most.0] {
            if !found.contains(&i) {
                found.push(i);
            }
        }
    }
    found.into_iter().map(|i| points[i]).collect()
}

/// Nearly the centre of the smallest ball around the points: `steps` of Bădoiu and Clarkson 2003, towards the
/// farthest point by 1 / (k + 1), and then twice as many that shrink faster, as those would take thousands to come
/// nearer than a hundredth of the radius.
fn enclosing_center(points: &[DVec3], steps: u32) -> DVec3 {
    let mut center = points.iter().sum::<DVec3>() / points.len() as f64;
    for k in 1..=steps {
        center += (farthest(points, center) - center) / f64::from(k + 1);
    }
    let mut step = 1.0 / f64::from(steps + 1);
    for _ in 0..2 * steps {
        center += (farthest(points, center) - center) * step;
        step *= 0.9;
    }
    center
}

/// The point farthest from another. `points` is not empty.
pub(super) fn farthest(points: &[DVec3], from: DVec3) -> DVec3 {
    let (mut best, mut most) = (from, -1.0);
    for p in points {
        let distance = p.distance_squared(from);
        if distance > most {
            (best, most) = (*p, distance);
        }
    }
    best
}

/// E of equation (35).
pub(super) fn total(balls: &[Priced]) -> f64 {
    balls.iter().map(|b| b.outside).sum()
}
