//! A picture on the GPU: the passes record, this submits and reads back.

use super::Frame;
use crate::Error;
use crate::gpu::Gpu;
use crate::report::Times;
use sh_gpu::Renderer;
use std::time::Instant;
use wgpu::{BufferUsages, QuerySet};

/// Runs the plan. The picture is linear radiance, row by row from the top.
pub fn picture(gpu: &Gpu, frame: &Frame, times: &mut Times) -> Result<Vec<[f32; 3]>, Error> {
    let Frame {
        scene,
        plan,
        view,
        light,
    } = frame;
    let renderer = times.measure("upload", || -> Result<Renderer, Error> {
        let renderer = Renderer::new(&gpu.device, &gpu.queue, scene, plan, view)?;
        renderer.prepare(&gpu.queue, scene, light, view)?;
        gpu.submit(|_| {})?;
        Ok(renderer)
    })?;
    let stamps = Stamps::new(gpu, renderer.timestamps());
    let picture = renderer.picture();
    let staging = gpu.staging(picture.size());
    let start = Instant::now();
    gpu.submit(|encoder| {
        renderer.record(encoder, stamps.as_ref().map(|stamps| &stamps.queries));
        if let Some(stamps) = &stamps {
            stamps.resolve(encoder);
        }
    })?;
    let mut rest = start.elapsed().as_secs_f64();
    if let Some(stamps) = stamps {
        let stamps = gpu.read(&stamps.staging, numbers)?;
        for (pass, nanoseconds) in renderer.times(&stamps, gpu.queue.get_timestamp_period()) {
            times.add(pass.name(), nanoseconds * 1e-9);
            rest -= nanoseconds * 1e-9;
        }
    }
    // All passes, or what recording, submitting and waiting took besides them.
    times.add("frame", rest.max(0.0));
    times.measure("read back", || {
        gpu.submit(|encoder| {
            encoder.copy_buffer_to_buffer(picture, 0, &staging, 0, picture.size());
        })?;
        gpu.read(&staging, |bytes| {
            let pixels: &[[f32; 4]] = bytemuck::cast_slice(bytes);
            pixels.iter().map(|[r, g, b, _]| [*r, *g, *b]).collect()
        })
    })
}

/// Timestamps of a frame on their way to the processor.
struct Stamps {
    queries: QuerySet,
    resolved: wgpu::Buffer,
    staging: wgpu::Buffer,
}

impl Stamps {
    /// None where the device has no clock worth the name (a software driver's stands still while a dispatch
    /// runs), or the frame has more passes than a query set holds.
    fn new(gpu: &Gpu, count: u32) -> Option<Self> {
        if !gpu.timestamps || gpu.software || count > wgpu::QUERY_SET_MAX_QUERIES {
            return None;
        }
        let queries = gpu.device.create_query_set(&wgpu::QuerySetDescriptor {
            label: Some("gaunt timestamps"),
            ty: wgpu::QueryType::Timestamp,
            count,
        });
        let size = u64::from(count) * u64::from(wgpu::QUERY_SIZE);
        let resolved = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("gaunt timestamps"),
            size,
            usage: BufferUsages::QUERY_RESOLVE | BufferUsages::COPY_SRC,
            mapped_at_creation: false,
        });
        Some(Self {
            queries,
            resolved,
            staging: gpu.staging(size),
        })
    }

    fn resolve(&self, encoder: &mut wgpu::CommandEncoder) {
        let size = self.resolved.size();
        let count = (size / u64::from(wgpu::QUERY_SIZE)) as u32;
        encoder.resolve_query_set(&self.queries, 0..count, &self.resolved, 0);
        encoder.copy_buffer_to_buffer(&self.resolved, 0, &self.staging, 0, size);
    }
}

fn numbers(bytes: &[u8]) -> Vec<u64> {
    bytes
        .as_chunks()
        .0
        .iter()
        .map(|b| u64::from_ne_bytes(*b))
        .collect()
}
