//! What a mesh file holds.

use glam::Vec3;
use sh_scene::motion::{Bone, Clip, Skeleton, Skin};
use sh_scene::{Material, Mesh, PunctualLight};

/// A mesh and what it looks like.
#[derive(Clone, Debug)]
pub struct Part {
    /// The file's own name for it, or empty.
    pub name: String,
    /// The surface, in the file's space.
    pub mesh: Mesh,
    /// How it reflects.
    pub material: Material,
}

/// What a mesh file holds.
#[derive(Clone, Debug)]
pub struct Model {
    /// Its parts, one for each material; at least one.
    pub parts: Vec<Part>,
    /// What moves the parts; none where the file has no animations.
    pub figure: Option<Figure>,
    /// Its cameras, in its space.
    pub cameras: Vec<ModelCamera>,
    /// Its lights, in its space.
    pub lights: Vec<PunctualLight>,
    /// What was wrong with the file and has been put right: sentences that name the file.
    pub warnings: Vec<String>,
}

/// A camera of a mesh file.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelCamera {
    /// Its name, or that of its node, or empty.
    pub name: String,
    /// Where it is, in metres.
    pub eye: Vec3,
    /// The unit vector that it looks along.
    pub ahead: Vec3,
    /// Its vertical field of view, in radians.
    pub fov: f32,
}

/// What moves a model, and all the ways in which it can.
#[derive(Clone, Debug)]
pub struct Figure {
    /// The file's nodes.
    pub skeleton: Skeleton,
    /// What carries vertices.
    pub bones: Vec<Bone>,
    /// The vertices of each of the model's parts at rest.
    pub skins: Vec<Skin>,
    /// The file's animations, in its order; at least one.
    pub clips: Vec<Clip>,
}
