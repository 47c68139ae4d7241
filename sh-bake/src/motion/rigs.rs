//! Models that play clips, and the spheres that go along.

use super::choice::called;
use super::{bind_spheres, grow_spheres};
use crate::error::{Error, file_name};
use crate::{Figure, Model, SphereSet};
use sh_scene::motion::{Pose, Rig};
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::path::Path;
use std::sync::Arc;

/// A mesh file, how many spheres bound it, and the number of the clip it plays.
type Key<'a> = (&'a Path, usize, usize);

/// The rigs of a scene, each made once.
#[derive(Default)]
pub(crate) struct Rigs<'a> {
    known: BTreeMap<Key<'a>, Moving>,
}

/// A model that plays a clip.
pub(crate) struct Moving {
    pub(crate) rig: Arc<Rig>,
    /// Its spheres, which hold it in motion.
    pub(crate) set: SphereSet,
    /// What it plays, for a person.
    pub(crate) sentence: String,
}

impl<'a> Rigs<'a> {
    /// The model that plays a clip, given the spheres that bound it where it stands still.
    pub(crate) fn moving(
        &mut self,
        key: Key<'a>,
        model: &Model,
        figure: &Figure,
        set: &SphereSet,
    ) -> Result<&Moving, Error> {
        match self.known.entry(key) {
            Entry::Occupied(known) => Ok(known.into_mut()),
            Entry::Vacant(room) => {
                let (mesh, _, clip) = key;
                let moving = Moving::new(mesh, clip, model, figure, set);
                let moving = moving.map_err(|message| Error::file(mesh, message))?;
                Ok(room.insert(moving))
            }
        }
    }
}

impl Moving {
    /// The error is a sentence.
    fn new(
        mesh: &Path,
        number: usize,
        model: &Model,
        figure: &Figure,
        set: &SphereSet,
    ) -> Result<Self, String> {
        let mut set = set.clone();
        let before = volume(&set);
        let meshes: Vec<_> = model.parts.iter().map(|part| &part.mesh).collect();
        let mut still = Pose::default();
        still.set(&figure.skeleton, &figure.bones, None);
        let anchors = bind_spheres(&meshes, &figure.skins, still.bones(), &set.spheres);
        let rig = Rig::new(
            figure.skeleton.clone(),
            figure.bones.clone(),
            figure.clips[number].clone(),
            figure.skins.clone(),
            anchors,
        )
        .map_err(|e| format!("the clip cannot be played: {e}."))?;
        grow_spheres(&rig, &meshes, &mut set.spheres)?;

        let grown = 100.0 * (volume(&set) / before.max(f64::MIN_POSITIVE) - 1.0);
        let (name, clip) = (file_name(mesh), rig.clip());
        let (called, seconds) = (called(number, clip), clip.duration());
        let sentence = format!(
            "{name} plays its clip {called}, which takes {seconds:.3} s; to hold it, its spheres are larger by \
             {grown:.0} % of their volume."
        );
        Ok(Self {
            rig: Arc::new(rig),
            set,
            sentence,
        })
    }
}

/// What spheres take of space, but for a factor, overlaps counted as often as they come.
fn volume(set: &SphereSet) -> f64 {
    let cubes = set.spheres.iter().map(|s| f64::from(s.radius).powi(3));
    cubes.sum()
}
