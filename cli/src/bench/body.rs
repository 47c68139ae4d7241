//! Bodies of capsules: rigid segments on joints, each with receivers on its surface and spheres along its axis.

use glam::{Affine3A, Quat, Vec3};
use sh_scene::{Receiver, Sphere};
use std::f32::consts::{PI, TAU};

/// A joint that swings, and the capsule that hangs on it.
#[derive(Clone, Copy, Debug)]
pub struct Segment {
    /// The segment that the joint sits on; none: the body's root.
    pub parent: Option<usize>,
    /// Where the joint is, in the parent's space, in metres.
    pub joint: Vec3,
    /// The axis it swings about.
    pub axis: Vec3,
    /// The largest angle, in radians.
    pub swing: f32,
    /// Where in its period it starts, 0 to 1.
    pub phase: f32,
    /// One end of the capsule's axis, seen from the joint.
    pub from: Vec3,
    /// The other end.
    pub to: Vec3,
    /// Its radius.
    pub radius: f32,
}

impl Segment {
    /// A segment that does not swing.
    pub fn still(joint: Vec3, from: Vec3, to: Vec3, radius: f32) -> Self {
        Self {
            parent: None,
            joint,
            axis: Vec3::X,
            swing: 0.0,
            phase: 0.0,
            from,
            to,
            radius,
        }
    }

    /// A ball that does not swing.
    pub fn ball(joint: Vec3, center: Vec3, radius: f32) -> Self {
        Self::still(joint, center, center, radius)
    }

    fn area(&self) -> f32 {
        TAU * self.radius * (self.from.distance(self.to) + 2.0 * self.radius)
    }

    /// Points and normals evenly over the surface, in the segment's space.
    fn receivers(&self, count: usize, object: u32) -> Vec<Receiver> {
        let along = self.to - self.from;
        let length = along.length();
        let up = along.normalize_or(Vec3::Y);
        let (side, front) = up.any_orthonormal_pair();
        let total = length + 2.0 * self.radius;
        (0..count)
            .map(|i| {
                // Area grows evenly along the axis, over the cylinder and over both half balls.
                let h = total * (i as f32 + 0.5) / count as f32;
                let turn = PI * (3.0 - 5.0_f32.sqrt()) * i as f32;
                let middle = (h - self.radius).clamp(0.0, length);
                let rise = ((h - self.radius - middle) / self.radius).clamp(-1.0, 1.0);
                let flat = (1.0 - rise * rise).max(0.0).sqrt();
                let normal = up * rise + (side * turn.cos() + front * turn.sin()) * flat;
                Receiver {
                    position: (self.from + up * middle + normal * self.radius).into(),
                    covered: 1,
                    normal: normal.normalize().into(),
                    object,
                }
            })
            .collect()
    }

    /// Spheres at even steps along the axis that together hold the capsule.
    fn spheres(&self, count: usize) -> Vec<Sphere> {
        let step = self.from.distance(self.to) / count as f32;
        let radius = self.radius.hypot(0.5 * step);
        (0..count)
            .map(|i| Sphere {
                center: self
                    .from
                    .lerp(self.to, (i as f32 + 0.5) / count as f32)
                    .into(),
                radius,
            })
            .collect()
    }
}

/// A body: how many receivers and spheres it has, and how it moves.
#[derive(Clone, Debug)]
pub struct Body {
    /// Its segments, parents before children.
    pub segments: Vec<Segment>,
    /// Receivers on all segments together, shared out by area; none, or one a segment and more.
    pub receivers: usize,
    /// Spheres in all segments together, shared out by length.
    pub spheres: usize,
    /// Clusters of its receivers.
    pub clusters: usize,
    /// Where it stands.
    pub place: Vec3,
    /// Which way it goes.
    pub way: Way,
    /// Steps a second; 0: nothing moves.
    pub pace: f32,
    /// What share of light it reflects, linear Rec.709.
    pub albedo: [f32; 3],
}

/// Which way a body goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Way {
    /// None: its joints alone swing.
    Stands,
    /// Around a circle of this radius about its place, in metres.
    Circle(f32),
    /// From its place along a line, and from its place again.
    Line {
        /// The whole of the line, in metres.
        along: Vec3,
        /// Which part of it lies behind the body at first, 0 to 1.
        start: f32,
    },
}

impl Way {
    /// World from a body that has made so many turns.
    fn at(self, place: Vec3, turns: f32) -> Affine3A {
        match self {
            Self::Stands => Affine3A::from_translation(place),
            Self::Circle(radius) => {
                let offset = Vec3::new(turns.sin(), 0.0, turns.cos()) * radius;
                let facing = Quat::from_rotation_y(turns + PI * 0.5);
                Affine3A::from_rotation_translation(facing, place + offset)
            }
            Self::Line { along, start } => {
                Affine3A::from_translation(place + along * (start + turns).fract())
            }
        }
    }
}

/// The parts of a body in their segments' spaces.
pub struct Parts {
    /// Of each receiver: its segment.
    pub receivers: Vec<(usize, Receiver)>,
    /// Of each sphere: its segment.
    pub spheres: Vec<(usize, Sphere)>,
}

impl Body {
    /// Receivers and spheres of all segments.
    pub fn parts(&self, object: u32) -> Parts {
        let areas: Vec<f32> = self.segments.iter().map(Segment::area).collect();
        let lengths = self
            .segments
            .iter()
            .map(|s| s.from.distance(s.to) / s.radius + 1.0);
        let lengths: Vec<f32> = lengths.collect();
        let receivers = match self.receivers {
            0 => vec![0; areas.len()],
            count => shared_out(count, &areas),
        };
        let spheres = shared_out(self.spheres, &lengths);
        let mut parts = Parts {
            receivers: Vec::new(),
            spheres: Vec::new(),
        };
        for (i, segment) in self.segments.iter().enumerate() {
            let on = segment.receivers(receivers[i], object);
            parts.receivers.extend(on.into_iter().map(|r| (i, r)));
            let along = segment.spheres(spheres[i]);
            parts.spheres.extend(along.into_iter().map(|s| (i, s)));
        }
        parts
    }

    /// World from segment for every segment at a time in seconds.
    pub fn pose(&self, seconds: f32, out: &mut Vec<Affine3A>) {
        let root = self.way.at(self.place, 0.3 * self.pace * seconds);
        let first = out.len();
        for segment in &self.segments {
            let parent = segment.parent.map_or(root, |parent| out[first + parent]);
            let angle = segment.swing * (TAU * (self.pace * seconds + segment.phase)).sin();
            let turn = Quat::from_axis_angle(segment.axis.normalize(), angle);
            out.push(parent * Affine3A::from_rotation_translation(turn, segment.joint));
        }
    }
}

/// Whole numbers, at least 1 each, that add up to `total` and are in proportion to `weights` (largest remainders).
fn shared_out(total: usize, weights: &[f32]) -> Vec<usize> {
    let sum: f32 = weights.iter().sum();
    let rest = total - weights.len();
    let exact: Vec<f32> = weights.iter().map(|w| rest as f32 * w / sum).collect();
    let mut shares: Vec<usize> = exact.iter().map(|&x| 1 + x as usize).collect();
    let mut order: Vec<usize> = (0..weights.len()).collect();
    order.sort_by(|&a, &b| exact[b].fract().total_cmp(&exact[a].fract()));
    let missing = total - shares.iter().sum::<usize>();
    for &i in order.iter().cycle().take(missing) {
        shares[i] += 1;
    }
    shares
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_add_up() {
        for total in [3, 4, 10, 97] {
            let shares = shared_out(total, &[1.0, 2.5, 0.1]);
            assert_eq!(shares.iter().sum::<usize>(), total);
            assert!(shares.iter().all(|&n| n > 0));
        }
    }

    #[test]
    fn spheres_hold_their_capsule_and_receivers_lie_on_it() {
        let segment = Segment::still(
            Vec3::ZERO,
            Vec3::new(0.0, 0.3, 0.1),
            Vec3::new(1.0, 1.0, 0.4),
            0.2,
        );
        let spheres = segment.spheres(6);
        for receiver in segment.receivers(500, 0) {
            let p = Vec3::from(receiver.position);
            // The ends are half balls of the capsule's radius; spheres reach almost there.
            let held = spheres
                .iter()
                .any(|s| p.distance(s.center.into()) < s.radius + 0.1);
            assert!(held, "{p}");
            let axis = segment.to - segment.from;
            let t = ((p - segment.from).dot(axis) / axis.length_squared()).clamp(0.0, 1.0);
            let nearest = segment.from + axis * t;
            assert!((p.distance(nearest) - 0.2).abs() < 1e-4);
            assert!((p - nearest).normalize().dot(receiver.normal.into()) > 0.999);
        }
    }
}
