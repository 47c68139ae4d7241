//! The shadow pass: its rounding, against its own text in f64; its edges and its bounds. Whether that text is the method's
//! formula, and near what rays see, is `tests/tests/shadow.rs`.

mod common;

use common::{Random, light_of, receiver};
use glam::{Vec3, vec3};
use sh_core::{Lane, OrderError, Routines, for_order};
use sh_cpu::{Cuts, Error, Outline, OutlineAll, Path, Point, irradiance, shade, shadow, shadow_on};
use sh_scene::{EnvironmentMap, Light, Receiver, Sphere};

/// A sky that is bright towards +X and blue below, of some order.
fn light(order: usize) -> Light {
    light_of(order, |d| {
        let sun = 20.0 * (4.0 * (d.dot(vec3(0.8, 0.6, 0.0)) - 1.0)).exp();
        [0.5 + sun, 0.5 + 0.8 * sun, 1.0 + 0.3 * sun - 0.4 * d.y]
    })
}

fn sphere(center: Vec3, radius: f32) -> Sphere {
    Sphere {
        center: center.into(),
        radius,
    }
}

/// Receivers and blockers scattered so that all cases of the self-shadow rule occur.
fn scattered(receivers: usize, blockers: usize) -> (Vec<Receiver>, Vec<Sphere>) {
    let mut random = Random(99);
    let spheres = (0..blockers).map(|_| {
        let center = random.point(3.0);
        sphere(center, random.within(0.05, 0.5))
    });
    let spheres: Vec<_> = spheres.collect();
    let receivers = (0..receivers).map(|i| {
        let mut r = receiver(random.point(3.0), random.direction());
        r.covered = u32::from(i % 11 != 3);
        r
    });
    (receivers.collect(), spheres)
}

/// The pass's text with f64 as its lane, one receiver at a time.
fn in_f64(receiver: &Receiver, spheres: &[Sphere], light: &Light, accumulation: usize) -> [f64; 3] {
    fn with<const C: usize>(
        r: &Receiver,
        spheres: &[Sphere],
        light: &Light,
        accumulation: usize,
    ) -> [f64; 3]
    where
        [f64; C]: Routines<f64>,
        f64: Outline<C> + OutlineAll,
    {
        let point = Point {
            position: r.position.map(f64::from),
            normal: r.normal.map(f64::from),
            object: f64::from(r.object),
            gloss: None,
        };
        let cuts = Cuts::everything(spheres, 1, light);
        shade::<f64, C>(
            &point,
            (&cuts, 0),
            light,
            accumulation,
            None::<fn(usize) -> f64>,
        )
    }
    for_order!(light.order, C => with::<C>(receiver, spheres, light, accumulation))
}

#[test]
fn every_path_rounds_to_what_f64_gives() {
    let (receivers, spheres) = scattered(300, 12);
    for (order, accumulation) in [(2, 2), (3, 3), (4, 4), (5, 5), (6, 6), (4, 6), (3, 5)] {
        let light = light(order);
        let expected: Vec<_> = receivers
            .iter()
            .map(|r| in_f64(r, &spheres, &light, accumulation))
            .collect();
        for path in Path::all() {
            let mut radiance = vec![[f32::NAN; 3]; receivers.len()];
            shadow_on(
                path,
                &receivers,
                &spheres,
                &light,
                accumulation,
                &mut radiance,
            )
            .unwrap();
            let mut worst = 0.0_f64;
            for ((r, expected), got) in receivers.iter().zip(&expected).zip(&radiance) {
                for (expected, &got) in expected.iter().zip(got) {
                    if r.covered == 0 {
                        assert_eq!(got, 0.0);
                    } else {
                        worst = worst.max((expected - f64::from(got)).abs());
                    }
                }
            }
            println!("order {order} of {accumulation}, {path:?}: {worst:.2e}");
            assert!(
                worst < 1e-5,
                "order {order} of {accumulation}, {path:?}: {worst}"
            );
        }
    }
}

/// The lower bands of a transfer of order 6 light the receiver, put together here from the routines alone.
#[test]
fn accumulation_above_the_order_uses_all_of_the_visibility() {
    let light = light(4);
    let r = receiver(Vec3::ZERO, vec3(0.2, 1.0, -0.1));
    // Wholly in front of the receiver, so that each counts as it is.
    let spheres = [
        sphere(vec3(0.9, 1.4, 0.2), 0.5),
        sphere(vec3(0.4, 1.9, 0.8), 0.7),
        sphere(vec3(-1.0, 2.0, -1.2), 0.6),
    ];
    let mut sum = [0.0_f64; 36];
    for sphere in &spheres {
        let center = sphere.center.map(f64::from);
        let distance = center.map(|x| x * x).iter().sum::<f64>().sqrt();
        let sine = f64::from(sphere.radius) / distance;
        let cosine = (1.0 - sine * sine).sqrt();
        let log = <[f64; 36]>::cap_log_shading(sine, cosine);
        let turned = <[f64; 36]>::zonal(log, center.map(|x| x / distance));
        sum.iter_mut().zip(turned).for_each(|(sum, t)| *sum += t);
    }
    let lit = sum.transfer(r.normal.map(f64::from));
    let expected: [f64; 3] = std::array::from_fn(|c| {
        let light = light.coefficients.iter().map(|l| f64::from(l[c]));
        lit.iter().zip(light).map(|(a, b)| a * b).sum()
    });
    let mut radiance = [[0.0; 3]; 3];
    for (accumulation, radiance) in [4, 5, 6].into_iter().zip(&mut radiance) {
        let slot = std::slice::from_mut(radiance);
        shadow(&[r], &spheres, &light, accumulation, slot).unwrap();
    }
    for (got, expected) in radiance[2].into_iter().zip(expected) {
        assert!(expected > 0.1 && (f64::from(got) - expected).abs() < 1e-5 * expected.max(1.0));
    }
    let difference = |a: [f32; 3], b: [f32; 3]| Lane::abs(a[0] - b[0]);
    assert!(difference(radiance[0], radiance[2]) > 1e-3, "{radiance:?}");
    assert!(difference(radiance[1], radiance[2]) > 1e-4, "{radiance:?}");
}

#[test]
fn radiance_lies_between_zero_and_the_unshadowed() {
    // Very many blockers: the log visibility is large, the series has to hold.
    let (receivers, spheres) = scattered(500, 400);
    for (order, accumulation) in (2..=6).flat_map(|n| [(n, n), (n, 6)]) {
        let light = light(order);
        let (mut open, mut shadowed) = (vec![[0.0; 3]; 500], vec![[0.0; 3]; 500]);
        irradiance(&receivers, &light, &mut open).unwrap();
        shadow(&receivers, &spheres, &light, accumulation, &mut shadowed).unwrap();
        for (open, shadowed) in open.iter().zip(&shadowed) {
            for (open, shadowed) in open.iter().zip(shadowed) {
                assert!(
                    (0.0..=*open).contains(shadowed),
                    "order {order}: {shadowed} of {open}"
                );
            }
        }
        // Without blockers nothing is lost but rounding.
        shadow(&receivers, &[], &light, accumulation, &mut shadowed).unwrap();
        for (open, shadowed) in open.iter().flatten().zip(shadowed.iter().flatten()) {
            assert!(
                (open - shadowed).abs() <= 1e-5 * open.max(1.0),
                "{open} {shadowed}"
            );
        }
    }
}

/// Radiance along a path of a receiver, in steps; the largest change between neighbours.
fn walk(order: usize, spheres: &[Sphere], steps: usize, at: impl Fn(f32) -> Receiver) -> f32 {
    let receivers: Vec<_> = (0..=steps).map(|i| at(i as f32 / steps as f32)).collect();
    let mut radiance = vec![[0.0; 3]; receivers.len()];
    shadow(&receivers, spheres, &light(order), order, &mut radiance).unwrap();
    let change = |pair: &[[f32; 3]]| (pair[1][0] - pair[0][0]).abs();
    radiance.windows(2).map(change).fold(0.0, f32::max)
}

#[test]
fn walking_across_a_sphere_changes_radiance_continuously() {
    let ball = [sphere(Vec3::ZERO, 1.0)];
    type Line = fn(f32) -> Receiver;
    let lines: [(&str, Line); 6] = [
        ("out along the tangent plane, centre in front", |t| {
            receiver(vec3(0.05 + 3.0 * t, -0.4, 0.1), Vec3::Y)
        }),
        ("out along the tangent plane, centre behind", |t| {
            receiver(vec3(0.05 + 3.0 * t, 0.4, 0.1), Vec3::Y)
        }),
        (
            "through, from wholly in front to wholly behind, inside the circle",
            |t| receiver(vec3(0.3, -1.5 + 3.0 * t, 0.2), Vec3::Y),
        ),
        ("through, beside the circle", |t| {
            receiver(vec3(1.4, -1.5 + 3.0 * t, 0.2), Vec3::Y)
        }),
        ("across at a slant, out through the side", |t| {
            receiver(vec3(-0.2 + 2.0 * t, -0.5 + t, 0.3), vec3(0.3, 1.0, -0.2))
        }),
        ("turning in place outside", |t| {
            let (sin, cos) = (6.0 * t).sin_cos();
            receiver(vec3(1.3, 0.2, 0.0), vec3(sin, cos, 0.2))
        }),
    ];
    for order in [2, 4, 6] {
        for (name, line) in lines {
            // A jump keeps its size when steps get finer; a slope's steps shrink with them, but not below
            // rounding. (That the log visibility itself does not jump is tested beside its text.)
            let coarse = walk(order, &ball, 1_000, line);
            let fine = walk(order, &ball, 16_000, line);
            // A sphere whose centre is behind the plane grazes the horizon, where light hardly counts.
            let grazes = name.ends_with("behind");
            assert!(
                order == 2 || grazes || coarse > 1e-6,
                "{name}: nothing happens"
            );
            assert!(
                fine < coarse / 4.0 + 2e-6,
                "order {order}, {name}: {coarse} then {fine}"
            );
            assert!(fine < 0.02, "order {order}, {name}: {fine} in one step");
        }
    }
}

#[test]
fn a_sphere_that_leaves_the_plane_keeps_its_shadow() {
    // At c = r the rule for cut spheres and that for whole ones meet.
    let mut radiance = [[0.0; 3]; 2];
    let around = [1.0 - 1e-4, 1.0 + 1e-4].map(|c| receiver(vec3(0.5, -c, 0.0), Vec3::Y));
    let ball = [sphere(Vec3::ZERO, 1.0)];
    shadow(&around, &ball, &light(4), 4, &mut radiance).unwrap();
    assert!(
        (radiance[0][0] - radiance[1][0]).abs() < 2e-3,
        "{radiance:?}"
    );
}

#[test]
fn a_sphere_darkens_what_is_under_it_and_nothing_in_front_of_it() {
    let even = Light::project(&EnvironmentMap::constant([1.0; 3]), None, 4, f32::INFINITY).unwrap();
    let ball = [sphere(vec3(0.0, 1.0, 0.0), 1.0)];
    let mut last = 0.0;
    for distance in [0.2, 0.5, 1.0, 2.0, 4.0, 16.0] {
        let mut radiance = [[0.0; 3]; 2];
        let r = receiver(vec3(distance, 0.0, 0.0), Vec3::Y);
        let away = receiver(vec3(distance, 0.0, 0.0), Vec3::NEG_Y);
        shadow(&[r, away], &ball, &even, 4, &mut radiance).unwrap();
        assert!(
            radiance[0][0] > last,
            "{distance} m: {radiance:?} after {last}"
        );
        last = radiance[0][0];
        // The plane of the opposite normal has the sphere behind it.
        assert!(
            (radiance[1][0] - 1.0).abs() < 1e-5,
            "{distance} m: {radiance:?}"
        );
    }
    assert!(last > 0.98);
}

#[test]
fn degenerate_blockers_and_places_give_finite_light() {
    let at = vec3(0.3, -0.2, 0.5);
    let r = receiver(at, vec3(0.1, 1.0, 0.3));
    let light = light(4);
    let shaded = |blocker: Sphere| {
        let mut radiance = [[f32::NAN; 3]];
        shadow(&[r], &[blocker], &light, 4, &mut radiance).unwrap();
        radiance[0]
    };
    let mut open = [[0.0; 3]];
    shadow(&[r], &[], &light, 4, &mut open).unwrap();
    // No extent: nothing is blocked, wherever it is.
    for center in [at, at + Vec3::Y, at - Vec3::Y, at + Vec3::X] {
        assert_eq!(shaded(sphere(center, 0.0)), open[0], "{center}");
    }
    // The receiver at the centre of a sphere, touching it from inside and outside, and far from everything.
    let n = Vec3::from(r.normal);
    for blocker in [
        sphere(at, 1.0),
        sphere(at + n, 1.0),
        sphere(at - n, 1.0),
        sphere(at + n * 1e-20, 1e-20),
        sphere(at + Vec3::X * 1e-7, 1.0),
        sphere(at + Vec3::splat(1e15), 1e3),
        sphere(at + Vec3::splat(1e8), 1e8),
        sphere(Vec3::ZERO, f32::MIN_POSITIVE),
    ] {
        for (got, open) in shaded(blocker).into_iter().zip(open[0]) {
            assert!(
                got >= 0.0 && got <= open.max(0.0) * 1.000_01,
                "{blocker:?}: {got} of {open}"
            );
        }
    }
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let (receivers, spheres) = scattered(5_000, 60);
    let light = light(4);
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        let mut radiance = vec![[0.0; 3]; receivers.len()];
        pool.install(|| shadow(&receivers, &spheres, &light, 6, &mut radiance))
            .unwrap();
        radiance
    };
    let one = on(1);
    for threads in [2, 3] {
        assert!(one == on(threads), "{threads} threads differ from one");
    }
}

#[test]
fn what_does_not_fit_is_refused() {
    let (receivers, spheres) = scattered(10, 2);
    let mut light = light(4);
    let mut short = [[0.0; 3]; 9];
    let error = shadow(&receivers, &spheres, &light, 4, &mut short).unwrap_err();
    assert_eq!(
        error.to_string(),
        "radiance has 9 entries for 10 samples: it needs one each"
    );
    let mut radiance = [[7.0; 3]; 10];
    for accumulation in [3, 7, 0, usize::MAX] {
        let refused = shadow(&receivers, &spheres, &light, accumulation, &mut radiance);
        assert_eq!(
            refused.unwrap_err().to_string(),
            format!(
                "logarithms of visibility for light of order 4 cannot be accumulated at order {accumulation}: orders 4 to 6 can"
            )
        );
    }
    light.coefficients.pop();
    let path = Path::best();
    let error = shadow_on(path, &receivers, &spheres, &light, 4, &mut radiance).unwrap_err();
    assert_eq!(
        error,
        Error::Coefficients {
            order: 4,
            found: 15
        }
    );
    light.order = 7;
    let error = shadow(&receivers, &spheres, &light, 7, &mut radiance).unwrap_err();
    assert_eq!(error, Error::Order(OrderError(7)));
    let error = irradiance(&receivers, &light, &mut radiance).unwrap_err();
    assert_eq!(error, Error::Order(OrderError(7)));
    assert_eq!(
        radiance, [[7.0; 3]; 10],
        "nothing is written before a refusal"
    );
}
