//! The irradiance pass: light without blockers, for every receiver (Ren et al. 2006, equation 9).

use crate::lighting::Lit;
use crate::pipeline::{Kernel, Slot, buffer_entry, shader};
use crate::{Bound, Error};
use sh_kernels::Pass;
use sh_scene::{Light, Limits, Receiver};
use wgpu::{
    BindGroup, BufferBinding, BufferBindingType, CommandEncoder, ComputePassTimestampWrites,
    Device, Queue, ShaderStages,
};

/// Light without blockers, on the host's device, queue and encoder. Used as [`ShadowPass`](crate::ShadowPass) is.
#[derive(Debug)]
pub struct IrradiancePass {
    kernel: Kernel,
    lit: Lit,
    group: BindGroup,
}

impl IrradiancePass {
    /// Makes the pipeline for an SH order, 2 to 6, and sets room aside for analytic lights, 64 bytes each.
    pub fn new(device: &Device, order: usize, max_emitters: u32) -> Result<Self, Error> {
        let module = shader(device, Pass::Irradiance, order)?;
        let lit = Lit::new(device, order, max_emitters)?;
        let storage = |binding, read_only| {
            let ty = BufferBindingType::Storage { read_only };
            buffer_entry(binding, ShaderStages::COMPUTE, ty, false)
        };
        let groups = [&Lit::layout(0)[..], &[storage(0, true), storage(1, false)]];
        let kernel = Kernel::new(device, &module, "irradiance", groups);
        let group = kernel.own(device, &lit.entries(0));
        Ok(Self { kernel, lit, group })
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
        self.kernel.bind(
            device,
            &[receivers, Slot::with("radiance", 16, 1, radiance)],
        )
    }

    /// Uploads the light for what is submitted next.
    pub fn prepare(&self, queue: &Queue, light: &Light) -> Result<(), Error> {
        self.lit.prepare(queue, light, 0, Limits::LEAVES)
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
