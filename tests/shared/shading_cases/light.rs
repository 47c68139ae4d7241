//! Light of any strength, normals, scales, and what is not a number.

use super::{Shade, UP, at_origin, even, lattice, receiver, shaded, sphere, sunny, worst};
use glam::vec3;
use sh_scene::{Receiver, Sphere};

/// However bright the sun is against the sky, radiance stays in bounds, and where all is hidden the sun is too.
pub fn a_sun_a_million_times_the_sky(shade: &Shade, order: usize) {
    let light = sunny(order, 1e6);
    let receivers: Vec<Receiver> = lattice(50)
        .map(|n| receiver(vec3(n.z, n.x, n.y), n))
        .collect();
    let spheres: Vec<Sphere> = lattice(40).map(|d| sphere(2.0 * d, 0.4)).collect();
    shaded(shade, &receivers, &spheres, &light, order);
    let open = shade(&[at_origin()], &[], &light, order)[0];
    let dark = shaded(shade, &[at_origin()], &[sphere(UP, 1.0)], &light, order)[0];
    assert!(
        dark[0] <= worst(order).sun * open[0],
        "{dark:?} of {open:?}"
    );
}

/// Radiance is in proportion to light, from 1e-30 to 1e30.
pub fn light_of_any_strength(shade: &Shade, order: usize) {
    let receivers: Vec<Receiver> = lattice(30).map(|n| receiver(0.5 * n, n)).collect();
    let spheres: Vec<Sphere> = lattice(9).map(|d| sphere(2.0 * d, 0.6)).collect();
    let light = sunny(order, 50.0);
    let usual = shaded(shade, &receivers, &spheres, &light, order);
    let most = usual.iter().flatten().copied().fold(0.0, f32::max);
    for factor in [1e-30, 1e-6, 1e6, 1e30] {
        let mut scaled = light.clone();
        scaled
            .coefficients
            .iter_mut()
            .flatten()
            .for_each(|c| *c *= factor);
        let found = shaded(shade, &receivers, &spheres, &scaled, order);
        for (found, usual) in found.iter().flatten().zip(usual.iter().flatten()) {
            let off = (found / factor - usual).abs();
            assert!(off <= 3e-6 * most, "{factor:e}: {found} for {usual}");
        }
    }
}

/// Two sides of one surface: what stands in front of one is behind the other and does not darken it; no receiver
/// changes what another gets beside it.
pub fn opposite_normals(shade: &Shade, order: usize) {
    let spheres: Vec<Sphere> = lattice(60)
        .filter(|d| d.y > 0.3)
        .map(|d| sphere(2.0 * d, 0.5))
        .collect();
    let light = sunny(order, 100.0);
    let places = lattice(17).map(|d| 0.1 * vec3(d.x, 0.0, d.z));
    let sides: Vec<Receiver> = places
        .flat_map(|p| [receiver(p, UP), receiver(p, -UP)])
        .collect();
    let found = shaded(shade, &sides, &spheres, &light, order);
    let open = shade(&sides, &[], &light, order);
    let mut darkened = 0;
    for (i, side) in sides.iter().enumerate() {
        let alone = shade(&[*side], &spheres, &light, order)[0];
        assert_eq!(found[i], alone, "receiver {i} sees its neighbours");
        if side.normal[1] < 0.0 {
            assert_eq!(found[i], open[i], "receiver {i} is darkened from behind");
        } else {
            darkened += usize::from(found[i][0] < 0.9 * open[i][0]);
        }
    }
    assert!(darkened > 10, "{darkened} of 17 receivers are in shadow");
}

/// Receivers and blockers scaled alike, from 1e-6 to 1e6, give the same radiance to 1e-5 of the light.
pub fn scales(shade: &Shade, order: usize) {
    let light = sunny(order, 30.0);
    let scaled = |factor: f32| {
        let receivers: Vec<Receiver> = lattice(100)
            .map(|n| receiver(factor * 1.3 * vec3(n.z, n.x, n.y), n))
            .collect();
        let spheres: Vec<Sphere> = lattice(30)
            .map(|d| sphere(factor * 1.5 * d, factor * 0.4))
            .collect();
        shaded(shade, &receivers, &spheres, &light, order)
    };
    let usual = scaled(1.0);
    let most = usual.iter().flatten().copied().fold(0.0, f32::max);
    for factor in [1e-6, 1e-3, 1e3, 1e6] {
        let found = scaled(factor);
        let off = found
            .iter()
            .flatten()
            .zip(usual.iter().flatten())
            .map(|(a, b)| (a - b).abs())
            .fold(0.0, f32::max);
        assert!(off <= 1e-5 * most, "{factor:e}: {off:e} of {most}");
    }
}

/// Light of order 2 under visibilities that are accumulated at any order: in bounds, the light alone where
/// nothing blocks, and the shadow of one blocker to a tenth.
pub fn light_of_a_lower_order(shade: &Shade, order: usize) {
    let receivers: Vec<Receiver> = lattice(40).map(|n| receiver(0.5 * n, n)).collect();
    let spheres: Vec<Sphere> = lattice(12).map(|d| sphere(2.0 * d, 0.7)).collect();
    for light in [sunny(2, 1e6), even(2)] {
        shaded(shade, &receivers, &spheres, &light, order);
        let (a, b) = (
            shade(&receivers, &[], &light, order),
            shade(&receivers, &[], &light, 2),
        );
        for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
            assert!((a - b).abs() <= 1e-5 * b.max(1.0), "{a} {b}");
        }
    }
    let sine = 40.0_f32.to_radians().sin();
    let ball = [sphere(2.0 * UP, 2.0 * sine)];
    let of = |accumulation| shaded(shade, &[at_origin()], &ball, &even(2), accumulation)[0][0];
    let truth = 1.0 - sine * sine;
    assert!((of(order) - truth).abs() < 0.1, "{} for {truth}", of(order));
}

/// Positions, normals, spheres or light that are not finite: no radiance that is not a number, none below 0, what is finite
/// beside them is as it was, and such spheres block nothing.
pub fn what_is_not_a_number(shade: &Shade, order: usize) {
    let sound: Vec<Receiver> = lattice(16).map(|n| receiver(0.5 * n, n)).collect();
    let spheres: Vec<Sphere> = lattice(7).map(|d| sphere(2.0 * d, 0.6)).collect();
    let light = sunny(order, 50.0);
    let usual = shaded(shade, &sound, &spheres, &light, order);
    let is_radiance = |found: &[[f32; 3]], what: &str| {
        for x in found.iter().flatten() {
            assert!(*x >= 0.0, "{what}: {x}");
        }
    };
    // Such a sphere blocks nothing.
    let mut rest = spheres.clone();
    rest.remove(3);
    let rest = shaded(shade, &sound, &rest, &light, order);
    let as_without = |broken: &[Sphere], what: &str| {
        let found = shade(&sound, broken, &light, order);
        for (found, rest) in found.iter().flatten().zip(rest.iter().flatten()) {
            assert!(
                (found - rest).abs() < 1e-4 * rest.max(1.0),
                "{what}: {found} and {rest}"
            );
        }
    };
    for bad in [
        f32::NAN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        f32::MAX,
        f32::MIN,
    ] {
        for k in 0..3 {
            for normal in [false, true] {
                let mut receivers = sound.clone();
                for receiver in receivers.iter_mut().step_by(2) {
                    if normal {
                        receiver.normal[k] = bad;
                    } else {
                        receiver.position[k] = bad;
                    }
                }
                let found = shade(&receivers, &spheres, &light, order);
                is_radiance(&found, &format!("{bad} in a receiver"));
                for i in (1..found.len()).step_by(2) {
                    assert_eq!(found[i], usual[i], "receiver {i} beside {bad}");
                }
            }
            let mut broken = spheres.clone();
            broken[3].center[k] = bad;
            as_without(&broken, &format!("{bad} in a centre"));
        }
        let mut broken = spheres.clone();
        broken[3].radius = bad;
        as_without(&broken, &format!("{bad} in a radius"));
        let mut broken = light.clone();
        broken.coefficients[2][1] = bad;
        let found = shade(&sound, &spheres, &broken, order);
        is_radiance(&found, &format!("{bad} in the light"));
        for (found, usual) in found.iter().zip(&usual) {
            assert_eq!(
                [found[0], found[2]],
                [usual[0], usual[2]],
                "channels beside {bad}"
            );
        }
    }
    // No normal, and one that is far from unit length.
    for normal in [[0.0; 3], [1e-30, 0.0, 0.0], [1e3, 0.0, 0.0], [1e18; 3]] {
        let mut receivers = sound.clone();
        receivers.iter_mut().for_each(|r| r.normal = normal);
        is_radiance(&shade(&receivers, &spheres, &light, order), "a normal");
    }
}
