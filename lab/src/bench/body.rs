//! Bodies of capsules: rigid segments on joints, each with receivers on its surface and spheres along its axis.

use super::capsule::Capsule;
use glam::{Affine3A, Quat, Vec3};
use sh_bake::weights_by;
use sh_scene::{Receiver, Sphere};
use std::f32::consts::{PI, TAU};

/// Receivers on a body that its spheres' weights are found with, about.
const WEIGHED: usize = 384;

/// A joint that swings, and the capsule that hangs on it.
#[derive(Clone, Copy, Debug, PartialEq)]
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

    /// Its segments in the world.
    pub fn capsules(&self, poses: &[Affine3A]) -> Vec<Capsule> {
        let capsule = |(segment, pose): (&Segment, &Affine3A)| Capsule {
            from: pose.transform_point3(segment.from),
            to: pose.transform_point3(segment.to),
            radius: segment.radius,
        };
        self.segments.iter().zip(poses).map(capsule).collect()
    }

    /// A weight for each of its spheres, with which they block what its capsules do, where they are at first.
    fn weights(&self) -> Vec<f32> {
        let mut poses = Vec::new();
        self.pose(0.0, &mut poses);
        let (parts, capsules) = (self.parts(1), self.capsules(&poses));
        let on = |(s, sphere): &(usize, Sphere)| placed_sphere(sphere, &poses[*s]);
        let spheres: Vec<Sphere> = parts.spheres.iter().map(on).collect();
        let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        for capsule in &capsules {
            low = low.min(capsule.from.min(capsule.to) - capsule.radius);
            high = high.max(capsule.from.max(capsule.to) + capsule.radius);
        }
        let around = Sphere {
            center: (0.5 * (low + high)).into(),
            radius: 0.5 * low.distance(high),
        };
        let above = |(s, receiver): &(usize, Receiver)| {
            let Receiver {
                position, normal, ..
            } = placed(receiver, &poses[*s]);
            let up = Vec3::from(normal) * (2e-3 * around.radius);
            ((Vec3::from(position) + up).into(), normal)
        };
        let each = parts.receivers.len().div_ceil(WEIGHED).max(1);
        let surface: Vec<_> = parts.receivers.iter().step_by(each).map(above).collect();
        let blocked = |from: [f32; 3], way: [f32; 3]| {
            let (from, way) = (from.into(), way.into());
            capsules.iter().any(|capsule| capsule.meets(from, way))
        };
        weights_by(&spheres, around, [0.0, 1.0, 0.0], &surface, &blocked)
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

/// A weight for each sphere of some bodies, one after another; those that are alike are weighed once.
pub fn weights(bodies: &[Body]) -> Vec<f32> {
    let mut known: Vec<(&Body, Vec<f32>)> = Vec::new();
    let mut all = Vec::new();
    for body in bodies {
        let alike = |(other, _): &&(&Body, Vec<f32>)| {
            other.segments == body.segments && other.spheres == body.spheres
        };
        if let Some((_, weights)) = known.iter().find(alike) {
            all.extend(weights);
        } else {
            let weights = body.weights();
            all.extend(&weights);
            known.push((body, weights));
        }
    }
    all
}

/// A receiver on a segment, in the world.
pub fn placed(receiver: &Receiver, pose: &Affine3A) -> Receiver {
    Receiver {
        position: pose.transform_point3(receiver.position.into()).into(),
        normal: pose.transform_vector3(receiver.normal.into()).into(),
        ..*receiver
    }
}

/// A sphere on a segment, in the world.
pub fn placed_sphere(sphere: &Sphere, pose: &Affine3A) -> Sphere {
    Sphere {
        center: pose.transform_point3(sphere.center.into()).into(),
        ..*sphere
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
