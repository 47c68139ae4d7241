//! The device's own clock.

use super::device::Gpu;
use crate::Error;
use wgpu::{BufferUsages, QuerySet};

/// Timestamps of passes on their way to the processor.
#[derive(Debug)]
pub struct Stamps {
    queries: QuerySet,
    resolved: wgpu::Buffer,
    staging: wgpu::Buffer,
}

impl Stamps {
    /// Room for so many. None where the device has no clock worth the name (a software driver's stands still while a
    /// dispatch runs), or they are more than a query set holds.
    pub fn new(gpu: &Gpu, count: u32) -> Option<Self> {
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

    /// Where passes write them.
    pub fn queries(&self) -> &QuerySet {
        &self.queries
    }

    /// Records their way to the processor, after the passes that write them.
    pub fn resolve(&self, encoder: &mut wgpu::CommandEncoder) {
        let size = self.resolved.size();
        let count = (size / u64::from(wgpu::QUERY_SIZE)) as u32;
        encoder.resolve_query_set(&self.queries, 0..count, &self.resolved, 0);
        encoder.copy_buffer_to_buffer(&self.resolved, 0, &self.staging, 0, size);
    }

    /// What was written, in units of `Queue::get_timestamp_period`. What was recorded must have been submitted.
    pub fn read(&self, gpu: &Gpu) -> Result<Vec<u64>, Error> {
        gpu.read(&self.staging, numbers)
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
