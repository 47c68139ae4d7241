//! Hard cases of whole pictures on the GPU: meshes with triangles that are none, and scenes of any size.

use crate::frame::render;
use crate::gpu::Gpu;
use crate::scenes::{standing_quad, view};
use glam::Affine3A;
use sh_scene::{Mesh, Object, Scene};

fn picture(gpu: &Gpu, scene: &Scene) -> Vec<[f32; 4]> {
    let pixels = render(gpu, scene, &view(scene, 64, 48), 1 << 20);
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
        [0.0, 0.5, 0.5],
        [0.0, 0.5, 0.5],
        [0.0, 0.75, 0.5],
        [0.0, 1.0, 0.5],
    ] {
        mesh.positions.push(position);
        mesh.normals.push([0.0, 0.0, 1.0]);
        mesh.uvs.push([0.0; 2]);
    }
    for corners in [[0, 0, 0], [0, 1, 2], [0, 2, 0], [1, 2, 3], [3, 2, 1]] {
        mesh.triangles.push(corners.map(|i| first + i));
    }
}

pub fn triangles_without_area_change_no_pixel(gpu: &Gpu) {
    let mut scene = standing_quad();
    let sound = picture(gpu, &scene);
    degenerate(&mut scene.objects[0].mesh);
    assert_eq!(picture(gpu, &scene), sound);
    // A body of nothing else, blocking nothing.
    let mut mesh = Mesh::default();
    degenerate(&mut mesh);
    scene.objects.push(Object {
        name: "nothing".into(),
        mesh,
        spheres: Vec::new(),
        ..scene.objects[0].clone()
    });
    assert_eq!(picture(gpu, &scene), sound);
}

pub fn normals_without_length_give_a_picture(gpu: &Gpu) {
    let mut scene = standing_quad();
    scene.objects[0].mesh.normals[0] = [0.0; 3];
    picture(gpu, &scene);
    scene.objects[0].mesh.normals.fill([0.0; 3]);
    picture(gpu, &scene);
}

/// A scene in other units.
fn scaled(scene: &Scene, scale: f32) -> Scene {
    let mut scene = scene.clone();
    for object in &mut scene.objects {
        let mesh = object.mesh.positions.iter_mut().flatten();
        let spheres = object.spheres.iter_mut().flat_map(|s| s.center.iter_mut());
        mesh.chain(spheres).for_each(|x| *x *= scale);
        object.spheres.iter_mut().for_each(|s| s.radius *= scale);
        let place = object.transform.translation;
        object.transform = Affine3A::from_translation((place * scale).into());
    }
    if let Some(ground) = &mut scene.ground {
        ground.height *= scale;
    }
    scene.camera.eye *= scale;
    scene.camera.target *= scale;
    scene
}

/// The same picture at a millionth and a million times the size; a sample at an edge may fall to either side.
pub fn scenes_of_any_size_look_the_same(gpu: &Gpu) {
    let scene = standing_quad();
    let usual = picture(gpu, &scene);
    for scale in [1e-6, 1e-3, 1e3, 1e6] {
        let found = picture(gpu, &scaled(&scene, scale));
        let off = |(a, b): (&[f32; 4], &[f32; 4])| {
            a.iter()
                .zip(b)
                .map(|(a, b)| (a - b).abs())
                .fold(0.0, f32::max)
        };
        let mut differences: Vec<f32> = found.iter().zip(&usual).map(off).collect();
        differences.sort_by(f32::total_cmp);
        let nearly_all = differences[differences.len() * 99 / 100];
        let most = differences[differences.len() - 1];
        println!("{scale:e}: {nearly_all:e}, at most {most:e}");
        assert!(nearly_all < 1e-4, "{scale:e}: {nearly_all} {most}");
    }
}
