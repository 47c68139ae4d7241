//! Where one ball around given points has least volume outside the solid.
//!
//! The price of a centre is the outside volume of the smallest ball about it that holds all points. It has
//! many local minima: near the points the ball is small, deeper in the body it is large but mostly inside.
//! So a pattern search (Hooke and Jeeves 1961) starts from the best of several depths. It looks only at
//! points that stand out in some direction; a point that is missed by that is added, and the search goes on.

use super::solid::{Disc, Solid};
use super::surface::Ball;
use glam::DVec3;

/// A ball with its volume outside the solid.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Priced {
    pub(crate) ball: Ball,
    pub(crate) outside: f64,
}

/// Share of a ball's r³ that is added to its price, so that among balls inside the solid the smallest wins.
pub(crate) const TIE: f64 = 1e-3;

/// The best ball found around `points`, of which there is at least one. The search starts in `old` and from
/// the middle of the points against `normal`, which is their mean normal or zero.
pub(crate) fn place(
    solid: &Solid,
    disc: &Disc,
    points: &[DVec3],
    normal: DVec3,
    old: Option<DVec3>,
) -> Priced {
    let mut active = outstanding(points);
    let middle = enclosing_center(&active);
    let size = reach(&active, middle);
    let starts = [0.0, 0.35, 0.8, 1.5, 3.0].map(|depth| middle - normal * (size * depth));
    let mut best = price(solid, disc, &active, middle);
    for start in starts[1..].iter().copied().chain(old) {
        best = cheaper(best, price(solid, disc, &active, start));
    }
    let mut step = 0.3 * size.min(best.1.ball.radius);
    for _ in 0..10 {
        while step > 0.005 * size {
            let center = best.1.ball.center;
            let before = best.0;
            for offset in [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| axis * step) {
                best = cheaper(best, price(solid, disc, &active, center + offset));
                best = cheaper(best, price(solid, disc, &active, center - offset));
            }
            if best.0 >= before {
                step *= 0.5;
            }
        }
        let missed = farthest(points, best.1.ball.center);
        if missed.distance(best.1.ball.center) <= best.1.ball.radius {
            return best.1;
        }
        active.push(missed);
        best = price(solid, disc, &active, best.1.ball.center);
        step = 0.05 * size;
    }
    price(solid, disc, points, best.1.ball.center).1
}

/// The price of a centre, with its ball.
fn price(solid: &Solid, disc: &Disc, points: &[DVec3], center: DVec3) -> (f64, Priced) {
    let radius = reach(points, center);
    let outside = solid.outside(center, radius, disc);
    (
        outside + TIE * radius.powi(3),
        Priced {
            ball: Ball { center, radius },
            outside,
        },
    )
}

fn cheaper(a: (f64, Priced), b: (f64, Priced)) -> (f64, Priced) {
    if b.0 < a.0 { b } else { a }
}

/// How far the points reach from a centre.
fn reach(points: &[DVec3], center: DVec3) -> f64 {
    points
        .iter()
        .map(|p| p.distance_squared(center))
        .fold(0.0, f64::max)
        .sqrt()
}

/// The point farthest from a centre.
fn farthest(points: &[DVec3], center: DVec3) -> DVec3 {
    let by = |p: &&DVec3| p.distance_squared(center);
    points
        .iter()
        .max_by(|a, b| by(a).total_cmp(&by(b)))
        .copied()
        .unwrap_or(center)
}

/// The points that lie farthest in one of 26 directions; all of them where they are few.
fn outstanding(points: &[DVec3]) -> Vec<DVec3> {
    if points.len() <= 40 {
        return points.to_vec();
    }
    let mut found = Vec::with_capacity(26);
    for k in (0..27).filter(|k| *k != 13) {
        let direction = DVec3::new(
            f64::from(k % 3 - 1),
            f64::from(k / 3 % 3 - 1),
            f64::from(k / 9 - 1),
        );
        let far = points
            .iter()
            .max_by(|a, b| a.dot(direction).total_cmp(&b.dot(direction)));
        found.extend(far.filter(|p| !found.contains(*p)).copied());
    }
    found
}

/// Nearly the centre of the smallest ball around the points (Bădoiu and Clarkson 2003: step towards the
/// farthest point by 1 / (k + 1)).
fn enclosing_center(points: &[DVec3]) -> DVec3 {
    let mut center = points.iter().sum::<DVec3>() / points.len() as f64;
    for k in 1..=16 {
        center += (farthest(points, center) - center) / f64::from(k + 1);
    }
    center
}
