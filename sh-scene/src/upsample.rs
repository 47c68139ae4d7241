//! What decides where light at half resolution will do for a sample of the picture: the constants of the joint
//! bilateral filter (Kopf et al. 2007), which both backends share.
//!
//! A sample at p with normal N looks at the four receivers k around it at half resolution. Each weighs
//!
//! ```text
//! bilinear · max(0, 1 − (h/c)²) · clamp((N·N_k − NORMAL_FROM) / (1 − NORMAL_FROM), 0, 1)
//! h = max(|(p_k − p)·N|, |(p_k − p)·N_k|)      how far one is from the other's plane
//! c = what two pixels cover at the sample's distance
//! ```
//! What is interpolated is the share of its light that a receiver gets through all blockers, channel by channel; the
//! sample's own light without blockers is multiplied with it, so that normals keep their detail.

use crate::View;

/// Below this sum of weights a sample is shaded by itself.
pub const MIN_WEIGHT: f32 = 0.3;

/// Where shares of the receivers around a sample differ by more than this, it is shaded by itself.
pub const MAX_SPREAD: f32 = 0.1;

/// The cosine between normals below which a receiver does not weigh: 37°.
pub const NORMAL_FROM: f32 = 0.8;

/// Receivers of less weight than this have no say in [`MAX_SPREAD`].
pub const CORNER: f32 = 0.02;

/// What two pixels cover at distance 1 from the eye: c of the weight, over the distance.
pub fn footprint(view: &View) -> f32 {
    4.0 * (view.camera.fov * 0.5).tan() / view.height as f32
}
