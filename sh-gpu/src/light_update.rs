//! The light update pass: what every sphere of a body sends on (Guerrero et al. 2008, section 5).

use crate::surfaces::{PointBuffers, Surfaces, first_and_last};
use crate::{Bound, Error, LightGatherPass, ShadowPass};
use sh_scene::{Body, Forest};
use wgpu::{CommandEncoder, ComputePassTimestampWrites, Device, Queue};

/// What spheres send on of the light that falls on the surface around them, on the host's device, queue and encoder.
/// It is written to [`LightGatherPass::emission`].
///
/// ```no_run
/// # use sh_gpu::{Error, LightGatherPass, LightUpdatePass, ShadowPass};
/// # use sh_scene::{Body, Forest, Scene};
/// # fn frame(device: &wgpu::Device, queue: &wgpu::Queue, shadow: &ShadowPass, gather: &LightGatherPass,
/// #     scene: &Scene, forest: &Forest) -> Result<(), Error> {
/// let bodies = || scene.objects.iter().map(Body::from);
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
    surfaces: Surfaces,
    points: PointBuffers,
    placed: Bound,
    shaded: Bound,
    updated: Bound,
    /// With several bounces.
    gathered: Option<Bound>,
    bounces: u32,
}

impl LightUpdatePass {
    /// Makes the pipelines and uploads the bodies' surface points, for light that is sent on `bounces` times. The points
    /// are lit by `shadow`, with the light and the tree of blockers that it is prepared with, and from the second bounce
    /// on by `gather` as well.
    ///
    /// 112 bytes a point are set aside.
    pub fn new<'a>(
        device: &Device,
        queue: &Queue,
        shadow: &ShadowPass,
        gather: &LightGatherPass,
        bodies: impl IntoIterator<Item = Body<'a>> + Clone,
        bounces: u32,
    ) -> Result<Self, Error> {
        let surfaces = Surfaces::new(device, queue, &shadow.inputs, gather, bodies)?;
        let points = surfaces.point_buffers(device)?;
        let [receivers, radiance, sent] = points.all();
        let clusters = || surfaces.clusters();
        let lit = radiance.clone();
        let gathered = match bounces {
            0 | 1 => None,
            _ => {
                let (receivers, sent) = (receivers.clone(), sent.clone());
                Some(gather.bind_clusters(device, receivers, clusters(), sent)?)
            }
        };
        Ok(Self {
            placed: surfaces.bind_points(device, receivers.clone())?,
            shaded: shadow.bind_clusters(device, receivers, clusters(), lit)?,
            updated: surfaces.bind_update(device, [radiance, sent])?,
            gathered,
            surfaces,
            points,
            bounces,
        })
    }

    /// Bytes of GPU memory that the pass owns.
    pub fn bytes(&self) -> u64 {
        self.surfaces.bytes() + self.points.bytes()
    }

    /// Uploads the surface points anew, where [`prepare`](Self::prepare) alone does not do: of bodies that bend. They
    /// must have as many as those given to [`new`](Self::new).
    ///
    /// # Errors
    /// Where they have not.
    pub fn update_surfaces<'a>(
        &self,
        queue: &Queue,
        bodies: impl IntoIterator<Item = Body<'a>> + Clone,
    ) -> Result<(), Error> {
        self.surfaces.update_surfaces(queue, bodies)
    }

    /// Uploads where the bodies stand and how their spheres are turned, for what is submitted next: 112 bytes a sphere.
    /// `blockers` is the tree of all their spheres that the shadow pass was prepared with.
    ///
    /// # Errors
    /// Where bodies or tree are others than those that the pass was made for.
    pub fn prepare<'a>(
        &self,
        queue: &Queue,
        bodies: impl IntoIterator<Item = Body<'a>> + Clone,
        blockers: &Forest,
    ) -> Result<(), Error> {
        self.surfaces.prepare(queue, bodies, blockers)
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
        let more = self.gathered.as_ref().map_or(0, |_| self.bounces - 1);
        let end_of = |bounce: u32| end.clone().filter(|_| bounce == more);
        self.surfaces.record_points(encoder, &self.placed, begin);
        shadow.record(encoder, &self.shaded, None);
        self.points.clear_sent(encoder);
        self.surfaces
            .record_update(encoder, &self.updated, end_of(0));
        let bounces = self.gathered.iter().cycle().zip(1..=more);
        for (gathered, bounce) in bounces {
            self.points.clear_sent(encoder);
            gather.record(encoder, gathered, None);
            self.surfaces
                .record_update(encoder, &self.updated, end_of(bounce));
        }
    }
}
