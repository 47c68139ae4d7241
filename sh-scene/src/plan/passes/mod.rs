//! The passes there are, a file each.
//!
//! The table's order says which of two passes comes first where their slots leave that open.

mod gbuffer;
mod invalid;
mod irradiance;
mod light_gather;
mod light_update;
mod points;
mod resolve;
mod scatter;
mod shadow;
mod shares;
mod upsample;

pub use gbuffer::GBUFFER;
pub use invalid::{INVALID, INVALID_SAMPLES, InvalidSamples};
pub use irradiance::IRRADIANCE;
pub use light_gather::LIGHT_GATHER;
pub use light_update::LIGHT_UPDATE;
pub use points::POINTS;
pub use resolve::RESOLVE;
pub use scatter::SCATTER;
pub use shadow::SHADOW;
pub use shares::SHARES;
pub use upsample::UPSAMPLE;

use super::Pass;

/// All of them.
pub static PASSES: [&Pass; 11] = [
    &POINTS,
    &LIGHT_UPDATE,
    &GBUFFER,
    &IRRADIANCE,
    &SHADOW,
    &LIGHT_GATHER,
    &SHARES,
    &UPSAMPLE,
    &SCATTER,
    &INVALID,
    &RESOLVE,
];
