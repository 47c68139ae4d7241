//! What the passes of a plan should take on the CPU, from the number of operations: before anything has run.
//!
//! Operations of SH routines are those that the generator counts (`gaunt ops`); a receiver's blockers are counted in the
//! cuts of places on the bodies. The rest are round figures, measured once with `gaunt plan` on an x86-64 with AVX-512. An
//! estimate is right within a factor of two or three: it says which pass will be the expensive one.

use crate::ops;
use glam::Vec3;
use sh_cpu::{Path, lane_count, multiply_adds_per_second};
use sh_scene::basis::PATCH_SAMPLES;
use sh_scene::plan::Units;
use sh_scene::surface::DIRECTIONS;
use sh_scene::{BasisBody, Domain, Forest, Grid, LightViews, Object, Plan, Planned, Scene, View};

/// Places at which cuts are counted.
const PLACES: usize = 64;

/// The share of the peak that shading reaches: `gaunt-lab bench battle` tells the inner loop's.
const SHARE: f64 = 0.3;

/// The share of samples that half resolution does not do for.
const ANEW: f64 = 0.1;

/// Multiply-adds of what one sphere sends to a receiver, for each that may hide a part of it.
const HIDER: f64 = 60.0;

/// Patches and regions of a body that a receiver looks at, and multiply-adds of each.
const SEEN: f64 = 64.0;
const PATCH: f64 = 40.0;

/// Milliseconds of each pass of a plan on the current pool of threads.
pub(super) fn of(plan: &Plan, scene: &Scene, view: &View) -> Vec<f64> {
    let threads = rayon::current_num_threads() as f64;
    let path = Path::best();
    let rate = multiply_adds_per_second(path) * lane_share(path) * SHARE;
    let units = units(plan, scene);
    let passes = plan.passes.iter();
    passes
        .map(|planned| seconds(planned, &units, scene, view, rate) * 1e3 / threads)
        .collect()
}

/// The peak is measured on the widest registers, which is what shading runs on as well.
fn lane_share(path: Path) -> f64 {
    if lane_count(path) > 1 { 1.0 } else { 0.5 }
}

/// What parts of a receiver's work cost in this scene.
fn units(plan: &Plan, scene: &Scene) -> Units {
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
    let blockers = match plan.is_blocked() {
        true => cut(scene),
        false => 0.0,
    };
    let blocker = of("accumulate_blocker", accumulation) + 30.0;
    let exponential = of("transfer", accumulation) + of("accumulated_log", accumulation);
    let bodies = BasisBody::all(&scene.objects).count() as f64;
    let functions = BasisBody::all(&scene.objects).map(|body| body.basis.count());
    let functions = functions.max().unwrap_or(0) as f64;
    Units {
        open: light,
        shadow: light + exponential + blockers * blocker,
        gather: blockers * (of("ball_average", order) + 3.0 * coefficients + 8.0 * HIDER),
        patches: bodies * (SEEN * PATCH + blockers * HIDER),
        weigh: functions * 2.0 * 3.0 * (1.0 + PATCH_SAMPLES as f64),
        send: 3.0 * (DIRECTIONS as f64 * coefficients + of("rotate", order)),
    }
}

/// Seconds of a pass on one thread that does `rate` multiply-adds a second.
fn seconds(planned: &Planned, units: &Units, scene: &Scene, view: &View, rate: f64) -> f64 {
    let of_objects = |count: &dyn Fn(&Object) -> usize| -> f64 {
        let counts = scene.objects.iter().map(count);
        counts.sum::<usize>() as f64
    };
    let cells = |grid: Grid| f64::from(grid.columns) * f64::from(grid.rows);
    let elements = match planned.at {
        Domain::Scene => 1.0,
        Domain::Points => of_objects(&|o| o.surface.points.len()),
        Domain::Patches => BasisBody::all(&scene.objects)
            .map(|body| body.basis.patches() as f64)
            .sum(),
        Domain::Views => {
            let views = LightViews::count(&scene.punctual);
            (views * LightViews::side(views).pow(2)) as f64
        }
        Domain::Spheres => of_objects(&|o| o.spheres.len()),
        Domain::Halves => cells(view.halves()),
        Domain::Receivers | Domain::Samples | Domain::Pixels => cells(view.samples()),
        Domain::Rest => ANEW * cells(view.samples()),
        // As if objects were all as large.
        Domain::Gloss => {
            let glossy = scene.objects.iter().filter(|o| o.mirrors());
            let share = glossy.count() as f64 / scene.objects.len().max(1) as f64;
            share * cells(view.samples())
        }
    };
    let cost = (planned.pass.cost)(units);
    let turns = planned.turns.len() as f64;
    turns * elements * (cost.nanoseconds * 1e-9 + cost.multiply_adds / rate)
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
