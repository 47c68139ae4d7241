//! Shadows of spheres and plates, and light from them.

use super::{
    DOWN, UP, assert_near, bounces, dark, even, flatness, lamp, object, plate, projected, trace,
    trace_more,
};
use glam::Vec3;
use sh_bake::shapes;
use sh_reference::quadrature::gauss_legendre;
use sh_scene::{AreaShape, Texture};

/// A point under a sphere of radius r whose centre is d above it, under an even sky: 1 − (r/d)² without a bounce. With
/// r/d = 1/2 and albedo 1/2 that is 0.375. The sphere's triangles lie within it; the open part grows by less than their
/// depth says.
#[test]
fn the_plane_under_a_sphere() {
    let ball = shapes::ball(1.0, 6);
    let depth = flatness(&ball);
    let mut under = even();
    under.objects = vec![object(ball, [0.7; 3], Vec3::new(0.0, 2.0, 0.0))];
    for options in [bounces(0), projected()] {
        let seen = trace(&under, options, [0.0; 3], UP);
        // (r (1 − e) / d)² is smaller by less than 2 e (r/d)².
        let reflected = seen.direct.map(|c| 0.5 * c);
        let error = seen.direct_error.map(|c| 0.5 * c);
        assert_near(reflected, error, [0.375; 3], depth * 0.25, 1e-3);
        assert_eq!(seen.indirect, [0.0; 3]);
    }
}

/// A lone sphere under an even sky is as bright as its albedo everywhere: it sends a·(r/d)² on, whatever the number of
/// bounces, since it does not see itself.
#[test]
fn one_bounce_from_an_evenly_lit_sphere() {
    let ball = shapes::ball(1.0, 6);
    let depth = flatness(&ball);
    let albedo = [0.8_f32, 0.5, 0.1];
    let mut under = even();
    under.objects = vec![object(ball, albedo, Vec3::new(0.0, 2.0, 0.0))];
    let expected = albedo.map(|a| f64::from(a) * 0.25);
    for options in [bounces(1), bounces(5)] {
        let seen = trace_more(&under, options, [0.0; 3], UP, 16);
        // Normals that are rounder than the triangles send a little light into the ball itself.
        let scene_error = 4.0 * depth;
        assert_near(
            seen.indirect,
            seen.indirect_error,
            expected,
            scene_error,
            1e-3,
        );
    }
}

/// Everything white under an even white sky is white: with enough bounces no receiver tells where a body is.
#[test]
fn a_white_furnace() {
    let mut furnace = even();
    furnace.objects = vec![
        object(
            shapes::torus_knot(2, 3, 0.52, 0.2, 0.12),
            [1.0; 3],
            Vec3::ZERO,
        ),
        object(
            shapes::rounded_box(Vec3::splat(0.6), 0.05),
            [1.0; 3],
            Vec3::new(0.9, 0.1, 0.0),
        ),
        object(shapes::cone(0.4, 1.0), [1.0; 3], Vec3::new(-0.9, 0.0, 0.0)),
    ];
    for (point, normal) in [
        ([0.0, -0.5, 0.0], UP),
        ([0.5, 0.6, 0.1], DOWN),
        ([-0.45, 0.0, 0.0], [1.0, 0.0, 0.0]),
    ] {
        let few = trace(&furnace, bounces(0), point, normal);
        assert!(few.direct[0] < 0.95, "no body is seen from {point:?}");
        let seen = trace(&furnace, bounces(60), point, normal);
        let error = std::array::from_fn(|c| seen.direct_error[c] + seen.indirect_error[c]);
        // Coarse triangles with round normals: 1 in 300 rays ends in its own surface.
        assert_near(seen.total(), error, [1.0; 3], 4e-3, 4e-3);
        assert!(seen.total()[0] > few.total()[0]);
    }
}

/// Two equal round plates face each other, radius R, distance h. The upper one's lower side sees the lower one under
/// the angle factor F(ρ) = ½ (1 − (ρ² + h² − R²)/√((ρ² + h² + R²)² − 4R²ρ²)) (Howell's catalogue, B-13), so that it is
/// lit by 1 − F(ρ); the middle of the lower one gets a ∫ (1 − F(ρ)) 2ρh²/(ρ² + h²)² dρ from there.
#[test]
fn one_bounce_between_two_plates() {
    let (radius, height) = (1.0_f64, 0.7_f64);
    let factor = |rho: f64| {
        let [p, r, h] = [rho * rho, radius * radius, height * height];
        0.5 * (1.0 - (p + h - r) / ((p + h + r).powi(2) - 4.0 * r * p).sqrt())
    };
    let kernel = |rho: f64| {
        let sum = rho * rho + height * height;
        2.0 * rho * height * height / (sum * sum)
    };
    let lit: f64 = gauss_legendre(40, 0.0, radius)
        .into_iter()
        .map(|(rho, weight)| weight * kernel(rho) * (1.0 - factor(rho)))
        .sum();
    let mut plates = even();
    let place = Vec3::new(0.0, height as f32, 0.0);
    plates.objects = vec![
        object(plate(1.0, 256), [0.3, 0.6, 0.9], Vec3::ZERO),
        object(plate(1.0, 256), [0.3, 0.6, 0.9], place),
    ];
    let seen = trace_more(&plates, bounces(1), [0.0; 3], UP, 16);
    let open = 1.0 - factor(0.0);
    // A polygon of 256 corners is smaller than its circle by 1e-4.
    assert_near(seen.direct, seen.direct_error, [open; 3], 2e-4, 2e-3);
    let expected = [0.3, 0.6, 0.9].map(|a| a * lit);
    assert_near(seen.indirect, seen.indirect_error, expected, 2e-4, 2e-3);
}

/// Bodies hide lamps that are farther away, and no others.
#[test]
fn lamps_are_hidden_by_what_is_nearer() {
    for (height, hidden) in [(1.0, false), (3.0, true)] {
        let mut room = dark();
        let (center, radius) = (Vec3::new(0.0, height, 0.0), 0.2);
        room.lights = vec![lamp(AreaShape::Local { center, radius }, [1.0; 3])];
        room.objects = vec![object(plate(5.0, 6), [0.0; 3], Vec3::new(0.0, 2.0, 0.0))];
        let share = (f64::from(radius) / f64::from(height)).powi(2);
        let expected = if hidden { 0.0 } else { share };
        let seen = trace(&room, bounces(0), [0.0; 3], UP);
        assert_near(seen.direct, seen.direct_error, [expected; 3], 1e-5, 1e-3);
    }
}

/// A plate with a texture of two by two texels over one period of it: what it sends is the mean of the linear texels
/// where it fills the view and one texel where it shows just that.
#[test]
fn textures_colour_what_is_reflected() {
    let texel = |code: u8| [code, 255 - code, 0, 255];
    let texture = Texture {
        width: 2,
        height: 2,
        rgba: [0, 255, 255, 0].into_iter().flat_map(texel).collect(),
    };
    let mut room = even();
    let mut far = plate(400.0, 4);
    // Metres over four: the texture repeats many times.
    far.uvs = far
        .positions
        .iter()
        .map(|p| [0.25 * p[0], 0.25 * p[2]])
        .collect();
    let mut body = object(far, [0.5, 0.5, 0.5], Vec3::new(0.0, 2.0, 0.0));
    body.material.texture = Some(texture);
    room.objects = vec![body];
    let mean = trace(&room, bounces(1), [0.3, 0.0, -0.2], UP);
    // The plate ends where 2e-5 of the view is left.
    assert_near(
        mean.indirect,
        mean.indirect_error,
        [0.25, 0.25, 0.0],
        1e-4,
        1e-2,
    );
    let near = trace(&room, bounces(1), [1.0, 1.99, 1.0], UP);
    assert_near(
        near.indirect,
        near.indirect_error,
        [0.0, 0.5, 0.0],
        1e-2,
        1e-2,
    );
    // Colours of the corners come on top.
    let body = &mut room.objects[0];
    body.mesh.colors = vec![[0.5, 0.25, 0.0]; body.mesh.positions.len()];
    let tinted = trace(&room, bounces(1), [0.3, 0.0, -0.2], UP);
    let expected = [0.125, 0.0625, 0.0];
    assert_near(tinted.indirect, tinted.indirect_error, expected, 1e-4, 1e-2);
}
