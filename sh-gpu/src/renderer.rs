//! A whole frame: the passes of a plan, band by band, recorded into the caller's encoder.

use crate::{
    Bands, Bodies, Bound, Error, GbufferPass, IrradiancePass, ResolvePass, ShadowOptions,
    ShadowPass,
};
use sh_scene::{Light, PassKind, Plan, Receiver, Scene, View};
use wgpu::{
    Buffer, BufferBinding, BufferSize, BufferUsages, CommandEncoder, ComputePassTimestampWrites,
    Device, QuerySet, Queue,
};

/// One pass of the plan, with what it binds for every band.
#[derive(Debug)]
#[expect(
    clippy::large_enum_variant,
    reason = "a handful of these exist, in one vector"
)]
enum Stage {
    Gbuffer {
        pass: GbufferPass,
        bodies: Bodies,
        bound: Vec<Bound>,
    },
    Irradiance {
        pass: IrradiancePass,
        bound: Vec<Bound>,
    },
    Shadow {
        pass: ShadowPass,
        bound: Vec<Bound>,
    },
    Resolve {
        pass: ResolvePass,
        bound: Vec<Bound>,
    },
}

impl Stage {
    fn kind(&self) -> PassKind {
        match self {
            Self::Gbuffer { .. } => PassKind::Gbuffer,
            Self::Irradiance { .. } => PassKind::Irradiance,
            Self::Shadow { .. } => PassKind::Shadow,
            Self::Resolve { .. } => PassKind::Resolve,
        }
    }
}

/// Renders a scene into a buffer of pixels.
///
/// [`new`](Self::new) makes everything; a frame is [`prepare`](Self::prepare) and [`record`](Self::record),
/// which create nothing on the device. Submitting, waiting and reading back are the host's.
///
/// The picture is worked off in horizontal bands ([`Bands`]): G-buffer, receivers and radiance exist for
/// one band at a time, and the bands follow each other in the encoder.
#[derive(Debug)]
pub struct Renderer {
    bands: Bands,
    stages: Vec<Stage>,
    picture: Buffer,
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
        let bands = Bands::new(device, view.width, view.height, max_samples)?;
        let order = scene.settings.order;
        let buffers = Buffers::new(device, &bands);
        let each = |bind: &dyn Fn(u32) -> Result<Bound, Error>| -> Result<Vec<Bound>, Error> {
            (0..bands.count()).map(bind).collect()
        };
        let mut stages = Vec::with_capacity(plan.passes.len());
        for planned in &plan.passes {
            stages.push(match planned.kind {
                PassKind::Gbuffer => {
                    let pass = GbufferPass::new(device, &bands)?;
                    let bound = each(&|band| {
                        let [receivers, albedo, _] = buffers.of(&bands, band);
                        pass.bind(device, receivers, albedo)
                    })?;
                    Stage::Gbuffer {
                        bodies: Bodies::new(device, queue, scene)?,
                        pass,
                        bound,
                    }
                }
                PassKind::Irradiance => {
                    let pass = IrradiancePass::new(device, order)?;
                    let bound = each(&|band| {
                        let [receivers, _, radiance] = buffers.of(&bands, band);
                        pass.bind(device, receivers, radiance)
                    })?;
                    Stage::Irradiance { pass, bound }
                }
                PassKind::Shadow => {
                    let blockers: usize = scene.objects.iter().map(|o| o.spheres.len()).sum();
                    let max_blockers = u32::try_from(blockers).unwrap_or(u32::MAX);
                    let pass = ShadowPass::new(
                        device,
                        ShadowOptions {
                            order,
                            accumulation: scene.settings.accumulation,
                            max_blockers,
                        },
                    )?;
                    let bound = each(&|band| {
                        let [receivers, _, radiance] = buffers.of(&bands, band);
                        pass.bind(device, receivers, radiance)
                    })?;
                    Stage::Shadow { pass, bound }
                }
                PassKind::Resolve => {
                    let pass = ResolvePass::new(device, queue, &bands, &scene.environment)?;
                    let bound = each(&|band| {
                        let [receivers, albedo, radiance] = buffers.of(&bands, band);
                        let picture = buffers.picture_of(&bands, band);
                        pass.bind(device, receivers, albedo, radiance, picture)
                    })?;
                    Stage::Resolve { pass, bound }
                }
            });
        }
        Ok(Self {
            bands,
            stages,
            picture: buffers.picture,
        })
    }

    /// Uploads what may change from frame to frame: the camera, where the objects and with them their
    /// blockers stand, their albedo, the light. Meshes, textures, the environment map, the number of
    /// spheres and the picture's size stay those given to [`new`](Self::new).
    pub fn prepare(
        &self,
        queue: &Queue,
        scene: &Scene,
        light: &Light,
        view: &View,
    ) -> Result<(), Error> {
        self.bands.prepare(queue, view, scene.ground)?;
        for stage in &self.stages {
            match stage {
                Stage::Gbuffer { bodies, .. } => bodies.prepare(queue, scene)?,
                Stage::Irradiance { pass, .. } => pass.prepare(queue, light)?,
                Stage::Shadow { pass, .. } => pass.prepare(queue, &scene.world_spheres(), light)?,
                Stage::Resolve { .. } => {}
            }
        }
        Ok(())
    }

    /// Records the frame. With a query set of type `Timestamp` and [`timestamps`](Self::timestamps) entries
    /// or more, every pass of every band writes when it began and ended.
    pub fn record(&self, encoder: &mut CommandEncoder, queries: Option<&QuerySet>) {
        encoder.push_debug_group("gaunt frame");
        for band in 0..self.bands.count() {
            for (index, stage) in self.stages.iter().enumerate() {
                let first = 2 * (band * self.stages.len() as u32 + index as u32);
                let stamps = queries.map(|set| (set, [first, first + 1]));
                self.record_stage(encoder, stage, band, stamps);
            }
        }
        encoder.pop_debug_group();
    }

    fn record_stage(
        &self,
        encoder: &mut CommandEncoder,
        stage: &Stage,
        band: u32,
        stamps: Option<(&QuerySet, [u32; 2])>,
    ) {
        let writes = stamps.map(|(query_set, [begin, end])| ComputePassTimestampWrites {
            query_set,
            beginning_of_pass_write_index: Some(begin),
            end_of_pass_write_index: Some(end),
        });
        let at = band as usize;
        match stage {
            Stage::Gbuffer {
                pass,
                bodies,
                bound,
            } => {
                pass.record(encoder, &self.bands, band, bodies, &bound[at], stamps);
            }
            Stage::Irradiance { pass, bound } => pass.record(encoder, &bound[at], writes),
            Stage::Shadow { pass, bound } => pass.record(encoder, &bound[at], writes),
            Stage::Resolve { pass, bound } => {
                pass.record(encoder, &self.bands, band, &bound[at], writes);
            }
        }
    }

    /// The picture, row by row from the top: a `vec4f` a pixel, linear Rec.709 red, green, blue and the
    /// share of the pixel's samples that hit something. Usages `STORAGE` and `COPY_SRC`.
    pub fn picture(&self) -> &Buffer {
        &self.picture
    }

    /// How many timestamps a frame writes.
    pub fn timestamps(&self) -> u32 {
        2 * self.bands.count() * self.stages.len() as u32
    }

    /// The time each pass of the plan took, over all bands, in nanoseconds, from a frame's timestamps and
    /// `Queue::get_timestamp_period`.
    pub fn times(&self, timestamps: &[u64], period: f32) -> Vec<(PassKind, f64)> {
        let stages = self.stages.len();
        let mut times: Vec<_> = self
            .stages
            .iter()
            .map(|stage| (stage.kind(), 0.0))
            .collect();
        for (index, [begin, end]) in timestamps.as_chunks().0.iter().enumerate() {
            times[index % stages].1 += end.saturating_sub(*begin) as f64 * f64::from(period);
        }
        times
    }
}

/// What the passes of a frame hand each other: one band's samples, and the picture.
struct Buffers {
    samples: [(Buffer, u64); 3],
    picture: Buffer,
}

impl Buffers {
    fn new(device: &Device, bands: &Bands) -> Self {
        let buffer = |name: &str, size: u64, usage: BufferUsages| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(&format!("gaunt {name}")),
                size,
                usage: usage | BufferUsages::STORAGE,
                mapped_at_creation: false,
            })
        };
        let strides = [
            ("receivers", size_of::<Receiver>() as u64),
            ("albedo", 16),
            ("radiance", 16),
        ];
        let samples = strides.map(|(name, stride)| {
            (
                buffer(name, bands.samples(0) * stride, BufferUsages::empty()),
                stride,
            )
        });
        let pixels = (0..bands.count())
            .map(|band| bands.picture_range(band).1)
            .sum();
        Self {
            samples,
            picture: buffer("picture", pixels, BufferUsages::COPY_SRC),
        }
    }

    /// Receivers, albedo and radiance, as large as a band.
    fn of(&self, bands: &Bands, band: u32) -> [BufferBinding<'_>; 3] {
        self.samples
            .each_ref()
            .map(|(buffer, stride)| BufferBinding {
                buffer,
                offset: 0,
                size: BufferSize::new(bands.samples(band) * stride),
            })
    }

    /// A band's part of the picture.
    fn picture_of(&self, bands: &Bands, band: u32) -> BufferBinding<'_> {
        let (offset, size) = bands.picture_range(band);
        BufferBinding {
            buffer: &self.picture,
            offset,
            size: BufferSize::new(size),
        }
    }
}
