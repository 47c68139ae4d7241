//! Unity: `SphericalHarmonicsL2` and the seven vectors of its shaders.
//!
//! Coefficients are of irradiance over π, with basis and cosine lobe multiplied in: what is stored belongs to the
//! polynomials 1, y, z, x, xy, yz, 3z² − 1, zx, x² − y², in the order used here. Axes are the caller's: [`Axes::UNITY`], or
//! [`Axes::UNITY_IMPORT`] where a scene came in as glTF.
//!
//! Source: how the built-in shaders evaluate `unity_SHAr` … `unity_SHC` (`SHEvalLinearL0L1`, `SHEvalLinearL2`), and
//! Unity's `SphericalHarmonicsL2` as its scripts pack it for them. The manual names neither order nor factors.
//!
//! ```
//! use sh_core::{Sh3, ShRgb, convention::{Axes, unity}};
//! let light = ShRgb::gray(Sh3::ONE * 0.5);
//! assert!((unity::shader(&light, Axes::UNITY)[0][3] - 0.5).abs() < 1e-6);
//! ```

use super::{Axes, from_polynomial, packed, polynomial, unpacked};
use crate::ShRgb;

/// Radiance to the coefficients of a `SphericalHarmonicsL2`: `probe[channel][coefficient]`, as its index operator
/// has them.
///
/// A relative error of 2 u (u = 2⁻²⁴) a coefficient.
///
/// ```
/// use sh_core::{Sh3, ShRgb, convention::{Axes, unity}};
/// let probe = unity::probe(&ShRgb::gray(Sh3::ONE), Axes::UNITY);
/// assert!((probe[0][0] - 1.0).abs() < 1e-6 && probe[0][1..] == [0.0; 8]);
/// ```
pub fn probe(light: &ShRgb<f32, 9>, axes: Axes) -> [[f32; 9]; 3] {
    polynomial(&axes.rgb(light))
}

/// Radiance from the coefficients of a `SphericalHarmonicsL2`. The way back from [`probe`].
///
/// ```
/// use sh_core::{Sh3, ShRgb, convention::{Axes, unity}};
/// let light = ShRgb::gray(Sh3::cosine([0.0, 1.0, 0.0]));
/// let back = unity::from_probe(&unity::probe(&light, Axes::UNITY), Axes::UNITY);
/// assert!((back.g - light.g).norm() < 1e-6);
/// ```
pub fn from_probe(probe: &[[f32; 9]; 3], axes: Axes) -> ShRgb<f32, 9> {
    axes.inverse().rgb(&from_polynomial(*probe))
}

/// Radiance to the shader's `unity_SHAr`, `unity_SHAg`, `unity_SHAb`, `unity_SHBr`, `unity_SHBg`, `unity_SHBb`,
/// `unity_SHC`, four numbers each: 112 bytes.
///
/// An error of 4 u of a channel's largest coefficient: the constant term takes part of the quadratic one in.
///
/// ```
/// use sh_core::{Sh3, ShRgb, convention::{Axes, unity}};
/// let [red, ..] = unity::shader(&ShRgb::gray(Sh3::cosine([1.0, 0.0, 0.0])), Axes::UNITY);
/// // Lit from +x: dot(unity_SHAr, (n, 1)) is larger there.
/// assert!(red[0] > 0.0 && red[1] == 0.0 && red[2] == 0.0);
/// ```
pub fn shader(light: &ShRgb<f32, 9>, axes: Axes) -> [[f32; 4]; 7] {
    packed(probe(light, axes))
}

/// Radiance from the shader's seven vectors. The way back from [`shader`].
///
/// ```
/// use sh_core::{Sh3, ShRgb, convention::{Axes, unity}};
/// let light = ShRgb::gray(Sh3::cosine([0.0, 1.0, 0.0]));
/// let back = unity::from_shader(&unity::shader(&light, Axes::UNITY), Axes::UNITY);
/// assert!((back.b - light.b).norm() < 1e-6);
/// ```
pub fn from_shader(rows: &[[f32; 4]; 7], axes: Axes) -> ShRgb<f32, 9> {
    from_probe(&unpacked(rows), axes)
}
