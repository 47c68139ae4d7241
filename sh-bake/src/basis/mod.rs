//! Irradiance on a body's surface as a sum of few functions (Iwasaki et al. 2007, "Precomputed radiance transfer for dynamic
//! scenes taking into account light interreflection", sections 3.1 and 4.2).
//!
//! The body is lit by many lights, in its own shadow; the functions are those that say most of what falls on it of all of
//! them. Three things are not as in the paper. It is *irradiance* that is written in them, not what is reflected, so that
//! colours and textures stay out of the functions and may change. The first function is the constant, in place of the mean
//! of all lights: even light is then told exactly. And functions are at right angles to each other where each point counts
//! by its area, so that a weight is one mean over the surface, and there is no matrix to invert (equation 14).

mod escape;
mod field;
mod functions;
mod harmonics;
mod samples;
mod singular;
#[cfg(test)]
mod tests;
mod training;

pub use field::{IrradianceField, LitField};
pub use functions::irradiance_basis;

/// Changes whenever the same body may get other functions or patches.
pub(crate) const BASIS_VERSION: u32 = 2;
