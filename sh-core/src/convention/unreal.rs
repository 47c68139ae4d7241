//! Unreal, and Direct3D's SH library (`D3DXSH…`, `XMSH…`), which shares its signs.
//!
//! Vectors are radiance in the order used here with the sign (−1)^m. Axes are the caller's:
//! [`Axes::UNREAL`], or [`Axes::UNREAL_IMPORT`] where a scene came in as glTF. Direct3D has none of its own; programs
//! that use it often have [`Axes::UNITY`].
//!
//! Source: `TSHVector::SHBasisFunction` and `SetupSkyIrradianceEnvironmentMapConstantsFromSkyIrradiance` of Unreal;
//! the reference of `D3DXSHEvalDirection` for the order; Sloan 2008, appendices A2 and A10.
//!
//! ```
//! use sh_core::{Sh2, ShRgb, convention::{Axes, unreal}};
//! // Light from the right, +X here, is light from +Y there: the coefficient of m = −1, negative.
//! let there = unreal::vector(&ShRgb::gray(Sh2::cosine([1.0, 0.0, 0.0])), Axes::UNREAL);
//! assert!(there.r[1] < -0.3 && there.r[3].abs() < 1e-6);
//! ```

use super::{Axes, condon_shortley, from_polynomial, packed, polynomial, unpacked};
use crate::{Lane, Routines, ShRgb};

/// Radiance to an `FSHVectorRGB2` or `FSHVectorRGB3`, or any other order.
///
/// A rotation's error: 1e-6 ‖f‖ in f32.
///
/// ```
/// use sh_core::{Sh3, ShRgb, convention::{Axes, unreal}};
/// let there = unreal::vector(&ShRgb::gray(Sh3::cosine([0.0, 1.0, 0.0])), Axes::UNREAL);
/// assert!((there.r[2] - Sh3::cosine([0.0, 0.0, 1.0])[2]).abs() < 1e-6);
/// ```
pub fn vector<L: Lane, const C: usize>(light: &ShRgb<L, C>, axes: Axes) -> ShRgb<L, C>
where
    [L; C]: Routines<L>,
{
    axes.rgb(light).map(|f| condon_shortley(&f))
}

/// Radiance from an `FSHVectorRGB`. The way back from [`vector`].
///
/// ```
/// use sh_core::{Sh3, ShRgb, convention::{Axes, unreal}};
/// let light = ShRgb::gray(Sh3::cosine([0.36, 0.48, 0.8]));
/// assert!((unreal::from_vector(&unreal::vector(&light, Axes::UNREAL), Axes::UNREAL).r - light.r).norm() < 1e-6);
/// ```
pub fn from_vector<L: Lane, const C: usize>(there: &ShRgb<L, C>, axes: Axes) -> ShRgb<L, C>
where
    [L; C]: Routines<L>,
{
    axes.inverse().rgb(&there.map(|f| condon_shortley(&f)))
}

/// Radiance to the shader's `SkyIrradianceEnvironmentMap`: seven vectors whose polynomial is irradiance over π.
///
/// Newer versions of Unreal hold an eighth, with the average brightness, which is not made here.
///
/// ```
/// use sh_core::{Sh3, ShRgb, convention::{Axes, unreal}};
/// let [red, ..] = unreal::sky(&ShRgb::gray(Sh3::cosine([0.0, 1.0, 0.0])), Axes::UNREAL);
/// // Lit from above: z there.
/// assert!(red[2] > 0.1 && red[0].abs() < 1e-6);
/// ```
pub fn sky(light: &ShRgb<f32, 9>, axes: Axes) -> [[f32; 4]; 7] {
    packed(polynomial(&axes.rgb(light)))
}

/// Radiance from the first seven vectors of `SkyIrradianceEnvironmentMap`. The way back from [`sky`].
///
/// ```
/// use sh_core::{Sh3, ShRgb, convention::{Axes, unreal}};
/// let light = ShRgb::gray(Sh3::cosine([0.36, 0.48, 0.8]));
/// assert!((unreal::from_sky(&unreal::sky(&light, Axes::UNREAL), Axes::UNREAL).r - light.r).norm() < 2e-6);
/// ```
pub fn from_sky(rows: &[[f32; 4]; 7], axes: Axes) -> ShRgb<f32, 9> {
    axes.inverse().rgb(&from_polynomial(unpacked(rows)))
}
