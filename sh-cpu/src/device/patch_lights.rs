//! What patches send on, and where their bodies are.

use glam::{Affine3A, Mat3, Vec3};
use sh_scene::BasisBody;
use sh_scene::basis::{Patch, Shape};
use std::ops::Range;

/// What the patches and regions of all bodies send on, in these bodies' own spaces. Its memory is kept from frame to frame.
#[derive(Clone, Debug, Default)]
pub struct PatchLights {
    /// Coefficients of a region.
    pub coefficients: usize,
    pub bodies: Vec<Lit>,
    /// No patch sends on more radiance than this.
    pub brightest: [f32; 3],
}

/// A body and its light.
#[derive(Clone, Debug, Default)]
pub struct Lit {
    /// Of its functions.
    pub weights: Vec<[f32; 3]>,
    /// Radiance of each patch.
    pub radiance: Vec<[f32; 3]>,
    /// What the body gives each patch itself; empty where it gives itself nothing.
    pub own: Vec<[f32; 3]>,
    /// Intensity of each region by direction, coefficient by coefficient.
    pub emission: Vec<[f32; 3]>,
}

impl Lit {
    /// The mean radiance of some patches.
    #[inline(always)]
    pub(crate) fn mean(&self, patches: Range<usize>) -> [f32; 3] {
        let share = 1.0 / patches.len() as f32;
        let mut mean = [0.0; 3];
        for radiance in &self.radiance[patches] {
            for (mean, of) in mean.iter_mut().zip(radiance) {
                *mean += of;
            }
        }
        mean.map(|sum| sum * share)
    }
}

impl PatchLights {
    /// Bytes that it takes.
    pub(crate) fn bytes(&self) -> usize {
        let of = |body: &Lit| {
            let lists = [&body.weights, &body.radiance, &body.own, &body.emission];
            lists
                .into_iter()
                .map(|list| size_of_val(&list[..]))
                .sum::<usize>()
        };
        self.bodies.iter().map(of).sum()
    }
}

/// A body where it is now.
#[derive(Clone, Copy, Debug)]
pub struct Placed<'a> {
    pub shape: &'a Shape,
    pub patches: &'a [Patch],
    pub object: u32,
    /// Its own space from the world's, which its directions are turned by.
    pub turn: Mat3,
    /// The same of places.
    pub local: Affine3A,
    /// Metres of the world a metre of its own.
    pub scale: f32,
    /// The ball around it in the world.
    pub center: Vec3,
    pub radius: f32,
    /// Whether it is anywhere.
    pub placed: bool,
}

impl<'a> Placed<'a> {
    /// One whose space is no larger than a point is nowhere to be seen.
    pub fn of(body: BasisBody<'a>) -> Self {
        let (turn, scale) = body.placed();
        let local = body.transform.inverse();
        let shape = body.basis.shape();
        let placed = scale > 0.0 && local.is_finite();
        Self {
            shape,
            patches: &body.basis.parts().patches,
            object: body.object,
            turn: Mat3::from_quat(turn.inverse()),
            local: if placed { local } else { Affine3A::IDENTITY },
            scale: if placed { scale } else { 1.0 },
            center: body.transform.transform_point3(shape.center),
            radius: shape.radius * scale,
            placed,
        }
    }
}

impl Placed<'_> {
    /// A place of its own space in the world.
    pub(crate) fn world(&self, place: Vec3) -> Vec3 {
        self.center + self.turn.transpose() * (place - self.shape.center) * self.scale
    }
}
