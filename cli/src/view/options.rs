//! What is asked of `gaunt view`.

use super::hints::Hints;
use super::wish::Overlay;
use crate::render::{Backend, Overrides};
use sh_bake::Cache;
use std::path::PathBuf;

/// What is shown and how.
#[derive(Clone, Debug)]
pub struct Options {
    /// A scene file; none for the built-in scene.
    pub scene: Option<PathBuf>,
    /// The clip that a mesh file plays; none for its first.
    pub clip: Option<String>,
    /// What renders.
    pub backend: Backend,
    /// Width and height of the window, in points.
    pub size: [u32; 2],
    /// Settings instead of the scene's, at first.
    pub settings: Overrides,
    /// What is laid over the picture, at first.
    pub overlay: Overlay,
    /// A picture of the window, PNG, in place of a person before it.
    pub screenshot: Option<PathBuf>,
    /// How many frames of motion that shows, the last of them in the picture, 30 a second; from 1 on.
    pub frames: u32,
    /// Where sphere sets are kept.
    pub cache: Option<Cache>,
    /// What options mean.
    pub hints: Hints,
}
