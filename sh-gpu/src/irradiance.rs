//! The irradiance pass: environment light without blockers, for every receiver (Ren et al. 2006,
//! equation 9).

use crate::lighting::Shading;
use crate::pipeline::shader;
use crate::{Bound, Error};
use sh_kernels::Pass;
use sh_scene::Light;
use wgpu::{BufferBinding, CommandEncoder, ComputePassTimestampWrites, Device, Queue};

/// Environment light without blockers, on the host's device, queue and encoder. Used as
/// [`ShadowPass`](crate::ShadowPass) is.
#[derive(Debug)]
pub struct IrradiancePass(Shading);

impl IrradiancePass {
    /// Makes the pipeline for an SH order, 2 to 6.
    pub fn new(device: &Device, order: usize) -> Result<Self, Error> {
        let module = shader(device, Pass::Irradiance, order)?;
        Shading::new(device, Pass::Irradiance, &module, order, None).map(Self)
    }

    /// Binds receivers ([`sh_scene::Receiver`], 32 bytes each, read) and radiance (red, green, blue, 0 as
    /// `vec4f`, 16 bytes each, written). The size of `receivers` says how many there are; `radiance` must
    /// hold as many. Both need `BufferUsages::STORAGE`.
    pub fn bind(
        &self,
        device: &Device,
        receivers: BufferBinding<'_>,
        radiance: BufferBinding<'_>,
    ) -> Result<Bound, Error> {
        self.0.bind(device, receivers, radiance)
    }

    /// Uploads the light for what is submitted next.
    pub fn prepare(&self, queue: &Queue, light: &Light) -> Result<(), Error> {
        self.0.prepare(queue, &[], light)
    }

    /// Records one compute pass that writes the radiance each receiver would reflect with albedo 1, never
    /// negative; receivers that are not covered get 0.
    pub fn record(
        &self,
        encoder: &mut CommandEncoder,
        bound: &Bound,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) {
        self.0.record(encoder, bound, timestamps);
    }
}
