//! `gaunt-lab accuracy`: what every exponential and logarithm costs, in error and in time.
//!
//! | module | does |
//! |---|---|
//! | [`methods`] | lists what is compared |
//! | [`errors`] | measures errors against the truth |
//! | [`operations`] | counts operations |
//! | [`times`] | measures times, one number at a time and in vector lanes |
//! | [`pictures`] | measures whole pictures against ray-cast ones |
//! | [`pareto`], [`chart`], [`table`], [`page`] | find the front, draw it, print it |

pub mod chart;
pub mod errors;
mod lanes;
pub mod methods;
pub mod operations;
pub mod page;
pub mod pareto;
pub mod pictures;
mod sets;
pub mod table;
pub mod times;

use gaunt::Error;
use gaunt::image::Output;
use gaunt::progress::Progress;
use serde::Serialize;
use std::io::Write;
use std::path::{Path, PathBuf};

/// One way to a receiver's visibility, measured.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// SH order of the result, 2 to 6.
    pub order: usize,
    /// What the sum of logarithms is exponentiated by; `product chain` has no logarithm.
    pub exponential: String,
    /// What the logarithm of a blocker is: `fitted` to the exponential, `eigen`, `samples` or `none`.
    pub logarithm: String,
    /// SH order that logarithms are summed and exponentiated in, at least `order`.
    pub accumulation_order: usize,
    /// `scalar` or `lanes`.
    pub backend: String,
    /// Mean of ‖g − V‖/√4π over 1,000 random sets of blockers, V being the projected true visibility.
    pub mean: f64,
    /// Its 95th percentile.
    pub p95: f64,
    /// Its maximum.
    pub max: f64,
    /// The largest difference that single precision makes, over √4π.
    pub rounding: f64,
    /// Multiplications a receiver, on average.
    pub mul: f64,
    /// Additions a receiver, on average.
    pub add: f64,
    /// Exponentials of numbers a receiver.
    pub exp: f64,
    /// Nanoseconds a receiver; none where this backend has no such method.
    pub ns: Option<f64>,
    /// Mean error over sets of blockers that nearly coincide.
    pub heavy: f64,
    /// Largest error over 1 to 4,096 identical blockers.
    pub stacked: f64,
    /// Mean of ‖g − exp(f)‖/√4π against the exact exponential of the same sum, projected; none where that sum is
    /// no logarithm.
    pub from_exact: Option<f64>,
}

/// One whole picture, measured against a ray-cast truth.
#[derive(Clone, Debug, Serialize)]
pub struct PictureRow {
    /// Which scene.
    pub scene: String,
    /// SH order of the light.
    pub order: usize,
    /// SH order that logarithms are summed in.
    pub accumulation_order: usize,
    /// Spheres of the whole scene.
    pub spheres: usize,
    /// What the scene's own numbers of spheres were multiplied with.
    pub factor: f32,
    /// Root of the mean square of the difference in luminance, over the mean.
    pub rms: f64,
    /// Mean of the difference, over the mean.
    pub bias: f64,
    /// Milliseconds of the shadow pass for a million receivers.
    pub ms: f64,
}

/// Where results go besides the terminal.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Rows as JSON.
    pub json: Option<PathBuf>,
    /// The chart of methods, .svg or .png; the chart of pictures goes beside it, with `-pictures` in its name.
    pub plot: Option<PathBuf>,
    /// The page that sums it all up.
    pub page: Option<PathBuf>,
}

/// Everything that was measured.
#[derive(Clone, Debug, Serialize)]
pub struct Results {
    /// Methods.
    pub methods: Vec<Row>,
    /// Pictures.
    pub pictures: Vec<PictureRow>,
}

/// Measures everything, writes what was asked for, and returns the table for the terminal.
pub fn run(options: &Options) -> Result<String, Error> {
    let progress = Progress::new("methods");
    // First whatever can fail at once.
    let json = options.json.as_deref().map(Output::create).transpose()?;
    let page = options.page.as_deref().map(Output::create).transpose()?;
    if let Some(plot) = &options.plot {
        chart::check(plot)?;
    }
    let methods = rows(&|part| progress.set(0.7 * part));
    progress.say("pictures");
    let pictures = pictures::rows(&|part| progress.set(0.7 + 0.3 * part))?;
    let results = Results { methods, pictures };
    progress.finish();
    if let (Some(output), Some(path)) = (json, &options.json) {
        // An infinite error is no JSON number: it becomes null.
        let text = serde_json::to_string_pretty(&results.methods)?;
        write(output, path, &text)?;
    }
    if let Some(plot) = &options.plot {
        chart::methods(&results.methods, plot)?;
        chart::pictures(&results.pictures, &beside(plot))?;
    }
    if let (Some(output), Some(path)) = (page, &options.page) {
        let charts = options
            .plot
            .as_ref()
            .map(|plot| (plot.clone(), beside(plot)));
        write(output, path, &page::markdown(&results, charts.as_ref()))?;
    }
    Ok(table::text(&results.methods))
}

/// All rows of the methods.
pub fn rows(progress: &(dyn Fn(f32) + Sync)) -> Vec<Row> {
    let sets = sets::Sets::standard();
    let mut rows = Vec::new();
    errors::order::<4>(&sets, &mut rows, &|part| progress(0.05 * part));
    errors::order::<9>(&sets, &mut rows, &|part| progress(0.05 + 0.1 * part));
    errors::order::<16>(&sets, &mut rows, &|part| progress(0.15 + 0.15 * part));
    errors::order::<25>(&sets, &mut rows, &|part| progress(0.3 + 0.25 * part));
    errors::order::<36>(&sets, &mut rows, &|part| progress(0.55 + 0.45 * part));
    rows.sort_by_key(|row| row.order);
    rows
}

/// `a.svg` to `a-pictures.svg`.
fn beside(plot: &Path) -> PathBuf {
    let stem = plot.file_stem().unwrap_or_default().to_string_lossy();
    let ending = plot.extension().unwrap_or_default().to_string_lossy();
    plot.with_file_name(format!("{stem}-pictures.{ending}"))
}

fn write(output: Output, path: &Path, text: &str) -> Result<(), Error> {
    output.finish(|file| {
        let written = writeln!(file, "{}", text.trim_end());
        written.map_err(|source| Error::file("write to", path.display(), source))
    })
}
