//! The program that measures: arguments and dispatch.

use clap::{Args, Parser, Subcommand};
use gaunt::Error;
use gaunt::program::size;
use gaunt::render::Backend;
use gaunt_lab::{accuracy, basis, bench, fit, spheres, validate};
use std::path::PathBuf;
use std::process::ExitCode;

/// Measures Gaunt: accuracy, times, validation against the truth, fitted constants.
#[derive(Parser)]
#[command(name = "gaunt-lab", version, about, long_about)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
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
    /// Compare the validation scenes of spherical lights with the truth, and measure where errors come from
    ///
    /// The scenes are those of Guerrero et al. 2008, figures 8 to 10, made by code; docs/INDIRECT.md shows them. Takes
    /// some minutes.
    Validate(Validate),
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
    /// Measure in how few functions the irradiance on a body can be written
    ///
    /// Prints a table: what is left of the light of a lamp in twelve places, traced path by path, over its mean, with functions
    /// found for the body and with cosines and spherical harmonics of position (Iwasaki et al. 2007, figure 10).
    Basis {
        /// Mesh files; without one, a ball, a box and a torus knot made by code
        meshes: Vec<PathBuf>,
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

/// Arguments of `gaunt-lab validate`.
#[derive(Args)]
struct Validate {
    /// A folder for a sheet of pictures a scene
    #[arg(short, long, value_name = "FOLDER")]
    out: Option<PathBuf>,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
    /// Width and height of each picture, in pixels
    #[arg(long, value_name = "WxH", default_value = "192x108", value_parser = size)]
    size: [u32; 2],
    /// Paths a pixel; the noise that is left is told
    #[arg(long, value_name = "PATHS", default_value_t = 128, value_parser = clap::value_parser!(u32).range(2..=1_048_576))]
    reference: u32,
    /// Only these scenes and tables
    ///
    /// Scenes are sphere, spheres, lamp, animal, bend-90, bend-180, box-1 and box-8; tables are counts, orders, bends, steps
    /// and weights; rooms, by patches, are plane, room and teapots, and ways is a table of these.
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    only: Vec<String>,
}

impl From<Validate> for validate::Options {
    fn from(args: Validate) -> Self {
        Self {
            out: args.out,
            json: args.json,
            size: args.size,
            paths: args.reference,
            only: args.only,
        }
    }
}

fn main() -> ExitCode {
    gaunt::program::run("gaunt-lab", |cli: Cli| run(cli.command))
}

/// Does what a command says; the text that is left to print.
fn run(command: Command) -> Result<String, Error> {
    match command {
        Command::Accuracy { json, plot, page } => {
            accuracy::run(&accuracy::Options { json, plot, page })
        }
        Command::Bench {
            bench,
            backend,
            json,
            plot,
        } => bench::run(&bench::Options {
            bench,
            backend,
            json,
            plot,
        }),
        Command::Validate(args) => validate::run(&args.into()),
        Command::Spheres {
            meshes,
            counts,
            json,
        } => spheres::run(&spheres::Options {
            meshes,
            counts: counts.into_iter().map(usize::from).collect(),
            json,
        }),
        Command::Basis { meshes, json } => basis::run(&basis::Options { meshes, json }),
        Command::Fit { out, only } => fit::write(&out, only.as_deref()),
    }
}
