//! What is found for each body of a scene: once for all that are alike, or taken from the cache.

mod basis;
mod once;
mod spheres;
mod surfaces;
mod weights;

pub use basis::BasisReport;
pub(crate) use basis::tell;
pub(crate) use once::{Found, once};
pub(crate) use spheres::Fit;
pub use surfaces::SurfaceReport;
pub(crate) use surfaces::sample;
pub use weights::WeightReport;
pub(crate) use weights::weigh;
