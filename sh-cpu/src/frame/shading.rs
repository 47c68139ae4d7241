//! The passes of a picture that look at spheres.

use super::work::Stages;
use crate::light_gather::{LightGather, light_gather};
use crate::shadow::{Shadow, shadow_clusters};
use crate::{CutOptions, Cuts, Error, LightCutOptions, LightCuts, Path, SphericalLights};
use sh_scene::{Forest, Light, Receiver, Settings};
use std::ops::Range;

/// These passes, with what these are and what is counted.
pub(super) struct Shadows<'a> {
    pub forest: &'a Forest,
    pub cuts: &'a mut Cuts,
    /// What spheres send on, where they do.
    pub lights: Option<&'a SphericalLights>,
    pub light_cuts: &'a mut LightCuts,
    pub light: &'a Light,
    pub settings: Settings,
    pub pairs: usize,
    pub shadowed: usize,
    pub too_small: usize,
    pub lamps_below: usize,
}

impl Shadows<'_> {
    pub fn shade(
        &mut self,
        receivers: &[Receiver],
        clusters: &[Range<usize>],
        radiance: &mut [[f32; 3]],
        stages: &mut Stages,
    ) -> Result<(), Error> {
        let Settings {
            limits,
            accumulation,
            ..
        } = self.settings;
        let options = CutOptions {
            limits,
            ratios: true,
            accumulation,
        };
        let Self { forest, cuts, .. } = self;
        stages.time("cut", || {
            cuts.bound(receivers, clusters, 0..clusters.len());
            cuts.dim(self.light);
            cuts.find(Path::best(), forest, self.light, options);
        });
        self.pairs += cuts.pairs();
        self.shadowed += cuts.receivers();
        self.too_small += cuts.too_small();
        self.lamps_below += cuts.lamps_below();
        let shadow = Shadow {
            clusters,
            cuts,
            light: self.light,
            accumulation,
            baked: None,
        };
        stages.time("shadow", || {
            shadow_clusters(Path::best(), receivers, &shadow, radiance)
        })
    }

    /// What spheres send to receivers; nothing where they send nothing on.
    pub fn gather(
        &mut self,
        receivers: &[Receiver],
        clusters: &[Range<usize>],
        stages: &mut Stages,
    ) -> Result<Vec<[f32; 3]>, Error> {
        let Some(lights) = self.lights else {
            return Ok(Vec::new());
        };
        let Settings {
            limits,
            indirect,
            order,
            ..
        } = self.settings;
        let options = LightCutOptions {
            cut: CutOptions {
                limits,
                ratios: true,
                accumulation: order,
            },
            blocking: indirect.unwrap_or_default().blocking,
        };
        let (path, cuts) = (Path::best(), &mut *self.light_cuts);
        stages.time("light_cut", || {
            cuts.find(path, receivers, clusters, self.forest, lights, options);
        });
        let mut sent = vec![[0.0; 3]; receivers.len()];
        let gather = LightGather {
            clusters,
            cuts,
            lights,
        };
        stages.time("light_gather", || {
            light_gather(path, receivers, &gather, &mut sent)
        })?;
        Ok(sent)
    }
}

/// Adds what was sent, if anything was.
pub(super) fn add(radiance: &mut [[f32; 3]], sent: &[[f32; 3]]) {
    for (radiance, sent) in radiance.iter_mut().zip(sent) {
        for (radiance, sent) in radiance.iter_mut().zip(sent) {
            *radiance += sent;
        }
    }
}
