//! `gaunt fit`: every fitted constant of the library, from its definition.
//!
//! The results are the text files of `codegen/data/`, which the library compiles in. A test refits and
//! compares.

use crate::Error;
use crate::image::Output;
use crate::progress::Progress;
use nalgebra::{DMatrix, DVector};
use sh_core::log::Logarithm;
use sh_core::{ROOT_FOUR_PI, Routines, cap};
use std::fmt::Write;
use std::path::Path;

/// A data file: its name in `codegen/data/` and its text.
pub struct DataFile {
    /// File name.
    pub name: &'static str,
    /// Contents.
    pub text: String,
}

/// Degree of the cap logarithm's polynomials.
const CAP_LOG_DEGREE: usize = 7;

/// Degree of the optimal linear factors' polynomials.
const OPTIMAL_LINEAR_DEGREE: usize = 3;

/// All fitted data. `progress` is told the part that is done, 0 to 1.
pub fn all(progress: &dyn Fn(f32)) -> Vec<DataFile> {
    let mut log = String::from(
        "# The logarithm of a cap's visibility, fitted: f_l = sin^2(t) p_l(2 cos t - 1), t in 0..90 degrees.\n\
         # Least squares against the eigen logarithm (Ren et al. 2006, eq. 30-32) over half degrees.\n\
         # Written by `gaunt fit`. Columns: order, coefficients of p_l from the lowest power; a row a band.\n",
    );
    let mut table = String::from(
        "# The eigen logarithm of a cap's visibility (Ren et al. 2006, eq. 30-32, clipped at 0.02).\n\
         # Written by `gaunt fit`. Columns: order, n zonal coefficients; a row a degree, 0..179.\n",
    );
    let mut linear = String::from(
        "# Factors a and b of the optimal linear exponential (Ren et al. 2006, eq. 23-24), |f| in 0..1/4.\n\
         # Written by `gaunt fit`. Columns: order, coefficients from the lowest power; first a, then b.\n",
    );
    fn order<const C: usize>(texts: &mut [&mut String; 3])
    where
        [f64; C]: Logarithm,
    {
        cap_log::<C>(texts[0]);
        cap_log_table::<C>(texts[1]);
        optimal_linear::<C>(texts[2]);
    }
    let mut texts = [&mut log, &mut table, &mut linear];
    order::<4>(&mut texts);
    progress(0.02);
    order::<9>(&mut texts);
    progress(0.08);
    order::<16>(&mut texts);
    progress(0.25);
    order::<25>(&mut texts);
    progress(0.5);
    order::<36>(&mut texts);
    progress(1.0);
    vec![
        DataFile {
            name: "cap_log.txt",
            text: log,
        },
        DataFile {
            name: "cap_log_table.txt",
            text: table,
        },
        DataFile {
            name: "optimal_linear.txt",
            text: linear,
        },
    ]
}

/// Writes all fitted data into a folder that exists, and says what changed.
pub fn write(folder: &Path) -> Result<String, Error> {
    if !folder.is_dir() {
        let folder = folder.display();
        return Err(Error::Usage(format!(
            "{folder} is no folder: run this at the root of the sources, or name one with --out"
        )));
    }
    let progress = Progress::new("fitting");
    let files = all(&|part| progress.set(part));
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

/// The eigen logarithm of a cap of angular radius `angle`: its zonal coefficients.
pub fn eigen_log<const C: usize>(angle: f64) -> Vec<f64>
where
    [f64; C]: Logarithm,
{
    let zonal = cap::visibility::<C>(angle);
    let log = <[f64; C]>::zonal(zonal, [0.0, 0.0, 1.0]).log();
    (0..<[f64; C]>::ORDER).map(|l| log[l * l + l]).collect()
}

/// Solves min ‖A x − b‖.
fn least_squares(a: DMatrix<f64>, b: &DVector<f64>) -> Vec<f64> {
    let svd = a.svd(true, true);
    svd.solve(b, 1e-13)
        .expect("both sides of the decomposition were asked for")
        .as_slice()
        .to_vec()
}

fn row(text: &mut String, order: usize, values: &[f64]) {
    write!(text, "{order}").expect("writing to a string");
    for v in values {
        // Seven significant digits: beyond the fit's own error, short enough to read.
        write!(text, " {v:.7e}").expect("writing to a string");
    }
    text.push('\n');
}

fn cap_log<const C: usize>(text: &mut String)
where
    [f64; C]: Logarithm,
{
    let n = <[f64; C]>::ORDER;
    let angles: Vec<f64> = (1..=180).map(|i| f64::from(i).to_radians() / 2.0).collect();
    let truth: Vec<Vec<f64>> = angles.iter().map(|t| eigen_log::<C>(*t)).collect();
    // Weighted with 1/sin² θ, that is with one over the solid angle: a distant blocker must cast its shadow as
    // exactly, for its size, as a near one.
    let design = DMatrix::from_fn(angles.len(), CAP_LOG_DEGREE + 1, |i, k| {
        (2.0 * angles[i].cos() - 1.0).powi(k as i32)
    });
    let fits: Vec<Vec<f64>> = (0..n)
        .map(|l| {
            let target = DVector::from_iterator(
                angles.len(),
                angles
                    .iter()
                    .zip(&truth)
                    .map(|(t, f)| f[l] / t.sin().powi(2)),
            );
            least_squares(design.clone(), &target)
        })
        .collect();
    let error = |l: usize| {
        angles.iter().zip(&truth).fold(0.0_f64, |worst, (t, f)| {
            let u = 2.0 * t.cos() - 1.0;
            let p = fits[l].iter().rev().fold(0.0, |p, c| p * u + c);
            worst.max((t.sin().powi(2) * p - f[l]).abs())
        })
    };
    let errors: Vec<String> = (0..n).map(|l| format!("{:.3}", error(l))).collect();
    writeln!(
        text,
        "# order {n}: largest error by band {}",
        errors.join(" ")
    )
    .expect("writing to a string");
    for fit in fits {
        row(text, n, &fit);
    }
}

fn cap_log_table<const C: usize>(text: &mut String)
where
    [f64; C]: Logarithm,
{
    for degree in 0..180 {
        row(
            text,
            <[f64; C]>::ORDER,
            &eigen_log::<C>(f64::from(degree).to_radians()),
        );
    }
}

/// Pairs (‖f̂‖, a, b) of circles of growing radius, least squares per circle (eq. 24), up to a norm of 1/4.
fn optimal_linear<const C: usize>(text: &mut String)
where
    [f64; C]: Logarithm,
{
    let n = <[f64; C]>::ORDER;
    let mut samples = Vec::new();
    for i in 1.. {
        let angle = f64::from(i).to_radians() / 8.0;
        let g = cap::visibility::<C>(angle);
        let f = eigen_log::<C>(angle);
        let square: f64 = f[1..].iter().map(|x| x * x).sum();
        if square.sqrt() > 0.25 {
            break;
        }
        let dc = (-f[0] / ROOT_FOUR_PI).exp();
        let a = dc * g.as_ref()[0] / ROOT_FOUR_PI;
        let b = dc
            * g.as_ref()[1..]
                .iter()
                .zip(&f[1..])
                .map(|(g, f)| g * f)
                .sum::<f64>()
            / square;
        samples.push((square.sqrt(), a, b));
    }
    // a(0) = b(0) = 1 exactly: an empty blocker leaves full visibility.
    let design = DMatrix::from_fn(samples.len(), OPTIMAL_LINEAR_DEGREE, |i, k| {
        samples[i].0.powi(k as i32 + 1)
    });
    let fit = |value: &dyn Fn(&(f64, f64, f64)) -> f64| {
        let target = DVector::from_iterator(samples.len(), samples.iter().map(|s| value(s) - 1.0));
        let mut c = least_squares(design.clone(), &target);
        c.insert(0, 1.0);
        let error = samples.iter().fold(0.0_f64, |worst, s| {
            worst.max((c.iter().rev().fold(0.0, |p, c| p * s.0 + c) - value(s)).abs())
        });
        (c, error)
    };
    let ((a, error_a), (b, error_b)) = (fit(&|s| s.1), fit(&|s| s.2));
    writeln!(
        text,
        "# order {n}: largest error {error_a:.1e} {error_b:.1e}"
    )
    .expect("writing to a string");
    row(text, n, &a);
    row(text, n, &b);
}
