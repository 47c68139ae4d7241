//! The lobe of a polished surface.

use super::marquardt::least_squares;
use super::row;
use nalgebra::{DMatrix, DVector};
use sh_reference::ball::legendre;
use sh_reference::gloss::Gloss;
use std::f64::consts::PI;
use std::fmt::Write;

/// Roughnesses and cosines that the fit sees, each.
const STEPS: usize = 48;

/// The highest band that there are routines for.
const BANDS: usize = 5;

/// The highest power of x, and that of y for what grows as Fresnel's reflectance does, to the fifth power, and for the rest.
const X: usize = 4;
const Y_FRESNEL: usize = 5;
const Y: usize = 4;

/// The least roughness and cosine: below both nothing changes that a picture shows.
const LEAST: [f64; 2] = [0.02, 0.004];

/// A lobe's numbers, in the order of the file.
struct Case {
    x: f64,
    y: f64,
    /// The root of what it counts.
    counts: f64,
    numbers: [f64; 3 + BANDS],
}

/// Places between 0 and 1, more of them at both ends, and what each stands for.
fn places() -> impl Iterator<Item = (f64, f64)> {
    (0..STEPS).map(|i| {
        let turn = PI * (i as f64 + 0.5) / STEPS as f64;
        (0.5 - 0.5 * turn.cos(), turn.sin())
    })
}

impl Case {
    fn new((roughness, one): (f64, f64), (cosine, other): (f64, f64)) -> Self {
        let (roughness, cosine) = (roughness.max(LEAST[0]), cosine.max(LEAST[1]));
        let sine = (1.0 - cosine * cosine).sqrt();
        let lobe = Gloss::new(roughness, [0.0, 0.0, 1.0], [sine, 0.0, cosine]);
        let mean = [0, 2].map(|k| lobe.sum(|d| d[k]));
        let length = mean[0].hypot(mean[1]);
        let axis = mean.map(|c| c / length);
        let bands = (1..=BANDS).map(|l| {
            let sum = lobe.sum(|d| legendre(l, axis[0] * d[0] + axis[1] * d[2]));
            sum / lobe.energy()
        });
        let mut numbers = [0.0; 3 + BANDS];
        numbers[0] = lobe.energy();
        numbers[1] = lobe.grazing();
        numbers[2] = -axis[0] / sine.max(1e-6);
        for (number, band) in numbers[3..].iter_mut().zip(bands) {
            *number = band;
        }
        Self {
            x: 2.0 * roughness - 1.0,
            y: 2.0 * cosine - 1.0,
            counts: (one * other).sqrt(),
            numbers,
        }
    }
}

/// Polynomials in roughness and cosine of what a lobe mirrors, where its axis is and how wide it is about that.
pub(super) fn text() -> String {
    let mut text = String::from(
        "# The lobe of a polished surface (GGX, correlated Smith shadowing), fitted to its integrals: polynomials in x = 2 r - 1 and\n\
         # y = 2 m - 1, r the roughness and m the cosine between the normal and the direction to the viewer. `energy` is what it\n\
         # mirrors of an even sky, `grazing` the same times (1 - h . v)^5, `tilt` the sine of its axis over that of the mirrored\n\
         # direction, `band l` the mean of P_l about that axis.\n\
         # Written by `gaunt-lab fit`. Columns: name, power of x, coefficients from the lowest power of y.\n",
    );
    let cases: Vec<Case> = places()
        .flat_map(|roughness| places().map(move |cosine| Case::new(roughness, cosine)))
        .collect();
    let names = ["energy", "grazing", "tilt"].map(String::from);
    let bands = (1..=BANDS).map(|l| format!("band {l}"));
    for (k, name) in names.into_iter().chain(bands).enumerate() {
        let last = if k < 2 { Y_FRESNEL } else { Y };
        let terms = (X + 1) * (last + 1);
        let plain = DMatrix::from_fn(cases.len(), terms, |i, term| {
            let (a, b) = (term / (last + 1), term % (last + 1));
            cases[i].x.powi(a as i32) * cases[i].y.powi(b as i32)
        });
        let counts = DVector::from_iterator(cases.len(), cases.iter().map(|case| case.counts));
        let values = DVector::from_iterator(cases.len(), cases.iter().map(|case| case.numbers[k]));
        let weighed = DMatrix::from_fn(cases.len(), terms, |i, term| counts[i] * plain[(i, term)]);
        let fitted = least_squares(weighed, &values.component_mul(&counts));
        let off = &plain * DVector::from_column_slice(&fitted) - &values;
        let mean = (off.norm_squared() / cases.len() as f64).sqrt();
        writeln!(
            text,
            "# {name}: largest error {:.4}, root of its mean square {mean:.4}",
            off.amax()
        )
        .expect("writing to a string");
        for (power, along) in fitted.chunks(last + 1).enumerate() {
            row(&mut text, &format!("{name} {power}"), along);
        }
    }
    text
}
