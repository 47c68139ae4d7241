//! three.js: the nine colours of `SphericalHarmonics3`, as `LightProbe` has them.
//!
//! Radiance in the order, with the signs and axes used here: only the places of colours and coefficients differ.
//! `getIrradianceAt` and the shader multiply by the cosine lobe, without dividing by π: what they give is irradiance.
//!
//! glTF's EXT_lights_image_based calls its coefficients irradiance and states no formula; importers disagree whether
//! the cosine lobe is in them. For that reason there is no adapter for it.
//!
//! Source: `SphericalHarmonics3.getAt` and `getIrradianceAt`, which cite Ramamoorthi and Hanrahan 2001.
//!
//! ```
//! use sh_core::{Sh3, ShRgb, convention::three};
//! let light = Sh3::cosine([0.36, 0.48, 0.8]);
//! assert_eq!(three::light_probe(&ShRgb::gray(light))[4], [light[4]; 3]);
//! ```

use super::{channels, interleaved};
use crate::{Sh, ShRgb};

/// Radiance to the 9 coefficients of a `SphericalHarmonics3`, a colour each. Exact.
///
/// ```
/// use sh_core::{Sh3, ShRgb, convention::three};
/// let probe = three::light_probe(&ShRgb::gray(Sh3::ONE));
/// assert!((probe[0][2] - 3.5449077).abs() < 1e-6);
/// ```
pub fn light_probe(light: &ShRgb<f32, 9>) -> [[f32; 3]; 9] {
    interleaved([light.r.0, light.g.0, light.b.0])
}

/// Radiance from the coefficients of a `SphericalHarmonics3`. The way back from [`light_probe`]; exact.
///
/// ```
/// use sh_core::{Sh3, ShRgb, convention::three};
/// let light = ShRgb::gray(Sh3::cosine([0.36, 0.48, 0.8]));
/// assert_eq!(three::from_light_probe(&three::light_probe(&light)), light);
/// ```
pub fn from_light_probe(coefficients: &[[f32; 3]; 9]) -> ShRgb<f32, 9> {
    let [r, g, b] = channels(coefficients).map(Sh);
    ShRgb { r, g, b }
}
