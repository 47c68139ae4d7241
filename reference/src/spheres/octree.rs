//! Spheres around the leaves of an octree: the simplest set that bounds a body (Hubbard 1995, "Collision detection
//! for interactive graphics applications", section 4; one of the two that Ren et al. 2006 compare with).
//!
//! The tree begins with a cube around the mesh. The leaf whose sphere has most volume outside the mesh is cut in
//! eight, as long as no more leaves than asked for result; leaves that hold nothing of the body go. The sphere of
//! a leaf is not drawn around the cube, as Hubbard has it, but as small as it can be around what of the body lies
//! in the cube: that is better by far, and so the comparison is a fair one.

use super::outside::{outside, winding};
use super::{Ball, squared_distance};
use crate::raycast::Triangle;
use crate::vec3::{Vec3, add, scale, sub};

/// A leaf that holds something of the body.
struct Leaf {
    low: Vec3,
    size: f64,
    depth: u32,
    /// The triangles that reach into it.
    triangles: Vec<usize>,
    ball: Ball,
    outside: f64,
}

/// At most `count` spheres that bound the body inside a closed mesh, and its surface. Without triangles or with a
/// `count` of 0 there are none.
pub fn spheres(triangles: &[Triangle], count: usize) -> Vec<Ball> {
    /// No leaf is smaller than 2 to the minus this of the first.
    const DEPTH: u32 = 20;
    let mut leaves: Vec<Leaf> = root(triangles).into_iter().take(count).collect();
    let mut done = Vec::new();
    while !leaves.is_empty() {
        let worst =
            (0..leaves.len()).max_by(|&a, &b| leaves[a].outside.total_cmp(&leaves[b].outside));
        let leaf = leaves.swap_remove(worst.unwrap_or(0));
        let parts = children(&leaf, triangles);
        if leaf.depth < DEPTH && leaves.len() + done.len() + parts.len() <= count {
            leaves.extend(parts);
        } else {
            done.push(leaf);
        }
    }
    done.iter().map(|leaf| leaf.ball).collect()
}

fn root(triangles: &[Triangle]) -> Option<Leaf> {
    let corners = || triangles.iter().flatten().copied();
    let low = corners().reduce(|a, b| [0, 1, 2].map(|k| a[k].min(b[k])))?;
    let high = corners().reduce(|a, b| [0, 1, 2].map(|k| a[k].max(b[k])))?;
    let size = sub(high, low).into_iter().fold(0.0, f64::max);
    let middle = scale(add(low, high), 0.5);
    let low = middle.map(|c| c - 0.5 * size);
    leaf(
        low,
        size,
        0,
        &(0..triangles.len()).collect::<Vec<_>>(),
        triangles,
    )
}

fn children(parent: &Leaf, triangles: &[Triangle]) -> Vec<Leaf> {
    let half = 0.5 * parent.size;
    (0..8)
        .map(|i| [0, 1, 2].map(|k| parent.low[k] + half * f64::from(i >> k & 1)))
        .filter_map(|low| leaf(low, half, parent.depth + 1, &parent.triangles, triangles))
        .collect()
}

/// The leaf with its sphere, or none where it holds nothing of the body.
fn leaf(
    low: Vec3,
    size: f64,
    depth: u32,
    candidates: &[usize],
    triangles: &[Triangle],
) -> Option<Leaf> {
    let mut contents = Vec::new();
    let mut kept = Vec::new();
    for &i in candidates {
        let polygon = clipped(&triangles[i], low, size);
        if !polygon.is_empty() {
            kept.push(i);
            contents.extend(polygon);
        }
    }
    // The body in the cube has its corners where the surface ends at a face or an edge of the cube, which are
    // corners of the clipped triangles, and in those corners of the cube that it holds.
    let corners = (0..8).map(|i| [0, 1, 2].map(|k| low[k] + size * f64::from(i >> k & 1)));
    contents.extend(corners.filter(|c| winding(*c, triangles) > 0.5));
    contents.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
    contents.dedup_by(|a, b| squared_distance(*a, *b) == 0.0);
    let ball = Ball::around(&contents)?;
    Some(Leaf {
        low,
        size,
        depth,
        triangles: kept,
        ball,
        outside: outside(&ball, triangles),
    })
}

/// The part of a triangle in a cube (Sutherland and Hodgman 1974), as the corners of a polygon.
fn clipped(triangle: &Triangle, low: Vec3, size: f64) -> Vec<Vec3> {
    let mut polygon = triangle.to_vec();
    for axis in 0..3 {
        for (sign, limit) in [(1.0, low[axis]), (-1.0, -(low[axis] + size))] {
            let depth = |p: &Vec3| sign * p[axis] - limit;
            let mut next = Vec::with_capacity(polygon.len() + 1);
            for (i, p) in polygon.iter().enumerate() {
                let q = &polygon[(i + 1) % polygon.len()];
                let (a, b) = (depth(p), depth(q));
                if a >= 0.0 {
                    next.push(*p);
                }
                if (a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0) {
                    let mut cut = add(*p, scale(sub(*q, *p), a / (a - b)));
                    cut[axis] = sign * limit;
                    next.push(cut);
                }
            }
            polygon = next;
        }
    }
    polygon
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raycast::triangles;
    use sh_bake::shapes;

    #[test]
    fn a_cube_in_eight_has_eight_spheres_around_smaller_cubes() {
        let cube = triangles(&shapes::rounded_box(glam::Vec3::ONE, 0.0));
        let one = spheres(&cube, 1);
        assert!((one[0].radius - 0.75_f64.sqrt()).abs() < 1e-3, "{one:?}");
        let eight = spheres(&cube, 8);
        assert_eq!(eight.len(), 8);
        assert!(
            eight
                .iter()
                .all(|b| (b.radius - 0.75_f64.sqrt() / 2.0).abs() < 1e-3)
        );
        assert_eq!(spheres(&cube, 7).len(), 1);
        assert!(spheres(&cube, 0).is_empty() && spheres(&[], 5).is_empty());
    }

    #[test]
    fn the_spheres_hold_the_surface_and_the_inside() {
        let knot = triangles(&shapes::torus_knot(2, 3, 1.0, 0.4, 0.15));
        let set = spheres(&knot, 60);
        assert!(set.len() > 50 && set.len() <= 60);
        let held = |p: Vec3| {
            set.iter()
                .any(|b| squared_distance(p, b.center) <= b.radius.powi(2) * (1.0 + 1e-12))
        };
        for t in &knot {
            let middle = scale(add(add(t[0], t[1]), t[2]), 1.0 / 3.0);
            assert!(held(middle) && t.iter().all(|p| held(*p)));
        }
    }
}
