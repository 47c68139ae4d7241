//! Scenes that move: where everything is at a time.
//!
//! ```text
//! keys  ─────────────────────────────────> an object's transform
//! clip ──> skeleton ──> bones ──> skin ──> a mesh's positions and normals
//!                         └────> anchors > its spheres' centres, and their surface points
//! rate ──────────────────────────────────> the environment's turn
//! ```
//!
//! [`Motion::pose`] is a function of time alone: what it starts from (rest positions, the environment before
//! it turns) is kept here and never written, so that a frame has the same bits whatever came before it. A
//! steady frame allocates nothing. Nothing here reads a file: tracks, skeletons and skins can be made by code.
//!
//! ```
//! use glam::{Quat, Vec3};
//! use sh_scene::motion::{Keys, Motion, Place};
//!
//! let place = |x: f32| Place { translation: Vec3::X * x, rotation: Quat::IDENTITY, scale: 1.0 };
//! let there_and_back = Keys::new(vec![(0.0, place(0.0)), (1.0, place(2.0)), (2.0, place(0.0))], true)?;
//! let mut motion = Motion::default();
//! motion.add_keys(0..1, there_and_back.clone());
//! assert_eq!(there_and_back.at(4.5).translation.x, 1.0);
//! assert_eq!(motion.period(), 2.0);
//! # Ok::<(), sh_scene::motion::MotionError>(())
//! ```

mod anchors;
mod keys;
mod rig;
mod skeleton;
mod skin;
mod surface;
mod track;
mod turn;

pub use anchors::{Anchor, Anchors};
pub use keys::{Keys, Place};
pub use rig::{Pose, Rig};
pub use skeleton::{Bone, Clip, Joint, JointTracks, Skeleton, Trs};
pub use skin::{Influences, Skin};
pub use track::{Interpolation, Track, Value};

use crate::{EnvironmentMap, Object, Scene};
use std::ops::Range;
use std::sync::Arc;
use surface::Surface;

/// Why something cannot move. The messages tell what is wrong and have no full stop.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MotionError {
    /// A track or a list of keys without a key.
    #[error("there are no keys, and at least one is needed")]
    Empty,
    /// Not as many values as the times call for.
    #[error("there are {values} values for {times} times, but {expected} are needed")]
    Count {
        /// How many times there are.
        times: usize,
        /// How many values there are.
        values: usize,
        /// How many there have to be.
        expected: usize,
    },
    /// A time that does not come after the one before it.
    #[error(
        "key {key} is at {time} seconds, but times have to be finite, not below 0, and each above the one before"
    )]
    Time {
        /// Which key, from 0.
        key: usize,
        /// Its time, in seconds.
        time: f32,
    },
    /// A value that is infinite, not a number, or a rotation of length zero.
    #[error(
        "key {key} has {value}, but values have to be finite, and rotations quaternions other than zero"
    )]
    Value {
        /// Which key, from 0.
        key: usize,
        /// The value.
        value: String,
    },
    /// A joint whose parent comes after it, or does not exist.
    #[error(
        "joint {joint} has the parent {parent}, but parents have to come before their children"
    )]
    Parent {
        /// Which joint.
        joint: usize,
        /// What it names.
        parent: u32,
    },
    /// Something that names a bone or joint that is not there.
    #[error("{what} {index} is named, but there are {count}")]
    Missing {
        /// What is missing: "bone".
        what: &'static str,
        /// Which is named.
        index: u32,
        /// How many there are.
        count: usize,
    },
    /// Lists that have to be equally long and are not.
    #[error("there are {found} {what} for {expected} vertices")]
    Length {
        /// What there are too few or too many of.
        what: &'static str,
        /// How many there are.
        found: usize,
        /// How many there have to be.
        expected: usize,
    },
}

/// An environment that turns about +Y at an even rate.
#[derive(Clone, Debug)]
struct Turn {
    /// As it is before any turn.
    rest: EnvironmentMap,
    /// Radians at time 0.
    start: f64,
    /// Radians a second.
    rate: f64,
}

/// A rig and the first of the objects that it moves.
#[derive(Clone, Debug)]
struct Rigged {
    first: usize,
    rig: Arc<Rig>,
    /// The object's surface samples at rest, if it has any.
    surface: Option<Surface>,
}

/// How a scene moves. The default moves nothing and costs nothing.
#[derive(Clone, Debug, Default)]
pub struct Motion {
    keys: Vec<(Range<usize>, Keys)>,
    rigs: Vec<Rigged>,
    turn: Option<Turn>,
    /// Room for a rig's matrices.
    pose: Pose,
}

impl Motion {
    /// Moves these of the scene's objects along keys, all alike.
    pub fn add_keys(&mut self, objects: Range<usize>, keys: Keys) {
        self.keys.push((objects, keys));
    }

    /// Lets a rig move meshes and spheres of the scene's objects from `first` on, one for each of its skins.
    pub fn add_rig(&mut self, first: usize, rig: Arc<Rig>) {
        self.rigs.push(Rigged {
            first,
            rig,
            surface: None,
        });
    }

    /// Lets the surface samples of objects that rigs move go along with their spheres. They are taken as they are now:
    /// sampled where the rigs' skeletons rest, without a clip, with the spheres where they are then.
    pub fn add_surfaces(&mut self, objects: &[Object]) {
        for Rigged {
            first,
            rig,
            surface,
        } in &mut self.rigs
        {
            let object = objects.get(*first).filter(|o| !o.surface.is_empty());
            *surface = object.map(|object| {
                self.pose.set(rig.skeleton(), rig.bones(), None);
                Surface::new(object, rig.anchors(), self.pose.bones())
            });
        }
    }

    /// Turns the environment: `rest` by `start` radians at time 0, and by `rate` radians more each second,
    /// counter-clockwise seen from above.
    pub fn turn_environment(&mut self, rest: EnvironmentMap, start: f64, rate: f64) {
        self.turn = Some(Turn { rest, start, rate });
    }

    /// Whether nothing moves.
    pub fn is_still(&self) -> bool {
        self.keys.is_empty() && self.rigs.is_empty() && self.turn.is_none()
    }

    /// Whether meshes change their shape, and with it more than transforms and spheres.
    pub fn bends(&self) -> bool {
        !self.rigs.is_empty()
    }

    /// Whether the environment turns.
    pub fn turns(&self) -> bool {
        self.turn.is_some()
    }

    /// The turn of the environment at a time, in radians from its rest; none where it does not turn.
    pub fn environment_angle(&self, seconds: f64) -> Option<f64> {
        let turn = self.turn.as_ref()?;
        Some((turn.start + turn.rate * finite(seconds)).rem_euclid(std::f64::consts::TAU))
    }

    /// The longest time, in seconds, that keys or a clip take; 0 where there are none.
    pub fn period(&self) -> f64 {
        let keys = self.keys.iter().map(|(_, keys)| keys.duration());
        let clips = self.rigs.iter().map(|r| r.rig.clip().duration());
        keys.chain(clips).map(f64::from).fold(0.0, f64::max)
    }

    /// Puts `scene` into the state that it has at a time: objects' transforms, meshes' positions and normals,
    /// spheres' centres and surface points, the environment. What does not move is not touched. The result depends on the time
    /// alone; one that is not finite counts as 0.
    ///
    /// `scene` is the one that this motion was made for; objects that it lacks are passed over.
    pub fn pose(&mut self, seconds: f64, scene: &mut Scene) {
        let seconds = finite(seconds);
        for (range, keys) in &self.keys {
            let transform = keys.at(seconds);
            let objects = scene.objects.iter_mut().take(range.end);
            for object in objects.skip(range.start) {
                object.transform = transform;
            }
        }
        for Rigged {
            first,
            rig,
            surface,
        } in &self.rigs
        {
            let Some(objects) = scene.objects.get_mut(*first..) else {
                continue;
            };
            rig.pose(seconds, &mut self.pose, objects);
            if let (Some(surface), Some(object)) = (surface, objects.first_mut()) {
                let (spheres, samples) = (&object.spheres, &mut object.surface);
                surface.pose(rig.anchors(), self.pose.bones(), spheres, samples);
            }
        }
        if let Some(angle) = self.environment_angle(seconds)
            && let Some(turn) = &self.turn
        {
            turn.rest.rotated_into(angle as f32, &mut scene.environment);
        }
    }
}

fn finite(seconds: f64) -> f64 {
    if seconds.is_finite() { seconds } else { 0.0 }
}
