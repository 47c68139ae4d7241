//! Analytic lights, against maps that show the same discs and against what is known of them.

mod common;

use common::receiver;
use glam::{Vec3, vec3};
use sh_core::Routines;
use sh_cpu::{CutOptions, Cuts, Path, Shadow, irradiance_on, shadow, shadow_clusters};
use sh_scene::{
    AreaLight, AreaShape, Distribution, EnvironmentMap, Forest, Light, Limits, Receiver, Sphere,
};

/// No environment, and these lights.
fn dark(order: usize, lights: &[AreaLight]) -> Light {
    Light::project(
        &EnvironmentMap::constant([0.0; 3]),
        None,
        order,
        f32::INFINITY,
    )
    .unwrap()
    .with_lights(lights)
    .unwrap()
}

fn around() -> Vec<Receiver> {
    (0..60)
        .map(|i| {
            let t = i as f32;
            let n = vec3((1.3 * t).sin(), (0.7 * t).cos(), (2.1 * t).sin());
            receiver(Vec3::ZERO, n)
        })
        .collect()
}

/// Open ground under a disc is as bright as it is, at every order and under any window: what is above the horizon of an
/// even disc, weighted by the cosine. An SH vector of order 3 with a window gave 0.45 of it.
#[test]
fn open_ground_gets_all_of_a_disc_at_every_order() {
    let direction = vec3(0.5, 0.7, -0.4).normalize();
    let angle = 0.5_f32;
    // Directions of the disc, each with the same solid angle.
    let rays: Vec<Vec3> = (0..20_000)
        .map(|i| {
            let height = 1.0 - (i as f32 + 0.5) / 20_000.0 * (1.0 - angle.cos());
            let (sin, cos) = (i as f32 * 2.399_963_2 % std::f32::consts::TAU).sin_cos();
            let x = direction.any_orthonormal_vector();
            let flat = (1.0 - height * height).sqrt();
            direction * height + (x * cos + direction.cross(x) * sin) * flat
        })
        .collect();
    let each = 2.0 * (1.0 - angle.cos()) / rays.len() as f32;
    let truth = |normal: Vec3| {
        rays.iter()
            .map(|d| d.dot(normal).max(0.0) * each)
            .sum::<f32>()
    };
    for (order, window) in (2..=6).flat_map(|n| [(n, None), (n, Some(2.0)), (n, Some(1e6))]) {
        let disc = AreaLight {
            window,
            ..AreaLight::distant(direction * 3.0, angle, [2.0, 1.0, 0.5])
        };
        let receivers = around();
        for path in Path::all() {
            let mut found = vec![[0.0; 3]; 60];
            irradiance_on(path, &receivers, &dark(order, &[disc]), &mut found).unwrap();
            for (r, found) in receivers.iter().zip(found) {
                let normal = Vec3::from(r.normal);
                let facing = normal.dot(direction);
                let expected = truth(normal);
                // Exact where the horizon leaves it whole, and nearly so where it cuts it.
                let permitted = if facing.abs() > angle.sin() {
                    2e-4
                } else {
                    0.02
                };
                for (found, color) in found.iter().zip([2.0, 1.0, 0.5]) {
                    let off = (found / color - expected).abs();
                    assert!(
                        off < permitted,
                        "order {order}, {path:?}, {facing}: {found} {expected}"
                    );
                }
                assert!(facing > -angle.sin() || found == [0.0; 3]);
            }
        }
    }
}

#[test]
fn a_ball_is_a_disc_as_large_as_it_looks() {
    let center = vec3(1.0, 3.0, -2.0);
    let ball = AreaLight::local(center, 0.7, [1.0; 3]);
    for p in [Vec3::ZERO, vec3(0.5, 1.0, 0.3), vec3(-20.0, 0.0, 7.0)] {
        let disc = AreaLight {
            shape: AreaShape::Distant {
                direction: center - p,
                angle: (0.7 / center.distance(p)).asin(),
            },
            ..ball
        };
        let r = [receiver(p, vec3(0.2, 1.0, 0.1))];
        let (mut a, mut b) = ([[0.0; 3]], [[0.0; 3]]);
        sh_cpu::irradiance(&r, &dark(4, &[ball]), &mut a).unwrap();
        sh_cpu::irradiance(&r, &dark(4, &[disc]), &mut b).unwrap();
        assert!((a[0][0] / b[0][0] - 1.0).abs() < 1e-4, "{p}: {a:?} {b:?}");
    }
}

/// Irradiance of a small ball falls with the square of the distance, without noise from rounding.
#[test]
fn small_lights_keep_their_precision() {
    let radius = 1e-3;
    let light = dark(4, &[AreaLight::local(Vec3::ZERO, radius, [1.0; 3])]);
    let at = |distance: f32| {
        let mut radiance = [[0.0; 3]];
        let r = [receiver(vec3(0.0, -distance, 0.0), Vec3::Y)];
        sh_cpu::irradiance(&r, &light, &mut radiance).unwrap();
        radiance[0][0] * distance * distance / (radius * radius)
    };
    let near = at(0.1);
    assert!(near > 0.5 && near < 1.2, "{near}");
    for i in 1..400 {
        let value = at(0.1 * 1.02_f32.powi(i));
        assert!((value / near - 1.0).abs() < 2e-4, "{i}: {value} {near}");
    }
}

#[test]
fn blockers_shade_each_light_apart() {
    let left = AreaLight::distant(vec3(-1.0, 1.0, 0.0), 0.2, [1.0, 0.0, 0.0]);
    let right = AreaLight::local(vec3(4.0, 4.0, 0.0), 0.8, [0.0, 1.0, 0.0]);
    let light = dark(4, &[left, right]);
    let r = [receiver(Vec3::ZERO, Vec3::Y)];
    let shaded = |spheres: &[Sphere]| {
        let mut radiance = [[0.0; 3]];
        shadow(&r, spheres, &light, 4, &mut radiance).unwrap();
        radiance[0]
    };
    let at = |x: f32, y: f32| Sphere {
        center: [x, y, 0.0],
        radius: 0.9,
    };
    let open = shaded(&[]);
    let [without_left, without_right] = [shaded(&[at(-1.2, 1.2)]), shaded(&[at(1.2, 1.2)])];
    assert!(
        without_left[0] < 0.5 * open[0] && without_left[1] > 0.9 * open[1],
        "{without_left:?} {open:?}"
    );
    assert!(
        without_right[1] < 0.5 * open[1] && without_right[0] > 0.9 * open[0],
        "{without_right:?}"
    );
    assert_eq!(open[2], 0.0);
    // In the middle of a lamp, and a receiver that faces away.
    let mut radiance = [[f32::NAN; 3]; 2];
    let odd = [
        receiver(vec3(4.0, 4.0, 0.0), Vec3::Y),
        receiver(Vec3::ZERO, Vec3::NEG_Y),
    ];
    sh_cpu::irradiance(&odd, &light, &mut radiance).unwrap();
    assert!(
        radiance
            .iter()
            .flatten()
            .all(|c| c.is_finite() && *c >= 0.0),
        "{radiance:?}"
    );
    assert!(radiance[1][0] < 0.05 * open[0]);
}

#[test]
fn what_is_no_light_is_refused() {
    let good = AreaShape::Distant {
        direction: Vec3::Y,
        angle: 0.1,
    };
    let light = |shape, radiance: f32, window| AreaLight {
        window,
        ..AreaLight::of(shape, [radiance; 3])
    };
    let far = |direction, angle| AreaShape::Distant { direction, angle };
    let near = |x, radius| AreaShape::Local {
        center: vec3(x, 0.0, 0.0),
        radius,
    };
    assert!(light(good, 1.0, None).emitter(4).is_ok());
    for bad in [
        light(good, -1.0, None),
        light(good, f32::NAN, None),
        light(good, 1.0, Some(0.0)),
        light(good, 1.0, Some(f32::NAN)),
        light(far(Vec3::ZERO, 0.1), 1.0, None),
        light(far(Vec3::Y, 0.0), 1.0, None),
        light(far(Vec3::Y, 2.0), 1.0, None),
        light(near(0.0, 0.0), 1.0, None),
        light(near(f32::INFINITY, 1.0), 1.0, None),
    ] {
        assert!(bad.emitter(4).is_err(), "{bad:?}");
    }
    let bound = AreaLight {
        object: Some(0),
        ..light(near(0.0, 1.0), 1.0, None)
    };
    assert!(bound.emitter(4).is_err() && bound.placed(&[]).is_err());
}

/// A ball that glows below, and everywhere a little: what each receiver gets is what an even ball gives it times the mean
/// of what it sees, in double precision.
#[test]
fn a_ball_is_as_bright_as_the_side_that_it_shows() {
    fn check<const C: usize>(lamp: &AreaLight, even: &AreaLight, receivers: &[Receiver])
    where
        [f64; C]: Routines<f64>,
    {
        let order = C.isqrt();
        let own = lamp.distribution.unwrap();
        let AreaShape::Local { center, radius } = lamp.shape else {
            panic!("a ball");
        };
        for path in Path::all() {
            let mut found = vec![[0.0; 3]; receivers.len()];
            let mut open = found.clone();
            irradiance_on(path, receivers, &dark(order, &[*lamp]), &mut found).unwrap();
            irradiance_on(path, receivers, &dark(order, &[*even]), &mut open).unwrap();
            for (r, (found, open)) in receivers.iter().zip(found.iter().zip(&open)) {
                let back = (Vec3::from(r.position) - center).as_dvec3();
                let sine = (f64::from(radius) / back.length()).min(1.0);
                let cosine = (1.0 - sine * sine).sqrt();
                let weights = <[f64; C]>::ball_average(sine, cosine, back.normalize().to_array());
                for c in 0..3 {
                    let terms = weights.iter().zip(own.coefficients());
                    let mean: f64 = terms.map(|(w, k)| w * f64::from(k[c])).sum();
                    let expected = f64::from(open[c]) * mean.max(0.0);
                    let error = (f64::from(found[c]) - expected).abs();
                    assert!(
                        error < 2e-6 * f64::from(open[c]).max(1e-3),
                        "{path:?}, order {order}: {found:?}, {expected}"
                    );
                }
            }
        }
    }
    let even = AreaLight::local(vec3(0.3, 2.0, -0.4), 0.5, [3.0, 2.0, 1.0]);
    let below = Distribution::cap(vec3(0.2, -1.0, 0.1), 1.2).unwrap();
    let mut coefficients = *below.coefficients();
    coefficients[0][2] += 0.5;
    coefficients[1][1] *= 0.5;
    let lamp = AreaLight {
        distribution: Some(Distribution::new(&coefficients).unwrap()),
        ..even
    };
    // All around it, near and far, one of them inside.
    let receivers: Vec<Receiver> = (0..40)
        .map(|i| {
            let t = i as f32;
            let away = vec3((1.3 * t).sin(), (0.7 * t).cos(), (2.1 * t).sin()).normalize();
            let distance = if i == 7 { 0.2 } else { 0.51 + 0.1 * t };
            let center = vec3(0.3, 2.0, -0.4);
            receiver(center + away * distance, vec3(0.1, 0.2, 0.3) - away)
        })
        .collect();
    check::<4>(&lamp, &even, &receivers);
    check::<9>(&lamp, &even, &receivers);
    check::<16>(&lamp, &even, &receivers);
    check::<25>(&lamp, &even, &receivers);
    check::<36>(&lamp, &even, &receivers);
    // It gives ten times as much below it as above.
    let at = |y: f32, n: f32| {
        let mut radiance = [[0.0; 3]];
        let r = [receiver(vec3(0.3, y, -0.4), vec3(0.0, n, 0.0))];
        sh_cpu::irradiance(&r, &dark(4, &[lamp]), &mut radiance).unwrap();
        radiance[0][0]
    };
    assert!(at(0.0, 1.0) > 10.0 * at(4.0, -1.0));
}

/// A distribution that says "everywhere alike" changes nothing, and one below 0 gives nothing.
#[test]
fn even_and_negative_distributions() {
    let even = AreaLight::local(vec3(0.0, 2.0, 0.0), 0.5, [3.0, 2.0, 1.0]);
    let with = |mean: f32| AreaLight {
        distribution: Some(Distribution::new(&[[mean * 12.566_371_f32.sqrt(); 3]]).unwrap()),
        ..even
    };
    let at = |lamp: AreaLight| {
        let mut radiance = [[0.0; 3]; 60];
        sh_cpu::irradiance(&around(), &dark(4, &[lamp]), &mut radiance).unwrap();
        radiance
    };
    for (a, b) in at(even)
        .iter()
        .flatten()
        .zip(at(with(1.0)).iter().flatten())
    {
        assert!((a - b).abs() <= 1e-6 * a, "{a} {b}");
    }
    assert!(at(with(-1.0)).iter().flatten().all(|c| *c == 0.0));
    // Only a ball has one.
    let disc = AreaLight {
        distribution: with(1.0).distribution,
        ..AreaLight::distant(Vec3::Y, 0.1, [1.0; 3])
    };
    assert!(disc.emitter(4).is_err());
}

/// What a receiver at the origin that faces up gets of a lamp above it, over what it gets in the open: with every sphere
/// by itself, and by a cut of a tree for a cluster about it.
fn share(lamp: AreaLight, spheres: &[Sphere]) -> [f32; 2] {
    let light = dark(4, &[lamp]);
    let r: Vec<Receiver> = (0..9)
        .map(|i| {
            receiver(
                vec3((i % 3) as f32 - 1.0, 0.0, (i / 3) as f32 - 1.0) * 0.1,
                Vec3::Y,
            )
        })
        .collect();
    let (mut open, mut all, mut cut) = (vec![[0.0; 3]; 9], vec![[0.0; 3]; 9], vec![[0.0; 3]; 9]);
    sh_cpu::irradiance(&r, &light, &mut open).unwrap();
    shadow(&r, spheres, &light, 4, &mut all).unwrap();
    let forest = Forest::new(spheres, &[spheres.len()]);
    let everyone = 0..r.len();
    let clusters = std::slice::from_ref(&everyone);
    let mut cuts = Cuts::default();
    cuts.bound(&r, clusters, 0..1);
    let options = CutOptions {
        limits: Limits::default(),
        ratios: true,
        accumulation: 4,
    };
    cuts.dim(&light);
    cuts.find(Path::best(), &forest, &light, options);
    let shadow = Shadow {
        clusters,
        cuts: &cuts,
        light: &light,
        accumulation: 4,
        baked: None,
        eye: None,
    };
    shadow_clusters(Path::best(), &r, &shadow, &mut cut).unwrap();
    [all[4][0] / open[4][0], cut[4][0] / open[4][0]]
}

/// A sphere over a lamp takes nothing of its light from a receiver below, one under it does.
#[test]
fn a_lamp_is_hidden_by_what_is_before_it() {
    let lamp = AreaLight::local(Vec3::Y * 2.0, 0.1, [1.0; 3]);
    let ball = |x: f32, y: f32, radius: f32| Sphere {
        center: [x, y, 0.0],
        radius,
    };
    for (spheres, low, high) in [
        (vec![ball(0.0, 4.0, 1.0)], 0.999, 1.001),
        (vec![ball(0.0, 40.0, 30.0)], 0.999, 1.001),
        (vec![ball(0.0, 1.0, 0.7)], 0.0, 0.3),
        (vec![ball(0.0, 4.0, 1.0), ball(0.0, 1.0, 0.7)], 0.0, 0.3),
        // Around the lamp, wholly and in part.
        (vec![ball(0.0, 2.1, 0.5)], 0.999, 1.001),
        (vec![ball(0.0, 2.5, 0.5)], 0.7, 1.0),
    ] {
        for share in share(lamp, &spheres) {
            assert!((low..=high).contains(&share), "{spheres:?}: {share}");
        }
    }
    // A body of many spheres that is far off, as one node of the tree, behind the lamp, around it and before it.
    for (height, low, high) in [(9.0, 0.98, 1.001), (2.0, 0.5, 1.0), (1.0, 0.0, 0.45)] {
        let spheres: Vec<Sphere> = (0..40)
            .map(|i| {
                let (sin, cos) = (2.4 * i as f32).sin_cos();
                let away = 0.06 * (i as f32).sqrt();
                ball(away * cos, height + away * sin, 0.1)
            })
            .collect();
        let [all, cut] = share(lamp, &spheres);
        assert!((low..=high).contains(&all), "{height}: {all}");
        assert!((all - cut).abs() < 0.02, "{height}: {all} {cut}");
    }
}

/// A sphere that is taken up past a lamp, in its way or beside it, changes nothing at once, and neither does a lamp that
/// comes out of a sphere.
#[test]
fn nothing_jumps_where_a_sphere_goes_behind_a_lamp() {
    let lamp = AreaLight::local(Vec3::Y * 2.0, 0.1, [1.0; 3]);
    for aside in [0.0_f32, 0.3, 0.9, 2.0] {
        let largest = |steps: usize| {
            let at = |i: usize| {
                let center = [aside, 0.6 + 4.0 * i as f32 / steps as f32, 0.2];
                share(
                    lamp,
                    &[Sphere {
                        center,
                        radius: 0.4,
                    }],
                )
            };
            let all: Vec<[f32; 2]> = (0..=steps).map(at).collect();
            let change = |w: &[[f32; 2]]| (w[1][0] - w[0][0]).abs().max((w[1][1] - w[0][1]).abs());
            all.windows(2).map(change).fold(0.0, f32::max)
        };
        let (coarse, fine) = (largest(200), largest(3200));
        println!("{aside} aside: {coarse} {fine}");
        assert!(fine < coarse / 6.0 + 1e-4, "{aside}: {coarse} {fine}");
    }
}
