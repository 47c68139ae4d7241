//! Which clip an object plays.

use crate::error::{Error, file_name, one_line};
use crate::scene_file::SceneFile;
use crate::{Figure, Model};
use sh_scene::motion::Clip;
use std::collections::BTreeMap;
use std::path::Path;

/// Which clip moves a mesh file that is loaded by itself, as a scene's only object. Scene files say it for each
/// object.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ClipChoice<'a> {
    /// None: the mesh stands still, in the pose its nodes are in.
    #[default]
    None,
    /// The file's first one, if it has any.
    First,
    /// The one of this name, or, where none is called so, of this number, counted from 0.
    Named(&'a str),
}

/// The number of the clip that each object plays, if it does.
pub(crate) fn clips(
    path: &Path,
    file: &SceneFile,
    models: &BTreeMap<&Path, Model>,
    choice: ClipChoice,
) -> Result<Vec<Option<usize>>, Error> {
    let mut clips = Vec::with_capacity(file.objects.len());
    for entry in &file.objects {
        let figure = models[entry.mesh.as_path()].figure.as_ref();
        clips.push(match (&entry.clip, choice) {
            (Some(clip), _) => {
                let found = find(figure, &clip.name).map_err(|message| Error::Scene {
                    path: path.to_path_buf(),
                    line: clip.line,
                    message: one_line(&format!("{}: {message}", file_name(&entry.mesh))),
                });
                Some(found?)
            }
            (None, ClipChoice::Named(name)) => {
                let found = find(figure, name);
                Some(found.map_err(|message| Error::file(&entry.mesh, message))?)
            }
            (None, ClipChoice::First) if file.of_mesh => figure.map(|_| 0),
            (None, _) => None,
        });
    }
    Ok(clips)
}

/// The number of the clip with this name, or this number. The error is the end of a sentence.
fn find(figure: Option<&Figure>, name: &str) -> Result<usize, String> {
    let clips = figure.map_or(&[][..], |figure| &figure.clips);
    let by_name = clips.iter().position(|clip| clip.name == name);
    let by_number = || name.parse().ok().filter(|number| *number < clips.len());
    by_name.or_else(by_number).ok_or_else(|| {
        if clips.is_empty() {
            return format!("there is no clip `{name}`: the file has none.");
        }
        let called = clips.iter().enumerate().map(|(i, clip)| called(i, clip));
        let called: Vec<String> = called.collect();
        let called = called.join(", ");
        format!("there is no clip `{name}`; the file has {called}.")
    })
}

/// What messages call a clip: by its name, or its number where it has none.
pub(super) fn called(number: usize, clip: &Clip) -> String {
    match &clip.name[..] {
        "" => number.to_string(),
        name => format!("`{name}`"),
    }
}
