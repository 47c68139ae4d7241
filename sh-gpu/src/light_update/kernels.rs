//! The kernels of the pass.

use super::memory::of;
use crate::pipeline::Kernel;
use crate::{Bound, Error, ShadowPass};
use sh_kernels::Pass;
use std::sync::Arc;
use wgpu::{Buffer, Device};

/// Points put in place; what spheres emit of their light; means for the nodes above.
#[derive(Debug)]
pub(super) struct Kernels {
    pub place: Arc<Kernel>,
    pub project: Arc<Kernel>,
    pub raise: Arc<Kernel>,
}

impl Kernels {
    pub fn new(shadow: &ShadowPass) -> Result<Self, Error> {
        let specialised = (Pass::LightUpdate, shadow.order(), shadow.order());
        let kernel = |name| shadow.pipelines.kernel(specialised, name);
        Ok(Self {
            place: kernel("place")?,
            project: kernel("project")?,
            raise: kernel("raise")?,
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
