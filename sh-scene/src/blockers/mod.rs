//! Blockers in a hierarchy, and the part of it that a cluster of receivers needs.
//!
//! The spheres of all objects are the leaves of one tree (Ren et al. 2006, section 6.3): [`Forest`]. A
//! [`Bounds`] says where a cluster of receivers is and how its normals lie. Between the two stands the *cut*: the
//! nodes that together hold every leaf once, as coarse as the angles they subtend over the cluster allow
//! ([`Limits`]). A node of a cut that is no leaf stands for all leaves below it, with a ratio vector that makes it
//! weigh as much as they do: [`Blocker`] is the record that the shadow pass reads.

mod bounds;
mod build;
mod forest;

pub use bounds::{Bounds, Side};
pub use forest::{Forest, Node};
#[doc(inline)]
pub use sh_core::constants::NEGLIGIBLE;

use crate::Sphere;
use sh_core::constants::MAX_ORDER;

/// A blocker of a cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blocker {
    /// Centre, in metres.
    pub center: [f32; 3],
    /// Radius, in metres.
    pub radius: f32,
    /// What band l of the sphere's log visibility is multiplied with: its weight, or the ratio vector w of Ren et al. 2006,
    /// equation 37.
    pub weights: [f32; MAX_ORDER],
    /// The body that it is of, as [`crate::Receiver::object`] has it; 0 where it is of none or of several.
    pub object: u32,
}

impl Blocker {
    /// One that does not count.
    pub const NONE: Self = Self {
        center: [0.0; 3],
        radius: 0.0,
        weights: [0.0; MAX_ORDER],
        object: 0,
    };

    /// A sphere of no body that stands for itself.
    pub fn new(sphere: Sphere) -> Self {
        Self {
            center: sphere.center,
            radius: sphere.radius,
            weights: [1.0; MAX_ORDER],
            object: 0,
        }
    }

    /// A node of a tree with the weight of a leaf.
    pub fn of(node: &Node) -> Self {
        Self {
            center: node.center,
            radius: node.radius,
            weights: [node.weight; MAX_ORDER],
            object: node.object,
        }
    }
}

/// How coarse a cut may be, as sines of angular radii.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// A node below this over the whole cluster stands for its leaves (θ_max of equation 36). 0: only leaves do.
    pub sin_max: f32,
    /// A node below this, seen from the cluster's centre, is not looked into when its leaves' visibility is summed
    /// up for a ratio vector (θ_min): it counts as a cap of their joint cross-section.
    pub sin_min: f32,
}

impl Limits {
    /// Angular radii of 25° and 1.5°. The paper takes 20° to 30° for the first.
    ///
    /// ```
    /// assert!(sh_scene::Limits::default().sin_max < 0.5);
    /// ```
    pub fn new(theta_max: f32, theta_min: f32) -> Self {
        Self {
            sin_max: theta_max.sin(),
            sin_min: theta_min.sin(),
        }
    }

    /// No hierarchy: every leaf is in every cut.
    pub const LEAVES: Self = Self {
        sin_max: 0.0,
        sin_min: 0.0,
    };
}

impl Default for Limits {
    fn default() -> Self {
        Self::new(25.0_f32.to_radians(), 1.5_f32.to_radians())
    }
}
