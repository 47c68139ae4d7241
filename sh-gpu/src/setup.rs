//! What the passes of a plan are made from: the device, the buffers of a frame, and what several of them share.

use crate::bases::Bases;
use crate::buffers::Buffers;
use crate::inputs::Inputs;
use crate::surfaces::Surfaces;
use crate::views::Views;
use crate::{
    Bands, Bound, Error, HalfBinding, LightGatherPass, Pipelines, RestBinding, ShadowOptions,
    ShadowPass, UpsampleBound, UpsamplePass,
};
use sh_scene::resource::{EMISSION, RECEIVERS, SENT, SHARE, UPSAMPLED};
use sh_scene::{Domain, Plan, Resource, Scene};
use std::sync::Arc;
use wgpu::{BufferBinding, Device, Queue};

/// What stages are made from.
pub(crate) struct Setup<'a> {
    pub device: &'a Device,
    pub pipelines: &'a Pipelines,
    pub queue: &'a Queue,
    pub scene: &'a Scene,
    pub buffers: &'a Buffers,
    pub bands: &'a Bands,
    pub halves: Option<&'a Bands>,
    pub inputs: Option<&'a Arc<Inputs>>,
    pub shadow: Option<&'a Arc<ShadowPass>>,
    pub gather: Option<&'a Arc<LightGatherPass>>,
    pub upsample: Option<&'a Arc<UpsamplePass>>,
    pub surfaces: Option<&'a Arc<Surfaces>>,
    pub bases: Option<&'a Arc<Bases>>,
    pub views: Option<&'a Arc<Views>>,
}

/// What the passes of a scene's plan need of light and blockers.
pub(crate) fn options(scene: &Scene) -> ShadowOptions {
    let blockers: usize = scene.objects.iter().map(|o| o.spheres.len()).sum();
    ShadowOptions {
        order: scene.settings.order,
        accumulation: scene.settings.accumulation,
        max_blockers: u32::try_from(blockers).unwrap_or(u32::MAX),
        max_emitters: emitters(scene),
        distributions: distributions(scene),
        ..ShadowOptions::default()
    }
}

/// Whether spheres send light on.
pub(crate) fn sends(plan: &Plan) -> bool {
    plan.touches(EMISSION)
}

pub(crate) fn emitters(scene: &Scene) -> u32 {
    let shining = scene.lights.iter().filter(|lamp| lamp.shines());
    u32::try_from(shining.count()).unwrap_or(u32::MAX)
}

pub(crate) fn distributions(scene: &Scene) -> bool {
    let mut shining = scene.lights.iter().filter(|lamp| lamp.shines());
    shining.any(|lamp| lamp.distribution.is_some())
}

impl Setup<'_> {
    /// A band's part of a resource of a domain.
    pub fn part(&self, what: Resource, at: Domain, band: u32) -> Result<BufferBinding<'_>, Error> {
        self.buffers.band(what, at, self.bands_of(at)?, band)
    }

    /// Binds receivers and something written for each of them, of every band of a domain.
    pub fn each(
        &self,
        at: Domain,
        written: Resource,
        bind: impl Fn(&Device, [BufferBinding<'_>; 2]) -> Result<Bound, Error>,
    ) -> Result<Vec<Bound>, Error> {
        let bound = (0..self.bands_of(at)?.count()).map(|band| {
            let receivers = self.part(RECEIVERS, at.receivers(), band)?;
            bind(self.device, [receivers, self.part(written, at, band)?])
        });
        bound.collect()
    }

    pub fn upsampled(&self) -> Result<(Arc<UpsamplePass>, Vec<UpsampleBound>), Error> {
        let (bands, pass) = (self.bands, self.upsample()?);
        let both = [bands, self.bands_of(Domain::Halves)?];
        let bound = (0..bands.count()).map(|band| {
            let under = |what| self.buffers.under(what, both, band);
            let sent = self.buffers.get(SENT, Domain::Halves);
            let halves = HalfBinding {
                receivers: under(RECEIVERS)?,
                shares: under(SHARE)?,
                sent: sent.map(|_| under(SENT)).transpose()?,
            };
            let receivers = self.part(RECEIVERS, Domain::Samples, band)?;
            let radiance = self.part(UPSAMPLED, Domain::Samples, band)?;
            pass.bind(self.device, halves, receivers, radiance)
        });
        let bound = bound.collect::<Result<_, Error>>()?;
        Ok((pass, bound))
    }

    /// Binds the list that upsampling leaves, band by band.
    pub fn rest(
        &self,
        bind: impl Fn(&Device, RestBinding<'_>) -> Result<Bound, Error>,
    ) -> Result<Vec<Bound>, Error> {
        let upsample = self.upsample()?;
        let bands = (0..self.bands.count()).map(|band| upsample.rest(self.bands, band));
        bands.map(|rest| bind(self.device, rest)).collect()
    }

    pub fn bands_of(&self, at: Domain) -> Result<&Bands, Error> {
        match at {
            Domain::Halves => self.halves.ok_or(NO_HALVES),
            _ => Ok(self.bands),
        }
    }

    pub fn shadow(&self) -> Result<Arc<ShadowPass>, Error> {
        shared(self.shadow, "shadow")
    }

    pub fn surfaces(&self) -> Result<Arc<Surfaces>, Error> {
        shared(self.surfaces, "points")
    }

    pub fn bases(&self) -> Result<Arc<Bases>, Error> {
        shared(self.bases, "basis_update")
    }

    /// Points of surfaces or patches, in clusters, and something of each.
    pub fn points(
        &self,
        at: Domain,
        written: Resource,
        bind: impl Fn(&Device, RestBinding<'_>) -> Result<Bound, Error>,
    ) -> Result<Vec<Bound>, Error> {
        let (surfaces, bases);
        let clusters = match at {
            Domain::Patches => {
                bases = self.bases()?;
                // What bodies send varies less than what lights do.
                bases.clusters(written == SENT)
            }
            _ => {
                surfaces = self.surfaces()?;
                surfaces.clusters()
            }
        };
        let points = RestBinding {
            receivers: self.part(RECEIVERS, at, 0)?,
            clusters,
            radiance: self.part(written, at, 0)?,
        };
        Ok(vec![bind(self.device, points)?])
    }

    pub fn gather(&self) -> Result<Arc<LightGatherPass>, Error> {
        shared(self.gather, "light_gather")
    }

    pub fn upsample(&self) -> Result<Arc<UpsamplePass>, Error> {
        shared(self.upsample, "upsample")
    }
}

pub(crate) fn shared<T>(pass: Option<&Arc<T>>, name: &'static str) -> Result<Arc<T>, Error> {
    pass.cloned().ok_or(Error::NoPass { pass: name })
}

/// Plans that were checked have what they upsample from.
const NO_HALVES: Error = Error::NoPass {
    pass: "gbuffer at half resolution",
};
