//! The passes there are, a file each.
//!
//! The table's order says which of two passes comes first where their slots leave that open.

mod basis_gather;
mod basis_update;
mod gbuffer;
mod invalid;
mod irradiance;
mod light_gather;
mod light_update;
mod light_view;
mod points;
mod punctual;
mod resolve;
mod scatter;
mod shadow;
mod shares;
mod upsample;

pub use basis_gather::BASIS_GATHER;
pub use basis_update::BASIS_UPDATE;
pub use gbuffer::GBUFFER;
pub use invalid::{INVALID, INVALID_SAMPLES, InvalidSamples};
pub use irradiance::IRRADIANCE;
pub use light_gather::LIGHT_GATHER;
pub use light_update::LIGHT_UPDATE;
pub use light_view::LIGHT_VIEW;
pub use points::POINTS;
pub use punctual::PUNCTUAL;
pub use resolve::RESOLVE;
pub use scatter::SCATTER;
pub use shadow::SHADOW;
pub use shares::SHARES;
pub use upsample::UPSAMPLE;

use super::Pass;

/// All of them.
pub static PASSES: [&Pass; 15] = [
    &LIGHT_VIEW,
    &POINTS,
    &LIGHT_UPDATE,
    &BASIS_UPDATE,
    &GBUFFER,
    &IRRADIANCE,
    &SHADOW,
    &LIGHT_GATHER,
    &BASIS_GATHER,
    &PUNCTUAL,
    &SHARES,
    &UPSAMPLE,
    &SCATTER,
    &INVALID,
    &RESOLVE,
];
