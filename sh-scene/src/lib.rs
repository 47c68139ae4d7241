//! What both backends read: records, lights, the plan of passes.
//!
//! (under construction)
mod camera;
mod light;
mod plan;
mod records;
mod scene;

pub use camera::{Camera, View};
pub use light::Light;
pub use plan::{Pass, PassKind, Plan};
pub use records::{Receiver, Sphere};
pub use scene::{EnvironmentMap, Ground, Material, Mesh, Object, Scene, Settings, Texture};
