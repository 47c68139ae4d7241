//! What a comparison looks at: one receiver a pixel.

use crate::Error;
use rayon::prelude::*;
use sh_cpu::{Gbuffer, Geometry, gbuffer};
use sh_scene::{Grid, Receiver, Scene, Tiles, View};

/// The receivers of a small picture, in the order of its tiles.
pub struct Seen {
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// Receivers and albedo, tile by tile.
    pub samples: Gbuffer,
    view: View,
    grid: Grid,
}

impl Seen {
    /// What a scene's camera sees.
    ///
    /// # Errors
    /// Where the scene or the size is none that can be rendered.
    pub fn new(scene: &Scene, [width, height]: [u32; 2]) -> Result<Self, Error> {
        // Through a picture twice as fine the coarse grid has one ray a pixel of this one.
        let view = View {
            camera: scene.camera,
            width: 2 * width,
            height: 2 * height,
        };
        let geometry = Geometry::new(scene)?;
        let grid = view.halves();
        let mut samples = Gbuffer::default();
        gbuffer(&geometry, &view, grid, 0..grid.tiles().rows, &mut samples)?;
        Ok(Self {
            width,
            height,
            samples,
            view,
            grid,
        })
    }

    /// The receivers.
    pub fn receivers(&self) -> &[Receiver] {
        &self.samples.receivers
    }

    /// How they are stored.
    pub fn tiles(&self) -> Tiles {
        self.grid.tiles()
    }

    /// Something of each receiver that is there, without the gaps between them.
    pub fn covered<T: Copy>(&self, all: &[T]) -> Vec<T> {
        let pairs = self.receivers().iter().zip(all);
        pairs
            .filter(|(r, _)| r.covered != 0)
            .map(|(_, t)| *t)
            .collect()
    }

    /// A picture, row by row, of the pixel's ray and the index of its receiver, if it has one.
    pub fn picture(
        &self,
        pixel: impl Fn(glam::Vec3, Option<usize>) -> [f32; 3] + Sync,
    ) -> Vec<[f32; 3]> {
        let (tiles, width) = (self.tiles(), self.width as usize);
        let one = |i: usize| {
            let (x, y) = ((i % width) as u32, (i / width) as u32);
            let at = tiles.index(x, y);
            let covered = self.receivers()[at].covered != 0;
            pixel(self.view.ray(self.grid, x, y), covered.then_some(at))
        };
        (0..width * self.height as usize)
            .into_par_iter()
            .map(one)
            .collect()
    }

    /// Radiance as the eye sees it: albedo times what each receiver reflects, and `sky` elsewhere.
    pub fn shaded(
        &self,
        radiance: &[[f32; 3]],
        sky: impl Fn(glam::Vec3) -> [f32; 3] + Sync,
    ) -> Vec<[f32; 3]> {
        self.picture(|ray, receiver| match receiver {
            Some(at) => {
                let (albedo, radiance) = (self.samples.albedo[at], radiance[at]);
                std::array::from_fn(|c| albedo[c] * radiance[c])
            }
            None => sky(ray),
        })
    }
}
