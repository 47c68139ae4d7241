//! Irradiance on a body's surface in few functions, and the patches that send it on (Iwasaki et al. 2007, "Precomputed
//! radiance transfer for dynamic scenes taking into account light interreflection").
//!
//! What falls on a rigid body is told as E(x) ≈ Σ wᵢ Ψᵢ(x) with few functions Ψᵢ, which were found for that body
//! (`sh_bake`). So all that has to be known of a body's light, bounce by bounce, is a handful of weights.
//!
//! What is seen of the body is told by parts of its surface. The paper keeps what is seen of each function as SH vectors at
//! 24,576 places around the body, and looks between them. Here a *patch* is a flat disc in its place, so that it is right
//! from wherever it is looked at, from inside of the ball around the body as well; from farther away four that are flat together
//! are one disc, and from afar 16 are a *region*, which has an intensity by direction, an SH vector about its middle. What hides a patch, or a sample of a region, behind
//! the rest of its own body is part of both. They take a fortieth of the room or less, and are in the body's own space: where a
//! body moves, nothing of it changes.
//!
//! ```text
//! body ── 16 to 64 regions ── 16 patches each ── 4 samples each, of which the first is a point where light is looked up
//! ```

mod escape;
mod irradiance;
mod parts;
mod records;
mod shape;
mod weights;

pub use escape::Escape;
pub use irradiance::IrradianceBasis;
pub use parts::{BasisParts, BasisSample};
pub use records::{Disc, Facet, Patch, Region};
#[doc(inline)]
pub use sh_core::constants::{MOST_COEFFICIENTS, PATCH_SAMPLES, QUARTERS, REGION_PATCHES};
pub use shape::Shape;
