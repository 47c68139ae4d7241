//! The shadow pass on every vector path, against its method's formula put together here from the reference, and against rays.

use sh_cpu::{Path, irradiance, shadow_on};
use sh_reference::basis::{dot as inner, evaluate};
use sh_reference::sampled;
use sh_reference::visibility::{caps, visible};
use sh_reference::zonal::cosine;
use sh_scene::{EnvironmentMap, Light, Receiver, Sphere};
use sh_tests::case::Random;
use sh_tests::truth::truth;

/// A sky that is bright towards +X and blue below, of some order.
fn light(order: usize) -> Light {
    let map = sh_reference::environment::map_of(32, 16, |d| {
        let sun = 20.0 * (4.0 * (0.8 * d[0] + 0.6 * d[1] - 1.0)).exp();
        [0.5 + sun, 0.5 + 0.8 * sun, 1.0 + 0.3 * sun - 0.4 * d[1]]
    });
    let map: EnvironmentMap = map;
    Light::project(&map, None, order, 2.0 * order as f32).expect("a sound map")
}

/// Receivers and blockers scattered so that receivers are inside of spheres, and horizons cut some.
fn scattered(receivers: usize, blockers: usize, reach: f64) -> (Vec<Receiver>, Vec<Sphere>) {
    let mut random = Random::new(99);
    let mut point = |reach: f64| [0; 3].map(|_| (reach * random.signed()) as f32);
    let spheres = (0..blockers).map(|_| Sphere {
        center: point(reach),
        radius: 0.275 + 0.225 * point(1.0)[0],
    });
    let spheres = spheres.collect();
    let mut random = Random::new(7);
    let receivers = (0..receivers).map(|_| Receiver {
        position: [0; 3].map(|_| (reach * random.signed()) as f32),
        covered: 1,
        normal: random.on_sphere::<3>().map(|x| x as f32),
        object: 0,
    });
    (receivers.collect(), spheres)
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// What of a sphere is above the horizon, as `sh_core::seen` documents it: sine and cosine of the angular radius, and the
/// direction. A sphere that the horizon cuts is stood for by one that touches the plane below its centre.
fn seen(center: [f64; 3], normal: [f64; 3], radius: f64) -> Option<(f64, f64, [f64; 3])> {
    let (height, square) = (dot(center, normal), dot(center, center));
    let whole = |center: [f64; 3], radius: f64| {
        let distance = dot(center, center).sqrt();
        let sine = (radius / distance).min(1.0);
        (
            sine,
            (1.0 - sine * sine).sqrt(),
            center.map(|x| x / distance),
        )
    };
    if height >= radius {
        return Some(whole(center, radius));
    }
    // From inside, that of one which reaches to the receiver.
    let inside = (radius * radius / square).max(1.0);
    let over = height / radius * inside;
    if over <= -1.0 {
        return None;
    }
    let sine_squared = (radius * radius / square).min(1.0);
    let part = truth("horizon_radius", 4, &[vec![over], vec![sine_squared]]);
    let radius = radius * part.expect("a truth")[0];
    let touching = [0, 1, 2].map(|k| center[k] + (radius - height) * normal[k]);
    Some(whole(touching, radius))
}

/// (L, H(N), exp Σ f): logarithms of all spheres summed in the order of accumulation, the transfer, the light's bands of it,
/// held between 0 and the light without blockers.
fn by_formula(at: &Receiver, spheres: &[Sphere], light: &Light, accumulation: usize) -> [f64; 3] {
    let normal = at.normal.map(f64::from);
    let mut sum = vec![0.0; accumulation * accumulation];
    for sphere in spheres {
        let center = [0, 1, 2].map(|k| f64::from(sphere.center[k]) - f64::from(at.position[k]));
        if let Some((sine, cosine, direction)) = seen(center, normal, sphere.radius.into()) {
            let arguments = [vec![sine], vec![cosine]];
            let log = truth("cap_log_shading", accumulation, &arguments).expect("a truth");
            let turned = sh_reference::zonal::rotated(&log, direction);
            sum.iter_mut().zip(turned).for_each(|(sum, t)| *sum += t);
        }
    }
    let transfer = truth("transfer", accumulation, &[sum, normal.to_vec()]).expect("a truth");
    let open = cosine(light.order, normal);
    [0, 1, 2].map(|c| {
        let light: Vec<f64> = light.coefficients.iter().map(|l| l[c].into()).collect();
        let shadowed = inner(&light, &transfer[..light.len()]);
        shadowed.min(inner(&light, &open)).max(0.0)
    })
}

/// The pass on one path.
fn found(
    path: Path,
    receivers: &[Receiver],
    spheres: &[Sphere],
    light: &Light,
    accumulation: usize,
) -> Vec<[f32; 3]> {
    let mut radiance = vec![[f32::NAN; 3]; receivers.len()];
    shadow_on(path, receivers, spheres, light, accumulation, &mut radiance).expect("all fits");
    radiance
}

#[test]
fn every_path_is_the_formula() {
    let (receivers, spheres) = scattered(300, 12, 3.0);
    for (order, accumulation) in [(2, 2), (3, 3), (4, 4), (5, 5), (6, 6), (4, 6), (3, 5)] {
        let light = light(order);
        let expected: Vec<_> = receivers
            .iter()
            .map(|r| by_formula(r, &spheres, &light, accumulation))
            .collect();
        let mut open = vec![[0.0; 3]; receivers.len()];
        irradiance(&receivers, &light, &mut open).expect("all fits");
        let change = |(open, shadowed): (&[f32; 3], &[f64; 3])| f64::from(open[0]) - shadowed[0];
        let shadows = open.iter().zip(&expected).map(change).fold(0.0, f64::max);
        for path in Path::all() {
            let found = found(path, &receivers, &spheres, &light, accumulation);
            let off = expected.iter().flatten().zip(found.iter().flatten());
            let worst = off
                .map(|(a, b)| (a - f64::from(*b)).abs())
                .fold(0.0, f64::max);
            println!(
                "order {order} of {accumulation}, {path:?}: {worst:.1e}, shadows to {shadows:.2}"
            );
            assert!(
                worst < 1e-5,
                "order {order} of {accumulation}, {path:?}: {worst}"
            );
            assert!(shadows > 1.0, "the deepest shadow takes {shadows}");
        }
    }
}

/// Against directions that spheres are in the way of: what the method errs by, over what shadows take, both RMS.
#[test]
fn shadows_are_those_of_rays() {
    let (receivers, spheres) = scattered(200, 12, 2.0);
    // Inside of a sphere nothing is seen.
    let outside = |r: &Receiver| {
        spheres.iter().all(|s| {
            let to = [0, 1, 2].map(|k| f64::from(s.center[k]) - f64::from(r.position[k]));
            dot(to, to) > f64::from(s.radius).powi(2)
        })
    };
    let receivers: Vec<Receiver> = receivers.into_iter().filter(outside).collect();
    assert!(receivers.len() > 150);
    for (order, bound) in [(2, 0.26), (3, 0.13), (4, 0.085), (5, 0.083), (6, 0.085)] {
        let light = light(order);
        let sky: [Vec<f64>; 3] =
            [0, 1, 2].map(|c| light.coefficients.iter().map(|l| l[c].into()).collect());
        let found = found(Path::best(), &receivers, &spheres, &light, order);
        let (mut off, mut taken) = (0.0, 0.0);
        for (receiver, found) in receivers.iter().zip(&found) {
            let caps = caps(receiver.position.map(f64::from), &spheres);
            let normal = receiver.normal.map(f64::from);
            let lit = |hidden: bool| {
                let seen = |s| f64::from(u8::from(!hidden || visible(&caps, s)));
                let sky = |s| [0, 1, 2].map(|c| evaluate(&sky[c], s));
                sampled::irradiance(normal, 2000, seen, sky).value
            };
            for ((truth, open), found) in lit(true).iter().zip(lit(false)).zip(found) {
                off += (truth - f64::from(*found)).powi(2);
                taken += (truth - open).powi(2);
            }
        }
        let share = f64::sqrt(off / taken);
        println!("order {order}: errs by {share:.3} of what shadows take");
        assert!(share < bound, "order {order}: {share}");
    }
}
