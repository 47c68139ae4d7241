//! A host's G-buffer, as the screen pass takes it.

use crate::{Error, ScreenPass};
use glam::Mat4;
use wgpu::{TextureUsages, TextureView};

/// Where a G-buffer has its positions.
#[derive(Clone, Copy, Debug)]
pub enum Position<'a> {
    /// In a texture of floats, in world space, in metres; alpha is 0 where nothing is covered. `Rgba32Float`, or
    /// `Rgba16Float` in a scene that is small enough.
    Texture(&'a TextureView),
    /// In the depth buffer (`Depth32Float`, or the depth aspect of another format), by way of the camera.
    Depth(&'a TextureView),
}

/// A G-buffer, and where radiance goes: textures of one size, without mip levels or samples.
#[derive(Clone, Copy, Debug)]
pub struct ScreenTextures<'a> {
    /// Positions. Usage `TEXTURE_BINDING`.
    pub position: Position<'a>,
    /// World-space normals of any length but 0, in the first three channels of any float or normalised format. Usage
    /// `TEXTURE_BINDING`.
    pub normal: &'a TextureView,
    /// What radiance is written to: [`ScreenPass::RADIANCE`], usage `STORAGE_BINDING`.
    pub radiance: &'a TextureView,
}

/// How a frame's G-buffer is to be read.
///
/// ```
/// use glam::camera::rh::{proj::directx::perspective_infinite_reverse, view::look_at_mat4};
/// use glam::Vec3;
/// let view = look_at_mat4(Vec3::new(0.0, 2.0, 5.0), Vec3::ZERO, Vec3::Y);
/// let reversed = perspective_infinite_reverse(1.0, 16.0 / 9.0, 0.1);
/// let camera = sh_gpu::ScreenCamera { world_from_clip: (reversed * view).inverse(), ..Default::default() };
/// assert_eq!(camera.empty_depth, 0.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScreenCamera {
    /// From WebGPU's clip space (x and y from -1 to 1, y upwards, depth from 0 to 1) to the world; only
    /// [`Position::Depth`] asks for it. With an infinite far plane that is an inverse of a matrix that has one.
    pub world_from_clip: Mat4,
    /// What the depth buffer was cleared to: 0 where depth is reversed, else 1.
    pub empty_depth: f32,
    /// A normal is a texel's first three channels times this,
    pub normal_scale: f32,
    /// plus this: 1 and 0 for formats that hold signs, 2 and -1 for those that do not.
    pub normal_bias: f32,
}

impl Default for ScreenCamera {
    fn default() -> Self {
        Self {
            world_from_clip: Mat4::IDENTITY,
            empty_depth: 0.0,
            normal_scale: 1.0,
            normal_bias: 0.0,
        }
    }
}

impl ScreenTextures<'_> {
    /// The size that all have, if they can be bound.
    pub(crate) fn check(&self) -> Result<[u32; 2], Error> {
        let (Position::Texture(position) | Position::Depth(position)) = self.position;
        let size = |view: &TextureView| [view.texture().width(), view.texture().height()];
        let expected = size(self.radiance);
        let bound = TextureUsages::TEXTURE_BINDING;
        let wanted = [
            ("position", position, bound),
            ("normal", self.normal, bound),
            ("radiance", self.radiance, TextureUsages::STORAGE_BINDING),
        ];
        for (texture, view, usage) in wanted {
            let [width, height] = size(view);
            let format = view.texture().format();
            let problem = if !view.texture().usage().contains(usage) {
                format!("needs the usage {usage:?}")
            } else if [width, height] != expected {
                let [across, down] = expected;
                format!("has {width} by {height} texels, but the target has {across} by {down}")
            } else if texture == "radiance" && format != ScreenPass::RADIANCE {
                format!(
                    "has the format {format:?}; {:?} is needed",
                    ScreenPass::RADIANCE
                )
            } else {
                continue;
            };
            return Err(Error::Texture { texture, problem });
        }
        Ok(expected)
    }
}
