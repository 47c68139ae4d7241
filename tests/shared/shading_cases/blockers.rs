//! Blockers of any number, size and place.

use super::{Shade, UP, Worst, at_origin, even, lattice, receiver, shaded, share, sphere, worst};
use glam::{Vec3, vec3};
use sh_scene::{Receiver, Sphere};

/// One blocker hides what it does, and so do 2 to 4,096 in one place, but for what the method takes too much: they never let
/// through more than there is. Without any shadow .12 to .41 too much would be let through.
pub fn identical_blockers(shade: &Shade, order: usize) {
    let Worst {
        single,
        brighter,
        stacked,
        ..
    } = worst(order);
    for (degrees, direction) in [(40.0_f32, UP), (20.0, UP), (40.0, vec3(0.6, 0.8, 0.0))] {
        let sine = degrees.to_radians().sin();
        let one = sphere(2.0 * direction, 2.0 * sine);
        let hidden = sine * sine * direction.y;
        assert!(
            brighter < 0.2 * hidden,
            "the bound tells a shadow from none"
        );
        for count in [1, 2, 5, 16, 100, 1024, 4096] {
            let share = share(shade, at_origin(), &vec![one; count], order);
            let off = share - (1.0 - hidden);
            let darker = if count == 1 { single } else { stacked };
            assert!(
                (-darker..brighter).contains(&off),
                "{count} of {degrees} degrees: {share}, {hidden} hidden"
            );
        }
    }
}

/// Hundreds of spheres that overlap shade as the body that they fill, but for what the method takes too much: no more light
/// is let through than passes it. Without any shadow .27 too much would be.
pub fn spheres_of_one_body(shade: &Shade, order: usize) {
    // A bar across the zenith.
    let spheres: Vec<Sphere> = (0..400)
        .map(|i| sphere(vec3(i as f32 / 200.0 - 1.0, 1.5, 0.2), 0.5))
        .collect();
    let hit = |d: Vec3| {
        spheres.iter().any(|s| {
            let center = Vec3::from(s.center);
            let along = center.dot(d);
            along > 0.0 && center.length_squared() - along * along < s.radius * s.radius
        })
    };
    let upper = lattice(4000).filter(|d| d.y > 0.0);
    let all: f32 = upper.clone().map(|d| d.y).sum();
    let seen: f32 = upper.filter(|d| !hit(*d)).map(|d| d.y).sum();
    let (share, truth) = (share(shade, at_origin(), &spheres, order), seen / all);
    assert!(
        (-worst(order).body..0.0).contains(&(share - truth)),
        "{share} for {truth}"
    );
}

/// A blocker whose radius goes to 0 takes no light, wherever it is.
pub fn vanishing_blockers(shade: &Shade, order: usize) {
    for radius in [0.0, 1e-45, 1e-40, 1e-38, 1e-30, 1e-18, 1e-9, 1e-5] {
        for center in [UP, vec3(0.0, 1e-3, 0.0), vec3(3.0, 0.1, 0.0), -UP, Vec3::X] {
            let spheres = [sphere(center, radius), sphere(10.0 * center, radius)];
            let share = share(shade, at_origin(), &spheres, order);
            assert!(
                (share - 1.0).abs() < 3e-4,
                "{radius:e} at {center}: {share}"
            );
        }
    }
    // Without any extent, or none that a float tells apart, to the last digit but rounding.
    for center in [Vec3::ZERO, UP, Vec3::X] {
        let share = share(shade, at_origin(), &[sphere(center, 0.0)], order);
        assert!((share - 1.0).abs() < 2e-6, "{center}: {share}");
    }
}

/// A sphere that fills the sky but for a rim lets the rim's light through, and nothing once it touches.
pub fn blockers_up_to_the_horizon(shade: &Shade, order: usize) {
    for size in [1e-3, 1.0, 1e3, 1e6_f32] {
        for gap in [1e-2, 1e-3, 1e-5, 0.0_f32] {
            let radius = size * (1.0 - gap);
            let share = share(shade, at_origin(), &[sphere(size * UP, radius)], order);
            let rim = if gap > 1e-4 { 0.07 } else { 2e-3 };
            assert!(
                share < worst(order).half_space + rim,
                "{size}, {gap}: {share}"
            );
        }
    }
    // Touching the plane from the front beside the receiver: no jump between whole and cut.
    for distance in [0.3, 1.0, 4.0] {
        let around = [1.0 - 1e-5, 1.0, 1.0 + 1e-5].map(|height| {
            let ball = [sphere(vec3(distance, height, 0.0), 1.0)];
            share(shade, at_origin(), &ball, order)
        });
        for pair in around.windows(2) {
            assert!((pair[0] - pair[1]).abs() < 2e-3, "{distance}: {around:?}");
        }
    }
}

/// On a sphere, outside of it by its normal, a receiver does not see it; facing inwards it sees nothing else; in
/// it and at its centre radiance stays in bounds, and without size or place nothing is divided by.
pub fn on_in_and_at_the_centre(shade: &Shade, order: usize) {
    for radius in [1e-12, 1e-3, 1.0, 1e6_f32] {
        let ball = [sphere(Vec3::ZERO, radius)];
        for direction in lattice(24) {
            let on = direction * radius;
            let outwards = share(shade, receiver(on, direction), &ball, order);
            assert!(
                (outwards - 1.0).abs() < 2e-3,
                "{radius} {direction}: {outwards}"
            );
            let inwards = share(shade, receiver(on, -direction), &ball, order);
            assert!(
                inwards < worst(order).half_space,
                "{radius} {direction}: {inwards}"
            );
            // Inside, at all depths, looking anywhere.
            for depth in [0.0, 1e-7, 0.3, 0.999] {
                for normal in lattice(6) {
                    share(shade, receiver(on * depth, normal), &ball, order);
                }
            }
        }
        // The very centre is the one place where the rule jumps: there nothing counts.
        let centre = share(shade, at_origin(), &ball, order);
        assert!((centre - 1.0).abs() < 2e-6, "{centre}");
    }
}

/// Spheres that the tangent plane cuts, anywhere and of any size, leave radiance in bounds, and a step of a
/// ten-thousandth changes it by no more than a hundredth.
pub fn across_the_tangent_plane(shade: &Shade, order: usize) {
    let light = even(order);
    for height in [-0.999_999, -0.5, -1e-6, 0.0, 1e-6, 0.5, 0.999_999] {
        for size in [1e-6, 1.0, 1e6_f32] {
            let places: Vec<Receiver> = (0..=400)
                .map(|i| receiver(vec3(0.05 + i as f32 * 0.01, 0.0, 0.0) * size, UP))
                .collect();
            let moved: Vec<Receiver> = (0..=400)
                .map(|i| receiver(vec3(0.0501 + i as f32 * 0.01, 0.0, 0.0) * size, UP))
                .collect();
            let ball = [sphere(UP * height * size, size)];
            let (a, b) = (
                shaded(shade, &places, &ball, &light, order),
                shaded(shade, &moved, &ball, &light, order),
            );
            for (i, (a, b)) in a.iter().zip(&b).enumerate() {
                assert!(
                    (a[0] - b[0]).abs() < 0.01,
                    "{height}, {size}, {i}: {a:?} {b:?}"
                );
            }
        }
    }
}

/// Where nothing of the sky above a receiver is left, no more gets through than the method lets.
pub fn total_occlusion(shade: &Shade, order: usize) {
    let shell = |count: usize, radius: f32| -> Vec<Sphere> {
        lattice(count).map(|d| sphere(d, radius)).collect()
    };
    let half_space = |up: Vec3| sphere(1e4 * up, 1e4);
    let arrangements: [(&str, Vec<Sphere>); 6] = [
        ("a half space", vec![half_space(UP)]),
        ("two half spaces", vec![half_space(UP), half_space(-UP)]),
        ("a shell of 100 spheres", shell(100, 0.5)),
        ("a shell of 500 spheres", shell(500, 0.3)),
        ("a shell of 2,000 spheres", shell(2000, 0.2)),
        ("a shell of 4,000 spheres", shell(4000, 0.1)),
    ];
    for (name, spheres) in arrangements {
        let normals: Vec<Receiver> = if name.contains("shell") {
            lattice(20).map(|n| receiver(Vec3::ZERO, n)).collect()
        } else {
            vec![at_origin()]
        };
        let found = shaded(shade, &normals, &spheres, &even(order), order);
        let most = found.iter().map(|l| l[0]).fold(0.0, f32::max);
        let bound = match name.contains("shell") {
            true => worst(order).shell,
            false => worst(order).half_space,
        };
        assert!(most <= bound, "{name}: {most:e}, {bound} promised");
    }
}
