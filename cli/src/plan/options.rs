//! What is asked of `gaunt plan`.

use crate::render::{Backend, Overrides};
use sh_bake::Cache;
use std::path::PathBuf;

/// Which scene, and what is to be told of it.
#[derive(Clone, Debug)]
pub struct Options {
    /// A scene file; none for the built-in scene.
    pub scene: Option<PathBuf>,
    /// What computes.
    pub backend: Backend,
    /// Width and height, in pixels.
    pub size: [u32; 2],
    /// Settings instead of the scene's.
    pub settings: Overrides,
    /// JSON instead of a table.
    pub json: bool,
    /// The cost of the scene as effects are switched on one by one, instead of its plan.
    pub effects: bool,
    /// Where sphere sets are kept.
    pub cache: Option<Cache>,
}

impl Default for Options {
    /// The built-in scene, 1280 by 720.
    fn default() -> Self {
        Self {
            scene: None,
            backend: Backend::Auto,
            size: [1280, 720],
            settings: Overrides::default(),
            json: false,
            effects: false,
            cache: None,
        }
    }
}
