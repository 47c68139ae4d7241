//! Spots, points and suns.

use super::{UP, assert_near, bounces, dark, object, plate, projected, trace};
use glam::Vec3;
use sh_reference::gloss::Gloss;
use sh_reference::paths::PathTracer;
use sh_scene::{PunctualLight, PunctualShape, Scene};
use std::f64::consts::PI;

const BRIGHT: [f32; 3] = [8.0, 4.0, 2.0];

fn lit(shape: PunctualShape) -> Scene {
    Scene {
        punctual: vec![PunctualLight::new(shape, BRIGHT)],
        ..dark()
    }
}

fn point(position: Vec3, radius: f32) -> PunctualShape {
    PunctualShape::Point { position, radius }
}

/// What albedo 1 reflects of `BRIGHT` over a square, at a cosine.
fn given(cosine: f64, square: f64) -> [f64; 3] {
    BRIGHT.map(|c| f64::from(c) * cosine / (PI * square))
}

/// Intensity over the square of the distance, times the cosine, whatever the size of what is above the horizon; of a sun the irradiance. Where there is
/// no size there is no noise.
#[test]
fn in_the_open_light_falls_with_the_square() {
    let place = Vec3::new(1.5, 2.0, 0.0);
    let (cosine, square) = (0.8, 6.25);
    for (radius, options) in [(0.0, bounces(0)), (0.0, projected()), (0.7, bounces(0))] {
        let seen = trace(&lit(point(place, radius)), options, [0.0; 3], UP);
        assert_near(
            seen.direct,
            seen.direct_error,
            given(cosine, square),
            1e-6,
            1e-3,
        );
        assert!(radius > 0.0 || seen.direct_error[0] < 1e-9);
    }
    for angle in [0.0, 0.3] {
        let sun = PunctualShape::Sun {
            direction: place,
            angle,
        };
        let seen = trace(&lit(sun), bounces(0), [0.0; 3], UP);
        assert_near(
            seen.direct,
            seen.direct_error,
            given(cosine, 1.0),
            1e-6,
            2e-3,
        );
    }
    let spot = |towards| PunctualShape::Spot {
        position: place,
        towards,
        angle: 0.4,
        blend: 0.5,
        radius: 0.0,
    };
    let ahead = trace(&lit(spot(-place)), bounces(0), [0.0; 3], UP);
    assert_near(ahead.direct, [0.0; 3], given(cosine, square), 1e-6, 0.0);
    let past = trace(&lit(spot(Vec3::X)), bounces(0), [0.0; 3], UP);
    assert_eq!(past.direct, [0.0; 3]);
}

/// What is before a light hides it, what is behind it or below the ground does not.
#[test]
fn a_plate_hides_what_is_behind_it() {
    for (height, hidden) in [(1.0, true), (3.0, false), (-1.0, false)] {
        for radius in [0.0, 0.1] {
            let mut scene = lit(point(Vec3::new(0.0, 2.0, 0.0), radius));
            scene
                .objects
                .push(object(plate(0.8, 32), [1.0; 3], Vec3::Y * height));
            let seen = trace(&scene, bounces(0), [0.0; 3], UP);
            let expected = if hidden { [0.0; 3] } else { given(1.0, 4.0) };
            // Rays start a little above the receiver.
            assert_near(seen.direct, seen.direct_error, expected, 1e-4, 1e-3);
        }
    }
}

/// A small hole before a large light lets through what of it is to be seen: half a disc beside an edge.
#[test]
fn an_edge_leaves_half_of_a_ball() {
    let mut scene = lit(point(Vec3::new(0.0, 4.0, 0.0), 0.2));
    // The edge of a large square runs through the line to the middle.
    let mut half = plate(4.0 * 2.0_f32.sqrt(), 4);
    for position in &mut half.positions {
        let [x, y, z] = *position;
        let (sin, cos) = std::f32::consts::FRAC_PI_4.sin_cos();
        *position = [x * cos - z * sin + 4.0, y, x * sin + z * cos];
    }
    scene.objects.push(object(half, [1.0; 3], Vec3::Y * 2.0));
    let seen = trace(&scene, bounces(0), [0.0; 3], UP);
    let expected = given(0.5, 16.0);
    assert_near(seen.direct, seen.direct_error, expected, 1e-4, 2e-3);
}

/// A surface that a light shines on reflects its albedo's part of that; mirrored, it is seen as bright; and a smooth lobe shows the light itself.
#[test]
fn light_is_reflected_and_mirrored() {
    let mut scene = lit(PunctualShape::Sun {
        direction: Vec3::Y,
        angle: 0.0,
    });
    // It faces up, below the receiver, which faces down.
    let floor = object(plate(60.0, 64), [0.5, 0.25, 1.0], Vec3::NEG_Y * 2.0);
    scene.objects.push(floor);
    let tracer = PathTracer::new(&scene, bounces(1)).expect("a light");
    let down = [0.0, -1.0, 0.0];
    let seen = tracer.mirrored([[0.0; 3], down], ([0.6, -0.8, 0.0], 0.05), 1 << 12, 1);
    assert_eq!(seen.direct, [0.0; 3]);
    let shown = [0.5, 0.25, 1.0];
    let expected = [0, 1, 2].map(|c| shown[c] * given(1.0, 1.0)[c]);
    assert_near(seen.indirect, seen.indirect_error, expected, 2e-3, 0.02);

    let view = [0.6, 0.8, 0.0];
    let gloss = Gloss::new(0.4, UP, view);
    let mirrored = lit(point(Vec3::new(-1.2, 1.6, 0.1), 0.0));
    let tracer = PathTracer::new(&mirrored, bounces(0)).expect("a light");
    let seen = tracer.mirrored([[0.0; 3], UP], (view, 0.4), 64, 1);
    let away = Vec3::new(-1.2, 1.6, 0.1).as_dvec3();
    let value = gloss.value(away.normalize().to_array()) / away.length_squared();
    let expected = BRIGHT.map(|c| f64::from(c) * value);
    assert_near(seen.direct, [0.0; 3], expected, 1e-5, 0.0);
}
