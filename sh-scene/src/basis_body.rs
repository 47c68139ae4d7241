//! Rigid bodies that send light by their patches.

use crate::{IrradianceBasis, Object};
use glam::{Affine3A, Quat};

/// A rigid body whose light is told by its basis, and where it is.
///
/// ```
/// # use sh_scene::*;
/// # fn bodies(scene: &Scene) {
/// let count = BasisBody::all(&scene.objects).count();
/// # }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct BasisBody<'a> {
    /// What is known of it.
    pub basis: &'a IrradianceBasis,
    /// World from the space that it is known in: a rotation, a uniform scale and a translation.
    pub transform: Affine3A,
    /// The body, as receivers carry it ([`crate::Receiver::object`]).
    pub object: u32,
}

impl<'a> BasisBody<'a> {
    /// Those of a scene.
    pub fn all(objects: &'a [Object]) -> impl Iterator<Item = Self> + Clone {
        let objects = (1..).zip(objects);
        objects.filter_map(|(object, body)| {
            Some(Self {
                basis: body.basis.as_deref()?,
                transform: body.transform,
                object,
            })
        })
    }

    /// The rotation from its space to the world, and the scale; none of a body without extent, which faces nowhere.
    pub fn placed(&self) -> (Quat, f32) {
        let (scale, turn, _) = self.transform.to_scale_rotation_translation();
        let turn = Some(turn).filter(|q| q.is_finite()).unwrap_or_default();
        (turn.normalize(), scale.x.abs())
    }
}
