//! The hard cases of shading, the same for every backend: `sh-cpu/tests/hard_cases.rs` runs them on every vector
//! path and in f64, `sh-gpu/tests/gpu/hard_cases.rs` on the GPU. What each promises stands at its head;
//! `docs/HARD_CASES.md` is the list.

mod blockers;
mod light;

use glam::{Vec3, vec3};
use sh_scene::{EnvironmentMap, Light, Receiver, Sphere};

/// A backend's shadow pass: receivers, blockers, light and order of accumulation to radiance.
pub type Shade<'a> = dyn Fn(&[Receiver], &[Sphere], &Light, usize) -> Vec<[f32; 3]> + 'a;

/// A case: its name, and what runs it at an order of light and accumulation.
pub type Case = (&'static str, fn(&Shade, usize));

/// All of them.
pub const CASES: &[Case] = &[
    ("identical blockers", blockers::identical_blockers),
    ("spheres of one body", blockers::spheres_of_one_body),
    ("vanishing blockers", blockers::vanishing_blockers),
    (
        "blockers up to the horizon",
        blockers::blockers_up_to_the_horizon,
    ),
    (
        "receivers on, in and at the centre",
        blockers::on_in_and_at_the_centre,
    ),
    (
        "spheres across the tangent plane",
        blockers::across_the_tangent_plane,
    ),
    ("total occlusion", blockers::total_occlusion),
    (
        "a sun a million times the sky",
        light::a_sun_a_million_times_the_sky,
    ),
    ("light of any strength", light::light_of_any_strength),
    ("opposite normals", light::opposite_normals),
    ("scales", light::scales),
    ("light of a lower order", light::light_of_a_lower_order),
    ("what is not a number", light::what_is_not_a_number),
];

/// How far an even sky's light may be from the truth, as a part of it, by order: measured, and rounded up.
struct Worst {
    /// One blocker of 20 or 40 degrees: too dark.
    single: f32,
    /// Any number of them in one place: too bright.
    brighter: f32,
    /// 2 to 4,096 of them in one place: too dark.
    stacked: f32,
    /// Hundreds of spheres of one body: too dark. They are never too bright.
    body: f32,
    /// A sphere that touches the receiver's plane in front of it and hides all.
    half_space: f32,
    /// A closed shell of small spheres around the receiver.
    shell: f32,
    /// A half space, of the light of a sun behind it a million times the sky.
    sun: f32,
}

fn worst(order: usize) -> Worst {
    let [single, brighter, stacked, body, half_space, shell, sun] = match order {
        2 => [0.038, 0.023, 0.57, 0.43, 0.044, 0.33, 0.05],
        3 => [0.064, 0.001, 0.53, 0.40, 0.037, 0.049, 0.04],
        4 => [0.001, 0.009, 0.30, 0.18, 0.006, 0.011, 0.004],
        5 => [0.005, 0.003, 0.13, 0.18, 0.004, 0.001, 0.002],
        _ => [0.004, 0.001, 0.16, 0.11, 0.014, 0.002, 0.004],
    };
    Worst {
        single,
        brighter,
        stacked,
        body,
        half_space,
        shell,
        sun,
    }
}

fn sphere(center: Vec3, radius: f32) -> Sphere {
    Sphere {
        center: center.into(),
        radius,
    }
}

fn receiver(position: Vec3, normal: Vec3) -> Receiver {
    Receiver {
        position: position.into(),
        covered: 1,
        normal: normal.normalize().into(),
        object: 0,
    }
}

/// A sky of radiance 1.
fn even(order: usize) -> Light {
    Light::project(
        &EnvironmentMap::constant([1.0; 3]),
        None,
        order,
        f32::INFINITY,
    )
    .unwrap()
}

/// A sky of radiance 1 with a sun in one texel.
fn sunny(order: usize, sun: f32) -> Light {
    let mut map = EnvironmentMap {
        width: 32,
        height: 16,
        pixels: vec![[1.0, 0.9, 0.8]; 32 * 16],
    };
    map.pixels[3 * 32 + 9] = [sun; 3];
    Light::project(&map, None, order, 2.0 * order as f32).unwrap()
}

/// `count` directions spread evenly over the sphere (a Fibonacci lattice).
fn lattice(count: usize) -> impl Iterator<Item = Vec3> + Clone {
    (0..count).map(move |i| {
        let y = 1.0 - (2 * i + 1) as f32 / count as f32;
        let (sin, cos) = (i as f32 * 2.399_963_2).sin_cos();
        let r = (1.0 - y * y).sqrt();
        vec3(r * cos, y, r * sin)
    })
}

/// Radiance under blockers, after a look at what always holds: every value lies between 0 and that without.
fn shaded(
    shade: &Shade,
    receivers: &[Receiver],
    spheres: &[Sphere],
    light: &Light,
    accumulation: usize,
) -> Vec<[f32; 3]> {
    let open = shade(receivers, &[], light, accumulation);
    let shadowed = shade(receivers, spheres, light, accumulation);
    assert_eq!(shadowed.len(), receivers.len());
    for (i, (open, shadowed)) in open.iter().zip(&shadowed).enumerate() {
        for (open, shadowed) in open.iter().zip(shadowed) {
            // Without blockers the visibility is 1 but for rounding, most where a bright sun behind nearly cancels.
            let most = open * (1.0 + 3e-5);
            assert!(
                (0.0..=most).contains(shadowed),
                "receiver {i}: {shadowed} of {open}"
            );
        }
    }
    shadowed
}

/// What part of an even sky's light reaches one receiver.
fn share(shade: &Shade, receiver: Receiver, spheres: &[Sphere], order: usize) -> f32 {
    shaded(shade, &[receiver], spheres, &even(order), order)[0][0]
}

const UP: Vec3 = Vec3::Y;

fn at_origin() -> Receiver {
    receiver(Vec3::ZERO, UP)
}
