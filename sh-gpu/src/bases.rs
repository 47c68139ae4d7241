//! Bodies whose light is told in few functions, on the GPU: the passes `points`, `basis_update` and `basis_gather` over them.

use crate::clusters::{bind_clusters, bind_tiles};
use crate::inputs::Inputs;
use crate::lighting::{buffer, room};
use crate::pipeline::Kernel;
use crate::records::Basis;
use crate::scope::checked;
use crate::slot::Slot;
use crate::surfaces::first_and_last;
use crate::upload::{Kept, Known, filled};
use crate::{Bound, ClusterBinding, Error};
use glam::Mat4;
use sh_kernels::Pass;
use sh_scene::basis::{MOST_COEFFICIENTS, PATCH_SAMPLES, Patch, REGION_PATCHES};
use sh_scene::{BasisBody, Receiver};
use std::sync::Arc;
use wgpu::{
    BindGroup, Buffer, BufferBinding, BufferSize, BufferUsages, CommandEncoder,
    ComputePassTimestampWrites, Device, Queue,
};

/// What is known of bodies, with what their patches send on, and the kernels that find and gather it.
#[derive(Debug)]
pub(crate) struct Bases {
    update: Update,
    gather: Gather,
    memory: Memory,
    counts: Counts,
    coefficients: usize,
    records: Kept<Vec<Basis>>,
    known: Known,
}

/// The kernels of `points` and `basis_update`, with what they are bound to for good.
#[derive(Debug)]
struct Update {
    place: Arc<Kernel>,
    weigh: Arc<Kernel>,
    shine: Arc<Kernel>,
    raise: Arc<Kernel>,
    group: BindGroup,
    shone: Bound,
    raised: Bound,
}

/// Those of `basis_gather`.
#[derive(Debug)]
struct Gather {
    seen: Arc<Kernel>,
    /// With several bounces.
    points: Option<Arc<Kernel>>,
    /// Where anything mirrors light.
    gloss: Option<Arc<Kernel>>,
    group: BindGroup,
}

/// Who gathers what patches send.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Gathering {
    /// What is seen, with what bodies send themselves.
    Seen,
    /// Points of patches, which have that in their weights.
    Points,
    /// What mirrors light.
    Gloss,
}

/// What bodies have together, and the largest of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Counts {
    bodies: usize,
    patches: usize,
    functions: usize,
    /// Of a patch and a function.
    pairs: usize,
    /// Points that take light that bodies have sent.
    few: usize,
    /// Clusters of these, and of all points.
    clusters: [usize; 2],
    /// Of a function and a point, of all and of the few.
    duals: usize,
    /// Elements of what patches and regions send on.
    light: usize,
    /// Patches of the body that has most.
    largest: usize,
}

impl Counts {
    fn of<'a>(bodies: impl Iterator<Item = BasisBody<'a>>, coefficients: usize) -> Self {
        bodies.fold(Self::default(), |all, body| {
            let (patches, functions) = (body.basis.patches(), body.basis.count());
            let few = body.basis.few();
            let [first, rest] = [few, patches - few].map(|some| some.div_ceil(REGION_PATCHES));
            Self {
                bodies: all.bodies + 1,
                patches: all.patches + patches,
                functions: all.functions + functions,
                pairs: all.pairs + patches * functions,
                few: all.few + few,
                clusters: [all.clusters[0] + first, all.clusters[1] + first + rest],
                duals: all.duals + (patches + few) * functions,
                light: all.light + elements(patches, coefficients),
                largest: all.largest.max(patches),
            }
        })
    }
}

/// What a body's patches and regions send on, and the brightest.
fn elements(patches: usize, coefficients: usize) -> usize {
    2 * patches + patches / REGION_PATCHES * coefficients + 1
}

#[derive(Debug)]
struct Memory {
    bodies: Buffer,
    points: Buffer,
    duals: Buffer,
    sends: Buffer,
    owns: Buffer,
    lobes: Buffer,
    patches: Buffer,
    regions: Buffer,
    weights: Buffer,
    light: Buffer,
    /// Runs of points that lie together: those that take light that bodies have sent come first.
    clusters: Buffer,
}

impl Bases {
    /// Makes the pipelines for so many bounces and uploads what is known of the bodies.
    pub fn new<'a>(
        device: &Device,
        inputs: &Inputs,
        bodies: impl Iterator<Item = BasisBody<'a>> + Clone,
        (bounces, gloss): (u32, bool),
    ) -> Result<Self, Error> {
        checked(device, || {
            let coefficients = inputs.order * inputs.order;
            let counts = Counts::of(bodies.clone(), coefficients);
            let memory = Memory::new(device, counts, bodies)?;
            let update = Update::new(device, inputs, &memory, (counts, coefficients))?;
            let gather = Gather::new(device, inputs, &memory, (bounces, gloss))?;
            Ok(Self {
                update,
                gather,
                memory,
                counts,
                coefficients,
                records: Kept::default(),
                known: Known::default(),
            })
        })
    }

    /// Bytes of GPU memory.
    pub fn bytes(&self) -> u64 {
        self.memory.all().map(Buffer::size).sum()
    }

    /// Bytes that have been uploaded since it was made.
    pub fn uploaded(&self) -> u64 {
        self.known.written()
    }

    /// How many points there are.
    pub fn points(&self) -> u64 {
        self.counts.patches as u64
    }

    /// Points that lie together, in clusters: all, or the few that take light that bodies have sent.
    pub fn clusters(&self, few: bool) -> ClusterBinding<'_> {
        let count = self.counts.clusters[usize::from(!few)] as u64;
        ClusterBinding {
            clusters: BufferBinding {
                buffer: &self.memory.clusters,
                offset: 0,
                size: BufferSize::new(count * size_of::<[u32; 2]>() as u64),
            },
            largest: REGION_PATCHES as u32,
        }
    }

    /// Uploads where the bodies are.
    pub fn prepare<'a>(
        &self,
        queue: &Queue,
        bodies: impl Iterator<Item = BasisBody<'a>> + Clone,
    ) -> Result<(), Error> {
        let found = Counts::of(bodies.clone(), self.coefficients);
        if found != self.counts {
            return Err(Error::Patches {
                bodies: found.bodies,
                patches: found.patches,
                expected: self.counts.bodies,
                made_for: self.counts.patches,
            });
        }
        self.records.with(|records| {
            records.clear();
            let mut first = Counts::default();
            for body in bodies {
                records.push(self.record(&body, first));
                let own = Counts::of(std::iter::once(body), self.coefficients);
                first.patches += own.patches;
                first.few += own.few;
                first.functions += own.functions;
                first.duals += own.duals;
                first.pairs += own.pairs;
                first.light += own.light;
            }
            self.known.write(queue, &self.memory.bodies, records);
        });
        Ok(())
    }

    /// A body whose parts begin where those before it end.
    fn record(&self, body: &BasisBody, first: Counts) -> Basis {
        let (shape, (_, scale)) = (body.basis.shape(), body.placed());
        let inverse = body.transform.inverse();
        let placed = scale > 0.0 && inverse.is_finite();
        let number = |count: usize| u32::try_from(count).unwrap_or(u32::MAX);
        Basis {
            world_from_object: Mat4::from(body.transform),
            object_from_world: if placed {
                Mat4::from(inverse)
            } else {
                Mat4::IDENTITY
            },
            center: body.transform.transform_point3(shape.center),
            radius: shape.radius * scale,
            scale: if placed { scale } else { 0.0 },
            object: body.object,
            first: number(first.patches),
            patches: number(body.basis.patches()),
            functions: number(body.basis.count()),
            weights: number(first.functions),
            duals: number(first.duals),
            sends: number(first.pairs),
            light: number(first.light),
            own: u32::from(!body.basis.parts().own.is_empty()),
            few: number(body.basis.few()),
            first_few: number(first.few),
        }
    }

    /// Binds what the pass `points` writes.
    pub fn bind_points(
        &self,
        device: &Device,
        receivers: BufferBinding<'_>,
    ) -> Result<Bound, Error> {
        let points = self.memory.points.as_entire_buffer_binding();
        let slots = [
            Slot::counting("receivers", size_of::<Receiver>() as u64, receivers),
            Slot::with("points", 16, 2, points),
        ];
        let (bodies, largest) = (self.counts.bodies as u64, self.counts.largest as u64);
        self.update
            .place
            .bind_groups(device, &slots, bodies, largest)
    }

    /// Binds what the pass `basis_update` reads of points: light that comes directly, and light that bodies have sent.
    pub fn bind_update(
        &self,
        device: &Device,
        [radiance, gathered]: [BufferBinding<'_>; 2],
    ) -> Result<Bound, Error> {
        let slots = [
            Slot::counting("radiance", 16, radiance),
            Slot::with("gathered", 16, 1, gathered),
            Slot::with("duals", 4, 0, self.memory.duals.as_entire_buffer_binding()),
            Slot::with(
                "before",
                16,
                0,
                self.memory.light.as_entire_buffer_binding(),
            ),
            Slot::with(
                "weights",
                16,
                0,
                self.memory.weights.as_entire_buffer_binding(),
            ),
        ];
        let bodies = self.counts.bodies as u64;
        self.update.weigh.bind_groups(device, &slots, bodies, 1)
    }

    /// Binds receivers and what is added to: tiles of a picture, or clusters.
    pub fn bind(
        &self,
        device: &Device,
        receivers: BufferBinding<'_>,
        clusters: Option<ClusterBinding<'_>>,
        radiance: BufferBinding<'_>,
        kind: Gathering,
    ) -> Result<Bound, Error> {
        let written = Slot::with("radiance", 16, 1, radiance);
        let kernel = self.gather.of(kind);
        match clusters {
            Some(clusters) => bind_clusters(kernel, device, receivers, clusters, written),
            None => bind_tiles(kernel, device, receivers, written),
        }
    }

    /// Records the pass `points`: bodies have sent themselves nothing yet.
    pub fn record_points(
        &self,
        encoder: &mut CommandEncoder,
        bound: &Bound,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) {
        encoder.clear_buffer(&self.memory.light, 0, None);
        let own = (&self.update.group, &[][..]);
        self.update.place.record(encoder, own, bound, timestamps);
    }

    /// Records the pass `basis_update`.
    pub fn record_update(
        &self,
        encoder: &mut CommandEncoder,
        bound: &Bound,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) {
        let [begin, end] = first_and_last(timestamps);
        let (own, update) = ((&self.update.group, &[][..]), &self.update);
        update.weigh.record(encoder, own, bound, begin);
        update.shine.record(encoder, own, &update.shone, None);
        update.raise.record(encoder, own, &update.raised, end);
    }

    /// Dispatches of [`record_update`](Self::record_update).
    pub fn update_dispatches(&self, bound: &Bound) -> usize {
        let Update { shone, raised, .. } = &self.update;
        bound.dispatches() + shone.dispatches() + raised.dispatches()
    }

    /// Records the pass `basis_gather`; `kind` as it was bound.
    pub fn record_gather(
        &self,
        encoder: &mut CommandEncoder,
        bound: &Bound,
        kind: Gathering,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) {
        let group = (&self.gather.group, &[][..]);
        self.gather
            .of(kind)
            .record(encoder, group, bound, timestamps);
    }
}

impl Update {
    fn new(
        device: &Device,
        inputs: &Inputs,
        memory: &Memory,
        (counts, coefficients): (Counts, usize),
    ) -> Result<Self, Error> {
        let specialised = (Pass::BasisUpdate, inputs.order, inputs.order);
        let kernel = |name| inputs.pipelines.kernel(specialised, name);
        let [shine, raise] = [kernel("shine")?, kernel("raise")?];
        let own = [("bodies", memory.bodies.as_entire_binding())];
        let light = || Slot::with("light", 16, 0, memory.light.as_entire_buffer_binding());
        let (bodies, largest) = (counts.bodies as u64, counts.largest as u64);
        let sent = [
            Slot::counting("sends", 16, memory.sends.as_entire_buffer_binding()),
            Slot::with("owns", 16, 1, memory.owns.as_entire_buffer_binding()),
            Slot::with("weighed", 16, 0, memory.weights.as_entire_buffer_binding()),
            light(),
        ];
        let lobes = memory.lobes.as_entire_buffer_binding();
        let lobes = [Slot::counting("lobes", 4, lobes), light()];
        let regions = largest / REGION_PATCHES as u64 * coefficients as u64 + 1;
        Ok(Self {
            shone: shine.bind_groups(device, &sent, bodies, largest)?,
            raised: raise.bind_groups(device, &lobes, bodies, regions)?,
            group: shine.own(device, &own),
            place: kernel("place")?,
            weigh: kernel("weigh")?,
            shine,
            raise,
        })
    }
}

impl Gather {
    fn new(
        device: &Device,
        inputs: &Inputs,
        memory: &Memory,
        (bounces, gloss): (u32, bool),
    ) -> Result<Self, Error> {
        let of = (Pass::BasisGather, inputs.order, inputs.order);
        let kernel = |own: bool, gloss: bool| {
            let constants = [("OWN_LIGHT", own), ("GLOSS", gloss)];
            inputs.pipelines.specialised(of, "gather", &constants)
        };
        let seen = kernel(true, false)?;
        let [lighting, _] = inputs.lit.bindings();
        let own = [
            lighting,
            inputs.tree(),
            ("bodies", memory.bodies.as_entire_binding()),
            ("patches", memory.patches.as_entire_binding()),
            ("regions", memory.regions.as_entire_binding()),
            ("light", memory.light.as_entire_binding()),
            inputs.lit.eye(),
        ];
        Ok(Self {
            group: seen.own(device, &own),
            points: (bounces > 1).then(|| kernel(false, false)).transpose()?,
            gloss: gloss.then(|| kernel(true, true)).transpose()?,
            seen,
        })
    }

    fn of(&self, kind: Gathering) -> &Kernel {
        let other = match kind {
            Gathering::Seen => None,
            Gathering::Points => self.points.as_ref(),
            Gathering::Gloss => self.gloss.as_ref(),
        };
        other.unwrap_or(&self.seen)
    }
}

impl Memory {
    fn new<'a>(
        device: &Device,
        counts: Counts,
        bodies: impl Iterator<Item = BasisBody<'a>> + Clone,
    ) -> Result<Self, Error> {
        let what = "room for what is known of bodies";
        let count = |count: usize| u32::try_from(count).unwrap_or(u32::MAX);
        let own = |label, number: usize, size: usize| {
            let room = room(device, what, count(number), size)?;
            Ok::<_, Error>(buffer(device, label, room, BufferUsages::STORAGE))
        };
        let known = |label, bytes: &[u8]| {
            room(device, what, count(bytes.len()), 1)?;
            filled(device, label, bytes, BufferUsages::STORAGE)
        };
        let four = |[x, y, z]: [f32; 3]| [x, y, z, 0.0];
        let bases = || bodies.clone().map(|body| body.basis);
        let points = bases().flat_map(|basis| {
            let samples = basis.samples();
            let order = basis.order().iter();
            order.map(|patch| samples[patch * PATCH_SAMPLES])
        });
        let points = points.flat_map(|point| [four(point.position), four(point.normal)]);
        let duals = bases().flat_map(|basis| basis.dual().iter().chain(basis.few_dual()));
        let duals = duals.copied();
        let sends = bases().flat_map(|basis| basis.sends()).map(|x| four(*x));
        // A body that sends itself nothing has as much room as the others, so that both are found alike.
        let owns = bases().flat_map(|basis| {
            let (own, all) = (&basis.parts().own, basis.sends().len());
            (0..all).map(|i| four(own.get(i).copied().unwrap_or_default()))
        });
        let lobes = bases().flat_map(|basis| basis.lobes()).flatten().copied();
        let patches = bases().flat_map(|basis| &basis.parts().patches).copied();
        let regions = bases().flat_map(|basis| &basis.shape().regions).copied();
        let few = bases().map(|basis| basis.few());
        let rest = bases().map(|basis| basis.patches() - basis.few());
        let mut clusters = Vec::new();
        let mut first = 0;
        for end in few.chain(rest) {
            let end = first + end;
            let runs = (first..end).step_by(REGION_PATCHES);
            clusters.extend(runs.map(|at| [count(at), count((end - at).min(REGION_PATCHES))]));
            first = end;
        }
        let floats = |all: Vec<f32>| bytemuck::cast_slice(&all).to_vec();
        let vectors = |all: Vec<[f32; 4]>| bytemuck::cast_slice(&all).to_vec();
        Ok(Self {
            bodies: own("gaunt bases", counts.bodies, size_of::<Basis>())?,
            points: known("gaunt patch points", &vectors(points.collect()))?,
            duals: known("gaunt duals", &floats(duals.collect()))?,
            sends: known("gaunt sends", &vectors(sends.collect()))?,
            owns: known("gaunt owns", &vectors(owns.collect()))?,
            lobes: known("gaunt lobes", &floats(lobes.collect()))?,
            patches: known(
                "gaunt patches",
                bytemuck::cast_slice(&patches.collect::<Vec<Patch>>()),
            )?,
            regions: known(
                "gaunt regions",
                bytemuck::cast_slice(&regions.collect::<Vec<_>>()),
            )?,
            weights: own("gaunt weights", counts.functions, 16)?,
            light: own("gaunt patch light", counts.light, 16)?,
            clusters: known("gaunt patch clusters", bytemuck::cast_slice(&clusters))?,
        })
    }

    fn all(&self) -> impl Iterator<Item = &Buffer> {
        let known = [&self.points, &self.duals, &self.sends, &self.owns];
        let seen = [&self.lobes, &self.patches, &self.regions, &self.clusters];
        let made = [&self.bodies, &self.weights, &self.light];
        known.into_iter().chain(seen).chain(made)
    }
}

const _: () = assert!(MOST_COEFFICIENTS == 36, "lobes are of order 6");
