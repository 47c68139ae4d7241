//! Hard cases of whole pictures: meshes with triangles that are none, and scenes of any size.

mod common;

use common::{object, scene, sphere_mesh};
use glam::{Affine3A, Vec3, vec3};
use sh_cpu::render;
use sh_scene::{Ground, Mesh, Plan, Scene};

/// A ball on the ground, `scale` metres in radius.
fn ball(scale: f32) -> Scene {
    let place = Affine3A::from_translation(scale * Vec3::Y);
    let mut scene = scene(vec![object(sphere_mesh(scale, 24), place)]);
    scene.ground = Some(Ground {
        height: 0.0,
        albedo: [0.5; 3],
    });
    scene.camera.eye = scale * vec3(0.0, 3.0, 6.0);
    scene.camera.target = scale * vec3(0.0, 0.7, 0.0);
    scene
}

fn picture(scene: &Scene) -> Vec<[f32; 3]> {
    let pixels = render(scene, &Plan::new(scene), (64, 48), &|_| ())
        .expect("the scene is sound")
        .pixels;
    for (i, pixel) in pixels.iter().enumerate() {
        for c in pixel {
            assert!(*c >= 0.0 && c.is_finite(), "pixel {i} is {pixel:?}");
        }
    }
    pixels
}

/// Adds triangles without area: corners that coincide, in index or in place, or lie on a line.
fn degenerate(mesh: &mut Mesh) {
    let first = mesh.positions.len() as u32;
    for position in [
        [0.0, 1.5, 0.0],
        [0.0, 1.5, 0.0],
        [0.0, 1.75, 0.0],
        [0.0, 2.0, 0.0],
    ] {
        mesh.positions.push(position);
        mesh.normals.push([0.0, 0.0, 1.0]);
        mesh.uvs.push([0.0; 2]);
    }
    for corners in [[0, 0, 0], [0, 1, 2], [0, 2, 0], [1, 2, 3], [3, 2, 1]] {
        mesh.triangles.push(corners.map(|i| first + i));
    }
}

#[test]
fn triangles_without_area_change_no_pixel() {
    let sound = picture(&ball(1.0));
    let mut scene = ball(1.0);
    degenerate(&mut scene.objects[0].mesh);
    assert_eq!(picture(&scene), sound);
    // A body of nothing else, blocking nothing.
    let mut mesh = Mesh::default();
    degenerate(&mut mesh);
    let mut nothing = object(mesh, Affine3A::from_translation(vec3(0.0, 1.0, 2.0)));
    nothing.spheres.clear();
    scene.objects.push(nothing);
    assert_eq!(picture(&scene), sound);
}

#[test]
fn normals_without_length_give_a_picture() {
    let mut scene = ball(1.0);
    for normal in scene.objects[0].mesh.normals.iter_mut().step_by(3) {
        *normal = [0.0; 3];
    }
    picture(&scene);
    scene.objects[0].mesh.normals.fill([0.0; 3]);
    picture(&scene);
}

/// The same picture at a millionth and a million times the size; a sample at an edge may fall to either side.
#[test]
fn scenes_of_any_size_look_the_same() {
    let usual = picture(&ball(1.0));
    for scale in [1e-6, 1e-4, 1e-3, 1e3, 1e6] {
        let found = picture(&ball(scale));
        let off = |(a, b): (&[f32; 3], &[f32; 3])| {
            a.iter()
                .zip(b)
                .map(|(a, b)| (a - b).abs())
                .fold(0.0, f32::max)
        };
        let mut differences: Vec<f32> = found.iter().zip(&usual).map(off).collect();
        differences.sort_by(f32::total_cmp);
        let most = differences[differences.len() - 1];
        let nearly_all = differences[differences.len() * 99 / 100];
        println!("{scale:e}: {nearly_all:e}, at most {most:e}");
        assert!(
            nearly_all < 1e-4 && most < 0.5,
            "{scale:e}: {nearly_all} {most}"
        );
    }
}
