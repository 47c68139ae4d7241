//! What happens once, before the first frame: files are loaded and spheres fitted.
//!
//! - [`load_scene`] takes a scene file (or a mesh file) to a [`sh_scene::Scene`]; [`default_scene`] needs no
//!   file.
//! - [`load_mesh`] reads glTF and OBJ, [`load_environment`] HDR and EXR maps.
//! - [`SphereSet::fit`] bounds any triangle mesh by a given number of spheres.
//! - [`shapes`] are meshes made by code.
//!
//! Bad input is an [`Error`]: a sentence that names the file and what in it is wrong. Nothing is printed;
//! what was wrong and could be put right comes back as warnings.
//!
//! # Scene files
//! TOML; every key but `mesh` may be left out. A key that is not known is an error.
//!
//! ```toml
//! [[objects]]                  # at least one
//! mesh = "bunny.obj"           # .obj, .gltf or .glb, relative to this file
//! spheres = 64                 # 1 to 4096
//! scale = 1.0                  # applied first,
//! rotate = [0, 90, 0]          # then turned about x, then y, then z, in degrees,
//! translate = [0, 0, 0]        # then moved, in metres
//! albedo = [0.8, 0.8, 0.8]     # or one number; in place of the file's own colour, under its texture
//!
//! [environment]                # a clear sky with a sun where nothing is said
//! map = "city.hdr"             # .hdr or .exr, equirectangular
//! rotation = 0                 # about +Y, in degrees, counter-clockwise seen from above
//! intensity = 1.0
//!
//! [ground]                     # an infinite plane that receives shadows
//! height = 0.0                 # under the lowest point where nothing is said
//! albedo = [0.5, 0.5, 0.5]
//! enabled = true               # false: no ground
//!
//! [camera]                     # frames the objects where nothing is said
//! eye = [3, 2, 5]
//! target = [0, 1, 0]
//! fov = 35                     # vertical, in degrees
//!
//! [settings]
//! order = 4                    # of the light, 2 to 6
//! accumulation_order = 6       # of the shadows' logarithms, from the order to 6: truer and slower; ACCURACY.md
//! window = 8                   # twice the order where nothing is said
//! shadows = true
//! ```

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
