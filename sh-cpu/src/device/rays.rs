//! The rays of a view.

use glam::Vec3A;
use sh_scene::{Grid, View};

/// The rays of a grid: [`View::ray`] with what is common to all rays computed once.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rays {
    axes: [glam::Vec3; 3],
    wide: f32,
    tall: f32,
    view: View,
    grid: Grid,
}

impl Rays {
    pub(crate) fn new(view: &View, grid: Grid) -> Self {
        let tall = (view.camera.fov * 0.5).tan();
        Self {
            axes: view.axes(),
            wide: tall * view.width as f32 / view.height as f32,
            tall,
            view: *view,
            grid,
        }
    }

    /// Unit direction through a cell, the bits of [`View::ray`].
    #[inline(always)]
    pub(crate) fn through(&self, x: u32, y: u32) -> Vec3A {
        let [right, up, forward] = self.axes;
        let [u, v] = self.grid.place(&self.view, x, y);
        (forward + right * (u * self.wide) + up * (v * self.tall))
            .normalize()
            .into()
    }
}
