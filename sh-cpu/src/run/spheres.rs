//! Passes that look at the tree of spheres.

use super::work::Stages;
use crate::device::cut::CutOptions;
use crate::device::light_order::LightCutOptions;
use crate::device::patch_lights::Placed;
use crate::device::spherical_lights::Points;
use crate::error::Error;
use crate::passes::basis_gather::{BasisGather, basis_gather};
use crate::passes::light_gather::{LightGather, light_gather};
use crate::passes::light_update::light_update;
use crate::passes::shadow::{Shadow, shadow_clusters};
use crate::store::{Set, Spheres};
use sh_scene::{BasisBody, Body, Domain, Settings};

impl Spheres<'_> {
    /// Light through the visibility of all blockers.
    pub(super) fn shade(&mut self, set: &mut Set, stages: &mut Stages) -> Result<(), Error> {
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
        let (receivers, clusters) = (set.receivers, set.clusters);
        let Self { forest, cuts, .. } = self;
        stages.time("cut", || {
            cuts.bound(receivers, clusters, 0..clusters.len());
            cuts.dim(self.light);
            cuts.find(self.path, forest, self.light, options);
        });
        self.counts.pairs += cuts.pairs();
        self.counts.shadowed += cuts.receivers();
        self.counts.too_small += cuts.too_small();
        self.counts.lamps_below += cuts.lamps_below();
        let shadow = Shadow {
            clusters,
            cuts,
            light: self.light,
            accumulation,
            baked: None,
            eye: set.eye,
        };
        stages.time("shadow", || {
            shadow_clusters(self.path, receivers, &shadow, set.room())
        })
    }

    /// What spheres send to receivers.
    pub(super) fn gather(
        &mut self,
        set: &Set,
        stages: &mut Stages,
    ) -> Result<Vec<[f32; 3]>, Error> {
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
        let (receivers, clusters) = (set.receivers, set.clusters);
        let (path, cuts, lights) = (self.path, &mut *self.light_cuts, &*self.lights);
        stages.time("light_cut", || {
            cuts.find(path, receivers, clusters, self.forest, lights, options);
        });
        let mut sent = vec![[0.0; 3]; receivers.len()];
        let gather = LightGather {
            clusters,
            cuts,
            lights,
            eye: set.eye,
        };
        stages.time("light_gather", || {
            light_gather(path, receivers, &gather, &mut sent)
        })?;
        Ok(sent)
    }

    /// What patches send to the receivers of a domain. To points of patches what their own body gives itself is not among it: that
    /// is in its weights already.
    pub(super) fn gather_patches<'a>(
        &mut self,
        (set, at): (&Set, Domain),
        bodies: impl Iterator<Item = BasisBody<'a>>,
        stages: &mut Stages,
    ) -> Result<Vec<[f32; 3]>, Error> {
        let (receivers, clusters) = (set.receivers, set.clusters);
        let (path, lights, limits) = (self.path, &*self.patch_lights, self.settings.limits);
        let bodies: Vec<Placed> = bodies.map(Placed::of).collect();
        let (cuts, own) = match at {
            Domain::Patches => (&mut *self.point_cuts, false),
            _ => (&mut *self.patch_cuts, true),
        };
        if own || !cuts.found() {
            stages.time("patch_cut", || {
                cuts.find((receivers, clusters), self.forest, &bodies, limits);
            });
        }
        let mut sent = vec![[0.0; 3]; receivers.len()];
        let gather = BasisGather {
            clusters,
            cuts,
            bodies: &bodies,
            lights,
            own,
            eye: set.eye,
        };
        stages.time("basis_gather", || {
            basis_gather(path, receivers, &gather, &mut sent)
        })?;
        Ok(sent)
    }

    /// What spheres send on of the light on these points.
    pub(super) fn update<'a>(
        &mut self,
        points: &Points,
        bodies: impl IntoIterator<Item = Body<'a>> + Clone,
    ) -> Result<(), Error> {
        let indirect = self.settings.indirect.unwrap_or_default();
        let how = (self.light.order, indirect.blocking.within_bodies());
        light_update(points, bodies, self.forest, how, &mut self.lights.emission)
    }
}
