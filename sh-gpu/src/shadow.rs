//! The shadow pass: light through the visibility of all blocker spheres, for every receiver (Ren et al. 2006,
//! sections 6 to 8).

use crate::clusters::{bind_clusters, bind_tiles};
use crate::inputs::Inputs;
use crate::pipeline::Kernel;
use crate::scope::checked;
use crate::slot::Slot;
use crate::{Bound, ClusterBinding, Error, Pipelines};
use sh_kernels::Pass;
use sh_scene::{Forest, Light, Limits, Sphere};
use std::sync::Arc;
use wgpu::{
    BindGroup, Buffer, BufferBinding, CommandEncoder, ComputePassTimestampWrites, Device, Queue,
};

/// How a [`ShadowPass`] is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShadowOptions {
    /// SH order of the light, 2 to 6. The cost of a receiver grows with its fourth power.
    pub order: usize,
    /// SH order in which the blockers' logarithms are summed and exponentiated, from `order` to 6. Above `order`
    /// the shadows are truer; the cost of a blocker grows with its square.
    pub accumulation: usize,
    /// The most blocker spheres [`ShadowPass::prepare`] will take; 64 bytes each are set aside, for two nodes of a
    /// tree.
    pub max_blockers: u32,
    /// The most analytic lights; 640 bytes each are set aside.
    pub max_emitters: u32,
    /// Whether some of them may have a distribution.
    pub distributions: bool,
    /// What it writes.
    pub output: Output,
}

impl Default for ShadowOptions {
    fn default() -> Self {
        Self {
            order: 4,
            accumulation: 4,
            max_blockers: 4096,
            max_emitters: 16,
            distributions: true,
            output: Output::Radiance,
        }
    }
}

/// What a [`ShadowPass`] writes for every receiver.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Output {
    /// The radiance that albedo 1 would reflect: a `vec4f` (red, green, blue, 0), 16 bytes. Every channel lies within 0
    /// and its unshadowed value.
    #[default]
    Radiance,
    /// The light itself, g·L in the papers: the product of visibility and all light, before it meets a surface. n²
    /// `vec4f` (red, green, blue, 0) at order n, 16 n² bytes: coefficient i of receiver r is element r·n² + i. For
    /// BRDFs and normal maps of the host's: dot it with the SH vector of BRDF times cosine, in world space. The host
    /// bounds what comes out of that; with the cosine lobe of the receiver's own normal it is
    /// [`Radiance`](Self::Radiance) before bounding.
    Light,
}

impl Output {
    /// Elements of 16 bytes a receiver at an SH order.
    ///
    /// ```
    /// assert_eq!(sh_gpu::Output::Radiance.elements(4), 1);
    /// assert_eq!(sh_gpu::Output::Light.elements(4), 16);
    /// ```
    pub fn elements(self, order: usize) -> u64 {
        match self {
            Self::Radiance => 1,
            Self::Light => (order * order) as u64,
        }
    }

    fn kernels(self) -> Pass {
        match self {
            Self::Radiance => Pass::Shadow,
            Self::Light => Pass::ShadowedLight,
        }
    }
}

/// Light through the visibility of all blocker spheres, on the host's device, queue and encoder.
///
/// Pipeline and bind groups are made by [`new`](Self::new) and [`bind`](Self::bind); a frame is
/// [`prepare`](Self::prepare) and [`record`](Self::record), which create nothing.
///
/// ```no_run
/// # use sh_gpu::{Error, ShadowOptions, ShadowPass};
/// # use sh_scene::{Forest, Light, Limits};
/// # fn frame(device: &wgpu::Device, queue: &wgpu::Queue, receivers: &wgpu::Buffer, radiance: &wgpu::Buffer,
/// #     spheres: &[sh_scene::Sphere], forest: &mut Forest, light: &Light) -> Result<(), Error> {
/// let options = ShadowOptions { max_blockers: 1000, ..ShadowOptions::default() };
/// let shadow = ShadowPass::new(device, options)?;
/// let bound = shadow.bind(device, receivers.as_entire_buffer_binding(), radiance.as_entire_buffer_binding())?;
/// // every frame
/// forest.update(spheres);
/// shadow.prepare(queue, forest, Limits::default(), light)?;
/// let mut encoder = device.create_command_encoder(&Default::default());
/// shadow.record(&mut encoder, &bound, None);
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct ShadowPass {
    kernel: Arc<Kernel>,
    pub(crate) inputs: Arc<Inputs>,
    group: BindGroup,
    options: ShadowOptions,
}

impl ShadowPass {
    /// Makes the pipeline and sets room aside for blockers and light.
    pub fn new(device: &Device, options: ShadowOptions) -> Result<Self, Error> {
        Self::with(&Pipelines::new(device), options)
    }

    /// As [`new`](Self::new), with a pipeline that is shared.
    pub fn with(pipelines: &Pipelines, options: ShadowOptions) -> Result<Self, Error> {
        Self::of(&Arc::new(Inputs::new(pipelines, options)?), options, false)
    }

    /// With light and blockers that other passes read as well; `gloss`: for what receivers mirror.
    pub(crate) fn of(
        inputs: &Arc<Inputs>,
        options: ShadowOptions,
        gloss: bool,
    ) -> Result<Self, Error> {
        let device = inputs.pipelines.device();
        let (pass, lit) = (options.output.kernels(), &inputs.lit);
        checked(device, || {
            let of = (pass, options.order, options.accumulation);
            let [lamps, distributions] = lit.lamps();
            let constants = [lamps, distributions, ("GLOSS", gloss)];
            let kernel = inputs.pipelines.specialised(of, pass.name(), &constants)?;
            let [record, emitters] = lit.bindings();
            let own = [record, emitters, inputs.tree(), lit.eye()];
            let known = match options.output {
                Output::Radiance => &own[..],
                Output::Light => &own[..3],
            };
            let group = kernel.own(device, known);
            Ok(Self {
                kernel,
                inputs: Arc::clone(inputs),
                group,
                options,
            })
        })
    }

    /// Bytes of GPU memory of light and blockers.
    pub fn bytes(&self) -> u64 {
        self.inputs.bytes()
    }

    /// Binds receivers ([`sh_scene::Receiver`], 32 bytes each, read) and radiance (red, green, blue, 0 as
    /// `vec4f`, 16 bytes each, written). The size of `receivers` says how many there are; `radiance` must
    /// hold as many, or n² times as many with [`Output::Light`]. Both need `BufferUsages::STORAGE`. Those that exceed
    /// the device's `max_storage_buffer_binding_size` are bound in parts.
    ///
    /// Every [`sh_scene::Tiles::AREA`] receivers one after another are a cluster: the tiles of a picture, or what the host
    /// put side by side.
    pub fn bind(
        &self,
        device: &Device,
        receivers: BufferBinding<'_>,
        radiance: BufferBinding<'_>,
    ) -> Result<Bound, Error> {
        bind_tiles(&self.kernel, device, receivers, self.written(radiance))
    }

    /// As [`bind`](Self::bind), with clusters of the host's.
    pub fn bind_clusters(
        &self,
        device: &Device,
        receivers: BufferBinding<'_>,
        clusters: ClusterBinding<'_>,
        radiance: BufferBinding<'_>,
    ) -> Result<Bound, Error> {
        let written = self.written(radiance);
        bind_clusters(&self.kernel, device, receivers, clusters, written)
    }

    fn written<'a>(&self, binding: BufferBinding<'a>) -> Slot<'a> {
        let ShadowOptions { order, output, .. } = self.options;
        let name = match output {
            Output::Radiance => "radiance",
            Output::Light => "light",
        };
        Slot::with(name, 16, output.elements(order), binding)
    }

    /// Uploads the blockers and the light for what is submitted next.
    ///
    /// # Errors
    /// Where they are more than there is room for, or the light is of another order.
    pub fn prepare(
        &self,
        queue: &Queue,
        blockers: &Forest,
        limits: Limits,
        light: &Light,
    ) -> Result<(), Error> {
        self.inputs.prepare(queue, blockers, limits, light)
    }

    /// As [`prepare`](Self::prepare), without a hierarchy: every sphere counts for every receiver.
    ///
    /// # Errors
    /// As `prepare`.
    pub fn prepare_spheres(
        &self,
        queue: &Queue,
        blockers: &[Sphere],
        light: &Light,
    ) -> Result<(), Error> {
        self.inputs.prepare_spheres(queue, blockers, light)
    }

    /// As [`prepare`](Self::prepare), where the host has written so many nodes to [`nodes`](Self::nodes) itself.
    ///
    /// # Errors
    /// As `prepare`.
    pub fn prepare_light(
        &self,
        queue: &Queue,
        nodes: u32,
        limits: Limits,
        light: &Light,
    ) -> Result<(), Error> {
        self.inputs.prepare_light(queue, nodes, limits, light)
    }

    /// The tree of blockers: [`sh_scene::Node`] records. Usages `STORAGE` and `COPY_DST`.
    pub fn nodes(&self) -> &Buffer {
        &self.inputs.nodes
    }

    /// Records one compute pass that writes the radiance each receiver of a cluster would reflect with albedo 1. Every
    /// channel lies within 0 and its unshadowed value; receivers that are not covered get 0.
    pub fn record(
        &self,
        encoder: &mut CommandEncoder,
        bound: &Bound,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) {
        self.kernel
            .record(encoder, (&self.group, &[]), bound, timestamps);
    }
}
