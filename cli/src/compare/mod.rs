//! `gaunt compare`: a scene by the passes and by the path tracer, side by side and in figures.
//!
//! | module | does |
//! |---|---|
//! | `view` | one receiver a pixel |
//! | `ours` | their light by the passes |
//! | `twice` | their light by the path tracer, in two independent halves |
//! | `half` | what half resolution gives away |
//! | `measure` | figures of the difference |
//! | `balls`, `pictures`, `sheet` | the spheres, and all pictures on one sheet |

pub mod balls;
mod comparison;
mod half;
mod measure;
pub mod ours;
pub mod pictures;
mod print;
pub mod sheet;
pub mod twice;
mod view;

pub use comparison::Comparison;
pub use measure::{Figures, Parts, Radiance, scale};
pub use view::Seen;

use crate::Error;
use crate::image::{Output, exposure};
use crate::progress::Progress;
use crate::render::{self, Overrides};
use crate::truth::{self, Source};
use ours::Ours;
use pictures::Pictures;
use sh_bake::Cache;
use sh_reference::paths;
use std::path::PathBuf;
use std::time::Instant;
use twice::Truth;

/// What to compare and how.
#[derive(Clone, Debug)]
pub struct Options {
    /// A scene file; none for the built-in scene.
    pub scene: Option<PathBuf>,
    /// Where the sheet goes, a PNG file; none for figures alone.
    pub out: Option<PathBuf>,
    /// Figures as JSON instead of a table.
    pub json: bool,
    /// Width and height of each picture, in pixels, of which each is a receiver.
    pub size: [u32; 2],
    /// Paths a receiver, at least 2: they are two independent halves.
    pub paths: u32,
    /// How often bodies reflect in the truth; none for what the scene says.
    pub bounces: Option<u32>,
    /// The light of the truth.
    pub light: Source,
    /// Settings instead of the scene's.
    pub settings: Overrides,
    /// Where sphere sets are kept, and taken from if they are there; none to fit them anew.
    pub cache: Option<Cache>,
}

/// Compares, writes the sheet if asked for one, and returns the text to print.
///
/// # Errors
/// Where the scene cannot be loaded or rendered, or the sheet cannot be written.
pub fn run(options: &Options) -> Result<String, Error> {
    let comparison = compare(options)?;
    if options.json {
        return Ok(serde_json::to_string_pretty(&comparison)?);
    }
    Ok(print::table(&comparison))
}

/// The comparison itself.
///
/// # Errors
/// As [`run`].
pub fn compare(options: &Options) -> Result<Comparison, Error> {
    let most = sh_cpu::MAX_SIDE / 2;
    if options.size.iter().any(|side| *side > most) {
        return Err(Error::Usage(format!(
            "--size is {} x {}, but each side of a comparison's pictures must be at most {most} pixels",
            options.size[0], options.size[1]
        )));
    }
    let out = options.out.as_deref();
    let output = out
        .map(|file| sheet::check(file).and_then(|()| Output::create(file)))
        .transpose()?;
    let progress = Progress::new("loading the scene");
    let loading = render::Options {
        scene: options.scene.clone(),
        settings: options.settings,
        cache: options.cache.clone(),
        ..render::Options::default()
    };
    let scene = render::load(&loading, &progress)?.scene;
    let settings = &scene.settings;
    let light = scene.light()?;
    let seen = Seen::new(&scene, options.size)?;

    let start = Instant::now();
    let Ours {
        parts: ours,
        emission,
    } = ours::ours(&scene, &seen)?;
    let seconds_ours = start.elapsed().as_secs_f64();
    let half_resolution = half::half(&scene, &seen)?;

    progress.say("tracing paths");
    let start = Instant::now();
    let bounces = options.bounces.unwrap_or_else(|| truth::bounces(settings));
    let halves = if scene.ground.is_some() { 2 } else { 1 };
    let truth = |ground_reflects: bool| {
        let first = f32::from(u8::from(ground_reflects));
        let tell = |part: f32| progress.set((first + part) / halves as f32);
        let traced = paths::Options {
            bounces,
            ground_reflects,
            light: options.light.into(),
        };
        Truth::trace(&scene, &seen, traced, options.paths, &tell)
    };
    let bodies = truth(false)?;
    let ground = scene.ground.map(|_| truth(true)).transpose()?;
    let seconds_truth = start.elapsed().as_secs_f64();
    progress.finish();

    let scale = scale(&seen.covered(&bodies.parts.total()));
    let [direct, indirect, total] = bodies.figures(&seen, &ours, scale);
    let grounded = ground.as_ref().map(|g| g.figures(&seen, &ours, scale));
    let indirect_light = seen.covered(&bodies.parts.indirect);
    let sum: f64 = indirect_light.iter().flatten().map(|c| f64::from(*c)).sum();
    let name = match &options.scene {
        Some(path) => path.display().to_string(),
        None => "the built-in scene".into(),
    };
    let comparison = Comparison {
        scene: name,
        width: options.size[0],
        height: options.size[1],
        receivers: indirect_light.len(),
        order: settings.order,
        accumulation_order: settings.accumulation,
        spheres: scene.objects.iter().map(|o| o.spheres.len()).sum(),
        paths: options.paths,
        bounces,
        light: match options.light {
            Source::Map => "map",
            Source::Projected => "projected",
        },
        mean_radiance: scale,
        indirect_share: sum / (3 * indirect_light.len().max(1)) as f64 / scale,
        direct,
        indirect,
        total,
        direct_ground: grounded.map(|[direct, ..]| direct),
        indirect_ground: grounded.map(|[_, indirect, _]| indirect),
        total_ground: grounded.map(|[.., total]| total),
        half_resolution,
        seconds_ours,
        seconds_truth,
        sheet: options.out.clone(),
    };
    if let (Some(output), Some(file)) = (output, out) {
        let pictures = Pictures {
            scene: &scene,
            seen: &seen,
            exposure: exposure(&light, &scene),
        };
        let spheres = balls::picture(&scene, &light, &emission, &seen);
        let ground = ground.as_ref().map(|truth| &truth.parts);
        let rows = pictures.rows(&ours, &bodies.parts, ground, spheres);
        sheet::write(
            output,
            file,
            &print::title(&comparison),
            &rows,
            options.size,
        )?;
    }
    Ok(comparison)
}
