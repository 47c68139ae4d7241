//! The shadow pass: environment light through the visibility of all blocker spheres, for every receiver
//! (Ren et al. 2006, section 8).

use crate::lighting::Shading;
use crate::pipeline::module;
use crate::{Bound, Error};
use sh_kernels::Pass;
use sh_scene::{Light, Sphere};
use wgpu::{BufferBinding, CommandEncoder, ComputePassTimestampWrites, Device, Queue};

/// How a [`ShadowPass`] is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShadowOptions {
    /// SH order of the light, 2 to 6. The cost of a receiver grows with its fourth power.
    pub order: usize,
    /// SH order in which the blockers' logarithms are summed and exponentiated, from `order` to 6. Above `order`
    /// the shadows are truer; the cost of a blocker grows with its square.
    pub accumulation: usize,
    /// The most blocker spheres [`ShadowPass::prepare`] will take; 16 bytes each are set aside.
    pub max_blockers: u32,
}

impl Default for ShadowOptions {
    fn default() -> Self {
        Self {
            order: 4,
            accumulation: 4,
            max_blockers: 4096,
        }
    }
}

/// Environment light through the visibility of all blocker spheres, on the host's device, queue and
/// encoder.
///
/// Pipeline and bind groups are made by [`new`](Self::new) and [`bind`](Self::bind); a frame is
/// [`prepare`](Self::prepare) and [`record`](Self::record), which create nothing.
///
/// ```no_run
/// # use sh_gpu::{Error, ShadowOptions, ShadowPass};
/// # fn frame(device: &wgpu::Device, queue: &wgpu::Queue, receivers: &wgpu::Buffer, radiance: &wgpu::Buffer,
/// #     spheres: &[sh_scene::Sphere], light: &sh_scene::Light) -> Result<(), Error> {
/// let options = ShadowOptions { max_blockers: 1000, ..ShadowOptions::default() };
/// let shadow = ShadowPass::new(device, options)?;
/// let bound = shadow.bind(device, receivers.as_entire_buffer_binding(), radiance.as_entire_buffer_binding())?;
/// // every frame
/// shadow.prepare(queue, spheres, light)?;
/// let mut encoder = device.create_command_encoder(&Default::default());
/// shadow.record(&mut encoder, &bound, None);
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct ShadowPass(Shading);

impl ShadowPass {
    /// Makes the pipeline and sets room aside for blockers and light.
    pub fn new(device: &Device, options: ShadowOptions) -> Result<Self, Error> {
        let ShadowOptions {
            order,
            accumulation,
            max_blockers,
        } = options;
        let text = match sh_kernels::source(Pass::Shadow, order) {
            Some(_) => sh_kernels::shadow(order, accumulation).ok_or(Error::Accumulation {
                order,
                accumulation,
            })?,
            None => return Err(Error::Order(order)),
        };
        let label = format!("gaunt shadow order {order}, accumulated in {accumulation}");
        let module = module(device, &label, text)?;
        Shading::new(device, Pass::Shadow, &module, order, Some(max_blockers)).map(Self)
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

    /// Uploads the blockers, in world space, and the light for what is submitted next.
    pub fn prepare(&self, queue: &Queue, blockers: &[Sphere], light: &Light) -> Result<(), Error> {
        self.0.prepare(queue, blockers, light)
    }

    /// Records one compute pass that writes the radiance each receiver would reflect with albedo 1. Every
    /// channel lies within 0 and its unshadowed value; receivers that are not covered get 0.
    pub fn record(
        &self,
        encoder: &mut CommandEncoder,
        bound: &Bound,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) {
        self.0.record(encoder, bound, timestamps);
    }
}
