//! Arguments of the commands that render: what they are and what they ask for.

use clap::{Args, ValueEnum};
use gaunt::program::size;
use gaunt::render::{self, Backend, Frames, Overrides, Reference, frame_numbers, frame_rate};
use gaunt::truth::Source;
use gaunt::{compare, export, plan};
use sh_bake::Cache;
use std::path::PathBuf;

/// Arguments of `gaunt render`.
#[derive(Args)]
pub struct Render {
    /// A scene in TOML, or a mesh file; without one, the built-in scene
    scene: Option<PathBuf>,
    /// The picture: .png (for a screen) or .exr (linear radiance); with --frames its name has a %d or %04d in it
    #[arg(short, long, default_value = "gaunt.png")]
    out: PathBuf,
    /// Render these frames of the scene's motion, a file each: 0..60 is frames 0 to 59
    ///
    /// Every frame is the same whether others are rendered or not. A mesh file given without --clip plays its
    /// first clip.
    #[arg(long, value_name = "A..B", value_parser = frame_numbers)]
    frames: Option<std::ops::Range<u32>>,
    /// Frames that make a second of motion
    #[arg(long, value_name = "RATE", default_value_t = 30.0, value_parser = frame_rate)]
    fps: f64,
    /// The clip that a mesh file plays: its name, or its number from 0; scene files say it for each object
    #[arg(long, value_name = "NAME")]
    clip: Option<String>,
    /// What computes; auto takes a GPU if there is one, and the CPU otherwise
    #[arg(long, value_enum, default_value_t = Backend::Auto)]
    backend: Backend,
    /// Width and height in pixels
    #[arg(long, value_name = "WxH", default_value = "1280x720", value_parser = size)]
    size: [u32; 2],
    #[command(flatten)]
    changes: Changes,
    /// Whether shadows are computed at half the picture's resolution, instead of what the scene or the quality says
    #[arg(long, value_enum)]
    half_resolution: Option<Switch>,
    /// Trace so many paths a pixel in place of the passes: the truth, slowly
    #[arg(long, value_name = "PATHS", value_parser = clap::value_parser!(u32).range(1..=1_048_576))]
    reference: Option<u32>,
    /// How often bodies reflect in the truth, instead of what the scene says
    #[arg(long, value_name = "COUNT", requires = "reference", value_parser = clap::value_parser!(u32).range(0..=1000))]
    reference_bounces: Option<u32>,
    /// The light of the truth: the environment's map, or what spherical harmonics make of it
    #[arg(long, value_enum, requires = "reference")]
    reference_light: Option<Source>,
    /// Let the ground reflect what arrives there, shadows and bounces, and not only what it would in the open
    #[arg(long, requires = "reference")]
    reflecting_ground: bool,
    /// Brighter or darker by so many stops (PNG only)
    #[arg(long, default_value_t = 0.0, allow_negative_numbers = true, value_parser = stops)]
    exposure: f32,
    /// Also write what was done and how long it took to this file
    #[arg(long, value_name = "REPORT.json")]
    json: Option<PathBuf>,
}

/// Arguments of `gaunt plan`.
#[derive(Args)]
pub struct Plan {
    /// A scene in TOML, or a mesh file; without one, the built-in scene
    scene: Option<PathBuf>,
    /// What computes; auto takes a GPU if there is one, and the CPU otherwise
    #[arg(long, value_enum, default_value_t = Backend::Auto)]
    backend: Backend,
    /// Width and height in pixels
    #[arg(long, value_name = "WxH", default_value = "1280x720", value_parser = size)]
    size: [u32; 2],
    #[command(flatten)]
    changes: Changes,
    /// Whether shadows are computed at half the picture's resolution, instead of what the scene or the quality says
    #[arg(long, value_enum)]
    half_resolution: Option<Switch>,
    /// Print a table of what the scene costs as effects are switched on one by one, instead of its plan
    #[arg(long)]
    effects: bool,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
}

impl From<Plan> for plan::Options {
    fn from(args: Plan) -> Self {
        Self {
            scene: args.scene,
            backend: args.backend,
            size: args.size,
            settings: Overrides {
                half_resolution: args.half_resolution.map(Switch::on),
                ..args.changes.into()
            },
            json: args.json,
            effects: args.effects,
            cache: Cache::of_user(),
        }
    }
}

/// Arguments of `gaunt compare`.
#[derive(Args)]
pub struct Compare {
    /// A scene in TOML, or a mesh file; without one, the built-in scene
    scene: Option<PathBuf>,
    /// A sheet of pictures, .png: ours, the truth, the difference, the spheres
    #[arg(short, long, value_name = "SHEET.png")]
    out: Option<PathBuf>,
    /// Print JSON instead of a table
    #[arg(long)]
    json: bool,
    /// Width and height of each picture, in pixels
    #[arg(long, value_name = "WxH", default_value = "384x216", value_parser = size)]
    size: [u32; 2],
    /// Paths a pixel; the noise that is left is told
    #[arg(long, value_name = "PATHS", default_value_t = 256, value_parser = clap::value_parser!(u32).range(2..=1_048_576))]
    reference: u32,
    /// How often bodies reflect in the truth, instead of what the scene says
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u32).range(0..=1000))]
    reference_bounces: Option<u32>,
    /// The light of the truth: what spherical harmonics make of it, as the passes have it, or the map as it is
    #[arg(long, value_enum, default_value_t = Source::Projected)]
    reference_light: Source,
    #[command(flatten)]
    changes: Changes,
}

/// Arguments of `gaunt view`.
#[cfg(feature = "view")]
#[derive(Args)]
pub struct View {
    /// A scene in TOML, or a mesh file; without one, the built-in scene
    scene: Option<PathBuf>,
    /// The clip that a mesh file plays, instead of its first: its name, or its number from 0
    #[arg(long, value_name = "NAME")]
    clip: Option<String>,
    /// What computes; auto takes a GPU if there is one, and the CPU otherwise
    #[arg(long, value_enum, default_value_t = Backend::Auto)]
    backend: Backend,
    /// Width and height of the window
    #[arg(long, value_name = "WxH", default_value = "1440x900", value_parser = size)]
    size: [u32; 2],
    #[command(flatten)]
    changes: Changes,
    /// What is laid over the picture at first
    #[arg(long, value_enum, default_value_t)]
    overlay: gaunt::view::Overlay,
    /// Write a picture of the window to this file and end; needs no display
    #[arg(long, value_name = "FILE.png")]
    screenshot: Option<PathBuf>,
    /// How many frames of motion the picture waits for, 30 a second; it shows the last of them
    #[arg(long, value_name = "COUNT", default_value_t = 1, requires = "screenshot", value_parser = clap::value_parser!(u32).range(1..))]
    frames: u32,
}

#[cfg(feature = "view")]
impl From<View> for gaunt::view::Options {
    fn from(args: View) -> Self {
        // Controls are explained as the options are: `render` has them all.
        let options = Render::augment_args(clap::Command::new("gaunt"));
        Self {
            scene: args.scene,
            clip: args.clip,
            backend: args.backend,
            size: args.size,
            settings: args.changes.into(),
            overlay: args.overlay,
            screenshot: args.screenshot,
            frames: args.frames,
            cache: Cache::of_user(),
            hints: gaunt::view::Hints::new(&options),
        }
    }
}

/// Arguments of `gaunt export`.
#[derive(Args)]
pub struct Export {
    /// The language: wgsl, glsl, hlsl, msl or spirv
    #[arg(long, value_name = "LANGUAGE", required_unless_present = "all")]
    lang: Option<String>,
    /// SH order: 2 to 6
    #[arg(long, default_value_t = 4)]
    order: usize,
    /// Only these routines and what they need, with commas between
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    routines: Vec<String>,
    /// What every name starts with, instead of sh4_ at order 4
    #[arg(long)]
    prefix: Option<String>,
    /// Every language at every order, with a page that explains them
    #[arg(long, conflicts_with_all = ["lang", "order", "routines", "prefix"])]
    all: bool,
    /// The folder for the files, or an archive, .tar.gz
    #[arg(short, long, value_name = "FOLDER", default_value = ".")]
    out: PathBuf,
}

impl From<Export> for export::Options {
    fn from(args: Export) -> Self {
        Self {
            language: args.lang,
            order: args.order,
            routines: args.routines,
            prefix: args.prefix,
            out: args.out,
        }
    }
}

/// Settings instead of the scene's.
#[derive(Args)]
struct Changes {
    /// Both SH orders under one name, instead of the scene's; ACCURACY.md tells what each gives and costs
    #[arg(long, value_enum)]
    quality: Option<Quality>,
    /// SH order of the light, 2 to 6, instead of the scene's or the quality's
    ///
    /// Shading a receiver costs as the fourth power of it, every blocker at least as its square. An order of
    /// accumulation that was the same goes with it.
    #[arg(long)]
    order: Option<usize>,
    /// SH order in which shadows are accumulated, from the light's to 6, instead of the scene's or the quality's
    ///
    /// Above the light's order shadows are truer, and every blocker costs as the square of it; see ACCURACY.md.
    #[arg(long)]
    accumulation: Option<usize>,
    /// Whether shadows are cast, instead of what the scene says
    #[arg(long, value_enum)]
    shadows: Option<Switch>,
}

impl From<Changes> for Overrides {
    fn from(changes: Changes) -> Self {
        Self {
            quality: changes.quality.map(Into::into),
            order: changes.order,
            accumulation: changes.accumulation,
            shadows: changes.shadows.map(Switch::on),
            half_resolution: None,
        }
    }
}

impl From<Render> for render::Options {
    fn from(args: Render) -> Self {
        Self {
            scene: args.scene,
            out: args.out,
            frames: args.frames.map(|numbers| Frames {
                numbers,
                rate: args.fps,
            }),
            clip: args.clip,
            backend: args.backend,
            reference: args.reference.map(|paths| Reference {
                paths,
                bounces: args.reference_bounces,
                ground: args.reflecting_ground,
                light: args.reference_light.unwrap_or_default(),
            }),
            size: args.size,
            settings: Overrides {
                half_resolution: args.half_resolution.map(Switch::on),
                ..args.changes.into()
            },
            stops: args.exposure,
            report: args.json,
            cache: Cache::of_user(),
        }
    }
}

impl From<Compare> for compare::Options {
    fn from(args: Compare) -> Self {
        Self {
            scene: args.scene,
            out: args.out,
            json: args.json,
            size: args.size,
            paths: args.reference,
            bounces: args.reference_bounces,
            light: args.reference_light,
            settings: args.changes.into(),
            cache: Cache::of_user(),
        }
    }
}

#[derive(Clone, Copy, ValueEnum)]
enum Switch {
    On,
    Off,
}

impl Switch {
    fn on(self) -> bool {
        matches!(self, Self::On)
    }
}

#[derive(Clone, Copy, ValueEnum)]
enum Quality {
    /// The softest light: order 3, shadows in order 3, in .9 of balanced's time
    Fast,
    /// The middle, and the default: order 4 for both
    Balanced,
    /// The sharpest light and the truest shadows: order 6 for both, in 1.4 times balanced's time, at full resolution
    Accurate,
}

impl From<Quality> for sh_scene::Quality {
    fn from(quality: Quality) -> Self {
        match quality {
            Quality::Fast => Self::Fast,
            Quality::Balanced => Self::Balanced,
            Quality::Accurate => Self::Accurate,
        }
    }
}

fn stops(text: &str) -> Result<f32, String> {
    match text.parse() {
        Ok(stops) if (-20.0..=20.0).contains(&stops) => Ok(stops),
        _ => Err("stops are a number from -20 to 20".into()),
    }
}
