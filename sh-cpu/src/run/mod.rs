//! Running a plan.

mod frames;
mod sent;
mod spheres;
mod twins;
mod work;

pub use frames::{Frame, Frames, Lit, render};
pub use sent::LightUpdate;
pub use work::Work;
