//! (under construction)
mod error;
mod gbuffer;
mod geometry;
pub mod lanes;
mod resolve;
mod texture;
mod width;
pub use error::{Error, MAX_SIDE};
pub use gbuffer::{Gbuffer, gbuffer};
pub use geometry::{Geometry, Hit};
pub use resolve::resolve;
pub use width::{Path, Width, levels};
