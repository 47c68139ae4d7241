//! What frames of a plan were, on either backend.

use serde::Serialize;
use sh_bake::Loaded;
use sh_scene::passes::LIGHT_UPDATE;
use sh_scene::{Changes, Plan, Scene};

/// Frames that are timed: the median is told.
pub(super) const FRAMES: usize = 5;

/// Frames of a second of motion.
const RATE: f64 = 30.0;

/// Something that there is no work for, and why.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Idle {
    /// What.
    pub name: &'static str,
    /// A sentence.
    pub reason: String,
}

/// What a backend found: of each pass of the plan, and of the frame.
pub(super) struct Measured {
    /// Dispatches or tasks of each pass.
    pub dispatches: Vec<u64>,
    /// Milliseconds of each pass.
    pub ms: Vec<f64>,
    /// Of the whole frame: the middle, and by how much a half of all frames differ from it.
    pub frame_ms: [f64; 2],
    pub memory: Vec<sh_scene::Buffer>,
    /// Of a frame after the first.
    pub changes: Changes,
    pub idle: Vec<Idle>,
    /// How times were taken.
    pub clock: &'static str,
}

/// Puts the scene where it is in a frame.
pub(super) fn pose(loaded: &mut Loaded, frame: usize) {
    if !loaded.motion.is_still() {
        let seconds = frame as f64 / RATE;
        loaded.motion.pose(seconds, &mut loaded.scene);
    }
}

/// The middle one, by size, and half the distance between a quarter from below and one from above.
pub(super) fn middle_and_spread(mut values: Vec<f64>) -> [f64; 2] {
    values.sort_by(f64::total_cmp);
    let at = |quarter: usize| {
        let last = values.len().saturating_sub(1);
        values.get(last * quarter / 4).copied().unwrap_or(0.0)
    };
    [median(values.clone()), 0.5 * (at(3) - at(1))]
}

/// The middle one, by size.
pub(super) fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}

/// That what spheres send on was no work, if it was none.
pub(super) fn kept(plan: &Plan, tasks: &[u64]) -> Option<Idle> {
    let mut passes = plan.passes.iter().zip(tasks);
    let idle = passes.any(|(planned, tasks)| planned.is(&LIGHT_UPDATE) && *tasks == 0);
    let reason = "No body moved and no light changed: spheres send on what they did before.";
    idle.then(|| Idle {
        name: LIGHT_UPDATE.name,
        reason: reason.into(),
    })
}

/// What of the tree and the light was no work.
pub(super) fn idle(scene: &Scene, plan: &Plan, changes: &Changes, nodes: usize) -> Vec<Idle> {
    let mut all = Vec::new();
    let mut add = |name, reason| all.push(Idle { name, reason });
    let blocked = plan.is_blocked();
    let still = scene.objects.len().saturating_sub(changes.objects);
    if blocked && still > 0 {
        let (objects, renewed) = (scene.objects.len(), changes.nodes);
        add(
            "blockers",
            format!(
                "{still} of {objects} objects did not move: {renewed} of {nodes} nodes of the tree are renewed."
            ),
        );
    }
    if changes.projections == 0 {
        add(
            "light",
            "The environment did not change: it is not projected again.".into(),
        );
    }
    let lamps = scene.lights.len().saturating_sub(changes.lamps);
    if lamps > 0 {
        add(
            "lamps",
            format!("{lamps} of {} did not change.", scene.lights.len()),
        );
    }
    all
}
