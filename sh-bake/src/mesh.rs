//! Meshes from files: one entrance for every format, and the checks that all of them go through.

use crate::error::{Error, read, shown};
use crate::{gltf, normals, obj};
use glam::{DVec3, Vec3};
use sh_scene::{Material, Mesh};
use std::path::Path;

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
    /// What was wrong with the file and has been put right: sentences that name the file.
    pub warnings: Vec<String>,
}

/// Coordinates beyond this are taken as damage: squares and volumes of them would leave `f32`.
const FARTHEST: f32 = 1e9;

/// Loads a mesh file, glTF (.gltf, .glb) or Wavefront OBJ by the ending of its name.
///
/// Of glTF, all triangle meshes of the default scene are taken with their nodes' transforms, in the pose the
/// nodes are in, with base colour factor and texture. Of OBJ, faces are cut into triangles and material
/// libraries are not read. Missing normals are computed: smooth, but for creases of more than 60°.
///
/// # Errors
/// Where the file cannot be read, is damaged, needs an extension that is not known, or holds no triangle.
pub fn load_mesh(path: &Path) -> Result<Model, Error> {
    let ending = path
        .extension()
        .and_then(|e| e.to_str())
        .unwrap_or("")
        .to_ascii_lowercase();
    let (raw, mut warnings) = match ending.as_str() {
        "gltf" | "glb" => gltf::load(path, &read(path)?)?,
        "obj" => (vec![obj::load(path, &read(path)?)?], Vec::new()),
        _ => {
            return Err(Error::Format {
                path: path.into(),
                known: ".gltf, .glb and .obj",
            });
        }
    };
    let total: usize = raw.iter().map(|part| part.triangles.len()).sum();
    let mut parts = Vec::new();
    for part in raw {
        parts.extend(part.finish(path, &mut warnings)?);
    }
    if parts.is_empty() {
        return Err(Error::file(
            path,
            match total {
                0 => "the file has no triangles.".to_string(),
                n => format!(
                    "the file has no triangle with an area: all {n} have their corners on a line."
                ),
            },
        ));
    }
    Ok(Model { parts, warnings })
}

/// A part as a file gives it, not yet checked.
pub(crate) struct RawPart {
    pub(crate) name: String,
    pub(crate) positions: Vec<[f32; 3]>,
    /// As many as positions, or none.
    pub(crate) normals: Vec<[f32; 3]>,
    /// As many as positions, or none.
    pub(crate) uvs: Vec<[f32; 2]>,
    pub(crate) triangles: Vec<[u32; 3]>,
    pub(crate) material: Material,
}

impl RawPart {
    /// The part with everything checked and made whole; none where it has no triangle with an area.
    fn finish(mut self, path: &Path, warnings: &mut Vec<String>) -> Result<Option<Part>, Error> {
        let what = if self.name.is_empty() {
            String::new()
        } else {
            format!("{}: ", self.name)
        };
        for t in &self.triangles {
            for &i in t {
                let Some(p) = self.positions.get(i as usize) else {
                    let count = self.positions.len();
                    let message = format!("{what}vertex index {i} is out of range 0..{count}.");
                    return Err(Error::file(path, message));
                };
                if let Some(c) = p.iter().find(|c| !c.is_finite() || c.abs() > FARTHEST) {
                    let message = format!(
                        "{what}the position of vertex {i} has a coordinate {c}, and coordinates have to be \
                         finite and within ±{FARTHEST:e}.",
                    );
                    return Err(Error::file(path, message));
                }
            }
        }
        let before = self.triangles.len();
        self.triangles = with_area(&self.positions, &self.triangles);
        let dropped = before - self.triangles.len();
        if dropped > 0 {
            let display = shown(path);
            warnings.push(format!(
                "{display}: {what}{dropped} of {before} triangles have no area and were left out."
            ));
        }
        if self.triangles.is_empty() {
            return Ok(None);
        }

        let good = |n: &[f32; 3]| (0.25..4.0).contains(&Vec3::from(*n).length_squared());
        let given = self.normals.len() == self.positions.len();
        if given
            && self
                .triangles
                .iter()
                .flatten()
                .all(|&i| good(&self.normals[i as usize]))
        {
            for n in &mut self.normals {
                *n = Vec3::from(*n).normalize_or(Vec3::Y).to_array();
            }
        } else {
            if given {
                let display = shown(path);
                warnings.push(format!(
                    "{display}: {what}some normals are no unit vectors; all were computed anew."
                ));
            }
            let smoothed = normals::smooth(&self.positions, &self.triangles);
            let taken = |i: &u32| *i as usize;
            self.positions = smoothed
                .source
                .iter()
                .map(|i| self.positions[taken(i)])
                .collect();
            if !self.uvs.is_empty() {
                self.uvs = smoothed.source.iter().map(|i| self.uvs[taken(i)]).collect();
            }
            (self.normals, self.triangles) = (smoothed.normals, smoothed.triangles);
        }
        let mesh = Mesh {
            positions: self.positions,
            normals: self.normals,
            uvs: self.uvs,
            triangles: self.triangles,
        };
        Ok(Some(Part {
            name: self.name,
            mesh,
            material: self.material,
        }))
    }
}

/// The triangles that have an area: their height over the longest edge is more than a billionth of it.
pub(crate) fn with_area(positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let has_area = |t: &&[u32; 3]| {
        let [a, b, c] = t.map(|i| DVec3::from(positions[i as usize].map(f64::from)));
        let longest = a
            .distance_squared(b)
            .max(b.distance_squared(c))
            .max(c.distance_squared(a));
        (b - a).cross(c - a).length() > 1e-9 * longest
    };
    triangles.iter().filter(has_area).copied().collect()
}
