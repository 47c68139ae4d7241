//! A GPU for the program: finding one, submitting, waiting, reading back.
//!
//! The passes of `sh-gpu` leave all of this to their host; here the host is this program.

mod device;
mod stamps;

pub use device::Gpu;
pub use stamps::Stamps;
