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

#[cfg(test)]
mod tests {
    use super::*;
    use glam::vec3;
    use sh_scene::Camera;

    #[test]
    fn rays_are_those_of_the_view() {
        let camera = Camera {
            eye: vec3(1.0, 2.0, 3.0),
            target: vec3(-0.3, 0.1, 0.2),
            fov: 0.8,
        };
        let view = View {
            camera,
            width: 37,
            height: 23,
        };
        for grid in [view.samples(), view.halves()] {
            let rays = Rays::new(&view, grid);
            for y in 0..grid.rows {
                for x in 0..grid.columns {
                    assert_eq!(rays.through(x, y), Vec3A::from(view.ray(grid, x, y)));
                }
            }
        }
    }
}
