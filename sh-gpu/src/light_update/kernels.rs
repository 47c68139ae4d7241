//! The kernels of the pass.

use super::memory::of;
use crate::lighting::Lit;
use crate::pipeline::{Kernel, buffer_entry};
use crate::{Bound, Error, ShadowPass};
use sh_kernels::Pass;
use std::sync::Arc;
use wgpu::{Buffer, BufferBindingType, Device, ShaderStages};

/// Points put in place; what spheres emit of their light; means for the nodes above.
#[derive(Debug)]
pub(super) struct Kernels {
    pub place: Arc<Kernel>,
    pub project: Arc<Kernel>,
    pub raise: Arc<Kernel>,
}

impl Kernels {
    pub fn new(shadow: &ShadowPass) -> Result<Self, Error> {
        let entry = |binding, ty| buffer_entry(binding, ShaderStages::COMPUTE, ty, false);
        let storage = |binding, read_only| entry(binding, BufferBindingType::Storage { read_only });
        let [record, _] = Lit::layout(0);
        let own = [
            record,
            storage(1, true),
            storage(2, true),
            storage(3, true),
            storage(4, false),
            storage(5, true),
            storage(6, true),
        ];
        let specialised = (Pass::LightUpdate, shadow.order(), shadow.order());
        let kernel = |name, read_only| {
            let groups = [&own[..], &[storage(0, read_only)]];
            shadow.pipelines.kernel(specialised, name, groups)
        };
        Ok(Self {
            place: kernel("place", false)?,
            project: kernel("project", true)?,
            raise: kernel("raise", true)?,
        })
    }

    /// What so many spheres emit where their points have this radiance.
    pub fn project(
        &self,
        device: &Device,
        radiance: &Buffer,
        spheres: u64,
    ) -> Result<Bound, Error> {
        let slots = [of(radiance, "radiance", 16)];
        self.project.bind_groups(device, &slots, spheres, 1)
    }
}
