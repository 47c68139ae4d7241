//! Light that bodies send on by their patches, from what falls on them to what receivers get (Iwasaki et al. 2007).

use glam::{Affine3A, Quat, Vec3, vec3};
use sh_bake::{SphereSet, irradiance_basis, shapes};
use sh_cpu::Frames;
use sh_scene::{
    Camera, EnvironmentMap, Indirect, Material, Mesh, Method, Object, Plan, Receiver, Scene,
    Settings,
};
use std::ops::Range;
use std::sync::Arc;

/// A body of so many spheres, whose patches send light on.
fn body(mesh: Mesh, albedo: f32, spheres: usize) -> Object {
    let material = Material::diffuse([albedo; 3]);
    Object {
        name: "body".into(),
        spheres: SphereSet::fit(&[&mesh], spheres).spheres,
        basis: irradiance_basis(&[(&mesh, &material)], 16, &|_| {}).map(Arc::new),
        mesh,
        material,
        ..Object::default()
    }
}

fn at(object: &Object, place: Vec3) -> Object {
    Object {
        transform: Affine3A::from_translation(place),
        ..object.clone()
    }
}

/// In an even sky of radiance 1.
fn scene(objects: Vec<Object>, bounces: u32) -> Scene {
    Scene {
        punctual: Vec::new(),
        objects,
        environment: EnvironmentMap::constant([1.0; 3]),
        lights: Vec::new(),
        ground: None,
        camera: Camera {
            eye: Vec3::Z,
            target: Vec3::ZERO,
            fov: 1.0,
        },
        settings: Settings {
            indirect: Some(Indirect {
                method: Method::BasisIrradiance,
                bounces,
                ..Indirect::default()
            }),
            ..Settings::default()
        },
    }
}

fn receiver(position: Vec3, normal: Vec3, object: u32) -> Receiver {
    Receiver {
        position: position.into(),
        covered: 1,
        normal: normal.normalize().into(),
        object,
    }
}

/// What receivers get of the sky, and of what bodies send: each a cluster of its own.
fn lit(frames: &mut Frames, scene: &Scene, receivers: &[Receiver]) -> [Vec<f32>; 2] {
    let clusters: Vec<Range<usize>> = (0..receivers.len()).map(|i| i..i + 1).collect();
    let plan = Plan::of_receivers(scene);
    let lit = frames.light(scene, &plan, receivers, &clusters).unwrap();
    [lit.radiance, lit.sent].map(|all| all.iter().map(|c| c[1]).collect())
}

fn sent(scene: &Scene, receivers: &[Receiver]) -> Vec<f32> {
    let [_, sent] = lit(&mut Frames::default(), scene, receivers);
    sent
}

/// The k-th of some directions that are spread evenly.
fn around(k: usize, count: usize) -> Vec3 {
    let height = 1.0 - 2.0 * (k as f32 + 0.5) / count as f32;
    let (sin, cos) = (k as f32 * 2.399_963).sin_cos();
    let flat = (1.0 - height * height).sqrt();
    vec3(flat * cos, height, flat * sin)
}

/// A ball in an even sky is as bright all over as its albedo, and seen as a disc: (R / d)² of its radiance falls on who
/// faces it, and on who sees it aslant the cosine of that, wherever they stand.
#[test]
fn a_ball_gives_what_a_disc_of_its_size_gives() {
    let scene = scene(vec![body(shapes::ball(1.0, 5), 0.5, 1)], 1);
    for (far, most) in [
        (1.1, 0.06),
        (1.5, 0.02),
        (2.5, 0.02),
        (4.0, 0.05),
        (9.0, 0.05),
    ] {
        for aslant in [0.0_f32, 0.7] {
            let receivers: Vec<Receiver> = (0..60)
                .map(|k| {
                    let out = around(k, 60);
                    let side = out.any_orthonormal_vector();
                    receiver(out * far, side * aslant.sin() - out * aslant.cos(), 0)
                })
                .collect();
            // Where the ball reaches below the horizon there is no closed form as short.
            if (1.0_f32 / far).asin() + aslant > 1.5 {
                continue;
            }
            let expected = 0.5 / (far * far) * aslant.cos();
            let found = sent(&scene, &receivers);
            let off = |x: &f32| (x / expected - 1.0).powi(2);
            let error = (found.iter().map(off).sum::<f32>() / found.len() as f32).sqrt();
            println!("{far} {aslant}: {error}");
            assert!(error < most, "{far}, {aslant}: {error}");
        }
    }
}

/// What a polygon of radiance 1 gives a receiver that has all of it above its horizon, as what albedo 1 reflects (Lambert 1760).
fn polygon(corners: &[Vec3], from: &Receiver) -> f64 {
    let (place, normal) = (Vec3::from(from.position), Vec3::from(from.normal));
    let towards = |k: usize| (corners[k % corners.len()] - place).as_dvec3().normalize();
    let edge = |k: usize| {
        let (a, b) = (towards(k), towards(k + 1));
        let across = a.cross(b);
        across.length().atan2(a.dot(b)) * across.normalize().dot(normal.as_dvec3())
    };
    let sum: f64 = (0..corners.len()).map(edge).sum();
    sum.abs() / (2.0 * std::f64::consts::PI)
}

/// A square in an even sky is as bright all over as its albedo, and gives what Lambert's formula says, from anywhere: as
/// small discs, as patches, as quarters of a region, as regions. Errors are in parts of its radiance; next to it single discs show.
#[test]
fn a_square_gives_what_a_square_gives() {
    let square = Object {
        spheres: Vec::new(),
        ..body(shapes::panel([1.0; 2], [4; 2]), 0.5, 1)
    };
    let scene = scene(vec![square], 1);
    let corners = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)];
    let corners = corners.map(|(x, y)| vec3(x, y, 0.0));
    for (height, most) in [
        (0.01, 0.012),
        (0.03, 0.004),
        (0.1, 0.007),
        (0.3, 0.001),
        (0.6, 0.001),
        (1.0, 3e-4),
        (2.0, 1e-4),
        (5.0, 1e-5),
    ] {
        let mut worst = 0.0_f64;
        for k in 0..100u8 {
            let [x, y] = [k / 10, k % 10].map(|i| 0.16 * (f32::from(i) - 4.37));
            let aslant = around(usize::from(k), 100) * 0.6;
            let place = vec3(x, y, height);
            let receiver = receiver(place, aslant - Vec3::Z, 0);
            let normal = Vec3::from(receiver.normal);
            if corners
                .iter()
                .any(|corner| (corner - place).dot(normal) < 0.0)
            {
                continue;
            }
            let expected = 0.5 * polygon(&corners, &receiver);
            let found = f64::from(sent(&scene, &[receiver])[0]);
            worst = worst.max((found - expected).abs() / 0.5);
        }
        println!("{height}: {worst}");
        assert!(worst < most, "{height}: {worst}");
    }
}

/// Receivers of several bodies in one cluster get what each gets by itself, as many side by side as are computed at once.
#[test]
fn receivers_of_other_bodies_change_nothing() {
    let ball = body(shapes::ball(0.4, 4), 0.8, 1);
    let floor = Object {
        spheres: Vec::new(),
        transform: Affine3A::from_rotation_translation(
            Quat::from_rotation_x(-std::f32::consts::FRAC_PI_2),
            vec3(0.0, -0.5, 0.0),
        ),
        ..body(shapes::panel([3.0; 2], [4; 2]), 0.8, 1)
    };
    let balls = [vec3(-0.6, 0.0, 0.0), vec3(0.6, 0.0, 0.1)];
    let mut objects = vec![floor];
    objects.extend(balls.map(|place| at(&ball, place)));
    let scene = scene(objects, 2);
    let on = |k: usize| match k / 32 {
        0 => {
            let [x, z] = [k % 8, k / 8].map(|i| 0.3 * i as f32);
            receiver(vec3(x - 1.05, -0.5, z - 0.45), Vec3::Y, 1)
        }
        body => {
            let out = around(k % 32, 32);
            receiver(balls[body - 1] + 0.4 * out, out, body as u32 + 1)
        }
    };
    let receivers: Vec<Receiver> = (0..96).map(on).collect();
    let apart = sent(&scene, &receivers);
    let plan = Plan::of_receivers(&scene);
    let one = std::iter::once(0..96).collect::<Vec<_>>();
    let together = Frames::default().light(&scene, &plan, &receivers, &one);
    let pairs = together.unwrap().sent.into_iter().zip(apart);
    let worst = pairs.map(|(a, b)| (a[1] - b).abs()).fold(0.0, f32::max);
    println!("{worst}");
    assert!(worst < 1e-4, "{worst}");
}

/// White bodies in an even sky of 1: with every bounce they come nearer to 1 everywhere, and no farther. What is off is
/// shadows' order and near discs.
#[test]
fn a_white_furnace_comes_to_its_limit() {
    let ball = body(shapes::ball(0.5, 4), 1.0, 1);
    let places = [
        vec3(0.0, 0.0, 0.0),
        vec3(1.3, 0.1, 0.0),
        vec3(-0.3, 1.25, 0.2),
        vec3(0.2, -0.2, 1.4),
        vec3(-1.2, -0.6, -0.3),
    ];
    let objects: Vec<Object> = places.iter().map(|place| at(&ball, *place)).collect();
    let receivers: Vec<Receiver> = (0..5 * 60)
        .map(|k| {
            let out = around(k / 5, 60);
            receiver(places[k % 5] + out * 0.5, out, (k % 5) as u32 + 1)
        })
        .collect();
    let mut before = 0.0;
    let mut told = Vec::new();
    for bounces in [1, 2, 3, 5, 8] {
        let scene = scene(objects.clone(), bounces);
        let [direct, sent] = lit(&mut Frames::default(), &scene, &receivers);
        let all: Vec<f32> = direct.iter().zip(&sent).map(|(a, b)| a + b).collect();
        let mean = all.iter().sum::<f32>() / all.len() as f32;
        let most = all.iter().copied().fold(0.0, f32::max);
        told.push((bounces, mean, most));
        assert!(mean > before, "{told:?}");
        before = mean;
    }
    println!("{told:?}");
    let (_, mean, most) = told[told.len() - 1];
    assert!((mean - 1.0).abs() < 0.02 && most < 1.06, "{told:?}");
}

/// A body that is turned, enlarged and moved gives receivers that are moved with it the same.
#[test]
fn what_a_body_gives_moves_with_it() {
    let still = body(shapes::torus_knot(2, 3, 0.5, 0.2, 0.12), 0.7, 24);
    let mover = Affine3A::from_scale_rotation_translation(
        Vec3::splat(2.5),
        Quat::from_euler(glam::EulerRot::XYZ, 0.5, 1.1, -2.0),
        vec3(3.0, -1.0, 2.0),
    );
    let moved = Object {
        transform: mover,
        ..still.clone()
    };
    let receivers: Vec<Receiver> = (0..80)
        .map(|k| {
            receiver(
                around(k, 80) * (0.5 + 0.02 * k as f32),
                -around(k + 3, 90),
                0,
            )
        })
        .collect();
    let taken: Vec<Receiver> = receivers
        .iter()
        .map(|r| {
            let normal = mover.transform_vector3(r.normal.into());
            receiver(mover.transform_point3(r.position.into()), normal, 0)
        })
        .collect();
    let (here, there) = (
        sent(&scene(vec![still], 3), &receivers),
        sent(&scene(vec![moved], 3), &taken),
    );
    let brightest = here.iter().copied().fold(0.0, f32::max);
    assert!(brightest > 0.05, "{brightest}");
    for (a, b) in here.iter().zip(&there) {
        assert!((a - b).abs() < 1e-3 * brightest, "{a} {b}");
    }
}

/// From far away to the surface, and past a body in between: in steps a sixteenth as long light changes by no more than
/// about a sixteenth.
#[test]
fn nothing_jumps_as_a_receiver_walks_past() {
    let cube = body(shapes::rounded_box(Vec3::splat(0.8), 0.02), 0.8, 8);
    let ball = body(shapes::ball(0.3, 3), 0.8, 1);
    let scene = scene(vec![cube, at(&ball, vec3(0.9, 0.1, 0.62))], 2);
    let along = |steps: usize| {
        let walk = |k: usize| {
            let t = 5.0 * (1.0 - k as f32 / steps as f32);
            let place = vec3(0.41 + t, 0.05 + 0.1 * t, 0.1 + 0.3 * t);
            receiver(place, vec3(-1.0, 0.2, -0.3), 0)
        };
        let all = sent(&scene, &(0..=steps).map(walk).collect::<Vec<_>>());
        all.windows(2)
            .map(|pair| (pair[1] - pair[0]).abs())
            .fold(0.0, f32::max)
    };
    let [coarse, fine] = [along(1000), along(16_000)];
    println!("{coarse} {fine}");
    assert!(
        fine < coarse / 8.0 && fine < 1.0 / 1024.0,
        "{coarse} {fine}"
    );
}

/// Nothing that is seen is NaN, below 0 or brighter than the brightest surface, wherever receivers are and whatever bodies
/// are: touching, nested, flat, open, of one triangle, of none, black, without extent, or nowhere.
#[test]
fn bodies_of_any_kind_are_bounded() {
    let triangle = Mesh {
        positions: vec![[0.0; 3], [0.6, 0.0, 0.0], [0.0, 0.0, -0.6]],
        normals: vec![[0.0, 1.0, 0.0]; 3],
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    let cube = body(shapes::rounded_box(Vec3::splat(0.8), 0.02), 0.9, 8);
    let flat = Object {
        transform: Affine3A::from_scale(Vec3::ZERO),
        ..cube.clone()
    };
    let nowhere = Object {
        transform: Affine3A::from_translation(Vec3::NAN),
        ..cube.clone()
    };
    let objects = vec![
        cube.clone(),
        at(&body(shapes::ball(0.3, 3), 0.9, 1), vec3(0.1, 0.0, 0.1)),
        at(&body(shapes::ball(0.3, 3), 0.0, 1), vec3(0.7, 0.0, 0.0)),
        at(&body(triangle, 1.0, 1), vec3(0.0, 0.45, 0.0)),
        body(Mesh::default(), 1.0, 1),
        flat,
        nowhere,
    ];
    assert!(objects[4].basis.is_none());
    let scene = scene(objects, 4);
    let mut receivers = vec![
        receiver(Vec3::ZERO, Vec3::Y, 0),
        receiver(Vec3::ZERO, Vec3::Y, 1),
    ];
    for object in 0..4 {
        for k in 0..200 {
            let place = around(k, 200) * (0.01 * k as f32).powi(2);
            receivers.push(receiver(place, around(7 * k, 1400), object));
        }
        let basis = scene.objects[0].basis.as_ref().unwrap();
        for patch in basis.parts().patches.iter().step_by(9) {
            let (place, normal) = (
                patch.whole.disc.center.into(),
                Vec3::from(patch.whole.disc.normal),
            );
            receivers.push(receiver(place, normal, object));
            receivers.push(receiver(place, -normal, object));
        }
    }
    let [direct, sent] = lit(&mut Frames::default(), &scene, &receivers);
    for (i, (direct, sent)) in direct.iter().zip(&sent).enumerate() {
        assert!((0.0..=1.01).contains(direct), "{i}: {direct}");
        assert!(
            (0.0..=1.06).contains(sent),
            "{i}: {sent} at {:?}",
            receivers[i]
        );
    }
    assert!(sent.iter().any(|x| *x > 0.2));
}

/// A frame is the same whatever came before it, where nothing moves, where one body does, and where the light changes.
#[test]
fn a_frame_is_the_same_whatever_came_before_it() {
    let ball = body(shapes::ball(0.5, 3), 0.8, 1);
    let mut scene = scene(vec![ball.clone(), at(&ball, vec3(1.2, 0.0, 0.0))], 3);
    let receivers: Vec<Receiver> = (0..40)
        .map(|k| receiver(around(k, 40) * 2.0, -around(k, 40), 0))
        .collect();
    let mut frames = Frames::default();
    let mut same = |scene: &Scene| {
        let fresh = lit(&mut Frames::default(), scene, &receivers);
        for _ in 0..2 {
            assert_eq!(lit(&mut frames, scene, &receivers), fresh);
        }
        fresh
    };
    let first = same(&scene);
    scene.objects[1].transform.translation.y = 0.5;
    assert_ne!(same(&scene), first);
    scene.environment = EnvironmentMap::constant([0.5; 3]);
    same(&scene);
    scene.objects[1].basis = body(shapes::ball(0.5, 3), 0.1, 1).basis;
    same(&scene);
    scene.objects[1].transform.translation.y = 0.0;
    scene.environment = EnvironmentMap::constant([1.0; 3]);
    scene.objects[1].basis.clone_from(&ball.basis);
    assert_eq!(same(&scene), first);
}
