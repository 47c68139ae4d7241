//! What a scene file says of an object.

use crate::error::{Error, file_name};
use crate::indirect;
use crate::keys::{FAR, Section, Source, albedo, beside};

use glam::{EulerRot, Quat, Vec3};
use sh_scene::motion::{Keys, Place};
use sh_scene::{Finish, Material, Method};
use std::ops::Range;
use std::path::{Path, PathBuf};
use toml::de::DeTable;

/// One of `[[objects]]`.
pub(crate) struct ObjectEntry {
    pub(crate) mesh: PathBuf,
    /// What lights call it, if not by its file's name.
    pub(crate) name: Option<String>,
    /// Spheres that block light in its place, at most; 0: it blocks none.
    pub(crate) spheres: usize,
    /// By what it sends light on, if not as the scene has it.
    pub(crate) method: Option<Method>,
    /// Whether the lights of its file are in the scene.
    pub(crate) lights: bool,
    pub(crate) place: Place,
    pub(crate) albedo: Option<[f32; 3]>,
    pub(crate) roughness: Option<f32>,
    pub(crate) metallic: Option<f32>,
    pub(crate) clip: Option<ClipName>,
    pub(crate) keys: Option<Keys>,
}

/// A clip, by name or number, and the line that asks for it.
pub(crate) struct ClipName {
    pub(crate) name: String,
    pub(crate) line: usize,
}

/// Spheres for an object that does not say how many: with weights more gain little at the default order, and cost a frame as
/// much again (docs/SPHERES.md).
const SPHERES: usize = 32;

impl ObjectEntry {
    /// A mesh of which nothing else is said.
    pub(crate) fn of_mesh(path: &Path) -> Self {
        Self {
            mesh: path.to_path_buf(),
            name: None,
            spheres: SPHERES,
            method: None,
            lights: true,
            place: REST,
            albedo: None,
            roughness: None,
            metallic: None,
            clip: None,
            keys: None,
        }
    }

    /// Reads one of `[[objects]]`.
    pub(crate) fn read<'a>(
        source: Source<'a>,
        span: Range<usize>,
        table: &'a DeTable<'a>,
    ) -> Result<Self, Error> {
        let known = [
            "mesh",
            "name",
            "blockers",
            "spheres",
            "method",
            "lights",
            "translate",
            "rotate",
            "scale",
            "albedo",
            "roughness",
            "metallic",
            "clip",
            "keys",
            "repeat",
        ];
        let s = Section::new(source, "objects", span, table, &known)?;
        let Some(mesh) = s.string("mesh")? else {
            return Err(s.error("mesh", "is missing: it names the object's mesh file."));
        };
        let place = place(&s, REST)?;
        let clip = s.string_or_count("clip")?.map(|name| ClipName {
            name,
            line: s.line("clip"),
        });
        Ok(Self {
            mesh: beside(source.path, mesh),
            name: s.string("name")?.map(String::from),
            spheres: spheres(&s)?,
            method: indirect::method(&s)?,
            lights: s.boolean("lights")?.unwrap_or(true),
            place,
            albedo: albedo(&s)?,
            roughness: s.number("roughness", "from 0 to 1", |n| (0.0..=1.0).contains(&n))?,
            metallic: s.number("metallic", "from 0 to 1", |n| (0.0..=1.0).contains(&n))?,
            clip,
            keys: keys(&s, place)?,
        })
    }
}

impl ObjectEntry {
    /// A material of the mesh's file, where the scene says otherwise. What a texture of the file says of the finish is then left
    /// out, and of what the scene does not say the file's factor counts.
    pub(crate) fn material(&self, file: &Material) -> Material {
        let mut material = file.clone();
        material.albedo = self.albedo.unwrap_or(material.albedo);
        if self.roughness.is_some() || self.metallic.is_some() {
            let Finish {
                roughness,
                metallic,
            } = material.finish;
            material.finish_texture = None;
            material.finish = Finish {
                roughness: self.roughness.unwrap_or(roughness),
                metallic: self.metallic.unwrap_or(metallic),
            };
        }
        material
    }
}

/// How many spheres block light in an object's place: none of a wall that all others stand before.
fn spheres(s: &Section) -> Result<usize, Error> {
    let count = s.count("spheres", 1..=4096)?;
    match s.string("blockers")? {
        None | Some("spheres") => Ok(count.unwrap_or(SPHERES)),
        Some("none") if count.is_some() => Err(s.error(
            "spheres",
            "says how many block light in the object's place, but objects.blockers is \"none\".",
        )),
        Some("none") => Ok(0),
        Some(other) => {
            let message = format!("is \"{other}\", but it has to be \"spheres\" or \"none\".");
            Err(s.error("blockers", message))
        }
    }
}

/// Where an object stands that does not say.
const REST: Place = Place {
    translation: Vec3::ZERO,
    rotation: Quat::IDENTITY,
    scale: 1.0,
};

/// A place; what the section does not say is as in `rest`.
fn place(s: &Section, rest: Place) -> Result<Place, Error> {
    let translation = s.triple("translate", "of metres", false, |n| n.abs() < FAR)?;
    let rotation = s.triple("rotate", "of degrees", false, |n| n.abs() < FAR)?;
    let scale = s.number("scale", "above 0 and below 1e9", |n| n > 1e-9 && n < FAR)?;
    let rotation = rotation.map(|degrees| {
        let [x, y, z] = degrees.map(f32::to_radians);
        // About x first, so z is the outermost.
        Quat::from_euler(EulerRot::ZYX, z, y, x)
    });
    Ok(Place {
        translation: translation.map_or(rest.translation, Vec3::from),
        rotation: rotation.unwrap_or(rest.rotation),
        scale: scale.unwrap_or(rest.scale),
    })
}

/// Places over time; what a key does not say is as the object's own place.
fn keys(s: &Section, rest: Place) -> Result<Option<Keys>, Error> {
    let repeat = s.boolean("repeat")?;
    let Some(entries) = s.sections(
        "keys",
        "objects.keys",
        &["time", "translate", "rotate", "scale"],
    )?
    else {
        return match repeat {
            None => Ok(None),
            Some(_) => Err(s.error("repeat", "says whether keys repeat, but there are no keys.")),
        };
    };
    let mut keys = Vec::with_capacity(entries.len());
    for entry in &entries {
        let time = entry.number("time", "of seconds, not below 0", |n| {
            (0.0..FAR).contains(&n)
        })?;
        let Some(time) = time else {
            return Err(entry.error("time", "is missing: it is the key's time in seconds."));
        };
        if let Some((last, _)) = keys.last().filter(|(last, _)| *last >= time) {
            let message = format!(
                "is {time}, but keys come in the order of time, and one before is at {last}."
            );
            return Err(entry.error("time", message));
        }
        keys.push((time, place(entry, rest)?));
    }
    Keys::new(keys, repeat.unwrap_or(false))
        .map(Some)
        .map_err(|e| s.error("keys", format!("cannot be followed: {e}.")))
}

/// Which object a light is bound to.
pub(crate) fn bound(s: &Section, objects: &[ObjectEntry]) -> Result<Option<usize>, Error> {
    let Some(name) = s.string("object")? else {
        return Ok(None);
    };
    let called = |entry: &ObjectEntry| match &entry.name {
        Some(name) => name.clone(),
        None => file_name(&entry.mesh),
    };
    let names: Vec<String> = objects.iter().map(called).collect();
    let mut found = (0..names.len()).filter(|&i| names[i] == name);
    match (found.next(), found.next()) {
        (Some(index), None) => Ok(Some(index)),
        (Some(_), Some(_)) => {
            let message = format!(
                "is {name:?}, but several objects are called so: give one a name of its own, name = \"...\"."
            );
            Err(s.error("object", message))
        }
        (None, _) => {
            let names = names.join(", ");
            let message =
                format!("is {name:?}, but no object is called so; the objects are {names}.");
            Err(s.error("object", message))
        }
    }
}
