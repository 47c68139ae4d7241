//! The ground: as the light has it, and as it really is.

use super::{DOWN, UP, assert_near, bounces, even, flatness, ground, object, scene, trace};
use glam::Vec3;
use sh_bake::shapes;
use sh_reference::paths::{Options, Source};
use sh_reference::quadrature::gauss_legendre;
use sh_scene::Sky;

fn reflecting(count: u32) -> Options {
    Options {
        ground_reflects: true,
        ..bounces(count)
    }
}

/// Without bodies, what the ground reflects is what the light has from below.
#[test]
fn the_open_ground_is_the_same_both_ways() {
    let mut sky = scene(Sky::default().map(64, 32));
    sky.ground = ground(0.4);
    for normal in [DOWN, [0.8, -0.6, 0.0]] {
        let still = trace(&sky, bounces(0), [0.0, 1.0, 0.0], normal);
        let real = trace(&sky, reflecting(0), [0.0, 1.0, 0.0], normal);
        assert_near(real.direct, real.direct_error, still.direct, 5e-3, 2e-2);
        assert_eq!(real.indirect, [0.0; 3]);
    }
}

/// A black ball of radius r, its centre at height d over a ground of albedo a, even sky. The ground at a distance ρ from
/// the foot lacks r² d/(ρ² + d²)^{3/2} of its light; a receiver under the ball at height h that looks down sees it by
/// 2ρh²/(ρ² + h²)² dρ. With ρ = h √(t/(1 − t)) that weight is even in t from 0 to 1.
#[test]
fn the_shadow_of_a_ball_lights_it_less_from_below() {
    let ball = shapes::ball(1.0, 6);
    let depth = flatness(&ball);
    let (d, h, albedo) = (1.5_f64, 0.4_f64, 0.5_f32);
    let lost: f64 = gauss_legendre(60, 0.0, 1.0)
        .into_iter()
        .map(|(t, weight)| {
            let rho_2 = h * h * t / (1.0 - t);
            weight * d / (rho_2 + d * d).powf(1.5)
        })
        .sum();
    let mut over = even();
    over.ground = ground(albedo);
    over.objects = vec![object(ball, [0.0; 3], Vec3::new(0.0, d as f32, 0.0))];
    let point = [0.0, h, 0.0];
    let seen = trace(&over, reflecting(3), point, DOWN);
    let expected = f64::from(albedo) * (1.0 - lost);
    assert_near(
        seen.direct,
        seen.direct_error,
        [expected; 3],
        2.0 * depth,
        2e-3,
    );
    assert_eq!(seen.indirect, [0.0; 3]);
    // As the method has it, the ground below a body is as bright as elsewhere.
    let still = trace(&over, bounces(3), point, DOWN);
    assert_near(
        still.direct,
        still.direct_error,
        [f64::from(albedo); 3],
        0.0,
        1e-6,
    );
}

/// A white ball on a white ground under an even sky: with the ground reflecting everything is white in the end. Without
/// it, a ground of albedo 1 shows itself as bright as the sky, and what it receives is white as well.
#[test]
fn a_white_furnace_with_a_ground() {
    let mut furnace = even();
    furnace.ground = ground(1.0);
    let place = Vec3::new(0.0, 1.001, 0.0);
    furnace.objects = vec![object(shapes::ball(1.0, 5), [1.0; 3], place)];
    let at = [0.8, 0.0, 0.1];
    for options in [bounces(60), reflecting(60)] {
        for (point, normal) in [(at, UP), ([1.1, 0.3, 0.0], DOWN)] {
            let seen = trace(&furnace, options, point, normal);
            let error = std::array::from_fn(|c| seen.direct_error[c] + seen.indirect_error[c]);
            assert_near(seen.total(), error, [1.0; 3], 2e-3, 6e-3);
        }
    }
    // Light that the ball has sent to the ground and the ground back comes on top of what bodies alone do.
    furnace.ground = ground(0.5);
    let under = ([1.1, 0.3, 0.0], DOWN);
    let alone = trace(&furnace, bounces(1), under.0, under.1);
    let both = trace(&furnace, reflecting(1), under.0, under.1);
    assert!(both.indirect[0] > alone.indirect[0] + 0.02);
    assert!(both.direct[0] < alone.direct[0]);
}

/// An even sky is the same in both kinds of light, with the ground in them.
#[test]
fn projected_ground_is_not_hidden_by_itself() {
    let mut sky = even();
    sky.ground = ground(1.0);
    let options = Options {
        light: Source::Projected,
        ..bounces(1)
    };
    let seen = trace(&sky, options, [0.0, 1.0, 0.0], DOWN);
    assert_near(seen.direct, seen.direct_error, [1.0; 3], 1e-6, 1e-3);
    let options = Options {
        ground_reflects: true,
        ..options
    };
    let seen = trace(&sky, options, [0.0, 1.0, 0.0], DOWN);
    assert_near(seen.direct, seen.direct_error, [1.0; 3], 1e-6, 1e-3);
}
