//! Mean value coordinates: a point as a weighted sum of a closed mesh's vertices.

use glam::DVec3;
use std::f64::consts::PI;

/// Unit vectors to two vertices span an angle whose sine is at least this, and a point's height over a
/// triangle's plane, over its distance from the corners, is so much before the plane counts as met.
const FLAT: f64 = 1e-9;

/// The weights λ, one for each point, with Σ λ = 1 and Σ λ p = `x`, of Ju, Schaefer and Warren 2005 ("Mean
/// value coordinates for closed triangular meshes", figure 4): smooth, and not negative inside convex meshes.
/// On a vertex, an edge or a triangle they are the barycentric coordinates there. Takes time linear in the
/// mesh; computed in double precision.
///
/// None where the weights have no sum to divide by. Of a mesh that is not closed the weights do not sum to
/// the point: [`error`] tells.
pub(crate) fn mean_value(points: &[DVec3], triangles: &[[u32; 3]], x: DVec3) -> Option<Vec<f64>> {
    let mut weights = vec![0.0; points.len()];
    for t in triangles {
        let corners = t.map(|i| points[i as usize] - x);
        let distances = corners.map(DVec3::length);
        let longest = distances.iter().fold(0.0, |a: f64, d| a.max(*d));
        if let Some(k) = distances.iter().position(|d| *d <= 1e-12 * longest) {
            // On a vertex.
            weights.fill(0.0);
            weights[t[k] as usize] = 1.0;
            return Some(weights);
        }
        let [u, v, w] = [0, 1, 2].map(|k| corners[k] / distances[k]);
        // Between the two other corners, as seen from x; unlike an arc sine accurate up to a half turn (Kahan 2006).
        let angles =
            [(v, w), (w, u), (u, v)].map(|(a, b)| 2.0 * a.distance(b).atan2((a + b).length()));
        let half = (angles[0] + angles[1] + angles[2]) / 2.0;
        if PI - half < 1e-8 {
            // On the triangle, or on one of its edges.
            weights.fill(0.0);
            for k in 0..3 {
                let [next, last] = [distances[(k + 1) % 3], distances[(k + 2) % 3]];
                weights[t[k] as usize] += angles[k].sin() * next * last;
            }
            return normalised(weights);
        }
        let sines = angles.map(f64::sin);
        if sines.iter().any(|s| *s < FLAT) {
            continue;
        }
        // The spherical triangle's angles by the half-angle formula.
        let cosines = [0, 1, 2].map(|k| {
            let sides = sines[(k + 1) % 3] * sines[(k + 2) % 3];
            2.0 * half.sin() * (half - angles[k]).sin() / sides - 1.0
        });
        let side = u.dot(v.cross(w)).signum();
        let signed = cosines.map(|c| side * (1.0 - c * c).max(0.0).sqrt());
        if signed.iter().any(|s| s.abs() < FLAT) {
            // In the triangle's plane, beside it.
            continue;
        }
        for k in 0..3 {
            let (next, last) = ((k + 1) % 3, (k + 2) % 3);
            let above = angles[k] - cosines[next] * angles[last] - cosines[last] * angles[next];
            weights[t[k] as usize] += above / (distances[k] * sines[next] * signed[last]);
        }
    }
    normalised(weights)
}

/// The weights divided by their sum, where that is more than rounding left of them.
fn normalised(mut weights: Vec<f64>) -> Option<Vec<f64>> {
    let sum: f64 = weights.iter().sum();
    let size: f64 = weights.iter().map(|w| w.abs()).sum();
    if sum.is_nan() || sum.abs() <= 1e-6 * size {
        return None;
    }
    weights.iter_mut().for_each(|w| *w /= sum);
    Some(weights)
}

/// How far Σ λ p is from `x`.
pub(crate) fn error(points: &[DVec3], weights: &[f64], x: DVec3) -> f64 {
    let sum: DVec3 = points.iter().zip(weights).map(|(p, w)| *p * *w).sum();
    sum.distance(x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes;
    use sh_scene::Mesh;

    fn parts(mesh: &Mesh) -> (Vec<DVec3>, Vec<[u32; 3]>) {
        let points = mesh.positions.iter().map(|p| DVec3::from(p.map(f64::from)));
        (points.collect(), mesh.triangles.clone())
    }

    /// The largest |Σ λ f(p) − f(x)| of linear functions f, and Σ |λ|.
    fn measure(points: &[DVec3], triangles: &[[u32; 3]], x: DVec3) -> (f64, f64) {
        let weights = mean_value(points, triangles, x).expect("coordinates");
        assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-9);
        let size = weights.iter().map(|w| w.abs()).sum();
        (error(points, &weights, x), size)
    }

    #[test]
    fn linear_functions_are_reproduced_inside_and_outside() {
        let shapes = [
            shapes::ball(1.0, 3),
            shapes::torus_knot(2, 3, 1.0, 0.4, 0.15),
            shapes::rounded_box(glam::Vec3::new(1.0, 2.0, 0.3), 0.05),
        ];
        for mesh in &shapes {
            let (points, triangles) = parts(mesh);
            for i in 0..60 {
                let f = f64::from(i);
                let x = DVec3::new((f * 0.71).sin(), (f * 0.37).cos(), (f * 1.3).sin()) * 0.9;
                if let Some(weights) = mean_value(&points, &triangles, x) {
                    // Outside the sum of the weights may come near zero, and errors grow by as much.
                    let size: f64 = weights.iter().map(|w| w.abs()).sum();
                    let error = error(&points, &weights, x);
                    assert!(error < 1e-8 * size, "{x}: {error}, {size}");
                }
            }
        }
    }

    #[test]
    fn inside_a_convex_mesh_no_weight_is_negative() {
        let (points, triangles) = parts(&shapes::ball(1.0, 3));
        for i in 0..50 {
            let f = f64::from(i);
            let x = DVec3::new(f.sin(), (f * 0.7).sin(), (f * 1.9).cos()) * 0.5;
            let (error, size) = measure(&points, &triangles, x);
            assert!(error < 1e-10 && size < 1.0 + 1e-9, "{x}: {error} {size}");
        }
    }

    #[test]
    fn vertices_edges_and_faces_have_their_own_coordinates() {
        let (points, triangles) = parts(&shapes::torus_knot(2, 3, 1.0, 0.4, 0.15));
        for t in triangles.iter().step_by(97) {
            let [a, b, c] = t.map(|i| points[i as usize]);
            for barycentric in [
                [1.0, 0.0, 0.0],
                [0.0, 0.0, 1.0],
                [0.25, 0.75, 0.0],
                [0.0, 0.5, 0.5],
                [0.2, 0.3, 0.5],
                [0.001, 0.001, 0.998],
            ] {
                let [i, j, k] = barycentric;
                let x = a * i + b * j + c * k;
                let weights = mean_value(&points, &triangles, x).expect("coordinates");
                assert!(error(&points, &weights, x) < 1e-7, "{barycentric:?}");
                for (corner, expected) in t.iter().zip(barycentric) {
                    let found = weights[*corner as usize];
                    assert!((found - expected).abs() < 1e-5, "{barycentric:?}: {found}");
                }
            }
            // Through a face there is no jump.
            let normal = (b - a).cross(c - a).normalize();
            let middle = (a + b + c) / 3.0;
            let [inside, outside] = [-1e-6, 1e-6].map(|h| {
                let x = middle + normal * h;
                mean_value(&points, &triangles, x).expect("coordinates")
            });
            let jump = inside
                .iter()
                .zip(&outside)
                .fold(0.0, |m: f64, (a, b)| m.max((a - b).abs()));
            assert!(jump < 1e-3, "{jump}");
        }
    }

    #[test]
    fn an_open_mesh_is_found_out() {
        let (points, mut triangles) = parts(&shapes::ball(1.0, 3));
        triangles.truncate(triangles.len() / 2);
        let x = DVec3::new(0.1, 0.2, 0.3);
        let told = mean_value(&points, &triangles, x).map(|w| error(&points, &w, x));
        assert!(told.is_none_or(|e| e > 1e-2), "{told:?}");
    }
}
