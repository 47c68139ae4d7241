//! Bodies of rounded cones that melt into each other.
//!
//! The surface is where f(p) = −k ln Σ exp(−dᵢ(p) / k) is zero, with the distances dᵢ to the cones and the width k of
//! the seams (Quilez' smooth minimum of distances, exponential form). It is cut out of a grid of cubes, each of six
//! tetrahedra around the same diagonal, so that neighbours agree on every edge and the mesh is closed.

use glam::{UVec3, Vec3};
use sh_scene::Mesh;
use std::collections::HashMap;

/// Two balls and all that lies between them: a limb that thins out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limb {
    /// The balls' centres, in metres.
    pub ends: [Vec3; 2],
    /// Their radii, in metres.
    pub radii: [f32; 2],
}

impl Limb {
    /// A limb from end to end.
    pub fn new(ends: [[f32; 3]; 2], radii: [f32; 2]) -> Self {
        Self {
            ends: ends.map(Vec3::from),
            radii,
        }
    }

    /// Distance to its surface, below 0 inside; near enough to it where it thins out slowly.
    fn distance(&self, point: Vec3) -> f32 {
        let [a, b] = self.ends;
        let along = b - a;
        let part = (point - a).dot(along) / along.length_squared().max(f32::MIN_POSITIVE);
        let part = part.clamp(0.0, 1.0);
        let radius = self.radii[0] + part * (self.radii[1] - self.radii[0]);
        point.distance(a + along * part) - radius
    }
}

/// Limbs that melt into each other over a width of `seam`, as one closed and smooth mesh whose triangles are about `cell`
/// wide, all in metres. Where limbs lie within each other the body swells by up to the seam's width times the logarithm
/// of their number.
///
/// ```
/// use sh_bake::shapes::{Limb, merged};
/// let arm = Limb::new([[0.0; 3], [1.0, 0.0, 0.0]], [0.3, 0.2]);
/// let leg = Limb::new([[0.0; 3], [0.0, -1.0, 0.0]], [0.3, 0.2]);
/// let mesh = merged(&[arm, leg], 0.03, 0.06);
/// assert!(sh_bake::is_closed(&[&mesh]));
/// ```
pub fn merged(limbs: &[Limb], seam: f32, cell: f32) -> Mesh {
    let Some(bounds) = bounds(limbs) else {
        return Mesh::default();
    };
    let room = 2.0 * cell + seam * (limbs.len() as f32).ln();
    let low = bounds[0] - room;
    let cells = ((bounds[1] + room - low) / cell).ceil().as_uvec3();
    let field = |p: Vec3| {
        let nearest = limbs.iter().map(|l| l.distance(p)).fold(f32::MAX, f32::min);
        let sum: f32 = limbs
            .iter()
            .map(|l| ((nearest - l.distance(p)) / seam).exp())
            .sum();
        nearest - seam * sum.ln()
    };
    let corners = cells + 1;
    let place = |at: UVec3| low + at.as_vec3() * cell;
    let index = |at: UVec3| at.x + corners.x * (at.y + corners.y * at.z);
    let mut values = Vec::new();
    for z in 0..corners.z {
        for y in 0..corners.y {
            for x in 0..corners.x {
                values.push(field(place(UVec3::new(x, y, z))));
            }
        }
    }
    let mut mesh = Mesh::default();
    let mut known = HashMap::new();
    // The point of the surface on an edge of the grid, of which one end is inside.
    let mut point = |inside: UVec3, outside: UVec3, mesh: &mut Mesh| {
        let edge = [index(inside), index(outside)];
        *known.entry(edge).or_insert_with(|| {
            let [a, b] = edge.map(|i| values[i as usize]);
            // Away from the ends, where triangles would shrink to nothing.
            let part = (a / (a - b)).clamp(0.05, 0.95);
            let position = place(inside).lerp(place(outside), part);
            let step = 0.1 * cell;
            let slope = Vec3::AXES.map(|e| field(position + e * step) - field(position - e * step));
            mesh.positions.push(position.to_array());
            let normal = Vec3::from(slope).normalize_or(Vec3::Y);
            mesh.normals.push(normal.to_array());
            mesh.positions.len() as u32 - 1
        })
    };
    for z in 0..cells.z {
        for y in 0..cells.y {
            for x in 0..cells.x {
                let cube = UVec3::new(x, y, z);
                for steps in TETRAHEDRA {
                    let corners = steps.map(|s| cube + UVec3::from(s));
                    let (inside, outside): (Vec<_>, Vec<_>) = corners
                        .into_iter()
                        .partition(|c| values[index(*c) as usize] < 0.0);
                    let mut at = |i: usize, o: usize| point(inside[i], outside[o], &mut mesh);
                    let around = match [inside.len(), outside.len()] {
                        [1, 3] => vec![at(0, 0), at(0, 1), at(0, 2)],
                        [3, 1] => vec![at(0, 0), at(1, 0), at(2, 0)],
                        [2, 2] => vec![at(0, 0), at(0, 1), at(1, 1), at(1, 0)],
                        _ => continue,
                    };
                    let outward = outside.iter().map(|c| c.as_vec3()).sum::<Vec3>()
                        / outside.len() as f32
                        - inside.iter().map(|c| c.as_vec3()).sum::<Vec3>() / inside.len() as f32;
                    for i in 1..around.len() - 1 {
                        let mut triangle = [around[0], around[i], around[i + 1]];
                        let [a, b, c] = triangle.map(|k| Vec3::from(mesh.positions[k as usize]));
                        if (b - a).cross(c - a).dot(outward) < 0.0 {
                            triangle.swap(1, 2);
                        }
                        mesh.triangles.push(triangle);
                    }
                }
            }
        }
    }
    mesh
}

/// The ways from corner to corner of a cube along its edges, from the lowest to the highest: six tetrahedra.
const TETRAHEDRA: [[[u32; 3]; 4]; 6] = [
    [[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 1, 1]],
    [[0, 0, 0], [1, 0, 0], [1, 0, 1], [1, 1, 1]],
    [[0, 0, 0], [0, 1, 0], [1, 1, 0], [1, 1, 1]],
    [[0, 0, 0], [0, 1, 0], [0, 1, 1], [1, 1, 1]],
    [[0, 0, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1]],
    [[0, 0, 0], [0, 0, 1], [0, 1, 1], [1, 1, 1]],
];

fn bounds(limbs: &[Limb]) -> Option<[Vec3; 2]> {
    let balls = limbs.iter().flat_map(|l| l.ends.into_iter().zip(l.radii));
    let boxes = balls.map(|(center, radius)| [center - radius, center + radius]);
    boxes.reduce(|[a, b], [c, d]| [a.min(c), b.max(d)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_single_ball_is_a_ball() {
        let ball = Limb::new([[0.1, 0.2, 0.3]; 2], [0.5; 2]);
        let mesh = merged(&[ball], 0.02, 0.08);
        assert!(crate::is_closed(&[&mesh]));
        let mut volume = 0.0;
        for (p, n) in mesh.positions.iter().zip(&mesh.normals) {
            let out = Vec3::from(*p) - ball.ends[0];
            assert!((out.length() - 0.5).abs() < 0.01, "{out}");
            assert!(out.normalize().dot((*n).into()) > 0.999);
        }
        for t in &mesh.triangles {
            let [a, b, c] = t.map(|i| Vec3::from(mesh.positions[i as usize]));
            volume += a.dot(b.cross(c)) / 6.0;
        }
        let exact = 4.0 / 3.0 * std::f32::consts::PI * 0.125;
        assert!((volume / exact - 1.0).abs() < 0.03, "{volume} {exact}");
    }

    #[test]
    fn no_limbs_are_no_mesh() {
        assert!(merged(&[], 0.1, 0.1).triangles.is_empty());
    }
}
