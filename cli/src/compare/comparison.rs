//! What a comparison found.

use super::measure::Figures;
use serde::Serialize;
use std::path::PathBuf;

/// What a comparison found. All figures are in parts of the mean radiance of all light in the truth whose reflectors
/// are the bodies.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Comparison {
    /// The scene's file, or what the built-in one is called.
    pub scene: String,
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// Receivers: pixels that are not sky.
    pub receivers: usize,
    /// SH order of the light.
    pub order: usize,
    /// SH order in which the blockers' logarithms are accumulated.
    pub accumulation_order: usize,
    /// Spheres of all bodies.
    pub spheres: usize,
    /// Paths a receiver.
    pub paths: u32,
    /// Bounces of the truth.
    pub bounces: u32,
    /// The truth's light: `map` or `projected`.
    pub light: &'static str,
    /// Mean radiance of the truth, which figures are in parts of.
    pub mean_radiance: f64,
    /// The share of indirect light in it.
    pub indirect_share: f64,
    /// Light that no body has reflected, where bodies are the only reflectors.
    pub direct: Figures,
    /// Light that at least one body has reflected.
    pub indirect: Figures,
    /// Both together.
    pub total: Figures,
    /// As `direct` where the ground reflects what really arrives there; none without a ground.
    pub direct_ground: Option<Figures>,
    /// As `indirect` where the ground reflects too.
    pub indirect_ground: Option<Figures>,
    /// As `total` where the ground reflects too.
    pub total_ground: Option<Figures>,
    /// The picture with light at half resolution against the one whose samples are all shaded, in parts of the latter's
    /// mean where bodies and ground are; none where the scene has no light at half resolution. All others are without it.
    pub half_resolution: Option<Figures>,
    /// Seconds of the passes.
    pub seconds_ours: f64,
    /// Seconds of the path tracer.
    pub seconds_truth: f64,
    /// The sheet, if one was written.
    pub sheet: Option<PathBuf>,
}
