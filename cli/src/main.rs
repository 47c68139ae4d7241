//! The program: arguments and dispatch.

use clap::{Args, Parser, Subcommand, ValueEnum};
use gaunt::render::{Backend, Frames, Options, Overrides, frame_numbers, frame_rate};
use gaunt::{Error, accuracy, bench, eval, fit, ops, project, render, spheres};
use sh_bake::Cache;
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;

/// Soft shadows from environment light, in spherical harmonics.
///
/// Without a command, renders the built-in scene to gaunt.png.
#[derive(Parser)]
#[command(version, about, long_about)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Subcommand)]
enum Command {
    /// Render a scene to a PNG or EXR file, or its motion to one for each frame
    ///
    /// Prints where the picture is, the plan (which passes run and why) and the time that each stage took.
    Render(Render),
    /// Print the SH coefficients of an environment map
    ///
    /// One row a coefficient, index l*l + l + m, with red, green and blue. Nothing is windowed, and solid
    /// angles are exact.
    Project {
        /// An equirectangular map, .hdr or .exr; its centre is -Z, its top +Y
        environment: PathBuf,
        /// SH order: 2 to 6
        #[arg(long, default_value_t = 4)]
        order: usize,
        /// Print [[red, green, blue], ...] instead of a table
        #[arg(long)]
        json: bool,
    },
    /// Evaluate SH routines: JSON lines from standard input, one JSON line out for each
    ///
    /// A request is {"op": ..., "order": n, ...}, the answer {"ok": [...]} or {"error": "a sentence"}.
    /// Operations and their arguments:
    ///   basis {dir}   cosine {dir}   zonal {z, dir}   product {f, g}   square {f}   triple {f, g, h}
    ///   rotate {f, quat: [x, y, z, w]}   window {f, h}   cap {angle}   log {f, method: eigen | samples}
    ///   cap_log {angle, method: fitted | table | eigen | samples | fitted:X, X an exponential but eigen and ps}
    ///   exp {f, method: saturating | sampled | sampled:Q | ps:N | ps*:N | ol | hyb | eigen}
    /// Vectors have n*n numbers, zonal ones n; angles are radians; rotations are active; directions and
    /// quaternions must be unit vectors. Without a method, cap_log is fitted to the eigen logarithm (beyond pi/2
    /// its table), log is eigen, exp is ps*:2. The shadow pass uses fitted:saturating and saturating, which only
    /// go together.
    #[command(verbatim_doc_comment)]
    Eval {
        /// What computes: double precision, single precision, or the WGSL library on a GPU
        #[arg(long, value_enum, default_value_t = Precision::F64)]
        backend: Precision,
    },
    /// Print how many multiplications and additions each generated routine takes
    Ops {
        /// Print [{"routine", "order", "mul", "add"}, ...] instead of a table
        #[arg(long)]
        json: bool,
    },
    /// Measure what accuracy costs: every exponential and logarithm against the truth, and in time
    ///
    /// Prints a table: for each SH order the methods from fast to slow, with their errors over 1,000 random sets
    /// of blockers and the time of a receiver. Methods with a star have none that is both faster and more accurate.
    Accuracy {
        /// Write all rows to this file
        #[arg(long, value_name = "FILE.json")]
        json: Option<PathBuf>,
        /// Draw error against time to this file, .svg or .png, and whole pictures to a second one beside it
        #[arg(long, value_name = "FILE")]
        plot: Option<PathBuf>,
        /// Write the page that sums it up to this file
        #[arg(long, value_name = "FILE.md")]
        page: Option<PathBuf>,
    },
    /// Time moving scenes: every stage of a frame, against one lane on one thread and against the machine's peak
    ///
    /// The scenes are made by code at the scale of Ren et al. 2006. On a shared machine trust the ratios.
    Bench {
        /// What to time
        #[arg(value_enum)]
        bench: bench::Bench,
        /// What shades; auto takes a GPU if there is one
        #[arg(long, value_enum, default_value_t = Backend::Cpu)]
        backend: Backend,
        /// Print JSON instead of tables
        #[arg(long)]
        json: bool,
        /// Draw the comparison with rays to this file, .svg or .png
        #[arg(long, value_name = "FILE")]
        plot: Option<PathBuf>,
    },
    /// Fit spheres to meshes, and measure how tight they are beside simpler sets
    ///
    /// Prints a table: the volume of the spheres outside the mesh over the mesh's volume, for the fit that shadows use,
    /// for the leaves of an octree and for plain clustering. All are measured by the same exact sum.
    Spheres {
        /// Mesh files; without one, a box and a torus knot made by code
        meshes: Vec<PathBuf>,
        /// Numbers of spheres
        #[arg(long, value_delimiter = ',', default_value = "8,16,32,64,128", value_parser = clap::value_parser!(u16).range(1..=4096))]
        counts: Vec<u16>,
        /// Write all rows to this file, too
        #[arg(long, value_name = "FILE.json")]
        json: Option<PathBuf>,
    },
    /// Refit all fitted constants of the library and write them as data files
    Fit {
        /// The folder for the files
        #[arg(long, default_value = "codegen/data")]
        out: PathBuf,
    },
}

#[derive(Args)]
struct Render {
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
    /// Whether shadows are computed at half the picture's resolution, instead of what the scene or the quality says
    #[arg(long, value_enum)]
    half_resolution: Option<Switch>,
    /// Brighter or darker by so many stops (PNG only)
    #[arg(long, default_value_t = 0.0, allow_negative_numbers = true, value_parser = stops)]
    exposure: f32,
    /// Also write what was done and how long it took to this file
    #[arg(long, value_name = "REPORT.json")]
    json: Option<PathBuf>,
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
    /// The softest light, in half the time of balanced
    Fast,
    /// The middle, and the default
    Balanced,
    /// The sharpest light and the truest shadows, in about three times the time of balanced
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

#[derive(Clone, Copy, ValueEnum)]
enum Precision {
    F64,
    F32,
    Gpu,
}

fn size(text: &str) -> Result<[u32; 2], String> {
    let sides = text
        .split_once(['x', 'X'])
        .and_then(|(w, h)| Some([w.parse().ok()?, h.parse().ok()?]));
    match sides {
        Some([w, h]) if (1..=16_384).contains(&w) && (1..=16_384).contains(&h) => Ok([w, h]),
        Some(_) => Err("each side must be 1 to 16384 pixels".into()),
        None => Err("a size looks like 1280x720".into()),
    }
}

fn stops(text: &str) -> Result<f32, String> {
    match text.parse() {
        Ok(stops) if (-20.0..=20.0).contains(&stops) => Ok(stops),
        _ => Err("stops are a number from -20 to 20".into()),
    }
}

fn main() -> ExitCode {
    // A damaged EXR file can end its decoder in a panic, which the loader catches and tells in a sentence: nobody
    // needs to read both.
    let usual = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        let place = panic
            .location()
            .map(|location| location.file().replace('\\', "/"));
        if !place.is_some_and(|file| file.contains("/exr-")) {
            usual(panic);
        }
    }));
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => {
            // Help goes to standard output and is no failure. Where printing fails, nobody reads it.
            let _ = error.print();
            return if error.use_stderr() {
                ExitCode::FAILURE
            } else {
                ExitCode::SUCCESS
            };
        }
    };
    match run(cli.command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            let text = error.to_string();
            let end = if text.ends_with(['.', '!', '?']) {
                ""
            } else {
                "."
            };
            let _ = writeln!(std::io::stderr(), "gaunt: {text}{end}");
            ExitCode::FAILURE
        }
    }
}

fn run(command: Option<Command>) -> Result<(), Error> {
    match command {
        None => {
            let options = Options {
                cache: Cache::of_user(),
                ..Options::default()
            };
            say(&render::render(&options)?.to_string())
        }
        Some(Command::Render(args)) => {
            let options = Options {
                scene: args.scene,
                out: args.out,
                frames: args.frames.map(|numbers| Frames {
                    numbers,
                    rate: args.fps,
                }),
                clip: args.clip,
                backend: args.backend,
                size: args.size,
                settings: Overrides {
                    quality: args.quality.map(Into::into),
                    order: args.order,
                    accumulation: args.accumulation,
                    shadows: args.shadows.map(Switch::on),
                    half_resolution: args.half_resolution.map(Switch::on),
                },
                stops: args.exposure,
                report: args.json,
                cache: Cache::of_user(),
            };
            say(&render::render(&options)?.to_string())
        }
        Some(Command::Project {
            environment,
            order,
            json,
        }) => {
            let map = sh_bake::load_environment(&environment)?;
            let coefficients = project::coefficients(&map, order)?;
            say(&if json {
                serde_json::json!(coefficients).to_string()
            } else {
                project::table(&coefficients)
            })
        }
        Some(Command::Eval { backend }) => {
            let backend = match backend {
                Precision::F64 => eval::Backend::F64,
                Precision::F32 => eval::Backend::F32,
                Precision::Gpu => eval::Backend::Gpu(Box::new(eval::Evaluator::new()?)),
            };
            eval::serve(backend, std::io::stdin().lock(), std::io::stdout().lock())
        }
        Some(Command::Ops { json }) => {
            let counts = ops::counts();
            say(&if json {
                ops::json(&counts)?
            } else {
                ops::table(&counts)
            })
        }
        Some(Command::Accuracy { json, plot, page }) => {
            let options = accuracy::Options { json, plot, page };
            say(&accuracy::run(&options)?)
        }
        Some(Command::Bench {
            bench,
            backend,
            json,
            plot,
        }) => {
            let options = bench::Options {
                bench,
                backend,
                json,
                plot,
            };
            say(&bench::run(&options)?)
        }
        Some(Command::Spheres {
            meshes,
            counts,
            json,
        }) => {
            let options = spheres::Options {
                meshes,
                counts: counts.into_iter().map(usize::from).collect(),
                json,
            };
            say(&spheres::run(&options)?)
        }
        Some(Command::Fit { out }) => say(&fit::write(&out)?),
    }
}

/// Prints to standard output. A reader that has gone away is no failure.
fn say(text: &str) -> Result<(), Error> {
    let mut output = std::io::stdout().lock();
    match writeln!(output, "{text}").and_then(|()| output.flush()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Error::file("write to", "standard output", error))
        }
        _ => Ok(()),
    }
}
