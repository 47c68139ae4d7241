//! How far a mesh goes around a point, for meshes that are not closed.
//!
//! The generalised winding number (Jacobson, Kavan and Sorkine-Hornung 2013, equation 5) is the sum of the solid angles
//! of all triangles over 4π: 1 inside a closed mesh, 0 outside, and in between where there are holes. What is more than
//! half enclosed counts as inside. Far triangles are taken together, as one dipole a group (Barill et al. 2018, "Fast
//! winding numbers for soups and clouds", first order), near ones each for itself (van Oosterom and Strackee 1983).

use glam::DVec3;
use std::f64::consts::PI;

/// Winding numbers above this are inside: a half, and what the dipoles may be wrong.
pub(crate) const INSIDE: f64 = 0.51;
/// A group is far where the point is this many of its radii away.
const FAR: f64 = 5.0;
/// Triangles in a group that is not divided.
const LEAF: usize = 8;

/// Triangles in groups.
pub(crate) struct Winding {
    triangles: Vec<[DVec3; 3]>,
    /// The tree, depth first; a node's first child follows it.
    nodes: Vec<Node>,
}

struct Node {
    /// The middle by area, how far its triangles reach from there, and their normals times area.
    center: DVec3,
    radius: f64,
    dipole: DVec3,
    first: u32,
    count: u32,
    /// The node after all that are below this one.
    next: u32,
}

impl Winding {
    pub(crate) fn new(points: &[DVec3], triangles: &[[u32; 3]]) -> Self {
        let corners = triangles.iter().map(|t| t.map(|i| points[i as usize]));
        let mut tree = Self {
            triangles: corners.collect(),
            nodes: Vec::new(),
        };
        if !tree.triangles.is_empty() {
            tree.divide(0, tree.triangles.len());
        }
        tree
    }

    fn divide(&mut self, first: usize, count: usize) {
        let group = &mut self.triangles[first..first + count];
        let middle = |[a, b, c]: &[DVec3; 3]| (a + b + c) / 3.0;
        let normal = |[a, b, c]: &[DVec3; 3]| (b - a).cross(c - a) * 0.5;
        let area: f64 = group.iter().map(|t| normal(t).length()).sum();
        let weighted: DVec3 = group.iter().map(|t| middle(t) * normal(t).length()).sum();
        let low = group.iter().fold(DVec3::INFINITY, |a, t| a.min(middle(t)));
        let high = group
            .iter()
            .fold(DVec3::NEG_INFINITY, |a, t| a.max(middle(t)));
        let center = if area > 0.0 {
            weighted / area
        } else {
            0.5 * (low + high)
        };
        let reach = group.iter().flatten().map(|p| p.distance(center));
        let node = Node {
            center,
            radius: reach.fold(0.0, f64::max),
            dipole: group.iter().map(normal).sum(),
            first: first as u32,
            count: count as u32,
            next: 0,
        };
        let axis = (high - low).max_position();
        let place = self.nodes.len();
        self.nodes.push(node);
        if count > LEAF {
            let half = count / 2;
            self.triangles[first..first + count]
                .select_nth_unstable_by(half, |a, b| middle(a)[axis].total_cmp(&middle(b)[axis]));
            self.divide(first, half);
            self.divide(first + half, count - half);
        }
        self.nodes[place].next = self.nodes.len() as u32;
    }

    /// The winding number about a point.
    pub(crate) fn at(&self, point: DVec3) -> f64 {
        let (mut sum, mut i) = (0.0, 0);
        while let Some(node) = self.nodes.get(i) {
            let away = node.center - point;
            let distance = away.length();
            if distance > FAR * node.radius {
                sum += node.dipole.dot(away) / distance.powi(3);
                i = node.next as usize;
            } else if node.count as usize <= LEAF {
                let group = node.first as usize..(node.first + node.count) as usize;
                sum += self.triangles[group]
                    .iter()
                    .map(|t| solid_angle(t, point))
                    .sum::<f64>();
                i = node.next as usize;
            } else {
                i += 1;
            }
        }
        sum / (4.0 * PI)
    }
}

/// The solid angle of a triangle, positive where its back is seen.
fn solid_angle(triangle: &[DVec3; 3], point: DVec3) -> f64 {
    let [a, b, c] = triangle.map(|p| p - point);
    let [la, lb, lc] = [a.length(), b.length(), c.length()];
    let lower = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    2.0 * a.dot(b.cross(c)).atan2(lower)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes;

    #[test]
    fn the_tree_agrees_with_the_sum_over_all_triangles() {
        let mesh = shapes::torus_knot(2, 3, 1.0, 0.4, 0.15);
        let points: Vec<DVec3> = mesh
            .positions
            .iter()
            .map(|p| DVec3::from(p.map(f64::from)))
            .collect();
        // A quarter of the knot is missing.
        let triangles = &mesh.triangles[..mesh.triangles.len() * 3 / 4];
        let tree = Winding::new(&points, triangles);
        let mut most: f64 = 0.0;
        for k in 0..2000 {
            let turn = f64::from(k) * 0.618_034;
            let p = DVec3::new(
                (turn * 7.0).sin() * 1.5,
                (turn * 3.0).sin() * 0.6,
                (turn * 11.0).cos() * 1.5,
            );
            let exact: f64 = tree
                .triangles
                .iter()
                .map(|t| solid_angle(t, p))
                .sum::<f64>()
                / (4.0 * PI);
            most = most.max((tree.at(p) - exact).abs());
        }
        assert!(most < INSIDE - 0.5, "{most}");
    }
}
