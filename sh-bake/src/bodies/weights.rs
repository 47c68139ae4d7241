//! The weights of a scene's bodies.

use crate::cache::{Cache, weights_key};
use crate::progress::Progress;
use crate::weights::{Pose, of_poses};
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use sh_scene::motion::Motion;
use sh_scene::{Object, Scene};
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// Poses of a clip that weights are found in.
const POSES: usize = 4;

/// Up in a body's space is told apart to this.
const STEP: f32 = 1.0 / 256.0;

/// A body's weights, as far as a person wants to know.
#[derive(Clone, Debug)]
pub struct WeightReport {
    /// The name of the first of its objects.
    pub name: String,
    /// How many spheres it has.
    pub spheres: usize,
    /// Time for finding them, or for reading them from the cache.
    pub time: Duration,
    /// Whether they come from the cache.
    pub cached: bool,
}

/// Finds weights for the spheres of bodies, each of which is some of the objects, the first with the spheres of all; of those
/// that bend over poses of their clip. Bodies that are alike and equally upright are weighed once and reported once.
pub(crate) fn weigh(
    scene: &mut Scene,
    motion: &mut Motion,
    bodies: &[Range<usize>],
    cache: Option<&Cache>,
    progress: &(dyn Fn(Progress) + Sync),
) -> Vec<WeightReport> {
    let mut poses: Vec<Vec<Pose>> = bodies.iter().map(|_| Vec::new()).collect();
    let times = if motion.bends() { POSES } else { 1 };
    for k in 0..times {
        if times > 1 {
            motion.pose(motion.period() * k as f64 / times as f64, scene);
        }
        for (body, poses) in bodies.iter().zip(&mut poses) {
            let objects = &scene.objects[body.clone()];
            let pose = Pose {
                meshes: objects.iter().map(|o| o.mesh.clone()).collect(),
                spheres: objects
                    .first()
                    .map(|o| o.spheres.clone())
                    .unwrap_or_default(),
            };
            let is_new = poses
                .last()
                .is_none_or(|last: &Pose| last.spheres != pose.spheres);
            if is_new {
                poses.push(pose);
            }
        }
    }
    if times > 1 {
        motion.pose(0.0, scene);
    }

    let mut wanted: BTreeMap<String, usize> = BTreeMap::new();
    let mut keys = Vec::new();
    for (b, body) in bodies.iter().enumerate() {
        let up = scene.objects.get(body.start).map_or(DVec3::Y, up);
        let key = weights_key(&poses[b], up);
        wanted.entry(key.clone()).or_insert(b);
        keys.push((key, up));
    }
    let total = wanted
        .values()
        .map(|&b| 1 + poses[b][0].spheres.len())
        .sum();
    let sum = AtomicUsize::new(0);
    let tell = |more: usize| {
        let done = sum.fetch_add(more, Ordering::Relaxed) + more;
        let stage = "weighing spheres";
        progress(Progress { stage, done, total });
    };
    tell(0);
    let find = |(key, &b): (&String, &usize)| {
        let start = Instant::now();
        let count = poses[b][0].spheres.len();
        let found = cache.and_then(|cache| cache.find_weights(key, count));
        let cached = found.is_some();
        let weights = found.unwrap_or_else(|| {
            let weights = of_poses(&poses[b], keys[b].1);
            if let Some(cache) = cache {
                cache.keep_weights(key, &weights);
            }
            weights
        });
        tell(1 + count);
        (key.clone(), (weights, start.elapsed(), cached))
    };
    let found: BTreeMap<_, _> = wanted.par_iter().map(find).collect();

    let mut reports = Vec::new();
    for (b, (body, (key, _))) in bodies.iter().zip(&keys).enumerate() {
        let (Some(object), Some((weights, time, cached))) =
            (scene.objects.get_mut(body.start), found.get(key))
        else {
            continue;
        };
        object.weights.clone_from(weights);
        if wanted.get(key) == Some(&b) {
            reports.push(WeightReport {
                name: object.name.clone(),
                spheres: weights.len(),
                time: *time,
                cached: *cached,
            });
        }
    }
    reports
}

/// Where up is in an object's space, in steps: turning about it changes nothing.
fn up(object: &Object) -> DVec3 {
    let (_, turn, _) = object.transform.to_scale_rotation_translation();
    let up = turn.inverse() * Vec3::Y;
    let stepped = (up / STEP).round() * STEP;
    if stepped.is_finite() {
        stepped.as_dvec3()
    } else {
        DVec3::Y
    }
}
