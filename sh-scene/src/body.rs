//! Bodies whose spheres send light on.

use crate::Object;
use crate::surface::SurfaceSamples;
use glam::{Affine3A, Quat};

/// A body whose spheres send light on: where it is, and the surface around them.
///
/// ```
/// # use sh_scene::*;
/// # fn bodies(scene: &Scene) {
/// let points: usize = scene.objects.iter().map(|object| Body::from(object).points()).sum();
/// # }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Body<'a> {
    /// Points on its surface, sphere by sphere.
    pub surface: &'a SurfaceSamples,
    /// World from the space that they are in: a rotation, a uniform scale and a translation.
    pub transform: Affine3A,
    /// How many spheres it has: a body without a surface has black ones.
    pub spheres: usize,
}

impl Body<'_> {
    /// Points around all of its spheres.
    pub fn points(&self) -> usize {
        let spheres = 0..self.spheres;
        spheres.map(|sphere| self.surface.of(sphere).len()).sum()
    }

    /// The rotation from the space that points are in to the world; none of a body without extent, which faces nowhere.
    pub fn turn(&self) -> Quat {
        let (_, turn, _) = self.transform.to_scale_rotation_translation();
        Some(turn).filter(|q| q.is_finite()).unwrap_or_default()
    }

    /// The rotation from the frame of a sphere's directions to the world, with [`turn`](Self::turn) as it is.
    pub fn frame(&self, turn: Quat, sphere: usize) -> Quat {
        let own = self.surface.rotations.get(sphere);
        let own = own.map_or(Quat::IDENTITY, |q| Quat::from_array(*q));
        (turn * own).normalize()
    }
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
