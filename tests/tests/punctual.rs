//! Lights with sharp shadows, against their integrals and against paths.

use glam::{Affine3A, Quat, Vec3, Vec3A};
use sh_bake::shapes;
use sh_cpu::{Frames, Geometry};
use sh_reference::paths::{Options, PathTracer};
use sh_reference::quadrature::Rule;
use sh_scene::{
    Camera, EnvironmentMap, Ground, Material, Mesh, Object, Plan, PunctualLight, PunctualShape,
    Receiver, Scene, Settings,
};
use std::f32::consts::PI;
use std::ops::Range;

fn point(position: Vec3, radius: f32) -> PunctualLight {
    PunctualLight::new(PunctualShape::Point { position, radius }, [PI; 3])
}

fn spot(position: Vec3, [angle, blend, radius]: [f32; 3]) -> PunctualLight {
    let shape = PunctualShape::Spot {
        position,
        towards: -position,
        angle: angle.to_radians(),
        blend,
        radius,
    };
    PunctualLight::new(shape, [60.0, 50.0, 40.0])
}

fn sun(degrees: f32) -> PunctualLight {
    let shape = PunctualShape::Sun {
        direction: Vec3::new(1.0, 1.5, 0.7),
        angle: degrees.to_radians(),
    };
    PunctualLight::new(shape, [3.0; 3])
}

/// A ball that the horizon cuts gives the mean cosine of what is above it; one that it does not cut is exact.
#[test]
fn a_ball_gives_its_integral() {
    for radius in [0.02_f32, 0.2, 0.6] {
        let sine = radius / 2.0;
        for step in -12..=12 {
            let cosine = sine * step as f32 / 8.0;
            let direction = Vec3::new((1.0 - cosine * cosine).sqrt(), cosine, 0.0);
            let light = point(2.0 * direction, radius).record().unwrap();
            let given = light.radiance(Vec3::ZERO, Vec3::Y)[0];
            let least = (1.0 - f64::from(sine * sine)).sqrt();
            let cap = Rule::zone(direction.as_dvec3().to_array(), least, 1.0, 120);
            // Radiance I / π r², over π.
            let exact = cap.integrate(|d| d[1].max(0.0)) / f64::from(PI * radius * radius);
            let off = (f64::from(given) - exact).abs() * 4.0;
            let bound = if cosine >= sine {
                2e-3 * f64::from(sine)
            } else {
                0.04 * f64::from(sine)
            };
            assert!(off < bound + 1e-6, "{radius}, {cosine}: {given} of {exact}");
        }
    }
}

/// A spot is as bright as a point in the middle of its cone, and dark outside of it, however narrow or wide it is.
#[test]
fn a_cone_fades_to_its_edge() {
    for angle in [0.1, 1.0, 40.0, 120.0, 179.0_f32] {
        for blend in [0.0, 0.2, 1.0] {
            let position = Vec3::new(0.0, 5.0, 0.0);
            let light = spot(position, [angle, blend, 0.0]).record().unwrap();
            let at = |part: f32| {
                let aside = 0.5 * angle.to_radians() * part;
                light
                    .seen(position + 3.0 * Vec3::new(aside.sin(), -aside.cos(), 0.0))
                    .share
                    * 9.0
            };
            let inner = 1.0 - blend;
            assert!(
                (at(0.0) - 1.0).abs() < 1e-4,
                "{angle}, {blend}: {}",
                at(0.0)
            );
            assert!(
                (at(0.98 * inner) - 1.0).abs() < 0.05,
                "{angle}, {blend}: {}",
                at(0.98 * inner)
            );
            assert_eq!(at(1.01), 0.0, "{angle}, {blend}");
            let falls = (0..100).map(|i| at(i as f32 / 99.0)).collect::<Vec<_>>();
            assert!(
                falls.is_sorted_by(|a, b| a >= b || (a - b).abs() < 1e-3),
                "{falls:?}"
            );
        }
    }
}

fn object(mesh: Mesh, place: Affine3A) -> Object {
    Object {
        mesh,
        material: Material::diffuse([0.7; 3]),
        transform: place,
        ..Object::default()
    }
}

/// A knot, a box and a ball on the ground, which cast shadows on it and on each other and themselves.
fn scene(lights: Vec<PunctualLight>) -> Scene {
    let knot = Affine3A::from_translation(Vec3::new(-0.8, 1.0, 0.3));
    let turned =
        Affine3A::from_rotation_translation(Quat::from_rotation_y(0.5), Vec3::new(0.9, 0.5, -0.4));
    Scene {
        objects: vec![
            object(shapes::torus_knot(2, 3, 0.6, 0.25, 0.12), knot),
            object(shapes::rounded_box(Vec3::new(0.8, 1.0, 0.8), 0.05), turned),
            object(
                shapes::ball(0.35, 4),
                Affine3A::from_translation(Vec3::new(0.2, 0.35, 0.9)),
            ),
        ],
        environment: EnvironmentMap::constant([0.0; 3]),
        lights: Vec::new(),
        punctual: lights,
        ground: Some(Ground {
            height: 0.0,
            albedo: [0.5; 3],
        }),
        camera: Camera {
            eye: Vec3::new(1.0, 3.2, 5.0),
            target: Vec3::new(0.0, 0.6, 0.0),
            fov: 0.7,
        },
        settings: Settings::default(),
    }
}

/// What a camera sees, row by row, and in clusters. It sees the ground wherever it sees nothing else.
fn seen(scene: &Scene, [width, height]: [u32; 2]) -> (Vec<Receiver>, Vec<Range<usize>>) {
    let view = sh_scene::View {
        camera: scene.camera,
        width,
        height,
    };
    let geometry = Geometry::new(scene).unwrap();
    let [right, up, forward] = view.axes();
    let tall = (0.5 * scene.camera.fov).tan();
    let wide = tall * width as f32 / height as f32;
    let eye = Vec3A::from(scene.camera.eye);
    let mut receivers = Vec::new();
    for row in 0..height {
        for column in 0..width {
            let x = ((column as f32 + 0.5) / width as f32 * 2.0 - 1.0) * wide;
            let y = (1.0 - (row as f32 + 0.5) / height as f32 * 2.0) * tall;
            let ray: Vec3A = (forward + right * x + up * y).normalize().into();
            let hit = geometry.cast(eye, ray);
            let ground = -eye.y / ray.y;
            let (position, normal) = match hit.filter(|hit| hit.distance < ground || ground < 0.0) {
                Some(hit) => (hit.position, hit.normal),
                None => {
                    assert!(ground > 0.0, "the sky is in the picture");
                    let mut place = eye + ray * ground;
                    place.y = 0.0;
                    (place, Vec3A::Y)
                }
            };
            receivers.push(Receiver {
                position: position.into(),
                covered: 1,
                normal: normal.into(),
                object: 0,
            });
        }
    }
    let count = receivers.len();
    let clusters = (0..count).step_by(256).map(|i| i..(i + 256).min(count));
    let clusters = clusters.collect();
    (receivers, clusters)
}

/// Shadows of all kinds of lights, small and large, in pixels of two by two samples, in parts of the mean light, are those of paths.
#[test]
fn shadows_are_those_of_paths() {
    let high = Vec3::new(1.5, 4.0, 2.5);
    let low = Vec3::new(0.1, 2.2, 0.2);
    // Points stand near and low: their pictures are of 100 degrees, and most of what they light is edges.
    let cases = [
        ("sharp spot", spot(high, [60.0, 0.2, 0.0]), 8, 0.02),
        ("soft spot", spot(high, [60.0, 0.2, 0.2]), 64, 0.02),
        ("wide spot", spot(high, [140.0, 0.1, 0.1]), 64, 0.02),
        ("sharp point", point(low, 0.0), 8, 0.03),
        ("soft point", point(low, 0.1), 64, 0.035),
        ("sharp sun", sun(0.0), 8, 0.02),
        ("sun", sun(0.27), 64, 0.02),
        ("large sun", sun(5.0), 64, 0.02),
    ];
    for (what, light, paths, bound) in cases {
        let scene = scene(vec![light]);
        let size = [240, 180];
        let (receivers, clusters) = seen(&scene, size);
        let plan = Plan::of_receivers(&scene);
        let ours = Frames::default().light(&scene, &plan, &receivers, &clusters);
        let ours = ours.unwrap().radiance;
        let tracer = PathTracer::new(&scene, Options::default()).unwrap();
        let width = size[0] as usize;
        let mut pixels = vec![[0.0; 2]; receivers.len() / 4 + width];
        for (i, (receiver, ours)) in receivers.iter().zip(&ours).enumerate() {
            let [position, normal] = [receiver.position, receiver.normal].map(|v| v.map(f64::from));
            let truth = tracer.radiance(position, normal, paths, i as u32).direct[1];
            let pixel = &mut pixels[i / width / 2 * (width / 2) + i % width / 2];
            pixel[0] += 0.25 * f64::from(ours[1]);
            pixel[1] += 0.25 * truth;
        }
        let square: f64 = pixels.iter().map(|[a, b]| (a - b) * (a - b)).sum();
        let [sum, truth] = [0, 1].map(|k| pixels.iter().map(|pixel| pixel[k]).sum::<f64>());
        let count = receivers.len() as f64 / 4.0;
        // Where no path arrives there is no light, but beside edges.
        let leaks = pixels
            .iter()
            .filter(|[a, b]| *b == 0.0 && *a > 0.1 * truth / count);
        let leaks = leaks.count() as f64 / count;
        let (rms, bias) = ((square / count).sqrt() * count / truth, sum / truth - 1.0);
        println!(
            "{what}: {:.2} %, bias {:+.3} %, leaks {:.3} %",
            100.0 * rms,
            100.0 * bias,
            100.0 * leaks
        );
        assert!(
            rms < bound && bias.abs() < 0.005 && leaks < 0.002,
            "{what}: {rms} {bias} {leaks}"
        );
    }
}

fn light(frames: &mut Frames, scene: &Scene, receivers: &[Receiver]) -> [Vec<[f32; 3]>; 2] {
    let count = receivers.len();
    let clusters: Vec<_> = (0..count)
        .step_by(256)
        .map(|i| i..(i + 256).min(count))
        .collect();
    let plan = Plan::of_receivers(scene);
    let lit = frames.light(scene, &plan, receivers, &clusters).unwrap();
    [lit.radiance, lit.sent]
}

fn lit(scene: &Scene, receivers: &[Receiver]) -> Vec<[f32; 3]> {
    let [radiance, _] = light(&mut Frames::default(), scene, receivers);
    radiance
}

/// Whatever lights are like and wherever they are, what receivers get is a number, not below 0, and at most what they get where
/// nothing is in the way.
#[test]
fn lights_of_any_kind_are_bounded() {
    let at = |x: f32, y: f32, z: f32| Vec3::new(x, y, z);
    let ball = at(0.2, 0.35, 0.9);
    let far = PunctualLight::new(
        PunctualShape::Spot {
            position: at(1e4, 2e4, 1e4),
            towards: at(-1.0, -2.0, -1.0),
            angle: 0.01,
            blend: 0.0,
            radius: 50.0,
        },
        [1e9; 3],
    );
    let cases: [(&str, Vec<PunctualLight>); 13] = [
        ("within a ball", vec![point(ball, 0.0)]),
        ("around a ball", vec![point(ball, 1.0)]),
        ("on the ground", vec![point(Vec3::ZERO, 0.0)]),
        ("below the ground", vec![point(at(0.0, -1.0, 0.0), 0.1)]),
        ("on the surface", vec![point(at(0.2, 0.7, 0.9), 0.0)]),
        ("on a receiver", vec![point(at(0.0, 1e-9, 0.0), 0.0)]),
        ("narrow", vec![spot(at(1.5, 4.0, 2.5), [0.1, 0.0, 0.0])]),
        ("wide", vec![spot(at(1.5, 4.0, 2.5), [179.0, 1.0, 0.5])]),
        ("far", vec![far]),
        (
            "level sun",
            vec![PunctualLight::new(
                PunctualShape::Sun {
                    direction: Vec3::X,
                    angle: 0.7,
                },
                [1.0; 3],
            )],
        ),
        (
            "sun from below",
            vec![PunctualLight::new(
                PunctualShape::Sun {
                    direction: Vec3::NEG_Y,
                    angle: 0.0,
                },
                [1.0; 3],
            )],
        ),
        (
            "dark",
            vec![PunctualLight::new(
                PunctualShape::Point {
                    position: Vec3::Y,
                    radius: 0.0,
                },
                [0.0; 3],
            )],
        ),
        (
            "sixty-four",
            (0..64)
                .map(|i| point(at(i as f32 * 0.05 - 1.6, 2.0, 1.0), 0.05))
                .collect(),
        ),
    ];
    for (what, lights) in cases {
        let mut scene = scene(lights);
        // Triangles without an area are in the picture of nobody.
        let mesh = &mut scene.objects[1].mesh;
        mesh.triangles.push([0, 0, 1]);
        let (mut receivers, _) = seen(&scene, [64, 48]);
        receivers.push(Receiver {
            position: [f32::NAN, 0.0, 0.0],
            ..receivers[0]
        });
        receivers.push(Receiver {
            normal: [0.0; 3],
            ..receivers[0]
        });
        let shadowed = lit(&scene, &receivers);
        scene.settings.shadows = false;
        let open = lit(&scene, &receivers);
        for (i, (shadowed, open)) in shadowed.iter().zip(&open).enumerate() {
            for (a, b) in shadowed.iter().zip(open) {
                assert!(
                    a.is_finite() && *a >= 0.0 && *a <= 1.000_001 * b,
                    "{what}, {i}: {a} of {b}"
                );
            }
        }
        // What is nowhere sees no light that is somewhere.
        let nowhere = shadowed[64 * 48] == [0.0; 3];
        assert!(nowhere || what.contains("sun"), "{what}");
        let whole = |all: &[[f32; 3]]| all.iter().map(|c| f64::from(c[0])).sum::<f64>();
        let share = whole(&shadowed) / whole(&open).max(1e-9);
        match what {
            "within a ball" => {
                // Its inside is lit, and that nobody sees.
                assert!(share < 1e-3, "{what}: {share}");
            }
            "below the ground" | "sun from below" | "dark" => {
                assert_eq!(whole(&shadowed), 0.0, "{what}")
            }
            "far" | "wide" | "around a ball" => {
                assert!((0.3..1.0).contains(&share), "{what}: {share}")
            }
            _ => {}
        }
    }
}

/// Scenes of millimetres and of kilometres look alike, where intensities grow with the square.
#[test]
fn scenes_of_any_size_look_the_same() {
    let usual = scene(vec![
        spot(Vec3::new(1.5, 4.0, 2.5), [60.0, 0.2, 0.1]),
        sun(1.0),
    ]);
    let (receivers, _) = seen(&usual, [64, 48]);
    let expected = lit(&usual, &receivers);
    for size in [1e-2_f32, 1e3] {
        let mut scaled = usual.clone();
        for object in &mut scaled.objects {
            object.transform = Affine3A::from_scale(Vec3::splat(size)) * object.transform;
        }
        let PunctualShape::Spot {
            position, radius, ..
        } = &mut scaled.punctual[0].shape
        else {
            unreachable!();
        };
        (*position, *radius) = (*position * size, *radius * size);
        scaled.punctual[0].intensity = scaled.punctual[0].intensity.map(|c| c * size * size);
        let receivers: Vec<_> = receivers
            .iter()
            .map(|r| Receiver {
                position: r.position.map(|c| c * size),
                ..*r
            })
            .collect();
        let found = lit(&scaled, &receivers);
        let mean = expected.iter().map(|c| c[0]).sum::<f32>() / expected.len() as f32;
        let off = found
            .iter()
            .zip(&expected)
            .filter(|(a, b)| (a[0] - b[0]).abs() > 0.01 * mean);
        let off = off.count();
        assert!(
            off < expected.len() / 100,
            "{size}: {off} of {}",
            expected.len()
        );
    }
}

/// A frame has the same bits whatever came before it; a light that was switched off is gone, and what moves takes its shadow along,
/// whether it has spheres or not.
#[test]
fn a_frame_is_the_same_whatever_came_before_it() {
    let mut scene = scene(vec![
        spot(Vec3::new(1.5, 4.0, 2.5), [60.0, 0.2, 0.1]),
        sun(1.0),
    ]);
    let (receivers, _) = seen(&scene, [48, 36]);
    let mut frames = Frames::default();
    let mut before = Vec::new();
    for step in 0..6 {
        match step {
            1 => scene.objects[1].transform.translation.x += 0.3,
            2 => scene.punctual[0].intensity = [0.0; 3],
            3 => scene.punctual[1].intensity = [9.0; 3],
            4 => scene.ground = None,
            5 => scene.punctual.clear(),
            _ => {}
        }
        let [now, _] = light(&mut frames, &scene, &receivers);
        assert_eq!(now, lit(&scene, &receivers), "step {step}");
        let [again, _] = light(&mut frames, &scene, &receivers);
        assert_eq!(now, again, "step {step}, at rest");
        assert!(step == 4 || now != before, "step {step} changes nothing");
        before = now;
    }
    assert!(before.iter().all(|c| *c == [0.0; 3]));
}

/// Bodies send on what such a light gives them: a red ball in the sun makes the ground beside it red, and no more when it is in
/// the shadow of another body that has no spheres.
#[test]
fn bodies_send_it_on() {
    let mesh = shapes::ball(0.5, 3);
    let spheres = vec![sh_scene::Sphere {
        center: [0.0; 3],
        radius: 0.5,
    }];
    let material = Material::diffuse([0.9, 0.1, 0.1]);
    let mut scene = scene(vec![sun(0.5)]);
    scene.objects = vec![Object {
        surface: sh_bake::bake_surface(&[(&mesh, &material)], &spheres),
        spheres,
        material,
        ..object(mesh, Affine3A::from_translation(Vec3::Y * 0.55))
    }];
    scene.settings.indirect = Some(Default::default());
    let beside = Receiver {
        position: [0.45, 0.0, 0.3],
        covered: 1,
        normal: [0.0, 1.0, 0.0],
        object: 0,
    };
    let mut frames = Frames::default();
    let [_, sent] = light(&mut frames, &scene, &[beside]);
    let [red, green, _] = sent[0];
    assert!(
        red > 0.01 && (green / red - 1.0 / 9.0).abs() < 1e-3,
        "{sent:?}"
    );
    // At rest nothing of that is found again, with such a light and without.
    let once: Vec<_> = std::iter::once(0..1).collect();
    let found_again = |frames: &mut Frames, scene: &Scene| {
        let plan = Plan::of_receivers(scene);
        let lit = frames.light(scene, &plan, &[beside], &once).unwrap();
        lit.stages.iter().any(|(name, _)| *name == "light_update")
    };
    assert!(!found_again(&mut frames, &scene));
    let mut sky = scene.clone();
    sky.environment = EnvironmentMap::constant([1.0; 3]);
    sky.punctual.clear();
    let mut others = Frames::default();
    assert!(found_again(&mut others, &sky) && !found_again(&mut others, &sky));
    // A plate between the sun and the ball.
    let way = Vec3::new(1.0, 1.5, 0.7).normalize();
    let mut plate = object(shapes::panel([3.0; 2], [1; 2]), Affine3A::IDENTITY);
    plate.transform = Affine3A::from_rotation_translation(
        Quat::from_rotation_arc(Vec3::Z, way),
        Vec3::Y * 0.55 + 2.0 * way,
    );
    scene.objects.push(plate);
    let [_, sent] = light(&mut frames, &scene, &[beside]);
    assert!(sent[0][0] < 1e-3, "{sent:?}");
}
