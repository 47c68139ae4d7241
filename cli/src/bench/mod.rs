//! `gaunt bench`: how fast whole scenes are shaded, and how near that is to what the machine can do.

mod body;
mod frames;
mod peak;
mod rays;
mod scaling;
mod scenes;
mod world;

use crate::Error;
use crate::render::Backend;
use std::path::PathBuf;

/// What there is to run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Bench {
    /// Two characters fight between columns: 65,000 receivers, of them 24,000 moving, 244 spheres, 120 clusters
    Battle,
    /// A herd on a plain: 120,000 receivers, 500 spheres, 256 clusters
    Dino,
    /// How time and error grow with receivers and spheres, with the hierarchy of blockers and without
    Scaling,
    /// Shadows against ray casting: the time to the same error
    Rays,
}

/// How to run it.
#[derive(Clone, Debug)]
pub struct Options {
    /// What.
    pub bench: Bench,
    /// What shades the frames of a scene.
    pub backend: Backend,
    /// JSON instead of tables.
    pub json: bool,
    /// Where the chart of the comparison with rays goes.
    pub plot: Option<PathBuf>,
}

/// Runs a benchmark; the report as text.
///
/// # Errors
/// A sentence where options do not fit each other, there is no GPU where one is asked for, or a chart cannot be
/// written.
pub fn run(options: &Options) -> Result<String, Error> {
    if options.plot.is_some() && options.bench != Bench::Rays {
        return Err(Error::Usage(
            "--plot draws the comparison with rays: `gaunt bench rays --plot FILE.svg`".into(),
        ));
    }
    let moving = |name| frames::run(name, options.backend, options.json);
    match options.bench {
        Bench::Battle => moving(scenes::Name::Battle),
        Bench::Dino => moving(scenes::Name::Dino),
        Bench::Scaling => scaling::run(options.json),
        Bench::Rays => rays::run(options.json, options.plot.as_deref()),
    }
}
