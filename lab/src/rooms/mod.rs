//! Rooms at the scale of Iwasaki et al. 2007, section 7, made by code: walls are bodies like others, and nothing but a lamp
//! shines.

mod furniture;

use furniture::{armchair, ball, knot, pillar, table, teapot};
use glam::{Affine3A, Quat, Vec3};
use rayon::prelude::*;
use sh_bake::{SphereSet, irradiance_basis, shapes, weights};
use sh_scene::{
    AreaLight, Camera, Distribution, EnvironmentMap, Indirect, Material, Mesh, Method, Object,
    Scene, Settings, Sky,
};
use std::f32::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

/// Functions a body, where nothing else is said.
pub const FUNCTIONS: usize = 16;

/// How many of a room's bodies are walls: the first.
pub const WALLS: usize = 6;

/// Half of a room's extents, in metres; its floor lies at height 0.
const HALF: Vec3 = Vec3::new(2.6, 1.4, 2.6);

/// Vertices of a wall, across and down.
const WALL: u32 = 40;

/// What stands somewhere: which of the meshes, its spheres, colour, place and turn about +Y.
struct Piece {
    mesh: Arc<Mesh>,
    name: &'static str,
    spheres: usize,
    albedo: [f32; 3],
    place: [f32; 3],
    turn: f32,
}

/// Twelve bodies: six walls, and what stands between them. 50,000 vertices, one lamp.
pub fn room() -> Scene {
    let all = [
        (
            "table",
            table(),
            64,
            [0.55, 0.36, 0.2],
            [-0.3, 0.0, -0.4],
            0.3,
        ),
        (
            "armchair",
            armchair(),
            48,
            [0.25, 0.3, 0.6],
            [-1.7, 0.0, 0.5],
            1.9,
        ),
        (
            "teapot",
            teapot(0.0135),
            32,
            [0.75, 0.72, 0.65],
            [-0.35, 0.745, -0.35],
            2.4,
        ),
        ("ball", ball(), 1, [0.8, 0.6, 0.1], [1.3, 0.0, 0.6], 0.0),
        ("knot", knot(), 48, [0.7, 0.3, 0.55], [1.6, 0.0, -1.5], 0.0),
        (
            "pillar",
            pillar(),
            24,
            [0.7, 0.7, 0.7],
            [-1.7, 0.0, -1.7],
            0.0,
        ),
    ];
    let pieces = all.map(|(name, mesh, spheres, albedo, place, turn)| Piece {
        mesh: Arc::new(mesh),
        name,
        spheres,
        albedo,
        place,
        turn,
    });
    scene(pieces.into())
}

/// Thirty pots on the floor of a room. 122,000 vertices.
pub fn teapots() -> Scene {
    let mesh = Arc::new(teapot(0.0165));
    let colors = [
        [0.75, 0.2, 0.15],
        [0.2, 0.6, 0.25],
        [0.2, 0.3, 0.75],
        [0.8, 0.65, 0.2],
        [0.75, 0.72, 0.7],
    ];
    let pieces = (0..30u8).map(|i| {
        let (row, column) = (f32::from(i / 6), f32::from(i % 6));
        Piece {
            mesh: Arc::clone(&mesh),
            name: "teapot",
            spheres: 24,
            albedo: colors[usize::from(i * 7 % 5)],
            place: [0.75 * (column - 2.5), 0.0, 0.85 * (row - 2.0)],
            turn: 2.4 * f32::from(i),
        }
    });
    scene(pieces.collect())
}

/// A pot above a plane of one colour, under a sky and a lamp (Iwasaki et al. 2007, figure 9).
pub fn plane() -> Scene {
    let pot = Piece {
        mesh: Arc::new(teapot(0.0135)),
        name: "teapot",
        spheres: 32,
        albedo: [0.75, 0.72, 0.7],
        place: [0.0, 0.06, 0.0],
        turn: 0.6,
    };
    let plane = Object {
        name: "plane".into(),
        mesh: shapes::panel([1.2, 1.2], [WALL; 2]),
        material: Material::diffuse([0.7, 0.2, 0.15]),
        transform: Affine3A::from_quat(Quat::from_rotation_x(-FRAC_PI_2)),
        ..Object::default()
    };
    let mut objects = vec![plane, pot.object()];
    told(&mut objects, FUNCTIONS);
    Scene {
        punctual: Vec::new(),
        objects,
        environment: upper(Sky::default().map(128, 64)),
        lights: vec![AreaLight::local(
            Vec3::new(0.5, 0.8, 0.3),
            0.1,
            [40.0, 36.0, 30.0],
        )],
        ground: None,
        camera: Camera {
            eye: Vec3::new(0.35, 0.5, 0.85),
            target: Vec3::new(0.0, 0.14, 0.0),
            fov: 0.6,
        },
        settings: settings(),
    }
}

/// The upper half of a sky: below a plane that hides nothing there is to be nothing.
fn upper(mut sky: EnvironmentMap) -> EnvironmentMap {
    let lower = sky.pixels.len() / 2;
    sky.pixels[lower..].fill([0.0; 3]);
    sky
}

fn settings() -> Settings {
    Settings {
        half_resolution: false,
        indirect: Some(Indirect {
            method: Method::BasisIrradiance,
            bounces: 3,
            ..Indirect::default()
        }),
        ..Settings::default()
    }
}

/// A room with what stands in it, lit by a lamp under its ceiling, seen from a corner.
fn scene(pieces: Vec<Piece>) -> Scene {
    let mut objects = walls();
    objects.par_extend(pieces.into_par_iter().map(|piece| piece.object()));
    told(&mut objects, FUNCTIONS);
    let down = Distribution::cap(Vec3::NEG_Y, FRAC_PI_2);
    Scene {
        punctual: Vec::new(),
        objects,
        environment: EnvironmentMap::constant([0.0; 3]),
        lights: vec![AreaLight {
            distribution: down.ok(),
            ..AreaLight::local(
                Vec3::new(0.0, 2.0 * HALF.y - 0.3, 0.0),
                0.25,
                [34.0, 30.0, 24.0],
            )
        }],
        ground: None,
        camera: Camera {
            eye: Vec3::new(2.3, 1.7, 2.4),
            target: Vec3::new(-0.5, 0.75, -0.7),
            fov: 1.05,
        },
        settings: settings(),
    }
}

/// Bytes of what is known of the bodies' light, of those that share it once.
pub fn bytes(objects: &[Object]) -> usize {
    let mut bases: Vec<_> = objects.iter().flat_map(|o| &o.basis).collect();
    bases.sort_by_key(|basis| Arc::as_ptr(basis));
    bases.dedup_by_key(|basis| Arc::as_ptr(basis));
    bases.iter().map(|basis| basis.bytes()).sum()
}

/// Gives every body the functions in which its irradiance is told; bodies that are alike share them.
pub fn told(objects: &mut [Object], count: usize) {
    let same = |a: &Object, b: &Object| {
        a.material.albedo == b.material.albedo && a.mesh.positions == b.mesh.positions
    };
    let mut firsts: Vec<usize> = Vec::new();
    let mut of = Vec::new();
    for (i, object) in objects.iter().enumerate() {
        let known = firsts
            .iter()
            .position(|&first| same(&objects[first], object));
        of.push(known.unwrap_or(firsts.len()));
        if known.is_none() {
            firsts.push(i);
        }
    }
    let found: Vec<_> = firsts
        .par_iter()
        .map(|&first| {
            let parts = [(&objects[first].mesh, &objects[first].material)];
            irradiance_basis(&parts, count, &|_| {}).map(Arc::new)
        })
        .collect();
    for (object, of) in objects.iter_mut().zip(of) {
        object.basis.clone_from(&found[of]);
    }
}

impl Piece {
    fn object(self) -> Object {
        let mesh = Mesh::clone(&self.mesh);
        let spheres = SphereSet::fit(&[&mesh], self.spheres).spheres;
        let turn = Quat::from_rotation_y(self.turn);
        Object {
            name: self.name.into(),
            weights: weights(&[&mesh], &spheres, [0.0, 1.0, 0.0]),
            mesh,
            material: Material::diffuse(self.albedo),
            transform: Affine3A::from_rotation_translation(turn, self.place.into()),
            spheres,
            ..Object::default()
        }
    }
}

/// Six rectangles that face inward and hide nothing, since all is on the same side of each.
fn walls() -> Vec<Object> {
    let white = [0.75, 0.75, 0.72];
    let wall = |name: &str, [width, height]: [f32; 2], turn: Quat, albedo| Object {
        name: name.into(),
        mesh: shapes::panel([width, height], [WALL; 2]),
        material: Material::diffuse(albedo),
        transform: Affine3A::from_rotation_translation(
            turn,
            Vec3::Y * HALF.y - turn * Vec3::Z * (turn.inverse() * HALF).z.abs(),
        ),
        ..Object::default()
    };
    let [x, y, z] = (2.0 * HALF).to_array();
    let about_x = Quat::from_rotation_x;
    let about_y = Quat::from_rotation_y;
    vec![
        wall("floor", [x, z], about_x(-FRAC_PI_2), [0.6, 0.5, 0.4]),
        wall("ceiling", [x, z], about_x(FRAC_PI_2), white),
        wall("back", [x, y], Quat::IDENTITY, white),
        wall("front", [x, y], about_y(PI), white),
        wall("left", [z, y], about_y(FRAC_PI_2), [0.65, 0.15, 0.1]),
        wall("right", [z, y], about_y(-FRAC_PI_2), [0.15, 0.5, 0.15]),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn walls_face_inward_and_meet() {
        let walls = walls();
        for wall in &walls {
            let out = wall.transform.transform_vector3(Vec3::Z);
            let middle = wall.transform.transform_point3(Vec3::ZERO);
            let inward = Vec3::Y * HALF.y - middle;
            assert!(inward.normalize().dot(out) > 0.999, "{}", wall.name);
            let [low, high] = wall.bounds().unwrap();
            assert!(
                low.y > -1e-4 && high.y < 2.0 * HALF.y + 1e-4,
                "{}",
                wall.name
            );
            assert!(high.abs().max(low.abs()).max_element() > HALF.x - 1e-4);
        }
    }
}
