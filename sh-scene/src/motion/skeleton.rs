//! Trees of joints and what moves them.

use super::{MotionError, Track};
use glam::{Affine3A, Quat, Vec3};

/// A joint of a tree: any node that carries others, a mesh, or a part of a skin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// The joint it hangs on, which comes before it; none for a root.
    pub parent: Option<u32>,
    /// Parent from joint, where nothing moves it.
    pub local: Affine3A,
}

/// Joints, parents before children.
#[derive(Clone, Debug, Default)]
pub struct Skeleton {
    joints: Vec<Joint>,
}

/// A transform in parts: scaled first, then turned, then moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trs {
    /// In metres.
    pub translation: Vec3,
    /// A unit quaternion.
    pub rotation: Quat,
    /// Along each axis.
    pub scale: Vec3,
}

/// What moves one joint. Parts of its transform without a track stay as they are at rest.
#[derive(Clone, Debug)]
pub struct JointTracks {
    /// Which joint.
    pub joint: u32,
    /// Its local transform at rest.
    pub rest: Trs,
    /// Translation over time.
    pub translation: Option<Track<Vec3>>,
    /// Rotation over time.
    pub rotation: Option<Track<Quat>>,
    /// Scale over time.
    pub scale: Option<Track<Vec3>>,
}

/// A motion of a skeleton, which begins anew where it ends.
#[derive(Clone, Debug, Default)]
pub struct Clip {
    /// What it is called, or empty.
    pub name: String,
    tracks: Vec<JointTracks>,
    duration: f32,
}

/// What carries vertices: a joint, and where the vertices were when they were bound to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bone {
    /// The joint; none stays in the origin.
    pub joint: Option<u32>,
    /// Joint from mesh in the pose of binding.
    pub inverse_bind: Affine3A,
}

impl Skeleton {
    /// A tree of joints.
    ///
    /// # Errors
    /// Where a joint's parent does not come before it.
    pub fn new(joints: Vec<Joint>) -> Result<Self, MotionError> {
        for (joint, Joint { parent, .. }) in joints.iter().enumerate() {
            if let Some(parent) = parent.filter(|parent| *parent as usize >= joint) {
                return Err(MotionError::Parent { joint, parent });
            }
        }
        Ok(Self { joints })
    }

    /// The joints, parents before children.
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// Writes root from joint of every joint to `world`: at rest, or `seconds` into a clip.
    pub fn pose(&self, clip: Option<(&Clip, f64)>, world: &mut Vec<Affine3A>) {
        world.clear();
        world.extend(self.joints.iter().map(|joint| joint.local));
        if let Some((clip, seconds)) = clip {
            let seconds = clip.wrapped(seconds);
            for tracks in &clip.tracks {
                if let Some(local) = world.get_mut(tracks.joint as usize) {
                    *local = tracks.at(seconds);
                }
            }
        }
        for (i, joint) in self.joints.iter().enumerate() {
            if let Some(parent) = joint.parent {
                world[i] = world[parent as usize] * world[i];
            }
        }
    }

    /// Whether a clip moves each joint, by itself or by what it hangs on.
    pub fn moved(&self, clip: &Clip) -> Vec<bool> {
        let mut moved = vec![false; self.joints.len()];
        for tracks in &clip.tracks {
            if let Some(moved) = moved.get_mut(tracks.joint as usize) {
                *moved = true;
            }
        }
        for (i, joint) in self.joints.iter().enumerate() {
            moved[i] |= joint.parent.is_some_and(|parent| moved[parent as usize]);
        }
        moved
    }
}

impl JointTracks {
    fn at(&self, seconds: f32) -> Affine3A {
        let Trs {
            translation,
            rotation,
            scale,
        } = self.rest;
        let translation = self
            .translation
            .as_ref()
            .map_or(translation, |t| t.at(seconds));
        let rotation = self.rotation.as_ref().map_or(rotation, |t| t.at(seconds));
        let scale = self.scale.as_ref().map_or(scale, |t| t.at(seconds));
        Affine3A::from_scale_rotation_translation(scale, rotation, translation)
    }

    fn duration(&self) -> f32 {
        let translation = self.translation.as_ref().map_or(0.0, Track::duration);
        let rotation = self.rotation.as_ref().map_or(0.0, Track::duration);
        let scale = self.scale.as_ref().map_or(0.0, Track::duration);
        translation.max(rotation).max(scale)
    }
}

impl Clip {
    /// A clip as long as its longest track.
    pub fn new(name: String, tracks: Vec<JointTracks>) -> Self {
        let duration = tracks.iter().map(JointTracks::duration).fold(0.0, f32::max);
        Self {
            name,
            tracks,
            duration,
        }
    }

    /// How long it takes, in seconds.
    pub fn duration(&self) -> f32 {
        self.duration
    }

    /// What moves which joint.
    pub fn tracks(&self) -> &[JointTracks] {
        &self.tracks
    }

    /// The time within the clip that a time of the scene is.
    fn wrapped(&self, seconds: f64) -> f32 {
        match self.duration > 0.0 {
            true => seconds.rem_euclid(f64::from(self.duration)) as f32,
            false => 0.0,
        }
    }
}

impl Bone {
    /// Root from mesh, given the joints as [`Skeleton::pose`] writes them.
    pub fn matrix(&self, world: &[Affine3A]) -> Affine3A {
        let joint = self.joint.and_then(|joint| world.get(joint as usize));
        joint.map_or(self.inverse_bind, |joint| *joint * self.inverse_bind)
    }
}
