//! What the passes make of the receivers of a comparison.

use super::measure::Parts;
use super::view::Seen;
use crate::Error;
use sh_cpu::{
    Body, CutOptions, Cuts, LightCutOptions, LightCuts, LightGather, LightUpdate, Path, Shadow,
    SphericalLights, irradiance, light_gather, shadow_clusters,
};
use sh_scene::{Forest, Light, PassKind, Plan, Scene};

/// Direct and indirect light, and what the spheres send on.
pub struct Ours {
    /// Radiance of each receiver.
    pub parts: Parts,
    /// The SH vectors of each sphere's emission in three channels, in the order of the scene's spheres; empty where
    /// nothing is sent on.
    pub emission: Vec<Vec<[f32; 3]>>,
}

/// Runs the passes of the scene's plan on the CPU, at every receiver: what is left out is upsampling from half
/// resolution.
pub fn ours(scene: &Scene, light: &Light, seen: &Seen) -> Result<Ours, Error> {
    let plan = Plan::new(scene);
    let forest = scene.forest();
    let receivers = seen.receivers();
    let mut direct = vec![[0.0; 3]; receivers.len()];
    if plan.has(PassKind::Shadow) {
        let clusters = seen.tiles().clusters();
        let mut cuts = Cuts::default();
        cuts.bound(receivers, &clusters, 0..clusters.len());
        cuts.find(
            Path::best(),
            &forest,
            light,
            options(scene, scene.settings.accumulation),
        );
        let shadow = Shadow {
            clusters: &clusters,
            cuts: &cuts,
            light,
            accumulation: scene.settings.accumulation,
            baked: None,
        };
        shadow_clusters(Path::best(), receivers, &shadow, &mut direct)?;
    } else {
        irradiance(receivers, light, &mut direct)?;
    }
    let mut indirect = vec![[0.0; 3]; receivers.len()];
    let mut emission = Vec::new();
    if plan.has(PassKind::LightUpdate) {
        let lights = lights(scene, light, &forest)?;
        gather(scene, &forest, &lights, seen, &mut indirect)?;
        emission = by_sphere(&forest, &lights);
    }
    Ok(Ours {
        parts: Parts { direct, indirect },
        emission,
    })
}

fn options(scene: &Scene, accumulation: usize) -> CutOptions {
    CutOptions {
        limits: scene.settings.limits,
        ratios: true,
        accumulation,
    }
}

/// Lights the bodies' spheres.
fn lights(scene: &Scene, light: &Light, forest: &Forest) -> Result<SphericalLights, Error> {
    let update = LightUpdate {
        indirect: scene.settings.indirect.unwrap_or_default(),
        limits: scene.settings.limits,
        accumulation: scene.settings.accumulation,
    };
    let bodies = scene.objects.iter().map(Body::from);
    let mut lights = SphericalLights::default();
    lights.update(Path::best(), bodies, forest, light, update)?;
    Ok(lights)
}

fn gather(
    scene: &Scene,
    forest: &Forest,
    lights: &SphericalLights,
    seen: &Seen,
    radiance: &mut [[f32; 3]],
) -> Result<(), Error> {
    let (receivers, clusters) = (seen.receivers(), seen.tiles().clusters());
    let mut cuts = LightCuts::default();
    let options = LightCutOptions {
        cut: options(scene, scene.settings.order),
        blocking: scene.settings.indirect.unwrap_or_default().blocking,
    };
    cuts.find(Path::best(), receivers, &clusters, forest, lights, options);
    let gather = LightGather {
        clusters: &clusters,
        cuts: &cuts,
        lights,
    };
    light_gather(Path::best(), receivers, &gather, radiance)?;
    Ok(())
}

fn by_sphere(forest: &Forest, lights: &SphericalLights) -> Vec<Vec<[f32; 3]>> {
    let mut emission = vec![Vec::new(); forest.spheres()];
    for (index, node) in (0..).zip(forest.nodes()) {
        if let Some(sphere) = emission.get_mut(node.sphere as usize) {
            *sphere = lights.emission(index).to_vec();
        }
    }
    emission
}
