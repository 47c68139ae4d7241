//! The scene as rays and ours see it, and the frames of ours.

use super::cast::{Caster, Samples};
use super::{AROUND, CHUNK, EVERY, LIGHTS, MOMENT, ORDERS, Ours, Rays, equal, rms};
use crate::bench::capsule::Capsule;
use crate::bench::scenes::{Name, plan};
use crate::bench::world::World;
use gaunt::Error;
use glam::{Affine3A, Vec3A};
use rayon::prelude::*;
use sh_core::Routines;
use sh_cpu::{CutOptions, Cuts, Path, Shadow, shadow_clusters};
use sh_scene::{EnvironmentMap, Forest, Light, Limits, Receiver, Sky};
use std::time::Instant;

/// What the bodies of the scene are made of, where they are.
pub(super) fn capsules() -> Vec<Capsule> {
    let mut capsules = Vec::new();
    for body in &plan(Name::Battle).bodies {
        let mut poses: Vec<Affine3A> = Vec::new();
        body.pose(MOMENT, &mut poses);
        capsules.extend(body.capsules(&poses));
    }
    capsules
}

/// The sky, and what spherical harmonics make of it.
pub(super) struct Lights {
    pub(super) map: EnvironmentMap,
    pub(super) projected: Vec<Light>,
    order_4: [Vec3A; 16],
}

impl Lights {
    pub(super) fn new() -> Result<Self, Error> {
        let map = Sky::default().map(256, 128);
        let projected = ORDERS.map(|order| Light::project(&map, None, order, f32::INFINITY));
        let projected: Vec<Light> = projected.into_iter().collect::<Result<_, _>>()?;
        let order_4 = std::array::from_fn(|i| projected[1].coefficients[i].into());
        Ok(Self {
            map,
            projected,
            order_4,
        })
    }

    #[inline(always)]
    pub(super) fn of_order_4(&self, direction: Vec3A) -> Vec3A {
        let basis = <[f32; 16]>::basis(direction.to_array());
        let mut sum = Vec3A::ZERO;
        for (light, y) in self.order_4.iter().zip(basis) {
            sum += *light * y;
        }
        sum
    }

    pub(super) fn raw(&self, direction: Vec3A) -> Vec3A {
        self.map.sample(direction.into()).into()
    }

    /// Radiance of all lights from a direction.
    pub(super) fn all(&self, direction: Vec3A) -> [Vec3A; LIGHTS] {
        let basis = <[f32; 36]>::basis(direction.to_array());
        let mut all = [Vec3A::ZERO; LIGHTS];
        for (sum, light) in all.iter_mut().zip(&self.projected) {
            for (light, y) in light.coefficients.iter().zip(basis) {
                *sum += Vec3A::from(*light) * y;
            }
        }
        all[LIGHTS - 1] = self.raw(direction);
        all
    }
}

/// What rays and ours are given.
pub(super) struct Scene {
    pub(super) lights: Lights,
    pub(super) receivers: Vec<Receiver>,
    /// Which of the world's each of them is.
    pub(super) subset: Vec<usize>,
    pub(super) caster: Caster,
    pub(super) world: World,
}

impl Scene {
    /// At its moment, and the milliseconds of building the hierarchy for rays.
    pub(super) fn new() -> Result<(Self, f64), Error> {
        let mut world = World::new(plan(Name::Battle))?;
        world.pose(MOMENT);
        world.forest.update(&world.spheres);
        let capsules = capsules();
        let mut triangles = Vec::new();
        for capsule in &capsules {
            capsule.triangles(AROUND, &mut triangles);
        }
        let start = Instant::now();
        let caster = Caster::new(&triangles);
        let build_ms = start.elapsed().as_secs_f64() * 1e3;
        // What lies inside a body is seen by nobody.
        let seen = |r: &Receiver| {
            !capsules
                .iter()
                .any(|c| c.distance(r.position.into()) < -1e-4)
        };
        let subset: Vec<usize> = (0..world.receivers.len())
            .step_by(EVERY)
            .filter(|&i| seen(&world.receivers[i]))
            .collect();
        let scene = Self {
            lights: Lights::new()?,
            receivers: subset.iter().map(|&i| world.receivers[i]).collect(),
            subset,
            caster,
            world,
        };
        Ok((scene, build_ms))
    }

    pub(super) fn cast(&self, samples: &Samples) -> Vec<[Vec3A; LIGHTS]> {
        let shade =
            |(i, r): (usize, &Receiver)| self.caster.shade(r, i, samples, |d| self.lights.all(d));
        self.receivers.par_iter().enumerate().map(shade).collect()
    }

    /// Shades chunk after chunk and keeps the least seconds that each of them took.
    pub(super) fn time(
        &self,
        samples: &Samples,
        light: impl Fn(Vec3A) -> [Vec3A; 1] + Sync,
        least: &mut [f64],
    ) {
        let mut radiance = vec![[Vec3A::ZERO]; CHUNK];
        for (chunk, (receivers, least)) in self.receivers.chunks(CHUNK).zip(least).enumerate() {
            let start = Instant::now();
            radiance
                .par_iter_mut()
                .zip(receivers)
                .enumerate()
                .for_each(|(i, (radiance, r))| {
                    *radiance = self.caster.shade(r, chunk * CHUNK + i, samples, &light);
                });
            *least = least.min(start.elapsed().as_secs_f64());
            std::hint::black_box(&radiance);
        }
    }
}

/// One way of ours, at work.
pub(super) struct Frame {
    /// Which of [`ORDERS`] the light has.
    light: usize,
    accumulation: usize,
    cuts: Cuts,
    radiance: Vec<[f32; 3]>,
    seconds: f64,
}

impl Frame {
    pub(super) fn new(scene: &Scene, [order, accumulation]: [usize; 2]) -> Self {
        Self {
            light: order - ORDERS[0],
            accumulation,
            cuts: Cuts::default(),
            radiance: vec![[0.0; 3]; scene.world.receivers.len()],
            seconds: f64::INFINITY,
        }
    }

    pub(super) fn round(&mut self, scene: &Scene) -> Result<(), Error> {
        let mut forest = scene.world.forest.clone();
        let start = Instant::now();
        forest.update(&scene.world.spheres);
        self.shade(scene, &forest, Limits::default())?;
        self.seconds = self.seconds.min(start.elapsed().as_secs_f64());
        Ok(())
    }

    fn shade(&mut self, scene: &Scene, forest: &Forest, limits: Limits) -> Result<(), Error> {
        let world = &scene.world;
        let path = Path::best();
        let options = CutOptions {
            limits,
            ratios: true,
            accumulation: self.accumulation,
        };
        self.cuts
            .bound(&world.receivers, &world.clusters, 0..world.clusters.len());
        let light = &scene.lights.projected[self.light];
        self.cuts.find(path, forest, light, options);
        let shadow = Shadow {
            clusters: &world.clusters,
            cuts: &self.cuts,
            light,
            accumulation: self.accumulation,
            baked: None,
            eye: None,
        };
        shadow_clusters(path, &world.receivers, &shadow, &mut self.radiance)?;
        Ok(())
    }

    /// The radiance of the subset.
    fn looked_at(&self, scene: &Scene) -> Vec<[Vec3A; 1]> {
        let radiance = scene.subset.iter().map(|&i| [self.radiance[i].into()]);
        radiance.collect()
    }

    /// Of the subset, under the light's own order.
    pub(super) fn error(&self, scene: &Scene, truth: &[[Vec3A; LIGHTS]]) -> f64 {
        rms(&self.looked_at(scene), 0, truth, self.light)
    }

    pub(super) fn result(
        &self,
        scene: &Scene,
        truth: &[[Vec3A; LIGHTS]],
        rays: &[Rays],
    ) -> Result<Ours, Error> {
        let (light, raw) = (self.light, LIGHTS - 1);
        let mut leaves = Self::new(scene, [ORDERS[light], self.accumulation]);
        leaves.shade(scene, &scene.world.forest, Limits::LEAVES)?;
        let (leaves, looked_at) = (leaves.looked_at(scene), self.looked_at(scene));
        let ns = self.seconds * 1e9 / scene.world.receivers.len() as f64;
        let error = self.error(scene, truth);
        let raw_error = rms(&looked_at, 0, truth, raw);
        let curve = |light: usize, ns: fn(&Rays) -> f64| -> Vec<[f64; 3]> {
            let point = |r: &Rays| [f64::from(r.count), r.errors[light], ns(r)];
            rays.iter().map(point).collect()
        };
        Ok(Ours {
            order: ORDERS[light],
            accumulation: self.accumulation,
            error,
            raw_error,
            leaves: rms(&leaves, 0, truth, light),
            hierarchy: rms(&looked_at, 0, &leaves, 0),
            ns,
            equal: equal(&curve(light, |r| r.ns), error, ns),
            raw: equal(&curve(raw, |r| r.raw_ns), raw_error, ns),
        })
    }
}
