//! The light update pass: what every sphere of a body sends on (Guerrero et al. 2008, section 5).

use crate::lighting::{Lit, buffer, room};
use crate::pipeline::{Kernel, buffer_entry};
use crate::records::Sender;
use crate::scope::checked;
use crate::slot::Slot;
use crate::upload::{Kept, Known};
use crate::{Bound, ClusterBinding, Error, LightGatherPass, ShadowPass};
use glam::{Affine3A, Mat4, Quat};
use sh_kernels::Pass;
use sh_scene::surface::{COEFFICIENTS, DIRECTIONS, SurfacePoint, SurfaceSamples, cell_sums};
use sh_scene::{Forest, Object, Receiver};
use std::sync::Arc;
use wgpu::{
    BindGroup, BindGroupEntry, Buffer, BufferBindingType, BufferUsages, CommandEncoder,
    ComputePassTimestampWrites, Device, Queue, ShaderStages,
};

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
    place: Arc<Kernel>,
    project: Arc<Kernel>,
    raise: Arc<Kernel>,
    group: BindGroup,
    senders: Buffer,
    points: Buffer,
    stands: Buffer,
    exposed: Buffer,
    clusters: Buffer,
    receivers: Buffer,
    cells: Buffer,
    /// Radiance of the points: by the shadow pass alone, and with what has been gathered, where that is asked for.
    direct: Buffer,
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

/// The points' radiance with what has been gathered.
#[derive(Debug)]
struct Lighted {
    radiance: Buffer,
    gathered: Bound,
    projected: Bound,
}

/// What is uploaded, in memory that is kept.
#[derive(Default)]
struct Uploads {
    points: Vec<SurfacePoint>,
    /// For each of a sphere's directions the point that stands for it.
    stands: Vec<[u8; DIRECTIONS]>,
    /// How much can be seen of each sphere.
    exposed: Vec<[f32; COEFFICIENTS]>,
    clusters: Vec<[u32; 2]>,
    senders: Vec<Sender>,
    /// The node of each sphere.
    at: Vec<u32>,
}

/// What a pass was made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Counts {
    spheres: usize,
    points: usize,
    /// Points of the sphere that has most.
    largest: usize,
}

impl Counts {
    fn of<'a>(bodies: impl IntoIterator<Item = Shining<'a>>) -> Self {
        let mut counts = Self {
            spheres: 0,
            points: 0,
            largest: 0,
        };
        for body in bodies {
            counts.spheres += body.spheres;
            for sphere in 0..body.spheres {
                let points = body.surface.of(sphere).len();
                counts.points += points;
                counts.largest = counts.largest.max(points);
            }
        }
        counts
    }
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
        let entry = |binding, ty| buffer_entry(binding, ShaderStages::COMPUTE, ty, false);
        let storage = |binding, read_only| entry(binding, BufferBindingType::Storage { read_only });
        let [record, _] = Lit::layout(0);
        let own = [
            record,
            storage(1, true),
            storage(2, true),
            storage(3, true),
            storage(4, false),
            storage(5, true),
            storage(6, true),
        ];
        checked(device, || {
            let specialised = (Pass::LightUpdate, shadow.order(), shadow.order());
            let kernel = |name, read_only| {
                let groups = [&own[..], &[storage(0, read_only)]];
                shadow.pipelines.kernel(specialised, name, groups)
            };
            let (place, project, raise) = (
                kernel("place", false)?,
                kernel("project", true)?,
                kernel("raise", true)?,
            );

            let counts = Counts::of(bodies.clone());
            let number = |count: usize| u32::try_from(count).unwrap_or(u32::MAX);
            let make = |label, what, count: usize, size, usage| {
                let room = room(device, what, number(count), size)?;
                Ok::<_, Error>(buffer(device, label, room, usage | BufferUsages::STORAGE))
            };
            let (none, copied) = (BufferUsages::empty(), BufferUsages::COPY_SRC);
            let (spheres, of_points) = (counts.spheres, counts.points);
            let what = "room for surface points";
            let senders = size_of::<Sender>();
            let senders = make("gaunt senders", "room for spheres", spheres, senders, none)?;
            let stride = size_of::<SurfacePoint>();
            let points = make("gaunt surface points", what, of_points, stride, none)?;
            let stride = size_of::<Receiver>();
            let receivers = make("gaunt surface receivers", what, of_points, stride, none)?;
            let stands = make("gaunt standing points", what, spheres, DIRECTIONS, none)?;
            let size = COEFFICIENTS * size_of::<f32>();
            let exposed = make("gaunt exposed spheres", what, spheres, size, none)?;
            let clusters = make("gaunt surface clusters", what, spheres, 8, none)?;
            let direct = make("gaunt surface light", what, of_points, 16, copied)?;
            let sums = cell_sums();
            let cells = make("gaunt cells", what, sums.len(), size_of_val(&sums[0]), none)?;
            queue.write_buffer(&cells, 0, bytemuck::cast_slice(&sums[..]));

            let [record, _] = shadow.lit.entries(0);
            let rest = [
                &senders,
                &points,
                &cells,
                gather.emission(),
                &stands,
                &exposed,
            ];
            let rest = (1..).zip(rest).map(|(binding, buffer)| BindGroupEntry {
                binding,
                resource: buffer.as_entire_binding(),
            });
            let entries: Vec<_> = std::iter::once(record).chain(rest).collect();
            let group = place.own(device, &entries);
            let groups = spheres as u64;
            let place_slots = [of(&receivers, "receivers", stride as u64)];
            let placed = place.bind_groups(device, &place_slots, groups, 1)?;
            let all = || ClusterBinding {
                clusters: whole(&clusters),
                largest: number(counts.largest).max(1),
            };
            let shaded = shadow.bind_clusters(device, whole(&receivers), all(), whole(&direct))?;
            let project_of = |radiance: &Buffer| {
                project.bind_groups(device, &[of(radiance, "radiance", 16)], groups, 1)
            };
            let projected = project_of(&direct)?;
            let lit = match bounces {
                0 | 1 => None,
                _ => {
                    let radiance = make("gaunt surface light sent on", what, of_points, 16, none)?;
                    Some(Lighted {
                        gathered: gather.bind_clusters(
                            device,
                            whole(&receivers),
                            all(),
                            whole(&radiance),
                        )?,
                        projected: project_of(&radiance)?,
                        radiance,
                    })
                }
            };
            let nodes = of(&shadow.nodes, "nodes", size_of::<sh_scene::Node>() as u64);
            let raised = raise.bind_groups(device, &[nodes], gather.max_nodes().into(), 1)?;
            let pass = Self {
                place,
                project,
                raise,
                group,
                senders,
                points,
                stands,
                exposed,
                clusters,
                receivers,
                cells,
                direct,
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
        let own = [
            &self.senders,
            &self.points,
            &self.stands,
            &self.exposed,
            &self.clusters,
            &self.receivers,
            &self.cells,
            &self.direct,
        ];
        let lit = self.lit.as_ref().map(|lit| &lit.radiance);
        own.into_iter().chain(lit).map(Buffer::size).sum()
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
            points.write(queue, &self.points, &kept.points);
            stands.write(queue, &self.stands, &kept.stands);
            exposed.write(queue, &self.exposed, &kept.exposed);
            clusters.write(queue, &self.clusters, &kept.clusters);
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
            self.known[3].write(queue, &self.senders, senders);
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
        self.place.record(encoder, own, &self.placed, begin);
        shadow.record(encoder, &self.shaded, None);
        self.project.record(encoder, own, &self.projected, None);
        let end_of = |bounce: u32| end.clone().filter(|_| bounce == more);
        self.raise.record(encoder, own, &self.raised, end_of(0));
        let Some(lit) = &self.lit else {
            return;
        };
        for bounce in 1..=more {
            let (from, to) = (&self.direct, &lit.radiance);
            encoder.copy_buffer_to_buffer(from, 0, to, 0, from.size());
            gather.record(encoder, &lit.gathered, None);
            self.project.record(encoder, own, &lit.projected, None);
            self.raise
                .record(encoder, own, &self.raised, end_of(bounce));
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

/// All of a buffer of such records.
fn of<'a>(buffer: &'a Buffer, name: &'static str, stride: u64) -> Slot<'a> {
    Slot::counting(name, stride, whole(buffer))
}

fn whole(buffer: &Buffer) -> wgpu::BufferBinding<'_> {
    buffer.as_entire_buffer_binding()
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
