//! A body shadows itself without seams: a receiver that walks along its surface goes in and out of its blocker
//! spheres, and its radiance never jumps.

use glam::Vec3;
use sh_cpu::{CutOptions, Cuts, Path, Shadow, shadow_clusters};
use sh_scene::{Forest, Light, Limits, Receiver, Sky, Sphere};
use std::f32::consts::TAU;

/// Radius of the body, a bent tube, in metres.
const TUBE: f32 = 0.2;

/// Radius of its bend.
const BEND: f32 = 0.6;

/// Steps of the coarse walk; the fine one has 16 times as many.
const STEPS: usize = 4096;

/// The middle of the tube and the direction away from the bend's centre, from one end (0) to the other (1).
fn axis(t: f32) -> (Vec3, Vec3) {
    let (sin, cos) = (0.8 * TAU * t).sin_cos();
    let out = Vec3::new(cos, sin, 0.0);
    (out * BEND, out)
}

/// Overlapping spheres along the tube, none at even steps, that hold it.
fn body() -> Vec<Sphere> {
    const COUNT: usize = 40;
    let ball = |i: usize| {
        let t = (i as f32 + 0.5 + 0.2 * (2.3 * i as f32).sin()) / COUNT as f32;
        Sphere {
            center: axis(t).0.into(),
            radius: TUBE * (1.06 + 0.04 * (1.7 * i as f32).sin()),
        }
    };
    (0..COUNT).map(ball).collect()
}

/// A way along the tube that winds three times around it.
fn walk(steps: usize) -> Vec<Receiver> {
    let at = |i: usize| {
        let t = (i as f32 + 0.5) / steps as f32;
        let (middle, out) = axis(0.1 + 0.8 * t);
        let (sin, cos) = (3.0 * TAU * t).sin_cos();
        let normal = out * cos + Vec3::Z * sin;
        Receiver {
            position: (middle + normal * TUBE).into(),
            covered: 1,
            normal: normal.into(),
            object: 0,
        }
    };
    (0..steps).map(at).collect()
}

/// The largest change from step to step, over the radiance of a horizontal surface in the open.
fn largest_change(steps: usize, limits: Option<Limits>) -> Result<f32, Box<dyn std::error::Error>> {
    let light = Light::project(&Sky::default().map(64, 32), None, 4, f32::INFINITY)?;
    let open = light.irradiance([0.0, 1.0, 0.0])[1];
    let (receivers, spheres) = (walk(steps), body());
    let everything = 0..steps;
    let cuts = match limits {
        None => Cuts::everything(&spheres, steps, &light),
        Some(limits) => {
            let mut cuts = Cuts::default();
            let options = CutOptions {
                limits,
                ratios: true,
                accumulation: 4,
            };
            cuts.bound(&receivers, std::slice::from_ref(&everything), 0..1);
            cuts.find(
                Path::best(),
                &Forest::new(&spheres, &[spheres.len()]),
                &light,
                options,
            );
            cuts
        }
    };
    let shadow = Shadow {
        clusters: std::slice::from_ref(&everything),
        cuts: &cuts,
        light: &light,
        accumulation: 4,
        baked: None,
        eye: None,
    };
    let mut radiance = vec![[0.0; 3]; steps];
    shadow_clusters(Path::best(), &receivers, &shadow, &mut radiance)?;
    let greens = radiance.iter().map(|c| c[1]);
    let [least, most] = [f32::min, f32::max].map(|f| greens.clone().reduce(f).unwrap_or(0.0));
    assert!(
        most - least > 0.2 * open,
        "the walk goes through light and shadow"
    );
    let changes = radiance
        .windows(2)
        .map(|pair| (pair[1][1] - pair[0][1]).abs());
    Ok(changes.fold(0.0, f32::max) / open)
}

#[test]
fn radiance_follows_the_surface_without_jumps() -> Result<(), Box<dyn std::error::Error>> {
    for limits in [None, Some(Limits::LEAVES), Some(Limits::default())] {
        let [rough, fine] = [
            largest_change(STEPS, limits)?,
            largest_change(16 * STEPS, limits)?,
        ];
        // A jump would stay as it is; what is continuous falls to a sixteenth. Next to a sphere that is nearly below the
        // horizon light changes within some hundredths of its radius, as the truth does.
        assert!(rough < 64.0 / STEPS as f32, "{limits:?}: {rough}");
        assert!(fine < rough / 10.0, "{limits:?}: {rough}, then {fine}");
    }
    Ok(())
}
