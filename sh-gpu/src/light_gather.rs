//! The light gather pass: light that spheres send on, at every receiver (Guerrero et al. 2008, section 6).

use crate::clusters::{bind_clusters, bind_tiles};
use crate::inputs::Inputs;
use crate::lighting::{buffer, room};
use crate::pipeline::Kernel;
use crate::scope::checked;
use crate::slot::Slot;
use crate::upload::{Kept, Known};
use crate::{Bound, ClusterBinding, Error, ShadowPass};
use sh_core::constants::NO_BODY;
use sh_kernels::Pass;
use sh_scene::{Blocking, Forest};
use std::sync::Arc;
use wgpu::{
    BindGroup, Buffer, BufferBinding, BufferUsages, CommandEncoder, ComputePassTimestampWrites,
    Device, Queue,
};

/// Light that spheres send on, shadowed by all others, on the host's device, queue and encoder.
///
/// It looks at the tree of blockers, and takes its limits, as they were prepared for a [`ShadowPass`]. What the nodes
/// send on is written by a [`LightUpdatePass`](crate::LightUpdatePass), or by the host ([`emission`](Self::emission)).
///
/// ```no_run
/// # use sh_gpu::{Error, LightGatherPass, ShadowPass};
/// # use sh_scene::{Blocking, Forest, Scene};
/// # fn frame(device: &wgpu::Device, queue: &wgpu::Queue, receivers: &wgpu::Buffer, radiance: &wgpu::Buffer,
/// #     shadow: &ShadowPass, scene: &Scene, forest: &Forest) -> Result<(), Error> {
/// let gather = LightGatherPass::new(device, shadow, Blocking::Discs)?;
/// let bound = gather.bind(device, receivers.as_entire_buffer_binding(), radiance.as_entire_buffer_binding())?;
/// // every frame, after `shadow.prepare`
/// let spheres = scene.objects.iter().map(|object| object.spheres.len());
/// gather.prepare(queue, forest, spheres)?;
/// let mut encoder = device.create_command_encoder(&Default::default());
/// gather.record(&mut encoder, &bound, None);
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct LightGatherPass {
    kernel: Arc<Kernel>,
    group: BindGroup,
    members: Buffer,
    emission: Buffer,
    max_nodes: u32,
    blocking: Blocking,
    kept: Kept<Members>,
    known: Known,
}

impl LightGatherPass {
    /// Makes the pipeline, and sets room aside for what the nodes of `shadow`'s tree of blockers send on:
    /// 16 (n² + 1) + 8 bytes a node at order n. [`Blocking::Sphere`] gives what [`Blocking::Runs`] does, in the same
    /// time.
    pub fn new(device: &Device, shadow: &ShadowPass, blocking: Blocking) -> Result<Self, Error> {
        Self::of(device, &shadow.inputs, blocking)
    }

    /// With light and blockers that other passes read as well.
    pub(crate) fn of(device: &Device, inputs: &Inputs, blocking: Blocking) -> Result<Self, Error> {
        checked(device, || {
            let order = inputs.order;
            let max_nodes = inputs.max_blockers.saturating_mul(2);
            let sent = 16 * (order * order + 1);
            let emission = room(device, "room for what spheres send on", max_nodes, sent)?;
            let members = room(device, "room for members of bodies", max_nodes, 8)?;
            let storage = BufferUsages::STORAGE;
            let open = storage | BufferUsages::COPY_SRC;
            let emission = buffer(device, "gaunt emission", emission, open);
            let members = buffer(device, "gaunt members", members, storage);
            Self::over(inputs, [members, emission], blocking, false)
        })
    }

    /// For what receivers mirror: it reads what was prepared for this one.
    pub(crate) fn for_gloss(&self, inputs: &Inputs) -> Result<Self, Error> {
        let memory = [self.members.clone(), self.emission.clone()];
        checked(inputs.pipelines.device(), || {
            Self::over(inputs, memory, self.blocking, true)
        })
    }

    /// Over the members of bodies, and what nodes send on.
    fn over(
        inputs: &Inputs,
        [members, emission]: [Buffer; 2],
        blocking: Blocking,
        gloss: bool,
    ) -> Result<Self, Error> {
        let gloss = ("GLOSS", gloss);
        let by_bodies = ("BY_BODIES", blocking == Blocking::Object);
        let (name, constants): (_, &[_]) = match blocking {
            Blocking::Discs => ("gather_discs", &[gloss]),
            Blocking::Runs | Blocking::Sphere | Blocking::Object => {
                ("gather_sums", &[by_bodies, gloss])
            }
        };
        let of = (Pass::LightGather, inputs.order, inputs.order);
        let kernel = inputs.pipelines.specialised(of, name, constants)?;
        let [lighting, _] = inputs.lit.bindings();
        let own = [
            lighting,
            inputs.tree(),
            ("members", members.as_entire_binding()),
            ("emission", emission.as_entire_binding()),
            inputs.lit.eye(),
        ];
        Ok(Self {
            group: kernel.own(inputs.pipelines.device(), &own),
            kernel,
            members,
            emission,
            max_nodes: inputs.max_blockers.saturating_mul(2),
            blocking,
            kept: Kept::default(),
            known: Known::default(),
        })
    }

    /// Binds receivers ([`sh_scene::Receiver`], 32 bytes each, read) and radiance (red, green, blue, 0 as `vec4f`, 16
    /// bytes each, added to), as [`ShadowPass::bind`] does.
    pub fn bind(
        &self,
        device: &Device,
        receivers: BufferBinding<'_>,
        radiance: BufferBinding<'_>,
    ) -> Result<Bound, Error> {
        bind_tiles(&self.kernel, device, receivers, written(radiance))
    }

    /// As [`bind`](Self::bind), with clusters of the host's.
    pub fn bind_clusters(
        &self,
        device: &Device,
        receivers: BufferBinding<'_>,
        clusters: ClusterBinding<'_>,
        radiance: BufferBinding<'_>,
    ) -> Result<Bound, Error> {
        bind_clusters(&self.kernel, device, receivers, clusters, written(radiance))
    }

    /// Uploads which node belongs to which body, for what is submitted next. `blockers` is the
    /// tree that the shadow pass was prepared with, `spheres` says how many of its leaves each body has.
    pub fn prepare(
        &self,
        queue: &Queue,
        blockers: &Forest,
        spheres: impl IntoIterator<Item = usize>,
    ) -> Result<(), Error> {
        let capacity = self.max_nodes / 2;
        let (count, nodes) = (blockers.spheres(), blockers.nodes().len());
        if nodes > self.max_nodes as usize || count > capacity as usize {
            return Err(Error::Blockers { count, capacity });
        }
        self.kept.with(|kept| {
            kept.find(blockers, spheres)?;
            self.known.write(queue, &self.members, &kept.members);
            Ok(())
        })
    }

    /// What hides what.
    pub fn blocking(&self) -> Blocking {
        self.blocking
    }

    /// What every node sends on: n² + 1 `vec4f` a node at order n, the SH coefficients in world space of radiance as a
    /// function of the direction from its centre (red, green, blue, 0), and the brightest radiance of any part of it.
    /// That of a node above the leaves is their mean by cross-section. Usages `STORAGE`, `COPY_SRC` and `COPY_DST`.
    pub fn emission(&self) -> &Buffer {
        &self.emission
    }

    /// Bytes of GPU memory that the pass owns.
    pub fn bytes(&self) -> u64 {
        self.members.size() + self.emission.size()
    }

    /// Bytes that have been uploaded since the pass was made.
    pub(crate) fn uploaded(&self) -> u64 {
        self.known.written()
    }

    /// The most nodes that there may be.
    pub(crate) fn max_nodes(&self) -> u32 {
        self.max_nodes
    }

    /// Records one compute pass that adds, to the radiance of each receiver of a cluster, what albedo 1 would reflect
    /// of the light that spheres send. What is added lies within 0 and the brightest radiance that the root sends on;
    /// receivers that are not covered are left alone.
    pub fn record(
        &self,
        encoder: &mut CommandEncoder,
        bound: &Bound,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) {
        self.kernel
            .record(encoder, (&self.group, &[]), bound, timestamps);
    }
}

/// What the host binds for the light that is gathered.
fn written(radiance: BufferBinding<'_>) -> Slot<'_> {
    Slot::with("radiance", 16, 1, radiance)
}

/// Which node belongs to which body, in memory that is kept.
#[derive(Default)]
struct Members {
    /// The body of each node, and the node that stands for all of that body.
    members: Vec<[u32; 2]>,
    /// One past the last sphere of each body.
    ends: Vec<usize>,
    /// The node that stands for each body.
    roots: Vec<u32>,
}

impl Members {
    fn find(
        &mut self,
        forest: &Forest,
        spheres: impl IntoIterator<Item = usize>,
    ) -> Result<(), Error> {
        let Self {
            members,
            ends,
            roots,
        } = self;
        ends.clear();
        ends.extend(spheres.into_iter().scan(0, |count, spheres| {
            *count += spheres;
            Some(*count)
        }));
        let (count, expected) = (ends.last().copied().unwrap_or(0), forest.spheres());
        if count != expected {
            return Err(Error::Spheres { count, expected });
        }
        let nodes = forest.nodes();
        roots.clear();
        roots.resize(ends.len(), 0);
        members.clear();
        members.resize(nodes.len(), [NO_BODY, 0]);
        for (at, node) in nodes.iter().enumerate().rev() {
            let body = if node.is_leaf(at) {
                ends.partition_point(|&end| end <= node.sphere as usize) as u32
            } else {
                // All children's, if they agree.
                let mut child = at + 1;
                let first = members[child][0];
                let mut one = true;
                while child < node.skip as usize {
                    one &= members[child][0] == first;
                    child = nodes[child].skip as usize;
                }
                if one { first } else { NO_BODY }
            };
            members[at][0] = body;
            if let Some(root) = roots.get_mut(body as usize) {
                *root = at as u32;
            }
        }
        for [body, root] in members {
            *root = roots.get(*body as usize).copied().unwrap_or_default();
        }
        Ok(())
    }
}
