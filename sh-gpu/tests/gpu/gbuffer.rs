//! The G-buffer against rays intersected by hand.

use crate::gpu::Gpu;
use crate::scenes::{quad, standing_quad, view};
use glam::{Affine3A, Quat, Vec2, Vec3};
use sh_gpu::{Bands, Bodies, GbufferPass};
use sh_scene::{Receiver, Scene, Texture, View};

/// Receivers and albedo of a whole picture in one band, row by row.
fn gbuffer(gpu: &Gpu, scene: &Scene, view: &View) -> (Vec<Receiver>, Vec<[f32; 4]>) {
    let grid = view.samples();
    let bands = Bands::new(&gpu.device, view, grid, 1 << 20).unwrap();
    assert_eq!(bands.count(), 1);
    let bodies = Bodies::new(&gpu.device, &gpu.queue, scene).unwrap();
    let pass = GbufferPass::new(&gpu.device, &bands).unwrap();
    let (receivers, albedo) = (
        gpu.room(bands.receivers(0) * 32),
        gpu.room(bands.receivers(0) * 16),
    );
    let bound = pass
        .bind(
            &gpu.device,
            receivers.as_entire_buffer_binding(),
            albedo.as_entire_buffer_binding(),
        )
        .unwrap();
    bands.prepare(&gpu.queue, view, scene.ground).unwrap();
    bodies.prepare(&gpu.queue, scene).unwrap();
    // Something else first: a host that draws nothing sees nothing, and leaves nothing behind.
    gpu.submit(|encoder| {
        pass.record(encoder, &bands, 0, &bodies, &bound, None);
        pass.record_with(encoder, &bands, 0, |_| {}, &bound, None);
    });
    let nothing: Vec<Receiver> = gpu.read(&receivers);
    assert!(nothing.iter().all(|receiver| receiver.covered == 0));
    gpu.submit(|encoder| pass.record(encoder, &bands, 0, &bodies, &bound, None));
    let (receivers, albedo): (Vec<Receiver>, Vec<[f32; 4]>) =
        (gpu.read(&receivers), gpu.read(&albedo));
    let tiles = bands.tiles(0);
    let covered = |receivers: &[Receiver]| receivers.iter().filter(|r| r.covered != 0).count();
    let rows = (0..grid.rows).flat_map(|y| (0..grid.columns).map(move |x| tiles.index(x, y)));
    let rows: Vec<usize> = rows.collect();
    let found: Vec<Receiver> = rows.iter().map(|&i| receivers[i]).collect();
    assert_eq!(covered(&found), covered(&receivers), "beyond the grid");
    (found, rows.iter().map(|&i| albedo[i]).collect())
}

/// Where a ray meets the quad of half sides 1 that `to_world` places: position and uv.
fn meets_quad(to_world: Affine3A, eye: Vec3, ray: Vec3) -> Option<(Vec3, Vec2)> {
    let inverse = to_world.inverse();
    let (o, d) = (
        inverse.transform_point3(eye),
        inverse.transform_vector3(ray),
    );
    let hit = o - d * (o.z / d.z);
    let inside = (-o.z / d.z > 0.0) && hit.x.abs() < 1.0 && hit.y.abs() < 1.0;
    inside.then(|| (to_world.transform_point3(hit), (hit.truncate() + 1.0) * 0.5))
}

pub fn samples_are_where_rays_meet_surfaces(gpu: &Gpu) {
    let mut scene = standing_quad();
    scene.objects[0].transform = Affine3A::from_scale_rotation_translation(
        Vec3::splat(0.8),
        Quat::from_euler(glam::EulerRot::YXZ, 0.4, -0.3, 0.2),
        Vec3::new(0.1, 0.6, -0.2),
    );
    let view = view(&scene, 120, 90);
    let (receivers, albedo) = gbuffer(gpu, &scene, &view);
    let quad_normal = scene.objects[0]
        .transform
        .transform_vector3(Vec3::Z)
        .normalize();
    let (mut seen, mut different) = ([0; 3], 0);
    for (i, (found, albedo)) in receivers.iter().zip(&albedo).enumerate() {
        let ray = view.ray(view.samples(), i as u32 % 240, i as u32 / 240);
        let eye = view.camera.eye;
        let quad = meets_quad(scene.objects[0].transform, eye, ray).map(|(p, _)| p);
        let ground = (ray.y < 0.0).then(|| eye - ray * (eye.y / ray.y));
        let nearer = |p: &Vec3| ground.is_none_or(|g| p.distance(eye) < g.distance(eye));
        let (what, position, normal) = match (quad.filter(nearer), ground) {
            (Some(p), _) => (0, p, quad_normal),
            (None, Some(p)) => (1, p, Vec3::Y),
            (None, None) => (2, Vec3::ZERO, Vec3::ZERO),
        };
        let object = [1, 0, 0][what];
        // A sample on an edge may fall to either side.
        if (found.covered, found.object) != (u32::from(what != 2), object) {
            different += 1;
            continue;
        }
        seen[what] += 1;
        let off = position.distance(found.position.into());
        let far = position.distance(eye);
        // Where the ground is seen at a grazing angle, a rounded ray lands far off, but along the ray.
        let grazing = if what == 1 { far / eye.y } else { 1.0 };
        assert!(
            off <= 3e-6 * far * grazing,
            "sample {i}: {found:?}, but {position} is {off} away"
        );
        assert!(
            normal.distance(found.normal.into()) < 1e-6,
            "sample {i}: {found:?}, not {normal}"
        );
        let expected = [[0.25, 0.5, 0.75], [0.1, 0.2, 0.3], [0.0; 3]][what];
        for c in 0..3 {
            assert!(
                (albedo[c] - expected[c]).abs() < 1e-5,
                "sample {i}: {albedo:?}"
            );
        }
    }
    assert!(seen.iter().all(|&count| count > 1000), "{seen:?}");
    assert!(different <= 4, "{different} samples show something else");
}

/// A quad seen from behind, and a quad whose smooth normals lean away from the viewer.
pub fn normals_turn_to_the_viewer(gpu: &Gpu) {
    let mut scene = standing_quad();
    scene.ground = None;
    let center = |scene: &Scene| {
        let view = view(scene, 9, 9);
        gbuffer(gpu, scene, &view).0[9 * 18 + 9]
    };
    scene.camera.eye = Vec3::new(0.0, 1.0, 3.0);
    assert!(Vec3::from(center(&scene).normal).distance(Vec3::Z) < 1e-6);
    scene.camera.eye.z = -3.0;
    assert!(Vec3::from(center(&scene).normal).distance(Vec3::NEG_Z) < 1e-6);
    // Wound the other way, it is the normals that say where outside is.
    for triangle in &mut scene.objects[0].mesh.triangles {
        triangle.swap(0, 1);
    }
    assert!(Vec3::from(center(&scene).normal).distance(Vec3::NEG_Z) < 1e-6);
    // Leaning away, but still on the outside.
    let leaning = Vec3::new(0.9, 0.0, 0.2).normalize();
    scene.objects[0].mesh.normals = vec![leaning.into(); 4];
    scene.camera.eye = Vec3::new(-3.0, 1.0, 2.0);
    let found = center(&scene);
    assert!(leaning.dot(Vec3::from(found.position) - scene.camera.eye) > 0.0);
    assert!(
        Vec3::from(found.normal).distance(leaning) < 1e-6,
        "{found:?}"
    );
}

pub fn textures_are_bilinear_and_repeat(gpu: &Gpu) {
    let mut scene = standing_quad();
    scene.ground = None;
    scene.objects[0].mesh = quad(Vec3::ZERO, Vec3::X, Vec3::Y);
    for uv in &mut scene.objects[0].mesh.uvs {
        *uv = uv.map(|c| c * 3.0 - 1.0);
    }
    let codes = [0, 255, 128, 64, 200, 17_u8];
    let rgba = codes.iter().flat_map(|&c| [c, 255 - c, 0, 255]).collect();
    scene.objects[0].material.texture = Some(Texture {
        width: 3,
        height: 2,
        rgba,
    });
    let linear = |code: u8| {
        let c = f64::from(code) / 255.0;
        if c <= 0.04045 {
            c / 12.92
        } else {
            ((c + 0.055) / 1.055).powf(2.4)
        }
    };
    let view = view(&scene, 100, 100);
    let (receivers, albedo) = gbuffer(gpu, &scene, &view);
    let mut compared = 0;
    for (i, found) in albedo
        .iter()
        .enumerate()
        .filter(|(i, _)| receivers[*i].covered == 1)
    {
        let ray = view.ray(view.samples(), i as u32 % 200, i as u32 / 200);
        let Some((_, uv)) = meets_quad(scene.objects[0].transform, view.camera.eye, ray) else {
            continue;
        };
        let uv = uv * 3.0 - 1.0;
        let (x, y) = (f64::from(uv.x) * 3.0 - 0.5, f64::from(uv.y) * 2.0 - 0.5);
        let texel = |dx: f64, dy: f64| {
            let (x, y) = (
                (x.floor() + dx).rem_euclid(3.0),
                (y.floor() + dy).rem_euclid(2.0),
            );
            codes[y as usize * 3 + x as usize]
        };
        for (c, factor) in [(0, 0.25), (1, 0.5)] {
            let value = |dx, dy| {
                linear(if c == 0 {
                    texel(dx, dy)
                } else {
                    255 - texel(dx, dy)
                })
            };
            let (fx, fy) = (x - x.floor(), y - y.floor());
            let upper = value(0.0, 0.0) * (1.0 - fx) + value(1.0, 0.0) * fx;
            let lower = value(0.0, 1.0) * (1.0 - fx) + value(1.0, 1.0) * fx;
            let expected = factor * (upper * (1.0 - fy) + lower * fy);
            let off = (f64::from(found[c]) - expected).abs();
            // Software drivers decode sRGB with a polynomial; Direct3D permits half an 8-bit code.
            assert!(
                off < 1e-3,
                "sample {i}, uv {uv}: {found:?}, not {expected} in channel {c}"
            );
        }
        compared += 1;
    }
    assert!(compared > 5000, "{compared}");
}
