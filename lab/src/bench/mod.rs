//! `gaunt-lab bench`: how fast whole scenes are shaded, and how near that is to what the machine can do.

mod body;
mod capsule;
mod device;
mod frames;
mod lights;
mod peak;
mod rays;
mod rooms;
mod scaling;
mod scenes;
mod sent;
mod surface;
mod times;
mod world;

use gaunt::Error;
use gaunt::render::Backend;
use std::path::PathBuf;

/// What there is to run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Bench {
    /// Two characters fight between columns: 65,000 receivers, of them 24,000 moving, 244 spheres, 120 clusters
    Battle,
    /// A herd on a plain: 120,000 receivers, 500 spheres, 256 clusters
    Dino,
    /// A squirrel and balls slide down a ramp and light each other: 21,000 receivers, 14 lights, 25 clusters
    Squirrel,
    /// A robot walks and lights itself and the ground: 25,000 receivers, 26 lights, 68 clusters
    Robot,
    /// Two packages deform and light each other: 10,000 receivers, 16 lights, 18 clusters
    Packages,
    /// Moving things of a plant light each other: 21,000 receivers, 38 lights and a lamp, 40 clusters
    Assembly,
    /// How time and error grow with receivers and spheres, with the hierarchy of blockers and without
    Scaling,
    /// Shadows against ray casting: the time to the same error
    Rays,
    /// What more spheres that send light on cost, by what hides them
    Lights,
    /// A room of twelve bodies that send light to and fro by patches: 50,000 receivers, 3 bounces
    Room,
    /// Thirty pots on the floor of a room: 122,000 receivers
    Teapots,
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
    /// Where the chart goes that the comparison with rays or that of lights draws.
    pub plot: Option<PathBuf>,
}

/// Runs a benchmark; the report as text.
///
/// # Errors
/// A sentence where options do not fit each other, there is no GPU where one is asked for, or a chart cannot be
/// written.
pub fn run(options: &Options) -> Result<String, Error> {
    if options.plot.is_some() && !matches!(options.bench, Bench::Rays | Bench::Lights) {
        return Err(Error::Usage(
            "--plot draws what `gaunt-lab bench rays` and `gaunt-lab bench lights` measure".into(),
        ));
    }
    let moving = |name| frames::run(name, options.backend, options.json);
    match options.bench {
        Bench::Battle => moving(scenes::Name::Battle),
        Bench::Dino => moving(scenes::Name::Dino),
        Bench::Squirrel => moving(scenes::Name::Squirrel),
        Bench::Robot => moving(scenes::Name::Robot),
        Bench::Packages => moving(scenes::Name::Packages),
        Bench::Assembly => moving(scenes::Name::Assembly),
        Bench::Scaling => scaling::run(options.json),
        Bench::Rays => rays::run(options.json, options.plot.as_deref()),
        Bench::Lights => lights::run(options.json, options.plot.as_deref()),
        Bench::Room => rooms::run("room", crate::rooms::room, options.json),
        Bench::Teapots => rooms::run("teapots", crate::rooms::teapots, options.json),
    }
}
