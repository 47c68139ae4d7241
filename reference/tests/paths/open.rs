//! Light without bodies.

use super::{DOWN, UP, assert_near, bounces, dark, even, ground, lamp, projected, scene, trace};
use glam::{DVec3, Vec3};
use sh_reference::basis::basis;
use sh_reference::paths::Options;
use sh_reference::quadrature::Rule;
use sh_reference::zonal::cosine;
use sh_reference::{ball, horizon};
use sh_scene::{AreaLight, AreaShape, Distribution, Sky};
use std::f64::consts::PI;

const TILTED: [f64; 3] = [0.6, 0.64, -0.48];

/// An even sky over nothing gives its radiance, whichever way a receiver looks.
#[test]
fn an_even_sky_over_nothing_is_one() {
    for normal in [UP, DOWN, TILTED] {
        for options in [bounces(0), bounces(3), projected()] {
            let seen = trace(&even(), options, [3.0, 1.0, -2.0], normal);
            // Lights are given in single precision.
            assert_near(seen.direct, seen.direct_error, [1.0; 3], 1e-7, 2e-3);
            assert_eq!(seen.indirect, [0.0; 3]);
        }
    }
}

/// A sky with a sun: the irradiance of its upper half, which the map sums up texel by texel.
#[test]
fn a_sun_is_found() {
    let mut sky = scene(Sky::default().map(128, 64));
    sky.ground = ground(0.5);
    let up = sky.environment.upper_irradiance();
    let seen = trace(&sky, bounces(0), [0.0; 3], UP);
    assert_near(seen.direct, seen.direct_error, up, 0.0, 3e-3);
    // From below comes what the open ground shows.
    let below = trace(&sky, bounces(0), [0.0, 1.0, 0.0], DOWN);
    let expected = up.map(|c| 0.5 * c);
    assert_near(below.direct, [1.0; 3], expected, 0.0, 1e-6);
}

/// Maps whose horizon runs through a row, or that are black, or of one texel.
#[test]
fn odd_maps_are_sampled_evenly() {
    for height in [1, 3, 5] {
        let mut sky = scene(sh_scene::EnvironmentMap {
            width: 3,
            height,
            pixels: (0..3 * height)
                .map(|i| [(i % 4) as f32, 1.0, 0.0])
                .collect(),
        });
        sky.ground = ground(0.0);
        let seen = trace(&sky, bounces(0), [0.0; 3], UP);
        let up = sky.environment.upper_irradiance();
        assert_near(seen.direct, seen.direct_error, up, 0.0, 5e-3);
    }
    let none = trace(&dark(), bounces(2), [0.0; 3], UP);
    assert_eq!(none.total(), [0.0; 3]);
}

/// A disc of angular radius a, at an angle b from the normal and wholly above the surface: L sin² a cos b.
#[test]
fn a_disc_in_the_sky() {
    for (angle, tilt) in [(0.01_f32, 0.0_f32), (0.2, 0.7), (0.5, 1.0), (0.1, 1.4)] {
        let mut sky = dark();
        let direction = Vec3::new(tilt.sin(), tilt.cos(), 0.0) * 3.0;
        sky.lights = vec![lamp(
            AreaShape::Distant { direction, angle },
            [8.0, 4.0, 1.0],
        )];
        let (angle, tilt) = (f64::from(angle), f64::from(tilt));
        let share = angle.sin().powi(2) * tilt.cos();
        let expected = [8.0 * share, 4.0 * share, share];
        let seen = trace(&sky, bounces(0), [0.0; 3], UP);
        assert_near(seen.direct, seen.direct_error, expected, 1e-6, 1e-3 * share);
    }
    // Half a sky, seen from its middle: everything above.
    let mut sky = dark();
    let (direction, angle) = (Vec3::Y, std::f32::consts::FRAC_PI_2);
    sky.lights = vec![lamp(AreaShape::Distant { direction, angle }, [1.0; 3])];
    let seen = trace(&sky, bounces(0), [0.0; 3], UP);
    assert_near(seen.direct, seen.direct_error, [1.0; 3], 1e-6, 1e-3);
}

/// A ball of radius r at height h over a plane, at a distance d: L (r/d)² h/d. Inside a ball: L.
#[test]
fn a_ball_light_over_a_plane() {
    for (aside, height, radius) in [
        (0.0_f32, 2.0_f32, 0.5_f32),
        (3.0, 1.0, 0.9),
        (0.4, 0.5, 0.01),
    ] {
        let mut room = dark();
        let center = Vec3::new(aside, height, 0.0);
        room.lights = vec![lamp(AreaShape::Local { center, radius }, [2.0; 3])];
        let distance = f64::from(aside).hypot(f64::from(height));
        let share = (f64::from(radius) / distance).powi(2) * f64::from(height) / distance;
        let seen = trace(&room, bounces(0), [0.0; 3], UP);
        // Where rays start is 1e-8 m above the plane.
        assert_near(
            seen.direct,
            seen.direct_error,
            [2.0 * share; 3],
            1e-6,
            1e-3 * share,
        );
    }
    let mut inside = dark();
    let shape = AreaShape::Local {
        center: Vec3::new(0.1, 0.2, 0.0),
        radius: 1.0,
    };
    inside.lights = vec![lamp(shape, [2.0; 3])];
    let seen = trace(&inside, bounces(0), [0.0; 3], UP);
    assert_near(seen.direct, seen.direct_error, [2.0; 3], 0.0, 4e-3);
}

/// The SH light gives L·H(N), not below 0, and every lamp what its disc does, cut by the horizon.
#[test]
fn projected_light_is_what_the_passes_have() {
    let mut sky = scene(Sky::default().map(64, 32));
    sky.ground = ground(0.3);
    sky.lights = vec![
        lamp(
            AreaShape::Distant {
                direction: Vec3::new(1.0, 2.0, 0.5),
                angle: 0.1,
            },
            [20.0, 10.0, 5.0],
        ),
        lamp(
            AreaShape::Local {
                center: Vec3::new(-1.0, 2.0, 0.0),
                radius: 0.4,
            },
            [3.0, 6.0, 9.0],
        ),
    ];
    let light = sky.light().expect("a light");
    let order = light.order;
    let point = [0.0, 0.5, 0.0];
    for normal in [UP, TILTED, DOWN] {
        let lobe = cosine(order, normal);
        let against = |f: &[f64]| f.iter().zip(&lobe).map(|(a, b)| a * b).sum::<f64>();
        let mut expected = [0.0; 3];
        for c in 0..3 {
            let channel: Vec<f64> = light.coefficients.iter().map(|k| f64::from(k[c])).collect();
            expected[c] = against(&channel);
            for emitter in &light.emitters {
                let center = DVec3::from(emitter.center.map(f64::from));
                let towards = center - f64::from(emitter.local) * DVec3::from(point);
                let radius = f64::from(emitter.radius);
                let height = towards.dot(normal.into());
                let shown = horizon::share(height / radius, towards.length() / radius);
                expected[c] += f64::from(emitter.radiance[c]) * shown;
            }
        }
        let expected = expected.map(|c| c.max(0.0));
        let seen = trace(&sky, projected(), point, normal);
        assert_near(seen.direct, seen.direct_error, expected, 1e-6, 1e-2);
    }
}

/// The ground hides lamps and suns below it.
#[test]
fn nothing_shines_through_the_ground() {
    let mut sky = dark();
    sky.ground = ground(0.5);
    let (direction, angle) = (Vec3::new(0.3, -1.0, 0.0), 0.1);
    let (center, radius) = (Vec3::new(0.0, -2.0, 0.0), 1.0);
    sky.lights = vec![
        lamp(AreaShape::Distant { direction, angle }, [50.0; 3]),
        lamp(AreaShape::Local { center, radius }, [50.0; 3]),
    ];
    for ground_reflects in [false, true] {
        let options = Options {
            ground_reflects,
            ..bounces(2)
        };
        assert_eq!(
            trace(&sky, options, [0.0, 1.0, 0.0], DOWN).total(),
            [0.0; 3]
        );
    }
    sky.ground = None;
    assert!(trace(&sky, bounces(0), [0.0, 1.0, 0.0], DOWN).direct[0] > 1.0);
}

/// A ball that glows on one side, asked ray by ray over its disc: the tracer finds the same, and so does a projected lamp
/// whose mean radiance counts over the whole of its disc.
#[test]
fn a_ball_light_with_a_bright_side() {
    let (center, radius) = (Vec3::new(0.6, 1.5, -0.2), 0.8_f32);
    let coefficients: Vec<[f32; 3]> = (0..16)
        .map(|i| {
            let l = (i as f32).sqrt().floor();
            let at = |k: f32| (1.7 * i as f32 + k).sin() * 0.2 / (l + 1.0);
            [at(0.0), at(1.0), at(2.0)].map(|c| if i == 0 { 3.0 + c } else { c })
        })
        .collect();
    let distribution = Distribution::new(&coefficients).expect("order 4");
    let mut room = dark();
    room.lights = vec![AreaLight {
        distribution: Some(distribution),
        ..AreaLight::local(center, radius, [2.0, 1.0, 0.5])
    }];
    // Where rays start is 1e-8 m above the plane.
    let point = [0.0; 3];
    let towards = [center.x, center.y, center.z].map(f64::from);
    let far = towards.iter().map(|t| t * t).sum::<f64>().sqrt();
    let (axis, sine) = (towards.map(|t| t / far), f64::from(radius) / far);
    let rule = Rule::zone(axis, (1.0 - sine * sine).sqrt(), 1.0, 300);
    let mut expected = [0.0; 3];
    for (ray, weight) in rule.nodes() {
        let along: f64 = (0..3).map(|k| ray[k] * towards[k]).sum();
        let near = along
            - (along * along - far * far + f64::from(radius).powi(2))
                .max(0.0)
                .sqrt();
        let surface = [0, 1, 2].map(|k| (near * ray[k] - towards[k]) / f64::from(radius));
        let basis = basis(4, surface);
        for c in 0..3 {
            let shown: f64 = (0..16)
                .map(|i| basis[i] * f64::from(coefficients[i][c]))
                .sum();
            let radiance = [2.0, 1.0, 0.5][c] * shown;
            expected[c] += weight * radiance * ray[1].max(0.0) / PI;
        }
    }
    let seen = trace(&room, bounces(0), point, UP);
    assert_near(seen.direct, seen.direct_error, expected, 1e-6, 1e-2);
    // What a projected lamp has is one radiance for all of its disc: the mean.
    let mut even = room.clone();
    let light = room.lights[0];
    let average = ball::means(4, sine);
    let weights = basis(4, axis.map(|a| -a));
    let mean = [0, 1, 2].map(|c| {
        let terms =
            (0..16).map(|i: usize| average[i.isqrt()] * weights[i] * f64::from(coefficients[i][c]));
        (terms.sum::<f64>() * f64::from(light.radiance[c])) as f32
    });
    even.lights = vec![AreaLight::local(center, radius, mean)];
    let seen = trace(&room, projected(), point, UP);
    let same = trace(&even, projected(), point, UP);
    for c in 0..3 {
        let (a, b) = (seen.direct[c], same.direct[c]);
        assert!((a / b - 1.0).abs() < 1e-3, "{a} {b}");
    }
}
