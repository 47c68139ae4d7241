//! The program: arguments and dispatch.

mod arguments;

use arguments::{Compare, Export, Plan, Render};
use clap::{Parser, Subcommand, ValueEnum};
use gaunt::render::Options;
use gaunt::{Error, compare, eval, export, ops, plan, project, render};
use sh_bake::Cache;
use std::path::PathBuf;
use std::process::ExitCode;

/// Soft shadows from environment light, in spherical harmonics.
///
/// Without a command, renders the built-in scene to gaunt.png. What measures the library, its accuracy and its times, is
/// a program of its own: gaunt-lab.
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
}

#[derive(Clone, Copy, ValueEnum)]
enum Precision {
    F64,
    F32,
    Gpu,
}

fn main() -> ExitCode {
    gaunt::program::run("gaunt", |cli: Cli| run(cli.command))
}

/// Does what a command says; the text that is left to print.
fn run(command: Option<Command>) -> Result<String, Error> {
    match command {
        None => {
            let options = Options {
                cache: Cache::of_user(),
                ..Options::default()
            };
            Ok(render::render(&options)?.to_string())
        }
        Some(Command::Render(args)) => Ok(render::render(&args.into())?.to_string()),
        Some(Command::Plan(args)) => plan::run(&args.into()),
        #[cfg(feature = "view")]
        Some(Command::View(args)) => gaunt::view::run(&args.into()),
        Some(Command::Compare(args)) => compare::run(&args.into()),
        Some(Command::Project {
            environment,
            order,
            json,
        }) => {
            let map = sh_bake::load_environment(&environment)?;
            let coefficients = project::coefficients(&map, order)?;
            Ok(if json {
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
            eval::serve(backend, std::io::stdin().lock(), std::io::stdout().lock())?;
            Ok(String::new())
        }
        Some(Command::Ops { json }) => {
            let counts = ops::counts();
            if json {
                Ok(ops::json(&counts)?)
            } else {
                Ok(ops::table(&counts))
            }
        }
        Some(Command::Export(args)) => export::run(&args.into()),
    }
}
