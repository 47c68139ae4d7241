//! Shapes whose samples are known.

use super::*;
use crate::shapes;

const GREY: Material = Material::diffuse([0.25, 0.5, 0.75]);

fn sphere(center: [f32; 3], radius: f32) -> Sphere {
    Sphere { center, radius }
}

fn near(a: [f32; 3], b: [f32; 3], tolerance: f32) -> bool {
    Vec3::from(a).distance(Vec3::from(b)) <= tolerance
}

#[test]
fn a_sphere_around_a_ball_sees_all_of_it() {
    let mesh = shapes::ball(2.0, 5);
    let samples = bake_surface(&[(&mesh, &GREY)], &[sphere([0.0; 3], 2.0)]);
    assert_eq!(samples.starts, [0, 92]);
    assert_eq!(samples.rotations, [[0.0, 0.0, 0.0, 1.0]]);
    for (j, point) in samples.points.iter().enumerate() {
        let d = directions()[j];
        assert_eq!(point.direction, j as u32);
        assert!(near(point.position, d.map(|c| 2.0 * c), 4e-3), "{point:?}");
        assert!(near(point.normal, d, 2e-3), "{point:?}");
        assert!(near(point.albedo, GREY.albedo, 1e-6), "{point:?}");
    }
}

#[test]
fn spheres_of_a_capsule_see_their_own_halves() {
    // A tube of radius 1 with round ends, 4 long: spheres at ±1, whose surfaces part at y = 0.
    let mesh = shapes::capsule(1.0, 2.0);
    let spheres = [sphere([0.0, 1.0, 0.0], 1.5), sphere([0.0, -1.0, 0.0], 1.5)];
    let samples = bake_surface(&[(&mesh, &GREY)], &spheres);
    let mut partly = 0;
    for (i, s) in spheres.iter().enumerate() {
        let side = s.center[1];
        for (j, d) in directions().iter().enumerate() {
            let across = d[0].hypot(d[2]);
            // Where a ray from the centre meets the tube, above the sphere's own end of it.
            let height = side * (s.center[1] + d[1] / across.max(1e-6));
            let point = samples.of(i).iter().find(|p| p.direction == j as u32);
            let ahead = side * d[1] >= 0.0;
            if ahead || height > 0.4 {
                let point = point.unwrap();
                assert!(point.position[1] * side > 0.0);
                assert!(near(point.albedo, GREY.albedo, 1e-6), "{point:?}");
                assert!(
                    point.share > 0.8 && (!ahead || point.share == 1.0),
                    "{point:?}"
                );
            } else if height < -2.0 {
                assert!(point.is_none(), "{d:?}: {point:?}");
            }
        }
        partly += samples
            .of(i)
            .iter()
            .filter(|p| (0.08..0.92).contains(&p.share))
            .count();
        assert!(
            samples.of(i).len() < DIRECTIONS - 8,
            "{}",
            samples.of(i).len()
        );
    }
    assert!(
        partly >= 8,
        "cells at the border are partly dark, but {partly} are"
    );
}

#[test]
fn points_belong_to_the_sphere_of_the_least_relative_distance() {
    let mesh = shapes::torus_knot(2, 3, 1.0, 0.4, 0.15);
    let spheres = crate::SphereSet::fit(&[&mesh], 12).spheres;
    let samples = bake_surface(&[(&mesh, &GREY)], &spheres);
    assert_eq!(samples.spheres(), spheres.len());
    for i in 0..spheres.len() {
        for point in samples.of(i).iter().filter(|p| p.albedo != [0.0; 3]) {
            let p = Vec3::from(point.position);
            let relative = |s: &Sphere| p.distance(Vec3::from(s.center)) / s.radius;
            let least = spheres.iter().map(relative).fold(f32::INFINITY, f32::min);
            assert!(
                relative(&spheres[i]) <= least * (1.0 + 1e-5),
                "{i}: {point:?}"
            );
            assert!((Vec3::from(point.normal).length() - 1.0).abs() < 1e-5);
        }
    }
}

#[test]
fn a_centre_outside_sees_the_far_side_ahead_and_the_near_side_behind() {
    let mesh = shapes::ball(1.0, 4);
    let samples = bake_surface(&[(&mesh, &GREY)], &[sphere([3.0, 0.0, 0.0], 4.5)]);
    let half_angle = (1.0_f32 / 3.0).asin();
    for (j, d) in directions().iter().enumerate() {
        let d = Vec3::from(*d);
        let point = samples.points.iter().find(|p| p.direction == j as u32);
        let (ahead, behind) = (d.angle_between(-Vec3::X), d.angle_between(Vec3::X));
        if ahead < half_angle - 0.05 {
            let p = Vec3::from(point.unwrap().position);
            assert!(p.x < 0.4, "the far side: {p}");
        } else if behind < half_angle - 0.05 {
            let p = Vec3::from(point.unwrap().position);
            assert!(p.x > 0.3, "the near side: {p}");
        } else if ahead.min(behind) > half_angle + 0.3 {
            // Beside the body it is black, and stays so.
            assert_eq!(point.unwrap().albedo, [0.0; 3], "{d}");
        }
        if let Some(point) = point.filter(|p| p.albedo != [0.0; 3]) {
            assert!(
                near(point.normal, point.position, 0.03),
                "outward: {point:?}"
            );
        }
    }
}

#[test]
fn spheres_that_see_nothing_are_kept_without_points() {
    let mesh = shapes::ball(1.0, 3);
    let parts = [(&mesh, &GREY)];
    let all = sphere([0.0; 3], 1.0);
    let samples = bake_surface(
        &parts,
        &[
            sphere([0.2, 0.0, 0.0], 0.1),
            sphere([0.0; 3], 0.0),
            all,
            all,
            sphere([f32::NAN, 0.0, 0.0], 1.0),
            sphere([0.0; 3], f32::INFINITY),
        ],
    );
    assert_eq!(samples.starts, [0, 0, 0, 92, 92, 92, 92]);
    let alone = bake_surface(&parts, &[all]);
    assert_eq!(samples.points, alone.points);

    let empty = bake_surface(&[(&Mesh::default(), &GREY)], &[all, all]);
    assert_eq!(empty.starts, [0, 0, 0]);
    assert_eq!(bake_surface(&[], &[all]).starts, [0, 0]);
    assert!(bake_surface(&parts, &[]).is_empty());
}

#[test]
fn triangles_that_face_inwards_change_nothing_but_their_order() {
    let mut mesh = shapes::ball(1.0, 3);
    let spheres = [sphere([0.0, 0.3, 0.0], 1.3), sphere([0.0, -0.3, 0.0], 1.3)];
    let samples = bake_surface(&[(&mesh, &GREY)], &spheres);
    for t in &mut mesh.triangles {
        t.swap(1, 2);
    }
    let turned = bake_surface(&[(&mesh, &GREY)], &spheres);
    assert_eq!(samples.starts, turned.starts);
    for (a, b) in samples.points.iter().zip(&turned.points) {
        assert!(near(a.position, b.position, 1e-6) && near(a.normal, b.normal, 1e-5));
    }
}

#[test]
fn a_sheet_has_two_sides() {
    let corner = |x: f32, z: f32| [x, 0.0, z];
    let sheet = Mesh {
        positions: vec![
            corner(-1.0, -1.0),
            corner(-1.0, 1.0),
            corner(1.0, 1.0),
            corner(1.0, -1.0),
        ],
        normals: vec![[0.0, 1.0, 0.0]; 4],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        ..Mesh::default()
    };
    for height in [-0.2, 0.0, 0.2] {
        let samples = bake_surface(&[(&sheet, &GREY)], &[sphere([0.0, height, 0.0], 1.5)]);
        for (j, d) in directions().iter().enumerate() {
            let point = samples.points.iter().find(|p| p.direction == j as u32);
            if d[1].abs() > 0.5 {
                let point = point.unwrap();
                assert_eq!(point.normal, [0.0, d[1].signum(), 0.0], "{height}, {d:?}");
                assert!(point.position[1].abs() < 1e-6);
            }
        }
    }
}

#[test]
fn a_hole_is_dark() {
    let mut bowl = shapes::ball(1.0, 4);
    bowl.triangles
        .retain(|t| t.iter().any(|i| bowl.positions[*i as usize][1] > -0.8));
    let samples = bake_surface(&[(&bowl, &GREY)], &[sphere([0.0; 3], 1.0)]);
    for (j, d) in directions().iter().enumerate() {
        let there = samples.points.iter().find(|p| p.direction == j as u32);
        let bright = there.unwrap().albedo[0] > 0.0;
        if d[1] > -0.7 {
            assert!(bright, "{d:?}");
        } else if d[1] < -0.95 {
            assert!(!bright, "{d:?}");
        }
    }
}

#[test]
fn parts_are_one_body_with_their_own_colours() {
    let (upper, mut lower) = (shapes::ball(1.0, 4), shapes::ball(1.0, 4));
    let mut tinted = upper.clone();
    tinted.triangles.retain(|t| {
        t.iter()
            .map(|i| upper.positions[*i as usize][1])
            .sum::<f32>()
            > 0.0
    });
    tinted.colors = vec![[0.0, 1.0, 2.0]; tinted.positions.len()];
    lower.triangles.retain(|t| {
        t.iter()
            .map(|i| upper.positions[*i as usize][1])
            .sum::<f32>()
            <= 0.0
    });
    let red = Material::diffuse([1.0, f32::NAN, -1.0]);
    let samples = bake_surface(
        &[(&tinted, &GREY), (&lower, &red)],
        &[sphere([0.0; 3], 1.0)],
    );
    assert_eq!(samples.points.len(), DIRECTIONS);
    for point in &samples.points {
        let d = directions()[point.direction as usize];
        if d[1] > 0.3 {
            assert!(near(point.albedo, [0.0, 0.5, 1.0], 1e-6), "{point:?}");
        } else if d[1] < -0.3 {
            assert!(near(point.albedo, [1.0, 0.0, 0.0], 1e-6), "{point:?}");
        }
    }
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let mesh = shapes::torus_knot(2, 3, 1.0, 0.4, 0.15);
    let spheres = crate::SphereSet::fit(&[&mesh], 6).spheres;
    let bake = || bake_surface(&[(&mesh, &GREY)], &spheres);
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(bake)
    };
    assert_eq!(with(1), with(5));
}
