//! The shadow pass by itself, frame after frame, with the time that each takes.

use gaunt::Error;
use gaunt::gpu::{Gpu, Stamps};
use sh_gpu::{Bound, ClusterBinding, ShadowOptions, ShadowPass};
use sh_scene::{Forest, Light, Limits, Receiver};
use std::ops::Range;
use std::time::Instant;
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{Buffer, BufferUsages, ComputePassTimestampWrites};

/// What time was taken with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clock {
    /// The device's: the pass alone.
    Device,
    /// The processor's: submitting and waiting as well.
    Wall,
}

/// Receivers in clusters on the GPU, and the pass that lights them.
pub struct Shadows<'a> {
    gpu: &'a Gpu,
    pass: ShadowPass,
    bound: Bound,
    receivers: Buffer,
    radiance: Buffer,
    clusters: Buffer,
    stamps: Option<Stamps>,
}

impl<'a> Shadows<'a> {
    /// Room for so many receivers, and `clusters`, ranges of them that stay the same.
    ///
    /// # Errors
    /// Where the device has no room, or there are no such orders.
    pub fn new(
        gpu: &'a Gpu,
        receivers: usize,
        clusters: &[Range<usize>],
        options: ShadowOptions,
    ) -> Result<Self, Error> {
        let device = &gpu.device;
        let buffer = |label, stride: usize, usage| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: receivers.max(1) as u64 * stride as u64,
                usage: BufferUsages::STORAGE | usage,
                mapped_at_creation: false,
            })
        };
        let of_receivers = buffer(
            "gaunt receivers",
            size_of::<Receiver>(),
            BufferUsages::COPY_DST,
        );
        let radiance = buffer("gaunt radiance", 16, BufferUsages::empty());
        let record = |range: &Range<usize>| [range.start as u32, range.len() as u32];
        let records: Vec<[u32; 2]> = clusters.iter().map(record).collect();
        let largest = clusters.iter().map(|range| range.len() as u32).max();
        let records = device.create_buffer_init(&BufferInitDescriptor {
            label: Some("gaunt clusters"),
            contents: bytemuck::cast_slice(&records),
            usage: BufferUsages::STORAGE,
        });
        let pass = ShadowPass::new(device, options)?;
        let clusters = ClusterBinding {
            clusters: records.as_entire_buffer_binding(),
            largest: largest.unwrap_or(0),
        };
        let bound = pass.bind_clusters(
            device,
            of_receivers.as_entire_buffer_binding(),
            clusters,
            radiance.as_entire_buffer_binding(),
        )?;
        gpu.check()?;
        Ok(Self {
            gpu,
            pass,
            bound,
            receivers: of_receivers,
            radiance,
            clusters: records,
            stamps: Stamps::new(gpu, 2),
        })
    }

    /// Bytes of GPU memory: receivers, their clusters, radiance, and what the pass owns.
    pub fn bytes(&self) -> u64 {
        let host = [&self.receivers, &self.radiance, &self.clusters];
        self.pass.bytes() + host.map(Buffer::size).iter().sum::<u64>()
    }

    /// What [`frame`](Self::frame) takes the time with.
    pub fn clock(&self) -> Clock {
        match self.stamps {
            Some(_) => Clock::Device,
            None => Clock::Wall,
        }
    }

    /// Uploads receivers, blockers and light, lights the receivers and tells the milliseconds of that, uploads not
    /// among them.
    ///
    /// # Errors
    /// Where more comes than there is room for, or the device fails.
    pub fn frame(
        &self,
        receivers: &[Receiver],
        blockers: &Forest,
        limits: Limits,
        light: &Light,
    ) -> Result<f64, Error> {
        let queue = &self.gpu.queue;
        queue.write_buffer(&self.receivers, 0, bytemuck::cast_slice(receivers));
        self.pass.prepare(queue, blockers, limits, light)?;
        self.gpu.submit(|_| {})?;
        let writes = self
            .stamps
            .as_ref()
            .map(|stamps| ComputePassTimestampWrites {
                query_set: stamps.queries(),
                beginning_of_pass_write_index: Some(0),
                end_of_pass_write_index: Some(1),
            });
        let start = Instant::now();
        self.gpu.submit(|encoder| {
            self.pass.record(encoder, &self.bound, writes);
            if let Some(stamps) = &self.stamps {
                stamps.resolve(encoder);
            }
        })?;
        let wall = start.elapsed().as_secs_f64() * 1e3;
        let Some(stamps) = &self.stamps else {
            return Ok(wall);
        };
        let stamps = stamps.read(self.gpu)?;
        let spent = stamps[1].saturating_sub(stamps[0]);
        Ok(spent as f64 * f64::from(queue.get_timestamp_period()) * 1e-6)
    }
}
