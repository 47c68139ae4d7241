//! `gaunt plan`: the passes that a scene calls for, why, and what each of them costs.

mod cpu;
mod effects;
mod estimate;
mod gpu;
mod report;

pub use report::{Idle, Memory, Planned, Report};

use crate::Error;
use crate::progress::Progress;
use crate::render::{self, Backend, Choice, Overrides, choose};
use sh_bake::{Cache, Loaded};
use sh_scene::{Changes, Plan, Scene, View};
use std::path::PathBuf;

/// Frames that are timed: the median is told.
const FRAMES: usize = 5;

/// Frames of a second of motion.
const RATE: f64 = 30.0;

/// Which scene, and what is to be told of it.
#[derive(Clone, Debug)]
pub struct Options {
    /// A scene file; none for the built-in scene.
    pub scene: Option<PathBuf>,
    /// What computes.
    pub backend: Backend,
    /// Width and height, in pixels.
    pub size: [u32; 2],
    /// Settings instead of the scene's.
    pub settings: Overrides,
    /// JSON instead of a table.
    pub json: bool,
    /// The cost of the scene as effects are switched on one by one, instead of its plan.
    pub effects: bool,
    /// Where sphere sets are kept.
    pub cache: Option<Cache>,
}

impl Default for Options {
    /// The built-in scene, 1280 by 720.
    fn default() -> Self {
        Self {
            scene: None,
            backend: Backend::Auto,
            size: [1280, 720],
            settings: Overrides::default(),
            json: false,
            effects: false,
            cache: None,
        }
    }
}

/// What a backend found: of each pass of the plan, and of the frame.
struct Measured {
    /// Dispatches or tasks of each pass.
    dispatches: Vec<u64>,
    /// Milliseconds of each pass.
    ms: Vec<f64>,
    /// Of the whole frame: the middle, and by how much a half of all frames differ from it.
    frame_ms: [f64; 2],
    memory: Vec<sh_scene::Buffer>,
    /// Of a frame after the first.
    changes: Changes,
    idle: Vec<Idle>,
    /// How times were taken.
    clock: &'static str,
}

/// Plans a scene, runs some frames of it, and tells what came out; the text has no newline at its end.
///
/// # Errors
/// Where the scene cannot be loaded or a backend that was asked for is not there.
pub fn run(options: &Options) -> Result<String, Error> {
    let progress = Progress::new("loading the scene");
    let loaded = render::load(
        &render::Options {
            scene: options.scene.clone(),
            settings: options.settings,
            cache: options.cache.clone(),
            ..render::Options::default()
        },
        &progress,
    )?;
    let choice = choose(options.backend)?;
    progress.say("running frames");
    let text = match options.effects {
        true => effects::table(loaded, &choice, options)?,
        false => {
            let report = report(loaded, &choice, options)?;
            match options.json {
                true => serde_json::to_string_pretty(&report)?,
                false => report.to_string(),
            }
        }
    };
    progress.finish();
    Ok(text)
}

/// The plan of a scene and what its frames cost.
fn report(mut loaded: Loaded, choice: &Choice, options: &Options) -> Result<Report, Error> {
    let plan = Plan::new(&loaded.scene);
    let view = view(&loaded.scene, options.size);
    let name = match &options.scene {
        Some(path) => path.display().to_string(),
        None => "the built-in scene".into(),
    };
    let estimates = estimate::of(&plan, &loaded.scene, &view);
    let measured = measure(&mut loaded, &plan, &view, choice)?;
    Ok(Report::new(name, &plan, &view, choice, measured, estimates))
}

/// Runs frames of a scene: the first, which makes what all others keep, and then those that are timed.
fn measure(
    loaded: &mut Loaded,
    plan: &Plan,
    view: &View,
    choice: &Choice,
) -> Result<Measured, Error> {
    match &choice.gpu {
        Some(gpu) => gpu::measure(gpu, loaded, plan, view),
        None => cpu::measure(loaded, plan, view),
    }
}

fn view(scene: &Scene, [width, height]: [u32; 2]) -> View {
    View {
        camera: scene.camera,
        width,
        height,
    }
}

/// Puts the scene where it is in a frame.
fn pose(loaded: &mut Loaded, frame: usize) {
    if !loaded.motion.is_still() {
        let seconds = frame as f64 / RATE;
        loaded.motion.pose(seconds, &mut loaded.scene);
    }
}

/// The middle one, by size, and half the distance between a quarter from below and one from above.
fn middle_and_spread(mut values: Vec<f64>) -> [f64; 2] {
    values.sort_by(f64::total_cmp);
    let at = |quarter: usize| {
        let last = values.len().saturating_sub(1);
        values.get(last * quarter / 4).copied().unwrap_or(0.0)
    };
    [median(values.clone()), 0.5 * (at(3) - at(1))]
}

/// The middle one, by size.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}

/// What of the tree and the light was no work.
fn idle(scene: &Scene, plan: &Plan, changes: &Changes, nodes: usize) -> Vec<Idle> {
    let mut all = Vec::new();
    let mut add = |name, reason| all.push(Idle { name, reason });
    let shadows = plan.has(&sh_scene::passes::SHADOW);
    let still = scene.objects.len().saturating_sub(changes.objects);
    if shadows && still > 0 {
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
