//! What stands in rooms: each on the height 0 of its own space.

use crate::meshes::{add, finer};
use glam::Vec3;
use sh_bake::shapes::{self, Limb, merged};
use sh_scene::Mesh;

/// Boxes, each by its middle and its extents, as one mesh.
fn boxes(all: &[([f32; 3], [f32; 3])], cell: f32) -> Mesh {
    let mut mesh = Mesh::default();
    for (middle, size) in all {
        add(
            &mut mesh,
            shapes::rounded_box(Vec3::from(*size), 0.012),
            (*middle).into(),
        );
    }
    finer(mesh, Vec3::distance, cell)
}

pub(super) fn table() -> Mesh {
    let leg = |x: f32, z: f32| ([0.62 * x, 0.34, 0.36 * z], [0.08, 0.68, 0.08]);
    boxes(
        &[
            ([0.0, 0.71, 0.0], [1.5, 0.06, 0.95]),
            leg(1.0, 1.0),
            leg(-1.0, 1.0),
            leg(1.0, -1.0),
            leg(-1.0, -1.0),
        ],
        0.1,
    )
}

pub(super) fn armchair() -> Mesh {
    boxes(
        &[
            ([0.0, 0.22, 0.0], [0.75, 0.44, 0.75]),
            ([0.0, 0.5, -0.3], [0.75, 0.95, 0.16]),
            ([0.41, 0.32, 0.0], [0.14, 0.6, 0.75]),
            ([-0.41, 0.32, 0.0], [0.14, 0.6, 0.75]),
        ],
        0.1,
    )
}

/// Of triangles so wide.
pub(super) fn teapot(cell: f32) -> Mesh {
    let limbs = [
        Limb::new([[0.0, 0.12, 0.0], [0.0, 0.14, 0.0]], [0.12, 0.12]),
        Limb::new([[0.0, 0.05, 0.0], [0.0, 0.06, 0.0]], [0.05, 0.09]),
        Limb::new([[0.0, 0.26, 0.0], [0.0, 0.285, 0.0]], [0.025, 0.02]),
        Limb::new([[0.1, 0.1, 0.0], [0.19, 0.2, 0.0]], [0.035, 0.02]),
        Limb::new([[0.19, 0.2, 0.0], [0.22, 0.215, 0.0]], [0.02, 0.016]),
        Limb::new([[-0.1, 0.2, 0.0], [-0.19, 0.19, 0.0]], [0.016, 0.016]),
        Limb::new([[-0.19, 0.19, 0.0], [-0.19, 0.11, 0.0]], [0.016, 0.016]),
        Limb::new([[-0.19, 0.11, 0.0], [-0.1, 0.08, 0.0]], [0.016, 0.016]),
    ];
    standing(merged(&limbs, 0.008, cell))
}

pub(super) fn ball() -> Mesh {
    standing(shapes::ball(0.35, 4))
}

pub(super) fn knot() -> Mesh {
    standing(finer(
        shapes::torus_knot(2, 3, 0.42, 0.18, 0.12),
        Vec3::distance,
        0.1,
    ))
}

pub(super) fn pillar() -> Mesh {
    standing(finer(
        shapes::twisted_column(0.16, 2.2, 2.5),
        Vec3::distance,
        0.1,
    ))
}

fn standing(mut mesh: Mesh) -> Mesh {
    let lowest = mesh
        .positions
        .iter()
        .map(|p| p[1])
        .fold(f32::INFINITY, f32::min);
    for p in &mut mesh.positions {
        p[1] -= lowest;
    }
    mesh
}
