//! What remains of the edges of circular caps where no other cap covers them: the border of their union.
//!
//! Two edges of angular radii θᵢ, θⱼ whose axes are d apart meet in two points, seen from axis i at azimuths
//! ±h about the direction towards axis j. With s = (θᵢ + θⱼ + d)/2, by the half-angle formula of the
//! spherical triangle of sides θᵢ, d, θⱼ (Todhunter, "Spherical Trigonometry", 1886, chapter IV),
//!
//! ```text
//! tan h/2 = √( sin(s−θᵢ) sin(s−d) / (sin s sin(s−θⱼ)) )
//! ```
//!
//! in which nothing cancels but differences of d and the given angles, which are as good as those. Each point is
//! computed once and turned into an azimuth on both edges, so that the pieces of border join to rounding even
//! where the edges are nearly the same and the point is uncertain along them.

use crate::vec3::{Vec3, add, angle, cross, dot, frame, normalize, scale, sub};
use crate::visibility::Cap;
use std::f64::consts::{PI, TAU};

/// The edge of one cap.
#[derive(Clone, Debug)]
pub(crate) struct Edge {
    /// Unit vector.
    pub axis: Vec3,
    /// Angular radius, in 0..π.
    pub angle: f64,
    /// Azimuth 0 and azimuth π/2 about the axis, seen from outside anticlockwise.
    frame: [Vec3; 2],
    /// Azimuths other caps cover, from a value in 0..2π, at most 2π long.
    covered: Vec<(f64, f64)>,
}

/// The border of the union of caps.
#[derive(Clone, Debug)]
pub(crate) enum Border {
    /// The union is everything.
    All,
    /// Every edge of a cap that lies in no other; none if the union is nothing.
    Edges(Vec<Edge>),
}

/// The border of the union of `caps`. A cap that reaches out of another by at most `slack` (radians) counts as
/// lying in it, a gap not wider as closed and an overlap not wider as none.
pub(crate) fn border(caps: &[Cap], slack: f64) -> Border {
    let mut edges: Vec<Edge> = Vec::new();
    let mut largest_first: Vec<&Cap> = caps.iter().filter(|cap| cap.angle > slack).collect();
    largest_first.sort_by(|a, b| b.angle.total_cmp(&a.angle));
    for cap in largest_first {
        if cap.angle >= PI - slack {
            return Border::All;
        }
        let axis = unit(cap.axis);
        let inside = |edge: &Edge| angle(edge.axis, axis) + cap.angle <= edge.angle + slack;
        if !edges.iter().any(inside) {
            edges.push(Edge {
                axis,
                angle: cap.angle,
                frame: frame(axis),
                covered: Vec::new(),
            });
        }
    }
    for j in 1..edges.len() {
        let (before, rest) = edges.split_at_mut(j);
        for edge in before {
            if !meet(edge, &mut rest[0], slack) {
                return Border::All;
            }
        }
    }
    Border::Edges(edges)
}

/// Notes on both edges what the other's cap covers of them. False if both caps together cover everything.
fn meet(i: &mut Edge, j: &mut Edge, slack: f64) -> bool {
    let d = angle(i.axis, j.axis);
    if d + i.angle + j.angle >= TAU - slack {
        return false;
    }
    if d >= i.angle + j.angle - slack {
        return true;
    }
    let (a, b) = (i.half_width(j, d), j.half_width(i, d));
    // At right angles to both axes. The sum or difference of nearly equal vectors is exact.
    let aside = if dot(i.axis, j.axis) > 0.0 {
        sub(j.axis, i.axis)
    } else {
        add(j.axis, i.axis)
    };
    let normal = normalize(cross(i.axis, aside));
    let towards = cross(normal, i.axis);
    let point = |azimuth: f64| {
        let aside = add(scale(towards, azimuth.cos()), scale(normal, azimuth.sin()));
        add(scale(i.axis, i.angle.cos()), scale(aside, i.angle.sin()))
    };
    // Anticlockwise about axis i from `first` to `last`, about axis j the other way round.
    let (first, last) = (point(-a), point(a));
    i.cover(first, last, 2.0 * a);
    j.cover(last, first, 2.0 * b);
    true
}

impl Edge {
    /// The direction on the edge at an azimuth.
    pub(crate) fn point(&self, azimuth: f64) -> Vec3 {
        let (sin, cos) = self.angle.sin_cos();
        add(scale(self.axis, cos), scale(self.aside(azimuth), sin))
    }

    /// Unit vector there that leaves the cap at right angles to the edge.
    pub(crate) fn outwards(&self, azimuth: f64) -> Vec3 {
        let (sin, cos) = self.angle.sin_cos();
        add(scale(self.axis, -sin), scale(self.aside(azimuth), cos))
    }

    fn aside(&self, azimuth: f64) -> Vec3 {
        let [u, v] = self.frame;
        add(scale(u, azimuth.cos()), scale(v, azimuth.sin()))
    }

    /// Intervals of azimuth in 0..=2π that no other cap covers, ascending.
    pub(crate) fn bare(&self) -> Vec<(f64, f64)> {
        let mut covered = Vec::new();
        for &(from, length) in &self.covered {
            covered.push((from, from + length));
            if from + length > TAU {
                covered.push((0.0, from + length - TAU));
            }
        }
        covered.push((TAU, TAU));
        covered.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut bare = Vec::new();
        let mut until = 0.0;
        for (from, to) in covered {
            if from > until {
                bare.push((until, from));
            }
            until = to.max(until);
        }
        bare
    }

    /// Half the azimuths of this edge within the other's cap, the axes being `d` apart.
    fn half_width(&self, other: &Edge, d: f64) -> f64 {
        let half = |a: f64, b: f64, c: f64| (0.5 * (a + b - c)).sin().max(0.0);
        let above = half(other.angle, d, self.angle) * half(self.angle, other.angle, d);
        let below = half(self.angle, other.angle, -d) * half(self.angle, d, other.angle);
        2.0 * above.sqrt().atan2(below.sqrt())
    }

    /// Notes as covered what lies anticlockwise from `first` to `last`, about `length`. That tells nothing from
    /// everything where the two are the same to rounding.
    fn cover(&mut self, first: Vec3, last: Vec3, length: f64) {
        let [u, v] = self.frame;
        let azimuth = |s: Vec3| dot(s, v).atan2(dot(s, u));
        let from = azimuth(first);
        let off = azimuth(last) - from - length;
        let length = length + off - TAU * (off / TAU).round();
        // A tiny negative azimuth rounds to 2π itself, where nothing would wrap round.
        let from = from.rem_euclid(TAU);
        let from = if from < TAU { from } else { 0.0 };
        self.covered.push((from, length.clamp(0.0, TAU)));
    }
}

/// `axis` of length 1, whatever length it has.
fn unit(axis: Vec3) -> Vec3 {
    let largest = axis.iter().fold(0.0, |a: f64, c| a.max(c.abs()));
    normalize(axis.map(|c| c / largest))
}
