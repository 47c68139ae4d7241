//! `gaunt-lab validate`: the validation scenes of Guerrero et al. 2008 (section 8.2, figures 8 to 10), made by code, against
//! the path tracer.
//!
//! | module | does |
//! |---|---|
//! | `bodies`, `scenes` | what is looked at |
//! | `measure` | the truth of a scene, and how far the passes are from it |
//! | `tables` | how that falls with spheres and orders, and where it comes from |
//! | `weight` | the mean radiance of a ball, in two ways |
//! | `rooms` | bodies that send light to and fro by patches, by functions, order and bounces |
//! | `sheets`, `print` | pictures and tables |

mod bodies;
mod measure;
mod print;
mod rooms;
mod scenes;
mod sheets;
mod tables;
mod weight;

pub use tables::{Row, Step};

use gaunt::Error;
use gaunt::progress::Progress;
use measure::{Sight, Traced};
use scenes::CASES;
use serde::Serialize;
use sh_reference::paths::Source;
use std::path::PathBuf;

/// What to look at and how.
#[derive(Clone, Debug)]
pub struct Options {
    /// A folder for a sheet of pictures a scene; none for figures alone.
    pub out: Option<PathBuf>,
    /// Figures as JSON instead of tables.
    pub json: bool,
    /// Pixels across and down, each a receiver.
    pub size: [u32; 2],
    /// Paths a pixel, at least 2.
    pub paths: u32,
    /// Names of scenes and tables ([`names`]); empty for all.
    pub only: Vec<String>,
}

/// The tables besides the scenes'.
const TABLES: [&str; 6] = ["counts", "orders", "bends", "steps", "weights", "ways"];

/// All scenes and tables, by name.
///
/// ```
/// assert!(gaunt_lab::validate::names().any(|name| name == "bend-180"));
/// ```
pub fn names() -> impl Iterator<Item = &'static str> {
    let scenes = CASES.iter().map(|case| case.name);
    scenes.chain(TABLES).chain(rooms::names())
}

/// All tables; one that was not asked for is empty.
#[derive(Clone, Debug, Default, Serialize)]
struct Report {
    scenes: Vec<Row>,
    counts: Vec<Row>,
    orders: Vec<Row>,
    bends: Vec<Row>,
    steps: Vec<Step>,
    weights: Vec<weight::Row>,
    rooms: Vec<rooms::Row>,
}

/// Measures, writes the sheets if asked for, and returns the text to print.
///
/// # Errors
/// Where a name is none of [`names`], a size is too large, or a sheet cannot be written.
pub fn run(options: &Options) -> Result<String, Error> {
    if let Some(unknown) = options.only.iter().find(|o| !names().any(|n| n == *o)) {
        let names: Vec<_> = names().collect();
        return Err(Error::Usage(format!(
            "--only has \"{unknown}\", but there is {}",
            names.join(", ")
        )));
    }
    let most = sh_cpu::MAX_SIDE / 2;
    if options.size.iter().any(|side| *side > most) {
        return Err(Error::Usage(format!(
            "--size is {} x {}, but each side must be at most {most} pixels",
            options.size[0], options.size[1]
        )));
    }
    if let Some(folder) = &options.out {
        std::fs::create_dir_all(folder)
            .map_err(|source| Error::file("create", folder.display(), source))?;
    }
    let wanted = |name: &str| options.only.is_empty() || options.only.iter().any(|o| o == name);
    let traced = Traced {
        size: options.size,
        paths: options.paths,
    };
    let progress = Progress::new("lighting scenes");
    let all = names().filter(|name| wanted(name)).count().max(1) as f32;
    let mut done = 0.0;
    let mut finished = || {
        done += 1.0;
        progress.set(done / all);
    };
    let mut report = Report::default();
    for case in CASES.iter().filter(|case| wanted(case.name)) {
        let scene = case.scene();
        let sight = Sight::new(&scene, traced, Source::Projected)?;
        report
            .scenes
            .push(tables::row(case.name, &scene, &sight, Source::Projected)?);
        if let Some(folder) = &options.out {
            for scene in [&scene, &tables::patched(&scene)] {
                sheets::write(folder, (case.name, case.title), scene, &sight, options)?;
            }
        }
        finished();
    }
    for (name, rows, make) in [
        ("counts", &mut report.counts, tables::counts as Table),
        ("orders", &mut report.orders, tables::orders),
        ("bends", &mut report.bends, tables::bends),
    ] {
        if wanted(name) {
            *rows = make(traced)?;
            finished();
        }
    }
    if wanted("steps") {
        report.steps = tables::steps(traced)?;
        finished();
    }
    if wanted("weights") {
        report.weights = weight::rows();
    }
    for name in rooms::names() {
        if wanted(name) {
            report.rooms.extend(rooms::rows(name, traced, options)?);
            finished();
        }
    }
    if wanted("ways") {
        report.rooms.extend(rooms::ways(traced)?);
        finished();
    }
    progress.finish();
    if options.json {
        return Ok(serde_json::to_string_pretty(&report)?);
    }
    Ok(print::tables(&report))
}

type Table = fn(Traced) -> Result<Vec<Row>, Error>;
