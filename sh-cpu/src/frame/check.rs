//! Whether a plan makes a picture.

use crate::Error;
use sh_scene::{PassKind, Plan, Resolution};

/// Whether it does: samples, then light on them, then pixels.
pub(super) fn check_plan(plan: &Plan) -> Result<(), Error> {
    let at = |kinds: &[PassKind], resolution: Resolution| {
        plan.passes
            .iter()
            .position(|pass| pass.at == resolution && kinds.contains(&pass.kind))
    };
    let (samples, halves) = (Resolution::Samples, Resolution::Halves);
    let missing = |missing| Error::Plan { missing };
    let sampled = at(&[PassKind::Gbuffer], samples).ok_or(missing("gbuffer"))?;
    let light = [PassKind::Irradiance, PassKind::Shadow, PassKind::Upsample];
    let lit = at(&light, samples).ok_or(missing("irradiance, shadow or upsample"))?;
    let resolved = at(&[PassKind::Resolve], Resolution::Pixels).ok_or(missing("resolve"))?;
    if plan.has(PassKind::Upsample) {
        let seen = at(&[PassKind::Gbuffer], halves).ok_or(missing("gbuffer at half resolution"))?;
        let shaded = at(&[PassKind::Shadow], halves).ok_or(missing("shadow at half resolution"))?;
        if seen > shaded || shaded > lit {
            return Err(Error::PlanOrder);
        }
    }
    if sampled < lit && lit < resolved {
        Ok(())
    } else {
        Err(Error::PlanOrder)
    }
}
