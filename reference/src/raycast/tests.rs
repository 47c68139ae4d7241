use super::*;
use crate::sampled;
use crate::testing::{assert_close, directions, numbers};
use crate::visibility::{caps, project};
use glam::{Affine3A, Quat};
use sh_scene::{Material, Sphere};

/// A ball of triangles: `rows` by `2·rows` quads.
fn ball(center: Vec3, radius: f64, rows: usize) -> Vec<Triangle> {
    use std::f64::consts::{PI, TAU};
    let corner = |i: usize, j: usize| {
        let (a, b) = (
            PI * i as f64 / rows as f64,
            TAU * j as f64 / (2 * rows) as f64,
        );
        let s = [a.sin() * b.cos(), a.cos(), a.sin() * b.sin()];
        [0, 1, 2].map(|k| center[k] + radius * s[k])
    };
    let quads = (0..rows).flat_map(|i| (0..2 * rows).map(move |j| (i, j)));
    quads
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [
                corner(i, j),
                corner(i + 1, j),
                corner(i + 1, j + 1),
                corner(i, j + 1),
            ];
            [[a, b, c], [a, c, d]]
        })
        .collect()
}

#[test]
fn boxes_hide_no_triangle() {
    let corners = numbers(41, 9 * 300);
    let soup: Vec<Triangle> = corners
        .chunks(9)
        .map(|c| {
            let near = |i: usize| [0, 1, 2].map(|k| c[k] + 0.4 * c[3 * i + k]);
            [near(0), near(1), near(2)]
        })
        .collect();
    let caster = Caster::new(soup.clone());
    let mut hits = 0;
    for (i, s) in directions(400).into_iter().enumerate() {
        let start = numbers(i as u64, 3);
        let origin = [1.5 * start[0], 1.5 * start[1], 1.5 * start[2]];
        let brute = soup
            .iter()
            .filter_map(|t| intersect(t, origin, s, 0.0))
            .reduce(f64::min);
        assert_eq!(caster.nearest(origin, s, 0.0), brute);
        assert_eq!(caster.blocked(origin, s, 0.0), brute.is_some());
        let within = |limit| caster.blocked_within(origin, s, 0.0, limit);
        assert!(brute.is_none_or(|d| within(d + 1e-9) && !within(d - 1e-9)));
        if let Some(hit) = caster.nearest_hit(origin, s, 0.0) {
            let [a, b, c] = soup[hit.triangle];
            let [i, j, k] = hit.weights;
            let there = [0, 1, 2].map(|n| i * a[n] + j * b[n] + k * c[n]);
            let along = [0, 1, 2].map(|n| origin[n] + hit.distance * s[n]);
            assert_close(&there, &along, 1e-9);
        }
        hits += usize::from(brute.is_some());
    }
    assert!((50..350).contains(&hits), "{hits} rays hit");
}

#[test]
fn no_ray_slips_between_triangles() {
    let triangles = ball([0.0; 3], 1.0, 12);
    let caster = Caster::new(triangles.clone());
    for s in directions(3000) {
        assert!(caster.blocked([0.0; 3], s, 0.0));
    }
    // Straight at the corners and the middles of the edges.
    for [a, b, _] in triangles {
        let middle = [0, 1, 2].map(|k| 0.5 * (a[k] + b[k]));
        for target in [a, middle] {
            assert!(caster.blocked([0.0; 3], crate::vec3::normalize(target), 0.0));
        }
    }
}

#[test]
fn nothing_is_blocked_by_nothing() {
    let caster = Caster::new(Vec::new());
    assert!(!caster.blocked([0.0; 3], [0.0, 1.0, 0.0], 0.0));
    let flat = [[1.0, 1.0, 1.0]; 3];
    assert_eq!(
        Caster::new(vec![flat]).nearest([0.0; 3], [0.0, 1.0, 0.0], 0.0),
        None
    );
}

#[test]
fn surfaces_do_not_block_their_own_points() {
    let floor = [[-9.0, 0.0, -9.0], [9.0, 0.0, -9.0], [0.0, 0.0, 9.0]];
    let caster = Caster::new(vec![floor]);
    assert!(!caster.blocked([0.0; 3], [0.0, 1.0, 0.0], 1e-6));
    // From a point that rounding put below its surface.
    assert!(caster.blocked([0.0, -1e-7, 0.0], [0.0, 1.0, 0.0], 0.0));
    assert!(!caster.blocked([0.0, -1e-7, 0.0], [0.0, 1.0, 0.0], 1e-6));
    let white = sampled::irradiance(
        [0.0, 1.0, 0.0],
        4000,
        |s| {
            if caster.blocked([0.0; 3], s, 1e-6) {
                0.0
            } else {
                1.0
            }
        },
        |_| [1.0; 3],
    );
    assert!((white.value[1] - 1.0).abs() < 1e-3);
}

#[test]
fn a_ball_of_triangles_is_nearly_a_sphere() {
    let center = [0.5, 2.0, -0.5];
    let caster = Caster::new(ball(center, 1.0, 48));
    let dense = sampled::project(4, 50_000, |s| {
        if caster.blocked([0.0; 3], s, 0.0) {
            0.0
        } else {
            1.0
        }
    });
    let sphere = Sphere {
        center: center.map(|c| c as f32),
        radius: 1.0,
    };
    let exact = project(4, &caps([0.0; 3], &[sphere]), 1e-2);
    let off = crate::basis::distance(&dense.coefficients, &exact.coefficients);
    assert!(off < 5e-3, "{off:e}");
}

#[test]
fn world_triangles_are_transformed() {
    let mesh = Mesh {
        positions: vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        triangles: vec![[2, 0, 1]],
        ..Mesh::default()
    };
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    assert_eq!(triangles(&mesh), [[z, x, y]]);
    // A quarter turn about +Z takes x to y and y to -x; then twice as large, then moved.
    let object = Object {
        name: String::from("triangle"),
        mesh,
        material: Material::diffuse([1.0; 3]),
        transform: Affine3A::from_scale_rotation_translation(
            glam::Vec3::splat(2.0),
            Quat::from_rotation_z(std::f32::consts::FRAC_PI_2),
            glam::Vec3::new(10.0, 20.0, 30.0),
        ),
        ..Object::default()
    };
    let expected = [[10.0, 20.0, 32.0], [10.0, 22.0, 30.0], [8.0, 20.0, 30.0]];
    let found = world_triangles(&object);
    assert_eq!(found.len(), 1);
    for (corner, expected) in found[0].iter().zip(expected) {
        assert_close(corner, &expected, 1e-6);
    }
}
