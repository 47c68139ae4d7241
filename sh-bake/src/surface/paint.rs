//! What the surface looks like where a line goes through it.

use super::part::Part;
use super::shell::Crossing;
use glam::{DVec3, Vec3};
use sh_scene::{Material, Mesh};

/// Reflectance at a crossing, each channel in 0..=1: base colour, texture and vertex colour. What is no number is 0.
pub(crate) fn albedo((mesh, material): &Part, crossing: &Crossing) -> Vec3 {
    let corners = corners(mesh, crossing);
    let mut color = Vec3::from(material.albedo);
    if let Material {
        texture: Some(texture),
        ..
    } = material
        && let Some([a, b, c]) = corners.and_then(|i| among(&mesh.uvs, i))
    {
        let uv = std::array::from_fn(|k| {
            let [wa, wb, wc] = crossing.weights;
            (wa * f64::from(a[k]) + wb * f64::from(b[k]) + wc * f64::from(c[k])) as f32
        });
        color *= Vec3::from(texture.color(uv));
    }
    if let Some(tints) = corners.and_then(|i| among(&mesh.colors, i)) {
        color *= mean(tints, crossing).as_vec3();
    }
    // A comparison with what is no number is false.
    color.map(|c| if c > 0.0 { c.min(1.0) } else { 0.0 })
}

/// The unit normal at a crossing, on the side to which `outward` points: the vertices' or, where they have none, the
/// triangle's.
pub(crate) fn normal((mesh, _): &Part, crossing: &Crossing, outward: DVec3) -> DVec3 {
    let corners = corners(mesh, crossing);
    let face = corners.and_then(|i| among(&mesh.positions, i)).map(|t| {
        let [a, b, c] = t.map(|p| DVec3::from(p.map(f64::from)));
        (b - a).cross(c - a).normalize_or(outward)
    });
    let face = face.unwrap_or(outward);
    let face = if face.dot(outward) < 0.0 { -face } else { face };
    let smooth = corners.and_then(|i| among(&mesh.normals, i));
    let smooth = smooth.map_or(face, |normals| mean(normals, crossing).normalize_or(face));
    if smooth.dot(face) < 0.0 {
        -smooth
    } else {
        smooth
    }
}

/// The triangle's vertices.
fn corners(mesh: &Mesh, crossing: &Crossing) -> Option<[usize; 3]> {
    let triangle = mesh.triangles.get(crossing.triangle as usize)?;
    Some(triangle.map(|i| i as usize))
}

fn among<const N: usize>(all: &[[f32; N]], [a, b, c]: [usize; 3]) -> Option<[[f32; N]; 3]> {
    Some([*all.get(a)?, *all.get(b)?, *all.get(c)?])
}

fn mean(corners: [[f32; 3]; 3], crossing: &Crossing) -> DVec3 {
    let parts = corners.into_iter().zip(crossing.weights);
    parts
        .map(|(c, weight)| DVec3::from(c.map(f64::from)) * weight)
        .sum()
}
