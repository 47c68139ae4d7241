//! Weights of spheres, against a body whose shadow is known.

use glam::Vec3;
use sh_bake::{SphereSet, shapes, weights, weights_by};
use sh_core::Routines;
use sh_core::seen::Seen;
use sh_scene::Sphere;

const UP: [f32; 3] = [0.0, 1.0, 0.0];
const RADIUS: f32 = 0.3;
const HALF: f32 = 0.5;

/// Whether a ray meets a capsule along X, which rests on the ground: whether it comes near enough to the segment within.
fn meets(from: [f32; 3], way: [f32; 3]) -> bool {
    let (from, way) = (Vec3::from(from), Vec3::from(way));
    let nearest = |t: f32| {
        let p = from + way * t;
        let on = Vec3::new(p.x.clamp(-HALF, HALF), RADIUS, 0.0);
        p.distance(on)
    };
    // The distance to a convex body is convex along a ray.
    let (mut low, mut high) = (0.0, 20.0);
    for _ in 0..60 {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if nearest(a) < nearest(b) {
            high = b;
        } else {
            low = a;
        }
    }
    nearest(low) < RADIUS
}

/// RMS error of an even sky's light over places on the ground, at order 4.
fn error(spheres: &[Sphere], weights: &[f32]) -> f64 {
    const RAYS: usize = 1500;
    let golden = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    let (mut sum, mut count) = (0.0, 0.0);
    for i in 0..60 {
        let (r, turn) = (0.35 + 0.03 * f64::from(i), 2.4 * f64::from(i));
        let place = [(r * turn.cos()) as f32, 1e-4, (r * turn.sin()) as f32];
        let lit = (0..RAYS).filter(|&k| {
            // Evenly over the disc under the hemisphere: in proportion to the cosine.
            let radius = ((k as f64 + 0.5) / RAYS as f64).sqrt();
            let (sin, cos) = (golden * k as f64).sin_cos();
            let up = (1.0 - radius * radius).sqrt();
            !meets(place, [radius * cos, up, radius * sin].map(|x| x as f32))
        });
        let truth = lit.count() as f64 / RAYS as f64;
        let mut log = [0.0_f64; 16];
        for (sphere, weight) in spheres.iter().zip(weights) {
            let center = [0, 1, 2].map(|k| f64::from(sphere.center[k] - place[k]));
            let up = UP.map(f64::from);
            let seen = Seen::above(center, up, f64::from(sphere.radius), 0.0);
            let each = [f64::from(*weight); 4];
            log = log.accumulate_blocker(seen.sine, seen.cosine, seen.direction, each);
        }
        let transfer = log.accumulated_log().transfer(UP.map(f64::from));
        let found = transfer[0] * sh_core::ROOT_FOUR_PI;
        sum += (found - truth) * (found - truth);
        count += 1.0;
    }
    f64::sqrt(sum / count)
}

/// The capsule's spheres, which overlap.
fn spheres() -> Vec<Sphere> {
    (0..12)
        .map(|i| Sphere {
            center: [HALF * (i as f32 / 5.5 - 1.0), RADIUS, 0.0],
            radius: RADIUS * 1.05,
        })
        .collect()
}

#[test]
fn weighted_spheres_hide_what_the_mesh_hides() {
    let mut mesh = shapes::capsule(RADIUS, HALF * 2.0);
    // Along X, on the ground.
    let low = mesh.positions.iter().fold(f32::MAX, |low, p| low.min(p[1]));
    let high = mesh
        .positions
        .iter()
        .fold(f32::MIN, |high, p| high.max(p[1]));
    let middle = 0.5 * (low + high);
    for v in mesh.positions.iter_mut() {
        *v = [v[1] - middle, v[0] + RADIUS, -v[2]];
    }
    for n in mesh.normals.iter_mut() {
        *n = [n[1], n[0], -n[2]];
    }
    let spheres = spheres();
    let found = weights(&[&mesh], &spheres, UP);
    assert!(found.iter().all(|w| *w >= 0.0));
    let [without, with] = [vec![1.0; 12], found].map(|weights| error(&spheres, &weights));
    println!("without {without:.4}, with weights {with:.4}");
    assert!(
        without > 0.03 && with < 0.015 && with < without / 3.0,
        "{without} {with}"
    );
}

#[test]
fn a_body_that_its_owner_looks_at_gets_the_same_kind_of_weights() {
    let around = Sphere {
        center: [0.0, RADIUS, 0.0],
        radius: RADIUS,
    };
    let spheres = spheres();
    let found = weights_by(&spheres, around, UP, &[], &meets);
    let [without, with] = [vec![1.0; 12], found].map(|weights| error(&spheres, &weights));
    assert!(with < without / 2.0, "{without} {with}");
}

#[test]
fn the_number_of_threads_changes_nothing() {
    let mesh = shapes::ball(1.0, 3);
    let set = SphereSet::fit(&[&mesh], 6).spheres;
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let pool = pool.build().expect("threads");
        pool.install(|| weights(&[&mesh], &set, UP))
    };
    assert_eq!(with(1), with(3));
}

#[test]
fn nothing_to_look_at_weighs_one() {
    assert_eq!(weights(&[], &spheres(), UP), vec![1.0; 12]);
    assert!(weights(&[&shapes::ball(1.0, 2)], &[], UP).is_empty());
}
