//! Meshes from files: one entrance for every format.

use crate::error::{Error, read};
use crate::model::Model;
use crate::{gltf, obj};
use std::path::Path;

/// Loads a mesh file, glTF (.gltf, .glb) or Wavefront OBJ by the ending of its name.
///
/// Of glTF, all triangle meshes of the default scene are taken with their nodes' transforms, in the pose the
/// nodes are in, with base colour factor, texture and vertex colours (COLOR_0); where the file has animations, these and what they move
/// too ([`crate::Figure`]), but for morph targets. Of OBJ, faces are cut into triangles and material
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
    let gltf::Loaded {
        parts: raw,
        figure,
        cameras,
        lights,
        mut warnings,
    } = match ending.as_str() {
        "gltf" | "glb" => gltf::load(path, &read(path)?)?,
        "obj" => gltf::Loaded {
            parts: vec![obj::load(path, &read(path)?)?],
            figure: None,
            cameras: Vec::new(),
            lights: Vec::new(),
            warnings: Vec::new(),
        },
        _ => {
            return Err(Error::Format {
                path: path.into(),
                known: ".gltf, .glb and .obj",
            });
        }
    };
    let total: usize = raw.iter().map(|part| part.triangles.len()).sum();
    let (mut parts, mut binds) = (Vec::new(), Vec::new());
    for part in raw {
        if let Some((part, bind)) = part.finish(path, &mut warnings)? {
            parts.push(part);
            binds.extend(bind);
        }
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
    let figure = figure
        .map(|figure| figure.finish(&parts, binds))
        .transpose()
        .map_err(|e| Error::file(path, format!("the glTF is damaged: {e}.")))?;
    Ok(Model {
        parts,
        figure,
        cameras,
        lights,
        warnings,
    })
}
