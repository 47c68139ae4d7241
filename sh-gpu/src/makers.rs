//! How each pass of a plan is made and bound to the buffers of a frame.

use crate::plain::Plain;
use crate::punctual::PunctualPass;
use crate::setup::{Setup, distributions, emitters, options, shared};
use crate::stages::{Stage, Work, gathering};
use crate::{
    Drawn, Error, GbufferPass, HalfBinding, IrradiancePass, ResolvePass, RestBinding, ShadowPass,
};
use sh_scene::passes::{
    BASIS_GATHER, BASIS_UPDATE, GBUFFER, IRRADIANCE, LIGHT_GATHER, LIGHT_UPDATE, LIGHT_VIEW,
    POINTS, PUNCTUAL, RESOLVE, SCATTER, SHADOW, SHARES, UPSAMPLE,
};
use sh_scene::resource::{ALBEDO, PICTURE, RADIANCE, RECEIVERS, SENT, SHARE};
use sh_scene::{Domain, Pass, Planned};
use std::sync::Arc;
use wgpu::{BufferBinding, Device};

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

/// One pass of the plan.
pub(crate) fn stage(setup: &Setup, planned: &Planned) -> Result<Stage, Error> {
    let maker = MAKERS.iter().find(|(pass, _)| planned.is(pass));
    let work = match maker {
        Some((_, make)) => make(setup, planned.at)?,
        None => Work::Plain(Plain::new(setup, planned)?),
    };
    Ok(Stage {
        pass: planned.pass,
        at: planned.at,
        turns: planned.turns.len(),
        work,
    })
}

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
    let bound = match at {
        Domain::Points | Domain::Patches => setup.points(at, RADIANCE, |device, rest| {
            pass.bind(device, rest.receivers, rest.radiance)
        })?,
        _ => setup.each(at, RADIANCE, |device, [receivers, radiance]| {
            pass.bind(device, receivers, radiance)
        })?,
    };
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
