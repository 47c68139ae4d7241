//! The punctual pass: light of spots, points and suns, added to that of receivers.

use crate::pipeline::Kernel;
use crate::scope::checked;
use crate::slot::Slot;
use crate::views::Views;
use crate::{Bound, Error, Pipelines};
use sh_kernels::Pass;
use sh_scene::Receiver;
use std::sync::Arc;
use wgpu::{BindGroup, BufferBinding, CommandEncoder, ComputePassTimestampWrites, Device};

/// The pass, for receivers that reflect diffusely or for what they mirror.
#[derive(Debug)]
pub(crate) struct PunctualPass {
    kernel: Arc<Kernel>,
    group: BindGroup,
}

impl PunctualPass {
    /// By these lights; `draws` says whether anything may be in the way.
    pub fn new(
        pipelines: &Pipelines,
        order: usize,
        views: &Views,
        [draws, gloss]: [bool; 2],
    ) -> Result<Self, Error> {
        let device = pipelines.device();
        checked(device, || {
            let of = (Pass::Punctual, order, order);
            let constants = [("VIEWS", draws), ("GLOSS", gloss)];
            let kernel = pipelines.specialised(of, "punctual", &constants)?;
            let group = kernel.own(device, &views.bindings());
            Ok(Self { kernel, group })
        })
    }

    /// Binds receivers, read, and their radiance, added to.
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

    /// Records one compute pass.
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
