//! What is computed at half resolution.

use super::shading::Shadows;
use super::work::{Ledger, Stages};
use super::{bytes, position};
use crate::gbuffer::{Gbuffer, gbuffer};
use crate::irradiance::irradiance;
use crate::upsample::Halves;
use crate::{Error, Geometry};
use sh_scene::{PassKind, Plan, Resolution, View};

/// Its passes, over the whole picture.
pub(super) fn half(
    geometry: &Geometry,
    view: &View,
    plan: &Plan,
    shadows: &mut Shadows,
    ledger: &mut Ledger,
    stages: &mut Stages,
) -> Result<Halves, Error> {
    let at = |kind: PassKind| {
        let half = |pass: &sh_scene::Pass| pass.kind == kind && pass.at == Resolution::Halves;
        plan.passes.iter().position(half)
    };
    let missing = |missing| Error::Plan { missing };
    let seen_by = at(PassKind::Gbuffer).ok_or(missing("gbuffer at half resolution"))?;
    let shaded_by = at(PassKind::Shadow).ok_or(missing("shadow at half resolution"))?;
    let grid = view.halves();
    let tiles = grid.tiles();
    let clusters = tiles.clusters();
    let all = clusters.len() as u64;
    let mut seen = Gbuffer::default();
    ledger.pass(seen_by, |tasks| {
        *tasks = all;
        stages.time("gbuffer", || {
            gbuffer(geometry, view, grid, 0..tiles.rows, &mut seen)
        })
    })?;
    let receivers = seen.receivers;
    ledger.holds(seen_by, "receivers at half resolution", bytes(&receivers));
    let mut shadowed = vec![[0.0; 3]; receivers.len()];
    ledger.holds(shaded_by, "radiance at half resolution", bytes(&shadowed));
    ledger.pass(shaded_by, |tasks| {
        *tasks = all;
        shadows.shade(&receivers, &clusters, &mut shadowed, stages)
    })?;
    let sent = match at(PassKind::LightGather) {
        Some(pass) => {
            let sent = ledger.pass(pass, |tasks| {
                *tasks = all;
                shadows.gather(&receivers, &clusters, stages)
            })?;
            ledger.holds(pass, "light sent, at half resolution", bytes(&sent));
            sent
        }
        None => Vec::new(),
    };
    let share = |_: &mut u64| {
        stages.time("upsample", || {
            let mut open = vec![[0.0; 3]; receivers.len()];
            irradiance(&receivers, shadows.light, &mut open)?;
            let halves = Halves::new(receivers, &shadowed, &open)?;
            match sent.is_empty() {
                true => Ok(halves),
                false => halves.with_sent(sent),
            }
        })
    };
    match position(plan, PassKind::Upsample) {
        Some(pass) => {
            let halves: Halves = ledger.pass(pass, share)?;
            let shares = bytes(&halves.shares);
            ledger.holds(pass, "shares at half resolution", shares);
            Ok(halves)
        }
        None => Err(missing("upsample")),
    }
}
