//! What happens once, before the first frame: files are loaded and spheres fitted.

mod default_scene;
mod environment;
mod error;
mod gltf;
mod keys;
mod load;
mod mesh;
mod normals;
mod obj;
mod scene_file;
pub mod shapes;
mod spheres;

pub use default_scene::default_scene;
pub use environment::load_environment;
pub use error::Error;
pub use load::{FitReport, Progress, Report, load_scene, load_scene_with};
pub use mesh::{Model, Part, load_mesh};
pub use spheres::SphereSet;

/// The albedo of a mesh that has none: a light grey.
const WHITE: [f32; 3] = [0.8; 3];
