//! Meshes put together, and of smaller triangles.

use glam::Vec3;
use sh_scene::Mesh;
use std::collections::HashMap;

/// The mesh with every edge whose ends are more than so much apart halved until none is; what lies on an edge is shared.
pub(crate) fn finer(mut mesh: Mesh, apart: impl Fn(Vec3, Vec3) -> f32, most: f32) -> Mesh {
    let mut halves = HashMap::new();
    loop {
        let mut cut = false;
        for [a, b, c] in std::mem::take(&mut mesh.triangles) {
            let place = |i: u32| Vec3::from(mesh.positions[i as usize]);
            let length = |e: &[u32; 3]| apart(place(e[0]), place(e[1]));
            let edges = [[a, b, c], [b, c, a], [c, a, b]];
            let longest = edges
                .into_iter()
                .max_by(|e, f| length(e).total_cmp(&length(f)));
            let [p, q, r] = longest.unwrap_or([a, b, c]);
            if length(&[p, q, r]) <= most {
                mesh.triangles.push([a, b, c]);
                continue;
            }
            cut = true;
            let middle = *halves.entry([p.min(q), p.max(q)]).or_insert_with(|| {
                for list in [&mut mesh.positions, &mut mesh.normals] {
                    let [x, y] = [p, q].map(|i| Vec3::from(list[i as usize]));
                    list.push(((x + y) * 0.5).to_array());
                }
                if let Some(normal) = mesh.normals.last_mut() {
                    *normal = Vec3::from(*normal).normalize_or(Vec3::Y).to_array();
                }
                mesh.positions.len() as u32 - 1
            });
            mesh.triangles.extend([[p, middle, r], [middle, q, r]]);
        }
        if !cut {
            return mesh;
        }
    }
}

/// Adds a mesh to another, moved.
pub(crate) fn add(mesh: &mut Mesh, other: Mesh, by: Vec3) {
    let first = mesh.positions.len() as u32;
    let moved = other.positions.iter();
    let moved = moved.map(|p| (by + Vec3::from(*p)).to_array());
    mesh.positions.extend(moved);
    mesh.normals.extend(other.normals);
    let triangles = other.triangles.iter().map(|t| t.map(|i| i + first));
    mesh.triangles.extend(triangles);
}
