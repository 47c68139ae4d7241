//! A Vulkan device that is given SPIR-V as it is.

use std::borrow::Cow;
use wgpu::{BufferUsages, Features};

/// A device whose driver compiles what it is handed, with no translator between.
pub struct Device {
    device: wgpu::Device,
    queue: wgpu::Queue,
}

impl Device {
    /// The first there is; why there is none.
    pub fn open() -> Result<Self, String> {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
        let adapter = pollster::block_on(instance.request_adapter(&Default::default()))
            .map_err(|error| error.to_string())?;
        if adapter.get_info().backend != wgpu::Backend::Vulkan
            || !adapter.features().contains(Features::PASSTHROUGH_SHADERS)
        {
            return Err("there is no Vulkan device that takes SPIR-V".into());
        }
        let descriptor = wgpu::DeviceDescriptor {
            required_features: Features::PASSTHROUGH_SHADERS,
            required_limits: adapter.limits(),
            ..Default::default()
        };
        let (device, queue) = pollster::block_on(adapter.request_device(&descriptor))
            .map_err(|error| error.to_string())?;
        Ok(Self { device, queue })
    }

    /// Takes in a module with these entry points. It has to be valid: the driver does not check it.
    #[expect(
        unsafe_code,
        reason = "the driver gets the words as they are; spirv-val has seen them"
    )]
    pub fn module(&self, words: &[u32], entries: &[String]) -> wgpu::ShaderModule {
        let entries = entries
            .iter()
            .map(|name| wgpu::PassthroughShaderEntryPoint {
                name: Cow::Borrowed(name),
                workgroup_size: (64, 1, 1),
            });
        let descriptor = wgpu::ShaderModuleDescriptorPassthrough {
            entry_points: entries.collect(),
            spirv: Some(Cow::Borrowed(words)),
            ..Default::default()
        };
        // SAFETY: exported modules and what glslang makes of exported text, both of which other tests of this file
        // put through spirv-val; they index their buffers within the bounds that `run` gives them.
        unsafe { self.device.create_shader_module_passthrough(descriptor) }
    }

    /// Runs an entry point over the words of all invocations: binding 0 is read, binding 1 written.
    pub fn run(
        &self,
        module: &wgpu::ShaderModule,
        entry: &str,
        arguments: &[u32],
        results: usize,
        invocations: usize,
    ) -> Vec<u32> {
        let visible = |binding, read_only| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::COMPUTE,
            ty: wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Storage { read_only },
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        };
        let device = &self.device;
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: None,
            entries: &[visible(0, true), visible(1, false)],
        });
        let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: None,
            bind_group_layouts: &[Some(&layout)],
            immediate_size: 0,
        });
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(entry),
            layout: Some(&pipeline_layout),
            module,
            entry_point: Some(entry),
            compilation_options: Default::default(),
            cache: None,
        });
        let size = (results * 4) as u64;
        let buffer = |size, usage| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: None,
                size,
                usage,
                mapped_at_creation: false,
            })
        };
        let storage = BufferUsages::STORAGE;
        let input = buffer(arguments.len() as u64 * 4, storage | BufferUsages::COPY_DST);
        let output = buffer(size, storage | BufferUsages::COPY_SRC);
        let staging = buffer(size, BufferUsages::MAP_READ | BufferUsages::COPY_DST);
        self.queue
            .write_buffer(&input, 0, bytemuck::cast_slice(arguments));
        fn bound(binding: u32, buffer: &wgpu::Buffer) -> wgpu::BindGroupEntry<'_> {
            wgpu::BindGroupEntry {
                binding,
                resource: buffer.as_entire_binding(),
            }
        }
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &layout,
            entries: &[bound(0, &input), bound(1, &output)],
        });
        let mut encoder = device.create_command_encoder(&Default::default());
        let mut pass = encoder.begin_compute_pass(&Default::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.dispatch_workgroups(invocations.div_ceil(64) as u32, 1, 1);
        drop(pass);
        encoder.copy_buffer_to_buffer(&output, 0, &staging, 0, size);
        self.queue.submit([encoder.finish()]);
        staging.map_async(wgpu::MapMode::Read, .., |result| {
            result.expect("results come back")
        });
        device
            .poll(wgpu::PollType::wait_indefinitely())
            .expect("the device works on");
        let view = staging.get_mapped_range(..).expect("it is mapped");
        bytemuck::pod_collect_to_vec(&view)
    }
}
