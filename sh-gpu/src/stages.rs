//! The passes of a plan on the GPU: how each is made, bound to the buffers of a frame, and recorded.

use crate::bases::{Bases, Gathering};
use crate::buffers::Buffers;
use crate::inputs::Inputs;
use crate::plain::Plain;
use crate::punctual::PunctualPass;
use crate::surfaces::Surfaces;
use crate::views::Views;
use crate::{
    Bands, Bodies, Bound, Drawn, Error, GbufferPass, HalfBinding, IrradiancePass, LightGatherPass,
    Pipelines, ResolvePass, RestBinding, ShadowOptions, ShadowPass, UpsampleBound, UpsamplePass,
};
use sh_scene::passes::{
    BASIS_GATHER, BASIS_UPDATE, GBUFFER, IRRADIANCE, LIGHT_GATHER, LIGHT_UPDATE, LIGHT_VIEW,
    POINTS, PUNCTUAL, RESOLVE, SCATTER, SHADOW, SHARES, UPSAMPLE,
};
use sh_scene::resource::{ALBEDO, EMISSION, PICTURE, RADIANCE, RECEIVERS, SENT, SHARE, UPSAMPLED};
use sh_scene::{Domain, Pass, Plan, Planned, Resource, Scene};
use std::sync::Arc;
use wgpu::{Buffer, BufferBinding, CommandEncoder, ComputePassTimestampWrites, Device, Queue};

/// One pass of the plan, with what it binds for every band.
#[derive(Debug)]
pub(crate) struct Stage {
    pub pass: &'static Pass,
    pub at: Domain,
    /// How often a frame records it.
    pub turns: usize,
    pub work: Work,
}

/// A pass and what it is bound to, band by band. Those that several passes of a plan share are one.
#[derive(Debug)]
pub(crate) enum Work {
    Points {
        surfaces: Arc<Surfaces>,
        bound: Bound,
        /// What is cleared: light that bodies have sent.
        sent: Buffer,
    },
    LightUpdate {
        surfaces: Arc<Surfaces>,
        bound: Bound,
    },
    /// Points of patches.
    PatchPoints {
        bases: Arc<Bases>,
        bound: Bound,
        /// What is cleared: light that bodies have sent.
        sent: Buffer,
    },
    BasisUpdate {
        bases: Arc<Bases>,
        bound: Bound,
    },
    Gbuffer {
        pass: GbufferPass,
        bound: Vec<Bound>,
    },
    Irradiance {
        pass: IrradiancePass,
        bound: Vec<Bound>,
    },
    Shadow {
        pass: Arc<ShadowPass>,
        bound: Vec<Bound>,
    },
    LightGather {
        pass: Arc<LightGatherPass>,
        bound: Vec<Bound>,
        /// What has to be cleared before the first band, or in every turn.
        cleared: Option<Buffer>,
    },
    BasisGather {
        bases: Arc<Bases>,
        bound: Vec<Bound>,
        /// What has to be cleared before the first band, or in every turn.
        cleared: Option<Buffer>,
    },
    LightView {
        views: Arc<Views>,
    },
    Punctual {
        pass: PunctualPass,
        bound: Vec<Bound>,
    },
    Shares {
        pass: Arc<UpsamplePass>,
        bound: Vec<Bound>,
    },
    Upsample {
        pass: Arc<UpsamplePass>,
        bound: Vec<UpsampleBound>,
    },
    Scatter {
        pass: Arc<UpsamplePass>,
        bound: Vec<UpsampleBound>,
    },
    Resolve {
        pass: ResolvePass,
        bound: Vec<Bound>,
    },
    Plain(Plain),
}

/// What a stage is recorded with.
#[derive(Clone, Copy)]
pub(crate) struct Recording<'a> {
    /// The bands of the stage's domain.
    pub bands: &'a Bands,
    /// Which of them; 0 where the stage has none.
    pub band: u32,
    pub bodies: &'a Bodies,
    /// Whether what it makes is on the device as it would be made.
    pub kept: bool,
    /// The queries of begin and end.
    pub stamps: Option<(&'a wgpu::QuerySet, [u32; 2])>,
}

impl Stage {
    /// Records a band of it, or all of it where it has none.
    pub fn record(&self, encoder: &mut CommandEncoder, recording: Recording) {
        let Recording {
            bands,
            band,
            bodies,
            kept,
            stamps,
        } = recording;
        let writes = stamps.map(|(query_set, [begin, end])| ComputePassTimestampWrites {
            query_set,
            beginning_of_pass_write_index: Some(begin),
            end_of_pass_write_index: Some(end),
        });
        if kept {
            // Timestamps are written all the same: whoever reads them waits for them.
            if writes.is_some() {
                encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
                    label: Some("gaunt pass, unchanged"),
                    timestamp_writes: writes,
                });
            }
            return;
        }
        let at = band as usize;
        match &self.work {
            Work::Points {
                surfaces,
                bound,
                sent,
            } => {
                encoder.clear_buffer(sent, 0, None);
                surfaces.record_points(encoder, bound, writes);
            }
            Work::LightUpdate { surfaces, bound } => {
                surfaces.record_update(encoder, bound, writes);
            }
            Work::PatchPoints { bases, bound, sent } => {
                encoder.clear_buffer(sent, 0, None);
                bases.record_points(encoder, bound, writes);
            }
            Work::BasisUpdate { bases, bound } => bases.record_update(encoder, bound, writes),
            Work::BasisGather {
                bases,
                bound,
                cleared,
            } => {
                if let (0, Some(cleared)) = (band, cleared) {
                    encoder.clear_buffer(cleared, 0, None);
                }
                bases.record_gather(encoder, &bound[at], gathering(self.at), writes);
            }
            Work::Gbuffer { pass, bound } => {
                pass.record(encoder, bands, band, bodies, &bound[at], stamps);
            }
            Work::LightView { views } => views.record(encoder, bodies, stamps),
            Work::Punctual { pass, bound } => pass.record(encoder, &bound[at], writes),
            Work::Irradiance { pass, bound } => pass.record(encoder, &bound[at], writes),
            Work::Shadow { pass, bound } => pass.record(encoder, &bound[at], writes),
            Work::LightGather {
                pass,
                bound,
                cleared,
            } => {
                if let (0, Some(cleared)) = (band, cleared) {
                    encoder.clear_buffer(cleared, 0, None);
                }
                pass.record(encoder, &bound[at], writes);
            }
            Work::Shares { pass, bound } => pass.record_shares(encoder, &bound[at], writes),
            Work::Upsample { pass, bound } => {
                pass.record(encoder, bands, band, &bound[at], writes);
            }
            Work::Scatter { pass, bound } => {
                pass.record_scatter(encoder, bands, band, &bound[at], writes);
            }
            Work::Resolve { pass, bound } => {
                pass.record(encoder, bands, band, &bound[at], writes);
            }
            Work::Plain(plain) => plain.record(encoder, bands, band, writes),
        }
    }

    /// How many dispatches and draws a frame records; `drawn` is what is drawn of a band.
    pub fn dispatches(&self, drawn: usize) -> usize {
        let all = |bounds: &[Bound]| bounds.iter().map(Bound::dispatches).sum::<usize>();
        let once = match &self.work {
            Work::Points { bound, .. } => bound.dispatches(),
            Work::PatchPoints { bound, .. } => bound.dispatches(),
            Work::LightUpdate { surfaces, bound } => surfaces.update_dispatches(bound),
            Work::BasisUpdate { bases, bound } => bases.update_dispatches(bound),
            Work::Gbuffer { bound, .. } => all(bound) + bound.len() * drawn,
            Work::LightView { views } => views.dispatches(drawn),
            Work::Irradiance { bound, .. }
            | Work::Punctual { bound, .. }
            | Work::Shadow { bound, .. }
            | Work::LightGather { bound, .. }
            | Work::BasisGather { bound, .. }
            | Work::Shares { bound, .. }
            | Work::Resolve { bound, .. }
            | Work::Plain(Plain { bound, .. }) => all(bound),
            Work::Upsample { bound, .. } => bound.iter().map(UpsampleBound::dispatches).sum(),
            Work::Scatter { bound, .. } => {
                let bands = bound.iter().map(UpsampleBound::scatter_dispatches);
                bands.sum()
            }
        };
        once * self.turns
    }

    /// Bytes that have been uploaded for it alone since it was made.
    pub fn uploaded(&self) -> u64 {
        match &self.work {
            Work::Irradiance { pass, .. } => pass.uploaded(),
            _ => 0,
        }
    }

    /// Bytes of GPU memory of a pass that this stage owns; those that several stages share are not counted.
    pub fn bytes(&self) -> Option<u64> {
        Some(match &self.work {
            Work::Points { surfaces, .. } => surfaces.bytes(),
            Work::PatchPoints { bases, .. } => bases.bytes(),
            Work::Gbuffer { pass, .. } => pass.bytes(),
            Work::LightView { views } => views.bytes(),
            Work::Irradiance { pass, .. } => pass.bytes(),
            Work::Resolve { pass, .. } => pass.bytes(),
            _ => return None,
        })
    }
}

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

/// How a pass of the table is made.
type Make = fn(&Setup, Domain) -> Result<Work, Error>;

/// Those that are more than a kernel over buffers of the frame; all others are [`Plain`].
static MAKERS: [(&Pass, Make); 14] = [
    (&LIGHT_VIEW, |setup, _| {
        let views = shared(setup.views, "light_view")?;
        Ok(Work::LightView { views })
    }),
    (&PUNCTUAL, punctual),
    (&POINTS, points),
    (&LIGHT_UPDATE, light_update),
    (&BASIS_UPDATE, basis_update),
    (&GBUFFER, gbuffer),
    (&IRRADIANCE, irradiance),
    (&SHADOW, shadow),
    (&LIGHT_GATHER, light_gather),
    (&BASIS_GATHER, basis_gather),
    (&SHARES, shares),
    (&UPSAMPLE, |setup, _| {
        let (pass, bound) = setup.upsampled()?;
        Ok(Work::Upsample { pass, bound })
    }),
    (&SCATTER, |setup, _| {
        let (pass, bound) = setup.upsampled()?;
        Ok(Work::Scatter { pass, bound })
    }),
    (&RESOLVE, resolve),
];

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

fn emitters(scene: &Scene) -> u32 {
    let shining = scene.lights.iter().filter(|lamp| lamp.shines());
    u32::try_from(shining.count()).unwrap_or(u32::MAX)
}

fn distributions(scene: &Scene) -> bool {
    let mut shining = scene.lights.iter().filter(|lamp| lamp.shines());
    shining.any(|lamp| lamp.distribution.is_some())
}

impl Setup<'_> {
    /// One pass of the plan.
    pub fn stage(&self, planned: &Planned) -> Result<Stage, Error> {
        let maker = MAKERS.iter().find(|(pass, _)| planned.is(pass));
        let work = match maker {
            Some((_, make)) => make(self, planned.at)?,
            None => Work::Plain(Plain::new(self, planned)?),
        };
        Ok(Stage {
            pass: planned.pass,
            at: planned.at,
            turns: planned.turns.len(),
            work,
        })
    }

    /// A band's part of a resource of a domain.
    pub fn part(&self, what: Resource, at: Domain, band: u32) -> Result<BufferBinding<'_>, Error> {
        self.buffers.band(what, at, self.bands_of(at)?, band)
    }

    /// Binds receivers and something written for each of them, of every band of a domain.
    fn each(
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

    fn upsampled(&self) -> Result<(Arc<UpsamplePass>, Vec<UpsampleBound>), Error> {
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
    fn rest(
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

    fn shadow(&self) -> Result<Arc<ShadowPass>, Error> {
        shared(self.shadow, "shadow")
    }

    fn surfaces(&self) -> Result<Arc<Surfaces>, Error> {
        shared(self.surfaces, "points")
    }

    fn bases(&self) -> Result<Arc<Bases>, Error> {
        shared(self.bases, "basis_update")
    }

    /// Points of surfaces or patches, in clusters, and something of each.
    fn points(
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

    fn gather(&self) -> Result<Arc<LightGatherPass>, Error> {
        shared(self.gather, "light_gather")
    }

    fn upsample(&self) -> Result<Arc<UpsamplePass>, Error> {
        shared(self.upsample, "upsample")
    }
}

fn shared<T>(pass: Option<&Arc<T>>, name: &'static str) -> Result<Arc<T>, Error> {
    pass.cloned().ok_or(Error::NoPass { pass: name })
}

/// Plans that were checked have what they upsample from.
const NO_HALVES: Error = Error::NoPass {
    pass: "gbuffer at half resolution",
};

fn light_update(setup: &Setup, _: Domain) -> Result<Work, Error> {
    let surfaces = setup.surfaces()?;
    let light = |what| setup.part(what, Domain::Points, 0);
    let bound = surfaces.bind_update(setup.device, [light(RADIANCE)?, light(SENT)?])?;
    Ok(Work::LightUpdate { surfaces, bound })
}

fn points(setup: &Setup, at: Domain) -> Result<Work, Error> {
    let sent = setup.buffers.get(SENT, at).cloned();
    let sent = sent.ok_or(Error::NoResource {
        resource: SENT.name,
    })?;
    let receivers = setup.part(RECEIVERS, at, 0)?;
    if at == Domain::Patches {
        let bases = setup.bases()?;
        let bound = bases.bind_points(setup.device, receivers)?;
        return Ok(Work::PatchPoints { bases, bound, sent });
    }
    let surfaces = setup.surfaces()?;
    let bound = surfaces.bind_points(setup.device, receivers)?;
    Ok(Work::Points {
        surfaces,
        bound,
        sent,
    })
}

fn basis_update(setup: &Setup, at: Domain) -> Result<Work, Error> {
    let bases = setup.bases()?;
    let light = |what| setup.part(what, at, 0);
    let bound = bases.bind_update(setup.device, [light(RADIANCE)?, light(SENT)?])?;
    Ok(Work::BasisUpdate { bases, bound })
}

fn basis_gather(setup: &Setup, at: Domain) -> Result<Work, Error> {
    let bases = setup.bases()?;
    // What spheres have sent comes first.
    let sent = setup.buffers.get(SENT, at).cloned();
    let cleared = sent.filter(|_| setup.gather.is_none());
    let kind = gathering(at);
    let clustered = |device: &Device, rest: RestBinding<'_>| {
        let clusters = Some(rest.clusters);
        bases.bind(device, rest.receivers, clusters, rest.radiance, kind)
    };
    let tiled = |device: &Device, [receivers, written]: [BufferBinding<'_>; 2]| {
        bases.bind(device, receivers, None, written, kind)
    };
    let bound = match at {
        Domain::Points | Domain::Patches => setup.points(at, SENT, clustered)?,
        Domain::Halves => setup.each(at, SENT, tiled)?,
        Domain::Rest => setup.rest(clustered)?,
        _ => setup.each(at, RADIANCE, tiled)?,
    };
    Ok(Work::BasisGather {
        bases,
        bound,
        cleared,
    })
}

/// Who gathers what patches send in a domain.
fn gathering(at: Domain) -> Gathering {
    match at {
        Domain::Patches => Gathering::Points,
        Domain::Gloss => Gathering::Gloss,
        _ => Gathering::Seen,
    }
}

fn gbuffer(setup: &Setup, at: Domain) -> Result<Work, Error> {
    let objects = &setup.scene.objects;
    let drawn = Drawn {
        bodies: objects.iter().any(|o| !o.mesh.triangles.is_empty()),
        ground: setup.scene.ground.is_some(),
    };
    let pass = GbufferPass::drawing(setup.pipelines, setup.bands_of(at)?, drawn)?;
    let bands = setup.bands_of(at)?;
    let bound = (0..bands.count()).map(|band| {
        let receivers = setup.part(RECEIVERS, at, band)?;
        // That at half resolution goes where that of samples comes later: nobody reads it.
        let albedo = setup.buffers.band(ALBEDO, Domain::Samples, bands, band)?;
        pass.bind(setup.device, receivers, albedo)
    });
    let bound = bound.collect::<Result<_, Error>>()?;
    Ok(Work::Gbuffer { pass, bound })
}

fn irradiance(setup: &Setup, at: Domain) -> Result<Work, Error> {
    let order = setup.scene.settings.order;
    let (count, uneven) = (emitters(setup.scene), distributions(setup.scene));
    let gloss = at == Domain::Gloss;
    let pass = IrradiancePass::of(setup.pipelines, order, (count, uneven), gloss)?;
    let bound = setup.each(at, RADIANCE, |device, [receivers, radiance]| {
        pass.bind(device, receivers, radiance)
    })?;
    Ok(Work::Irradiance { pass, bound })
}

fn punctual(setup: &Setup, at: Domain) -> Result<Work, Error> {
    let views = shared(setup.views, "punctual")?;
    let order = setup.scene.settings.order;
    let kinds = [views.draws(), at == Domain::Gloss];
    let pass = PunctualPass::new(setup.pipelines, order, &views, kinds)?;
    let bound = setup.each(at, RADIANCE, |device, [receivers, radiance]| {
        pass.bind(device, receivers, radiance)
    })?;
    Ok(Work::Punctual { pass, bound })
}

fn shadow(setup: &Setup, at: Domain) -> Result<Work, Error> {
    let pass = match at {
        Domain::Gloss => {
            let inputs = shared(setup.inputs, "shadow")?;
            Arc::new(ShadowPass::of(&inputs, options(setup.scene), true)?)
        }
        _ => setup.shadow()?,
    };
    let clustered = |device: &Device, rest: RestBinding<'_>| {
        pass.bind_clusters(device, rest.receivers, rest.clusters, rest.radiance)
    };
    let bound = match at {
        Domain::Points | Domain::Patches => setup.points(at, RADIANCE, clustered)?,
        Domain::Rest => setup.rest(clustered)?,
        _ => setup.each(at, RADIANCE, |device, [receivers, radiance]| {
            pass.bind(device, receivers, radiance)
        })?,
    };
    Ok(Work::Shadow { pass, bound })
}

fn light_gather(setup: &Setup, at: Domain) -> Result<Work, Error> {
    let (mut pass, mut cleared) = (setup.gather()?, None);
    if at == Domain::Gloss {
        let inputs = shared(setup.inputs, "light_gather")?;
        pass = Arc::new(pass.for_gloss(&inputs)?);
    }
    let clustered = |device: &Device, rest: RestBinding<'_>| {
        pass.bind_clusters(device, rest.receivers, rest.clusters, rest.radiance)
    };
    let bound = match at {
        Domain::Points | Domain::Patches => {
            cleared = setup.buffers.get(SENT, at).cloned();
            setup.points(at, SENT, clustered)?
        }
        // What is sent is interpolated apart from the light that blockers leave a share of.
        Domain::Halves => {
            cleared = setup.buffers.get(SENT, at).cloned();
            setup.each(at, SENT, |device, [receivers, sent]| {
                pass.bind(device, receivers, sent)
            })?
        }
        Domain::Rest => setup.rest(clustered)?,
        _ => setup.each(at, RADIANCE, |device, [receivers, radiance]| {
            pass.bind(device, receivers, radiance)
        })?,
    };
    Ok(Work::LightGather {
        pass,
        bound,
        cleared,
    })
}

fn shares(setup: &Setup, at: Domain) -> Result<Work, Error> {
    let pass = setup.upsample()?;
    let bound = setup.each(at, SHARE, |device, [receivers, shares]| {
        let halves = HalfBinding {
            receivers,
            shares,
            sent: None,
        };
        pass.bind_shares(device, halves)
    })?;
    Ok(Work::Shares { pass, bound })
}

fn resolve(setup: &Setup, _: Domain) -> Result<Work, Error> {
    let bands = setup.bands;
    let environment = &setup.scene.environment;
    let gloss = setup.buffers.get(RADIANCE, Domain::Gloss).is_some();
    let pass = ResolvePass::of(setup.pipelines, setup.queue, bands, (environment, gloss))?;
    let bound = (0..bands.count()).map(|band| {
        let sample = |what| setup.part(what, Domain::Samples, band);
        let lit = (sample(RECEIVERS)?, sample(ALBEDO)?, sample(RADIANCE)?);
        let picture = setup.part(PICTURE, Domain::Pixels, band)?;
        let mirrored = match gloss {
            true => Some(setup.part(RADIANCE, Domain::Gloss, band)?),
            false => None,
        };
        pass.bind_with(setup.device, [lit.0, lit.1, lit.2], mirrored, picture)
    });
    let bound = bound.collect::<Result<_, Error>>()?;
    Ok(Work::Resolve { pass, bound })
}

#[cfg(test)]
mod tests {
    use super::*;
    use sh_kernels::Pass as Kernels;
    use sh_scene::PASSES;

    #[test]
    fn every_pass_of_the_table_is_made() {
        for pass in PASSES {
            let own = Kernels::ALL
                .iter()
                .any(|kernels| kernels.name() == pass.name);
            let made = MAKERS.iter().any(|(made, _)| *made == pass);
            assert!(made || own, "{pass:?}");
        }
    }
}
