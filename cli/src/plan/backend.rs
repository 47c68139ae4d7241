//! Frames of a plan on the backend that was chosen.

use super::measured::Measured;
use super::{cpu, gpu};
use crate::Error;
use crate::render::Choice;
use sh_bake::Loaded;
use sh_scene::{Plan, Scene, View};

/// Runs frames of a scene: the first, which makes what all others keep, and then those that are timed.
pub(super) fn measure(
    loaded: &mut Loaded,
    plan: &Plan,
    view: &View,
    choice: &Choice,
) -> Result<Measured, Error> {
    match &choice.gpu {
        Some(gpu) => gpu::measure(gpu, loaded, plan, view),
        None => cpu::measure(loaded, plan, view),
    }
}

pub(super) fn view(scene: &Scene, [width, height]: [u32; 2]) -> View {
    View {
        camera: scene.camera,
        width,
        height,
    }
}
