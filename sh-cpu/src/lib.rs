//! The passes on the CPU: vector lanes over receivers, threads over chunks of them.
//!
//! | pass | function | reads | writes |
//! |---|---|---|---|
//! | `gbuffer` | [`gbuffer()`] | [`Geometry`], a view | receivers and albedo of a band of sample rows |
//! | `irradiance` | [`irradiance()`] | receivers, light | radiance |
//! | `cut` | [`Cuts::find`] | receivers, their clusters, the forest of blockers | the blockers of each cluster |
//! | `shadow` | [`shadow_clusters()`]; [`shadow()`] without a hierarchy | receivers, blockers, light | radiance |
//! | `upsample` | [`upsample()`] | receivers, light at half resolution | radiance, and receivers it does not do for |
//! | `invalid` | [`invalid()`] | receivers, radiance | counts of invalid samples a pixel |
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

mod device;
mod error;
pub mod lanes;
mod passes;
mod run;
mod store;

pub use device::accumulate::{Blockers, Point};
pub use device::cut::{CutOptions, Cuts};
pub use device::geometry::{Geometry, Hit};
pub use device::light_cuts::LightCuts;
pub use device::light_order::LightCutOptions;
pub use device::outline::{Outline, OutlineAll};
pub use device::spherical_lights::SphericalLights;
pub use error::{Error, MAX_SIDE};
pub use lanes::path::{Path, levels};
pub use lanes::peak::{lanes as lane_count, multiply_adds_per_second};
pub use passes::gbuffer::{Gbuffer, gbuffer};
pub use passes::invalid::invalid;
pub use passes::irradiance::{irradiance, irradiance_on};
pub use passes::light_gather::{LightGather, light_gather};
pub use passes::resolve::{SampleLight, resolve};
pub use passes::shadow::{Shadow, bake, shade, shadow, shadow_clusters, shadow_on};
pub use passes::upsample::{Failed, Halves, upsample};
pub use run::{Frame, Frames, LightUpdate, Lit, Work, render};
