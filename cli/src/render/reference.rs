//! A picture by the path tracer: the same samples, the same pixels, and the truth between them.

use crate::Error;
use crate::report::{Planned, Times};
use crate::truth::{self, Source, narrow};
use rayon::prelude::*;
use sh_cpu::{Gbuffer, Geometry, SampleLight, gbuffer, resolve};
use sh_reference::paths;
use sh_scene::{Scene, Tiles, View};

/// How the path tracer renders.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reference {
    /// Paths a pixel. Each of its samples gets an equal share, rounded up.
    pub paths: u32,
    /// How often bodies reflect; none for what the scene says.
    pub bounces: Option<u32>,
    /// Whether the ground reflects what arrives there, and not only what it would in the open.
    pub ground: bool,
    /// The light.
    pub light: Source,
}

impl Reference {
    fn options(&self, scene: &Scene) -> paths::Options {
        paths::Options {
            bounces: self
                .bounces
                .unwrap_or_else(|| truth::bounces(&scene.settings)),
            ground_reflects: self.ground,
            light: self.light.into(),
        }
    }

    fn paths_a_sample(&self) -> u32 {
        let samples = View::OVERSAMPLE * View::OVERSAMPLE;
        self.paths.div_ceil(samples)
    }

    /// What it does, in place of a plan's passes.
    pub(super) fn planned(&self, scene: &Scene) -> Vec<Planned> {
        let options = self.options(scene);
        let paths = self.paths_a_sample();
        let light = match options.bounces {
            0 => "direct light".into(),
            1 => "direct light and one bounce".into(),
            n => format!("direct light and {n} bounces"),
        };
        let source = match self.light {
            Source::Map => "the environment map as it is",
            Source::Projected => "the environment's spherical harmonics",
        };
        let ground = match (scene.ground, self.ground) {
            (None, _) => "there is no ground",
            (Some(_), false) => "bodies are all that reflects",
            (Some(_), true) => "the ground reflects too",
        };
        let pass = |pass, reason: &str| Planned {
            pass,
            reason: reason.into(),
        };
        vec![
            pass("gbuffer", "Every picture starts with what is seen."),
            pass(
                "paths",
                &format!(
                    "The truth was asked for: {paths} paths a sample, {light} of {source}; {ground}."
                ),
            ),
            pass("resolve", "Every picture ends as pixels."),
        ]
    }
}

/// Renders the scene as it stands. The picture is linear radiance, row by row from the top, the same for any number of
/// threads.
pub(super) fn picture(
    reference: &Reference,
    scene: &Scene,
    view: &View,
    times: &mut Times,
    progress: &(dyn Fn(f32) + Sync),
) -> Result<Vec<[f32; 3]>, Error> {
    let geometry = times.measure("hierarchy", || Geometry::new(scene))?;
    let tracer = times.measure("hierarchy", || {
        truth::tracer(scene, reference.options(scene))
    })?;
    let grid = view.samples();
    let tiles = grid.tiles();
    let mut pixels = vec![[0.0; 3]; view.width as usize * view.height as usize];
    let mut samples = Gbuffer::default();
    // One row of tiles after the other, so that memory stays small.
    let rows = Tiles::SIDE / View::OVERSAMPLE * view.width;
    for (row, pixels) in pixels.chunks_mut(rows as usize).enumerate() {
        let row = row as u32;
        times.measure("gbuffer", || {
            gbuffer(&geometry, view, grid, row..row + 1, &mut samples)
        })?;
        let first = (row * tiles.columns) as usize * Tiles::AREA;
        let paths = reference.paths_a_sample();
        let share = if scene.mirrors() { 0.5 } else { 1.0 };
        let tell = |part: f32| progress((row as f32 + share * part) / tiles.rows as f32);
        let found = times.measure("paths", || {
            truth::trace(&tracer, &samples.receivers, first, paths, &tell)
        });
        let radiance: Vec<[f32; 3]> = found.par_iter().map(|r| narrow(r.total())).collect();
        let mirrored = scene.mirrors().then(|| {
            let seen = (&samples.receivers[..], view.camera.eye.into());
            let tell = |part: f32| tell(1.0 + part);
            let found = times.measure("paths", || {
                truth::trace_mirrored(&tracer, seen, first, paths, &tell)
            });
            let narrowed = found.par_iter().map(|r| narrow(r.total()));
            narrowed.collect::<Vec<_>>()
        });
        times.measure("resolve", || {
            let environment = &scene.environment;
            let lit = SampleLight {
                radiance: &radiance,
                mirrored: mirrored.as_deref(),
            };
            resolve(view, row..row + 1, &samples, lit, environment, pixels)
        })?;
    }
    Ok(pixels)
}
