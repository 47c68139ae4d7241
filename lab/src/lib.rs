//! What measures the library, as a program of its own: whoever renders need not build it.
//!
//! | command | module |
//! |---|---|
//! | `gaunt-lab accuracy` | [`accuracy`]: what every exponential and logarithm costs, in error and in time |
//! | `gaunt-lab bench` | [`mod@bench`]: times of moving scenes, stage by stage |
//! | `gaunt-lab validate` | [`validate`]: spherical lights against the path tracer |
//! | `gaunt-lab spheres` | [`spheres`]: how tight sphere sets are |
//! | `gaunt-lab basis` | [`basis`]: in how few functions a body's irradiance can be written |
//! | `gaunt-lab fit` | [`fit`]: the fitted constants of the library, from their definitions |
//!
//! ```
//! // The tables and scenes that `gaunt-lab validate --only` takes.
//! assert!(gaunt_lab::validate::names().any(|name| name == "bend-90"));
//! ```

pub mod accuracy;
pub mod basis;
pub mod bench;
pub mod fit;
mod meshes;
mod rooms;
pub mod spheres;
pub mod validate;
