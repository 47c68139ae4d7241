//! From what files say of motion to what moves a scene.

mod bind;
mod choice;
mod coordinates;
mod rigs;
mod survey;

pub use bind::bind_spheres;
pub use choice::ClipChoice;
pub(crate) use choice::clips;
pub(crate) use rigs::Rigs;
pub use survey::grow_spheres;
pub(crate) use survey::reach;
