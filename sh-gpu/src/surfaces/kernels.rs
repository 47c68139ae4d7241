//! The kernels of the pass.

use crate::pipeline::Kernel;
use crate::{Error, ShadowPass};
use sh_kernels::Pass;
use std::sync::Arc;

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
}
