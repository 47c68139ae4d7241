//! Frames: the steps of a plan, one after the other.

use super::twins::twin;
use super::work::{Ledger, Stages, Work};
use crate::device::check::{check_environment, check_view};
use crate::device::cut::Cuts;
use crate::device::geometry::{Geometry, Hierarchy};
use crate::device::light_cuts::LightCuts;
use crate::device::light_views::Views;
use crate::device::patch_cut::PatchCuts;
use crate::device::patch_lights::PatchLights;
use crate::device::spherical_lights::{Points, SphericalLights};
use crate::error::Error;
use crate::lanes::path::Path;
use crate::store::{Camera, Counts, Sets, Spheres, Store};
use sh_scene::passes::{BASIS_UPDATE, LIGHT_UPDATE, LIGHT_VIEW, PUNCTUAL};
use sh_scene::resource::{Given, PICTURE, RADIANCE};
use sh_scene::{
    Buffer, Changes, Domain, Forest, LightViews, Plan, Receiver, Scene, Settings, Step, Tracker,
    View,
};
use std::ops::Range;
use std::sync::Arc;
use std::time::Duration;

/// A rendered picture and where its time went.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// Linear Rec.709 radiance, row by row from the top.
    pub pixels: Vec<[f32; 3]>,
    /// What the plan gives of them besides ([`Plan::giving`]).
    pub given: Given,
    /// Wall time of each stage, in the order they first ran: `hierarchy`, `light` and, where blockers count, `forest`,
    /// then the passes of the plan by name, `cut` and `light_cut` being the part that finds spheres.
    pub stages: Vec<(&'static str, Duration)>,
    /// What each pass of the plan was, in its order.
    pub work: Vec<Work>,
    /// What the passes kept and wrote.
    pub buffers: Vec<Buffer>,
    /// What had changed since the frame before.
    pub changes: Changes,
    /// Pairs of a receiver and a blocker of its cluster. This and the counts below are of points on surfaces as well, in
    /// frames that light them.
    pub pairs: usize,
    /// Receivers whose shadow was computed.
    pub shadowed: usize,
    /// Nodes that were left out of clusters' cuts, because they are too small to matter there.
    pub too_small: usize,
    /// Pairs of a cluster and a lamp that is below the horizon of all its receivers.
    pub lamps_below: usize,
}

/// The light of a caller's receivers.
#[derive(Clone, Debug, Default)]
pub struct Lit {
    /// Radiance that albedo 1 reflects at each receiver, of light that comes directly.
    pub radiance: Vec<[f32; 3]>,
    /// The same of light that bodies send on; empty where none does.
    pub sent: Vec<[f32; 3]>,
    /// Wall time of each stage, as in [`Frame::stages`].
    pub stages: Vec<(&'static str, Duration)>,
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
    /// The surface points that they were found with.
    points: Points,
    patch_cuts: PatchCuts,
    point_cuts: PatchCuts,
    patch_lights: PatchLights,
    /// The points of patches that these were found with.
    patches: Points,
    views: Views,
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

    /// Lights a caller's receivers, by a plan of [`Plan::of_receivers`]: vertices, or whatever else is to be lit. Each of
    /// `clusters` holds receivers that lie together and side by side; together they are all of them. What is kept from
    /// frame to frame is as in [`render`](Self::render).
    ///
    /// # Errors
    /// Where the scene, the plan or the clusters are none that receivers can be lit with.
    pub fn light(
        &mut self,
        scene: &Scene,
        plan: &Plan,
        receivers: &[Receiver],
        clusters: &[Range<usize>],
    ) -> Result<Lit, Error> {
        plan.check_for(RADIANCE)?;
        let sets = Sets {
            brought: receivers,
            brought_clusters: clusters,
            ..Sets::default()
        };
        let lit = self.steps(scene, plan, None, sets, &|_| {});
        if lit.is_err() {
            *self = Self::default();
        }
        let (done, (_, sets)) = lit?;
        Ok(Lit {
            radiance: sets.radiance,
            sent: sets.brought_sent,
            stages: done.stages.0,
        })
    }

    /// The tree of blockers of the last frame, and what its spheres sent on: nothing where they did not.
    pub fn spheres(&self) -> (&Forest, &SphericalLights) {
        (self.tracker.forest(), &self.lights)
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
        plan.check_for(PICTURE)?;
        check_view(&view)?;
        check_environment(&scene.environment)?;
        let (done, (camera, _)) = self.steps(scene, plan, Some(view), Sets::default(), progress)?;
        let (work, buffers) = done.ledger.finish();
        let Counts {
            pairs,
            shadowed,
            too_small,
            lamps_below,
        } = done.counts;
        let (pixels, given) = camera
            .map(|camera| (camera.pixels, camera.given))
            .unwrap_or_default();
        Ok(Frame {
            width,
            height,
            pixels,
            given,
            stages: done.stages.0,
            work,
            buffers,
            changes: self.tracker.changes().clone(),
            pairs,
            shadowed,
            too_small,
            lamps_below,
        })
    }

    /// Makes what is given before the first pass, and works off the steps of a plan.
    fn steps<'a>(
        &mut self,
        scene: &'a Scene,
        plan: &Plan,
        view: Option<View>,
        sets: Sets<'a>,
        progress: &(dyn Fn(f32) + Sync),
    ) -> Result<(Done, (Option<Camera>, Sets<'a>)), Error> {
        let mut stages = Stages::default();
        let mut ledger = Ledger::new(plan);
        let before = self.hierarchy.clone();
        let geometry = match view.is_some() || plan.has(&LIGHT_VIEW) {
            true => Some(stages.time("hierarchy", || Geometry::reusing(scene, before.as_ref()))?),
            false => None,
        };
        if let Some(geometry) = &geometry {
            self.hierarchy = Some(Arc::clone(geometry.hierarchy()));
        }
        let camera = view.map(|view| {
            let pixels = view.width as usize * view.height as usize;
            Camera {
                view,
                pixels: vec![[0.0; 3]; pixels],
                given: plan
                    .besides()
                    .map(|given| (given, vec![[0; 4]; pixels]))
                    .collect(),
            }
        });
        let seen = match plan.has(&PUNCTUAL) {
            true => LightViews::of(scene)?,
            false => LightViews::default(),
        };
        let still = |(old, new): (&Arc<Hierarchy>, &Arc<Hierarchy>)| Arc::ptr_eq(old, new);
        let still = before
            .as_ref()
            .zip(self.hierarchy.as_ref())
            .is_some_and(still);
        // What lights with sharp shadows see is what it was, and so is what they give.
        let ground = scene.ground.filter(|_| plan.has(&LIGHT_VIEW));
        let unseen = self.views.take(seen, still, ground);
        let light = stages.time("light", || self.tracker.relight(scene).cloned())?;
        if plan.is_blocked() {
            stages.time("forest", || self.tracker.place(scene));
        }
        let sends = plan.has(&LIGHT_UPDATE) || plan.has(&BASIS_UPDATE);
        let surfaces = sends && self.tracker.resurface(scene);
        let same = self.tracker.changes().none() && !surfaces;
        // What spheres send on is what it was.
        let kept = same && self.lit == Some(scene.settings) && unseen;
        let mut store = Store {
            scene,
            spheres: Spheres {
                path: Path::best(),
                forest: self.tracker.forest(),
                light: &light,
                settings: scene.settings,
                cuts: &mut self.cuts,
                lights: &mut self.lights,
                light_cuts: &mut self.light_cuts,
                patch_lights: &mut self.patch_lights,
                patch_cuts: &mut self.patch_cuts,
                point_cuts: &mut self.point_cuts,
                counts: Counts::default(),
            },
            sets: Sets {
                points: std::mem::take(&mut self.points),
                patches: std::mem::take(&mut self.patches),
                ..sets
            },
            geometry,
            views: &mut self.views,
            camera,
        };
        let bands = store.camera.as_ref().map_or(0, Camera::bands);
        for Step { pass, part } in plan.steps(1, bands) {
            let planned = &plan.passes[pass];
            let known = match planned.at {
                Domain::Views => unseen,
                at => kept && at.is_kept(),
            };
            if known {
                continue;
            }
            let run = twin(planned.pass)?.run;
            ledger.pass(pass, |tasks| {
                run(&mut store, planned.at, part.band(), &mut stages).map(|count| *tasks = count)
            })?;
            if planned.at == Domain::Pixels {
                progress((part.band() + 1) as f32 / bands as f32);
            }
        }
        for (pass, planned) in plan.passes.iter().enumerate() {
            for (name, bytes) in (twin(planned.pass)?.memory)(&mut store, planned.at) {
                ledger.holds(pass, name, bytes);
            }
        }
        let (counts, camera, mut sets) = (store.spheres.counts, store.camera, store.sets);
        self.points = std::mem::take(&mut sets.points);
        self.patches = std::mem::take(&mut sets.patches);
        self.lit = sends.then_some(scene.settings);
        let done = Done {
            stages,
            ledger,
            counts,
        };
        Ok((done, (camera, sets)))
    }
}

/// What the steps of a frame were.
struct Done {
    stages: Stages,
    ledger: Ledger,
    counts: Counts,
}
