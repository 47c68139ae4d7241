//! The passes on the CPU: vector lanes over receivers, threads over chunks of them.
//!
//! | pass | function | reads | writes |
//! |---|---|---|---|
//! | `gbuffer` | [`gbuffer()`] | [`Geometry`], a view | receivers and albedo of a band of sample rows |
//! | `irradiance` | [`irradiance()`] | receivers, light | radiance |
//! | `cut` | [`Cuts::find`] | receivers, their clusters, the forest of blockers | the blockers of each cluster |
//! | `shadow` | [`shadow_clusters()`]; [`shadow()`] without a hierarchy | receivers, blockers, light | radiance |
//! | `upsample` | [`upsample()`] | receivers, light at half resolution | radiance, and receivers it does not do for |
//! | `resolve` | [`resolve()`] | all of them | pixels |
//!
//! [`render`] strings a plan together and makes a picture, [`Frames`] one after the other. Each pass can be called by itself: receivers may as
//! well be the vertices of a mesh.
//!
//! Lanes ([`lanes`]) are chosen when the program runs ([`Path::best`]). Work goes to the current rayon pool.
//! The same input gives the same bits on one processor, whatever the number of threads; different
//! instruction sets agree within rounding.
//!
//! ```
//! use sh_scene::{EnvironmentMap, Light, Receiver, Sphere};
//! let light = Light::project(&EnvironmentMap::constant([1.0; 3]), None, 4, 8.0)?;
//! let blocker = Sphere { center: [0.0, 2.0, 0.0], radius: 1.0 };
//! let below = Receiver { position: [0.0; 3], covered: 1, normal: [0.0, 1.0, 0.0], object: 0 };
//! let aside = Receiver { position: [9.0, 0.0, 0.0], ..below };
//! let mut radiance = [[0.0; 3]; 2];
//! sh_cpu::shadow(&[below, aside], &[blocker], &light, 4, &mut radiance)?;
//! assert!(radiance[0][0] < 0.85 && radiance[1][0] > 0.98);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod accumulate;
mod behind;
mod cut;
mod drive;
mod emitters;
mod error;
mod frame;
mod gbuffer;
mod geometry;
mod horizon;
mod irradiance;
pub mod lanes;
mod light_cut;
mod light_gather;
mod light_update;
mod outline;
mod path;
mod peak;
mod ratio;
mod resolve;
mod shadow;
mod upsample;

pub use accumulate::{Blockers, Point};
pub use cut::{CutOptions, Cuts};
pub use error::{Error, MAX_SIDE};
pub use frame::{Frame, Frames, Lit, Work, render};
pub use gbuffer::{Gbuffer, gbuffer};
pub use geometry::{Geometry, Hit};
pub use irradiance::{irradiance, irradiance_on};
pub use light_cut::{LightCutOptions, LightCuts};
pub use light_gather::{LightGather, light_gather};
pub use light_update::{Body, LightUpdate, SphericalLights};
pub use outline::{Outline, OutlineAll};
pub use path::{Path, levels};
pub use peak::{lanes as lane_count, multiply_adds_per_second};
pub use resolve::resolve;
pub use shadow::{Shadow, bake, shade, shadow, shadow_clusters, shadow_on};
pub use upsample::{Failed, Halves, upsample};
