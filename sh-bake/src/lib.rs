//! What happens once, before the first frame: files are loaded and spheres fitted.

mod environment;
mod error;
mod gltf;
mod mesh;
mod normals;
mod obj;
pub mod shapes;
mod spheres;

pub use environment::load_environment;
pub use error::Error;
pub use mesh::{Model, Part, load_mesh};
pub use spheres::SphereSet;

/// The albedo of a mesh that has none: a light grey.
const WHITE: [f32; 3] = [0.8; 3];
