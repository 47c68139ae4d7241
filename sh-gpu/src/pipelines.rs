//! Shader modules and pipelines, made the first time that somebody asks for them.

use crate::Error;
use crate::pipeline::{Kernel, module};
use sh_kernels::Pass;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use wgpu::{Device, RenderPipeline, ShaderModule};

/// What tells one shader module from another: pass, order, order of accumulation.
pub(crate) type Specialisation = (Pass, usize, usize);

/// A kernel of a module, and the bits of its overrides' values.
type KernelKey = (Specialisation, &'static str, Vec<(&'static str, bool)>);

/// The pipelines of a device, shared by all passes that are made [`with`](crate::ShadowPass::with) them: one for each
/// specialisation (order, order of accumulation, output, method), compiled when a pass first asks for it and kept as
/// long as this is. Clones share what they hold.
///
/// A host that makes passes anew, because a window or a scene changed, keeps one of these and compiles nothing twice.
///
/// ```no_run
/// # use sh_gpu::{Error, Pipelines, ShadowOptions, ShadowPass};
/// # fn passes(device: &wgpu::Device) -> Result<(), Error> {
/// let pipelines = Pipelines::new(device);
/// let near = ShadowPass::with(&pipelines, ShadowOptions::default())?;
/// let far = ShadowPass::with(&pipelines, ShadowOptions { max_blockers: 100, ..ShadowOptions::default() })?;
/// assert_eq!((pipelines.shader_modules(), pipelines.count()), (1, 1));
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct Pipelines {
    device: Device,
    made: Arc<Mutex<Made>>,
}

#[derive(Debug, Default)]
struct Made {
    modules: HashMap<Specialisation, ShaderModule>,
    kernels: HashMap<KernelKey, Arc<Kernel>>,
    rasters: HashMap<&'static str, RenderPipeline>,
}

impl Pipelines {
    /// None yet, for this device.
    pub fn new(device: &Device) -> Self {
        Self {
            device: device.clone(),
            made: Arc::default(),
        }
    }

    /// The device that they are made on.
    pub fn device(&self) -> &Device {
        &self.device
    }

    /// How many shader modules have been compiled.
    pub fn shader_modules(&self) -> usize {
        self.made().modules.len()
    }

    /// How many pipelines have been made, compute and render.
    pub fn count(&self) -> usize {
        let made = self.made();
        made.kernels.len() + made.rasters.len()
    }

    /// The kernel `name` of a module.
    pub(crate) fn kernel(
        &self,
        of: Specialisation,
        name: &'static str,
    ) -> Result<Arc<Kernel>, Error> {
        self.specialised(of, name, &[])
    }

    /// As [`kernel`](Self::kernel), with values for the shader's overrides.
    pub(crate) fn specialised(
        &self,
        of: Specialisation,
        name: &'static str,
        constants: &[(&'static str, bool)],
    ) -> Result<Arc<Kernel>, Error> {
        let key = (of, name, constants.to_vec());
        let mut made = self.made();
        if let Some(kernel) = made.kernels.get(&key) {
            return Ok(kernel.clone());
        }
        let module = made.module(&self.device, of)?;
        let kernel = Kernel::new(&self.device, &module, of.0, name, constants)?;
        let kernel = Arc::new(kernel);
        made.kernels.insert(key, kernel.clone());
        Ok(kernel)
    }

    /// The render pipeline with the fragment shader `name`.
    pub(crate) fn raster(
        &self,
        of: Specialisation,
        name: &'static str,
        make: impl FnOnce(&ShaderModule) -> RenderPipeline,
    ) -> Result<RenderPipeline, Error> {
        let mut made = self.made();
        if let Some(pipeline) = made.rasters.get(name) {
            return Ok(pipeline.clone());
        }
        let pipeline = make(&made.module(&self.device, of)?);
        made.rasters.insert(name, pipeline.clone());
        Ok(pipeline)
    }

    fn made(&self) -> MutexGuard<'_, Made> {
        // Nothing is left half done in there.
        self.made.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Made {
    fn module(&mut self, device: &Device, of: Specialisation) -> Result<ShaderModule, Error> {
        if let Some(module) = self.modules.get(&of) {
            return Ok(module.clone());
        }
        let module = module(device, of)?;
        self.modules.insert(of, module.clone());
        Ok(module)
    }
}
