//! A scene of bodies in motion: what a host keeps from frame to frame.

use super::body::{self, placed, placed_sphere};
use super::scenes::{Lamp, Plan};
use super::sent::Sent;
use super::surface::Surface;
use gaunt::Error;
use glam::{Affine3A, Quat, Vec3};
use rayon::prelude::*;
use sh_core::Routines;
use sh_cpu::{CutOptions, Cuts, Path, Shadow, shadow_clusters};
use sh_scene::{
    AreaLight, AreaShape, Clusters, Distribution, Forest, Light, Limits, Receiver, Sky, Sphere,
    ringing,
};
use std::ops::Range;
use std::time::Instant;

/// SH order of light and shadows.
pub const ORDER: usize = 4;

/// What each part of a frame is called, in order.
pub const STAGES: [&str; 8] = [
    "motion",
    "tree",
    "light",
    "light_update",
    "cut",
    "shadow",
    "light_cut",
    "light_gather",
];

/// Which of [`STAGES`] shades the receivers directly.
pub const SHADOW: usize = 5;

/// Which of them finds the order of lights.
pub const ORDER_OF_LIGHTS: usize = 6;

/// Which of them gathers what spheres send on.
pub const GATHER: usize = 7;

/// Receivers that a task moves.
const CHUNK: usize = 1024;

/// A scene and everything that its frames need.
pub struct World {
    /// All receivers where they are now, cluster by cluster, those that move first.
    pub receivers: Vec<Receiver>,
    /// The clusters.
    pub clusters: Vec<Range<usize>>,
    /// All blocker spheres where they are now.
    pub spheres: Vec<Sphere>,
    /// The tree over them.
    pub forest: Forest,
    /// The light as it is now.
    pub light: Light,
    /// The blockers of each cluster.
    pub cuts: Cuts,
    /// How coarse cuts may be.
    pub limits: Limits,
    /// What a frame computes: light that comes directly.
    pub radiance: Vec<[f32; 3]>,
    /// Light that comes by way of spheres, where the scene sends it on.
    pub sent: Option<Sent>,
    moving_clusters: usize,
    moving: Vec<(u32, Receiver)>,
    rest: Vec<(u32, Sphere)>,
    plan: Plan,
    poses: Vec<Affine3A>,
    sky: Light,
    lamps: Vec<AreaLight>,
}

impl World {
    /// The scene at its beginning.
    ///
    /// # Errors
    /// Where light cannot be made of the sky, which does not happen.
    pub fn new(plan: Plan) -> Result<Self, Error> {
        let mut rest = Vec::new();
        let mut counts = Vec::new();
        let (mut moving, mut still) = (Vec::new(), Vec::new());
        let mut clusters = Vec::new();
        let mut poses = Vec::new();
        let mut surfaces = Vec::new();
        let mut first = 0;
        for (object, body) in plan.bodies.iter().enumerate() {
            let at = poses.len();
            body.pose(0.0, &mut poses);
            let parts = body.parts(object as u32 + 1);
            counts.push(parts.spheres.len());
            if plan.indirect.is_some() {
                surfaces.push(Surface::new(body, &parts, &poses[at..]));
            }
            let named = |segment: usize| (at + segment) as u32;
            rest.extend(parts.spheres.iter().map(|(s, sphere)| (named(*s), *sphere)));
            let on: Vec<(u32, Receiver)> = parts
                .receivers
                .iter()
                .map(|(s, receiver)| (named(*s), *receiver))
                .collect();
            let placed: Vec<Receiver> = on
                .iter()
                .map(|(s, r)| placed(r, &poses[*s as usize]))
                .collect();
            let groups = Clusters::new(&placed, body.clusters);
            if body.pace > 0.0 {
                moving.extend(groups.sorted(&on));
                let ranges = groups.ranges.iter().map(|r| r.start + first..r.end + first);
                clusters.extend(ranges);
                first += on.len();
            } else {
                still.push((groups.sorted(&placed), groups.ranges));
            }
        }
        for face in &plan.faces {
            let on = face.receivers();
            let groups = Clusters::new(&on, face.clusters);
            still.push((groups.sorted(&on), groups.ranges));
        }
        let moving_clusters = clusters.len();
        let mut receivers: Vec<Receiver> = moving
            .iter()
            .map(|(s, r)| placed(r, &poses[*s as usize]))
            .collect();
        for (on, ranges) in still {
            clusters.extend(ranges.iter().map(|r| r.start + first..r.end + first));
            first += on.len();
            receivers.extend(on);
        }
        let spheres: Vec<Sphere> = rest
            .iter()
            .map(|(s, sphere)| placed_sphere(sphere, &poses[*s as usize]))
            .collect();
        let sky = Light::project(&Sky::default().map(256, 128), None, ORDER, f32::INFINITY)?;
        let lamp = |lamp: &Lamp| AreaLight {
            // The width is looked for once, not every frame.
            window: Some(ringing::of_small_light(ORDER)),
            distribution: (lamp.spread).and_then(|s| Distribution::cap(Vec3::NEG_Y, s).ok()),
            ..AreaLight::local(Vec3::new(0.0, 4.0, 0.0), lamp.radius, lamp.radiance)
        };
        let mut world = Self {
            radiance: vec![[0.0; 3]; receivers.len()],
            forest: Forest::weighted(&spheres, &body::weights(&plan.bodies), &counts),
            light: sky.clone(),
            cuts: Cuts::default(),
            limits: Limits::default(),
            lamps: plan.lamps.iter().map(lamp).collect(),
            sent: plan
                .indirect
                .map(|indirect| Sent::new(indirect, surfaces, receivers.len())),
            receivers,
            moving_clusters,
            clusters,
            spheres,
            moving,
            rest,
            plan,
            poses,
            sky,
        };
        world.turn_light(0.0)?;
        Ok(world)
    }

    /// How many receivers move.
    pub fn moving(&self) -> usize {
        self.moving.len()
    }

    /// Computes the frame at a time on the CPU; the milliseconds of each of [`STAGES`], 0 of those that the scene has no
    /// need of. Spread over the threads of the current rayon pool.
    ///
    /// # Errors
    /// Where the pass refuses what it is given, which does not happen.
    pub fn frame(&mut self, path: Path, seconds: f32) -> Result<[f64; STAGES.len()], Error> {
        let mut spent = [0.0; STAGES.len()];
        spent[..3].copy_from_slice(&self.set_out(seconds)?);
        if let Some(sent) = &mut self.sent {
            timed(&mut spent[3], || {
                sent.update(path, &self.forest, &self.light, self.limits)
            })?;
        }
        timed(&mut spent[4], || self.find_cuts(path));
        timed(&mut spent[SHADOW], || self.shade(path))?;
        if let Some(sent) = &mut self.sent {
            let (receivers, clusters) = (&self.receivers, &self.clusters);
            timed(&mut spent[ORDER_OF_LIGHTS], || {
                sent.find(path, receivers, clusters, &self.forest, self.limits);
            });
            timed(&mut spent[GATHER], || {
                sent.gather(path, receivers, clusters)
            })?;
        }
        Ok(spent)
    }

    /// Moves everything to where it is at a time; the milliseconds of the first three of [`STAGES`].
    ///
    /// # Errors
    /// As [`World::new`].
    pub fn set_out(&mut self, seconds: f32) -> Result<[f64; 3], Error> {
        let mut spent = [0.0; 3];
        timed(&mut spent[0], || self.pose(seconds));
        timed(&mut spent[1], || self.forest.update(&self.spheres));
        timed(&mut spent[2], || self.turn_light(seconds))?;
        Ok(spent)
    }

    /// Moves receivers and spheres.
    pub fn pose(&mut self, seconds: f32) {
        self.poses.clear();
        for body in &self.plan.bodies {
            body.pose(seconds, &mut self.poses);
        }
        let poses = &self.poses;
        self.receivers[..self.moving.len()]
            .par_chunks_mut(CHUNK)
            .zip(self.moving.par_chunks(CHUNK))
            .for_each(|(now, rest)| {
                for (now, (segment, rest)) in now.iter_mut().zip(rest) {
                    *now = placed(rest, &poses[*segment as usize]);
                }
            });
        for (now, (segment, rest)) in self.spheres.iter_mut().zip(&self.rest) {
            *now = placed_sphere(rest, &poses[*segment as usize]);
        }
        if let Some(sent) = &mut self.sent {
            sent.pose(poses);
        }
    }

    /// Turns the sky and moves the lamps.
    ///
    /// # Errors
    /// As [`World::new`].
    pub fn turn_light(&mut self, seconds: f32) -> Result<(), Error> {
        let turn = Quat::from_rotation_y(0.2 * seconds).to_array();
        for channel in 0..3 {
            let mut f = [0.0; ORDER * ORDER];
            for (f, sky) in f.iter_mut().zip(&self.sky.coefficients) {
                *f = sky[channel];
            }
            for (light, f) in self.light.coefficients.iter_mut().zip(f.rotate(turn)) {
                light[channel] = f;
            }
        }
        self.light.emitters.clear();
        for (i, lamp) in self.lamps.iter_mut().enumerate() {
            let angle = 0.7 * seconds + 3.0 * i as f32;
            if let AreaShape::Local { center, .. } = &mut lamp.shape {
                *center = Vec3::new(3.0 * angle.sin(), 3.5, 3.0 * angle.cos());
            }
            self.light.emitters.push(lamp.emitter(ORDER)?);
        }
        Ok(())
    }

    /// Finds the blockers of every cluster.
    pub fn find_cuts(&mut self, path: Path) {
        let options = CutOptions {
            limits: self.limits,
            ratios: true,
            accumulation: ORDER,
        };
        let Self {
            cuts,
            receivers,
            clusters,
            ..
        } = self;
        // Those that stand still are measured once.
        let all = clusters.len();
        let which = if cuts.clusters() == all {
            0..self.moving_clusters
        } else {
            0..all
        };
        cuts.bound(receivers, clusters, which);
        cuts.dim(&self.light);
        cuts.find(path, &self.forest, &self.light, options);
    }

    /// Shades every receiver.
    ///
    /// # Errors
    /// Where the pass refuses what it is given, which does not happen.
    pub fn shade(&mut self, path: Path) -> Result<(), Error> {
        let shadow = Shadow {
            clusters: &self.clusters,
            cuts: &self.cuts,
            light: &self.light,
            accumulation: ORDER,
            baked: None,
            eye: None,
        };
        shadow_clusters(path, &self.receivers, &shadow, &mut self.radiance)?;
        Ok(())
    }
}

/// Runs `work` and writes the milliseconds it took.
fn timed<T>(spent: &mut f64, work: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let result = work();
    *spent = start.elapsed().as_secs_f64() * 1e3;
    result
}
