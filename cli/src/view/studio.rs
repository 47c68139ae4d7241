//! Where pictures are made: the scene, posed and lit as it is wished, by the passes.

use super::layer;
use super::wish::{Ball, Overlay, Shown, Wish};
use crate::Error;
use crate::gpu::Gpu;
use crate::image::{exposure, screen};
use crate::render::gpu::{Painted, Painter};
use crate::render::{self, Changes, Shot};
use crate::report::{Stage, Times, planned};
use egui::{Color32, ColorImage};
use glam::Quat;
use rayon::prelude::*;
use sh_bake::{Choices, Loaded};
use sh_scene::motion::Motion;
use sh_scene::{AreaLight, AreaShape, EnvironmentMap, Plan, Scene, Settings, Tracker, View};
use std::sync::Arc;
use std::time::Instant;

/// How many sets of GPU resources are kept: two sizes of two settings.
const PAINTERS: usize = 4;

/// What GPU resources are made for.
#[derive(Clone, Debug, PartialEq)]
struct Purpose {
    size: [u32; 2],
    plan: Plan,
    settings: Settings,
}

/// GPU resources, and the state of the scene they hold.
struct Easel {
    purpose: Purpose,
    painter: Option<Painter>,
    seconds: f64,
    turn: f64,
}

/// A picture; what each stage took; and what computed.
type Made = (Painted, Vec<Stage>, String);

/// A scene and what renders it.
pub(super) struct Studio {
    /// Where the scene is from, to load it anew with other spheres.
    options: render::Options,
    spheres: f32,
    pub scene: Scene,
    motion: Motion,
    /// The environment as it was loaded, or as its motion has turned it.
    environment: EnvironmentMap,
    /// How far `scene.environment` is turned: by its motion and by hand.
    turned: Option<(Option<f64>, f32)>,
    lights: Vec<AreaLight>,
    surfaces: bool,
    exposure: f32,
    gpu: Option<Gpu>,
    easels: Vec<Easel>,
    /// What the frame before has left, on the GPU and on the CPU.
    tracker: Tracker,
    frames: sh_cpu::Frames,
}

impl Studio {
    pub fn new(options: render::Options, loaded: Loaded, gpu: Option<Gpu>) -> Result<Self, Error> {
        let light = loaded.scene.light()?;
        let mut studio = Self {
            options,
            spheres: 1.0,
            scene: loaded.scene.clone(),
            motion: Motion::default(),
            environment: EnvironmentMap::constant([0.0; 3]),
            turned: None,
            lights: Vec::new(),
            surfaces: false,
            exposure: exposure(&light, &loaded.scene),
            gpu,
            easels: Vec::new(),
            tracker: Tracker::default(),
            frames: sh_cpu::Frames::default(),
        };
        studio.take(loaded);
        Ok(studio)
    }

    fn take(&mut self, loaded: Loaded) {
        let Loaded {
            scene,
            motion,
            report,
        } = loaded;
        self.surfaces = !report.surfaces.is_empty();
        self.environment.clone_from(&scene.environment);
        self.lights.clone_from(&scene.lights);
        (self.scene, self.motion) = (scene, motion);
        self.turned = None;
        self.easels.clear();
        (self.tracker, self.frames) = Default::default();
    }

    /// Loads the scene anew where the wish needs other spheres, or surface samples that are not there yet.
    pub fn load(
        &mut self,
        wish: &Wish,
        tell: &(dyn Fn(sh_bake::Progress) + Sync),
    ) -> Result<(), Error> {
        let surfaces = wish.settings.indirect.is_some();
        if wish.spheres == self.spheres && (self.surfaces || !surfaces) {
            return Ok(());
        }
        let choices = Choices {
            spheres: wish.spheres,
            surfaces: surfaces || self.surfaces,
            ..Choices::default()
        };
        let loaded = render::load_with(&self.options, choices, tell)?;
        self.take(loaded);
        // Even where the scene has no surface to sample.
        self.surfaces |= surfaces;
        self.spheres = wish.spheres;
        Ok(())
    }

    /// Puts the scene into the wished state.
    fn pose(&mut self, wish: &Wish) {
        self.motion.pose(wish.seconds, &mut self.scene);
        let angle = self.motion.environment_angle(wish.seconds);
        if self.turned != Some((angle, wish.turn)) {
            if angle.is_some() {
                self.environment.clone_from(&self.scene.environment);
            }
            let turned = &mut self.scene.environment;
            self.environment.rotated_into(wish.turn, turned);
            self.turned = Some((angle, wish.turn));
        } else if angle.is_some() {
            // Posing has undone the turn by hand.
            let turned = &mut self.scene.environment;
            self.environment.rotated_into(wish.turn, turned);
        }
        let turn = Quat::from_rotation_y(wish.turn);
        for (light, from) in self.scene.lights.iter_mut().zip(&self.lights) {
            if let (
                AreaShape::Distant { direction, .. },
                AreaShape::Distant {
                    direction: from, ..
                },
            ) = (&mut light.shape, &from.shape)
            {
                *direction = turn * *from;
            }
        }
        self.scene.camera = wish.camera;
        self.scene.settings = wish.settings;
    }

    /// Makes the picture.
    pub fn render(&mut self, wish: &Wish) -> Result<Shown, Error> {
        let start = Instant::now();
        self.pose(wish);
        let plan = Plan::giving(&self.scene, wish.overlay.asks());
        let [width, height] = wish.size;
        let (painted, stages, device) = match &self.gpu {
            Some(_) => self.on_gpu(wish, &plan)?,
            None => {
                let frame = self
                    .frames
                    .render(&self.scene, &plan, (width, height), &|_| {})?;
                let stages = frame.stages.iter().map(|(stage, time)| Stage {
                    stage,
                    seconds: time.as_secs_f64(),
                });
                let threads = rayon::current_num_threads();
                let device = format!("the CPU, {threads} threads");
                let painted = Painted {
                    pixels: frame.pixels,
                    given: frame.given,
                };
                (painted, stages.collect(), device)
            }
        };
        let factor = self.exposure * wish.stops.exp2();
        let rows = painted.pixels.par_chunks(width as usize).zip(0..height);
        let shown = rows.flat_map_iter(|(row, y)| {
            row.iter().zip(0..).map(move |(pixel, x)| {
                let [r, g, b] = screen(pixel.map(|c| c * factor), x, y);
                Color32::from_rgb(r, g, b)
            })
        });
        let image = ColorImage::new([width as usize, height as usize], shown.collect());
        let seconds = start.elapsed().as_secs_f64();
        Ok(Shown {
            wish: *wish,
            image: Arc::new(image),
            plan: planned(&plan),
            stages,
            seconds,
            device,
            balls: match wish.overlay {
                Overlay::Spheres => self.balls(),
                _ => Vec::new(),
            },
            spheres: self.scene.objects.iter().map(|o| o.spheres.len()).sum(),
            layer: layer::of(&self.scene, &plan, wish, &painted.given)?,
        })
    }

    fn on_gpu(&mut self, wish: &Wish, plan: &Plan) -> Result<Made, Error> {
        let Some(gpu) = &self.gpu else {
            return Err(Error::Gpu("no GPU driver was found".into()));
        };
        let [width, height] = wish.size;
        let purpose = Purpose {
            size: wish.size,
            plan: plan.clone(),
            settings: wish.settings,
        };
        let turn =
            f64::from(wish.turn) + self.motion.environment_angle(wish.seconds).unwrap_or(0.0);
        let mut easel = match self
            .easels
            .iter()
            .position(|easel| easel.purpose == purpose)
        {
            Some(at) => self.easels.remove(at),
            None => Easel {
                purpose,
                painter: None,
                seconds: f64::NAN,
                turn: f64::NAN,
            },
        };
        let view = View {
            camera: wish.camera,
            width,
            height,
        };
        let changes = Changes {
            meshes: self.motion.bends() && easel.seconds != wish.seconds,
            environment: easel.turn != turn,
        };
        let shot = Shot {
            plan,
            view: &view,
            changes,
        };
        let mut times = Times::default();
        self.tracker.relight(&self.scene)?;
        let scene = (&self.scene, &mut self.tracker);
        let painted = render::gpu::picture(gpu, &mut easel.painter, scene, &shot, &mut times)?;
        (easel.seconds, easel.turn) = (wish.seconds, turn);
        // The latest last; the one that was not used for longest goes.
        self.easels.push(easel);
        if self.easels.len() > PAINTERS {
            self.easels.remove(0);
        }
        Ok((painted, times.0, gpu.name.clone()))
    }

    fn balls(&self) -> Vec<Ball> {
        let counts = self.scene.objects.iter().enumerate();
        let objects = counts.flat_map(|(i, o)| std::iter::repeat_n(i, o.spheres.len()));
        let spheres = self.scene.world_spheres();
        let balls = spheres.into_iter().zip(objects);
        balls
            .map(|(sphere, object)| Ball { sphere, object })
            .collect()
    }
}
