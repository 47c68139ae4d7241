//! `gaunt-lab fit`: every fitted constant of the library, from its definition.
//!
//! | file in `codegen/data/` | holds | fitted to |
//! |---|---|---|
//! | `ball.txt` | polynomials of what is seen of a ball | its integral |
//! | `cap_log.txt` | polynomials of the logarithm of a circle's visibility | each exponential, against true visibilities; the eigen logarithm |
//! | `cap_log_table.txt` | the eigen logarithm at whole degrees | nothing: computed |
//! | `gloss.txt` | polynomials of the lobe of a polished surface | its integrals |
//! | `horizon.txt` | polynomials of the circle that stands for a sphere under a horizon | its form factor |
//! | `lens.txt` | polynomials of the common part of two discs | its inverse cosines |
//! | `optimal_linear.txt` | factors of the optimal linear exponential | circles |
//! | `shading.txt` | compression of the shadow pass's exponential, and polynomials of its logarithm | true transfers |
//! | `saturating.txt` | compression and gains of the saturating exponential | true visibilities, together with its logarithm |
//!
//! The library compiles the files in. A test refits and compares.

mod ball;
mod circles;
mod gloss;
mod horizon;
mod lens;
mod linear;
mod marquardt;
mod sets;
mod shading;
mod visibility;

use gaunt::Error;
use gaunt::image::Output;
use gaunt::progress::Progress;
use std::fmt::Write;
use std::path::Path;

/// A data file: its name in `codegen/data/` and its text.
pub struct DataFile {
    /// File name.
    pub name: &'static str,
    /// Contents.
    pub text: String,
}

/// The texts that grow order by order.
struct Texts {
    cap_log: String,
    cap_log_table: String,
    optimal_linear: String,
    saturating: String,
}

/// The files.
const NAMES: [&str; 9] = [
    "ball.txt",
    "cap_log.txt",
    "cap_log_table.txt",
    "gloss.txt",
    "horizon.txt",
    "lens.txt",
    "optimal_linear.txt",
    "saturating.txt",
    "shading.txt",
];

/// Fitted data: all of it, or one file by name. `progress` is told the part that is done, 0 to 1.
pub fn all(only: Option<&str>, progress: &(dyn Fn(f32) + Sync)) -> Vec<DataFile> {
    let wanted = |name: &str| only.is_none_or(|only| only == name);
    let mut files = Vec::new();
    let mut put = |name: &'static str, text: &mut dyn FnMut() -> String| {
        if wanted(name) {
            files.push(DataFile { name, text: text() });
        }
    };
    put("ball.txt", &mut ball::text);
    put("gloss.txt", &mut gloss::text);
    put("horizon.txt", &mut horizon::text);
    put("lens.txt", &mut lens::text);
    put("shading.txt", &mut || shading(&|part| progress(0.3 * part)));
    // Those that are fitted together, as one starts from another.
    let together = [
        "cap_log.txt",
        "cap_log_table.txt",
        "optimal_linear.txt",
        "saturating.txt",
    ];
    if together.iter().any(|name| wanted(name)) {
        let texts = together
            .into_iter()
            .zip(logarithms(&|part| progress(0.3 + 0.7 * part)));
        files.extend(
            texts
                .filter(|(name, _)| wanted(name))
                .map(|(name, text)| DataFile { name, text }),
        );
    }
    files.sort_by_key(|file| file.name);
    files
}

/// Shares of the time by order.
const SHARES: [f32; 6] = [0.0, 0.03, 0.1, 0.25, 0.5, 1.0];

fn shading(progress: &(dyn Fn(f32) + Sync)) -> String {
    let mut text = String::from(
        "# The exponential of the shadow pass and its cap logarithm f_l = sin^2(t) p_l(2 cos t - 1), t in 0..90 degrees, fitted\n\
         # to true transfers.\n\
         # Written by `gaunt-lab fit`. Columns: `compression` or `log`, order, the compression or the coefficients of p_l from\n\
         # the lowest power; a row a band.\n",
    );
    let fits = [
        shading::fit::<4>,
        shading::fit::<9>,
        shading::fit::<16>,
        shading::fit::<25>,
        shading::fit::<36>,
    ];
    for (fit, share) in fits.into_iter().zip(&SHARES[1..]) {
        fit(&mut text);
        progress(*share);
    }
    text
}

/// `cap_log.txt`, `cap_log_table.txt`, `optimal_linear.txt` and `saturating.txt`.
fn logarithms(progress: &(dyn Fn(f32) + Sync)) -> [String; 4] {
    let mut texts = Texts {
        cap_log: String::from(
            "# The logarithm of a cap's visibility, fitted: f_l = sin^2(t) p_l(2 cos t - 1), t in 0..90 degrees.\n\
             # `eigen`: least squares against the eigen logarithm (Ren et al. 2006, eq. 30-32) over half degrees.\n\
             # All others: against true visibilities, so that the exponential of that name errs least.\n\
             # Written by `gaunt-lab fit`. Columns: what it is fitted to, order, coefficients of p_l from the lowest\n\
             # power; a row a band.\n",
        ),
        cap_log_table: String::from(
            "# The eigen logarithm of a cap's visibility (Ren et al. 2006, eq. 30-32, clipped at 0.02).\n\
             # Written by `gaunt-lab fit`. Columns: order, n zonal coefficients; a row a degree, 0..179.\n",
        ),
        optimal_linear: String::from(
            "# Factors a and b of the optimal linear exponential (Ren et al. 2006, eq. 23-24).\n\
             # Written by `gaunt-lab fit`. Columns: `small` (|f| in 0..1/4) or `wide` (powers of |f|/range), order,\n\
             # coefficients from the lowest power, first a, then b; `range`, order, the range.\n",
        ),
        saturating: String::from(
            "# The saturating exponential, fitted with its cap logarithm (`saturating` in cap_log.txt).\n\
             # Written by `gaunt-lab fit`. Columns: order, compression, gain of each band.\n",
        ),
    };
    order::<4>(&mut texts, &part(progress, &SHARES, 0));
    order::<9>(&mut texts, &part(progress, &SHARES, 1));
    order::<16>(&mut texts, &part(progress, &SHARES, 2));
    order::<25>(&mut texts, &part(progress, &SHARES, 3));
    order::<36>(&mut texts, &part(progress, &SHARES, 4));
    [
        texts.cap_log,
        texts.cap_log_table,
        texts.optimal_linear,
        texts.saturating,
    ]
}

/// Progress within one order.
fn part(progress: &(dyn Fn(f32) + Sync), shares: &[f32], order: usize) -> impl Fn(f32) + Sync {
    let (from, to) = (shares[order], shares[order + 1]);
    move |done| progress(from + done * (to - from))
}

fn order<const C: usize>(texts: &mut Texts, progress: &(dyn Fn(f32) + Sync))
where
    [f64; C]: sh_core::log::Logarithm,
{
    circles::cap_log_table::<C>(&mut texts.cap_log_table);
    linear::optimal_linear::<C>(&mut texts.optimal_linear);
    let start = circles::cap_log::<C>(&mut texts.cap_log);
    visibility::fit::<C>(&start, texts, progress);
}

/// Writes fitted data into a folder that exists, all of it or one file by name, and says what changed.
pub fn write(folder: &Path, only: Option<&str>) -> Result<String, Error> {
    if let Some(only) = only.filter(|only| !NAMES.contains(only)) {
        let names = NAMES.join(", ");
        return Err(Error::Usage(format!(
            "--only is {only}, but the files are {names}"
        )));
    }
    if !folder.is_dir() {
        let folder = folder.display();
        return Err(Error::Usage(format!(
            "{folder} is no folder: run this at the root of the sources, or name one with --out"
        )));
    }
    let progress = Progress::new("fitting");
    let files = all(only, &|part| progress.set(part));
    progress.finish();
    let mut lines = Vec::new();
    for DataFile { name, text } in files {
        let path = folder.join(name);
        let before = std::fs::read_to_string(&path).ok();
        let verdict = match before {
            Some(before) if before == text => "unchanged",
            Some(_) => "changed",
            None => "new",
        };
        if verdict != "unchanged" {
            Output::create(&path)?.finish(|file| {
                use std::io::Write;
                let written = file.write_all(text.as_bytes());
                written.map_err(|source| Error::file("write to", path.display(), source))
            })?;
        }
        lines.push(format!("{} {verdict}", path.display()));
    }
    Ok(lines.join("\n"))
}

/// One row of numbers behind words.
fn row(text: &mut String, words: &str, values: &[f64]) {
    write!(text, "{words}").expect("writing to a string");
    for v in values {
        // Seven significant digits: beyond the fit's own error, short enough to read.
        write!(text, " {v:.7e}").expect("writing to a string");
    }
    text.push('\n');
}
