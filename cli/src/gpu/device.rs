//! An opened device, and what is submitted to it.

use crate::Error;
use std::sync::{Arc, Mutex, PoisonError};
use wgpu::{Adapter, AdapterInfo, Buffer, BufferUsages, CommandEncoder, Device, DeviceDescriptor};
use wgpu::{DeviceType, Features, Queue};

/// An opened GPU.
#[derive(Debug)]
pub struct Gpu {
    /// Where resources are made.
    pub device: Device,
    /// Where work is submitted.
    pub queue: Queue,
    /// Its name and what drives it, for messages: `llvmpipe (Vulkan, software)`.
    pub name: String,
    /// Whether it is a program on the processor and no GPU.
    pub software: bool,
    /// Whether passes can say how long they took.
    pub timestamps: bool,
    /// What went wrong and was not yet told.
    complaint: Arc<Mutex<Option<String>>>,
}

impl Gpu {
    /// Opens the fastest adapter there is, which may be a software driver. The error is a sentence.
    pub fn open() -> Result<Self, Error> {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
        let options = wgpu::RequestAdapterOptions {
            power_preference: wgpu::PowerPreference::HighPerformance,
            ..Default::default()
        };
        let adapter = pollster::block_on(instance.request_adapter(&options))
            .map_err(|_| Error::Gpu("no GPU driver was found".into()))?;
        let (device, queue) = pollster::block_on(adapter.request_device(&Self::wants(&adapter)))
            .map_err(|error| {
                let name = name(&adapter.get_info());
                Error::Gpu(format!("{name} cannot be opened: {error}"))
            })?;
        Ok(Self::of(&adapter, &device, &queue))
    }

    /// What is asked of an adapter: whatever it can, as the passes check sizes against it and tell what does not fit.
    pub fn wants(adapter: &Adapter) -> DeviceDescriptor<'static> {
        DeviceDescriptor {
            label: Some("gaunt"),
            required_features: adapter.features() & Features::TIMESTAMP_QUERY,
            required_limits: adapter.limits(),
            ..Default::default()
        }
    }

    /// A device that somebody else has opened, with what it [`wants`](Self::wants). Its errors come here from now on.
    pub fn of(adapter: &Adapter, device: &Device, queue: &Queue) -> Self {
        let info = adapter.get_info();
        let complaint = Arc::new(Mutex::new(None));
        let heard = Arc::clone(&complaint);
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            heard
                .lock()
                .unwrap_or_else(PoisonError::into_inner)
                .get_or_insert_with(|| error.to_string());
        }));
        Self {
            device: device.clone(),
            queue: queue.clone(),
            name: name(&info),
            software: info.device_type == DeviceType::Cpu,
            timestamps: device.features().contains(Features::TIMESTAMP_QUERY),
            complaint,
        }
    }

    /// Records, submits and waits until it is done.
    pub fn submit(&self, record: impl FnOnce(&mut CommandEncoder)) -> Result<(), Error> {
        let mut encoder = self.device.create_command_encoder(&Default::default());
        record(&mut encoder);
        self.queue.submit([encoder.finish()]);
        self.wait()
    }

    /// A buffer that [`Self::read`] can copy `size` bytes into.
    pub fn staging(&self, size: u64) -> Buffer {
        self.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("gaunt read back"),
            size,
            usage: BufferUsages::MAP_READ | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        })
    }

    /// Hands the contents of a buffer made by [`Self::staging`] to `look`.
    pub fn read<T>(&self, staging: &Buffer, look: impl FnOnce(&[u8]) -> T) -> Result<T, Error> {
        let failed = |error: &dyn std::fmt::Display| {
            Error::Gpu(format!("{} did not give its results: {error}", self.name))
        };
        let outcome = Arc::new(Mutex::new(None));
        let reported = Arc::clone(&outcome);
        staging.map_async(wgpu::MapMode::Read, .., move |result| {
            *reported.lock().unwrap_or_else(PoisonError::into_inner) = Some(result);
        });
        self.wait()?;
        match outcome
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .take()
        {
            Some(Ok(())) => {}
            Some(Err(error)) => return Err(failed(&error)),
            None => return Err(failed(&"the device was lost")),
        }
        let view = staging
            .get_mapped_range(..)
            .map_err(|error| failed(&error))?;
        let result = look(&view);
        drop(view);
        staging.unmap();
        Ok(result)
    }

    fn wait(&self) -> Result<(), Error> {
        let polled = self.device.poll(wgpu::PollType::wait_indefinitely());
        // The device's own words first: a failed wait often only follows from them.
        self.check()?;
        polled.map_err(|error| Error::Gpu(format!("{} stopped working: {error}", self.name)))?;
        Ok(())
    }

    /// Fails if the device complained since the last time.
    pub fn check(&self) -> Result<(), Error> {
        match self
            .complaint
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .take()
        {
            None => Ok(()),
            Some(complaint) => Err(Error::Gpu(format!("{} complains: {complaint}", self.name))),
        }
    }
}

/// An adapter's name and what drives it.
fn name(info: &AdapterInfo) -> String {
    let software = info.device_type == DeviceType::Cpu;
    let kind = if software { ", software" } else { "" };
    format!("{} ({:?}{kind})", info.name, info.backend)
}
