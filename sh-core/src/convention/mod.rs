//! Vectors as other engines write them: order, signs, factors of π, radiance or irradiance, axes.
//!
//! | engine | function | holds | order and signs | factors | axes |
//! |---|---|---|---|---|---|
//! | Unity | [`unity::probe`], [`unity::shader`] | irradiance over π | as here | basis and cosine lobe multiplied in | [`Axes::UNITY`] |
//! | Unreal, D3D | [`unreal::vector`] | radiance | (−1)^m | none | [`Axes::UNREAL`] |
//! | | [`unreal::sky`] | irradiance over π | of the polynomial | basis and cosine lobe multiplied in | the same |
//! | Filament | [`filament::radiance`] | radiance | (−1)^m | none | as here |
//! | | [`filament::irradiance`] | irradiance over π | of the polynomial | basis and cosine lobe multiplied in | as here |
//! | three.js | [`three::light_probe`] | radiance | as here | none | as here |
//! | Bevy, glTF | none needed | | | | as here |
//!
//! *Irradiance over π* is what a white diffuse surface reflects: the dot product with
//! [`Routines::cosine`]. All adapters take and return radiance in this crate's own convention, and every one has
//! its way back. Colours stay linear Rec.709; units stay the caller's (Filament multiplies by its own intensity
//! in lux afterwards).
//!
//! Vectors of order 3 go in and come out: [`ShRgb::to_order`] brings others there.
//!
//! [`Axes`] alone is for everything else: it turns directions and vectors of any order to other axes, left-handed
//! ones among them.
//!
//! ```
//! use sh_core::{Sh3, ShRgb, convention::{Axes, filament, unity}};
//! let light = ShRgb::gray(Sh3::ONE * 0.5);
//! // Everywhere 0.5: each engine's constant term says so.
//! assert!((unity::probe(&light, Axes::UNITY)[0][0] - 0.5).abs() < 1e-6);
//! assert!((filament::irradiance(&light)[0][0] - 0.5).abs() < 1e-6);
//! assert_eq!(Axes::UNITY.direction([1.0_f32, 2.0, 3.0]), [1.0, 2.0, -3.0]);
//! ```

mod axes;
pub mod filament;
pub mod three;
pub mod unity;
pub mod unreal;

pub use axes::{Axes, Axis};

use crate::{Lane, Routines, Sh, ShRgb};
use core::f64::consts::FRAC_1_SQRT_2;

/// `f` with the Condon–Shortley sign (−1)^m on every coefficient, which D3D, Unreal and Filament's radiance
/// have. Its own inverse; exact.
///
/// Source: Sloan 2008, "Stupid Spherical Harmonics (SH) Tricks", appendix A2.
///
/// ```
/// use sh_core::{Sh2, convention::condon_shortley};
/// let f = Sh2::basis([0.36, 0.48, 0.8]);
/// assert_eq!(condon_shortley(&f).0, [f[0], -f[1], f[2], -f[3]]);
/// ```
pub fn condon_shortley<L: Lane, const C: usize>(f: &Sh<L, C>) -> Sh<L, C>
where
    [L; C]: Routines<L>,
{
    signed(f, |_, m| m % 2 != 0)
}

/// `f` with the coefficients of the bands l and m negated that `negative` names.
fn signed<L: Lane, const C: usize>(f: &Sh<L, C>, negative: impl Fn(i32, i32) -> bool) -> Sh<L, C>
where
    [L; C]: Routines<L>,
{
    let mut out = *f;
    for l in 0..<[L; C]>::ORDER as i32 {
        for m in -l..=l {
            let value = &mut out[(l * l + l + m) as usize];
            if negative(l, m) {
                *value = -*value;
            }
        }
    }
    out
}

/// What a coefficient of radiance is multiplied by to become that of the polynomials 1, y, z, x, xy, yz,
/// 3z² − 1, zx, x² − y² whose sum is irradiance over π.
///
/// Each function of the cosine lobe is one of them times its factor: it is read off where the polynomial is ±1,
/// 1/2 or 2.
fn polynomial_factors() -> [f32; 9] {
    let at = |d| <[f64; 9]>::cosine(d);
    let r = FRAC_1_SQRT_2;
    let (x, y, z) = (
        at([1.0, 0.0, 0.0]),
        at([0.0, 1.0, 0.0]),
        at([0.0, 0.0, 1.0]),
    );
    let (xy, yz, zx) = (at([r, r, 0.0]), at([0.0, r, r]), at([r, 0.0, r]));
    [
        x[0],
        y[1],
        z[2],
        x[3],
        xy[4] * 2.0,
        yz[5] * 2.0,
        z[6] / 2.0,
        zx[7] * 2.0,
        x[8],
    ]
    .map(|factor| factor as f32)
}

/// Radiance to the coefficients of the polynomials, a row a channel.
fn polynomial(light: &ShRgb<f32, 9>) -> [[f32; 9]; 3] {
    let factors = polynomial_factors();
    [light.r, light.g, light.b].map(|f| core::array::from_fn(|i| f[i] * factors[i]))
}

/// The way back from [`polynomial`].
fn from_polynomial(rows: [[f32; 9]; 3]) -> ShRgb<f32, 9> {
    let factors = polynomial_factors();
    let [r, g, b] = rows.map(|row| Sh(core::array::from_fn(|i| row[i] / factors[i])));
    ShRgb { r, g, b }
}

/// The nine terms of each channel as seven vectors that a shader takes dot products with: constant and linear
/// terms (x, y, z, 1) of red, green and blue, quadratic ones (xy, yz, z², zx) of each, x² − y² of all.
///
/// Source: Sloan 2008, appendix A10; Unity and Unreal share it.
fn packed(rows: [[f32; 9]; 3]) -> [[f32; 4]; 7] {
    let linear = rows.map(|c| [c[3], c[1], c[2], c[0] - c[6]]);
    let quadratic = rows.map(|c| [c[4], c[5], c[6] * 3.0, c[7]]);
    let last = [rows[0][8], rows[1][8], rows[2][8], 1.0];
    let ([a, b, c], [d, e, f]) = (linear, quadratic);
    [a, b, c, d, e, f, last]
}

/// The way back from [`packed`].
fn unpacked(rows: &[[f32; 4]; 7]) -> [[f32; 9]; 3] {
    core::array::from_fn(|channel| {
        let (a, b) = (rows[channel], rows[channel + 3]);
        let zonal = b[2] / 3.0;
        let constant = a[3] + zonal;
        let last = rows[6][channel];
        [constant, a[1], a[2], a[0], b[0], b[1], zonal, b[3], last]
    })
}

/// Coefficient by coefficient, red, green and blue together.
fn interleaved(rows: [[f32; 9]; 3]) -> [[f32; 3]; 9] {
    core::array::from_fn(|i| rows.map(|row| row[i]))
}

/// The way back from [`interleaved`].
fn channels(colours: &[[f32; 3]; 9]) -> [[f32; 9]; 3] {
    core::array::from_fn(|channel| colours.map(|colour| colour[channel]))
}
