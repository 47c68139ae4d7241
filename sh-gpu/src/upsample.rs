//! The upsample pass: light at half resolution to samples, and what has to be shaded by itself.

use crate::inputs::Inputs;
use crate::lighting::buffer;
use crate::pipeline::Kernel;
use crate::records::UpsampleRule;
use crate::scope::checked;
use crate::slot::Slot;
use crate::{Bands, Bound, ClusterBinding, Error, ShadowPass};
use sh_kernels::Pass;
use sh_scene::{Receiver, Tiles};
use std::sync::Arc;
use wgpu::{
    BindGroup, Buffer, BufferBinding, BufferUsages, CommandEncoder, ComputePassTimestampWrites,
    Device, Queue,
};

/// A joint bilateral filter from half resolution to samples ([`sh_scene::upsample`]), and the list of those that it does not
/// do for, on the host's device and encoder.
///
/// ```no_run
/// # use sh_gpu::{Bands, Error, HalfBinding, ShadowPass, UpsamplePass};
/// # use wgpu::BufferBinding;
/// # fn frame(device: &wgpu::Device, queue: &wgpu::Queue, encoder: &mut wgpu::CommandEncoder, bands: &Bands,
/// #     shadow: &ShadowPass, halves: HalfBinding, [receivers, radiance]: [BufferBinding; 2]) -> Result<(), Error> {
/// let pass = UpsamplePass::new(device, queue, bands, shadow, false)?;
/// let shares = pass.bind_shares(device, halves.clone())?;
/// let bound = pass.bind(device, halves, receivers, radiance)?;
/// let rest = pass.rest(bands, 0);
/// let again = shadow.bind_clusters(device, rest.receivers, rest.clusters, rest.radiance)?;
/// // every frame, after the shadow pass at half resolution; here of a picture of one band
/// pass.record_shares(encoder, &shares, None);
/// pass.record(encoder, bands, 0, &bound, None);
/// shadow.record(encoder, &again, None);
/// pass.record_scatter(encoder, bands, 0, &bound, None);
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

/// One band's buffers, bound to the two parts of an [`UpsamplePass`] that work on samples.
#[derive(Clone, Debug)]
pub struct UpsampleBound {
    upsample: Bound,
    scatter: Bound,
}

impl UpsampleBound {
    /// How many dispatches [`UpsamplePass::record`] records.
    pub fn dispatches(&self) -> usize {
        self.upsample.dispatches()
    }

    /// How many [`UpsamplePass::record_scatter`] records.
    pub fn scatter_dispatches(&self) -> usize {
        self.scatter.dispatches()
    }
}

/// The samples of a band that half resolution does not do for: a list, which the ordinary passes shade. At the head of each
/// tile's part of it are its samples, and the rest of the tile's part is left alone.
#[derive(Clone, Debug)]
pub struct RestBinding<'a> {
    /// [`Receiver`] records, whose objects are the samples they come from.
    pub receivers: BufferBinding<'a>,
    /// The part of each tile that is filled.
    pub clusters: ClusterBinding<'a>,
    /// A `vec4f` each, to be written by whoever shades them.
    pub radiance: BufferBinding<'a>,
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
    /// anew. Light comes as it was prepared for `shadow`; `sent` says whether spheres send any.
    pub fn new(
        device: &Device,
        queue: &Queue,
        bands: &Bands,
        shadow: &ShadowPass,
        sent: bool,
    ) -> Result<Self, Error> {
        Self::of(device, queue, bands, &shadow.inputs, sent)
    }

    /// With light that other passes read as well.
    pub(crate) fn of(
        device: &Device,
        queue: &Queue,
        bands: &Bands,
        inputs: &Inputs,
        sent: bool,
    ) -> Result<Self, Error> {
        checked(device, || {
            let kernel = |name, constants: &[(&'static str, bool)]| {
                let of = (Pass::Upsample, inputs.order, inputs.order);
                inputs.pipelines.specialised(of, name, constants)
            };
            let lamps = inputs.lit.lamps();
            let [any, uneven] = lamps;
            let sent = ("SENT", sent);
            let shares = kernel("shares", &lamps)?;
            let upsample = kernel("upsample", &[any, uneven, sent])?;
            let scatter = kernel("scatter", &[])?;
            let rule = buffer(
                device,
                "gaunt upsample rule",
                size_of::<UpsampleRule>() as u64,
                BufferUsages::UNIFORM,
            );
            queue.write_buffer(&rule, 0, bytemuck::bytes_of(&UpsampleRule::OURS));
            let [lighting, emitters] = inputs.lit.bindings();
            let band = ("band", bands.binding());
            let ours = ("rule", rule.as_entire_binding());
            let group = shares.own(device, &[band, lighting, emitters, ours]);
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

    /// The list of a band: whoever shades it binds this.
    pub fn rest(&self, bands: &Bands, band: u32) -> RestBinding<'_> {
        self.list(bands.receivers(band))
    }

    fn list(&self, count: u64) -> RestBinding<'_> {
        let tiles = count.div_ceil(Tiles::AREA as u64);
        RestBinding {
            receivers: part(&self.anew, count * size_of::<Receiver>() as u64),
            clusters: ClusterBinding {
                clusters: part(&self.clusters, tiles * 8),
                largest: Tiles::AREA as u32,
            },
            radiance: part(&self.shaded, count * 16),
        }
    }

    /// Binds a band's samples ([`Receiver`], read, and radiance as `vec4f`, written) and, at half resolution, the tiles
    /// that lie under it ([`Bands::half_tile_rows`]).
    pub fn bind(
        &self,
        device: &Device,
        halves: HalfBinding<'_>,
        receivers: BufferBinding<'_>,
        radiance: BufferBinding<'_>,
    ) -> Result<UpsampleBound, Error> {
        let stride = size_of::<Receiver>() as u64;
        let counting = Slot::counting("receivers", stride, receivers);
        let count = self.upsample.elements(&counting)?;
        let tiles = count.div_ceil(Tiles::AREA as u64);
        let RestBinding {
            receivers: anew,
            clusters: ClusterBinding { clusters, .. },
            radiance: shaded,
        } = self.list(count);
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
        let slots = [
            Slot::with("shaded_clusters", 8, 0, clusters),
            Slot::with("shaded_receivers", stride, 0, anew),
            Slot::with("shaded", 16, 0, shaded),
            Slot::counting("radiance", 16, radiance),
        ];
        let scatter = self.scatter.bind_groups(device, &slots, tiles, 1)?;
        Ok(UpsampleBound { upsample, scatter })
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

    /// Records one compute pass that writes the radiance of one band's samples, and the list of those that are to be shaded
    /// by themselves.
    pub fn record(
        &self,
        encoder: &mut CommandEncoder,
        bands: &Bands,
        band: u32,
        bound: &UpsampleBound,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) {
        let own = (&self.group, &[bands.offset(band)][..]);
        self.upsample
            .record(encoder, own, &bound.upsample, timestamps);
    }

    /// Records one compute pass that writes the radiance of the list to its samples.
    pub fn record_scatter(
        &self,
        encoder: &mut CommandEncoder,
        bands: &Bands,
        band: u32,
        bound: &UpsampleBound,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) {
        let own = (&self.group, &[bands.offset(band)][..]);
        self.scatter
            .record(encoder, own, &bound.scatter, timestamps);
    }
}

/// The first bytes of a buffer.
fn part(buffer: &Buffer, size: u64) -> BufferBinding<'_> {
    BufferBinding {
        buffer,
        offset: 0,
        size: wgpu::BufferSize::new(size),
    }
}
