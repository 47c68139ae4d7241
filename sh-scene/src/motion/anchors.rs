//! Spheres that follow a skin (Ren et al. 2006, section 6.2, "Animation").
//!
//! A sphere's centre is a weighted sum of the mesh's vertices, P = Σᵥ λᵥ pᵥ with Σᵥ λᵥ = 1, and keeps its
//! weights λ while the mesh moves. A skin puts vertex v to pᵥ = Σ_b wᵥ_b B_b (rᵥ, 1), with rest position rᵥ,
//! joint weights wᵥ_b and bones B_b. So
//!
//! ```text
//! P = Σ_b B_b a_b      a_b = Σᵥ λᵥ wᵥ_b (rᵥ, 1)
//! ```
//!
//! and a frame costs one matrix times one vector for each bone that counts, however many vertices there are.
//! The vectors a_b are the sphere's anchors; their fourth components sum to 1.

use super::MotionError;
use crate::Sphere;
use glam::{Affine3A, Vec3, Vec3A};

/// A sphere's hold on one bone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Anchor {
    /// Index of the bone.
    pub bone: u32,
    /// Share of the bone in the sphere.
    pub weight: f32,
    /// Where the bone holds it, in the bone's mesh space, times the weight.
    pub point: Vec3,
}

/// The anchors of a set of spheres.
#[derive(Clone, Debug, Default)]
pub struct Anchors {
    /// Where each sphere's anchors end.
    ends: Vec<u32>,
    anchors: Vec<Anchor>,
}

impl Anchors {
    /// The anchors of spheres, in their order. A sphere without any stays where it is.
    pub fn new(spheres: impl IntoIterator<Item = Vec<Anchor>>) -> Self {
        let mut all = Self::default();
        for anchors in spheres {
            all.anchors.extend(anchors);
            all.ends.push(all.anchors.len() as u32);
        }
        all
    }

    /// Each sphere's anchors.
    pub fn each(&self) -> impl Iterator<Item = &[Anchor]> {
        self.ends.iter().scan(0, |start, &end| {
            let anchors = &self.anchors[*start as usize..end as usize];
            *start = end;
            Some(anchors)
        })
    }

    /// Moves the spheres' centres with the bones, root from mesh each. Radii stay.
    ///
    /// # Panics
    /// If a bone is missing, which [`Rig::new`](super::Rig::new) sees to.
    pub fn pose(&self, bones: &[Affine3A], spheres: &mut [Sphere]) {
        for (anchors, sphere) in self.each().zip(spheres) {
            if !anchors.is_empty() {
                sphere.center = center(anchors, bones).to_array();
            }
        }
    }

    /// Whether all bones are among so many.
    pub(super) fn check(&self, count: usize) -> Result<(), MotionError> {
        match self.anchors.iter().find(|a| a.bone as usize >= count) {
            None => Ok(()),
            Some(anchor) => Err(MotionError::Missing {
                what: "bone",
                index: anchor.bone,
                count,
            }),
        }
    }
}

/// Where bones hold a sphere.
fn center(anchors: &[Anchor], bones: &[Affine3A]) -> Vec3A {
    let held = |anchor: &Anchor| {
        let bone = &bones[anchor.bone as usize];
        bone.matrix3 * Vec3A::from(anchor.point) + bone.translation * anchor.weight
    };
    anchors.iter().map(held).sum()
}
