//! The path tracer against what can be written down: every test says how near it has to come, and why.

mod cavities;
mod gloss;
mod ground;
mod noise;
mod open;
mod punctual;
mod spheres;

use glam::{Affine3A, Vec3};
use sh_reference::paths::{Options, PathTracer, Radiance, Source};
use sh_scene::{
    AreaLight, AreaShape, Camera, EnvironmentMap, Ground, Material, Mesh, Object, Scene, Settings,
};

const UP: [f64; 3] = [0.0, 1.0, 0.0];
const DOWN: [f64; 3] = [0.0, -1.0, 0.0];

/// Nothing but light from all around.
fn scene(environment: EnvironmentMap) -> Scene {
    Scene {
        punctual: Vec::new(),
        objects: Vec::new(),
        environment,
        lights: Vec::new(),
        ground: None,
        camera: Camera {
            eye: Vec3::Z,
            target: Vec3::ZERO,
            fov: 1.0,
        },
        settings: Settings::default(),
    }
}

/// An even sky of radiance 1 all around.
fn even() -> Scene {
    scene(EnvironmentMap::constant([1.0; 3]))
}

fn dark() -> Scene {
    scene(EnvironmentMap::constant([0.0; 3]))
}

fn object(mesh: Mesh, albedo: [f32; 3], place: Vec3) -> Object {
    Object {
        name: String::from("body"),
        mesh,
        material: Material::diffuse(albedo),
        transform: Affine3A::from_translation(place),
        ..Object::default()
    }
}

fn ground(albedo: f32) -> Option<Ground> {
    Some(Ground {
        height: 0.0,
        albedo: [albedo; 3],
    })
}

fn lamp(shape: AreaShape, radiance: [f32; 3]) -> AreaLight {
    AreaLight::of(shape, radiance)
}

/// A regular polygon of so many corners about the origin, in the plane of x and z, without normals.
fn plate(radius: f32, corners: u32) -> Mesh {
    let corner = |i: u32| {
        let (sin, cos) = (std::f32::consts::TAU * i as f32 / corners as f32).sin_cos();
        [radius * cos, 0.0, radius * sin]
    };
    Mesh {
        positions: std::iter::once([0.0; 3])
            .chain((0..corners).map(corner))
            .collect(),
        triangles: (0..corners)
            .map(|i| [0, 1 + i, 1 + (i + 1) % corners])
            .collect(),
        ..Mesh::default()
    }
}

/// How far below 1 the middles of a ball's triangles lie, over its radius.
fn flatness(ball: &Mesh) -> f64 {
    let radius = f64::from(Vec3::from(ball.positions[0]).length());
    let middle = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| Vec3::from(ball.positions[i as usize]).as_dvec3());
        (b - a).cross(c - a).normalize().dot(a).abs() / radius
    };
    1.0 - ball.triangles.iter().map(middle).fold(1.0, f64::min)
}

/// A good many paths.
fn trace(scene: &Scene, options: Options, point: [f64; 3], normal: [f64; 3]) -> Radiance {
    trace_more(scene, options, point, normal, 1)
}

/// So many times as many, for light that comes from a small part of the view.
fn trace_more(
    scene: &Scene,
    options: Options,
    point: [f64; 3],
    normal: [f64; 3],
    times: u32,
) -> Radiance {
    PathTracer::new(scene, options)
        .expect("a light")
        .radiance(point, normal, times << 14, 1)
}

fn bounces(bounces: u32) -> Options {
    Options {
        bounces,
        ..Options::default()
    }
}

fn projected() -> Options {
    Options {
        light: Source::Projected,
        ..Options::default()
    }
}

/// Panics unless every channel of what was found lies within a tolerance of what was expected, and within four of the
/// standard errors that were told, besides a stated error of the scene itself.
#[track_caller]
fn assert_near(
    found: [f64; 3],
    error: [f64; 3],
    expected: [f64; 3],
    scene_error: f64,
    tolerance: f64,
) {
    for c in 0..3 {
        let off = (found[c] - expected[c]).abs();
        let allowed = scene_error + (4.0 * error[c]).min(tolerance);
        // Written so that a NaN fails.
        assert!(
            off <= allowed + 1e-9,
            "channel {c}: {} instead of {}, off by {off:e}, standard error {:e}",
            found[c],
            expected[c],
            error[c]
        );
    }
}
