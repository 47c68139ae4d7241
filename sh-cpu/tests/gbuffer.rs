//! The G-buffer against surfaces whose intersections are known in closed form.

mod common;

use common::{Random, object, scene, sphere_mesh};
use glam::{Affine3A, Quat, Vec3, Vec3A, Vec4, vec3};
use sh_cpu::{Error, Gbuffer, Geometry, gbuffer};
use sh_scene::{Camera, Ground, Mesh, Scene, Texture, Tiles, View};
use std::f32::consts::PI;

/// All samples of a picture, row by row.
fn shoot(scene: &Scene, width: u32, height: u32) -> (View, Gbuffer) {
    let geometry = Geometry::new(scene).unwrap();
    let view = View {
        camera: scene.camera,
        width,
        height,
    };
    let grid = view.samples();
    let tiles = grid.tiles();
    let mut tiled = Gbuffer::default();
    gbuffer(&geometry, &view, grid, 0..tiles.rows, &mut tiled).unwrap();
    let mut out = Gbuffer::default();
    for y in 0..grid.rows {
        for x in 0..grid.columns {
            let at = tiles.index(x, y);
            out.receivers.push(tiled.receivers[at]);
            out.albedo.push(tiled.albedo[at]);
        }
    }
    let covered = |all: &Gbuffer| all.receivers.iter().filter(|r| r.covered != 0).count();
    assert_eq!(covered(&out), covered(&tiled), "nothing beyond the grid");
    (view, out)
}

/// Distance along a ray to a sphere, if it hits it.
fn sphere_distance(eye: Vec3, direction: Vec3, center: Vec3, radius: f32) -> Option<f64> {
    let (o, d) = ((eye - center).as_dvec3(), direction.as_dvec3());
    let half = o.dot(d);
    let discriminant = half * half - o.length_squared() + f64::from(radius).powi(2);
    (discriminant >= 0.0).then(|| -half - discriminant.sqrt())
}

#[test]
fn a_fine_sphere_is_hit_where_the_analytic_sphere_is() {
    let center = vec3(0.3, -0.2, 0.4);
    let transform = Affine3A::from_scale_rotation_translation(
        Vec3::splat(0.5),
        Quat::from_rotation_x(0.7),
        center,
    );
    let scene = scene(vec![object(sphere_mesh(2.0, 96), transform)]);
    let (view, samples) = shoot(&scene, 160, 120);
    // Of the 2·96 columns each spans 1.9°: the mesh lies within 1 - cos(0.94°)·cos(0.94°) of the sphere.
    let sag = 3e-4;
    let mut hits = 0;
    for (i, receiver) in samples.receivers.iter().enumerate() {
        let direction = view.ray(view.samples(), i as u32 % 320, i as u32 / 320);
        let eye = view.camera.eye;
        let inner = sphere_distance(eye, direction, center, 1.0 - sag);
        let outer = sphere_distance(eye, direction, center, 1.0);
        assert!(
            receiver.covered == 0 || outer.is_some(),
            "sample {i} hits beside the sphere"
        );
        assert!(
            receiver.covered == 1 || inner.is_none(),
            "sample {i} slips through the sphere"
        );
        if receiver.covered == 1 {
            hits += 1;
            let out = Vec3::from(receiver.position) - center;
            assert!(
                out.length() <= 1.0 + 1e-5 && out.length() >= 1.0 - sag,
                "sample {i}"
            );
            let across = (Vec3::from(receiver.position) - eye)
                .cross(direction)
                .length();
            assert!(across < 5e-6, "sample {i} lies {across} m beside its ray");
            let normal = Vec3::from(receiver.normal);
            assert!((normal.length() - 1.0).abs() < 1e-6);
            assert!(normal.dot(out.normalize()) > 0.9999, "sample {i}");
            assert_eq!(receiver.object, 1);
        }
    }
    assert!(hits > 10_000, "{hits}");
}

#[test]
fn the_ground_is_seen_from_above_only_and_behind_what_stands_on_it() {
    let mut scene = scene(vec![object(sphere_mesh(1.0, 32), Affine3A::IDENTITY)]);
    scene.ground = Some(Ground {
        height: -1.0,
        albedo: [0.2, 0.4, 0.6],
    });
    scene.camera.eye = vec3(0.0, 0.5, 5.0);
    let (view, samples) = shoot(&scene, 80, 60);
    let (mut ground, mut body) = (0, 0);
    for (i, (receiver, albedo)) in samples.receivers.iter().zip(&samples.albedo).enumerate() {
        let direction = view.ray(view.samples(), i as u32 % 160, i as u32 / 160);
        if receiver.covered == 0 {
            assert!(direction.y >= 0.0);
        } else if receiver.object == 0 {
            ground += 1;
            assert_eq!(receiver.position[1], -1.0);
            assert_eq!(receiver.normal, [0.0, 1.0, 0.0]);
            assert_eq!(*albedo, [0.2, 0.4, 0.6, 0.0]);
            let expected = view.camera.eye + direction * (-1.5 / direction.y);
            assert!((expected - Vec3::from(receiver.position)).length() < 1e-4 * expected.length());
        } else {
            body += 1;
        }
    }
    assert!(ground > 1000 && body > 1000);

    scene.camera.eye = vec3(0.0, -3.0, 5.0);
    let (_, below) = shoot(&scene, 80, 60);
    assert!(
        below
            .receivers
            .iter()
            .all(|r| r.covered == 0 || r.object == 1)
    );
    assert!(below.receivers.iter().any(|r| r.covered == 1));
}

#[test]
fn no_ray_slips_between_triangles_that_share_an_edge() {
    // A closed sphere that fills the view many times over, its edges crossed at all angles.
    let mut random = Random(7);
    for rings in [3, 8, 25] {
        let scene = scene(vec![object(sphere_mesh(1.0, rings), Affine3A::IDENTITY)]);
        let geometry = Geometry::new(&scene).unwrap();
        for i in 0..40_000 {
            // From outside towards a point well inside the inscribed sphere of the coarsest mesh.
            let mut origin = random.direction() * random.within(1.5, 60.0);
            let mut target = random.direction() * random.within(0.0, 0.4);
            if i % 2 == 0 {
                // Through a vertex, or a point of an edge, from a side that the mesh there faces.
                let mesh = &scene.objects[0].mesh;
                let at = (random.number() * mesh.triangles.len() as f32) as usize;
                let [a, b, _] = mesh.triangles[at].map(|i| Vec3::from(mesh.positions[i as usize]));
                let part = if i % 4 == 0 { 0.0 } else { random.number() };
                target = a.lerp(b, part);
                let lean = random.direction() * if rings == 3 { 0.3 } else { 0.7 };
                origin = target + (target.normalize() + lean) * random.within(0.5, 60.0);
            }
            let direction = (target - origin).normalize();
            let hit = geometry.cast(origin.into(), direction.into());
            assert!(
                hit.is_some(),
                "ray from {origin} towards {target} slips through {rings} rings"
            );
        }
    }
}

#[test]
fn seen_from_behind_an_open_mesh_shows_its_other_side() {
    let mesh = Mesh {
        positions: vec![[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, 0.0]],
        normals: vec![[0.0, 0.0, 1.0]; 3],
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    let scene = scene(vec![object(mesh, Affine3A::IDENTITY)]);
    let geometry = Geometry::new(&scene).unwrap();
    let front = geometry.cast(Vec3A::Z, Vec3A::NEG_Z).unwrap();
    let back = geometry.cast(Vec3A::NEG_Z, Vec3A::Z).unwrap();
    assert_eq!((front.normal, back.normal), (Vec3A::Z, Vec3A::NEG_Z));
    assert_eq!((front.distance, back.distance), (1.0, 1.0));
    assert_eq!(front.uv, None);
    assert_eq!(geometry.cast(Vec3A::Z, Vec3A::Z), None);
    assert_eq!(geometry.cast(Vec3A::Z, Vec3A::X), None);
}

#[test]
fn a_normal_that_leans_away_on_a_front_face_is_left_alone() {
    // Normals bent so far towards +X that a viewer from the left at a grazing angle sees their back.
    let bent = vec3(0.9, 0.0, 0.435_89);
    let mesh = Mesh {
        positions: vec![[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, 0.0]],
        normals: vec![bent.into(); 3],
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    let scene = scene(vec![object(mesh, Affine3A::IDENTITY)]);
    let geometry = Geometry::new(&scene).unwrap();
    let eye = Vec3A::new(-3.0, 0.0, 0.5);
    let hit = geometry.cast(eye, -eye.normalize()).unwrap();
    assert!(hit.normal.dot(Vec3A::from(bent)) > 0.999, "{}", hit.normal);
    assert!(hit.normal.dot(eye) < 0.0, "the case is not the one meant");
}

#[test]
fn textures_multiply_the_albedo() {
    let mut body = object(sphere_mesh(1.0, 24), Affine3A::IDENTITY);
    body.material.albedo = [0.5, 1.0, 1.0];
    // Red above, blue below: v runs from the top.
    let rgba = vec![255, 0, 0, 255, 0, 0, 255, 255];
    body.material.texture = Some(Texture {
        width: 1,
        height: 2,
        rgba,
    });
    let scene = scene(vec![body]);
    let (_, samples) = shoot(&scene, 40, 40);
    let at = |x: usize, y: usize| samples.albedo[y * 80 + x];
    let (upper, lower) = (at(40, 26), at(40, 54));
    assert!(upper[0] > 0.45 && upper[2] < 0.1, "{upper:?}");
    assert!(lower[2] > 0.9 && lower[0] < 0.05, "{lower:?}");
    assert_eq!(at(0, 0), [0.0; 4]);
}

#[test]
fn vertex_colours_multiply_the_albedo() {
    let mut mesh = sphere_mesh(1.0, 48);
    mesh.colors = mesh
        .positions
        .iter()
        .map(|p| p.map(|c| 0.5 + 0.5 * c))
        .collect();
    let mut body = object(mesh, Affine3A::IDENTITY);
    body.material.albedo = [0.5, 1.0, 1.0];
    let (_, samples) = shoot(&scene(vec![body]), 40, 40);
    let mut covered = 0;
    for (receiver, albedo) in samples.receivers.iter().zip(&samples.albedo) {
        if receiver.covered == 1 {
            // Linear in the position, so that interpolating it is exact.
            let color = Vec3::from(receiver.position) * 0.5 + 0.5;
            let expected = color * vec3(0.5, 1.0, 1.0);
            assert!(
                expected.distance(Vec4::from(*albedo).truncate()) < 1e-5,
                "{receiver:?}: {albedo:?}"
            );
            covered += 1;
        }
    }
    assert!(covered > 300, "{covered}");
}

#[test]
fn bands_are_parts_of_the_whole() {
    let mut scene = scene(vec![object(sphere_mesh(1.0, 16), Affine3A::IDENTITY)]);
    scene.ground = Some(Ground {
        height: -1.0,
        albedo: [0.5; 3],
    });
    let geometry = Geometry::new(&scene).unwrap();
    let view = View {
        camera: scene.camera,
        width: 33,
        height: 20,
    };
    let grid = view.samples();
    let (mut whole, mut band) = (Gbuffer::default(), Gbuffer::default());
    gbuffer(&geometry, &view, grid, 0..3, &mut whole).unwrap();
    for (start, end) in [(0, 1), (1, 3), (2, 3), (3, 3)] {
        gbuffer(&geometry, &view, grid, start..end, &mut band).unwrap();
        // Five tiles across.
        let range = start as usize * 5 * Tiles::AREA..end as usize * 5 * Tiles::AREA;
        assert_eq!(band.receivers, whole.receivers[range.clone()]);
        assert_eq!(band.albedo, whole.albedo[range]);
    }
}

#[test]
fn an_empty_scene_has_nothing_to_hit() {
    let (_, samples) = shoot(&scene(vec![]), 8, 8);
    assert!(samples.receivers.iter().all(|r| r.covered == 0));
    let flat = Mesh {
        positions: vec![[1.0, 0.0, 0.0]; 3],
        normals: vec![[0.0, 1.0, 0.0]; 3],
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    let (_, samples) = shoot(&scene(vec![object(flat, Affine3A::IDENTITY)]), 8, 8);
    assert!(samples.receivers.iter().all(|r| r.covered == 0));
}

#[test]
fn contradictions_are_reported_with_object_and_place() {
    let refused = |change: fn(&mut Mesh)| {
        let mut body = object(sphere_mesh(1.0, 4), Affine3A::IDENTITY);
        change(&mut body.mesh);
        Geometry::new(&scene(vec![body])).unwrap_err().to_string()
    };
    let says = |message: String, part: &str| {
        assert!(message.contains("object 0 (\"body\")"), "{message}");
        assert!(message.contains(part), "{message}");
    };
    says(
        refused(|m| m.triangles[2][1] = 1000),
        "triangle 2 refers to vertex 1000 of 45",
    );
    says(
        refused(|m| m.positions[3][1] = f32::NAN),
        "position 3 is not finite",
    );
    says(
        refused(|m| m.normals.truncate(44)),
        "45 positions but 44 normals",
    );
    says(
        refused(|m| m.uvs.truncate(1)),
        "45 positions but 1 texture coordinates",
    );

    let mut body = object(sphere_mesh(1.0, 4), Affine3A::IDENTITY);
    body.material.texture = Some(Texture {
        width: 2,
        height: 2,
        rgba: vec![0; 12],
    });
    says(
        Geometry::new(&scene(vec![body])).unwrap_err().to_string(),
        "needs 16 bytes",
    );
}

#[test]
fn cameras_and_sizes_that_show_nothing_are_refused() {
    let scene = scene(vec![]);
    let geometry = Geometry::new(&scene).unwrap();
    let good = scene.camera;
    let shot = |camera: Camera, width, height| {
        let view = View {
            camera,
            width,
            height,
        };
        let grid = view.samples();
        gbuffer(&geometry, &view, grid, 0..1, &mut Gbuffer::default())
    };
    assert_eq!(shot(good, 4, 4), Ok(()));
    assert_eq!(
        shot(good, 0, 4),
        Err(Error::Size {
            width: 0,
            height: 4
        })
    );
    assert_eq!(
        shot(good, 4, 1 << 20),
        Err(Error::Size {
            width: 4,
            height: 1 << 20
        })
    );
    for bad in [
        Camera {
            target: good.eye,
            ..good
        },
        Camera { fov: 0.0, ..good },
        Camera { fov: PI, ..good },
        Camera {
            fov: f32::NAN,
            ..good
        },
        Camera {
            eye: Vec3::splat(f32::NAN),
            ..good
        },
    ] {
        assert!(
            matches!(shot(bad, 4, 4), Err(Error::Camera { .. })),
            "{bad:?}"
        );
    }
}
