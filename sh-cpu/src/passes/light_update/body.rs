//! Bodies whose spheres send light on.

use glam::{Affine3A, Quat};
use sh_scene::Object;
use sh_scene::surface::SurfaceSamples;

/// A body whose spheres send light on.
#[derive(Clone, Copy, Debug)]
pub struct Body<'a> {
    /// Points on its surface, sphere by sphere.
    pub surface: &'a SurfaceSamples,
    /// World from the space that they are in: a rotation, a uniform scale and a translation.
    pub transform: Affine3A,
    /// How many spheres it has: a body without a surface has black ones.
    pub spheres: usize,
}

impl<'a> From<&'a Object> for Body<'a> {
    fn from(object: &'a Object) -> Self {
        Self {
            surface: &object.surface,
            transform: object.transform,
            spheres: object.spheres.len(),
        }
    }
}

/// The rotation of a transform that turns, scales evenly and moves.
pub(super) fn rotation(transform: &Affine3A) -> Quat {
    let (_, turn, _) = transform.to_scale_rotation_translation();
    // A body without extent faces nowhere.
    Some(turn).filter(|q| q.is_finite()).unwrap_or_default()
}
