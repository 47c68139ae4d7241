//! The shadow pass: light through the visibility of all blocker spheres, for every receiver (Ren et al. 2006,
//! sections 6 to 8).

use crate::lighting::{Lit, buffer, room};
use crate::pipeline::{Kernel, Slot, buffer_entry, module};
use crate::{Bound, Error};
use sh_kernels::Pass;
use sh_scene::{Forest, Light, Limits, Node, Receiver, Sphere, Tiles};
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{
    BindGroup, BindGroupEntry, Buffer, BufferBinding, BufferBindingType, BufferUsages,
    CommandEncoder, ComputePassTimestampWrites, Device, Queue, ShaderStages,
};

/// How a [`ShadowPass`] is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShadowOptions {
    /// SH order of the light, 2 to 6. The cost of a receiver grows with its fourth power.
    pub order: usize,
    /// SH order in which the blockers' logarithms are summed and exponentiated, from `order` to 6. Above `order`
    /// the shadows are truer; the cost of a blocker grows with its square.
    pub accumulation: usize,
    /// The most blocker spheres [`ShadowPass::prepare`] will take; 64 bytes each are set aside, for two nodes of a
    /// tree.
    pub max_blockers: u32,
    /// The most analytic lights; 64 bytes each are set aside.
    pub max_emitters: u32,
}

impl Default for ShadowOptions {
    fn default() -> Self {
        Self {
            order: 4,
            accumulation: 4,
            max_blockers: 4096,
            max_emitters: 16,
        }
    }
}

/// Receivers that share a cut of blockers, as the GPU reads them.
#[derive(Clone, Debug)]
pub struct ClusterBinding<'a> {
    /// A `vec2u` each, 8 bytes: index of the first receiver, and how many. They may change from frame to frame, and
    /// be written by a pass; those of no receivers cost next to nothing.
    pub clusters: BufferBinding<'a>,
    /// Receivers of the largest cluster; what a cluster has beyond is not lit.
    pub largest: u32,
}

/// Light through the visibility of all blocker spheres, on the host's device, queue and encoder.
///
/// Pipeline and bind groups are made by [`new`](Self::new) and [`bind`](Self::bind); a frame is
/// [`prepare`](Self::prepare) and [`record`](Self::record), which create nothing.
///
/// ```no_run
/// # use sh_gpu::{Error, ShadowOptions, ShadowPass};
/// # use sh_scene::{Forest, Light, Limits};
/// # fn frame(device: &wgpu::Device, queue: &wgpu::Queue, receivers: &wgpu::Buffer, radiance: &wgpu::Buffer,
/// #     spheres: &[sh_scene::Sphere], forest: &mut Forest, light: &Light) -> Result<(), Error> {
/// let options = ShadowOptions { max_blockers: 1000, ..ShadowOptions::default() };
/// let shadow = ShadowPass::new(device, options)?;
/// let bound = shadow.bind(device, receivers.as_entire_buffer_binding(), radiance.as_entire_buffer_binding())?;
/// // every frame
/// forest.update(spheres);
/// shadow.prepare(queue, forest, Limits::default(), light)?;
/// let mut encoder = device.create_command_encoder(&Default::default());
/// shadow.record(&mut encoder, &bound, None);
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct ShadowPass {
    kernel: Kernel,
    pub(crate) lit: Lit,
    pub(crate) nodes: Buffer,
    group: BindGroup,
    options: ShadowOptions,
}

impl ShadowPass {
    /// Makes the pipeline and sets room aside for blockers and light.
    pub fn new(device: &Device, options: ShadowOptions) -> Result<Self, Error> {
        let ShadowOptions {
            order,
            accumulation,
            max_blockers,
            max_emitters,
        } = options;
        let text = match sh_kernels::source(Pass::Shadow, order) {
            Some(_) => sh_kernels::shadow(order, accumulation).ok_or(Error::Accumulation {
                order,
                accumulation,
            })?,
            None => return Err(Error::Order(order)),
        };
        let label = format!("gaunt shadow order {order}, accumulated in {accumulation}");
        let module = module(device, &label, text)?;
        let max_nodes = max_blockers.saturating_mul(2);
        let lit = Lit::new(device, order, max_emitters)?;
        let room = room(device, "room for blockers", max_nodes, size_of::<Node>())?;
        let nodes = buffer(device, "gaunt blockers", room, BufferUsages::STORAGE);
        let storage = |binding, read_only| {
            let ty = BufferBindingType::Storage { read_only };
            buffer_entry(binding, ShaderStages::COMPUTE, ty, false)
        };
        let host = [storage(0, true), storage(1, true), storage(2, false)];
        let [record, emitters] = Lit::layout(0);
        let own = [record, emitters, storage(2, true)];
        let kernel = Kernel::new(device, &module, "shadow", [&own, &host]);
        let [record, emitters] = lit.entries(0);
        let blockers = BindGroupEntry {
            binding: 2,
            resource: nodes.as_entire_binding(),
        };
        let group = kernel.own(device, &[record, emitters, blockers]);
        Ok(Self {
            kernel,
            lit,
            nodes,
            group,
            options,
        })
    }

    /// The SH order of the light.
    pub(crate) fn order(&self) -> usize {
        self.options.order
    }

    /// The most blocker spheres.
    pub(crate) fn max_blockers(&self) -> u32 {
        self.options.max_blockers
    }

    /// Binds receivers ([`Receiver`], 32 bytes each, read) and radiance (red, green, blue, 0 as
    /// `vec4f`, 16 bytes each, written). The size of `receivers` says how many there are; `radiance` must
    /// hold as many. Both need `BufferUsages::STORAGE`.
    ///
    /// Every [`Tiles::AREA`] receivers one after another are a cluster: the tiles of a picture, or what the host put
    /// side by side.
    pub fn bind(
        &self,
        device: &Device,
        receivers: BufferBinding<'_>,
        radiance: BufferBinding<'_>,
    ) -> Result<Bound, Error> {
        let runs = tiles(&self.kernel, device, &receivers)?;
        let clusters = ClusterBinding {
            clusters: runs.as_entire_buffer_binding(),
            largest: Tiles::AREA as u32,
        };
        self.bind_clusters(device, receivers, clusters, radiance)
    }

    /// As [`bind`](Self::bind), with clusters of the host's.
    pub fn bind_clusters(
        &self,
        device: &Device,
        receivers: BufferBinding<'_>,
        clusters: ClusterBinding<'_>,
        radiance: BufferBinding<'_>,
    ) -> Result<Bound, Error> {
        bind_clusters(&self.kernel, device, receivers, clusters, radiance)
    }

    /// Uploads the blockers and the light for what is submitted next.
    pub fn prepare(
        &self,
        queue: &Queue,
        blockers: &Forest,
        limits: Limits,
        light: &Light,
    ) -> Result<(), Error> {
        let nodes = blockers.nodes();
        self.check(blockers.spheres(), nodes.len())?;
        self.lit.prepare(queue, light, nodes.len() as u32, limits)?;
        self.upload(queue, nodes);
        Ok(())
    }

    /// As [`prepare`](Self::prepare), without a hierarchy: every sphere counts for every receiver.
    pub fn prepare_spheres(
        &self,
        queue: &Queue,
        blockers: &[Sphere],
        light: &Light,
    ) -> Result<(), Error> {
        let count = blockers.len();
        self.check(count, count)?;
        self.lit
            .prepare(queue, light, count as u32, Limits::LEAVES)?;
        // Every leaf a tree of its own.
        let nodes: Vec<Node> = (0..)
            .zip(blockers)
            .map(|(at, &Sphere { center, radius })| Node {
                center,
                radius,
                area: radius * radius,
                parent: at,
                skip: at + 1,
                sphere: at,
            })
            .collect();
        self.upload(queue, &nodes);
        Ok(())
    }

    /// As [`prepare`](Self::prepare), where the host has written so many nodes to [`nodes`](Self::nodes) itself.
    pub fn prepare_light(
        &self,
        queue: &Queue,
        nodes: u32,
        limits: Limits,
        light: &Light,
    ) -> Result<(), Error> {
        self.check(nodes.div_ceil(2) as usize, nodes as usize)?;
        self.lit.prepare(queue, light, nodes, limits)
    }

    /// The tree of blockers: [`Node`] records. Usages `STORAGE` and `COPY_DST`.
    pub fn nodes(&self) -> &Buffer {
        &self.nodes
    }

    /// Records one compute pass that writes the radiance each receiver of a cluster would reflect with albedo 1. Every
    /// channel lies within 0 and its unshadowed value; receivers that are not covered get 0.
    pub fn record(
        &self,
        encoder: &mut CommandEncoder,
        bound: &Bound,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) {
        self.kernel
            .record(encoder, (&self.group, &[]), bound, timestamps);
    }

    fn check(&self, spheres: usize, nodes: usize) -> Result<(), Error> {
        let capacity = self.options.max_blockers;
        if spheres > capacity as usize || nodes > 2 * capacity as usize {
            return Err(Error::Blockers {
                count: spheres,
                capacity,
            });
        }
        Ok(())
    }

    fn upload(&self, queue: &Queue, nodes: &[Node]) {
        if !nodes.is_empty() {
            queue.write_buffer(&self.nodes, 0, bytemuck::cast_slice(nodes));
        }
    }
}

/// Clusters of [`Tiles::AREA`] receivers one after another.
pub(crate) fn tiles(
    kernel: &Kernel,
    device: &Device,
    receivers: &BufferBinding<'_>,
) -> Result<Buffer, Error> {
    let count = kernel.elements(&receiver_slot(receivers))? as u32;
    let runs: Vec<[u32; 2]> = (0..count)
        .step_by(Tiles::AREA)
        .map(|first| [first, (count - first).min(Tiles::AREA as u32)])
        .collect();
    Ok(device.create_buffer_init(&BufferInitDescriptor {
        label: Some("gaunt clusters"),
        contents: bytemuck::cast_slice(&runs),
        usage: BufferUsages::STORAGE,
    }))
}

/// Receivers, clusters and radiance for a kernel that works cluster by cluster.
pub(crate) fn bind_clusters(
    kernel: &Kernel,
    device: &Device,
    receivers: BufferBinding<'_>,
    clusters: ClusterBinding<'_>,
    radiance: BufferBinding<'_>,
) -> Result<Bound, Error> {
    let ClusterBinding { clusters, largest } = clusters;
    let clusters = Slot::with("clusters", 8, 0, clusters);
    let count = kernel.elements(&clusters)?;
    let radiance = Slot::with("radiance", 16, 1, radiance);
    let slots = [receiver_slot(&receivers), clusters, radiance];
    kernel.bind_groups(device, &slots, count, largest.into())
}

fn receiver_slot<'a>(binding: &BufferBinding<'a>) -> Slot<'a> {
    Slot::counting("receivers", size_of::<Receiver>() as u64, binding.clone())
}
