//! What part of a body's surface a sphere stands for, and what of it is seen in a direction (Guerrero et al. 2008,
//! section 4.2).
//!
//! A point belongs to the sphere from which it is farthest away relative to none: the one of the least |p − c|/r
//! (eq. 2), of several the first. What a sphere looks like from direction ω is looked up along the line through its
//! centre, among the places where the line leaves the solid:
//!
//! 1. ahead of the centre, the farthest of those that belong to the sphere;
//! 2. if all ahead belong to others, none: the others stand before it;
//! 3. if there is none ahead, the centre lies outside the solid, and what is seen is behind it: the nearest there.
//!
//! The paper's opposite ray meets front sides in the third case: as seen along ω itself the line leaves by them. So all
//! three are one rule, the farthest place along ω, and its outside always faces along ω. Behind the centre, too, only
//! what belongs to the sphere counts.
//!
//! Where the mesh is open there may be no solid. A centre that is more than half enclosed (the same winding number that
//! shadows use) counts as inside: back sides count, and a line that meets none leaves by a hole, behind which it is dark.
//! Around any other centre there is a sheet: both its sides count, each as the outside that is seen.

use super::part::Part;
use super::shell::{Crossing, Shell};
use crate::spheres::winding::{INSIDE, Winding};
use glam::DVec3;
use sh_scene::Sphere;

/// A body as its spheres see it.
pub(super) struct Body {
    pub(super) shell: Shell,
    /// The spheres' centres and radii; none of those that have no radius.
    balls: Vec<Option<(DVec3, f64)>>,
    sides: Sides,
}

enum Sides {
    /// 1, or −1 where triangles face inwards.
    Closed(f64),
    Open(Winding),
}

/// What is seen of a sphere along a line.
#[derive(Clone, Copy, Debug)]
pub(super) enum Seen {
    /// A place that belongs to it.
    Surface(Crossing),
    /// Only places that belong to other spheres.
    Others,
    /// No place at all: the line meets the body nowhere, or leaves it by a hole.
    Nothing,
}

/// One sphere and what is near it.
pub(super) struct Seat<'a> {
    shell: &'a Shell,
    center: DVec3,
    radius: f64,
    /// The other spheres, nearest surfaces first, and whether they come before this one.
    others: Vec<(DVec3, f64, bool)>,
    /// 1 or −1 where lines leave by the triangles' backs or fronts, 0 where they leave by both.
    outward: f64,
    /// Whether a line that leaves nowhere ahead is followed back.
    back: bool,
    /// Room for crossings, and the one of the others that was nearer the last time.
    found: Vec<Crossing>,
    last: usize,
}

impl Body {
    pub(super) fn new(parts: &[Part], spheres: &[Sphere]) -> Self {
        let shell = Shell::new(parts);
        let meshes: Vec<_> = parts.iter().map(|(mesh, _)| *mesh).collect();
        let sides = if crate::is_closed(&meshes) {
            Sides::Closed(if shell.volume() < 0.0 { -1.0 } else { 1.0 })
        } else {
            let (points, triangles) = crate::spheres::joined(&meshes);
            Sides::Open(Winding::new(&points, &triangles))
        };
        let ball = |s: &Sphere| {
            let center = DVec3::from(s.center.map(f64::from));
            let radius = f64::from(s.radius);
            (center.is_finite() && radius > 0.0 && radius.is_finite()).then_some((center, radius))
        };
        Self {
            shell,
            balls: spheres.iter().map(ball).collect(),
            sides,
        }
    }

    /// A sphere's view; none of one without a radius, which stands for nothing.
    pub(super) fn seat(&self, sphere: usize) -> Option<Seat<'_>> {
        let (center, radius) = self.balls[sphere]?;
        let others = self.balls.iter().enumerate().filter(|(k, _)| *k != sphere);
        let mut others: Vec<(DVec3, f64, bool)> = others
            .filter_map(|(k, ball)| ball.map(|(c, r)| (c, r, k < sphere)))
            .collect();
        let gap = |(c, r, _): &(DVec3, f64, bool)| center.distance(*c) - r;
        others.sort_by(|a, b| gap(a).total_cmp(&gap(b)));
        let (outward, back) = match &self.sides {
            Sides::Closed(outward) => (*outward, true),
            Sides::Open(winding) => match winding.at(center) {
                around if around.abs() > INSIDE => (around.signum(), false),
                _ => (0.0, true),
            },
        };
        Some(Seat {
            shell: &self.shell,
            center,
            radius,
            others,
            outward,
            back,
            found: Vec::new(),
            last: 0,
        })
    }
}

impl Seat<'_> {
    /// What is seen of the sphere from a direction, a unit vector.
    pub(super) fn seen(&mut self, direction: DVec3) -> Seen {
        let mut found = std::mem::take(&mut self.found);
        found.clear();
        self.shell.crossings(self.center, direction, &mut found);
        found.retain(|c| self.counts(c));
        if found.is_empty() && self.back {
            self.shell.crossings(self.center, -direction, &mut found);
            for crossing in &mut found {
                crossing.distance = -crossing.distance;
                crossing.leaves = !crossing.leaves;
            }
            found.retain(|c| self.counts(c));
        }
        // The farthest first; of two in one place, as on an edge, the first of the mesh.
        found.sort_by(|a, b| {
            let place = |c: &Crossing| (c.part, c.triangle);
            let farther = b.distance.total_cmp(&a.distance);
            farther.then_with(|| place(a).cmp(&place(b)))
        });
        let own = found
            .iter()
            .find(|c| self.owns(self.center + direction * c.distance));
        let seen = match own {
            Some(crossing) => Seen::Surface(*crossing),
            None if found.is_empty() => Seen::Nothing,
            None => Seen::Others,
        };
        self.found = found;
        seen
    }

    /// Whether the line leaves the solid there.
    fn counts(&self, crossing: &Crossing) -> bool {
        match crossing.leaves {
            true => self.outward >= 0.0,
            false => self.outward <= 0.0,
        }
    }

    /// Whether a point of the surface belongs to the sphere.
    fn owns(&mut self, p: DVec3) -> bool {
        let away = p.distance_squared(self.center);
        let radius = self.radius * self.radius;
        // |p − c'|/r' < |p − c|/r without the division.
        let nearer = |&(c, r, before): &(DVec3, f64, bool)| {
            let (theirs, ours) = (p.distance_squared(c) * radius, away * r * r);
            theirs < ours || (theirs == ours && before)
        };
        // Neighbouring lines end at neighbouring points: what was nearer will often be again.
        if self.others.get(self.last).is_some_and(nearer) {
            return false;
        }
        match self.others.iter().position(nearer) {
            Some(other) => {
                self.last = other;
                false
            }
            None => true,
        }
    }

    /// A place at a distance from the centre.
    pub(super) fn place(&self, direction: DVec3, distance: f64) -> DVec3 {
        self.center + direction * distance
    }

    pub(super) fn radius(&self) -> f64 {
        self.radius
    }
}
