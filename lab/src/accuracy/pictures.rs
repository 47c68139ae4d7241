//! Whole pictures against ray-cast ones.
//!
//! The built-in scene, seen by its camera. The truth has rays against the triangles for visibility and light of
//! order 6; what is measured errs by its spheres, by its logarithms and exponential, and by the order of its
//! light.

use super::PictureRow;
use gaunt::Error;
use rayon::prelude::*;
use sh_bake::Choices;
use sh_cpu::{CutOptions, Cuts, Gbuffer, Geometry, Path, Shadow, shadow_clusters};
use sh_reference::{basis, raycast, sampled};
use sh_scene::{Clusters, Light, Receiver, Scene, View};
use std::time::Instant;

/// Pixels across and down; there are four receivers a pixel.
const SIZE: [u32; 2] = [80, 45];

/// Directions over the sphere that the truth looks into from each receiver.
const RAYS: usize = 2048;

/// What the scene's numbers of spheres are multiplied with.
const FACTORS: [f32; 5] = [0.125, 0.25, 0.5, 1.0, 2.0];

/// Orders of light and accumulation.
const ORDERS: [(usize, usize); 9] = [
    (2, 2),
    (3, 3),
    (3, 4),
    (4, 4),
    (4, 5),
    (4, 6),
    (5, 5),
    (5, 6),
    (6, 6),
];

/// Receivers of a cluster, about.
const CLUSTER: usize = 128;

/// Runs of which the fastest counts.
const RUNS: usize = 21;

/// How far rays start above a surface, in metres.
const ABOVE: f64 = 1e-4;

fn luminance(c: [f32; 3]) -> f64 {
    f64::from(0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2])
}

/// All rows.
pub fn rows(progress: &(dyn Fn(f32) + Sync)) -> Result<Vec<PictureRow>, Error> {
    let mut rows = Vec::new();
    let mut seen = None;
    for (i, factor) in FACTORS.into_iter().enumerate() {
        let choices = Choices {
            spheres: factor,
            ..Choices::default()
        };
        // Always fitted anew.
        let (scene, _) = sh_bake::default_scene_with(choices, None, &|_| {});
        let (clusters, receivers, truth) = match seen.take() {
            Some(seen) => seen,
            None => {
                let receivers = receivers(&scene)?;
                let clusters = Clusters::new(&receivers, receivers.len().div_ceil(CLUSTER));
                let receivers = clusters.sorted(&receivers);
                let truth = truth(&scene, &receivers)?;
                (clusters, receivers, truth)
            }
        };
        for orders in ORDERS {
            rows.push(row(
                &scene,
                (&clusters, &receivers),
                &truth,
                factor,
                orders,
            )?);
        }
        seen = Some((clusters, receivers, truth));
        progress((i + 1) as f32 / FACTORS.len() as f32);
    }
    Ok(rows)
}

/// What the camera sees, without what it misses.
fn receivers(scene: &Scene) -> Result<Vec<Receiver>, Error> {
    let view = View {
        camera: scene.camera,
        width: SIZE[0],
        height: SIZE[1],
    };
    let geometry = Geometry::new(scene)?;
    let mut samples = Gbuffer::default();
    let grid = view.samples();
    sh_cpu::gbuffer(&geometry, &view, grid, 0..grid.tiles().rows, &mut samples)?;
    samples.receivers.retain(|receiver| receiver.covered != 0);
    Ok(samples.receivers)
}

/// Luminance that albedo 1 reflects at every receiver.
fn truth(scene: &Scene, receivers: &[Receiver]) -> Result<Vec<f64>, Error> {
    let light = light(scene, 6)?;
    let light: Vec<f64> = light.coefficients.iter().map(|c| luminance(*c)).collect();
    let triangles = scene.objects.iter().flat_map(raycast::world_triangles);
    let caster = raycast::Caster::new(triangles.collect());
    let rays: Vec<([f64; 3], f64)> = sampled::directions(RAYS)
        .map(|direction| (direction, basis::evaluate(&light, direction)))
        .collect();
    Ok(receivers
        .par_iter()
        .map(|receiver| {
            let normal = receiver.normal.map(f64::from);
            let origin =
                std::array::from_fn(|i| f64::from(receiver.position[i]) + ABOVE * normal[i]);
            let seen = |(direction, light): &([f64; 3], f64)| {
                let cosine: f64 = (0..3).map(|i| direction[i] * normal[i]).sum();
                let open = cosine > 0.0 && !caster.blocked(origin, *direction, 0.0);
                if open { cosine * light } else { 0.0 }
            };
            (rays.iter().map(seen).sum::<f64>() * 4.0 / RAYS as f64).max(0.0)
        })
        .collect())
}

fn light(scene: &Scene, order: usize) -> Result<Light, Error> {
    let (map, ground) = (&scene.environment, scene.ground);
    Ok(Light::project(map, ground, order, f32::INFINITY)?)
}

fn row(
    scene: &Scene,
    (clusters, receivers): (&Clusters, &[Receiver]),
    truth: &[f64],
    factor: f32,
    (order, accumulation_order): (usize, usize),
) -> Result<PictureRow, Error> {
    let light = light(scene, order)?;
    let (forest, clusters) = (scene.forest(), &clusters.ranges);
    let options = CutOptions {
        limits: scene.settings.limits,
        ratios: true,
        accumulation: accumulation_order,
    };
    let path = Path::best();
    let mut radiance = vec![[0.0; 3]; receivers.len()];
    let mut cuts = Cuts::default();
    cuts.bound(receivers, clusters, 0..clusters.len());
    let mut seconds = f64::INFINITY;
    for _ in 0..RUNS {
        let start = Instant::now();
        cuts.find(path, &forest, &light, options);
        let shadow = Shadow {
            clusters,
            cuts: &cuts,
            light: &light,
            accumulation: accumulation_order,
            baked: None,
            eye: None,
        };
        shadow_clusters(path, receivers, &shadow, &mut radiance)?;
        seconds = seconds.min(start.elapsed().as_secs_f64());
    }
    let (mut square, mut bias, mut mean) = (0.0, 0.0, 0.0);
    for (ours, truth) in radiance.iter().zip(truth) {
        let difference = luminance(*ours) - truth;
        square += difference * difference;
        bias += difference;
        mean += truth;
    }
    let count = truth.len() as f64;
    Ok(PictureRow {
        scene: "built-in".into(),
        order,
        accumulation_order,
        spheres: forest.spheres(),
        factor,
        rms: (square / count).sqrt() / (mean / count),
        bias: bias / mean,
        ms: seconds * 1e9 / count,
    })
}
