//! A whole picture: the passes of a plan, band by band.

use crate::gbuffer::{Gbuffer, check_view, gbuffer};
use crate::irradiance::irradiance;
use crate::resolve::{check_environment, resolve};
use crate::shadow::shadow;
use crate::{Error, Geometry};
use sh_scene::{Light, PassKind, Plan, Scene, View};
use std::time::{Duration, Instant};

/// Pixel rows a band. With 1280 columns a band's samples are 3 MB, so that a pass finds in the cache what the
/// one before it wrote.
const BAND: u32 = 8;

/// A rendered picture and where its time went.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// Linear Rec.709 radiance, row by row from the top.
    pub pixels: Vec<[f32; 3]>,
    /// Wall time of each stage, in the order they ran: `hierarchy` and `light`, which happen once, then the
    /// passes of the plan by name.
    pub stages: Vec<(&'static str, Duration)>,
}

/// Renders `scene` by `plan`, `size` = (width, height) in pixels.
///
/// `progress` is called after each band with the finished part of the picture, 0 to 1.
///
/// The picture is made in horizontal bands, each through all passes, so that memory beyond the pixels stays
/// at a few megabytes. Work within a band is spread over the threads of the current rayon pool; the result
/// does not depend on how many there are.
pub fn render(
    scene: &Scene,
    plan: &Plan,
    size: (u32, u32),
    progress: &(dyn Fn(f32) + Sync),
) -> Result<Frame, Error> {
    let (width, height) = size;
    let view = View {
        camera: scene.camera,
        width,
        height,
    };
    check_view(&view)?;
    check_environment(&scene.environment)?;
    check_plan(plan)?;

    let start = Instant::now();
    let geometry = Geometry::new(scene)?;
    let hierarchy = start.elapsed();
    let start = Instant::now();
    let settings = &scene.settings;
    let light = Light::project(
        &scene.environment,
        scene.ground,
        settings.order,
        settings.window,
    )?;
    let projection = start.elapsed();
    let spheres = scene.world_spheres();

    let mut spent = vec![Duration::ZERO; plan.passes.len()];
    let mut pixels = vec![[0.0; 3]; width as usize * height as usize];
    let mut samples = Gbuffer::default();
    let mut radiance = Vec::new();
    for (band, pixels) in pixels.chunks_mut((BAND * width) as usize).enumerate() {
        let first = band as u32 * BAND;
        let rows = first..(first + BAND).min(height);
        for (pass, spent) in plan.passes.iter().zip(&mut spent) {
            let start = Instant::now();
            match pass.kind {
                PassKind::Gbuffer => {
                    let samples_of = |row| row * View::OVERSAMPLE;
                    let rows = samples_of(rows.start)..samples_of(rows.end);
                    gbuffer(&geometry, &view, rows, &mut samples)?;
                    radiance.resize(samples.receivers.len(), [0.0; 3]);
                }
                PassKind::Irradiance => irradiance(&samples.receivers, &light, &mut radiance)?,
                PassKind::Shadow => {
                    let accumulation = settings.accumulation;
                    let receivers = &samples.receivers;
                    shadow(receivers, &spheres, &light, accumulation, &mut radiance)?;
                }
                PassKind::Resolve => {
                    let environment = &scene.environment;
                    resolve(
                        &view,
                        rows.clone(),
                        &samples,
                        &radiance,
                        environment,
                        pixels,
                    )?;
                }
            }
            *spent += start.elapsed();
        }
        progress(rows.end as f32 / height as f32);
    }

    let mut stages = vec![("hierarchy", hierarchy), ("light", projection)];
    stages.extend(plan.passes.iter().map(|pass| pass.kind.name()).zip(spent));
    Ok(Frame {
        width,
        height,
        pixels,
        stages,
    })
}

/// Whether a plan makes a picture: samples, then light on them, then pixels.
fn check_plan(plan: &Plan) -> Result<(), Error> {
    let at = |kinds: &[PassKind]| {
        plan.passes
            .iter()
            .position(|pass| kinds.contains(&pass.kind))
    };
    let missing = |missing| Error::Plan { missing };
    let sampled = at(&[PassKind::Gbuffer]).ok_or(missing("gbuffer"))?;
    let lit =
        at(&[PassKind::Irradiance, PassKind::Shadow]).ok_or(missing("irradiance or shadow"))?;
    let resolved = at(&[PassKind::Resolve]).ok_or(missing("resolve"))?;
    if sampled < lit && lit < resolved {
        Ok(())
    } else {
        Err(Error::PlanOrder)
    }
}
