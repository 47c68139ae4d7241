//! `gaunt view`: a window on a scene, to look around, play its motion, and see what every setting does and costs.
//!
//! ```text
//! window or headless ── App ── panel, stage ──> State ──> Wish ──> Worker's thread: Studio ──> Shown ──> App
//! ```
//! The window never waits: what it wants to see goes to a thread as a wish, the latest of which counts, and while
//! something moves it is for a picture so small that the next one is there in time. The window is drawn by eframe
//! (winit, egui, wgpu), or, where there is no display, by a rasteriser of its own into a file.

mod app;
mod headless;
mod hints;
mod layer;
mod look;
mod options;
mod orbit;
mod pace;
mod panel;
mod raster;
mod shot;
mod stage;
mod state;
mod studio;
mod truth;
mod window;
mod wish;
mod worker;

pub use hints::Hints;
pub use options::Options;
pub use wish::Overlay;

use crate::Error;
use crate::gpu::Gpu;
use crate::progress::Progress;
use crate::render::{self, Backend, Choice, Frames};
use app::{App, FRAME, Script};
use headless::Bell;
use state::{Facts, State};
use std::sync::Arc;
use studio::Studio;
use worker::Worker;

/// Opens the window and returns when it is closed, or writes a picture of it. The text to print tells where the picture
/// is; it is empty where none was asked for.
///
/// # Errors
/// Where the scene cannot be loaded or rendered, there is no display and no picture was asked for, or the picture
/// cannot be written.
pub fn run(options: &Options) -> Result<String, Error> {
    let output = options.screenshot.as_deref().map(shot::open).transpose()?;
    if output.is_none() && !display() {
        return Err(Error::Usage(NO_DISPLAY.into()));
    }
    let loading = render::Options {
        scene: options.scene.clone(),
        clip: options.clip.clone(),
        settings: options.settings,
        cache: options.cache.clone(),
        // A mesh file plays its first clip.
        frames: Some(Frames {
            numbers: 0..1,
            rate: 1.0 / FRAME,
        }),
        ..render::Options::default()
    };
    let progress = Progress::new("loading the scene");
    let loaded = render::load(&loading, &progress)?;
    progress.finish();
    let facts = Facts::new(options.scene.as_deref(), &loaded);
    let make = |gpu: Option<Gpu>, wake: Box<dyn Fn() + Send + Sync>| {
        let studio = Studio::new(loading.clone(), loaded.clone(), gpu)?;
        let worker = Worker::new(studio, wake);
        let state = State::new(&loaded, options);
        let script = output.as_ref().map(|_| Script::new(options.frames));
        let hints = options.hints.clone();
        Ok(App::new(facts.clone(), hints, state, worker, script))
    };

    let opened = display().then(|| {
        window::open(options, &facts.name, &|ctx, gpu| {
            let ctx = ctx.clone();
            let passes = match options.backend {
                Backend::Cpu => None,
                Backend::Gpu => Some(gpu),
                Backend::Auto => Some(gpu).filter(|gpu| !gpu.software),
            };
            make(passes, Box::new(move || ctx.request_repaint()))
        })
    });
    let (picture, place) = match opened {
        Some(Ok(left)) => match left.error {
            Some(error) => return Err(error),
            None => (left.picture, "on a display"),
        },
        // A display that does not answer, or nothing to draw on it with: a picture needs neither.
        None | Some(Err(_)) if output.is_some() => {
            let Choice { gpu, .. } = render::choose(options.backend)?;
            let bell = Bell::default();
            let rings = bell.clone();
            let app = make(gpu, Box::new(move || rings.ring()))?;
            let picture = headless::picture(app, &bell, options.size)?;
            (Some(Arc::new(picture)), "in memory")
        }
        Some(Err(error)) => {
            return Err(Error::Usage(format!(
                "cannot open a window: {error}; --screenshot FILE.png works without one"
            )));
        }
        None => return Err(Error::Usage(NO_DISPLAY.into())),
    };
    match (output, picture) {
        (Some(output), Some(picture)) => shot::write(output, &picture, place),
        (Some(_), None) => Err(Error::Usage(
            "the window was closed before its picture was taken".into(),
        )),
        (None, _) => Ok(String::new()),
    }
}

/// What to say where no window can be opened.
const NO_DISPLAY: &str = "there is no display for a window: DISPLAY is not set. With --screenshot FILE.png the window \
                          is drawn into a file without one, and xvfb-run gives it a virtual one";

/// Whether a window can be tried. Other systems always have a display.
fn display() -> bool {
    let unix = cfg!(all(unix, not(target_vendor = "apple")));
    let set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    !unix || set("DISPLAY")
}
