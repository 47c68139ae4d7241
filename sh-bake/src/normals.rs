//! Vertex normals for meshes that come without.

use glam::DVec3;
use std::collections::HashMap;

/// Faces that meet at more than this angle do not smooth each other (60°).
const CREASE_COSINE: f64 = 0.5;

/// Positions split where the surface has a crease, a unit normal each, and the triangles over them.
pub(crate) struct Smoothed {
    /// Which of the given positions each vertex has.
    pub(crate) source: Vec<u32>,
    pub(crate) normals: Vec<[f32; 3]>,
    pub(crate) triangles: Vec<[u32; 3]>,
}

/// Normals of a triangle mesh: at each corner the mean of the faces around that point in space which meet
/// its own face at less than 60°, weighted by their angle at the point (Thürmer and Wüthrich 1998). So a
/// scan comes out smooth and a box keeps its edges. Vertices in one place count as one; a vertex whose
/// corners differ is split. No triangle may have area zero.
pub(crate) fn smooth(positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> Smoothed {
    let mut places: HashMap<[u32; 3], Vec<(usize, usize)>> = HashMap::new();
    // Adding 0 makes -0 and 0 the same place.
    let place = |i: u32| positions[i as usize].map(|c| (c + 0.0).to_bits());
    let mut faces = Vec::with_capacity(triangles.len());
    let mut angles = Vec::with_capacity(triangles.len());
    for (face, t) in triangles.iter().enumerate() {
        let p = t.map(|i| DVec3::from(positions[i as usize].map(f64::from)));
        faces.push((p[1] - p[0]).cross(p[2] - p[0]).normalize_or_zero());
        angles.push([0, 1, 2].map(|k| {
            let (to_next, to_last) = (p[(k + 1) % 3] - p[k], p[(k + 2) % 3] - p[k]);
            to_next.angle_between(to_last)
        }));
        for (k, &i) in t.iter().enumerate() {
            places.entry(place(i)).or_default().push((face, k));
        }
    }

    let mut smoothed = Smoothed {
        source: Vec::new(),
        normals: Vec::new(),
        triangles: Vec::with_capacity(triangles.len()),
    };
    let mut known: HashMap<(u32, [u32; 3]), u32> = HashMap::new();
    for (face, t) in triangles.iter().enumerate() {
        smoothed.triangles.push(t.map(|i| {
            let mut sum = DVec3::ZERO;
            for &(other, corner) in &places[&place(i)] {
                if faces[other].dot(faces[face]) > CREASE_COSINE {
                    sum += faces[other] * angles[other][corner];
                }
            }
            let normal = sum.normalize_or(faces[face]).as_vec3().to_array();
            *known
                .entry((i, normal.map(f32::to_bits)))
                .or_insert_with(|| {
                    smoothed.source.push(i);
                    smoothed.normals.push(normal);
                    smoothed.source.len() as u32 - 1
                })
        }));
    }
    smoothed
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes;
    use glam::Vec3;

    #[test]
    fn a_ball_gets_the_normals_it_had() {
        let ball = shapes::ball(3.0, 4);
        let smoothed = smooth(&ball.positions, &ball.triangles);
        assert_eq!(smoothed.source.len(), ball.positions.len());
        for (&source, normal) in smoothed.source.iter().zip(&smoothed.normals) {
            let expected = Vec3::from(ball.normals[source as usize]);
            assert!(expected.dot(Vec3::from(*normal)) > 0.9995);
        }
    }

    #[test]
    fn a_box_keeps_its_edges() {
        let size = Vec3::new(1.0, 2.0, 3.0);
        let mesh = shapes::rounded_box(size, 0.0);
        let triangles: Vec<[u32; 3]> = crate::raw::with_area(&mesh.positions, &mesh.triangles);
        let smoothed = smooth(&mesh.positions, &triangles);
        for normal in &smoothed.normals {
            let longest = normal.iter().fold(0.0_f32, |a, c| a.max(c.abs()));
            assert!((longest - 1.0).abs() < 1e-6, "{normal:?} leans");
        }
    }
}
