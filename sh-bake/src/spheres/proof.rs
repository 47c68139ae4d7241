//! The proof that balls cover a triangle, and the repair where they do not.
//!
//! A triangle lies in a ball if its three corners do, because a ball is convex. So a set of balls covers a
//! triangle if the triangle can be cut into pieces each of which has its corners in one ball.

use super::solid::greater;
use glam::DVec3;

/// A ball: centre and radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ball {
    pub(crate) center: DVec3,
    pub(crate) radius: f64,
}

impl Ball {
    /// Whether the triangle lies in the ball.
    pub(crate) fn holds(&self, corners: &[DVec3; 3]) -> bool {
        self.needs(corners) <= self.radius
    }

    /// The radius that the ball needs to hold the triangle.
    pub(crate) fn needs(&self, corners: &[DVec3; 3]) -> f64 {
        let [a, b, c] = corners.map(|p| p.distance_squared(self.center));
        greater(greater(a, b), c).sqrt()
    }
}

/// A triangle cut across its longest edge.
pub(crate) fn halves([a, b, c]: [DVec3; 3]) -> [[DVec3; 3]; 2] {
    let (ab, bc, ca) = (
        a.distance_squared(b),
        b.distance_squared(c),
        c.distance_squared(a),
    );
    let (a, b, c) = if ab >= bc && ab >= ca {
        (a, b, c)
    } else if bc >= ca {
        (b, c, a)
    } else {
        (c, a, b)
    };
    // Sums commute bit by bit, so that neighbours cut a common edge at the same point.
    let middle = (a + b) * 0.5;
    [[a, middle, c], [middle, b, c]]
}

/// The longest edge of a triangle, squared.
pub(crate) fn longest_squared([a, b, c]: &[DVec3; 3]) -> f64 {
    a.distance_squared(*b)
        .max(b.distance_squared(*c))
        .max(c.distance_squared(*a))
}

/// Grows balls until they cover the triangle: where no cut into pieces of at least `finest` length shows
/// that they do, the ball that has to grow least grows. `grown` is told of each growth.
pub(crate) fn ensure(balls: &mut [Ball], triangle: [DVec3; 3], finest: f64) {
    let mut open = vec![triangle];
    while let Some(t) = open.pop() {
        if balls.iter().any(|ball| ball.holds(&t)) {
            continue;
        }
        if longest_squared(&t) > finest * finest {
            open.extend(halves(t));
            continue;
        }
        let growth = |ball: &Ball| ball.needs(&t) - ball.radius;
        if let Some(ball) = balls
            .iter_mut()
            .min_by(|a, b| growth(a).total_cmp(&growth(b)))
        {
            ball.radius = ball.needs(&t);
        }
    }
}

/// A point near which the balls are not proven to cover the triangle, or none if they are. The triangle
/// is cut at most `depth` times over.
pub(crate) fn uncovered(balls: &[Ball], triangle: [DVec3; 3], depth: u32) -> Option<DVec3> {
    // Only a ball that reaches into a piece can hold a part of it: the list shrinks on the way down.
    let [a, b, c] = triangle;
    let middle = (a + b + c) / 3.0;
    let reach = longest_squared(&triangle).sqrt();
    let near: Vec<Ball> = balls
        .iter()
        .filter(|ball| ball.center.distance(middle) <= ball.radius + reach)
        .copied()
        .collect();
    if near.iter().any(|ball| ball.holds(&triangle)) {
        return None;
    }
    if near.is_empty() || depth == 0 {
        return Some(middle);
    }
    halves(triangle)
        .into_iter()
        .find_map(|half| uncovered(&near, half, depth - 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRIANGLE: [DVec3; 3] = [DVec3::ZERO, DVec3::X, DVec3::Y];

    #[test]
    fn a_gap_between_balls_is_found_and_closed() {
        let ball = |x: f64, y: f64, radius| Ball {
            center: DVec3::new(x, y, 0.0),
            radius,
        };
        let mut balls = vec![
            ball(0.1, 0.1, 0.45),
            ball(0.9, 0.0, 0.45),
            ball(0.0, 0.9, 0.45),
        ];
        // The middle of the longest edge, (½, ½), lies in none.
        let hole = uncovered(&balls, TRIANGLE, 16).expect("there is a hole");
        assert!(
            balls
                .iter()
                .all(|b| b.center.distance(hole) > b.radius * 0.99),
            "{hole}"
        );
        ensure(&mut balls, TRIANGLE, 1e-3);
        assert_eq!(uncovered(&balls, TRIANGLE, 30), None);
        assert!(balls.iter().all(|b| b.radius < 0.6), "{balls:?}");
    }

    #[test]
    fn one_ball_around_all_covers_at_once() {
        let balls = [Ball {
            center: DVec3::ZERO,
            radius: 1.0,
        }];
        assert_eq!(uncovered(&balls, TRIANGLE, 0), None);
        assert!(uncovered(&[], TRIANGLE, 5).is_some());
    }
}
