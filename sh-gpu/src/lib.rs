//! The passes on the GPU, as middleware: the host owns device, queue, encoder and, where it wants,
//! receivers and radiance.
//!
//! Every pass has the same three steps, and so has [`Renderer`], which strings the passes of a plan
//! together:
//!
//! | step | when | creates |
//! |---|---|---|
//! | `new(&Device, …)`, `bind(&Device, …)` | once | pipelines, buffers, bind groups |
//! | `prepare(&Queue, …)` | every frame | nothing: uploads what changed |
//! | `record(&mut CommandEncoder, …)` | every frame | nothing: adds passes to the encoder |
//!
//! Nothing here submits, polls, waits, starts a thread or asks for a device, and all of it stays within
//! WebGPU's default limits. What does not fit comes back as an [`Error`] before anything is recorded.
//!
//! The kernels are those of `sh-kernels`; receivers, blockers and analytic lights are [`sh_scene::Receiver`],
//! [`sh_scene::Node`] and [`sh_scene::Emitter`], byte for byte.

mod bands;
mod bodies;
mod buffers;
mod error;
mod gbuffer;
mod irradiance;
mod light_gather;
mod light_update;
mod lighting;
mod pipeline;
pub mod records;
mod renderer;
mod resolve;
mod shadow;
mod stages;
mod upsample;

pub use bands::Bands;
pub use bodies::Bodies;
pub use error::Error;
pub use gbuffer::{GbufferPass, Timestamps};
pub use irradiance::IrradiancePass;
pub use light_gather::LightGatherPass;
pub use light_update::{LightUpdatePass, Shining};
pub use pipeline::Bound;
pub use renderer::Renderer;
pub use resolve::ResolvePass;
pub use shadow::{ClusterBinding, ShadowOptions, ShadowPass};
pub use upsample::{HalfBinding, Shading, UpsampleBound, UpsamplePass};
