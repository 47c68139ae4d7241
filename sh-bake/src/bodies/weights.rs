//! The weights of a scene's bodies.

use super::once::{Bake, once};
use crate::cache::{Baked, Cache, Ingredients, Key, fours};
use crate::progress::Progress;
use crate::weights::{Pose, WEIGHTS_VERSION, Weights, log, of_poses, transfer};
use glam::{DVec3, Vec3};
use sh_core::seen::Seen;
use sh_scene::motion::Motion;
use sh_scene::{Object, Scene};
use std::ops::Range;
use std::time::Duration;

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

    let ups = bodies
        .iter()
        .map(|body| scene.objects.get(body.start).map_or(DVec3::Y, up));
    let wanted: Vec<Weighed> = poses
        .into_iter()
        .zip(ups)
        .map(|(poses, up)| Weighed { poses, up })
        .collect();
    let found = once(&wanted, cache, progress);
    let mut reports = Vec::new();
    for (body, found) in bodies.iter().zip(found) {
        let Some(object) = scene.objects.get_mut(body.start) else {
            continue;
        };
        object.weights.clone_from(&found.what.0);
        if found.first {
            reports.push(WeightReport {
                name: object.name.clone(),
                spheres: found.what.0.len(),
                time: found.time,
                cached: found.cached,
            });
        }
    }
    reports
}

/// The spheres of a body: found by its shape in all poses that are looked at, its spheres, where up is, and what the shadow
/// pass makes of blockers.
struct Weighed {
    poses: Vec<Pose>,
    up: DVec3,
}

impl Weighed {
    fn spheres(&self) -> usize {
        self.poses.first().map_or(0, |pose| pose.spheres.len())
    }
}

impl Bake for Weighed {
    type Baked = Weights;

    const STAGE: &'static str = "weighing spheres";

    fn key(&self) -> Key {
        let mut key = Ingredients::<Weights>::new();
        // Whatever is fitted anew in the shadow pass shows here.
        for sine in [0.1, 0.5, 0.9, 1.0] {
            let cosine = f64::sqrt(1.0 - sine * sine);
            let seen = Seen {
                sine,
                cosine,
                direction: [0.6, 0.0, 0.8],
            };
            let transfer = transfer(&log(&seen), [0.0, 1.0, 0.0]);
            key.numbers(transfer.map(|number| number as f32));
        }
        key.numbers(self.up.as_vec3().to_array());
        for pose in &self.poses {
            key.spheres(&pose.spheres);
            for mesh in &pose.meshes {
                key.mesh(mesh);
            }
        }
        key.key()
    }

    fn steps(&self) -> usize {
        1 + self.spheres()
    }

    fn make(&self, _: &(dyn Fn(usize) + Sync)) -> Weights {
        Weights(of_poses(&self.poses, self.up))
    }

    fn kept(&self, kept: Weights) -> Option<Weights> {
        Some(kept).filter(|weights| weights.0.len() == self.spheres())
    }
}

impl Baked for Weights {
    const NAME: &str = "weights";
    const VERSION: u32 = WEIGHTS_VERSION;
    /// It holds 4096 weights.
    const MOST: u64 = 1 << 15;

    fn encoded(&self) -> Vec<u8> {
        self.0.iter().flat_map(|w| w.to_le_bytes()).collect()
    }

    fn decoded(bytes: &[u8]) -> Option<Self> {
        let weights = fours(bytes, f32::from_le_bytes)?;
        weights.iter().all(|w| *w >= 0.0).then_some(Self(weights))
    }
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
