//! The camera, and the grid of samples it looks through.

use glam::{Mat4, Vec3, Vec4};

/// Where the picture is taken from. +Y is up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Position of the eye, in metres.
    pub eye: Vec3,
    /// The point it looks at.
    pub target: Vec3,
    /// Vertical field of view, in radians.
    pub fov: f32,
}

/// A camera together with the size of the picture: what the G-buffer pass samples.
///
/// A picture of `width` by `height` pixels is sampled on a grid [`View::OVERSAMPLE`] times as fine in
/// each direction; both backends look through the centres of the same grid cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The camera.
    pub camera: Camera,
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
}

impl View {
    /// Samples per pixel in each direction.
    pub const OVERSAMPLE: u32 = 2;

    /// The camera's axes: right, up and forward, unit vectors. Looking straight up or down, +Z stands in
    /// for +Y.
    pub fn axes(&self) -> [Vec3; 3] {
        let forward = (self.camera.target - self.camera.eye).normalize();
        let up = if forward.y.abs() > 0.9999 { Vec3::Z } else { Vec3::Y };
        let right = forward.cross(up).normalize();
        [right, right.cross(forward), forward]
    }

    /// Unit direction through sample column `x`, row `y` (from the top left, in samples).
    pub fn ray(&self, x: u32, y: u32) -> Vec3 {
        let [right, up, forward] = self.axes();
        let tall = (self.camera.fov * 0.5).tan();
        let wide = tall * self.width as f32 / self.height as f32;
        let u = 2.0 * (x as f32 + 0.5) / (self.width * Self::OVERSAMPLE) as f32 - 1.0;
        let v = 1.0 - 2.0 * (y as f32 + 0.5) / (self.height * Self::OVERSAMPLE) as f32;
        (forward + right * (u * wide) + up * (v * tall)).normalize()
    }

    /// World to clip space (depth 1 at `near`, towards 0 at infinity) for rasterising the same grid.
    pub fn clip_from_world(&self, near: f32) -> Mat4 {
        let [right, up, forward] = self.axes();
        let tall = 1.0 / (self.camera.fov * 0.5).tan();
        let wide = tall * self.height as f32 / self.width as f32;
        let row = |axis: Vec3, scale: f32| (axis * scale).extend(-axis.dot(self.camera.eye) * scale);
        Mat4::from_cols(row(right, wide), row(up, tall), Vec4::W * near, row(forward, 1.0)).transpose()
    }
}
