//! Capsules in the world: what bodies of the benches are made of.

use glam::{Vec3, Vec3A};
use obvhs::triangle::Triangle;
use std::f32::consts::{PI, TAU};

/// A capsule in the world.
#[derive(Clone, Copy, Debug)]
pub struct Capsule {
    /// One end of its axis.
    pub from: Vec3,
    /// The other end.
    pub to: Vec3,
    /// Its radius.
    pub radius: f32,
}

impl Capsule {
    /// The point of the axis that is nearest.
    pub fn nearest(&self, point: Vec3) -> Vec3 {
        self.from.lerp(self.to, self.along(point))
    }

    /// Where on the axis that is: 0 to 1.
    fn along(&self, point: Vec3) -> f32 {
        let axis = self.to - self.from;
        let t = (point - self.from).dot(axis) / axis.length_squared().max(f32::MIN_POSITIVE);
        t.clamp(0.0, 1.0)
    }

    /// How far a point is from the surface; below 0 inside.
    pub fn distance(&self, point: Vec3) -> f32 {
        point.distance(self.nearest(point)) - self.radius
    }

    /// Whether a ray from a point along a unit vector comes nearer to the axis than the radius. The square of the distance
    /// between points of the ray and of the axis is convex in where both are, so each follows from the other by clamping
    /// (Ericson 2005, "Real-time collision detection", section 5.1.9).
    pub fn meets(&self, from: Vec3, way: Vec3) -> bool {
        let (axis, apart) = (self.to - self.from, from - self.from);
        let (square, across) = (axis.length_squared(), axis.dot(way));
        let (on_axis, on_way) = (axis.dot(apart), way.dot(apart));
        // The square of the axis without what runs along the ray.
        let turned = square - across * across;
        let mut t = if turned > 1e-6 * square {
            ((on_axis - across * on_way) / turned).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let mut along = across * t - on_way;
        if along < 0.0 {
            along = 0.0;
            t = self.along(from);
        }
        (apart + way * along).distance_squared(axis * t) < self.radius * self.radius
    }

    /// Where a line leaves: the last of the places where it leaves one of both balls and the cylinder between them.
    pub fn leaves(&self, origin: Vec3, towards: Vec3) -> Option<f32> {
        let ball = |center: Vec3| {
            let away = center - origin;
            let middle = away.dot(towards);
            let square = self.radius * self.radius - (away - towards * middle).length_squared();
            (square >= 0.0).then(|| middle + square.sqrt())
        };
        let cylinder = || {
            let axis = self.to - self.from;
            let length = axis.length();
            let axis = axis.try_normalize()?;
            let away = origin - self.from;
            // Across and along the axis.
            let (start, rise) = (away.dot(axis), towards.dot(axis));
            let (offset, flat) = (away - axis * start, towards - axis * rise);
            let square = flat.length_squared();
            let middle = -offset.dot(flat) / square;
            let inner =
                (self.radius * self.radius - (offset + flat * middle).length_squared()) / square;
            if square < 1e-12 || inner < 0.0 {
                return None;
            }
            let t = middle + inner.sqrt();
            // Beyond the ends the balls count.
            (0.0..=length).contains(&(start + rise * t)).then_some(t)
        };
        let all = [ball(self.from), ball(self.to), cylinder()];
        all.into_iter().flatten().reduce(f32::max)
    }

    /// The surface with so many triangles around; every corner lies on the capsule.
    pub fn triangles(&self, around: usize, out: &mut Vec<Triangle>) {
        let up = (self.to - self.from).normalize_or(Vec3::Y);
        let (side, front) = up.any_orthonormal_pair();
        let rows = around / 4;
        // Latitudes from pole to pole; the equator twice, once for each end.
        let south = (0..=rows).map(|row| (self.from, row as f32 / rows as f32 - 1.0));
        let north = (0..=rows).map(|row| (self.to, row as f32 / rows as f32));
        let rings: Vec<(Vec3, f32)> = south.chain(north).collect();
        let point = |(center, latitude): (Vec3, f32), column: usize| {
            let (rise, flat) = (0.5 * PI * latitude).sin_cos();
            let (sin, cos) = (TAU * column as f32 / around as f32).sin_cos();
            Vec3A::from(center + self.radius * (up * rise + (side * cos + front * sin) * flat))
        };
        for pair in rings.windows(2) {
            for column in 0..around {
                let [a, b] = [column, column + 1].map(|column| point(pair[0], column));
                let [c, d] = [column + 1, column].map(|column| point(pair[1], column));
                if pair[0].1 > -1.0 {
                    out.push(Triangle {
                        v0: a,
                        v1: b,
                        v2: c,
                    });
                }
                if pair[1].1 < 1.0 {
                    out.push(Triangle {
                        v0: a,
                        v1: c,
                        v2: d,
                    });
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against the least distance of many points of the ray and of the axis.
    #[test]
    fn rays_meet_what_they_come_near_to() {
        let ends = [Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.4, 1.5, 0.3)];
        for (from, to) in [(ends[0], ends[1]), (ends[1], ends[1])] {
            let capsule = Capsule {
                from,
                to,
                radius: 0.4,
            };
            let mut met = 0;
            for i in 0..2000 {
                let number = |k: f32| (i as f32 * k).fract();
                let start = Vec3::new(number(0.137), number(0.271), number(0.419)) * 2.0;
                let (sin, cos) = (TAU * number(0.618)).sin_cos();
                let rise = 2.0 * number(0.733) - 1.0;
                let flat = (1.0 - rise * rise).sqrt();
                let way = Vec3::new(flat * cos, rise, flat * sin);
                let nearest = (0..=4000)
                    .map(|k| start + way * (k as f32 * 1e-3))
                    .map(|p| capsule.distance(p))
                    .fold(f32::MAX, f32::min);
                // Steps of a millimetre leave room at the rim.
                if nearest.abs() > 1e-4 {
                    assert_eq!(capsule.meets(start, way), nearest < 0.0);
                    met += u32::from(nearest < 0.0);
                }
            }
            assert!((50..1000).contains(&met), "{met}");
        }
    }
}
