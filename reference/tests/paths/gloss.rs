//! Receivers that mirror light.

use super::{UP, assert_near, bounces, dark, even, lamp, object, plate, projected, scene};
use glam::Vec3;
use sh_reference::gloss::Gloss;
use sh_reference::paths::{Options, PathTracer, Radiance};
use sh_reference::quadrature::Rule;
use sh_scene::{AreaShape, EnvironmentMap, Scene};

/// The direction to a viewer of this cosine.
fn view(facing: f64) -> [f64; 3] {
    [(1.0 - facing * facing).sqrt(), facing, 0.0]
}

fn mirrored(scene: &Scene, options: Options, facing: f64, roughness: f64) -> Radiance {
    let tracer = PathTracer::new(scene, options).expect("a light");
    tracer.mirrored([[0.0; 3], UP], (view(facing), roughness), 1 << 14, 1)
}

/// Whatever the lobe, it sees of an even sky its radiance.
#[test]
fn an_even_sky_is_mirrored_as_it_is() {
    for roughness in [0.02, 0.3, 1.0] {
        for facing in [0.1, 0.6, 1.0] {
            for options in [bounces(0), bounces(2), projected()] {
                let seen = mirrored(&even(), options, facing, roughness);
                // The lobe's own sum, over 4,181 draws, errs by less.
                assert_near(seen.direct, seen.direct_error, [1.0; 3], 1e-3, 3e-3);
                assert_eq!(seen.indirect, [0.0; 3]);
            }
        }
    }
}

/// A smooth surface shows the half of the sky on the other side of the normal, and a rough one some of both.
#[test]
fn a_smooth_surface_shows_what_is_mirrored() {
    let pixels = (0..64 * 32).map(|i| [if i % 64 < 32 { 1.0 } else { 0.0 }; 3]);
    let half = scene(EnvironmentMap {
        width: 64,
        height: 32,
        pixels: pixels.collect(),
    });
    let [smooth, rough] = [0.03, 1.0].map(|r| mirrored(&half, bounces(0), 0.5, r).direct[0]);
    let bright = half.environment.sample(Vec3::new(-0.866_025_4, 0.5, 0.0))[0];
    assert!(
        (smooth - f64::from(bright)).abs() < 0.01,
        "{smooth}, not {bright}"
    );
    assert!((0.1..0.9).contains(&rough), "{rough}");
}

/// A ball that shines gives what the lobe is over its cap.
#[test]
fn a_lamp_is_mirrored_as_the_lobe_has_it() {
    let towards = Vec3::new(-0.6, 0.8, 0.1).normalize();
    let mut lit = dark();
    let shape = AreaShape::Local {
        center: 5.0 * towards,
        radius: 1.0,
    };
    lit.lights.push(lamp(shape, [2.0, 1.0, 0.5]));
    for roughness in [0.15, 0.4, 0.8] {
        let gloss = Gloss::new(roughness, UP, view(0.7));
        let cap = Rule::zone(towards.as_dvec3().to_array(), (0.96_f64).sqrt(), 1.0, 200);
        let share = cap.integrate(|d| gloss.value(d));
        let seen = mirrored(&lit, bounces(0), 0.7, roughness);
        let expected = [2.0, 1.0, 0.5].map(|c| c * share);
        assert_near(seen.direct, seen.direct_error, expected, 1e-5, 0.01 * share);
    }
}

/// A wall under an even sky, mirrored at its middle, shows what it reflects of it.
#[test]
fn a_wall_is_mirrored() {
    let mut walled = even();
    let mut wall = object(plate(40.0, 64), [0.5, 0.25, 0.75], Vec3::ZERO);
    // It stands upright, and faces the receiver from the side that the eye is not on.
    wall.transform = glam::Affine3A::from_rotation_translation(
        glam::Quat::from_rotation_z(-std::f32::consts::FRAC_PI_2),
        Vec3::new(-4.0, 0.0, 0.0),
    );
    walled.objects.push(wall);
    let seen = mirrored(&walled, bounces(1), 0.5, 0.02);
    assert!(seen.direct[0] < 0.01, "{:?}", seen.direct);
    // It sees half of the sky, and half of that it is dark: nothing else reflects.
    let expected = [0.5, 0.25, 0.75];
    assert_near(seen.indirect, seen.indirect_error, expected, 1e-3, 0.01);
}
