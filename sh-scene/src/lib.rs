//! What both backends read: a resolved [`Scene`], the records that go to the passes ([`Receiver`],
//! [`Sphere`]), [`Light`] as spherical harmonics, the [`Plan`] of passes a scene needs, and its [`motion`].
//!
//! Nothing here loads a file: a host with its own loaders needs only this crate. +Y is up, lengths are in
//! metres, angles in radians, radiance and albedo linear Rec.709.
//!
//! ```
//! use sh_scene::{Light, Sky};
//! let sky = Sky::default().map(64, 32);
//! let light = Light::project(&sky, None, 4, 8.0)?;
//! let [r, _, b] = light.irradiance([0.0, 0.0, -1.0]);
//! assert!(b > r, "the side that faces away from the sun is lit blue");
//! # Ok::<(), sh_scene::LightError>(())
//! ```

pub mod basis;
mod basis_body;
mod blockers;
mod body;
mod camera;
mod clusters;
mod distribution;
mod emitter;
mod environment;
mod finish;
mod indirect;
mod lift;
mod light;
mod lloyd;
pub mod motion;
pub mod order;
pub mod plan;
pub mod punctual;
mod quality;
mod records;
pub mod ringing;
mod scene;
mod sky;
pub mod surface;
mod texture;
mod tracker;
pub mod upsample;

pub use basis::{BasisSample, IrradianceBasis};
pub use basis_body::BasisBody;
pub use blockers::{Blocker, Bounds, Forest, Limits, NEGLIGIBLE, Node, Side};
pub use body::Body;
pub use camera::{Camera, Grid, Tiles, View};
pub use clusters::Clusters;
pub use distribution::Distribution;
pub use emitter::{AreaLight, AreaShape, Emitter};
pub use environment::EnvironmentMap;
pub use finish::Finish;
pub use indirect::{Blocking, Indirect, Method};
pub use lift::Lifted;
pub use light::{Light, LightError};
pub use plan::{
    Buffer, Domain, LeftOut, PASSES, Part, Pass, Plan, PlanError, Planned, Resource, Shader, Step,
    passes, resource,
};
pub use punctual::{LightView, LightViews, PunctualLight, PunctualRecord, PunctualShape};
pub use quality::Quality;
pub use records::{Receiver, Sphere};
pub use scene::{Ground, Material, Mesh, Object, Scene, Settings};
pub use sky::Sky;
pub use surface::{SurfacePoint, SurfaceSamples};
pub use texture::Texture;
pub use tracker::{Changes, Tracker, fingerprint};
