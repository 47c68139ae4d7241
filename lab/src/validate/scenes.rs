//! The scenes of Guerrero et al. 2008, figures 8 to 10, made by code.

use super::bodies::{arch, bend, bent, body, cylinder, squirrel, stood};
use glam::{Quat, Vec3};
use sh_bake::shapes;
use sh_scene::{AreaLight, Camera, Distribution, Ground, Indirect, Object, Scene, Settings, Sky};
use std::f32::consts::{FRAC_PI_2, PI};

/// A scene and what it is called.
pub(super) struct Case {
    /// The name that files and arguments use.
    pub name: &'static str,
    /// What is seen.
    pub title: &'static str,
    make: fn() -> Vec<Object>,
    /// Lamps besides the sky.
    lamps: fn() -> Vec<AreaLight>,
    /// What the camera looks at.
    target: Vec3,
    /// How far away it is, in metres.
    distance: f32,
}

impl Case {
    /// The scene with its spheres fitted and sampled: a few seconds.
    pub fn scene(&self) -> Scene {
        self.with((self.make)())
    }

    /// Other bodies in its place.
    pub fn with(&self, objects: Vec<Object>) -> Scene {
        Scene {
            punctual: Vec::new(),
            objects,
            environment: Sky::default().map(128, 64),
            lights: (self.lamps)(),
            ground: Some(Ground {
                height: 0.0,
                albedo: [0.5; 3],
            }),
            camera: Camera {
                eye: self.target + Vec3::new(0.25, 0.45, 0.86).normalize() * self.distance,
                target: self.target,
                fov: 30.0_f32.to_radians(),
            },
            settings: Settings {
                half_resolution: false,
                indirect: Some(Indirect::default()),
                ..Settings::default()
            },
        }
    }
}

const RED: [f32; 3] = [0.80, 0.20, 0.12];
const GREEN: [f32; 3] = [0.25, 0.70, 0.20];
const BLUE: [f32; 3] = [0.15, 0.30, 0.80];
const YELLOW: [f32; 3] = [0.85, 0.65, 0.15];
const ORANGE: [f32; 3] = [0.85, 0.42, 0.12];

/// All scenes, from simple to hard.
pub(super) const CASES: [Case; 8] = [
    Case {
        name: "sphere",
        title: "one sphere on a plane",
        make: || vec![ball("ball", 0.5, RED, [0.0; 3])],
        lamps: Vec::new,
        target: Vec3::new(0.0, 0.3, 0.0),
        distance: 3.0,
    },
    Case {
        name: "spheres",
        title: "several spheres",
        make: balls,
        lamps: Vec::new,
        target: Vec3::new(0.0, 0.45, 0.0),
        distance: 4.0,
    },
    Case {
        name: "lamp",
        title: "several spheres around a lamp that glows to one side",
        make: balls,
        lamps: || vec![lamp()],
        target: Vec3::new(0.0, 0.45, 0.0),
        distance: 4.0,
    },
    Case {
        name: "animal",
        title: "an animal of 32 spheres",
        make: || animal(32),
        lamps: Vec::new,
        target: Vec3::new(-0.1, 0.5, 0.0),
        distance: 3.5,
    },
    Case {
        name: "bend-90",
        title: "a cylinder bent by 90 degrees",
        make: || arched(FRAC_PI_2, 12),
        lamps: Vec::new,
        target: Vec3::new(0.0, 0.3, 0.0),
        distance: 4.4,
    },
    Case {
        name: "bend-180",
        title: "a cylinder bent by 180 degrees",
        make: || arched(PI, 12),
        lamps: Vec::new,
        target: Vec3::new(0.0, 0.4, 0.0),
        distance: 3.7,
    },
    Case {
        name: "box-1",
        title: "a box of one sphere",
        make: || boxed(1),
        lamps: Vec::new,
        target: Vec3::new(0.0, 0.4, 0.0),
        distance: 3.7,
    },
    Case {
        name: "box-8",
        title: "a box of 8 spheres",
        make: || boxed(8),
        lamps: Vec::new,
        target: Vec3::new(0.0, 0.4, 0.0),
        distance: 3.7,
    },
];

/// A scene of [`CASES`].
pub(super) fn case(name: &str) -> Option<&'static Case> {
    CASES.iter().find(|case| case.name == name)
}

fn balls() -> Vec<Object> {
    vec![
        ball("red", 0.5, RED, [-0.62, 0.0, 0.0]),
        ball("green", 0.4, GREEN, [0.35, 0.0, 0.15]),
        ball("blue", 0.25, BLUE, [-0.1, 0.0, 0.75]),
        ball("yellow", 0.3, YELLOW, [-0.1, 0.85, 0.1]),
        ball("orange", 0.35, ORANGE, [0.8, 0.0, -0.6]),
    ]
}

/// Before some of [`balls`] and behind others, wherever it is seen from; dark on the side of the red one.
fn lamp() -> AreaLight {
    let ahead = Vec3::new(1.0, -0.5, 0.4);
    AreaLight {
        distribution: Distribution::cap(ahead, 1.8).ok(),
        ..AreaLight::local(Vec3::new(0.15, 0.95, 0.7), 0.1, [60.0, 45.0, 30.0])
    }
}

fn ball(name: &str, radius: f32, albedo: [f32; 3], place: [f32; 3]) -> Object {
    let mesh = shapes::ball(radius, 4);
    body(name, mesh, 1, albedo, Quat::IDENTITY, place.into())
}

/// The animal with at most so many spheres.
pub(super) fn animal(count: usize) -> Vec<Object> {
    let turn = Quat::from_rotation_y(-0.5);
    vec![body(
        "squirrel",
        squirrel(),
        count,
        ORANGE,
        turn,
        Vec3::ZERO,
    )]
}

/// The box with at most so many spheres, a hand's breadth above the ground.
pub(super) fn boxed(count: usize) -> Vec<Object> {
    let mesh = shapes::rounded_box(Vec3::splat(0.8), 0.01);
    let turn = Quat::from_rotation_y(0.5);
    vec![body("box", mesh, count, BLUE, turn, Vec3::Y * 0.12)]
}

/// The cylinder, fitted and sampled straight and then bent.
fn arched(angle: f32, count: usize) -> Vec<Object> {
    let straight = body("cylinder", cylinder(), count, GREEN, arch(), Vec3::ZERO);
    vec![stood(bent(straight, bend(angle)), Vec3::ZERO)]
}

/// The same, fitted and sampled as it is bent.
pub(super) fn arched_anew(angle: f32, count: usize) -> Vec<Object> {
    let mut object = arched(angle, 1);
    let mesh = std::mem::take(&mut object[0].mesh);
    vec![body("cylinder", mesh, count, GREEN, arch(), Vec3::ZERO)]
}
