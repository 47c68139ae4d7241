//! Spheres by plain clustering (Lloyd 1982): each piece of the body goes to the nearest centre, each sphere becomes
//! the smallest one around its pieces, and so on until nothing changes.
//!
//! It knows nothing of what is inside the body and what is not: that is what a variational fit adds.

use super::outside::winding;
use super::{Ball, squared_distance};
use crate::raycast::Triangle;
use crate::vec3::{Vec3, add, scale, sub};

/// Rounds at most; most meshes need fewer.
const ROUNDS: usize = 60;

/// At most `count` spheres that bound the surface, cut into pieces, and a grid of points inside. Without triangles or
/// with a `count` of 0 there are none.
pub fn spheres(triangles: &[Triangle], count: usize) -> Vec<Ball> {
    let pieces = pieces(triangles, 120 * count.max(30));
    if count == 0 || pieces.is_empty() {
        return Vec::new();
    }
    let middles: Vec<Vec3> = pieces
        .iter()
        .map(|t| scale(add(add(t[0], t[1]), t[2]), 1.0 / 3.0))
        .collect();
    let mut centers = scattered(&middles, count);
    let clustered = |centers: &[Vec3]| {
        let mut clusters: Vec<Vec<Vec3>> = vec![Vec::new(); centers.len()];
        for (piece, middle) in pieces.iter().zip(&middles) {
            clusters[nearest(*middle, centers)].extend(piece);
        }
        clusters
    };
    for _ in 0..ROUNDS {
        let balls = clustered(&centers).into_iter();
        let moved: Vec<Vec3> = balls
            .filter_map(|points| Ball::nearly_around(&points, 60))
            .map(|ball| ball.center)
            .collect();
        if moved == centers {
            break;
        }
        centers = moved;
    }
    let clusters = clustered(&centers).into_iter();
    clusters
        .filter_map(|points| Ball::around(&points))
        .collect()
}

/// The surface in at least `target` pieces of like size, and points inside on a grid, as pieces without extent.
fn pieces(triangles: &[Triangle], target: usize) -> Vec<Triangle> {
    let area = |[a, b, c]: &Triangle| {
        0.5 * crate::vec3::length(crate::vec3::cross(sub(*b, *a), sub(*c, *a)))
    };
    let all: f64 = triangles.iter().map(area).sum();
    let edge = (4.0 * all / target as f64).sqrt();
    let mut open = triangles.to_vec();
    let mut pieces = Vec::new();
    while let Some([a, b, c]) = open.pop() {
        let longest = [(a, b, c), (b, c, a), (c, a, b)]
            .into_iter()
            .max_by(|x, y| squared_distance(x.0, x.1).total_cmp(&squared_distance(y.0, y.1)));
        match longest {
            Some((a, b, c)) if squared_distance(a, b) > edge * edge => {
                let middle = scale(add(a, b), 0.5);
                open.extend([[a, middle, c], [middle, b, c]]);
            }
            _ => pieces.push([a, b, c]),
        }
    }
    pieces.extend(inner(triangles).into_iter().map(|p| [p; 3]));
    pieces
}

/// Points inside the mesh, on a grid with 16 along its longest side.
fn inner(triangles: &[Triangle]) -> Vec<Vec3> {
    let corners = || triangles.iter().flatten().copied();
    let least = |a: Vec3, b: Vec3| [0, 1, 2].map(|k| a[k].min(b[k]));
    let most = |a: Vec3, b: Vec3| [0, 1, 2].map(|k| a[k].max(b[k]));
    let (Some(low), Some(high)) = (corners().reduce(least), corners().reduce(most)) else {
        return Vec::new();
    };
    let spacing = sub(high, low).into_iter().fold(0.0, f64::max) / 16.0;
    let at = |k: usize| [k % 16, k / 16 % 16, k / 256].map(|i| (i as f64 + 0.5) * spacing);
    (0..16 * 16 * 16)
        .map(|k| add(low, at(k)))
        .filter(|p| (0..3).all(|k| p[k] < high[k]) && winding(*p, triangles) > 0.5)
        .collect()
}

/// Points as far from each other as can be, one after the other.
fn scattered(points: &[Vec3], count: usize) -> Vec<Vec3> {
    let mut centers = vec![points[0]];
    let mut distance = vec![f64::INFINITY; points.len()];
    while centers.len() < count.min(points.len()) {
        let newest = centers[centers.len() - 1];
        for (d, p) in distance.iter_mut().zip(points) {
            *d = d.min(squared_distance(*p, newest));
        }
        let farthest = (0..points.len()).max_by(|&a, &b| distance[a].total_cmp(&distance[b]));
        centers.extend(farthest.map(|i| points[i]));
    }
    centers
}

fn nearest(point: Vec3, centers: &[Vec3]) -> usize {
    (0..centers.len())
        .min_by(|&a, &b| {
            squared_distance(point, centers[a]).total_cmp(&squared_distance(point, centers[b]))
        })
        .unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raycast::triangles;
    use sh_bake::shapes;

    #[test]
    fn every_piece_lies_in_a_sphere() {
        let knot = triangles(&shapes::torus_knot(2, 3, 1.0, 0.4, 0.15));
        let set = spheres(&knot, 20);
        assert_eq!(set.len(), 20);
        for piece in pieces(&knot, 3_600) {
            let holds = |b: &Ball| {
                piece
                    .iter()
                    .all(|p| squared_distance(*p, b.center) <= b.radius.powi(2) * (1.0 + 1e-12))
            };
            assert!(set.iter().any(holds), "{piece:?}");
        }
        assert!(spheres(&knot, 0).is_empty() && spheres(&[], 5).is_empty());
    }

    #[test]
    fn two_bodies_far_apart_are_two_spheres() {
        let ball = triangles(&shapes::ball(1.0, 2));
        let away = |t: &Triangle| t.map(|p| add(p, [9.0, 0.0, 0.0]));
        let both: Vec<Triangle> = ball.iter().copied().chain(ball.iter().map(away)).collect();
        let set = spheres(&both, 2);
        assert!(set.iter().all(|b| (b.radius - 1.0).abs() < 1e-2), "{set:?}");
    }
}
