//! The resolve pass: radiance times albedo, the environment where nothing is hit, samples to pixels.

use crate::pipeline::{Kernel, texture_bytes};
use crate::scope::checked;
use crate::slot::Slot;
use crate::upload::Kept;
use crate::{Bands, Bound, Error, Pipelines};
use sh_kernels::{MIN_ORDER, Pass};
use sh_scene::{EnvironmentMap, Receiver, View};
use std::sync::Arc;
use wgpu::{
    BindGroup, BindingResource, BufferBinding, CommandEncoder, ComputePassTimestampWrites, Device,
    Queue, Texture,
};

/// Samples to pixels, on the host's device and encoder.
///
/// ```no_run
/// # use sh_gpu::{Bands, Error, ResolvePass};
/// # use wgpu::BufferBinding;
/// # fn frame(device: &wgpu::Device, queue: &wgpu::Queue, encoder: &mut wgpu::CommandEncoder, bands: &Bands,
/// #     sky: &sh_scene::EnvironmentMap, [receivers, albedo, radiance, picture]: [BufferBinding; 4]) -> Result<(), Error> {
/// let pass = ResolvePass::new(device, queue, bands, sky)?;
/// let bound = pass.bind(device, receivers, albedo, radiance, picture)?;
/// // every frame; here the first band alone
/// pass.record(encoder, bands, 0, &bound, None);
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct ResolvePass {
    kernel: Arc<Kernel>,
    group: BindGroup,
    environment: Texture,
    kept: Kept<Vec<[f32; 4]>>,
}

impl ResolvePass {
    /// Makes the pipeline and uploads the environment map (16 bytes a texel; its sides may not exceed
    /// `max_texture_dimension_2d`).
    pub fn new(
        device: &Device,
        queue: &Queue,
        bands: &Bands,
        environment: &EnvironmentMap,
    ) -> Result<Self, Error> {
        Self::with(&Pipelines::new(device), queue, bands, environment)
    }

    /// As [`new`](Self::new), with a pipeline that is shared.
    pub fn with(
        pipelines: &Pipelines,
        queue: &Queue,
        bands: &Bands,
        environment: &EnvironmentMap,
    ) -> Result<Self, Error> {
        Self::of(pipelines, queue, bands, (environment, false))
    }

    /// With or without what samples mirror.
    pub(crate) fn of(
        pipelines: &Pipelines,
        queue: &Queue,
        bands: &Bands,
        (environment, gloss): (&EnvironmentMap, bool),
    ) -> Result<Self, Error> {
        let device = pipelines.device();
        let EnvironmentMap { width, height, .. } = environment;
        let side = u64::from(device.limits().max_texture_dimension_2d);
        let longest = u64::from(*width.max(height));
        Error::within(
            "the environment map",
            longest,
            "max_texture_dimension_2d",
            side,
        )?;
        check(environment)?;
        checked(device, || {
            let of = (Pass::Resolve, MIN_ORDER, MIN_ORDER);
            let kernel = pipelines.specialised(of, "resolve", &[("GLOSS", gloss)])?;
            let descriptor = wgpu::TextureDescriptor {
                label: Some("gaunt environment"),
                size: wgpu::Extent3d {
                    width: *width,
                    height: *height,
                    depth_or_array_layers: 1,
                },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format: wgpu::TextureFormat::Rgba32Float,
                usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
                view_formats: &[],
            };
            let texture = device.create_texture(&descriptor);
            let kept = Kept::default();
            kept.with(|kept| write(queue, &texture, environment, kept));
            let map = texture.create_view(&wgpu::TextureViewDescriptor {
                label: Some("gaunt environment"),
                ..Default::default()
            });
            let map = ("environment", BindingResource::TextureView(&map));
            let group = kernel.own(device, &[("band", bands.binding()), map]);
            Ok(Self {
                kernel,
                group,
                environment: texture,
                kept,
            })
        })
    }

    /// Bytes of GPU memory that the pass owns: the environment map.
    pub fn bytes(&self) -> u64 {
        texture_bytes(&self.environment)
    }

    /// Uploads another environment map in the place of the first, of the same size, for what is submitted next.
    pub fn update_environment(
        &self,
        queue: &Queue,
        environment: &EnvironmentMap,
    ) -> Result<(), Error> {
        let EnvironmentMap { width, height, .. } = environment;
        if (*width, *height) != (self.environment.width(), self.environment.height()) {
            return Err(Error::EnvironmentSize {
                size: [*width, *height],
                uploaded: [self.environment.width(), self.environment.height()],
            });
        }
        check(environment)?;
        self.kept
            .with(|kept| write(queue, &self.environment, environment, kept));
        Ok(())
    }

    /// Binds receivers ([`Receiver`], 32 bytes each), albedo, whose last number nobody reads, and radiance (`vec4f`,
    /// 16 bytes each) of one band's samples, tile by tile ([`sh_scene::Tiles`]), all read, and the band's part of the
    /// picture ([`Bands::picture_range`]), written: linear red, green, blue, and the share of the pixel's samples that
    /// hit something, as `vec4f`.
    pub fn bind(
        &self,
        device: &Device,
        receivers: BufferBinding<'_>,
        albedo: BufferBinding<'_>,
        radiance: BufferBinding<'_>,
        picture: BufferBinding<'_>,
    ) -> Result<Bound, Error> {
        self.bind_with(device, [receivers, albedo, radiance], None, picture)
    }

    /// With what samples mirror, if they do.
    pub(crate) fn bind_with(
        &self,
        device: &Device,
        [receivers, albedo, radiance]: [BufferBinding<'_>; 3],
        mirrored: Option<BufferBinding<'_>>,
        picture: BufferBinding<'_>,
    ) -> Result<Bound, Error> {
        // Without it nobody reads what is bound in its place.
        let mirrored = mirrored.unwrap_or(radiance.clone());
        let each = u64::from(View::OVERSAMPLE * View::OVERSAMPLE);
        let slots = [
            Slot::with("receivers", size_of::<Receiver>() as u64, each, receivers),
            Slot::with("albedo", 16, each, albedo),
            Slot::with("radiance", 16, each, radiance),
            Slot::with("mirrored", 16, each, mirrored),
            Slot::counting("picture", 16, picture),
        ];
        self.kernel.bind(device, &slots)
    }

    /// Records one compute pass that writes the pixels of one band.
    pub fn record(
        &self,
        encoder: &mut CommandEncoder,
        bands: &Bands,
        band: u32,
        bound: &Bound,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) {
        self.kernel.record(
            encoder,
            (&self.group, &[bands.offset(band)]),
            bound,
            timestamps,
        );
    }
}

/// Whether a map has a texel for every place.
fn check(environment: &EnvironmentMap) -> Result<(), Error> {
    let EnvironmentMap {
        width,
        height,
        pixels,
    } = environment;
    match pixels.len() as u64 == u64::from(*width) * u64::from(*height) && !pixels.is_empty() {
        true => Ok(()),
        false => Err(Error::Environment {
            width: *width,
            height: *height,
            texels: pixels.len(),
        }),
    }
}

/// Uploads a map to a texture of its size.
fn write(queue: &Queue, texture: &Texture, environment: &EnvironmentMap, kept: &mut Vec<[f32; 4]>) {
    let pixels = environment.pixels.iter();
    kept.clear();
    kept.extend(pixels.map(|[r, g, b]| [*r, *g, *b, 0.0]));
    let layout = wgpu::TexelCopyBufferLayout {
        offset: 0,
        bytes_per_row: Some(environment.width * 16),
        rows_per_image: None,
    };
    let bytes = bytemuck::cast_slice(kept);
    queue.write_texture(texture.as_image_copy(), bytes, layout, texture.size());
}
