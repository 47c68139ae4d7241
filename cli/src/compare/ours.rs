//! What the passes make of the receivers of a comparison.

use super::measure::Parts;
use super::view::Seen;
use crate::Error;
use sh_cpu::Frames;
use sh_scene::passes::LIGHT_UPDATE;
use sh_scene::{Plan, Scene};

/// Direct and indirect light, and what the spheres send on.
pub struct Ours {
    /// Radiance of each receiver.
    pub parts: Parts,
    /// The SH vectors of each sphere's emission in three channels, in the order of the scene's spheres; empty where
    /// none sends on.
    pub emission: Vec<Vec<[f32; 3]>>,
}

/// Lights every receiver by the scene's passes, on the CPU: what is left out is upsampling from half resolution.
///
/// # Errors
/// Where the scene is none that can be lit.
pub fn ours(scene: &Scene, seen: &Seen) -> Result<Ours, Error> {
    let mut frames = Frames::default();
    let clusters = seen.tiles().clusters();
    let plan = Plan::of_receivers(scene);
    let lit = frames.light(scene, &plan, seen.receivers(), &clusters)?;
    let mut indirect = lit.sent;
    let mut emission = Vec::new();
    if plan.has(&LIGHT_UPDATE) {
        let (forest, lights) = frames.spheres();
        emission = vec![Vec::new(); forest.spheres()];
        for (index, node) in (0..).zip(forest.nodes()) {
            if let Some(sphere) = emission.get_mut(node.sphere as usize) {
                *sphere = lights.emission(index).to_vec();
            }
        }
    }
    indirect.resize(seen.receivers().len(), [0.0; 3]);
    Ok(Ours {
        parts: Parts {
            direct: lit.radiance,
            indirect,
        },
        emission,
    })
}
