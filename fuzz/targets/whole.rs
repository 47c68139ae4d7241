//! Scenes loaded to the end: any points, any triangles over them, at any place and scale. What follows the
//! reading of a file, the fitting of spheres first, meets numbers that no person would write.
//!
//! The input: a byte for the count of spheres, seven floats for scale, place and turn, a byte for the count
//! of points, three floats each, and the rest is triangles, an index a byte.

#![no_main]

use gaunt_fuzz::{check_environment, check_error, file};
use libfuzzer_sys::fuzz_target;
use sh_bake::load_scene;
use sh_scene::View;

/// More would only be slower.
const MOST_SPHERES: u8 = 4;
const MOST_POINTS: u8 = 32;

/// A sky of eight pixels: the analytic one would take longer than all the rest.
const MAP: &[u8] = include_bytes!("../../sh-bake/tests/good/grey.hdr");

fuzz_target!(|bytes: &[u8]| {
    if let Some((scene, mesh)) = texts(bytes) {
        file("grey.hdr", MAP);
        file("mesh.obj", mesh.as_bytes());
        match load_scene(&file("scene.toml", scene.as_bytes())) {
            Ok(loaded) => check(&loaded.scene),
            Err(error) => check_error(&error),
        }
    }
});

/// The scene file and its mesh; none where the input is too short.
fn texts(mut bytes: &[u8]) -> Option<(String, String)> {
    let spheres = byte(&mut bytes)? % MOST_SPHERES + 1;
    let scale = float(&mut bytes)?;
    let (place, turn) = (triple(&mut bytes)?, triple(&mut bytes)?);
    let scene = format!(
        "environment.map = \"grey.hdr\"\n[[objects]]\nmesh = \"mesh.obj\"\nspheres = {spheres}\n\
         scale = {scale:?}\ntranslate = {place:?}\nrotate = {turn:?}\n"
    );
    let points = byte(&mut bytes)? % MOST_POINTS + 1;
    let mut mesh = String::new();
    for _ in 0..points {
        let [x, y, z] = triple(&mut bytes)?;
        mesh += &format!("v {x} {y} {z}\n");
    }
    for triangle in bytes.as_chunks::<3>().0 {
        let [a, b, c] = triangle.map(|i| i % points + 1);
        mesh += &format!("f {a} {b} {c}\n");
    }
    Some((scene, mesh))
}

fn byte(bytes: &mut &[u8]) -> Option<u8> {
    bytes.split_off_first().copied()
}

fn float(bytes: &mut &[u8]) -> Option<f32> {
    let four = bytes.split_off(..4)?.try_into().ok()?;
    Some(f32::from_le_bytes(four))
}

fn triple(bytes: &mut &[u8]) -> Option<[f32; 3]> {
    Some([float(bytes)?, float(bytes)?, float(bytes)?])
}

/// Checks that everything a renderer reads is a number, and that the spheres hold the mesh.
fn check(scene: &sh_scene::Scene) {
    check_environment(&scene.environment);
    for object in &scene.objects {
        assert!(object.transform.is_finite());
        let spheres = &object.spheres;
        assert!(!spheres.is_empty() && spheres.len() <= MOST_SPHERES.into());
        for sphere in spheres {
            assert!(
                sphere.radius.is_finite() && sphere.radius > 0.0,
                "a sphere is {sphere:?}"
            );
            assert!(sphere.center.iter().all(|c| c.is_finite()));
        }
    }
    let view = View {
        camera: scene.camera,
        width: 4,
        height: 3,
    };
    let axes = view.axes();
    let unit = axes.iter().all(|axis| (axis.length() - 1.0).abs() < 1e-4);
    assert!(unit, "the camera's axes are {axes:?}");
    assert!(scene.camera.eye.is_finite());
    assert!(scene.ground.as_ref().is_none_or(|g| g.height.is_finite()));
}
