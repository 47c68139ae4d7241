//! What both backends read: a resolved [`Scene`], the records that go to the passes ([`Receiver`],
//! [`Sphere`]), [`Light`] as spherical harmonics, and the [`Plan`] of passes a scene needs.
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

mod camera;
mod environment;
mod light;
mod plan;
mod quality;
mod records;
mod scene;
mod sky;

pub use camera::{Camera, View};
pub use environment::EnvironmentMap;
pub use light::{Light, LightError};
pub use plan::{Pass, PassKind, Plan, Resolution, Resource};
pub use quality::Quality;
pub use records::{Receiver, Sphere};
pub use scene::{Ground, Material, Mesh, Object, Scene, Settings, Texture};
pub use sky::Sky;
