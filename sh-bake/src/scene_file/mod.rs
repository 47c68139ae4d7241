//! Scene files: TOML, as the crate's documentation shows.

mod content;
mod read;
mod sections;

pub(crate) use content::{CameraName, SceneFile};
