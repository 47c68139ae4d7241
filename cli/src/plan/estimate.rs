//! What the passes of a plan should take on the CPU, from the number of operations: before anything has run.
//!
//! Operations of SH routines are those that the generator counts (`gaunt ops`); a receiver's blockers are counted in the
//! cuts of places on the bodies. The rest are round figures, measured once with `gaunt plan` on an x86-64 with AVX-512. An
//! estimate is right within a factor of two or three: it says which pass will be the expensive one.

use crate::ops;
use glam::Vec3;
use sh_cpu::{Path, lane_count, multiply_adds_per_second};
use sh_scene::{Forest, Pass, PassKind, Plan, Resolution, Scene, View};

/// Places at which cuts are counted.
const PLACES: usize = 64;

/// The share of the peak that shading reaches: `gaunt-lab bench battle` tells the inner loop's.
const SHARE: f64 = 0.3;

/// Nanoseconds of a ray that is cast.
const RAY: f64 = 450.0;

/// Nanoseconds of a sample that is put together from half resolution, and of one that becomes a part of a pixel.
const SAMPLE: f64 = 60.0;

/// The share of samples that half resolution does not do for.
const ANEW: f64 = 0.1;

/// Multiply-adds of what one sphere sends to a receiver, for each that may hide a part of it.
const HIDER: f64 = 60.0;

/// Milliseconds of each pass of a plan on the current pool of threads.
pub(super) fn of(plan: &Plan, scene: &Scene, view: &View) -> Vec<f64> {
    let threads = rayon::current_num_threads() as f64;
    let path = Path::best();
    let rate = multiply_adds_per_second(path) * lane_share(path) * SHARE;
    let cost = Cost::of(plan, scene);
    let passes = plan.passes.iter();
    passes
        .map(|pass| cost.seconds(pass, scene, view, rate) * 1e3 / threads)
        .collect()
}

/// The peak is measured on the widest registers, which is what shading runs on as well.
fn lane_share(path: Path) -> f64 {
    if lane_count(path) > 1 { 1.0 } else { 0.5 }
}

/// Multiply-adds a receiver.
struct Cost {
    /// In the open.
    open: f64,
    /// Through all blockers of its cut.
    shadow: f64,
    /// Of what spheres send.
    gather: f64,
}

impl Cost {
    fn of(plan: &Plan, scene: &Scene) -> Self {
        let settings = scene.settings;
        let (order, accumulation) = (settings.order, settings.accumulation);
        let counts = ops::counts();
        let of = |routine: &str, order: usize| {
            let found = counts
                .iter()
                .find(|c| c.routine == routine && c.order == order);
            found.map_or(0.0, |count| count.mul.max(count.add) as f64)
        };
        let coefficients = (order * order) as f64;
        let lamps = scene.lights.iter().filter(|lamp| lamp.shines()).count() as f64;
        let lamp = of("cap_visibility", order) + of("zonal", order) + 2.0 * coefficients + 30.0;
        let light = of("cosine", order) + 6.0 * coefficients + lamps * lamp;
        let blockers = match plan.has(PassKind::Shadow) {
            true => cut(scene),
            false => 0.0,
        };
        let blocker = of("accumulate_blocker", accumulation) + 30.0;
        let exponential = of("transfer", accumulation) + of("accumulated_log", accumulation);
        Self {
            open: light,
            shadow: light + exponential + blockers * blocker,
            gather: blockers * (of("ball_average", order) + 3.0 * coefficients + 8.0 * HIDER),
        }
    }

    fn seconds(&self, pass: &Pass, scene: &Scene, view: &View, rate: f64) -> f64 {
        let cells = match pass.at {
            Resolution::Halves => view.halves(),
            _ => view.samples(),
        };
        let cells = f64::from(cells.columns) * f64::from(cells.rows);
        let points: usize = scene.objects.iter().map(|o| o.surface.points.len()).sum();
        let points = points as f64;
        let bounces = scene.settings.indirect.map_or(0, |i| i.bounces);
        match pass.kind {
            PassKind::Gbuffer => cells * RAY * 1e-9,
            PassKind::Irradiance => cells * self.open / rate,
            PassKind::Shadow => cells * self.shadow / rate,
            PassKind::LightGather => cells * self.gather / rate,
            PassKind::LightUpdate => {
                let more = f64::from(bounces.saturating_sub(1));
                points * (self.shadow + more * self.gather) / rate
            }
            PassKind::Upsample => {
                let gather = if bounces > 0 { self.gather } else { 0.0 };
                let anew = ANEW * (self.shadow + gather);
                cells * (SAMPLE * 1e-9 + (self.open + anew) / rate)
            }
            PassKind::Resolve => cells * SAMPLE * 1e-9,
        }
    }
}

/// The mean size of a cut, at places above some of the spheres.
fn cut(scene: &Scene) -> f64 {
    let forest: Forest = scene.forest();
    let spheres = scene.world_spheres();
    let step = spheres.len().div_ceil(PLACES).max(1);
    let (mut places, mut nodes) = (0, 0);
    for sphere in spheres.iter().step_by(step) {
        let place = Vec3::from(sphere.center) + Vec3::Y * sphere.radius;
        places += 1;
        let (radius, limits) = (sphere.radius, scene.settings.limits);
        forest.cut(place, radius, limits, |_| nodes += 1);
    }
    f64::from(nodes) / f64::from(places.max(1))
}
