//! Filament: `IndirectLight::Builder::irradiance` and `radiance`, three bands, nine `float3`.
//!
//! `irradiance` takes coefficients that are convolved with the cosine lobe, divided by π and multiplied by the basis'
//! factors: they belong to the polynomials 1, y, z, x, xy, yz, 3z² − 1, zx, x² − y², so that the sign of the basis
//! drops out. `radiance` takes those of radiance in a basis with the sign (−1)^m. Axes are as here; `cmgen` mirrors
//! environments by default, which is a matter of the map and not of the vector.
//!
//! Source: the reference of `IndirectLight::Builder` for both, with its table of factors A_l^m; Filament's
//! `Irradiance_SphericalHarmonics` for the polynomial.
//!
//! ```
//! use sh_core::{Sh3, ShRgb, convention::filament};
//! let sh = filament::irradiance(&ShRgb::gray(Sh3::ONE * 0.5));
//! assert!((sh[0][0] - 0.5).abs() < 1e-6 && sh[1..] == [[0.0; 3]; 8]);
//! ```

use super::{channels, condon_shortley, from_polynomial, interleaved, polynomial};
use crate::{Sh, ShRgb};

/// Radiance to what `irradiance(3, sh)` takes: `sh[coefficient][channel]`. A relative error of 2 u a coefficient.
///
/// ```
/// use sh_core::{Sh3, ShRgb, convention::filament};
/// let sh = filament::irradiance(&ShRgb::gray(Sh3::cosine([0.0, 1.0, 0.0])));
/// assert!(sh[1][0] > 0.1 && sh[3][0] == 0.0);
/// ```
pub fn irradiance(light: &ShRgb<f32, 9>) -> [[f32; 3]; 9] {
    interleaved(polynomial(light))
}

/// Radiance from what `irradiance(3, sh)` takes, `cmgen`'s `sh.txt` for one. The way back from [`irradiance`].
///
/// ```
/// use sh_core::{Sh3, ShRgb, convention::filament};
/// let light = ShRgb::gray(Sh3::cosine([0.36, 0.48, 0.8]));
/// let back = filament::from_irradiance(&filament::irradiance(&light));
/// assert!((back.r - light.r).norm() < 1e-6);
/// ```
pub fn from_irradiance(sh: &[[f32; 3]; 9]) -> ShRgb<f32, 9> {
    from_polynomial(channels(sh))
}

/// Radiance to what `radiance(3, sh)` takes: `sh[coefficient][channel]`. Exact.
///
/// ```
/// use sh_core::{Sh3, ShRgb, convention::filament};
/// let light = Sh3::cosine([0.36, 0.48, 0.8]);
/// assert_eq!(filament::radiance(&ShRgb::gray(light))[3][0], -light[3]);
/// ```
pub fn radiance(light: &ShRgb<f32, 9>) -> [[f32; 3]; 9] {
    interleaved([light.r, light.g, light.b].map(|f| condon_shortley(&f).0))
}

/// Radiance from what `radiance(3, sh)` takes. The way back from [`radiance`]; exact.
///
/// ```
/// use sh_core::{Sh3, ShRgb, convention::filament};
/// let light = ShRgb::gray(Sh3::cosine([0.36, 0.48, 0.8]));
/// assert_eq!(filament::from_radiance(&filament::radiance(&light)), light);
/// ```
pub fn from_radiance(sh: &[[f32; 3]; 9]) -> ShRgb<f32, 9> {
    let [r, g, b] = channels(sh).map(|f| condon_shortley(&Sh(f)));
    ShRgb { r, g, b }
}
