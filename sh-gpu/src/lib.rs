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
//! Nothing here submits, polls, waits, starts a thread or asks for a device. A steady frame makes no GPU object and
//! allocates what the bare calls of wgpu allocate; a test counts both. Buffers, pipelines and passes have labels that
//! begin with `gaunt`, passes a debug group, and timestamps where the host hands in a query set.
//!
//! # The way of a frame
//! | | receivers come from | | light on them | | radiance goes to |
//! |---|---|---|---|---|---|
//! | a host's mesh | [`VertexPass`] | → | [`ShadowPass`], [`LightGatherPass`] | → | a vertex buffer of the host's |
//! | a host's G-buffer | [`ScreenPass`] | → | the same | → | a texture of the host's, by [`ScreenPass`] |
//! | records of the host's | [`sh_scene::Receiver`] in any storage buffer | → | the same | → | any storage buffer |
//! | a [`sh_scene::Scene`] | [`GbufferPass`] | → | the same, and [`UpsamplePass`] | → | [`Renderer::picture`], by [`ResolvePass`] |
//!
//! [`ShadowPass`] writes radiance, or the shadowed light itself as an SH vector ([`Output::Light`]) for BRDFs and normal
//! maps of the host's.
//!
//! ```no_run
//! # use sh_gpu::{Bound, Error, Position, ScreenCamera, ScreenPass, ScreenTextures, ShadowOptions, ShadowPass};
//! # use sh_scene::{Forest, Light, Limits, Sphere};
//! # fn frame(device: &wgpu::Device, queue: &wgpu::Queue, encoder: &mut wgpu::CommandEncoder,
//! #     textures: ScreenTextures, spheres: &[Sphere], light: &Light, camera: &ScreenCamera) -> Result<(), Error> {
//! // once
//! let shadow = ShadowPass::new(device, ShadowOptions::default())?;
//! let screen = ScreenPass::new(device, textures)?;
//! let parts = screen.parts().map(|part| shadow.bind(device, part.receivers, part.radiance));
//! let lit: Bound = parts.collect::<Result<_, _>>()?;
//! let mut blockers = Forest::new(spheres, &[spheres.len()]);
//! // every frame
//! blockers.update(spheres);
//! screen.prepare(queue, camera);
//! shadow.prepare(queue, &blockers, Limits::default(), light)?;
//! screen.record_receivers(encoder, None);
//! shadow.record(encoder, &lit, None);
//! screen.record_radiance(encoder, None);
//! # Ok(())
//! # }
//! ```
//!
//! `examples/host` of the repository is a whole renderer around this.
//!
//! # Limits and errors
//! All of it works on a device that was requested with `wgpu::Limits::default()`: at most 8 storage buffers a stage,
//! 128 MiB a binding, 256 invocations a workgroup. Receivers beyond one binding are bound and dispatched in parts
//! ([`Bound`]). What does not fit, and what a device has too little of, comes back as an [`Error`] before anything is
//! recorded; so does what the device itself complains of in `new` and `bind`: memory that ran out, a buffer that it
//! refuses, a device that is lost. [`Watch`] tells of the rest of a frame.
//!
//! The kernels are those of `sh-kernels`; receivers, blockers and analytic lights are [`sh_scene::Receiver`],
//! [`sh_scene::Node`] and [`sh_scene::Emitter`], byte for byte. Pipelines are compiled once a
//! specialisation and can be shared ([`Pipelines`]).
//!
//! For authors of renderers on wgpu. A scene comes from `sh-scene` or is made of its records; a [`sh_scene::Plan`] says
//! which passes it calls for; each frame goes `prepare` → `record` → the host's submit.
//!
//! ```
//! use sh_gpu::{ShadowOptions, ShadowPass};
//! use sh_scene::{EnvironmentMap, Forest, Light, Limits, Receiver, Sphere};
//! use wgpu::BufferUsages;
//! # let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
//! # let Ok(adapter) = pollster::block_on(instance.request_adapter(&Default::default())) else { return Ok(()) };
//! # let (device, queue) = pollster::block_on(adapter.request_device(&Default::default()))?;
//! # let buffer = |size, usage| device.create_buffer(&wgpu::BufferDescriptor { label: None, size, usage, mapped_at_creation: false });
//!
//! // A ball above a point that looks up. `device`, `queue` and both buffers are the host's.
//! let ball = [Sphere { center: [0.0, 2.0, 0.0], radius: 1.0 }];
//! let below = Receiver { position: [0.0; 3], covered: 1, normal: [0.0, 1.0, 0.0], object: 0 };
//! let receivers = buffer(32, BufferUsages::STORAGE | BufferUsages::COPY_DST);
//! let radiance = buffer(16, BufferUsages::STORAGE | BufferUsages::COPY_SRC);
//! queue.write_buffer(&receivers, 0, bytemuck::bytes_of(&below));
//! let light = Light::project(&EnvironmentMap::constant([1.0; 3]), None, 4, 8.0)?;
//!
//! // Once.
//! let pass = ShadowPass::new(&device, ShadowOptions { max_blockers: 1, ..ShadowOptions::default() })?;
//! let bound = pass.bind(&device, receivers.as_entire_buffer_binding(), radiance.as_entire_buffer_binding())?;
//! // Every frame.
//! pass.prepare(&queue, &Forest::new(&ball, &[1]), Limits::default(), &light)?;
//! let mut encoder = device.create_command_encoder(&Default::default());
//! pass.record(&mut encoder, &bound, None);
//! // What comes after it is the host's.
//! # let copy = buffer(16, BufferUsages::MAP_READ | BufferUsages::COPY_DST);
//! # encoder.copy_buffer_to_buffer(&radiance, 0, &copy, 0, 16);
//! queue.submit([encoder.finish()]);
//! # copy.map_async(wgpu::MapMode::Read, .., |_| {});
//! # device.poll(wgpu::PollType::wait_indefinitely())?;
//! # let red = f32::from_le_bytes(copy.get_mapped_range(..)?[..4].try_into()?);
//! assert!(red > 0.3 && red < 0.85);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bands;
mod bases;
mod bodies;
mod bound;
mod buffers;
mod clusters;
mod error;
mod gbuffer;
mod inputs;
mod irradiance;
mod layout;
mod light_gather;
mod light_update;
mod lighting;
mod makers;
mod pipeline;
mod pipelines;
mod plain;
mod punctual;
mod raster;
pub mod records;
mod renderer;
mod resolve;
mod scope;
mod screen;
mod screen_textures;
mod setup;
mod shadow;
mod slot;
mod stages;
mod surfaces;
mod upload;
mod upsample;
mod vertices;
mod views;
mod watch;

pub use bands::Bands;
pub use bodies::Bodies;
pub use bound::Bound;
pub use clusters::ClusterBinding;
pub use error::Error;
pub use gbuffer::{Drawn, GbufferPass, Timestamps};
pub use irradiance::IrradiancePass;
pub use light_gather::LightGatherPass;
pub use light_update::LightUpdatePass;
pub use pipelines::Pipelines;
pub use renderer::Renderer;
pub use resolve::ResolvePass;
pub use screen::{ScreenPart, ScreenPass};
pub use screen_textures::{Position, ScreenCamera, ScreenTextures};
pub use shadow::{Output, ShadowOptions, ShadowPass};
pub use upsample::{HalfBinding, RestBinding, UpsampleBound, UpsamplePass};
pub use vertices::{VertexBound, VertexLayout, VertexPass};
pub use watch::Watch;
