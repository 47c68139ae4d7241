//! `gaunt plan`: the passes that a scene calls for, why, and what each of them costs.

mod backend;
mod cpu;
mod effects;
mod estimate;
mod gpu;
mod measured;
mod options;
mod report;

pub use measured::Idle;
pub use options::Options;
pub use report::{Memory, Planned, Report};

use crate::Error;
use crate::progress::Progress;
use crate::render::{self, Choice, choose};
use backend::{measure, view};
use sh_bake::Loaded;
use sh_scene::Plan;

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
