//! What all passes do alike: layouts, pipelines, dispatches, and looking bindings over before they are used.

use crate::Error;
use sh_kernels::{Pass, WORKGROUP};
use wgpu::{
    BindGroup, BindGroupEntry, BindGroupLayout, BindGroupLayoutEntry, BindingResource, BindingType,
    BufferBinding, BufferBindingType, ComputePassTimestampWrites, ComputePipeline, Device,
    ShaderModule, ShaderStages,
};

/// A layout entry for a buffer.
pub(crate) fn buffer_entry(
    binding: u32,
    visibility: ShaderStages,
    ty: BufferBindingType,
    has_dynamic_offset: bool,
) -> BindGroupLayoutEntry {
    BindGroupLayoutEntry {
        binding,
        visibility,
        ty: BindingType::Buffer {
            ty,
            has_dynamic_offset,
            min_binding_size: None,
        },
        count: None,
    }
}

/// A layout entry for a two-dimensional texture that is read texel by texel.
pub(crate) fn texture_entry(
    binding: u32,
    visibility: ShaderStages,
    sample_type: wgpu::TextureSampleType,
) -> BindGroupLayoutEntry {
    BindGroupLayoutEntry {
        binding,
        visibility,
        ty: BindingType::Texture {
            sample_type,
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        },
        count: None,
    }
}

/// The shader module of a pass that knows one order.
pub(crate) fn shader(device: &Device, pass: Pass, order: usize) -> Result<ShaderModule, Error> {
    let source = sh_kernels::source(pass, order).ok_or(Error::Order(order))?;
    let label = format!("gaunt {} order {order}", pass.name());
    module(device, &label, source)
}

/// A shader module with one of the kernels' texts.
pub(crate) fn module(device: &Device, label: &str, source: &str) -> Result<ShaderModule, Error> {
    let limits = device.limits();
    let (needed, available) = (8, limits.max_storage_buffers_per_shader_stage.into());
    Error::within(
        "a pass",
        needed,
        "max_storage_buffers_per_shader_stage",
        available,
    )?;
    let available = limits.max_compute_invocations_per_workgroup.into();
    let needed = WORKGROUP.into();
    Error::within(
        "a workgroup",
        needed,
        "max_compute_invocations_per_workgroup",
        available,
    )?;
    Ok(device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some(label),
        source: wgpu::ShaderSource::Wgsl(source.into()),
    }))
}

/// A compute kernel with its layouts. Group 0 is what the pass owns, group 1 what the host may own.
#[derive(Debug)]
pub(crate) struct Kernel {
    pub label: String,
    pipeline: ComputePipeline,
    pub groups: [BindGroupLayout; 2],
    /// Workgroups along one axis of a dispatch.
    axis: u32,
    max_binding: u64,
    alignment: u64,
}

impl Kernel {
    pub fn new(
        device: &Device,
        shader: &ShaderModule,
        name: &'static str,
        groups: [&[BindGroupLayoutEntry]; 2],
    ) -> Self {
        let label = format!("gaunt {name}");
        let groups = groups.map(|entries| {
            device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: Some(&label),
                entries,
            })
        });
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(&label),
            bind_group_layouts: &[Some(&groups[0]), Some(&groups[1])],
            immediate_size: 0,
        });
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(&label),
            layout: Some(&layout),
            module: shader,
            entry_point: Some(name),
            compilation_options: wgpu::PipelineCompilationOptions {
                // No kernel reads what it has not written.
                zero_initialize_workgroup_memory: false,
                ..Default::default()
            },
            cache: None,
        });
        let limits = device.limits();
        Self {
            label,
            pipeline,
            groups,
            axis: limits.max_compute_workgroups_per_dimension,
            max_binding: limits.max_storage_buffer_binding_size,
            alignment: u64::from(limits.min_storage_buffer_offset_alignment),
        }
    }

    /// Group 0.
    pub fn own(&self, device: &Device, entries: &[BindGroupEntry<'_>]) -> BindGroup {
        device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some(&self.label),
            layout: &self.groups[0],
            entries,
        })
    }

    /// A bind group of storage buffers for group 1. The first slot that needs one element an invocation
    /// says how many invocations there are; all others must hold enough for it.
    pub fn bind(&self, device: &Device, slots: &[Slot<'_>]) -> Result<Bound, Error> {
        let (group, count) = self.group(device, slots)?;
        let [across, down] = self.spread(count.div_ceil(u64::from(WORKGROUP)))?;
        Ok(Bound {
            group,
            workgroups: [across, down, 1],
        })
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
        Ok(Bound {
            group,
            workgroups: [across as u32, down, deep],
        })
    }

    /// The bind group, and the number of elements of what counts.
    fn group(&self, device: &Device, slots: &[Slot<'_>]) -> Result<(BindGroup, u64), Error> {
        let mut sizes = Vec::with_capacity(slots.len());
        for slot in slots {
            sizes.push(self.elements(slot)?);
        }
        let counting = slots.iter().position(|slot| slot.counts).unwrap_or(0);
        let count = sizes[counting];
        for (slot, &size) in slots.iter().zip(&sizes) {
            let needed = count * slot.each;
            if size < needed {
                let problem = format!(
                    "holds {size} elements of {} bytes; {needed} are needed, because `{}` holds {count}",
                    slot.stride, slots[counting].name
                );
                return Err(Error::Binding {
                    binding: slot.name,
                    problem,
                });
            }
        }
        let entries: Vec<_> = (0..)
            .zip(slots)
            .map(|(binding, slot)| BindGroupEntry {
                binding,
                resource: BindingResource::Buffer(slot.binding.clone()),
            })
            .collect();
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some(&self.label),
            layout: &self.groups[1],
            entries: &entries,
        });
        Ok((group, count))
    }

    /// How many elements a binding holds, once it is looked over.
    pub fn elements(&self, slot: &Slot<'_>) -> Result<u64, Error> {
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
        Error::within(
            name,
            size,
            "max_storage_buffer_binding_size",
            self.max_binding,
        )?;
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

    /// Records one dispatch in a compute pass of its own.
    pub fn record(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        own: (&BindGroup, &[u32]),
        bound: &Bound,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) {
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
            label: Some(&self.label),
            timestamp_writes: timestamps,
        });
        pass.push_debug_group(&self.label);
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, own.0, own.1);
        pass.set_bind_group(1, &bound.group, &[]);
        let [x, y, z] = bound.workgroups;
        pass.dispatch_workgroups(x, y, z);
        pass.pop_debug_group();
    }
}

/// A storage buffer that a kernel wants.
pub(crate) struct Slot<'a> {
    /// As the kernel names it.
    pub name: &'static str,
    /// Bytes an element.
    pub stride: u64,
    /// Elements an invocation needs.
    pub each: u64,
    /// Whether there is an invocation for every element.
    pub counts: bool,
    pub binding: BufferBinding<'a>,
}

impl<'a> Slot<'a> {
    /// One element an invocation, and as many invocations as elements.
    pub fn counting(name: &'static str, stride: u64, binding: BufferBinding<'a>) -> Self {
        Self {
            name,
            stride,
            each: 1,
            counts: true,
            binding,
        }
    }

    /// At least `each` elements an invocation.
    pub fn with(name: &'static str, stride: u64, each: u64, binding: BufferBinding<'a>) -> Self {
        Self {
            name,
            stride,
            each,
            counts: false,
            binding,
        }
    }
}

/// The host's buffers, looked over and bound to one pass. Made once, used every frame while the buffers
/// stay the same; valid only for the pass that made it.
#[derive(Clone, Debug)]
pub struct Bound {
    group: BindGroup,
    workgroups: [u32; 3],
}
