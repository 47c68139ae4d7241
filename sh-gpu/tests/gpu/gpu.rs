//! A device for the tests, with WebGPU's default limits, and reading back.

use sh_gpu::Pipelines;
use std::sync::Mutex;
use wgpu::{Buffer, BufferUsages, CommandEncoder, Device, Queue};

/// An adapter's device and queue.
pub struct Gpu {
    pub instance: wgpu::Instance,
    pub device: Device,
    pub queue: Queue,
    pub timestamps: bool,
    /// Shared by tests: compiling pipelines takes longer than all else.
    pub pipelines: Pipelines,
    errors: std::sync::Arc<Mutex<Vec<String>>>,
}

impl Gpu {
    /// The first adapter there is, or why there is none.
    pub fn new() -> Result<Self, String> {
        Self::with(wgpu::Limits::default())
    }

    /// With exactly these limits.
    pub fn with(limits: wgpu::Limits) -> Result<Self, String> {
        let descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
        Self::of(wgpu::Instance::new(descriptor), limits)
    }

    /// Another device of the same instance.
    pub fn sibling(&self) -> Result<Self, String> {
        Self::of(self.instance.clone(), wgpu::Limits::default())
    }

    fn of(instance: wgpu::Instance, limits: wgpu::Limits) -> Result<Self, String> {
        let adapter = pollster::block_on(instance.request_adapter(&Default::default()))
            .map_err(|error| format!("there is no GPU adapter: {error}"))?;
        let timestamps = adapter.features() & wgpu::Features::TIMESTAMP_QUERY;
        let (device, queue) = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor {
            label: Some("tests"),
            required_features: timestamps,
            required_limits: limits,
            ..Default::default()
        }))
        .map_err(|error| format!("{} gives no device: {error}", adapter.get_info().name))?;
        let errors = std::sync::Arc::new(Mutex::new(Vec::new()));
        let seen = errors.clone();
        device.on_uncaptured_error(std::sync::Arc::new(move |error: wgpu::Error| {
            seen.lock().unwrap().push(error.to_string());
        }));
        let timestamps = !timestamps.is_empty();
        Ok(Self {
            pipelines: Pipelines::new(&device),
            instance,
            device,
            queue,
            timestamps,
            errors,
        })
    }

    /// Fails if the device complained since the last time.
    pub fn errors(&self) -> Result<(), libtest_mimic::Failed> {
        match std::mem::take(&mut *self.errors.lock().unwrap()).first() {
            None => Ok(()),
            Some(error) => Err(format!("the device complains: {error}").into()),
        }
    }

    /// A storage buffer with contents.
    pub fn buffer<T: bytemuck::NoUninit>(&self, contents: &[T]) -> Buffer {
        let bytes: &[u8] = bytemuck::cast_slice(contents);
        let buffer = self.room(bytes.len() as u64);
        self.queue.write_buffer(&buffer, 0, bytes);
        buffer
    }

    /// An empty storage buffer.
    pub fn room(&self, size: u64) -> Buffer {
        self.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("tests"),
            size,
            usage: BufferUsages::STORAGE | BufferUsages::COPY_SRC | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        })
    }

    /// Records, submits and waits.
    pub fn submit(&self, record: impl FnOnce(&mut CommandEncoder)) {
        let mut encoder = self.device.create_command_encoder(&Default::default());
        record(&mut encoder);
        self.queue.submit([encoder.finish()]);
        self.device
            .poll(wgpu::PollType::wait_indefinitely())
            .unwrap();
    }

    /// The contents of a buffer.
    pub fn read<T: bytemuck::Pod>(&self, buffer: &Buffer) -> Vec<T> {
        let copy = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("tests"),
            size: buffer.size(),
            usage: BufferUsages::MAP_READ | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        self.submit(|encoder| encoder.copy_buffer_to_buffer(buffer, 0, &copy, 0, buffer.size()));
        copy.slice(..)
            .map_async(wgpu::MapMode::Read, |result| result.unwrap());
        self.device
            .poll(wgpu::PollType::wait_indefinitely())
            .unwrap();
        let view = copy.slice(..).get_mapped_range().unwrap();
        bytemuck::pod_collect_to_vec(&view)
    }
}
