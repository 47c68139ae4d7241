//! Skeleton, clip, skins and spheres: all that moves a model.

use super::{Anchors, Bone, Clip, MotionError, Skeleton, Skin};
use crate::Object;
use glam::Affine3A;

/// A skinned model in motion: a skin for each of its meshes, and the spheres of all of them, which are those
/// of the first.
#[derive(Clone, Debug)]
pub struct Rig {
    skeleton: Skeleton,
    bones: Vec<Bone>,
    clip: Clip,
    skins: Vec<Skin>,
    /// Whether the clip moves each skin at all.
    moved: Vec<bool>,
    anchors: Anchors,
}

/// Room for the matrices of a pose, used again from frame to frame.
#[derive(Clone, Debug, Default)]
pub struct Pose {
    joints: Vec<Affine3A>,
    bones: Vec<Affine3A>,
}

impl Pose {
    /// Computes the bones, root from mesh each: at rest, or `seconds` into a clip.
    pub fn set(&mut self, skeleton: &Skeleton, bones: &[Bone], clip: Option<(&Clip, f64)>) {
        skeleton.pose(clip, &mut self.joints);
        self.bones.clear();
        let matrices = bones.iter().map(|bone| bone.matrix(&self.joints));
        self.bones.extend(matrices);
    }

    /// The bones that were computed last.
    pub fn bones(&self) -> &[Affine3A] {
        &self.bones
    }
}

impl Rig {
    /// A model that moves. Skins and anchors name bones, and bones and clips joints.
    ///
    /// # Errors
    /// Where one of them names what is not there.
    pub fn new(
        skeleton: Skeleton,
        bones: Vec<Bone>,
        clip: Clip,
        skins: Vec<Skin>,
        anchors: Anchors,
    ) -> Result<Self, MotionError> {
        let missing = |what, index, count| MotionError::Missing { what, index, count };
        let joints = skeleton.joints().len();
        let named = bones.iter().filter_map(|bone| bone.joint);
        let named = named.chain(clip.tracks().iter().map(|tracks| tracks.joint));
        if let Some(joint) = named.into_iter().find(|joint| *joint as usize >= joints) {
            return Err(missing("joint", joint, joints));
        }
        anchors.check(bones.len())?;
        let joints = skeleton.moved(&clip);
        let mut moved = Vec::with_capacity(skins.len());
        for skin in &skins {
            let mut any = false;
            for bone in skin.bones() {
                let Some(found) = bones.get(bone as usize) else {
                    return Err(missing("bone", bone, bones.len()));
                };
                any |= found.joint.is_some_and(|joint| joints[joint as usize]);
            }
            moved.push(any);
        }
        Ok(Self {
            skeleton,
            bones,
            clip,
            skins,
            moved,
            anchors,
        })
    }

    /// What moves it.
    pub fn clip(&self) -> &Clip {
        &self.clip
    }

    /// The joints.
    pub fn skeleton(&self) -> &Skeleton {
        &self.skeleton
    }

    /// What carries vertices and spheres.
    pub fn bones(&self) -> &[Bone] {
        &self.bones
    }

    /// What holds the spheres.
    pub fn anchors(&self) -> &Anchors {
        &self.anchors
    }

    /// The skins, one for each object.
    pub fn skins(&self) -> &[Skin] {
        &self.skins
    }

    /// Computes the bones at a time, in seconds.
    pub fn set(&self, seconds: f64, pose: &mut Pose) {
        pose.set(&self.skeleton, &self.bones, Some((&self.clip, seconds)));
    }

    /// Puts objects' meshes, one for each skin, and the first one's spheres to where they are at a time.
    /// Meshes that the clip does not move are left alone.
    pub fn pose(&self, seconds: f64, pose: &mut Pose, objects: &mut [Object]) {
        self.set(seconds, pose);
        if let Some(first) = objects.first_mut() {
            self.anchors.pose(&pose.bones, &mut first.spheres);
        }
        let skins = self.skins.iter().zip(&self.moved);
        for ((skin, _), object) in skins.zip(objects).filter(|((_, moved), _)| **moved) {
            skin.pose(&pose.bones, &mut object.mesh);
        }
    }
}
