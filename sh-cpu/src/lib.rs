//! (under construction)
pub mod lanes;
mod width;
pub use width::{Path, Width, levels};
