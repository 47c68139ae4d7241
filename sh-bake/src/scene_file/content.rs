//! What a scene file says.

use crate::lights::LightEntry;
use crate::objects::ObjectEntry;
use crate::punctual::PunctualEntry;
use sh_scene::Settings;
use std::path::PathBuf;

/// Functions that tell the irradiance of a body, where nothing is said (Iwasaki et al. 2007, section 6).
const FUNCTIONS: usize = 16;

/// A scene file's content, checked but not yet resolved.
pub(crate) struct SceneFile {
    /// Whether it is none, but a mesh file.
    pub(crate) of_mesh: bool,
    pub(crate) objects: Vec<ObjectEntry>,
    /// Whether there is light from all around.
    pub(crate) sky: bool,
    pub(crate) map: Option<PathBuf>,
    /// Whether its sun becomes a light of its own.
    pub(crate) lift: bool,
    /// Radians.
    pub(crate) rotation: f32,
    /// Degrees a second.
    pub(crate) turn: f32,
    pub(crate) intensity: f32,
    pub(crate) ground: bool,
    pub(crate) ground_height: Option<f32>,
    pub(crate) ground_albedo: [f32; 3],
    /// A file's camera.
    pub(crate) view: Option<CameraName>,
    pub(crate) eye: Option<[f32; 3]>,
    pub(crate) target: Option<[f32; 3]>,
    /// Radians.
    pub(crate) fov: Option<f32>,
    pub(crate) settings: Settings,
    /// Functions that tell the irradiance of a body.
    pub(crate) functions: usize,
    pub(crate) lights: Vec<LightEntry>,
    pub(crate) punctual: Vec<PunctualEntry>,
}

/// A camera of a file, by name or number, and the line that asks for it.
pub(crate) struct CameraName {
    pub(crate) name: String,
    pub(crate) line: usize,
}

impl Default for SceneFile {
    /// What holds where a file says nothing.
    fn default() -> Self {
        Self {
            of_mesh: false,
            objects: Vec::new(),
            sky: true,
            map: None,
            lift: false,
            rotation: 0.0,
            turn: 0.0,
            intensity: 1.0,
            ground: true,
            ground_height: None,
            ground_albedo: [0.5; 3],
            view: None,
            eye: None,
            target: None,
            fov: None,
            settings: Settings::default(),
            functions: FUNCTIONS,
            lights: Vec::new(),
            punctual: Vec::new(),
        }
    }
}
