//! What both backends read: records, lights, the plan of passes.
//!
//! (under construction)
mod camera;
mod environment;
mod light;
mod plan;
mod records;
mod scene;
mod sky;

pub use camera::{Camera, View};
pub use environment::EnvironmentMap;
pub use light::Light;
pub use plan::{Pass, PassKind, Plan, Resolution, Resource};
pub use records::{Receiver, Sphere};
pub use scene::{Ground, Material, Mesh, Object, Scene, Settings, Texture};
pub use sky::Sky;
