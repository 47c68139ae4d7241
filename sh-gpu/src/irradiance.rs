//! The irradiance pass: light without blockers, for every receiver (Ren et al. 2006, equation 9).

use crate::lighting::Lit;
use crate::pipeline::Kernel;
use crate::scope::checked;
use crate::slot::Slot;
use crate::{Bound, Error, Pipelines};
use sh_kernels::Pass;
use sh_scene::{Light, Limits, Receiver};
use std::sync::Arc;
use wgpu::{BindGroup, BufferBinding, CommandEncoder, ComputePassTimestampWrites, Device, Queue};

/// Light without blockers, on the host's device, queue and encoder. Used as [`ShadowPass`](crate::ShadowPass) is.
///
/// ```no_run
/// # use sh_gpu::{Error, IrradiancePass};
/// # fn frame(device: &wgpu::Device, queue: &wgpu::Queue, encoder: &mut wgpu::CommandEncoder,
/// #     light: &sh_scene::Light, receivers: &wgpu::Buffer, radiance: &wgpu::Buffer) -> Result<(), Error> {
/// let pass = IrradiancePass::new(device, light.order, light.emitters.len() as u32)?;
/// let bound = pass.bind(device, receivers.as_entire_buffer_binding(), radiance.as_entire_buffer_binding())?;
/// // every frame
/// pass.prepare(queue, light)?;
/// pass.record(encoder, &bound, None);
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct IrradiancePass {
    kernel: Arc<Kernel>,
    lit: Lit,
    group: BindGroup,
}

impl IrradiancePass {
    /// Makes the pipeline for an SH order, 2 to 6, and sets room aside for analytic lights, 640 bytes each.
    pub fn new(device: &Device, order: usize, max_emitters: u32) -> Result<Self, Error> {
        Self::with(&Pipelines::new(device), order, max_emitters, true)
    }

    /// As [`new`](Self::new), with a pipeline that is shared; `distributions` says whether some of the lights may have
    /// one.
    pub fn with(
        pipelines: &Pipelines,
        order: usize,
        max_emitters: u32,
        distributions: bool,
    ) -> Result<Self, Error> {
        Self::of(pipelines, order, (max_emitters, distributions), false)
    }

    /// For receivers that reflect diffusely, or for what they mirror.
    pub(crate) fn of(
        pipelines: &Pipelines,
        order: usize,
        (max_emitters, distributions): (u32, bool),
        gloss: bool,
    ) -> Result<Self, Error> {
        let device = pipelines.device();
        checked(device, || {
            let lit = Lit::new(device, order, max_emitters, distributions)?;
            let of = (Pass::Irradiance, order, order);
            let [lamps, uneven] = lit.lamps();
            let constants = [lamps, uneven, ("GLOSS", gloss)];
            let kernel = pipelines.specialised(of, "irradiance", &constants)?;
            let [record, emitters] = lit.bindings();
            let group = kernel.own(device, &[record, emitters, lit.eye()]);
            Ok(Self { kernel, lit, group })
        })
    }

    /// Binds receivers ([`Receiver`], 32 bytes each, read) and radiance (red, green, blue, 0 as
    /// `vec4f`, 16 bytes each, written). The size of `receivers` says how many there are; `radiance` must
    /// hold as many. Both need `BufferUsages::STORAGE`.
    pub fn bind(
        &self,
        device: &Device,
        receivers: BufferBinding<'_>,
        radiance: BufferBinding<'_>,
    ) -> Result<Bound, Error> {
        let receivers = Slot::counting("receivers", size_of::<Receiver>() as u64, receivers);
        let slots = [receivers, Slot::with("radiance", 16, 1, radiance)];
        self.kernel.bind_parts(&slots, |slots, _| {
            checked(device, || self.kernel.bind(device, slots))
        })
    }

    /// Bytes of GPU memory that the pass owns.
    pub fn bytes(&self) -> u64 {
        self.lit.bytes()
    }

    /// Bytes of light that have been uploaded since the pass was made.
    pub(crate) fn uploaded(&self) -> u64 {
        self.lit.uploaded()
    }

    /// Uploads the light for what is submitted next.
    pub fn prepare(&self, queue: &Queue, light: &Light) -> Result<(), Error> {
        self.lit.prepare(queue, light, 0, Limits::LEAVES)
    }

    /// Uploads from where what is mirrored is seen.
    pub(crate) fn look_from(&self, queue: &Queue, eye: [f32; 3]) {
        self.lit.look_from(queue, eye);
    }

    /// Records one compute pass that writes the radiance each receiver would reflect with albedo 1, never
    /// negative; receivers that are not covered get 0.
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
