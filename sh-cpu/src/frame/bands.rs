//! A band of samples, pass by pass.

use super::bytes;
use super::shading::{Shadows, add};
use super::work::{Ledger, Stages};
use crate::gbuffer::{Gbuffer, gbuffer};
use crate::irradiance::irradiance;
use crate::resolve::resolve;
use crate::upsample::{Failed, Halves, upsample};
use crate::{Error, Geometry};
use sh_scene::{PassKind, Plan, Resolution, Tiles, View};

/// What a band of samples goes through. Its memory serves all bands.
pub(super) struct Bands<'a> {
    pub view: &'a View,
    pub plan: &'a Plan,
    pub geometry: &'a Geometry<'a>,
    pub halves: &'a Halves,
    pub samples: Gbuffer,
    pub radiance: Vec<[f32; 3]>,
    pub failed: Failed,
    pub anew: Vec<[f32; 3]>,
}

impl Bands<'_> {
    pub fn render(
        &mut self,
        rows: std::ops::Range<u32>,
        pixels: &mut [[f32; 3]],
        shadows: &mut Shadows,
        ledger: &mut Ledger,
        stages: &mut Stages,
    ) -> Result<(), Error> {
        let &mut Self {
            view,
            plan,
            geometry,
            halves,
            ref mut samples,
            ref mut radiance,
            ref mut failed,
            ref mut anew,
        } = self;
        let tiles = Tiles {
            rows: rows.len() as u32,
            ..view.samples().tiles()
        };
        let all = u64::from(tiles.columns) * u64::from(tiles.rows);
        for (index, pass) in plan.passes.iter().enumerate() {
            if pass.at == Resolution::Halves {
                continue;
            }
            ledger.pass(index, |tasks| -> Result<(), Error> {
                *tasks = all;
                match pass.kind {
                    // Once a frame, before all bands.
                    PassKind::LightUpdate => *tasks = 0,
                    PassKind::Gbuffer => {
                        let (rows, grid) = (rows.clone(), view.samples());
                        stages.time("gbuffer", || gbuffer(geometry, view, grid, rows, samples))?;
                        radiance.resize(samples.receivers.len(), [0.0; 3]);
                    }
                    PassKind::Irradiance => stages.time("irradiance", || {
                        irradiance(&samples.receivers, shadows.light, radiance)
                    })?,
                    PassKind::Shadow => {
                        shadows.shade(&samples.receivers, &tiles.clusters(), radiance, stages)?;
                    }
                    PassKind::LightGather => {
                        let sent = shadows.gather(&samples.receivers, &tiles.clusters(), stages)?;
                        add(radiance, &sent);
                    }
                    PassKind::Upsample => {
                        stages.time("upsample", || {
                            irradiance(&samples.receivers, shadows.light, radiance)?;
                            upsample(view, halves, rows.clone(), samples, radiance, failed)
                        })?;
                        anew.resize(failed.receivers.len(), [0.0; 3]);
                        let Failed {
                            receivers,
                            clusters,
                            ..
                        } = &*failed;
                        *tasks += clusters.len() as u64;
                        shadows.shade(receivers, clusters, anew, stages)?;
                        let sent = shadows.gather(receivers, clusters, stages)?;
                        add(anew, &sent);
                        for (&index, light) in failed.indices.iter().zip(&*anew) {
                            radiance[index as usize] = *light;
                        }
                    }
                    PassKind::Resolve => {
                        *tasks = u64::from(rows.len() as u32 * Tiles::SIDE / View::OVERSAMPLE);
                        let environment = &geometry.scene.environment;
                        stages.time("resolve", || {
                            let rows = rows.clone();
                            resolve(view, rows, samples, radiance, environment, pixels)
                        })?;
                    }
                }
                Ok(())
            })?;
        }
        Ok(())
    }

    /// Tells of its memory.
    pub fn hold(&self, ledger: &mut Ledger) {
        let Self {
            samples,
            radiance,
            failed,
            anew,
            ..
        } = self;
        for (index, pass) in self.plan.passes.iter().enumerate() {
            if pass.at == Resolution::Halves {
                continue;
            }
            match pass.kind {
                PassKind::Gbuffer => {
                    ledger.holds(index, "triangles", self.geometry.hierarchy().bytes());
                    ledger.holds(index, "receivers of a band", bytes(&samples.receivers));
                    ledger.holds(index, "albedo of a band", bytes(&samples.albedo));
                }
                PassKind::Irradiance | PassKind::Shadow => {
                    ledger.holds(index, "radiance of a band", bytes(radiance));
                }
                PassKind::LightGather => {
                    ledger.holds(index, "light sent to a band", bytes(radiance));
                }
                PassKind::Upsample => {
                    ledger.holds(index, "radiance of a band", bytes(radiance));
                    let again = bytes(&failed.receivers) + bytes(&failed.indices) + bytes(anew);
                    ledger.holds(index, "what a band shades anew", again);
                }
                PassKind::LightUpdate | PassKind::Resolve => {}
            }
        }
    }
}
