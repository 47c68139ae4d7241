//! The upsample pass: light at half resolution to samples, and what has to be shaded by itself.

use crate::lighting::{Lit, buffer};
use crate::pipeline::{Kernel, buffer_entry};
use crate::records::UpsampleRule;
use crate::scope::checked;
use crate::slot::Slot;
use crate::{Bands, Bound, ClusterBinding, Error, LightGatherPass, ShadowPass};
use sh_kernels::Pass;
use sh_scene::{Receiver, Tiles};
use std::sync::Arc;
use wgpu::{
    BindGroup, BindGroupEntry, Buffer, BufferBinding, BufferBindingType, BufferUsages,
    CommandEncoder, ComputePassTimestampWrites, Device, Queue, ShaderStages,
};

/// A joint bilateral filter from half resolution to samples ([`sh_scene::upsample`]), with the shadow pass for what it
/// does not do for, on the host's device and encoder.
///
/// ```no_run
/// # use sh_gpu::{Bands, Error, HalfBinding, ShadowPass, UpsamplePass};
/// # use wgpu::BufferBinding;
/// # fn frame(device: &wgpu::Device, queue: &wgpu::Queue, encoder: &mut wgpu::CommandEncoder, bands: &Bands,
/// #     shadow: &ShadowPass, halves: HalfBinding, [receivers, radiance]: [BufferBinding; 2]) -> Result<(), Error> {
/// let pass = UpsamplePass::new(device, queue, bands, shadow)?;
/// let shares = pass.bind_shares(device, halves.clone())?;
/// let bound = pass.bind(device, shadow, halves, receivers, radiance)?;
/// // every frame, after the shadow pass at half resolution; here of a picture of one band
/// pass.record_shares(encoder, &shares, None);
/// pass.record(encoder, bands, 0, shadow, &bound, None);
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct UpsamplePass {
    shares: Arc<Kernel>,
    upsample: Arc<Kernel>,
    scatter: Arc<Kernel>,
    group: BindGroup,
    rule: Buffer,
    /// What has to be shaded anew in a band: receivers, whose objects are the samples they come from, and their
    /// radiance.
    anew: Buffer,
    shaded: Buffer,
    clusters: Buffer,
    /// In the place of what spheres send where they send nothing.
    nothing: Buffer,
}

/// The passes that shade what [`UpsamplePass`] cannot take from half resolution.
#[derive(Clone, Copy, Debug)]
pub struct Shading<'a> {
    /// Light through the visibility of all blockers.
    pub shadow: &'a ShadowPass,
    /// Light that spheres send on, where they do.
    pub gather: Option<&'a LightGatherPass>,
}

impl<'a> From<&'a ShadowPass> for Shading<'a> {
    fn from(shadow: &'a ShadowPass) -> Self {
        Self {
            shadow,
            gather: None,
        }
    }
}

/// One band's buffers, bound to all parts of an [`UpsamplePass`].
#[derive(Clone, Debug)]
pub struct UpsampleBound {
    upsample: Bound,
    shadow: Bound,
    gather: Option<Bound>,
    scatter: Bound,
}

impl UpsampleBound {
    /// How many dispatches [`UpsamplePass::record`] records.
    pub fn dispatches(&self) -> usize {
        let gather = self.gather.as_ref().map_or(0, Bound::dispatches);
        self.upsample.dispatches() + self.shadow.dispatches() + gather + self.scatter.dispatches()
    }
}

/// What an [`UpsamplePass`] reads at half resolution: whole rows of tiles.
#[derive(Clone, Debug)]
pub struct HalfBinding<'a> {
    /// [`Receiver`] records, 32 bytes each.
    pub receivers: BufferBinding<'a>,
    /// A `vec4f` each, 16 bytes: radiance from the shadow pass before [`UpsamplePass::record_shares`], and after it the
    /// share that radiance is of that without blockers.
    pub shares: BufferBinding<'a>,
    /// A `vec4f` each, 16 bytes: radiance that spheres send, from the light gather pass on a buffer that was cleared.
    pub sent: Option<BufferBinding<'a>>,
}

impl UpsamplePass {
    /// Makes the pipelines for the bands of a picture's samples, and sets room aside for what one band has to shade
    /// anew. Light comes as it was prepared for `shading`, the passes that [`bind`](Self::bind) is given.
    pub fn new<'a>(
        device: &Device,
        queue: &Queue,
        bands: &Bands,
        shading: impl Into<Shading<'a>>,
    ) -> Result<Self, Error> {
        let Shading { shadow, gather } = shading.into();
        let sent = gather.is_some();
        checked(device, || {
            let compute = ShaderStages::COMPUTE;
            let uniform = BufferBindingType::Uniform;
            let [lighting, emitters] = Lit::layout(1);
            let own = [
                buffer_entry(0, compute, uniform, true),
                lighting,
                emitters,
                buffer_entry(3, compute, uniform, false),
            ];
            let storage = |binding: u32, read_only| {
                let ty = BufferBindingType::Storage { read_only };
                buffer_entry(binding, compute, ty, false)
            };
            let kernel = |name, constants: &[(&'static str, f64)], written: &[bool]| {
                let host: Vec<_> = (0..)
                    .zip(written)
                    .map(|(binding, written)| storage(binding, !written))
                    .collect();
                let of = (Pass::Upsample, shadow.order(), shadow.order());
                let pipelines = &shadow.pipelines;
                pipelines.specialised(of, name, [&own, &host], constants)
            };
            let lamps = shadow.lit.lamps();
            let [any, uneven] = lamps;
            let shares = kernel("shares", &lamps, &[false, true])?;
            let written = [false, false, false, true, true, true, false];
            let upsample = kernel(
                "upsample",
                &[any, uneven, ("SENT", f64::from(u8::from(sent)))],
                &written,
            )?;
            let scatter = kernel("scatter", &[], &[false, false, false, true])?;
            let rule = buffer(
                device,
                "gaunt upsample rule",
                size_of::<UpsampleRule>() as u64,
                BufferUsages::UNIFORM,
            );
            queue.write_buffer(&rule, 0, bytemuck::bytes_of(&UpsampleRule::OURS));
            let [lighting, emitters] = shadow.lit.entries(1);
            let entry = |binding, resource| BindGroupEntry { binding, resource };
            let group = shares.own(
                device,
                &[
                    entry(0, bands.binding()),
                    lighting,
                    emitters,
                    entry(3, rule.as_entire_binding()),
                ],
            );
            let room = |label, count: u64, stride: u64| {
                device.create_buffer(&wgpu::BufferDescriptor {
                    label: Some(label),
                    size: count * stride,
                    usage: BufferUsages::STORAGE,
                    mapped_at_creation: false,
                })
            };
            let count = bands.receivers(0);
            Ok(Self {
                rule: rule.clone(),
                anew: room("gaunt anew", count, size_of::<Receiver>() as u64),
                shaded: room("gaunt shaded anew", count, 16),
                clusters: room("gaunt clusters anew", count / Tiles::AREA as u64, 8),
                nothing: room("gaunt nothing sent", 1, 16),
                shares,
                upsample,
                scatter,
                group,
            })
        })
    }

    /// Bytes of GPU memory that the pass owns.
    pub fn bytes(&self) -> u64 {
        let Self {
            rule,
            anew,
            shaded,
            clusters,
            nothing,
            ..
        } = self;
        [rule, anew, shaded, clusters, nothing]
            .map(Buffer::size)
            .iter()
            .sum()
    }

    /// Binds receivers and radiance at half resolution for [`record_shares`](Self::record_shares).
    pub fn bind_shares(&self, device: &Device, halves: HalfBinding<'_>) -> Result<Bound, Error> {
        let stride = size_of::<Receiver>() as u64;
        let receivers = Slot::counting("half_receivers", stride, halves.receivers);
        let radiance = Slot::with("half_radiance", 16, 1, halves.shares);
        self.shares.bind(device, &[receivers, radiance])
    }

    /// Binds a band's samples ([`Receiver`], read, and radiance as `vec4f`, written) and, at half resolution, the tiles
    /// that lie under it ([`Bands::half_tile_rows`]). `shading` are the passes that shade anew.
    pub fn bind<'a>(
        &self,
        device: &Device,
        shading: impl Into<Shading<'a>>,
        halves: HalfBinding<'_>,
        receivers: BufferBinding<'_>,
        radiance: BufferBinding<'_>,
    ) -> Result<UpsampleBound, Error> {
        let stride = size_of::<Receiver>() as u64;
        let counting = Slot::counting("receivers", stride, receivers);
        let count = self.upsample.elements(&counting)?;
        let tiles = count.div_ceil(Tiles::AREA as u64);
        let part = |buffer, size| BufferBinding {
            buffer,
            offset: 0,
            size: wgpu::BufferSize::new(size),
        };
        let anew = part(&self.anew, count * stride);
        let clusters = part(&self.clusters, tiles * 8);
        let shaded = part(&self.shaded, count * 16);
        let sent = halves.sent.unwrap_or_else(|| part(&self.nothing, 16));
        let slots = [
            Slot::with("half_receivers", stride, 0, halves.receivers),
            Slot::with("half_shares", 16, 0, halves.shares),
            counting,
            Slot::with("radiance", 16, 1, radiance.clone()),
            Slot::with("anew", stride, 1, anew.clone()),
            Slot::with("clusters", 8, 0, clusters.clone()),
            Slot::with("half_sent", 16, 0, sent),
        ];
        let upsample = self.upsample.bind_groups(device, &slots, tiles, 1)?;
        let largest = Tiles::AREA as u32;
        let all = ClusterBinding {
            clusters: clusters.clone(),
            largest,
        };
        let Shading { shadow, gather } = shading.into();
        let gather = gather
            .map(|gather| gather.bind_clusters(device, anew.clone(), all.clone(), shaded.clone()))
            .transpose()?;
        let shadow = shadow.bind_clusters(device, anew.clone(), all, shaded.clone())?;
        let slots = [
            Slot::with("clusters", 8, 0, clusters),
            Slot::with("anew", stride, 0, anew),
            Slot::with("shaded", 16, 0, shaded),
            Slot::counting("radiance", 16, radiance),
        ];
        let scatter = self.scatter.bind_groups(device, &slots, tiles, 1)?;
        Ok(UpsampleBound {
            upsample,
            shadow,
            gather,
            scatter,
        })
    }

    /// Records one compute pass that turns radiance at half resolution into shares. Once a frame.
    pub fn record_shares(
        &self,
        encoder: &mut CommandEncoder,
        bound: &Bound,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) {
        self.shares
            .record(encoder, (&self.group, &[0]), bound, timestamps);
    }

    /// Records three compute passes, or four where spheres send light on, that write the radiance of one band's samples.
    /// `shading` is what [`bind`](Self::bind) was given.
    pub fn record<'a>(
        &self,
        encoder: &mut CommandEncoder,
        bands: &Bands,
        band: u32,
        shading: impl Into<Shading<'a>>,
        bound: &UpsampleBound,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) {
        let [begin, end] = first_and_last(timestamps);
        let own = (&self.group, &[bands.offset(band)][..]);
        self.upsample.record(encoder, own, &bound.upsample, begin);
        let Shading { shadow, gather } = shading.into();
        shadow.record(encoder, &bound.shadow, None);
        if let (Some(gather), Some(bound)) = (gather, &bound.gather) {
            gather.record(encoder, bound, None);
        }
        self.scatter.record(encoder, own, &bound.scatter, end);
    }
}

/// The timestamps of a first and of a last pass.
pub(crate) fn first_and_last(
    timestamps: Option<ComputePassTimestampWrites<'_>>,
) -> [Option<ComputePassTimestampWrites<'_>>; 2] {
    let Some(both) = timestamps else {
        return [None, None];
    };
    let begin = ComputePassTimestampWrites {
        end_of_pass_write_index: None,
        ..both.clone()
    };
    let end = ComputePassTimestampWrites {
        beginning_of_pass_write_index: None,
        ..both
    };
    [Some(begin), Some(end)]
}
