//! The program: arguments and dispatch.

mod arguments;

use arguments::{Compare, Export, Plan, Render, Validate};
use clap::{Parser, Subcommand, ValueEnum};
use gaunt::render::{Backend, Options};
use gaunt::{
    Error, accuracy, bench, compare, eval, export, fit, ops, plan, project, render, spheres,
    validate,
};
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
    /// Print the passes that a scene calls for, why, and what each costs: dispatches, memory, time
    ///
    /// Runs some frames of the scene, at 30 a second where it moves. Tells what is left out and why, what was no work
    /// because it had not changed, and which shaders a GPU compiles.
    Plan(Plan),
    /// Open a window on a scene: look around, play its motion, change settings and see what they cost
    ///
    /// Drag to look around, with shift or the right button to move aside, and use the wheel to come nearer. Arrow keys,
    /// plus and minus do the same, space plays and pauses, Home goes back to the first view. Point at a name to read
    /// what it means.
    #[cfg(feature = "view")]
    View(arguments::View),
    /// Compare the passes with the truth: pictures side by side, and figures of the difference
    ///
    /// The truth is traced path by path from one receiver a pixel, twice: with bodies as the only reflectors, as the
    /// passes assume, and with the ground reflecting too. Figures are in parts of the mean radiance.
    Compare(Compare),
    /// Compare the validation scenes of spherical lights with the truth, and measure where errors come from
    ///
    /// The scenes are those of Guerrero et al. 2008, figures 8 to 10, made by code; docs/INDIRECT.md shows them. Takes
    /// some minutes.
    Validate(Validate),
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
    /// Export the SH routines as a file that another renderer's shaders include
    ///
    /// One file a language and order, without dependencies; every name starts with a prefix. docs/EXPORT.md tells how to
    /// include it. GLSL comes in three versions (450, 330 and 300 es), SPIR-V as entry points and as a library to link.
    Export(Export),
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
    /// The scenes are made by code at the scale of Ren et al. 2006 and Guerrero et al. 2008. On a shared machine trust the ratios.
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
        /// Draw the comparison with rays, or that of lights, to this file, .svg or .png
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

        /// Only this file
        #[arg(long)]
        only: Option<String>,
    },
}

#[derive(Clone, Copy, ValueEnum)]
enum Precision {
    F64,
    F32,
    Gpu,
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
        Some(Command::Render(args)) => say(&render::render(&args.into())?.to_string()),
        Some(Command::Plan(args)) => say(&plan::run(&args.into())?),
        #[cfg(feature = "view")]
        Some(Command::View(args)) => match gaunt::view::run(&args.into())? {
            text if text.is_empty() => Ok(()),
            text => say(&text),
        },
        Some(Command::Compare(args)) => say(&compare::run(&args.into())?),
        Some(Command::Validate(args)) => say(&validate::run(&args.into())?),
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
        Some(Command::Export(args)) => say(&export::run(&args.into())?),
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
        Some(Command::Fit { out, only }) => say(&fit::write(&out, only.as_deref())?),
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
