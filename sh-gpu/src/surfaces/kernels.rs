//! The kernels of the pass.

use crate::Error;
use crate::inputs::Inputs;
use crate::pipeline::Kernel;
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
    pub fn new(inputs: &Inputs) -> Result<Self, Error> {
        let specialised = (Pass::LightUpdate, inputs.order, inputs.order);
        let kernel = |name| inputs.pipelines.kernel(specialised, name);
        Ok(Self {
            place: kernel("place")?,
            project: kernel("project")?,
            raise: kernel("raise")?,
        })
    }
}
