//! What all passes do alike: layouts, pipelines, dispatches, and looking bindings over before they are used.

use crate::bound::Part;
use crate::layout::Layout;
use crate::pipelines::Specialisation;
use crate::slot::{Slot, enough};
use crate::{Bound, Error};
use sh_core::OrderError;
use sh_kernels::{Pass, WORKGROUP};
use sh_scene::Tiles;
use wgpu::{
    BindGroup, BindingResource, BindingType, BufferBindingType, ComputePassTimestampWrites,
    ComputePipeline, Device, ShaderModule,
};

/// Bytes of a texture without mip levels.
pub(crate) fn texture_bytes(texture: &wgpu::Texture) -> u64 {
    let texel = texture.format().block_copy_size(None).unwrap_or(0);
    u64::from(texture.width()) * u64::from(texture.height()) * u64::from(texel)
}

/// The shader module of a specialisation.
pub(crate) fn module(device: &Device, of: Specialisation) -> Result<ShaderModule, Error> {
    let (pass, order, accumulation) = of;
    let Some(source) = sh_kernels::source(pass, order) else {
        return Err(OrderError(order).into());
    };
    let (name, refused) = (
        pass.name(),
        Error::Accumulation {
            order,
            accumulation,
        },
    );
    let accumulated = match pass {
        Pass::Shadow => Some(sh_kernels::shadow(order, accumulation).ok_or(refused)?),
        Pass::ShadowedLight => {
            Some(sh_kernels::shadowed_light(order, accumulation).ok_or(refused)?)
        }
        _ => None,
    };
    let label = match accumulated {
        Some(_) => format!("gaunt {name} order {order}, accumulated in {accumulation}"),
        None => format!("gaunt {name} order {order}"),
    };
    let source = accumulated.unwrap_or(source);
    Ok(device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some(&label),
        source: wgpu::ShaderSource::Wgsl(source.into()),
    }))
}

/// Whether a device was requested with enough for a kernel of these layouts.
fn fits(device: &Device, own: &Layout, host: &Layout) -> Result<(), Error> {
    let limits = device.limits();
    let all = own.entries.iter().chain(&host.entries);
    let storage = all.filter(|entry| match &entry.ty {
        BindingType::Buffer { ty, .. } => matches!(ty, BufferBindingType::Storage { .. }),
        _ => false,
    });
    let limit = "max_storage_buffers_per_shader_stage";
    let available = limits.max_storage_buffers_per_shader_stage.into();
    let storage = storage.count() as u64;
    Error::within("the number of storage buffers", storage, limit, available)?;
    let limit = "max_compute_invocations_per_workgroup";
    let available = limits.max_compute_invocations_per_workgroup.into();
    Error::within("a workgroup", WORKGROUP.into(), limit, available)
}

/// A compute kernel with its layouts. Group 0 is what the pass owns, group 1 what the host may own.
#[derive(Debug)]
pub(crate) struct Kernel {
    pub label: String,
    pipeline: ComputePipeline,
    own: Layout,
    host: Layout,
    /// Workgroups along one axis of a dispatch.
    axis: u32,
    max_binding: u64,
    alignment: u64,
}

impl Kernel {
    /// Of a pass, with values for the shader's overrides.
    pub fn new(
        device: &Device,
        shader: &ShaderModule,
        pass: Pass,
        name: &'static str,
        constants: &[(&str, bool)],
    ) -> Result<Self, Error> {
        let label = format!("gaunt {name}");
        let [own, host] = Layout::of_kernel(device, pass, name);
        fits(device, &own, &host)?;
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(&label),
            bind_group_layouts: &[Some(&own.layout), Some(&host.layout)],
            immediate_size: 0,
        });
        let constants = constants.iter().map(|(name, on)| (*name, f64::from(*on)));
        let constants: Vec<_> = constants.collect();
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(&label),
            layout: Some(&layout),
            module: shader,
            entry_point: Some(name),
            compilation_options: wgpu::PipelineCompilationOptions {
                constants: &constants,
                // No kernel reads what it has not written.
                zero_initialize_workgroup_memory: false,
            },
            cache: None,
        });
        let limits = device.limits();
        Ok(Self {
            label,
            pipeline,
            own,
            host,
            axis: limits.max_compute_workgroups_per_dimension,
            max_binding: limits.max_storage_buffer_binding_size,
            alignment: u64::from(limits.min_storage_buffer_offset_alignment),
        })
    }

    /// Group 0, by the kernel's names.
    pub fn own(&self, device: &Device, all: &[(&str, BindingResource<'_>)]) -> BindGroup {
        self.own.bind(device, all)
    }

    /// Group 1, by the kernel's names.
    pub fn host(&self, device: &Device, all: &[(&str, BindingResource<'_>)]) -> BindGroup {
        self.host.bind(device, all)
    }

    /// A bind group of storage buffers for group 1. The first slot that needs one element an invocation
    /// says how many invocations there are; all others must hold enough for it.
    pub fn bind(&self, device: &Device, slots: &[Slot<'_>]) -> Result<Bound, Error> {
        let (group, count) = self.group(device, slots)?;
        Ok(Bound::new(group, self.workgroups(count)?))
    }

    /// Workgroups for so many elements.
    pub fn workgroups(&self, elements: u64) -> Result<[u32; 3], Error> {
        let [across, down] = self.spread(elements.div_ceil(u64::from(WORKGROUP)))?;
        Ok([across, down, 1])
    }

    /// Slots of which an invocation has `each` elements, in as few parts as the device's largest binding allows, of
    /// whole tiles. `bind` is given the slots of a part, and how many invocations it has.
    pub fn bind_parts(
        &self,
        slots: &[Slot<'_>],
        mut bind: impl FnMut(&[Slot<'_>], u64) -> Result<Bound, Error>,
    ) -> Result<Bound, Error> {
        let mut sizes = Vec::with_capacity(slots.len());
        for slot in slots {
            sizes.push(self.held(slot)?);
        }
        let count = enough(slots, &sizes)?;
        // Parts begin at a multiple of 256 elements, and so at a multiple of every device's alignment.
        let step = Tiles::AREA as u64;
        let limit = "max_storage_buffer_binding_size";
        let mut most = count;
        for slot in slots {
            let each = slot.stride * slot.each;
            Error::within(slot.name, each * step.min(count), limit, self.max_binding)?;
            if each * count > self.max_binding {
                most = most.min(self.max_binding / each / step * step);
            }
        }
        let parts = (0..count).step_by(most as usize).map(|first| {
            let count = most.min(count - first);
            let parts = slots.iter().map(|slot| slot.part(first, count));
            bind(&parts.collect::<Vec<_>>(), count)
        });
        parts.collect()
    }

    /// As [`bind`](Self::bind) for a kernel with a workgroup for every 64 elements of each of many groups of elements,
    /// the largest of which has `largest`: x counts within a group, y and z count groups.
    pub fn bind_groups(
        &self,
        device: &Device,
        slots: &[Slot<'_>],
        groups: u64,
        largest: u64,
    ) -> Result<Bound, Error> {
        let (group, _) = self.group(device, slots)?;
        let (across, axis) = (largest.div_ceil(u64::from(WORKGROUP)), self.axis.into());
        let limit = "max_compute_workgroups_per_dimension";
        Error::within("the number of workgroups of a cluster", across, limit, axis)?;
        let [down, deep] = self.spread(groups)?;
        Ok(Bound::new(group, [across as u32, down, deep]))
    }

    /// The bind group, and the number of elements of what counts.
    fn group(&self, device: &Device, slots: &[Slot<'_>]) -> Result<(BindGroup, u64), Error> {
        let mut sizes = Vec::with_capacity(slots.len());
        for slot in slots {
            sizes.push(self.elements(slot)?);
        }
        let count = enough(slots, &sizes)?;
        let buffers = slots.iter().map(|slot| {
            let buffer = BindingResource::Buffer(slot.binding.clone());
            (slot.name, buffer)
        });
        let group = self.host(device, &buffers.collect::<Vec<_>>());
        Ok((group, count))
    }

    /// How many elements a binding holds, once it is looked over; it has to fit the device's largest.
    pub fn elements(&self, slot: &Slot<'_>) -> Result<u64, Error> {
        let count = self.held(slot)?;
        let (size, limit) = (count * slot.stride, "max_storage_buffer_binding_size");
        Error::within(slot.name, size, limit, self.max_binding)?;
        Ok(count)
    }

    /// How many elements a binding of any size holds.
    fn held(&self, slot: &Slot<'_>) -> Result<u64, Error> {
        let Slot {
            name,
            stride,
            binding,
            ..
        } = slot;
        let fail = |problem: String| {
            Err(Error::Binding {
                binding: name,
                problem,
            })
        };
        if !binding.buffer.usage().contains(wgpu::BufferUsages::STORAGE) {
            return fail("is a buffer without BufferUsages::STORAGE; it needs that usage".into());
        }
        if !binding.offset.is_multiple_of(self.alignment) {
            let (offset, alignment) = (binding.offset, self.alignment);
            return fail(format!(
                "starts at byte {offset}; it has to start at a multiple of {alignment}"
            ));
        }
        let rest = binding.buffer.size().saturating_sub(binding.offset);
        let size = binding.size.map_or(rest, |size| size.get());
        if size > rest {
            return fail(format!(
                "has {size} bytes, but its buffer has only {rest} from its offset on"
            ));
        }
        if size == 0 || !size.is_multiple_of(*stride) {
            return fail(format!(
                "has {size} bytes; a positive multiple of {stride} is needed"
            ));
        }
        Ok(size / stride)
    }

    /// So many workgroups over two axes.
    fn spread(&self, groups: u64) -> Result<[u32; 2], Error> {
        let axis = u64::from(self.axis);
        let down = groups.div_ceil(axis).max(1);
        Error::within(
            "the number of workgroup rows",
            down,
            "max_compute_workgroups_per_dimension",
            axis,
        )?;
        Ok([groups.div_ceil(down) as u32, down as u32])
    }

    /// Records a compute pass with a dispatch for every part of what was bound.
    pub fn record(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        own: (&BindGroup, &[u32]),
        bound: &Bound,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) {
        let mut pass = self.begin(encoder, timestamps);
        self.dispatch(&mut pass, own, bound);
        pass.pop_debug_group();
    }

    /// As [`record`](Self::record) for several at once, each with a dynamic offset into group 0.
    pub fn record_parts<'a>(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        own: &BindGroup,
        parts: impl IntoIterator<Item = (u32, &'a Bound)>,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) {
        let mut pass = self.begin(encoder, timestamps);
        for (offset, bound) in parts {
            self.dispatch(&mut pass, (own, &[offset]), bound);
        }
        pass.pop_debug_group();
    }

    fn begin<'a>(
        &self,
        encoder: &'a mut wgpu::CommandEncoder,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) -> wgpu::ComputePass<'a> {
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
            label: Some(&self.label),
            timestamp_writes: timestamps,
        });
        pass.push_debug_group(&self.label);
        pass
    }

    /// Records the dispatches in a compute pass that is open.
    fn dispatch(&self, pass: &mut wgpu::ComputePass<'_>, own: (&BindGroup, &[u32]), bound: &Bound) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, own.0, own.1);
        for Part { group, workgroups } in &bound.parts {
            pass.set_bind_group(1, group, &[]);
            let [x, y, z] = *workgroups;
            pass.dispatch_workgroups(x, y, z);
        }
    }
}
