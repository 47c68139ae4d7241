//! What the fuzz targets share: the way of bytes to a loader that takes a path, and what loaders promise.
//!
//! | target | what it feeds |
//! |---|---|
//! | `scene` | scene files, [`sh_bake::load_scene`], as far as their meshes, which are missing |
//! | `gltf`, `obj` | mesh files, [`load_mesh`] |
//! | `hdr`, `exr` | environment maps, [`load_environment`] |
//! | `texture` | PNG and JPEG, as the base colour of a glTF triangle |
//! | `whole` | scenes of odd meshes at odd places, loaded to the end, sphere fitting included |
//! | `eval` | a line of `gaunt eval`, in double and in single precision |
//!
//! Bad input is answered in a sentence. A panic, an abort, more memory or time than the limits in `fuzz/run`, or
//! an answer that is not what is promised below, is a finding.

use sh_bake::{Error, Figure, Model, load_environment, load_mesh};
use sh_scene::EnvironmentMap;
use sh_scene::motion::Pose;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// A file of these bytes, in a folder that is this process's own and has nothing else in it but what the
/// target puts there.
pub fn file(name: &str, bytes: &[u8]) -> PathBuf {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    let folder = FOLDER.get_or_init(|| {
        let folder = std::env::temp_dir().join(format!("gaunt-fuzz-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("the folder for temporary files can be written");
        folder
    });
    let path = folder.join(name);
    std::fs::write(&path, bytes).expect("the folder for temporary files can be written");
    path
}

/// Poses a model by all its clips.
fn play(figure: &Figure, model: &Model) {
    assert_eq!(figure.skins.len(), model.parts.len());
    let mut pose = Pose::default();
    for clip in &figure.clips {
        for seconds in [0.0, 0.3, 1e9] {
            pose.set(&figure.skeleton, &figure.bones, Some((clip, seconds)));
            for (skin, part) in figure.skins.iter().zip(&model.parts) {
                let mut mesh = part.mesh.clone();
                assert_eq!(skin.len(), mesh.positions.len());
                skin.pose(pose.bones(), &mut mesh);
            }
        }
    }
}

/// Checks that an error is a sentence on one line.
pub fn check_error(error: &Error) {
    let message = error.to_string();
    assert!(message.ends_with(['.', '?']), "no sentence: {message}");
    assert!(
        !message.contains(char::is_control),
        "more than a line: {message:?}"
    );
}

/// Checks that an error begins with the path of the file, besides.
fn check_error_of(path: &Path, error: &Error) {
    check_error(error);
    let message = error.to_string();
    assert!(
        message.starts_with(&*path.to_string_lossy()),
        "the file is not named: {message}"
    );
}

/// Loads a mesh file and checks what comes of it.
pub fn mesh(path: &Path) {
    match load_mesh(path) {
        Ok(model) => check_model(&model),
        Err(error) => check_error_of(path, &error),
    }
}

/// Checks what everything that takes a mesh counts on.
pub fn check_model(model: &Model) {
    assert!(!model.parts.is_empty());
    for part in &model.parts {
        let mesh = &part.mesh;
        let count = mesh.positions.len();
        assert!(!mesh.triangles.is_empty());
        assert_eq!(mesh.normals.len(), count);
        assert!(mesh.uvs.is_empty() || mesh.uvs.len() == count);
        for &i in mesh.triangles.iter().flatten() {
            let (p, n) = (mesh.positions[i as usize], mesh.normals[i as usize]);
            assert!(p.iter().all(|c| c.is_finite()), "a position is {p:?}");
            let length = n.iter().map(|c| c * c).sum::<f32>().sqrt();
            assert!((length - 1.0).abs() < 1e-3, "a normal is {n:?}");
        }
        assert!(mesh.uvs.iter().flatten().all(|c| c.is_finite()));
        let albedo = part.material.albedo;
        assert!(
            albedo.iter().all(|c| (0.0..=1.0).contains(c)),
            "an albedo is {albedo:?}"
        );
        if let Some(texture) = &part.material.texture {
            assert!(!mesh.uvs.is_empty());
            let pixels = texture.width as usize * texture.height as usize;
            assert!(pixels > 0 && texture.rgba.len() == 4 * pixels);
        }
    }
    if let Some(figure) = &model.figure {
        play(figure, model);
    }
    for warning in &model.warnings {
        assert!(warning.ends_with('.') && !warning.contains(char::is_control));
    }
}

/// Loads an environment map and checks what comes of it.
pub fn environment(path: &Path) {
    match load_environment(path) {
        Ok(map) => check_environment(&map),
        Err(error) => check_error_of(path, &error),
    }
}

/// Checks what everything that takes a map counts on.
pub fn check_environment(map: &EnvironmentMap) {
    assert!(map.width > 0 && map.height > 0);
    assert_eq!(map.pixels.len(), map.width as usize * map.height as usize);
    let good = |c: &f32| c.is_finite() && *c >= 0.0;
    assert!(map.pixels.iter().flatten().all(good));
}

/// A GLB of its two parts, with the lengths that a mutation would break.
pub fn glb(json: &[u8], binary: &[u8]) -> Vec<u8> {
    let padded = |bytes: &[u8], with: u8| {
        let mut bytes = bytes.to_vec();
        bytes.resize(bytes.len().next_multiple_of(4), with);
        bytes
    };
    let (json, binary) = (padded(json, b' '), padded(binary, 0));
    let mut glb = b"glTF\x02\0\0\0".to_vec();
    glb.extend((28 + json.len() as u32 + binary.len() as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", json), (b"BIN\0", binary)] {
        glb.extend((chunk.len() as u32).to_le_bytes());
        glb.extend(kind);
        glb.extend(chunk);
    }
    glb
}
