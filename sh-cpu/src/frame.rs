//! A whole picture: the passes of a plan, band by band.

use crate::gbuffer::{Gbuffer, check_view, gbuffer};
use crate::irradiance::irradiance;
use crate::light_gather::{LightGather, light_gather};
use crate::resolve::{check_environment, resolve};
use crate::shadow::{Shadow, shadow_clusters};
use crate::upsample::{Failed, Halves, upsample};
use crate::{Body, LightCutOptions, LightCuts, LightUpdate, SphericalLights};
use crate::{CutOptions, Cuts, Error, Geometry, Path};
use sh_scene::{Forest, Light, PassKind, Plan, Receiver, Resolution, Scene, Settings, Tiles, View};
use std::ops::Range;
use std::time::{Duration, Instant};

/// Rows of tiles a band: 16 rows of pixels. With 1280 columns a band's samples are 6 MB, so that a pass finds in the
/// cache what the one before it wrote.
const BAND: u32 = 2;

/// A rendered picture and where its time went.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// Linear Rec.709 radiance, row by row from the top.
    pub pixels: Vec<[f32; 3]>,
    /// Wall time of each stage, in the order they first ran: `hierarchy`, `light` and `forest`, which happen once, then
    /// the passes of the plan by name, `cut` and `light_cut` being the
    /// part that finds spheres.
    pub stages: Vec<(&'static str, Duration)>,
    /// Pairs of a receiver and a blocker of its cluster.
    pub pairs: usize,
    /// Receivers whose shadow was computed.
    pub shadowed: usize,
}

/// Adds up the time of stages.
#[derive(Default)]
struct Stages(Vec<(&'static str, Duration)>);

impl Stages {
    fn time<T>(&mut self, stage: &'static str, work: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let result = work();
        let spent = start.elapsed();
        match self.0.iter_mut().find(|(name, _)| *name == stage) {
            Some((_, sum)) => *sum += spent,
            None => self.0.push((stage, spent)),
        }
        result
    }
}

/// The passes of a picture that look at spheres, with what these are and what is counted.
struct Shadows<'a> {
    forest: Forest,
    cuts: Cuts,
    /// What spheres send on, where they do.
    lights: Option<SphericalLights>,
    light_cuts: LightCuts,
    light: &'a Light,
    settings: Settings,
    pairs: usize,
    shadowed: usize,
}

impl Shadows<'_> {
    fn shade(
        &mut self,
        receivers: &[Receiver],
        clusters: &[Range<usize>],
        radiance: &mut [[f32; 3]],
        stages: &mut Stages,
    ) -> Result<(), Error> {
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
        let Self { forest, cuts, .. } = self;
        stages.time("cut", || {
            cuts.bound(receivers, clusters, 0..clusters.len());
            cuts.find(Path::best(), forest, options);
        });
        self.pairs += cuts.pairs();
        self.shadowed += cuts.receivers();
        let shadow = Shadow {
            clusters,
            cuts,
            light: self.light,
            accumulation,
            baked: None,
        };
        stages.time("shadow", || {
            shadow_clusters(Path::best(), receivers, &shadow, radiance)
        })
    }

    /// Lights the bodies' spheres.
    fn update(&mut self, scene: &Scene, stages: &mut Stages) -> Result<(), Error> {
        let Settings {
            limits,
            accumulation,
            indirect,
            ..
        } = self.settings;
        let update = LightUpdate {
            indirect: indirect.unwrap_or_default(),
            limits,
            accumulation,
        };
        let mut lights = SphericalLights::default();
        let bodies = scene.objects.iter().map(Body::from);
        stages.time("light_update", || {
            lights.update(Path::best(), bodies, &self.forest, self.light, update)
        })?;
        self.lights = Some(lights);
        Ok(())
    }

    /// What spheres send to receivers; nothing where they send nothing on.
    fn gather(
        &mut self,
        receivers: &[Receiver],
        clusters: &[Range<usize>],
        stages: &mut Stages,
    ) -> Result<Vec<[f32; 3]>, Error> {
        let Some(lights) = &self.lights else {
            return Ok(Vec::new());
        };
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
        let (path, cuts) = (Path::best(), &mut self.light_cuts);
        stages.time("light_cut", || {
            cuts.find(path, receivers, clusters, &self.forest, lights, options);
        });
        let mut sent = vec![[0.0; 3]; receivers.len()];
        let gather = LightGather {
            clusters,
            cuts,
            lights,
        };
        stages.time("light_gather", || {
            light_gather(path, receivers, &gather, &mut sent)
        })?;
        Ok(sent)
    }
}

/// Adds what was sent, if anything was.
fn add(radiance: &mut [[f32; 3]], sent: &[[f32; 3]]) {
    for (radiance, sent) in radiance.iter_mut().zip(sent) {
        for (radiance, sent) in radiance.iter_mut().zip(sent) {
            *radiance += sent;
        }
    }
}

/// Renders `scene` by `plan`, `size` = (width, height) in pixels.
///
/// `progress` is called after each band with the finished part of the picture, 0 to 1.
///
/// Passes at half resolution run over the whole picture. The rest is made in horizontal bands, each through all
/// passes, so that memory beyond the pixels stays at a few megabytes. Work is spread over the threads of the current
/// rayon pool; the result does not depend on how many there are.
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

    let mut stages = Stages::default();
    let geometry = stages.time("hierarchy", || Geometry::new(scene))?;
    let light = stages.time("light", || scene.light())?;
    let mut shadows = Shadows {
        forest: stages.time("forest", || {
            match plan.has(PassKind::Shadow) || plan.has(PassKind::LightUpdate) {
                true => scene.forest(),
                false => Forest::default(),
            }
        }),
        cuts: Cuts::default(),
        lights: None,
        light_cuts: LightCuts::default(),
        light: &light,
        settings: scene.settings,
        pairs: 0,
        shadowed: 0,
    };
    if plan.has(PassKind::LightUpdate) {
        shadows.update(scene, &mut stages)?;
    }
    let halves = match plan.has(PassKind::Upsample) {
        true => half(&geometry, &view, &mut shadows, &mut stages)?,
        false => Halves::default(),
    };

    let mut pixels = vec![[0.0; 3]; width as usize * height as usize];
    let mut samples = Gbuffer::default();
    let mut radiance = Vec::new();
    let (mut failed, mut anew) = (Failed::default(), Vec::new());
    let tile_rows = view.samples().tiles().rows;
    let pixel_rows = BAND * Tiles::SIDE / View::OVERSAMPLE;
    let bands = pixels.chunks_mut((pixel_rows * width) as usize);
    for (band, pixels) in bands.enumerate() {
        let first = band as u32 * BAND;
        let rows = first..(first + BAND).min(tile_rows);
        for pass in plan.passes.iter().filter(|p| p.at != Resolution::Halves) {
            match pass.kind {
                // Once a frame, before all bands.
                PassKind::LightUpdate => {}
                PassKind::Gbuffer => {
                    let (rows, grid) = (rows.clone(), view.samples());
                    stages.time("gbuffer", || {
                        gbuffer(&geometry, &view, grid, rows, &mut samples)
                    })?;
                    radiance.resize(samples.receivers.len(), [0.0; 3]);
                }
                PassKind::Irradiance => stages.time("irradiance", || {
                    irradiance(&samples.receivers, &light, &mut radiance)
                })?,
                PassKind::Shadow => {
                    let tiles = Tiles {
                        rows: rows.len() as u32,
                        ..view.samples().tiles()
                    };
                    let clusters = tiles.clusters();
                    shadows.shade(&samples.receivers, &clusters, &mut radiance, &mut stages)?;
                }
                PassKind::LightGather => {
                    let tiles = Tiles {
                        rows: rows.len() as u32,
                        ..view.samples().tiles()
                    };
                    let sent =
                        shadows.gather(&samples.receivers, &tiles.clusters(), &mut stages)?;
                    add(&mut radiance, &sent);
                }
                PassKind::Upsample => {
                    stages.time("upsample", || {
                        irradiance(&samples.receivers, &light, &mut radiance)?;
                        let rows = rows.clone();
                        upsample(&view, &halves, rows, &samples, &mut radiance, &mut failed)
                    })?;
                    anew.resize(failed.receivers.len(), [0.0; 3]);
                    let Failed {
                        receivers,
                        clusters,
                        ..
                    } = &failed;
                    shadows.shade(receivers, clusters, &mut anew, &mut stages)?;
                    let sent = shadows.gather(receivers, clusters, &mut stages)?;
                    add(&mut anew, &sent);
                    for (&index, light) in failed.indices.iter().zip(&anew) {
                        radiance[index as usize] = *light;
                    }
                }
                PassKind::Resolve => stages.time("resolve", || {
                    let environment = &scene.environment;
                    resolve(
                        &view,
                        rows.clone(),
                        &samples,
                        &radiance,
                        environment,
                        pixels,
                    )
                })?,
            }
        }
        progress(rows.end as f32 / tile_rows as f32);
    }
    Ok(Frame {
        width,
        height,
        pixels,
        stages: stages.0,
        pairs: shadows.pairs,
        shadowed: shadows.shadowed,
    })
}

/// What is computed at half resolution.
fn half(
    geometry: &Geometry,
    view: &View,
    shadows: &mut Shadows,
    stages: &mut Stages,
) -> Result<Halves, Error> {
    let grid = view.halves();
    let tiles = grid.tiles();
    let mut seen = Gbuffer::default();
    stages.time("gbuffer", || {
        gbuffer(geometry, view, grid, 0..tiles.rows, &mut seen)
    })?;
    let receivers = seen.receivers;
    let mut shadowed = vec![[0.0; 3]; receivers.len()];
    shadows.shade(&receivers, &tiles.clusters(), &mut shadowed, stages)?;
    let sent = shadows.gather(&receivers, &tiles.clusters(), stages)?;
    stages.time("upsample", || {
        let mut open = vec![[0.0; 3]; receivers.len()];
        irradiance(&receivers, shadows.light, &mut open)?;
        let halves = Halves::new(receivers, &shadowed, &open)?;
        match sent.is_empty() {
            true => Ok(halves),
            false => halves.with_sent(sent),
        }
    })
}

/// Whether a plan makes a picture: samples, then light on them, then pixels.
fn check_plan(plan: &Plan) -> Result<(), Error> {
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
