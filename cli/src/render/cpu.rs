//! A picture on the CPU: the passes of the plan, band by band.

use super::Frame;
use crate::Error;
use crate::progress::Progress;
use crate::report::Times;
use sh_cpu::{Gbuffer, Geometry};
use sh_scene::{PassKind, View};

/// Samples a band holds: as few as keep all threads busy, for memory and for the progress bar.
const BAND: u32 = 1 << 18;

/// Runs the plan. The picture is linear radiance, row by row from the top.
pub fn picture(
    frame: &Frame,
    times: &mut Times,
    progress: &Progress,
) -> Result<Vec<[f32; 3]>, Error> {
    let Frame {
        scene,
        plan,
        view,
        light,
    } = frame;
    let geometry = times.measure("hierarchy", || Geometry::new(scene))?;
    let spheres = scene.world_spheres();
    let mut pixels = vec![[0.0; 3]; view.width as usize * view.height as usize];
    let mut samples = Gbuffer::default();
    let mut radiance = Vec::new();

    let rows = (BAND / (view.width * View::OVERSAMPLE * View::OVERSAMPLE)).max(1);
    for first in (0..view.height).step_by(rows as usize) {
        let last = (first + rows).min(view.height);
        let at = |row: u32| row as usize * view.width as usize;
        let band = &mut pixels[at(first)..at(last)];
        for pass in &plan.passes {
            times.measure(pass.kind.name(), || match pass.kind {
                PassKind::Gbuffer => {
                    let rows = first * View::OVERSAMPLE..last * View::OVERSAMPLE;
                    let done = sh_cpu::gbuffer(&geometry, view, rows, &mut samples);
                    radiance.resize(samples.receivers.len(), [0.0; 3]);
                    done
                }
                PassKind::Irradiance => {
                    sh_cpu::irradiance(&samples.receivers, light, &mut radiance)
                }
                PassKind::Shadow => {
                    sh_cpu::shadow(&samples.receivers, &spheres, light, &mut radiance)
                }
                PassKind::Resolve => {
                    let environment = &scene.environment;
                    sh_cpu::resolve(view, first..last, &samples, &radiance, environment, band)
                }
            })?;
        }
        progress.set(last as f32 / view.height as f32);
    }
    Ok(pixels)
}
