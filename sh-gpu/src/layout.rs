//! Layouts of bind groups, from what the kernels declare ([`sh_kernels::EntryPoint`]).

use sh_kernels::{Binding, EntryPoint, Kind, Pass, Stage};
use wgpu::{
    BindGroup, BindGroupDescriptor, BindGroupEntry, BindGroupLayout, BindGroupLayoutEntry,
    BindingResource, BindingType, BufferBindingType, Device, ShaderStages, StorageTextureAccess,
    TextureSampleType, TextureViewDimension,
};

/// Records of which one buffer holds several, a few hundred bytes apart: they are bound with an offset.
const SEVERAL: [&str; 4] = ["Band", "Body", "LightView", "ScreenSource"];

/// The layout of a group, and the kernels' names of what is in it.
#[derive(Debug)]
pub(crate) struct Layout {
    label: String,
    pub layout: BindGroupLayout,
    pub entries: Vec<BindGroupLayoutEntry>,
    names: Vec<(&'static str, u32)>,
}

impl Layout {
    /// What the compute kernel `name` of a pass is bound to: group 0 is one for all of the pass's kernels, group 1 its own.
    pub fn of_kernel(device: &Device, pass: Pass, name: &str) -> [Self; 2] {
        let compute = |entry: &EntryPoint| entry.stage == Stage::Compute;
        let own = |entry: &EntryPoint| compute(entry) && entry.name == name;
        let label = format!("gaunt {name}");
        [
            Self::new(device, &label, pass, 0, compute),
            Self::new(device, &label, pass, 1, own),
        ]
    }

    /// What two entry points of a render pipeline are bound to: group 0 is one for all that a pass draws with.
    pub fn of_raster(device: &Device, pass: Pass, names: [&str; 2]) -> [Self; 2] {
        let raster = |entry: &EntryPoint| entry.stage != Stage::Compute;
        let own = |entry: &EntryPoint| raster(entry) && names.contains(&entry.name);
        let label = format!("gaunt {}", pass.name());
        [
            Self::new(device, &label, pass, 0, raster),
            Self::new(device, &label, pass, 1, own),
        ]
    }

    fn new(
        device: &Device,
        label: &str,
        pass: Pass,
        group: u32,
        chosen: impl Fn(&EntryPoint) -> bool,
    ) -> Self {
        let mut entries: Vec<BindGroupLayoutEntry> = Vec::new();
        let mut names = Vec::new();
        for entry in pass.entries().iter().filter(|entry| chosen(entry)) {
            let stage = match entry.stage {
                Stage::Compute => ShaderStages::COMPUTE,
                Stage::Vertex => ShaderStages::VERTEX,
                Stage::Fragment => ShaderStages::FRAGMENT,
            };
            for binding in entry.bindings.iter().filter(|b| b.group == group) {
                let known = entries.iter_mut();
                match known.into_iter().find(|e| e.binding == binding.binding) {
                    Some(known) => known.visibility |= stage,
                    None => {
                        names.push((binding.name, binding.binding));
                        entries.push(BindGroupLayoutEntry {
                            binding: binding.binding,
                            visibility: stage,
                            ty: ty(binding),
                            count: None,
                        });
                    }
                }
            }
        }
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some(label),
            entries: &entries,
        });
        Self {
            label: label.into(),
            layout,
            entries,
            names,
        }
    }

    /// A bind group of things by the kernels' names of them. What is missing or has no such name is an error of the
    /// device's, which [`crate::scope::checked`] gives back.
    pub fn bind(&self, device: &Device, all: &[(&str, BindingResource<'_>)]) -> BindGroup {
        let entries = all.iter().map(|(name, resource)| {
            let known = self.names.iter().find(|(known, _)| known == name);
            BindGroupEntry {
                binding: known.map_or(u32::MAX, |(_, binding)| *binding),
                resource: resource.clone(),
            }
        });
        device.create_bind_group(&BindGroupDescriptor {
            label: Some(&self.label),
            layout: &self.layout,
            entries: &entries.collect::<Vec<_>>(),
        })
    }
}

/// A layout's type of what a kernel declares.
fn ty(binding: &Binding) -> BindingType {
    let buffer = |ty| BindingType::Buffer {
        ty,
        has_dynamic_offset: SEVERAL.contains(&binding.ty),
        min_binding_size: None,
    };
    let texture = |sample_type| BindingType::Texture {
        sample_type,
        view_dimension: TextureViewDimension::D2,
        multisampled: false,
    };
    match binding.kind {
        Kind::Uniform => buffer(BufferBindingType::Uniform),
        Kind::Read => buffer(BufferBindingType::Storage { read_only: true }),
        Kind::Written => buffer(BufferBindingType::Storage { read_only: false }),
        Kind::Floats => texture(TextureSampleType::Float { filterable: false }),
        Kind::Integers => texture(TextureSampleType::Uint),
        Kind::Depth => texture(TextureSampleType::Depth),
        Kind::Target => BindingType::StorageTexture {
            access: StorageTextureAccess::WriteOnly,
            format: crate::ScreenPass::RADIANCE,
            view_dimension: TextureViewDimension::D2,
        },
    }
}
