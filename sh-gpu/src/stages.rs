//! The passes of a plan, made and bound to the buffers of a frame.

use crate::buffers::Buffers;
use crate::{
    Bands, Bound, Drawn, Error, GbufferPass, IrradiancePass, LightGatherPass, LightUpdatePass,
    Pipelines, ResolvePass, Shading, ShadowOptions, ShadowPass, Shining, UpsampleBound,
    UpsamplePass,
};
use sh_scene::{Pass, PassKind, Plan, Resolution, Scene};
use wgpu::{Buffer, BufferBinding, Device, Queue};

/// One pass of the plan, with what it binds for every band.
#[derive(Debug)]
pub(crate) struct Stage {
    pub kind: PassKind,
    /// Whether its bands are those of half resolution.
    pub half: bool,
    pub work: Work,
}

impl Stage {
    /// How many dispatches and draws a frame records; `drawn` is what is drawn of a band.
    pub fn dispatches(&self, drawn: usize) -> usize {
        let all = |bounds: &[Bound]| bounds.iter().map(Bound::dispatches).sum::<usize>();
        match &self.work {
            Work::LightUpdate { pass } => pass.dispatches(),
            Work::Gbuffer { bound, .. } => all(bound) + bound.len() * drawn,
            Work::Irradiance { bound, .. } | Work::Shadow { bound } => all(bound),
            Work::LightGather { bound, .. } | Work::Resolve { bound, .. } => all(bound),
            Work::Upsample { shares, bound, .. } => {
                let bands = bound.iter().map(UpsampleBound::dispatches);
                all(shares) + bands.sum::<usize>()
            }
        }
    }

    /// Bytes that have been uploaded for it alone since it was made.
    pub fn uploaded(&self) -> u64 {
        match &self.work {
            Work::LightUpdate { pass } => pass.uploaded(),
            Work::Irradiance { pass, .. } => pass.uploaded(),
            _ => 0,
        }
    }

    /// Name and bytes of GPU memory of a pass that this stage owns; those that several stages share are not counted.
    pub fn bytes(&self) -> Option<(&'static str, u64)> {
        Some(match &self.work {
            Work::LightUpdate { pass } => ("light_update", pass.bytes()),
            Work::Gbuffer { pass, .. } => ("gbuffer", pass.bytes()),
            Work::Irradiance { pass, .. } => ("irradiance", pass.bytes()),
            Work::Upsample { pass, .. } => ("upsample", pass.bytes()),
            Work::Resolve { pass, .. } => ("resolve", pass.bytes()),
            Work::Shadow { .. } | Work::LightGather { .. } => return None,
        })
    }
}

#[derive(Debug)]
pub(crate) enum Work {
    /// Once a frame, before all bands.
    LightUpdate {
        pass: Box<LightUpdatePass>,
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
        bound: Vec<Bound>,
    },
    LightGather {
        bound: Vec<Bound>,
        /// What has to be cleared before the first band.
        cleared: Option<Buffer>,
    },
    Upsample {
        pass: UpsamplePass,
        /// For each band at half resolution.
        shares: Vec<Bound>,
        bound: Vec<UpsampleBound>,
    },
    Resolve {
        pass: ResolvePass,
        bound: Vec<Bound>,
    },
}

/// What stages are made from.
pub(crate) struct Setup<'a> {
    pub device: &'a Device,
    pub pipelines: &'a Pipelines,
    pub queue: &'a Queue,
    pub scene: &'a Scene,
    pub bands: &'a Bands,
    pub halves: Option<&'a Bands>,
    pub shadow: Option<&'a ShadowPass>,
    pub gather: Option<&'a LightGatherPass>,
    pub buffers: &'a Buffers,
}

/// Whether a pass works at half resolution.
pub(crate) fn is_half(pass: &Pass) -> bool {
    pass.at == Resolution::Halves
}

/// The shadow pass that all passes of the plan share, if any needs one.
pub(crate) fn shadow_pass(
    pipelines: &Pipelines,
    scene: &Scene,
    plan: &Plan,
) -> Result<Option<ShadowPass>, Error> {
    let needs = |kind| plan.has(kind);
    if !needs(PassKind::Shadow) && !needs(PassKind::Upsample) && !sends(plan) {
        return Ok(None);
    }
    let blockers: usize = scene.objects.iter().map(|o| o.spheres.len()).sum();
    let options = ShadowOptions {
        order: scene.settings.order,
        accumulation: scene.settings.accumulation,
        max_blockers: u32::try_from(blockers).unwrap_or(u32::MAX),
        max_emitters: emitters(scene),
        distributions: distributions(scene),
        ..ShadowOptions::default()
    };
    ShadowPass::with(pipelines, options).map(Some)
}

/// Whether spheres send light on.
pub(crate) fn sends(plan: &Plan) -> bool {
    plan.has(PassKind::LightUpdate) || plan.has(PassKind::LightGather)
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
    pub fn stage(&self, pass: &Pass) -> Result<Stage, Error> {
        Ok(Stage {
            kind: pass.kind,
            half: is_half(pass),
            work: self.work(pass)?,
        })
    }

    fn work(&self, pass: &Pass) -> Result<Work, Error> {
        let &Self {
            device,
            queue,
            pipelines,
            ..
        } = self;
        Ok(match pass.kind {
            PassKind::Gbuffer => {
                let objects = &self.scene.objects;
                let drawn = Drawn {
                    bodies: objects.iter().any(|o| !o.mesh.triangles.is_empty()),
                    ground: self.scene.ground.is_some(),
                };
                let raster = GbufferPass::drawing(pipelines, self.bands_of(pass)?, drawn)?;
                let bound = self.each(pass, |[receivers, albedo, _]| {
                    raster.bind(device, receivers, albedo)
                })?;
                Work::Gbuffer {
                    pass: raster,
                    bound,
                }
            }
            PassKind::Irradiance => {
                let order = self.scene.settings.order;
                let (count, uneven) = (emitters(self.scene), distributions(self.scene));
                let light = IrradiancePass::with(pipelines, order, count, uneven)?;
                let bound = self.each(pass, |[receivers, _, radiance]| {
                    light.bind(device, receivers, radiance)
                })?;
                Work::Irradiance { pass: light, bound }
            }
            PassKind::Shadow => {
                let shadow = self.shadow()?;
                let bound = self.each(pass, |[receivers, _, radiance]| {
                    shadow.bind(device, receivers, radiance)
                })?;
                Work::Shadow { bound }
            }
            PassKind::LightUpdate => {
                let bodies = self.scene.objects.iter().map(Shining::from);
                let bounces = self.scene.settings.indirect.unwrap_or_default().bounces;
                let (shadow, gather) = (self.shadow()?, self.gather()?);
                let pass = LightUpdatePass::new(device, queue, shadow, gather, bodies, bounces)?;
                let pass = Box::new(pass);
                Work::LightUpdate { pass }
            }
            PassKind::LightGather => self.light_gather(pass)?,
            PassKind::Upsample => self.upsample()?,
            PassKind::Resolve => {
                let (bands, buffers) = (self.bands, self.buffers);
                let resolve = ResolvePass::with(pipelines, queue, bands, &self.scene.environment)?;
                let bound = (0..bands.count()).map(|band| {
                    let [receivers, albedo, radiance] = buffers.samples(bands, band);
                    let picture = buffers.picture_of(bands, band);
                    resolve.bind(device, receivers, albedo, radiance, picture)
                });
                Work::Resolve {
                    bound: bound.collect::<Result<_, _>>()?,
                    pass: resolve,
                }
            }
        })
    }

    fn light_gather(&self, pass: &Pass) -> Result<Work, Error> {
        let (device, gather) = (self.device, self.gather()?);
        if !is_half(pass) {
            let bound = self.each(pass, |[receivers, _, radiance]| {
                gather.bind(device, receivers, radiance)
            })?;
            let cleared = None;
            return Ok(Work::LightGather { bound, cleared });
        }
        // What is sent is interpolated apart from the light that blockers leave a share of.
        let bands = self.bands_of(pass)?;
        let bound = (0..bands.count()).map(|band| {
            let half = self.buffers.half(bands, band).ok_or(NO_HALVES)?;
            gather.bind(device, half.receivers, half.sent.ok_or(NO_HALVES)?)
        });
        Ok(Work::LightGather {
            bound: bound.collect::<Result<_, Error>>()?,
            cleared: self.buffers.half_sent().cloned(),
        })
    }

    fn upsample(&self) -> Result<Work, Error> {
        let &Self { device, bands, .. } = self;
        let (halves, shadow) = (self.halves.ok_or(NO_HALVES)?, self.shadow()?);
        let shading = Shading {
            shadow,
            gather: self.gather,
        };
        let pass = UpsamplePass::new(device, self.queue, bands, shading)?;
        let shares = (0..halves.count()).map(|band| {
            let half = self.buffers.half(halves, band).ok_or(NO_HALVES)?;
            pass.bind_shares(device, half)
        });
        let shares = shares.collect::<Result<_, Error>>()?;
        let bound = (0..bands.count()).map(|band| {
            let under = self.buffers.under(bands, halves, band).ok_or(NO_HALVES)?;
            let [receivers, _, radiance] = self.buffers.samples(bands, band);
            pass.bind(device, shading, under, receivers, radiance)
        });
        Ok(Work::Upsample {
            shares,
            bound: bound.collect::<Result<_, Error>>()?,
            pass,
        })
    }

    /// Binds receivers, albedo and radiance of every band that a pass works on.
    fn each(
        &self,
        pass: &Pass,
        bind: impl Fn([BufferBinding<'_>; 3]) -> Result<Bound, Error>,
    ) -> Result<Vec<Bound>, Error> {
        let bands = self.bands_of(pass)?;
        let of = |band| match is_half(pass) {
            true => self.buffers.half_band(bands, band).ok_or(NO_HALVES),
            false => Ok(self.buffers.samples(bands, band)),
        };
        (0..bands.count()).map(|band| bind(of(band)?)).collect()
    }

    fn bands_of(&self, pass: &Pass) -> Result<&Bands, Error> {
        match is_half(pass) {
            true => self.halves.ok_or(NO_HALVES),
            false => Ok(self.bands),
        }
    }

    fn shadow(&self) -> Result<&ShadowPass, Error> {
        self.shadow
            .ok_or(Error::Plan("has no shadow pass for what it shades"))
    }

    fn gather(&self) -> Result<&LightGatherPass, Error> {
        self.gather
            .ok_or(Error::Plan("has no light gather pass for what is sent on"))
    }
}

const NO_HALVES: Error = Error::Plan("upsamples, but nothing in it works at half resolution");
