//! A whole frame: the passes of a plan, band by band, recorded into the caller's encoder.

mod sent;
mod told;

use crate::bases::Bases;
use crate::buffers::Buffers;
use crate::inputs::Inputs;
use crate::makers::stage;
use crate::setup::{Setup, options, sends};
use crate::stages::{Recording, Stage, Work};
use crate::surfaces::Surfaces;
use crate::views::Views;
use crate::{Bands, Bodies, Error, LightGatherPass, Pipelines, ShadowPass, UpsamplePass};
use sent::Sent;
use sh_scene::passes::{BASIS_GATHER, BASIS_UPDATE, LIGHT_VIEW, PUNCTUAL, SHADOW};
use sh_scene::resource::PICTURE;
use sh_scene::{
    BasisBody, Body, Domain, EnvironmentMap, Forest, Light, Plan, Resource, Scene, Step, View,
};
use std::sync::Arc;
use wgpu::{Buffer, CommandEncoder, Device, QuerySet, Queue};

/// Renders a scene into a buffer of pixels.
///
/// [`new`](Self::new) makes everything; a frame is [`prepare`](Self::prepare) and [`record`](Self::record),
/// which create nothing on the device. Submitting, waiting and reading back are the host's; it says
/// [`submitted`](Self::submitted) when it has, so that what has not changed is not computed again.
///
/// The picture is worked off in horizontal bands ([`Bands`]): G-buffer, receivers and radiance exist for
/// one band at a time, and the bands follow each other in the encoder. Passes at half resolution come first, band by
/// band as well; what they make is kept of the whole picture, 12 bytes a pixel, or 16 where spheres send light on.
/// What these send is found before all bands.
///
/// ```no_run
/// # use sh_gpu::{Error, Renderer};
/// # use sh_scene::{Forest, Light, Plan, Scene, View};
/// # fn frame(device: &wgpu::Device, queue: &wgpu::Queue, scene: &Scene, light: &Light, view: &View)
/// #     -> Result<(), Error> {
/// let renderer = Renderer::new(device, queue, scene, &Plan::new(scene), view)?;
/// let blockers = scene.forest();
/// // every frame
/// renderer.prepare(queue, scene, &blockers, light, view)?;
/// let mut encoder = device.create_command_encoder(&Default::default());
/// renderer.record(&mut encoder, None);
/// queue.submit([encoder.finish()]); // `renderer.picture()` has the pixels
/// renderer.submitted();
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct Renderer {
    bands: Bands,
    halves: Option<Bands>,
    bodies: Bodies,
    /// One for all stages that need it, and so are the others.
    inputs: Option<Arc<Inputs>>,
    gather: Option<Arc<LightGatherPass>>,
    upsample: Option<Arc<UpsamplePass>>,
    surfaces: Option<Arc<Surfaces>>,
    bases: Option<Arc<Bases>>,
    views: Option<Arc<Views>>,
    stages: Vec<Stage>,
    /// The plan: what is recorded, in order.
    steps: Vec<Step>,
    plan: Plan,
    /// What the passes hand each other.
    buffers: Buffers,
    picture: Buffer,
    pipelines: Pipelines,
    /// Draws of a band.
    drawn: usize,
    /// Whether what spheres send on is on the device as it is now.
    sent: Sent,
}

impl Renderer {
    /// Uploads the scene's meshes, textures and environment map and makes the passes of `plan`, for
    /// pictures of the size of `view`.
    pub fn new(
        device: &Device,
        queue: &Queue,
        scene: &Scene,
        plan: &Plan,
        view: &View,
    ) -> Result<Self, Error> {
        Self::with_bands(device, queue, scene, plan, view, Bands::MAX_SAMPLES)
    }

    /// As [`new`](Self::new), with the most samples that a band may hold.
    pub fn with_bands(
        device: &Device,
        queue: &Queue,
        scene: &Scene,
        plan: &Plan,
        view: &View,
        max_samples: u32,
    ) -> Result<Self, Error> {
        let pipelines = Pipelines::new(device);
        Self::with_pipelines(&pipelines, queue, scene, plan, view, max_samples)
    }

    /// As [`with_bands`](Self::with_bands), with pipelines that are shared: a renderer that is made anew, for another
    /// size, scene or plan, compiles only what they do not hold yet.
    pub fn with_pipelines(
        pipelines: &Pipelines,
        queue: &Queue,
        scene: &Scene,
        plan: &Plan,
        view: &View,
        max_samples: u32,
    ) -> Result<Self, Error> {
        let device = pipelines.device();
        let bands = |grid| Bands::new(device, view, grid, max_samples);
        plan.check_for(PICTURE)?;
        let halves = match plan.runs_over(Domain::Halves) {
            true => Some(bands(view.halves())?),
            false => None,
        };
        let bands = bands(view.samples())?;
        let options = options(scene);
        let inputs = match plan.is_blocked() {
            true => Some(Arc::new(Inputs::new(pipelines, options)?)),
            false => None,
        };
        let shadow = match &inputs {
            Some(inputs) if plan.has(&SHADOW) => {
                Some(Arc::new(ShadowPass::of(inputs, options, false)?))
            }
            _ => None,
        };
        let sends = sends(plan);
        let gather = match &inputs {
            Some(inputs) if sends => {
                let blocking = scene.settings.indirect.unwrap_or_default().blocking;
                Some(Arc::new(LightGatherPass::of(device, inputs, blocking)?))
            }
            _ => None,
        };
        let upsample = match &inputs {
            Some(inputs) if halves.is_some() => {
                let sent = sends || plan.has(&BASIS_GATHER);
                let pass = UpsamplePass::of(device, queue, &bands, inputs, sent)?;
                Some(Arc::new(pass))
            }
            _ => None,
        };
        let surfaces = match (&inputs, &gather) {
            (Some(inputs), Some(gather)) => {
                let bodies = scene.objects.iter().map(Body::from);
                let surfaces = Surfaces::new(device, queue, inputs, gather, bodies)?;
                Some(Arc::new(surfaces))
            }
            _ => None,
        };
        let points = scene.objects.iter().map(|o| Body::from(o).points() as u64);
        let bases = match &inputs {
            Some(inputs) if plan.has(&BASIS_UPDATE) => {
                let bodies = BasisBody::all(&scene.objects);
                let bounces = scene.settings.indirect.unwrap_or_default().bounces;
                let gloss = plan.runs_over(Domain::Gloss);
                let bases = Bases::new(device, inputs, bodies, (bounces, gloss))?;
                Some(Arc::new(bases))
            }
            _ => None,
        };
        let views = match plan.has(&PUNCTUAL) {
            true => Some(Arc::new(Views::new(
                pipelines,
                scene,
                plan.has(&LIGHT_VIEW),
            )?)),
            false => None,
        };
        let points = [
            points.sum(),
            bases.as_ref().map_or(0, |bases| bases.points()),
        ];
        let buffers = Buffers::new(device, plan, &bands, halves.as_ref(), points)?;
        let setup = Setup {
            device,
            pipelines,
            queue,
            scene,
            bands: &bands,
            halves: halves.as_ref(),
            inputs: inputs.as_ref(),
            shadow: shadow.as_ref(),
            gather: gather.as_ref(),
            upsample: upsample.as_ref(),
            surfaces: surfaces.as_ref(),
            bases: bases.as_ref(),
            views: views.as_ref(),
            buffers: &buffers,
        };
        let stages = plan.passes.iter().map(|planned| stage(&setup, planned));
        let bodies = Bodies::new(device, queue, scene)?;
        Ok(Self {
            stages: stages.collect::<Result<_, _>>()?,
            steps: plan.steps(halves.as_ref().map_or(0, Bands::count), bands.count()),
            plan: plan.clone(),
            pipelines: pipelines.clone(),
            drawn: bodies.drawn() + usize::from(scene.ground.is_some()),
            sent: Sent::default(),
            bodies,
            picture: buffers
                .get(PICTURE, Domain::Pixels)
                .cloned()
                .ok_or(Error::NoResource {
                    resource: PICTURE.name,
                })?,
            buffers,
            bands,
            halves,
            inputs,
            gather,
            upsample,
            surfaces,
            bases,
            views,
        })
    }

    /// Uploads what may change from frame to frame: the camera, where the objects and with them their
    /// blockers stand, their albedo, the light. `blockers` is the scene's tree as [`Forest::update`] left it. Textures,
    /// the number of spheres and lights and the picture's size stay those given to [`new`](Self::new), and so do meshes
    /// and the environment map until [`update_meshes`](Self::update_meshes) and
    /// [`update_environment`](Self::update_environment).
    ///
    /// What is as it was in the frame before is not uploaded again ([`uploaded`](Self::uploaded)), and where nothing that
    /// lights bodies or stands in their light has changed since a frame that was [`submitted`](Self::submitted),
    /// [`record`](Self::record) leaves out what finds the light that they send on.
    pub fn prepare(
        &self,
        queue: &Queue,
        scene: &Scene,
        blockers: &Forest,
        light: &Light,
        view: &View,
    ) -> Result<(), Error> {
        let before = self.seen_uploaded();
        self.bands.prepare(queue, view, scene.ground)?;
        if let Some(halves) = &self.halves {
            halves.prepare(queue, view, scene.ground)?;
        }
        self.bodies.prepare(queue, scene)?;
        if let Some(inputs) = &self.inputs {
            inputs.prepare(queue, blockers, scene.settings.limits, light)?;
        }
        if let Some(gather) = &self.gather {
            let spheres = scene.objects.iter().map(|object| object.spheres.len());
            gather.prepare(queue, blockers, spheres)?;
        }
        if let Some(surfaces) = &self.surfaces {
            surfaces.prepare(queue, scene.objects.iter().map(Body::from), blockers)?;
        }
        if let Some(bases) = &self.bases {
            bases.prepare(queue, BasisBody::all(&scene.objects))?;
        }
        for stage in &self.stages {
            if let Work::Irradiance { pass, .. } = &stage.work {
                pass.prepare(queue, light)?;
            }
        }
        if let Some(views) = &self.views {
            views.prepare(queue, scene)?;
        }
        if self.seen_uploaded() != before {
            self.sent.change();
        }
        // Bodies look the same from wherever.
        let eye = view.camera.eye.to_array();
        if let Some(inputs) = &self.inputs {
            inputs.lit.look_from(queue, eye);
        }
        if let Some(views) = &self.views {
            views.look_from(queue, eye);
        }
        for stage in &self.stages {
            if let Work::Irradiance { pass, .. } = &stage.work {
                pass.look_from(queue, eye);
            }
        }
        Ok(())
    }

    /// Uploads the meshes' vertices and surface points anew, where [`prepare`](Self::prepare) alone does not do: in a
    /// scene that bends.
    pub fn update_meshes(&self, queue: &Queue, scene: &Scene) -> Result<(), Error> {
        self.bodies.update_meshes(queue, scene)?;
        if self.views.is_some() {
            self.sent.change();
        }
        if let Some(surfaces) = &self.surfaces {
            let before = surfaces.uploaded();
            surfaces.update_surfaces(queue, scene.objects.iter().map(Body::from))?;
            if surfaces.uploaded() != before {
                self.sent.change();
            }
        }
        Ok(())
    }

    /// Uploads the environment map anew, of the size it had: where it turns or changes.
    pub fn update_environment(
        &self,
        queue: &Queue,
        environment: &EnvironmentMap,
    ) -> Result<(), Error> {
        for stage in &self.stages {
            if let Work::Resolve { pass, .. } = &stage.work {
                pass.update_environment(queue, environment)?;
            }
        }
        Ok(())
    }

    /// Records the frame, which is to be submitted before the next one is recorded, or dropped. With a query set of type
    /// `Timestamp` and [`timestamps`](Self::timestamps) entries or more, every pass of every band writes when it began and
    /// ended.
    pub fn record(&self, encoder: &mut CommandEncoder, queries: Option<&QuerySet>) {
        encoder.push_debug_group("gaunt frame");
        for (first, step) in (0..).step_by(2).zip(&self.steps) {
            let stamps = queries.map(|set| (set, [first, first + 1]));
            self.record_step(encoder, *step, stamps);
        }
        encoder.pop_debug_group();
    }

    /// To be called after the frame that was recorded last has been handed to the queue, before anything else is recorded:
    /// from then on [`record`](Self::record) leaves out what this frame computes, as long as it stays the same. An encoder may
    /// be dropped instead; whoever never calls this gets the same pictures, and pays every frame for the light that spheres
    /// send on.
    pub fn submitted(&self) {
        self.sent.submit();
    }

    /// How many parts [`record_part`](Self::record_part) has.
    pub fn parts(&self) -> usize {
        self.steps.len()
    }

    /// Records one part of a frame: for a host that times them by itself, because its device has no clock. All of them
    /// in order are what [`record`](Self::record) records. Tells which pass of the plan it is a part of; none where there
    /// is no such part.
    pub fn record_part(&self, encoder: &mut CommandEncoder, part: usize) -> Option<usize> {
        let step = self.steps.get(part)?;
        self.record_step(encoder, *step, None);
        Some(step.pass)
    }

    fn record_step(
        &self,
        encoder: &mut CommandEncoder,
        Step { pass, part }: Step,
        stamps: Option<(&QuerySet, [u32; 2])>,
    ) {
        let stage = &self.stages[pass];
        let bands = match (&self.halves, stage.at) {
            (Some(halves), Domain::Halves) => halves,
            _ => &self.bands,
        };
        let recording = Recording {
            bands,
            band: part.band(),
            bodies: &self.bodies,
            kept: stage.at.is_kept() && !self.sent.record(),
            stamps,
        };
        stage.record(encoder, recording);
    }

    /// The picture, row by row from the top: a `vec4f` a pixel, linear Rec.709 red, green, blue and the
    /// share of the pixel's samples that hit something. Usages `STORAGE` and `COPY_SRC`.
    pub fn picture(&self) -> &Buffer {
        &self.picture
    }

    /// Something else that the plan gives of every pixel ([`Plan::giving`]), as the picture is stored: the elements that
    /// the resource's own documentation states. None where it does not. Usages as those of the picture.
    pub fn given(&self, resource: Resource) -> Option<&Buffer> {
        self.buffers.get(resource, Domain::Pixels)
    }
}
