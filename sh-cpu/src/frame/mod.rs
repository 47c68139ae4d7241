//! A whole picture: the passes of a plan, band by band.

mod bands;
mod check;
mod half;
mod shading;
mod work;

pub use work::Work;

use crate::gbuffer::{Gbuffer, check_view};
use crate::geometry::Hierarchy;
use crate::resolve::check_environment;
use crate::upsample::{Failed, Halves};
use crate::{Body, Cuts, Error, Geometry, LightCuts, LightUpdate, Path, SphericalLights};
use bands::Bands;
use check::check_plan;
use half::half;
use sh_scene::{Buffer, Changes, Forest, PassKind, Plan, Scene, Settings, Tiles, Tracker, View};
use shading::Shadows;
use std::sync::Arc;
use std::time::Duration;
use work::{Ledger, Stages};

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
    /// Wall time of each stage, in the order they first ran: `hierarchy`, `light` and, where blockers count, `forest`,
    /// then the passes of the plan by name, `cut` and `light_cut` being the part that finds spheres.
    pub stages: Vec<(&'static str, Duration)>,
    /// What each pass of the plan was, in its order.
    pub work: Vec<Work>,
    /// What the passes kept and wrote.
    pub buffers: Vec<Buffer>,
    /// What had changed since the frame before.
    pub changes: Changes,
    /// Pairs of a receiver and a blocker of its cluster.
    pub pairs: usize,
    /// Receivers whose shadow was computed.
    pub shadowed: usize,
    /// Nodes that were left out of clusters' cuts, because they are too small to matter there.
    pub too_small: usize,
    /// Pairs of a cluster and a lamp that is below the horizon of all its receivers.
    pub lamps_below: usize,
}

/// Renders one frame after the other, and keeps what has not changed: the hierarchy of triangles, the tree of blockers,
/// the light, and what spheres send on. The scene of the first frame gives the tree its topology.
///
/// ```no_run
/// # use sh_scene::*;
/// # fn frames(scene: &mut Scene, motion: &mut motion::Motion) -> Result<(), sh_cpu::Error> {
/// let plan = Plan::new(scene);
/// let mut frames = sh_cpu::Frames::default();
/// for frame in 0..60 {
///     motion.pose(f64::from(frame) / 30.0, scene);
///     let picture = frames.render(scene, &plan, (1280, 720), &|_| {})?;
///     println!("{} nodes were renewed", picture.changes.nodes);
/// }
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Default)]
pub struct Frames {
    tracker: Tracker,
    hierarchy: Option<Arc<Hierarchy>>,
    cuts: Cuts,
    light_cuts: LightCuts,
    lights: SphericalLights,
    /// The settings that `lights` were found with, if they were.
    lit: Option<Settings>,
}

/// Renders `scene` by `plan`, `size` = (width, height) in pixels: one frame of [`Frames`].
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
    Frames::default().render(scene, plan, size, progress)
}

impl Frames {
    /// The next frame; arguments as in [`render`]. Where it fails, the one after it starts anew.
    ///
    /// # Errors
    /// Where the scene, the plan or the size is none that a picture can be made of.
    pub fn render(
        &mut self,
        scene: &Scene,
        plan: &Plan,
        size: (u32, u32),
        progress: &(dyn Fn(f32) + Sync),
    ) -> Result<Frame, Error> {
        let frame = self.frame(scene, plan, size, progress);
        if frame.is_err() {
            *self = Self::default();
        }
        frame
    }

    /// How many nodes the tree of blockers has.
    pub fn nodes(&self) -> usize {
        self.tracker.forest().nodes().len()
    }

    /// Builds the tree of blockers of a scene without rendering it: where the first frame is not to decide about its
    /// topology, so that a frame is the same whichever came first.
    pub fn start(&mut self, scene: &Scene, plan: &Plan) {
        if plan.is_blocked() {
            self.tracker.place(scene);
        }
    }

    fn frame(
        &mut self,
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
        let mut ledger = Ledger::new(plan);
        let geometry = stages.time("hierarchy", || {
            Geometry::reusing(scene, self.hierarchy.as_ref())
        })?;
        self.hierarchy = Some(Arc::clone(geometry.hierarchy()));
        stages.time("light", || self.tracker.relight(scene))?;
        let blocked = plan.is_blocked();
        if blocked {
            stages.time("forest", || self.tracker.place(scene));
        }
        if let Some(pass) = position(plan, PassKind::LightUpdate) {
            self.update(scene, pass, &mut ledger, &mut stages)?;
        }
        let Self {
            tracker,
            cuts,
            light_cuts,
            lights,
            ..
        } = self;
        let none = Forest::default();
        let Some(light) = tracker.light() else {
            return Err(Error::Plan { missing: "light" });
        };
        let mut shadows = Shadows {
            forest: if blocked { tracker.forest() } else { &none },
            cuts,
            lights: plan.has(PassKind::LightUpdate).then_some(&*lights),
            light_cuts,
            light,
            settings: scene.settings,
            pairs: 0,
            shadowed: 0,
            too_small: 0,
            lamps_below: 0,
        };
        let halves = match plan.has(PassKind::Upsample) {
            true => half(
                &geometry,
                &view,
                plan,
                &mut shadows,
                &mut ledger,
                &mut stages,
            )?,
            false => Halves::default(),
        };

        let mut pixels = vec![[0.0; 3]; width as usize * height as usize];
        let mut bands = Bands {
            view: &view,
            plan,
            geometry: &geometry,
            halves: &halves,
            samples: Gbuffer::default(),
            radiance: Vec::new(),
            failed: Failed::default(),
            anew: Vec::new(),
        };
        let tile_rows = view.samples().tiles().rows;
        let pixel_rows = BAND * Tiles::SIDE / View::OVERSAMPLE;
        let parts = pixels.chunks_mut((pixel_rows * width) as usize);
        for (band, pixels) in parts.enumerate() {
            let first = band as u32 * BAND;
            let rows = first..(first + BAND).min(tile_rows);
            bands.render(rows.clone(), pixels, &mut shadows, &mut ledger, &mut stages)?;
            progress(rows.end as f32 / tile_rows as f32);
        }
        let Shadows {
            pairs,
            shadowed,
            too_small,
            lamps_below,
            ..
        } = shadows;
        bands.hold(&mut ledger);
        let shaded = |pass: &sh_scene::Pass| pass.kind == PassKind::Shadow;
        let shaded = plan.passes.iter().position(shaded);
        if let Some(pass) = shaded {
            let nodes = size_of_val(self.tracker.forest().nodes());
            ledger.holds(pass, "tree of blockers", nodes);
            ledger.holds(pass, "cuts", self.cuts.bytes());
        }
        if let Some(pass) = position(plan, PassKind::Resolve) {
            ledger.holds(pass, "picture", size_of_val(&pixels[..]));
        }
        let (work, buffers) = ledger.finish();
        Ok(Frame {
            width,
            height,
            pixels,
            stages: stages.0,
            work,
            buffers,
            changes: self.tracker.changes().clone(),
            pairs,
            shadowed,
            too_small,
            lamps_below,
        })
    }

    /// Lights the bodies' spheres, unless they are lit as they would be.
    fn update(
        &mut self,
        scene: &Scene,
        pass: usize,
        ledger: &mut Ledger,
        stages: &mut Stages,
    ) -> Result<(), Error> {
        let (tracker, lights) = (&mut self.tracker, &mut self.lights);
        let surfaces = tracker.resurface(scene);
        let same = tracker.changes().none() && !surfaces && self.lit == Some(scene.settings);
        let Some(light) = tracker.light().filter(|_| !same) else {
            ledger.holds(pass, "what spheres send on", lights.bytes());
            return Ok(());
        };
        let Settings {
            limits,
            accumulation,
            indirect,
            ..
        } = scene.settings;
        let update = LightUpdate {
            indirect: indirect.unwrap_or_default(),
            limits,
            accumulation,
        };
        self.lit = None;
        let bodies = scene.objects.iter().map(Body::from);
        let forest = tracker.forest();
        ledger.pass(pass, |tasks| {
            *tasks = u64::from(update.indirect.bounces) * forest.spheres() as u64;
            stages.time("light_update", || {
                lights.update(Path::best(), bodies, forest, light, update)
            })
        })?;
        self.lit = Some(scene.settings);
        ledger.holds(pass, "what spheres send on", lights.bytes());
        Ok(())
    }
}

fn position(plan: &Plan, kind: PassKind) -> Option<usize> {
    plan.passes.iter().position(|pass| pass.kind == kind)
}

fn bytes<T>(all: &[T]) -> usize {
    size_of_val(all)
}
