//! `gaunt render`: from a scene file to a picture file, or to one for each frame of its motion.

mod frames;
pub(crate) mod gpu;
mod reference;
mod settings;
mod shot;

pub use frames::{Frames, Pattern, frame_numbers, frame_rate};
pub use reference::Reference;
pub use settings::Overrides;
pub(crate) use shot::{Changes, Shot};

use crate::Error;
use crate::gpu::Gpu;
use crate::image::{Output, Picture, exposure};
use crate::progress::Progress;
use crate::report::{Basis, Body, Report, Sequence, Surface, Times, planned};
use frames::Files;
use gpu::Painted;
use sh_bake::{Cache, Choices, ClipChoice, Loaded};
use sh_scene::motion::Motion;
use sh_scene::passes::{INVALID_SAMPLES, InvalidSamples};
use sh_scene::resource::Given;
use sh_scene::{Plan, Tracker, View};
use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

/// What renders.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Backend {
    /// A GPU if there is one that is no program on the processor, and the CPU otherwise.
    #[default]
    Auto,
    /// The CPU.
    Cpu,
    /// Any GPU adapter, a software one too.
    Gpu,
}

/// What to render and how.
#[derive(Clone, Debug)]
pub struct Options {
    /// A scene file; none for the built-in scene.
    pub scene: Option<PathBuf>,
    /// Where the picture goes, PNG or EXR by its ending; for frames, a pattern with `%d` or `%04d`.
    pub out: PathBuf,
    /// The frames to render; none for one picture at time 0.
    pub frames: Option<Frames>,
    /// The clip that a mesh file plays, by name or number. Without one it plays its first where there are
    /// frames, and none otherwise.
    pub clip: Option<String>,
    /// What renders.
    pub backend: Backend,
    /// The path tracer in place of the passes.
    pub reference: Option<Reference>,
    /// Width and height, in pixels.
    pub size: [u32; 2],
    /// Settings instead of the scene's.
    pub settings: Overrides,
    /// Brighter or darker by powers of two.
    pub stops: f32,
    /// Where a report in JSON goes.
    pub report: Option<PathBuf>,
    /// Where sphere sets are kept, and taken from if they are there; none to fit them anew.
    pub cache: Option<Cache>,
}

impl Default for Options {
    /// The built-in scene to `gaunt.png`, 1280 by 720.
    fn default() -> Self {
        Self {
            scene: None,
            out: "gaunt.png".into(),
            frames: None,
            clip: None,
            backend: Backend::Auto,
            reference: None,
            size: [1280, 720],
            settings: Overrides::default(),
            stops: 0.0,
            report: None,
            cache: None,
        }
    }
}

/// A backend that was chosen: what it is and why.
pub struct Choice {
    /// The GPU; none for the CPU.
    pub gpu: Option<Gpu>,
    /// A sentence that says why.
    pub reason: String,
}

/// Renders a scene to a file, or to one for each frame, and tells how that went. Where it fails, no file is left
/// half written, and of the frames those that were done.
pub fn render(options: &Options) -> Result<Report, Error> {
    let start = Instant::now();
    let mut times = Times::default();
    let progress = Progress::new("loading the scene");
    // First whatever can fail at once.
    check_reference(options)?;
    let mut files = Files::open(&options.out, options.frames.as_ref())?;
    let report = options.report.as_deref().map(Output::create).transpose()?;

    let Loaded {
        mut scene,
        mut motion,
        report: loaded,
    } = load(options, &progress)?;
    times.add("read", loaded.read_time.as_secs_f64());
    times.add("fit spheres", loaded.fit_time.as_secs_f64());
    times.add("weights", loaded.weight_time.as_secs_f64());
    if !loaded.surfaces.is_empty() {
        times.add("surfaces", loaded.surface_time.as_secs_f64());
    }
    if !loaded.bases.is_empty() {
        times.add("functions", loaded.basis_time.as_secs_f64());
    }
    let choice = times.measure("device", || match options.reference {
        Some(_) => Ok(Choice {
            gpu: None,
            reason: "The CPU traces paths, because the truth was asked for.".into(),
        }),
        None => choose(options.backend),
    })?;
    let settings = scene.settings;
    let light = times.measure("light", || scene.light())?;
    // One for all frames, so that none flickers.
    let exposure = exposure(&light, &scene) * options.stops.exp2();
    let plan = Plan::giving(&scene, &[INVALID_SAMPLES]);
    let [width, height] = options.size;
    let view = View {
        camera: scene.camera,
        width,
        height,
    };

    progress.say("rendering");
    let mut painter = None;
    // The scene as it was loaded gives the tree of blockers its topology, so that no frame depends on others.
    let (mut tracker, mut frames) = (Tracker::default(), sh_cpu::Frames::default());
    match &choice.gpu {
        Some(_) if plan.is_blocked() => tracker.place(&scene),
        Some(_) => {}
        None => frames.start(&scene, &plan),
    }
    let numbers = options.frames.as_ref().map_or(0..1, |f| f.numbers.clone());
    let mut invalid = Vec::new();
    for (done, number) in numbers.clone().enumerate() {
        let done = |part: f32| progress.set((done as f32 + part) / numbers.len() as f32);
        let file = files.next(number)?;
        if let Some(frames) = options.frames.as_ref().filter(|_| !motion.is_still()) {
            let seconds = f64::from(number) / frames.rate;
            times.measure("pose", || motion.pose(seconds, &mut scene));
        }
        let painted = match (&options.reference, &choice.gpu) {
            (Some(reference), _) => {
                let pixels = reference::picture(reference, &scene, &view, &mut times, &done)?;
                Painted {
                    pixels,
                    given: Given::new(),
                }
            }
            (None, Some(gpu)) => {
                times.measure("light", || tracker.relight(&scene))?;
                let shot = Shot {
                    plan: &plan,
                    view: &view,
                    changes: Changes {
                        meshes: motion.bends(),
                        environment: motion.turns(),
                    },
                };
                let scene = (&scene, &mut tracker);
                gpu::picture(gpu, &mut painter, scene, &shot, &mut times)?
            }
            (None, None) => {
                let frame = frames.render(&scene, &plan, (width, height), &done)?;
                for (stage, time) in frame.stages {
                    times.add(stage, time.as_secs_f64());
                }
                Painted {
                    pixels: frame.pixels,
                    given: frame.given,
                }
            }
        };
        let found = InvalidSamples::of(&painted.given, width);
        invalid.extend(found.filter(|f| f.pixels > 0).map(|f| (number, f)));
        let picture = Picture {
            width,
            height,
            pixels: painted.pixels,
        };
        times.measure("write", || file.finish(picture, exposure))?;
        done(1.0);
    }
    progress.finish();

    let summary = Report {
        picture: options.out.clone(),
        width,
        height,
        frames: options.frames.as_ref().map(|frames| Sequence {
            first: frames.numbers.start,
            count: frames.numbers.len(),
            fps: frames.rate,
        }),
        backend: if choice.gpu.is_some() { "gpu" } else { "cpu" },
        device: match &choice.gpu {
            Some(gpu) => gpu.name.clone(),
            None => format!("the CPU on {} threads", rayon::current_num_threads()),
        },
        reason: choice.reason,
        order: settings.order,
        accumulation: settings.accumulation,
        exposure,
        objects: loaded.fits.iter().map(Body::new).collect(),
        surfaces: loaded.surfaces.iter().map(Surface::new).collect(),
        bases: loaded.bases.iter().map(Basis::new).collect(),
        moves: loaded.moves,
        warnings: [loaded.warnings, invalid_samples(options, &invalid)].concat(),
        plan: match &options.reference {
            Some(reference) => reference.planned(&scene),
            None => planned(&plan),
        },
        stages: times.0,
        seconds: start.elapsed().as_secs_f64(),
    };
    if let (Some(report), Some(path)) = (report, &options.report) {
        let text = serde_json::to_string_pretty(&summary)?;
        report.finish(|file| {
            let written = writeln!(file, "{text}");
            written.map_err(|source| Error::file("write to", path.display(), source))
        })?;
    }
    Ok(summary)
}

/// A sentence on what samples of pictures are invalid, if any are.
fn invalid_samples(options: &Options, found: &[(u32, InvalidSamples)]) -> Vec<String> {
    let first = found.first().map(|(number, first)| match options.frames {
        None => format!("{first}."),
        Some(_) => format!(
            "{first}. That is frame {number}, the first of {} with any.",
            found.len()
        ),
    });
    first.into_iter().collect()
}

/// What the path tracer cannot do.
fn check_reference(options: &Options) -> Result<(), Error> {
    if options.reference.is_none() {
        return Ok(());
    }
    let wrong = match options.settings {
        _ if options.backend == Backend::Gpu => {
            "--reference traces paths on the CPU: it goes with --backend cpu or auto, not with gpu"
        }
        Overrides {
            shadows: Some(false),
            ..
        } => "--reference traces paths, which cast shadows: it does not go with --shadows off",
        Overrides {
            half_resolution: Some(true),
            ..
        } => "--reference traces every sample: it does not go with --half-resolution on",
        _ => return Ok(()),
    };
    Err(Error::Usage(wrong.into()))
}

/// The scene with what the command line says instead.
pub(crate) fn load(options: &Options, progress: &Progress) -> Result<Loaded, Error> {
    let tell = |step: sh_bake::Progress| progress.set(step.done as f32 / step.total.max(1) as f32);
    load_with(options, Choices::default(), &tell)
}

/// As [`load`], with more or fewer spheres and surface samples; the clip is that of the options.
pub(crate) fn load_with(
    options: &Options,
    choices: Choices,
    tell: &(dyn Fn(sh_bake::Progress) + Sync),
) -> Result<Loaded, Error> {
    options.settings.check()?;
    let clip = match (&options.clip, &options.frames) {
        (Some(name), _) => ClipChoice::Named(name),
        (None, Some(_)) => ClipChoice::First,
        (None, None) => ClipChoice::None,
    };
    let choices = Choices { clip, ..choices };
    let cache = options.cache.as_ref();
    let mut loaded = match &options.scene {
        Some(path) => sh_bake::load_scene_with(path, choices, cache, tell)?,
        None if options.clip.is_some() => {
            let sentence = "--clip chooses a clip of a mesh file, and the built-in scene has none";
            return Err(Error::Usage(sentence.into()));
        }
        None => {
            let (scene, report) = sh_bake::default_scene_with(choices, cache, tell);
            Loaded {
                scene,
                motion: Motion::default(),
                report,
            }
        }
    };
    loaded.scene.settings = options.settings.apply(loaded.scene.settings)?;
    Ok(loaded)
}

/// The backend that was asked for, or the one that there is.
///
/// # Errors
/// Where a GPU was asked for and there is none.
pub fn choose(backend: Backend) -> Result<Choice, Error> {
    let cpu = |reason| Ok(Choice { gpu: None, reason });
    match backend {
        Backend::Cpu => cpu("The CPU was asked for.".into()),
        Backend::Gpu => {
            let gpu = Gpu::open()?;
            Ok(Choice {
                gpu: Some(gpu),
                reason: "A GPU was asked for.".into(),
            })
        }
        Backend::Auto => match Gpu::open() {
            Err(error) => cpu(format!("The CPU renders, because {error}.")),
            Ok(gpu) if gpu.software => cpu(format!(
                "The CPU renders, because the only GPU driver, {}, runs on the CPU as well and is slower there.",
                gpu.name
            )),
            Ok(gpu) => Ok(Choice {
                gpu: Some(gpu),
                reason: "The GPU renders, because there is one.".into(),
            }),
        },
    }
}
