//! Analytic lights, against maps that show the same discs and against what is known of them.

mod common;

use common::receiver;
use glam::{Vec3, vec3};
use sh_cpu::{Path, irradiance_on, shadow};
use sh_scene::{AreaLight, AreaShape, EnvironmentMap, Light, Receiver, Sphere};

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

#[test]
fn a_distant_disc_is_what_a_map_of_it_gives() {
    let direction = vec3(0.5, 0.7, -0.4).normalize();
    let angle = 0.5_f32;
    let (width, height) = (1024, 512);
    let pixels = (0..width * height)
        .map(|i| {
            let (u, v) = ((i % width) as f32 + 0.5, (i / width) as f32 + 0.5);
            let d = EnvironmentMap::direction(u / width as f32, v / height as f32);
            if d.dot(direction) > angle.cos() {
                [2.0, 1.0, 0.5]
            } else {
                [0.0; 3]
            }
        })
        .collect();
    let map = EnvironmentMap {
        width: width as u32,
        height: height as u32,
        pixels,
    };
    let disc = AreaLight {
        shape: AreaShape::Distant {
            direction: direction * 3.0,
            angle,
        },
        radiance: [2.0, 1.0, 0.5],
        window: Some(f32::INFINITY),
    };
    for order in 2..=6 {
        let from_map = Light::project(&map, None, order, f32::INFINITY).unwrap();
        let receivers = around();
        for path in Path::all() {
            let (mut a, mut b) = (vec![[0.0; 3]; 60], vec![[0.0; 3]; 60]);
            irradiance_on(path, &receivers, &dark(order, &[disc]), &mut a).unwrap();
            irradiance_on(path, &receivers, &from_map, &mut b).unwrap();
            for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
                // The map's edge of whole texels.
                assert!((a - b).abs() < 2e-3, "order {order}, {path:?}: {a} {b}");
            }
        }
    }
}

#[test]
fn a_ball_is_a_disc_as_large_as_it_looks() {
    let center = vec3(1.0, 3.0, -2.0);
    let ball = AreaLight {
        shape: AreaShape::Local {
            center,
            radius: 0.7,
        },
        radiance: [1.0; 3],
        window: None,
    };
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
    let light = dark(
        4,
        &[AreaLight {
            shape: AreaShape::Local {
                center: Vec3::ZERO,
                radius,
            },
            radiance: [1.0; 3],
            window: None,
        }],
    );
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
    let left = AreaLight {
        shape: AreaShape::Distant {
            direction: vec3(-1.0, 1.0, 0.0),
            angle: 0.2,
        },
        radiance: [1.0, 0.0, 0.0],
        window: None,
    };
    let right = AreaLight {
        shape: AreaShape::Local {
            center: vec3(4.0, 4.0, 0.0),
            radius: 0.8,
        },
        radiance: [0.0, 1.0, 0.0],
        window: None,
    };
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
        shape,
        radiance: [radiance; 3],
        window,
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
}
