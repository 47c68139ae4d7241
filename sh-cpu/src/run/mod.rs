//! Running a plan.

mod frames;
mod spheres;
mod twins;
mod work;

pub use frames::{Frame, Frames, Lit, render};
pub use work::Work;
