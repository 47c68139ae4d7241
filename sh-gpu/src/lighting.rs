//! Light and blockers on their way to the GPU, for the passes that shade receivers.

use crate::Error;
use crate::pipeline::{Bound, Kernel, Slot, buffer_entry};
use crate::records::Lighting;
use bytemuck::Zeroable;
use sh_kernels::Pass;
use sh_scene::{Light, Receiver, Sphere};
use wgpu::{
    BindGroup, BindGroupEntry, Buffer, BufferBinding, BufferBindingType, BufferUsages,
    CommandEncoder, ComputePassTimestampWrites, Device, Queue, ShaderModule, ShaderStages,
};

/// A pass that turns receivers into radiance: a kernel, the lighting record and room for blockers.
#[derive(Debug)]
pub(crate) struct Shading {
    kernel: Kernel,
    order: usize,
    capacity: u32,
    lighting: Buffer,
    blockers: Option<Buffer>,
    group: BindGroup,
}

impl Shading {
    pub fn new(
        device: &Device,
        pass: Pass,
        module: &ShaderModule,
        order: usize,
        capacity: Option<u32>,
    ) -> Result<Self, Error> {
        let size = u64::from(capacity.unwrap_or(0).max(1)) * size_of::<Sphere>() as u64;
        let limits = device.limits();
        let (max_binding, max_buffer) = (
            limits.max_storage_buffer_binding_size,
            limits.max_buffer_size,
        );
        Error::within(
            "room for blockers",
            size,
            "max_storage_buffer_binding_size",
            max_binding,
        )?;
        Error::within("room for blockers", size, "max_buffer_size", max_buffer)?;
        let compute = ShaderStages::COMPUTE;
        let read = BufferBindingType::Storage { read_only: true };
        let write = BufferBindingType::Storage { read_only: false };
        let own = [
            buffer_entry(0, compute, BufferBindingType::Uniform, false),
            buffer_entry(1, compute, read, false),
        ];
        let host = [
            buffer_entry(0, compute, read, false),
            buffer_entry(1, compute, write, false),
        ];
        let own = if capacity.is_some() {
            &own[..]
        } else {
            &own[..1]
        };
        let kernel = Kernel::new(device, module, pass.name(), [own, &host]);
        let buffer = |label: &str, size: u64, usage: BufferUsages| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(&format!("{} {label}", kernel.label)),
                size,
                usage: usage | BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        };
        let lighting = buffer(
            "lighting",
            size_of::<Lighting>() as u64,
            BufferUsages::UNIFORM,
        );
        let blockers = capacity.map(|_| buffer("blockers", size, BufferUsages::STORAGE));
        let mut entries = vec![BindGroupEntry {
            binding: 0,
            resource: lighting.as_entire_binding(),
        }];
        if let Some(blockers) = &blockers {
            entries.push(BindGroupEntry {
                binding: 1,
                resource: blockers.as_entire_binding(),
            });
        }
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some(&kernel.label),
            layout: &kernel.groups[0],
            entries: &entries,
        });
        Ok(Self {
            order,
            capacity: capacity.unwrap_or(0),
            lighting,
            blockers,
            group,
            kernel,
        })
    }

    pub fn prepare(&self, queue: &Queue, blockers: &[Sphere], light: &Light) -> Result<(), Error> {
        let count = light.coefficients.len();
        if light.order != self.order || count != self.order * self.order {
            return Err(Error::Light {
                order: light.order,
                coefficients: count,
                expected: self.order,
            });
        }
        if blockers.len() > self.capacity as usize {
            return Err(Error::Blockers {
                count: blockers.len(),
                capacity: self.capacity,
            });
        }
        let mut record = Lighting {
            blockers: blockers.len() as u32,
            ..Lighting::zeroed()
        };
        for (slot, [r, g, b]) in record.coefficients.iter_mut().zip(&light.coefficients) {
            *slot = [*r, *g, *b, 0.0];
        }
        queue.write_buffer(&self.lighting, 0, bytemuck::bytes_of(&record));
        if let (Some(buffer), false) = (&self.blockers, blockers.is_empty()) {
            queue.write_buffer(buffer, 0, bytemuck::cast_slice(blockers));
        }
        Ok(())
    }

    pub fn bind(
        &self,
        device: &Device,
        receivers: BufferBinding<'_>,
        radiance: BufferBinding<'_>,
    ) -> Result<Bound, Error> {
        let receivers = Slot::counting("receivers", size_of::<Receiver>() as u64, receivers);
        self.kernel.bind(
            device,
            &[receivers, Slot::with("radiance", 16, 1, radiance)],
        )
    }

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
