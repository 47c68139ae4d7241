//! Light and blockers on their way to the GPU, for the passes that shade receivers.

use crate::Error;
use crate::records::Lighting;
use crate::upload::Known;
use bytemuck::Zeroable;
use sh_scene::{Emitter, Light, Limits};
use wgpu::{BindingResource, Buffer, BufferUsages, Device, Queue};

/// The lighting record and analytic lights: the head of group 0 of the passes that shade receivers.
#[derive(Debug)]
pub(crate) struct Lit {
    order: usize,
    max_emitters: u32,
    distributions: bool,
    record: Buffer,
    emitters: Buffer,
    /// From where what is mirrored is seen. It is no part of the light: bodies look the same from wherever.
    eye: Buffer,
    /// What both hold.
    known: [Known; 2],
    known_eye: Known,
}

impl Lit {
    pub fn new(
        device: &Device,
        order: usize,
        max_emitters: u32,
        distributions: bool,
    ) -> Result<Self, Error> {
        let record = size_of::<Lighting>() as u64;
        let emitters = room(
            device,
            "room for emitters",
            max_emitters,
            size_of::<Emitter>(),
        )?;
        Ok(Self {
            order,
            max_emitters,
            distributions,
            record: buffer(device, "gaunt lighting", record, BufferUsages::UNIFORM),
            emitters: buffer(device, "gaunt emitters", emitters, BufferUsages::STORAGE),
            eye: buffer(device, "gaunt eye", 16, BufferUsages::UNIFORM),
            known: Default::default(),
            known_eye: Known::default(),
        })
    }

    /// The override constants of kernels that know analytic lights: whether there may be any, and any that is not even.
    pub fn lamps(&self) -> [(&'static str, bool); 2] {
        let any = self.max_emitters > 0;
        [("LAMPS", any), ("DISTRIBUTIONS", any && self.distributions)]
    }

    /// Record and analytic lights, as kernels name them.
    pub fn bindings(&self) -> [(&'static str, BindingResource<'_>); 2] {
        [
            ("lighting", self.record.as_entire_binding()),
            ("emitters", self.emitters.as_entire_binding()),
        ]
    }

    /// The eye, as kernels name it.
    pub fn eye(&self) -> (&'static str, BindingResource<'_>) {
        ("eye", self.eye.as_entire_binding())
    }

    /// Uploads from where the picture is seen.
    pub fn look_from(&self, queue: &Queue, [x, y, z]: [f32; 3]) {
        self.known_eye.write(queue, &self.eye, &[[x, y, z, 0.0]]);
    }

    /// Bytes that have been uploaded since it was made.
    pub fn uploaded(&self) -> u64 {
        self.known.iter().map(Known::written).sum()
    }

    /// Bytes of GPU memory.
    pub fn bytes(&self) -> u64 {
        self.record.size() + self.emitters.size() + self.eye.size()
    }

    /// Uploads the record and the emitters, for so many nodes that are there already.
    pub fn prepare(
        &self,
        queue: &Queue,
        light: &Light,
        nodes: u32,
        limits: Limits,
    ) -> Result<(), Error> {
        let count = light.coefficients.len();
        if light.order != self.order || count != self.order * self.order {
            return Err(Error::Light {
                order: light.order,
                coefficients: count,
                expected: self.order,
            });
        }
        let emitters = light.emitters.len();
        if emitters > self.max_emitters as usize {
            return Err(Error::Emitters {
                count: emitters,
                capacity: self.max_emitters,
            });
        }
        if !self.distributions && light.emitters.iter().any(|e| e.order > 0) {
            return Err(Error::Distributions);
        }
        let mut record = Lighting {
            nodes,
            emitters: emitters as u32,
            sin_max: limits.sin_max,
            sin_min: limits.sin_min,
            ..Lighting::zeroed()
        };
        for (slot, [r, g, b]) in record.coefficients.iter_mut().zip(&light.coefficients) {
            *slot = [*r, *g, *b, 0.0];
        }
        let [records, lamps] = &self.known;
        records.write(queue, &self.record, &[record]);
        lamps.write(queue, &self.emitters, &light.emitters);
        Ok(())
    }
}

/// Bytes of so many records, at least of one, if the device has room for them.
pub(crate) fn room(
    device: &Device,
    what: &'static str,
    count: u32,
    size: usize,
) -> Result<u64, Error> {
    let size = u64::from(count.max(1)) * size as u64;
    let limits = device.limits();
    let binding = limits.max_storage_buffer_binding_size;
    Error::within(what, size, "max_storage_buffer_binding_size", binding)?;
    Error::within(what, size, "max_buffer_size", limits.max_buffer_size)?;
    Ok(size)
}

/// A buffer that the queue writes.
pub(crate) fn buffer(device: &Device, label: &str, size: u64, usage: BufferUsages) -> Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size,
        usage: usage | BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}
