//! The light update pass: what every sphere of a body sends on (Guerrero et al. 2008, section 5).

mod kernels;
mod memory;

use crate::records::Sender;
use crate::scope::checked;
use crate::upload::{Kept, Known};
use crate::{Bound, Error, LightGatherPass, ShadowPass};
use glam::{Affine3A, Mat4, Quat};
use kernels::Kernels;
use memory::{Counts, Memory, of, whole};
use sh_scene::surface::{DIRECTIONS, MOST_COEFFICIENTS, SurfacePoint, SurfaceSamples};
use sh_scene::{Forest, Object, Receiver};
use wgpu::{BindGroup, Buffer, CommandEncoder, ComputePassTimestampWrites, Device, Queue};

/// A body whose spheres send light on.
#[derive(Clone, Copy, Debug)]
pub struct Shining<'a> {
    /// Points on its surface, sphere by sphere.
    pub surface: &'a SurfaceSamples,
    /// World from the space that they are in: a rotation, a uniform scale and a translation.
    pub transform: Affine3A,
    /// How many spheres it has: a body without a surface has black ones.
    pub spheres: usize,
}

impl<'a> From<&'a Object> for Shining<'a> {
    fn from(object: &'a Object) -> Self {
        Self {
            surface: &object.surface,
            transform: object.transform,
            spheres: object.spheres.len(),
        }
    }
}

/// What spheres send on of the light that falls on the surface around them, on the host's device, queue and encoder.
/// It is written to [`LightGatherPass::emission`].
///
/// ```no_run
/// # use sh_gpu::{Error, LightGatherPass, LightUpdatePass, ShadowPass, Shining};
/// # use sh_scene::{Forest, Scene};
/// # fn frame(device: &wgpu::Device, queue: &wgpu::Queue, shadow: &ShadowPass, gather: &LightGatherPass,
/// #     scene: &Scene, forest: &Forest) -> Result<(), Error> {
/// let bodies = || scene.objects.iter().map(Shining::from);
/// let update = LightUpdatePass::new(device, queue, shadow, gather, bodies(), 2)?;
/// // every frame, after `shadow.prepare` and `gather.prepare`
/// update.prepare(queue, bodies(), forest)?;
/// let mut encoder = device.create_command_encoder(&Default::default());
/// update.record(&mut encoder, shadow, gather, None);
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct LightUpdatePass {
    kernels: Kernels,
    group: BindGroup,
    memory: Memory,
    lit: Option<Lighted>,
    placed: Bound,
    shaded: Bound,
    projected: Bound,
    raised: Bound,
    counts: Counts,
    bounces: u32,
    within_bodies: bool,
    kept: Kept<Uploads>,
    /// What points, what stands for directions, points' runs, senders and what can be seen of them hold.
    known: [Known; 5],
}

/// The points' radiance with what has been gathered, for several bounces.
#[derive(Debug)]
struct Lighted {
    radiance: Buffer,
    gathered: Bound,
    projected: Bound,
}

impl Lighted {
    fn new(
        device: &Device,
        kernels: &Kernels,
        gather: &LightGatherPass,
        memory: &Memory,
        counts: Counts,
    ) -> Result<Self, Error> {
        let radiance = memory::lights(device, "gaunt surface light sent on", counts)?;
        let (receivers, all) = (whole(&memory.receivers), memory.all_clusters(counts));
        Ok(Self {
            gathered: gather.bind_clusters(device, receivers, all, whole(&radiance))?,
            projected: kernels.project(device, &radiance, counts.spheres as u64)?,
            radiance,
        })
    }
}

/// What is uploaded, in memory that is kept.
#[derive(Default)]
struct Uploads {
    points: Vec<SurfacePoint>,
    /// For each of a sphere's directions the point that stands for it.
    stands: Vec<[u8; DIRECTIONS]>,
    /// How much can be seen of each sphere.
    exposed: Vec<[f32; MOST_COEFFICIENTS]>,
    clusters: Vec<[u32; 2]>,
    senders: Vec<Sender>,
    /// The node of each sphere.
    at: Vec<u32>,
}

impl LightUpdatePass {
    /// Makes the pipelines and uploads the bodies' surface points, for light that is sent on `bounces` times. The points
    /// are lit by `shadow`, with the light and the tree of blockers that it is prepared with, and from the second bounce
    /// on by `gather` as well.
    ///
    /// 96 bytes a point are set aside, 112 with several bounces.
    pub fn new<'a>(
        device: &Device,
        queue: &Queue,
        shadow: &ShadowPass,
        gather: &LightGatherPass,
        bodies: impl IntoIterator<Item = Shining<'a>> + Clone,
        bounces: u32,
    ) -> Result<Self, Error> {
        checked(device, || {
            let kernels = Kernels::new(shadow)?;
            let counts = Counts::of(bodies.clone());
            let memory = Memory::new(device, queue, counts)?;
            let group = memory.group(device, &kernels.place, shadow, gather);
            let groups = counts.spheres as u64;
            let place_slots = [of(
                &memory.receivers,
                "receivers",
                size_of::<Receiver>() as u64,
            )];
            let placed = kernels.place.bind_groups(device, &place_slots, groups, 1)?;
            let (receivers, direct) = (whole(&memory.receivers), whole(&memory.direct));
            let shaded =
                shadow.bind_clusters(device, receivers, memory.all_clusters(counts), direct)?;
            let projected = kernels.project(device, &memory.direct, groups)?;
            let lit = match bounces {
                0 | 1 => None,
                _ => Some(Lighted::new(device, &kernels, gather, &memory, counts)?),
            };
            let nodes = of(&shadow.nodes, "nodes", size_of::<sh_scene::Node>() as u64);
            let nodes_of = u64::from(gather.max_nodes());
            let raised = kernels.raise.bind_groups(device, &[nodes], nodes_of, 1)?;
            let pass = Self {
                kernels,
                group,
                memory,
                lit,
                placed,
                shaded,
                projected,
                raised,
                counts,
                bounces,
                within_bodies: gather.blocking().within_bodies(),
                kept: Kept::default(),
                known: Default::default(),
            };
            pass.update_surfaces(queue, bodies)?;
            Ok(pass)
        })
    }

    /// Bytes of GPU memory that the pass owns.
    pub fn bytes(&self) -> u64 {
        let lit = self.lit.as_ref().map_or(0, |lit| lit.radiance.size());
        self.memory.bytes() + lit
    }

    /// Bytes that have been uploaded since the pass was made.
    pub(crate) fn uploaded(&self) -> u64 {
        self.known.iter().map(Known::written).sum()
    }

    /// How many dispatches [`record`](Self::record) records.
    pub(crate) fn dispatches(&self) -> usize {
        let of = |bounds: [&Bound; 3]| bounds.map(Bound::dispatches).iter().sum::<usize>();
        let first = of([&self.shaded, &self.projected, &self.raised]) + self.placed.dispatches();
        let more = self.bounces.saturating_sub(1) as usize;
        let each = |lit: &Lighted| of([&lit.gathered, &lit.projected, &self.raised]);
        first + self.lit.as_ref().map_or(0, |lit| more * each(lit))
    }

    /// Uploads the surface points anew, where [`prepare`](Self::prepare) alone does not do: of bodies that bend. They
    /// must have as many as those given to [`new`](Self::new).
    pub fn update_surfaces<'a>(
        &self,
        queue: &Queue,
        bodies: impl IntoIterator<Item = Shining<'a>> + Clone,
    ) -> Result<(), Error> {
        self.check(bodies.clone())?;
        self.kept.with(|kept| {
            kept.points.clear();
            kept.stands.clear();
            kept.exposed.clear();
            kept.clusters.clear();
            for body in bodies {
                for sphere in 0..body.spheres {
                    let own = body.surface.of(sphere);
                    let run = [kept.points.len() as u32, own.len() as u32];
                    kept.clusters.push(run);
                    kept.points.extend(own.iter().map(|point| SurfacePoint {
                        albedo: point.reflectance(self.within_bodies),
                        ..*point
                    }));
                    let stands = body.surface.stands(sphere, self.within_bodies);
                    kept.stands.push(stands);
                    let exposed = body.surface.exposed(sphere, self.within_bodies);
                    kept.exposed.push(exposed);
                }
            }
            let [points, stands, clusters, _, exposed] = &self.known;
            points.write(queue, &self.memory.points, &kept.points);
            stands.write(queue, &self.memory.stands, &kept.stands);
            exposed.write(queue, &self.memory.exposed, &kept.exposed);
            clusters.write(queue, &self.memory.clusters, &kept.clusters);
        });
        Ok(())
    }

    /// Uploads where the bodies stand and how their spheres are turned, for what is submitted next: 112 bytes a sphere.
    /// `blockers` is the tree of all their spheres that the shadow pass was prepared with.
    pub fn prepare<'a>(
        &self,
        queue: &Queue,
        bodies: impl IntoIterator<Item = Shining<'a>> + Clone,
        blockers: &Forest,
    ) -> Result<(), Error> {
        self.check(bodies.clone())?;
        let (count, expected) = (self.counts.spheres, blockers.spheres());
        if count != expected {
            return Err(Error::Spheres { count, expected });
        }
        self.kept.with(|Uploads { at, senders, .. }| {
            at.clear();
            at.resize(count, 0);
            senders.clear();
            for (index, node) in (0..).zip(blockers.nodes()) {
                if let Some(at) = at.get_mut(node.sphere as usize) {
                    *at = index;
                }
            }
            let mut first = 0;
            for (object, body) in (1..).zip(bodies) {
                let (_, turn, _) = body.transform.to_scale_rotation_translation();
                // A body without extent faces nowhere.
                let turn = Some(turn).filter(|q| q.is_finite()).unwrap_or_default();
                for sphere in 0..body.spheres {
                    let own = body.surface.rotations.get(sphere);
                    let own = own.map_or(Quat::IDENTITY, |q| Quat::from_array(*q));
                    let count = body.surface.of(sphere).len() as u32;
                    senders.push(Sender {
                        world_from_object: Mat4::from(body.transform),
                        turn: turn.to_array(),
                        frame: (turn * own).normalize().to_array(),
                        first,
                        count,
                        object,
                        node: at[senders.len()],
                    });
                    first += count;
                }
            }
            self.known[3].write(queue, &self.memory.senders, senders);
        });
        Ok(())
    }

    /// Records the passes that write what every node sends on. `shadow` and `gather` are those given to
    /// [`new`](Self::new).
    pub fn record(
        &self,
        encoder: &mut CommandEncoder,
        shadow: &ShadowPass,
        gather: &LightGatherPass,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) {
        let [begin, end] = first_and_last(timestamps);
        let own = (&self.group, &[][..]);
        let more = self.bounces.saturating_sub(1);
        self.kernels.place.record(encoder, own, &self.placed, begin);
        shadow.record(encoder, &self.shaded, None);
        self.kernels
            .project
            .record(encoder, own, &self.projected, None);
        let end_of = |bounce: u32| end.clone().filter(|_| bounce == more);
        let raise = &self.kernels.raise;
        raise.record(encoder, own, &self.raised, end_of(0));
        let Some(lit) = &self.lit else {
            return;
        };
        for bounce in 1..=more {
            let (from, to) = (&self.memory.direct, &lit.radiance);
            encoder.copy_buffer_to_buffer(from, 0, to, 0, from.size());
            gather.record(encoder, &lit.gathered, None);
            self.kernels
                .project
                .record(encoder, own, &lit.projected, None);
            raise.record(encoder, own, &self.raised, end_of(bounce));
        }
    }

    fn check<'a>(&self, bodies: impl IntoIterator<Item = Shining<'a>>) -> Result<(), Error> {
        let (found, expected) = (Counts::of(bodies), self.counts);
        if found != expected {
            return Err(Error::Points {
                count: found.spheres,
                points: found.points,
                spheres: expected.spheres,
                expected: expected.points,
            });
        }
        Ok(())
    }
}

/// The timestamps of a first and of a last pass.
fn first_and_last(
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
