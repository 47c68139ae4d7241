//! All that this renderer knows of Gaunt. `new` makes everything; a frame is `prepare` and `record`, which make nothing.

use glam::Mat4;
use sh_gpu::{Bound, Error, Pipelines, ScreenCamera, ScreenPass, ScreenTextures, ShadowOptions, ShadowPass};
use sh_scene::{Forest, Light, Limits, Sphere};
use wgpu::{CommandEncoder, Device, Queue};

/// Soft shadows for a G-buffer.
pub struct Shadows {
    screen: ScreenPass,
    shadow: ShadowPass,
    lit: Bound,
    blockers: Forest,
}

impl Shadows {
    /// For the textures of a G-buffer, and as many blocker spheres as there are now.
    pub fn new(device: &Device, textures: ScreenTextures<'_>, spheres: &[Sphere]) -> Result<Self, Error> {
        let pipelines = Pipelines::new(device);
        let options = ShadowOptions { max_blockers: spheres.len() as u32, ..ShadowOptions::default() };
        let shadow = ShadowPass::with(&pipelines, options)?;
        let screen = ScreenPass::with(&pipelines, textures)?;
        let lit = screen.parts().map(|part| shadow.bind(device, part.receivers, part.radiance));
        let lit = lit.collect::<Result<_, _>>()?;
        // One body for each sphere.
        let blockers = Forest::new(spheres, &vec![1; spheres.len()]);
        Ok(Self { screen, shadow, lit, blockers })
    }

    /// Every frame, with the spheres where they are now. Depth is reversed, and normals have signs: that is the default.
    pub fn prepare(
        &mut self, queue: &Queue, clip_from_world: Mat4, spheres: &[Sphere], light: &Light,
    ) -> Result<(), Error> {
        let world_from_clip = clip_from_world.inverse();
        self.screen.prepare(queue, &ScreenCamera { world_from_clip, ..ScreenCamera::default() });
        self.blockers.update(spheres);
        self.shadow.prepare(queue, &self.blockers, Limits::default(), light)
    }

    /// Every frame, between drawing the G-buffer and whatever reads radiance.
    pub fn record(&self, encoder: &mut CommandEncoder) {
        self.screen.record_receivers(encoder, None);
        self.shadow.record(encoder, &self.lit, None);
        self.screen.record_radiance(encoder, None);
    }
}
