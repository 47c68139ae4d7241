//! What happens once, before the first frame: files are loaded and spheres fitted.
//!
//! - [`load_scene`] takes a scene file (or a mesh file) to a [`sh_scene::Scene`] and its
//!   [`sh_scene::motion::Motion`]; [`default_scene`] needs no file.
//! - [`load_mesh`] reads glTF and OBJ, [`load_environment`] HDR and EXR maps.
//! - [`SphereSet::fit`] bounds any triangle mesh by a given number of spheres; a [`Cache`] keeps what loading fits
//!   and samples.
//! - [`bind_spheres`] makes spheres follow a mesh that bends, [`grow_spheres`] lets them hold it.
//! - [`bake_surface`] samples the surface around spheres, so that they can shine.
//! - [`shapes`] are meshes made by code.
//!
//! Bad input is an [`Error`]: a sentence that names the file and what in it is wrong. Nothing is printed;
//! what was wrong and could be put right comes back as warnings.
//!
//! For whoever has files: a renderer with loaders of its own needs only `sh-scene`. What comes out is what a plan is
//! made for, and what `sh-cpu` and `sh-gpu` shade, frame by frame.
//!
//! ```
//! // A ball of triangles, bounded by eight spheres: what a renderer with meshes of its own needs of this crate.
//! let ball = sh_bake::shapes::ball(1.0, 1);
//! let set = sh_bake::SphereSet::fit(&[&ball], 8);
//! assert!((1..=8).contains(&set.spheres.len()));
//! ```
//!
//! # Scene files
//! TOML; every key but `mesh` may be left out. A key that is not known is an error.
//!
//! ```toml
//! [[objects]]                  # at least one
//! mesh = "bunny.obj"           # .obj, .gltf or .glb, relative to this file
//! name = "bunny"               # what lights call it; its file's name where nothing is said
//! spheres = 64                 # 1 to 4096
//! # blockers = "none"          # in their place: a wall that hides nothing from what stands before it
//! scale = 1.0                  # applied first,
//! rotate = [0, 90, 0]          # then turned about x, then y, then z, in degrees,
//! translate = [0, 0, 0]        # then moved, in metres
//! albedo = [0.8, 0.8, 0.8]     # or one number; in place of the file's own colour, under its texture
//! roughness = 0.6              # 0 to 1, and
//! metallic = 0                 # 0 to 1: how it mirrors light; in place of what the file says
//! method = "spherical-lights"  # by what it sends light on, where that is not as [indirect] says
//! lights = true                # the lights of a glTF file are in the scene
//! clip = "Walk"                # plays one of the mesh file's clips over and over: its name, or its number from 0
//! keys = [                     # moves the whole: places over time, in seconds; straight lines and the shorter
//!     { time = 0 },            # turns (below 180 degrees) between them; what a key does not say is as above
//!     { time = 2, translate = [1, 0, 0], rotate = [0, 180, 0], scale = 2 },
//! ]
//! repeat = true                # the keys begin anew after the last; where nothing is said the object stays there
//!
//! [environment]                # a clear sky with a sun where nothing is said
//! map = "city.hdr"             # .hdr or .exr, equirectangular
//! rotation = 0                 # about +Y, in degrees, counter-clockwise seen from above
//! turn = 30                    # degrees a second
//! intensity = 1.0
//! # sun = "lift"               # its sun becomes a light with sharp shadows; "keep" where nothing is said. Not with turn
//! enabled = true               # false: no light from all around
//!
//! [[lights]]                   # any number of discs in the sky
//! direction = [1, 2, 0]        # towards it
//! angle = 2                    # its angular radius, in degrees
//! radiance = [90, 80, 60]      # of its surface; or one number
//!
//! [[lights]]                   # or glowing balls, which cast no shadow themselves
//! center = [0, 3, 1]
//! radius = 0.2
//! radiance = 40
//! window = 6                   # of its spherical harmonics, in bands; as wide as ringing allows where nothing is said
//! object = "bunny"             # bound to an object: center, radius and brightness in its space, moved and turned with it
//! towards = [0, -1, 0]         # glows where its surface faces this way,
//! spread = 90                  # within so many degrees, 0 to 180; all over where nothing is said. Or instead:
//! # map = "lamp.hdr"           # as bright in each direction from its centre as this map, times the radiance
//! # distribution = [3.5, 0, -2, 0]   # SH coefficients, numbers or colours, 1, 4, 9, 16, 25 or 36, times the radiance
//!
//! [[lights]]                   # or with sharp shadows: a spot, a point or a sun
//! kind = "spot"
//! position = [0, 4, 2]         # of a spot and a point
//! towards = [0, -1, -0.3]      # the way that a spot shines
//! angle = 40                   # of a spot: its cone from edge to edge, below 180 degrees; of a sun: its angular radius, 0 to 45 degrees
//! blend = 0.15                 # of a spot: the part of the cone over which it fades to its edge, 0 to 1
//! radius = 0.05                # of a spot and a point, in metres: the larger, the softer its shadows; none where nothing is said
//! intensity = 60               # radiance times square metres (candela); of a sun, irradiance (lux): radiance times steradians
//! color = [1, 0.9, 0.7]        # which that is multiplied with
//! object = "bunny"             # bound to an object, as above
//!
//! [ground]                     # an infinite plane that receives shadows
//! height = 0.0                 # under the lowest point where nothing is said
//! albedo = [0.5, 0.5, 0.5]
//! enabled = true               # false: no ground
//!
//! [indirect]                   # bodies light each other; they do not where nothing is said
//! method = "spherical-lights"  # by their spheres; or "basis-irradiance": by patches, of bodies that do not bend
//! bounces = 1                  # 1 to 16: how often light is sent on before it reaches what is seen
//! blocking = "discs"           # what hides the light of spheres; "runs", "sphere", "object": sh_scene::Blocking
//! basis = 16                   # by patches: functions that tell what falls on a body, 1 to 64
//!
//! [camera]                     # frames the objects where nothing is said
//! eye = [3, 2, 5]
//! target = [0, 1, 0]
//! fov = 35                     # vertical, in degrees
//! # name = "Camera"             # in their place: a camera of one of the glTF files, as that has it, by its name or number from 0
//!
//! [settings]
//! order = 4                    # of the light, 2 to 6
//! accumulation_order = 6       # of the shadows' logarithms, from the order to 6: truer and slower; ACCURACY.md
//! window = 8                   # of the environment; up to twice the order, as ringing allows, where nothing is said
//! shadows = true
//! half_resolution = false      # shadows for every two by two pixels, and at edges for every sample; true where nothing is said
//! blocker_angle = 25           # degrees: groups of spheres below this angular radius count as one; 0 to 30, 0 for none
//! ```

mod basis;
mod bodies;
mod cache;
mod choices;
mod default_scene;
mod environment;
mod error;
mod gltf;
mod indirect;
mod keys;
mod lights;
mod load;
mod mesh;
mod model;
mod motion;
mod normals;
mod obj;
mod objects;
mod progress;
mod punctual;
mod raw;
mod rays;
mod scene_file;
pub mod shapes;
mod spheres;
mod surface;
mod weights;

pub use basis::{IrradianceField, LitField, irradiance_basis};
pub use bodies::{BasisReport, SurfaceReport, WeightReport};
pub use cache::Cache;
pub use choices::Choices;
pub use default_scene::{default_scene, default_scene_with};
pub use environment::load_environment;
pub use error::Error;
pub use load::{FitReport, Loaded, Report, load_scene, load_scene_with};
pub use mesh::load_mesh;
pub use model::{Figure, Model, ModelCamera, Part};
pub use motion::{ClipChoice, bind_spheres, grow_spheres};
pub use progress::Progress;
pub use spheres::{SphereSet, is_closed};
pub use surface::bake_surface;
pub use weights::{weights, weights_by};
