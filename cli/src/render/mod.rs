//! `gaunt render`: from a scene file to a picture file.

mod gpu;
mod settings;

pub use settings::Overrides;

use crate::Error;
use crate::gpu::Gpu;
use crate::image::{Output, Picture, PictureFile, exposure};
use crate::progress::Progress;
use crate::report::{Body, Report, Times, planned};
use sh_bake::Report as Loaded;
use sh_scene::{Light, Plan, Scene, View};
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
    /// Where the picture goes, PNG or EXR by its ending.
    pub out: PathBuf,
    /// What renders.
    pub backend: Backend,
    /// Width and height, in pixels.
    pub size: [u32; 2],
    /// Settings instead of the scene's.
    pub settings: Overrides,
    /// Brighter or darker by powers of two.
    pub stops: f32,
    /// Where a report in JSON goes.
    pub report: Option<PathBuf>,
}

impl Default for Options {
    /// The built-in scene to `gaunt.png`, 1280 by 720.
    fn default() -> Self {
        Self {
            scene: None,
            out: "gaunt.png".into(),
            backend: Backend::Auto,
            size: [1280, 720],
            settings: Overrides::default(),
            stops: 0.0,
            report: None,
        }
    }
}

/// Everything that the GPU needs for a picture.
struct Frame<'a> {
    scene: &'a Scene,
    plan: &'a Plan,
    view: &'a View,
    light: &'a Light,
}

/// A backend that was chosen: what it is and why.
struct Choice {
    gpu: Option<Gpu>,
    reason: String,
}

/// Renders a scene to a file and tells how that went. Where it fails, no file is left behind.
pub fn render(options: &Options) -> Result<Report, Error> {
    let start = Instant::now();
    let mut times = Times::default();
    let progress = Progress::new("loading the scene");
    // First whatever can fail at once: nobody should wait for a picture that has no place to go.
    let file = PictureFile::create(&options.out)?;
    let report = options.report.as_deref().map(Output::create).transpose()?;

    let (scene, loaded) = load(options, &progress)?;
    times.add("read", loaded.read_time.as_secs_f64());
    times.add("fit spheres", loaded.fit_time.as_secs_f64());
    let choice = times.measure("device", || choose(options.backend))?;
    let settings = scene.settings;
    let light = times.measure("light", || scene.light())?;
    let plan = Plan::new(&scene);
    let [width, height] = options.size;

    progress.say("rendering");
    let pixels = match &choice.gpu {
        Some(gpu) => {
            let view = View {
                camera: scene.camera,
                width,
                height,
            };
            let frame = Frame {
                scene: &scene,
                plan: &plan,
                view: &view,
                light: &light,
            };
            gpu::picture(gpu, &frame, &mut times)?
        }
        None => {
            let frame = sh_cpu::render(&scene, &plan, (width, height), &|part| progress.set(part))?;
            for (stage, time) in frame.stages {
                times.add(stage, time.as_secs_f64());
            }
            frame.pixels
        }
    };
    let exposure = exposure(&light) * options.stops.exp2();
    let picture = Picture {
        width,
        height,
        pixels,
    };
    times.measure("write", || file.finish(picture, exposure))?;
    progress.finish();

    let summary = Report {
        picture: options.out.clone(),
        width,
        height,
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
        warnings: loaded.warnings,
        plan: planned(&plan),
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

/// The scene with what the command line says instead.
fn load(options: &Options, progress: &Progress) -> Result<(Scene, Loaded), Error> {
    options.settings.check()?;
    let tell = |step: sh_bake::Progress| progress.set(step.done as f32 / step.total.max(1) as f32);
    let (mut scene, loaded) = match &options.scene {
        Some(path) => sh_bake::load_scene_with(path, &tell)?,
        None => sh_bake::default_scene(&tell),
    };
    scene.settings = options.settings.apply(scene.settings)?;
    Ok((scene, loaded))
}

fn choose(backend: Backend) -> Result<Choice, Error> {
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
