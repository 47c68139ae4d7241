//! The scene's bodies on the GPU: vertices, textures, and where each body stands.

use crate::Error;
use crate::layout::Layout;
use crate::pipeline::texture_bytes;
use crate::records::{Body, Vertex};
use crate::scope::checked;
use crate::upload::{Kept, Known, filled};
use glam::Mat4;
use sh_kernels::Pass;
use sh_scene::{Mesh, Object, Scene, Texture};
use wgpu::util::{DeviceExt, TextureDataOrder};
use wgpu::{BindGroup, Buffer, BufferUsages, Device, Queue, RenderPass, TextureFormat};

/// Bytes from one body's record to the next: the alignment that every device grants.
const STRIDE: u64 = 256;

/// One body's geometry.
#[derive(Debug)]
struct Drawn {
    vertices: Buffer,
    indices: Buffer,
    count: u32,
    group: BindGroup,
    /// Bytes of the textures.
    texture: u64,
}

/// The bodies of a scene, uploaded once; where they stand and their albedo may change every frame.
///
/// ```no_run
/// # fn bodies(device: &wgpu::Device, queue: &wgpu::Queue, scene: &sh_scene::Scene) -> Result<(), sh_gpu::Error> {
/// let bodies = sh_gpu::Bodies::new(device, queue, scene)?;
/// // every frame
/// bodies.prepare(queue, scene)?;
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct Bodies {
    drawn: Vec<Drawn>,
    records: Buffer,
    kept: Kept<Vec<u8>>,
    known: Known,
    kept_vertices: Kept<Vec<Vertex>>,
}

impl Bodies {
    /// Uploads the meshes and textures of `scene`. Bodies without triangles are not drawn.
    pub fn new(device: &Device, queue: &Queue, scene: &Scene) -> Result<Self, Error> {
        for (index, object) in scene.objects.iter().enumerate() {
            check(device, object).map_err(|problem| Error::Object {
                index,
                name: object.name.clone(),
                problem,
            })?;
        }
        checked(device, || {
            let [_, layout] = Layout::of_raster(device, Pass::Gbuffer, Self::ENTRIES);
            let size = (scene.objects.len() as u64).max(1) * STRIDE;
            let most = device.limits().max_buffer_size;
            Error::within("the bodies' records", size, "max_buffer_size", most)?;
            let records = device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("gaunt bodies"),
                size,
                usage: BufferUsages::UNIFORM | BufferUsages::COPY_DST,
                mapped_at_creation: false,
            });
            let drawn = scene
                .objects
                .iter()
                .map(|o| upload(device, queue, o, &layout, &records))
                .collect::<Result<_, _>>()?;
            Ok(Self {
                drawn,
                records,
                kept: Kept::default(),
                known: Known::default(),
                kept_vertices: Kept::default(),
            })
        })
    }

    /// Bytes of GPU memory: vertices, triangles, textures and a record each.
    pub fn bytes(&self) -> u64 {
        let of = |body: &Drawn| body.vertices.size() + body.indices.size() + body.texture;
        self.records.size() + self.drawn.iter().map(of).sum::<u64>()
    }

    /// Bytes of records that have been uploaded since they were made.
    pub(crate) fn uploaded(&self) -> u64 {
        self.known.written()
    }

    /// How many are drawn.
    pub(crate) fn drawn(&self) -> usize {
        self.drawn.iter().filter(|body| body.count > 0).count()
    }

    /// Uploads where the bodies stand and how they reflect, for what is submitted next. `scene` must hold
    /// the objects that were uploaded, in that order.
    pub fn prepare(&self, queue: &Queue, scene: &Scene) -> Result<(), Error> {
        let (count, uploaded) = (scene.objects.len(), self.drawn.len());
        if count != uploaded {
            return Err(Error::Objects { count, uploaded });
        }
        self.kept.with(|bytes| {
            bytes.clear();
            bytes.resize(self.records.size() as usize, 0);
            for (index, object) in scene.objects.iter().enumerate() {
                let glossy = scene.settings.gloss && object.material.is_glossy();
                let record = Body {
                    world_from_object: Mat4::from(object.transform),
                    albedo: object.material.albedo.into(),
                    object: scene.body(index),
                    glossy: u32::from(glossy),
                    roughness: object.material.finish.roughness,
                    metallic: object.material.finish.metallic,
                    tail: 0,
                };
                let at = index * STRIDE as usize;
                bytes[at..at + size_of::<Body>()].copy_from_slice(bytemuck::bytes_of(&record));
            }
            self.known.write(queue, &self.records, bytes);
        });
        Ok(())
    }

    /// Uploads the meshes' positions, normals, texture coordinates and colours anew, for what is submitted next: of a scene
    /// that bends. `scene` must hold the objects that were uploaded, in that order, with as many vertices.
    pub fn update_meshes(&self, queue: &Queue, scene: &Scene) -> Result<(), Error> {
        let (count, uploaded) = (scene.objects.len(), self.drawn.len());
        if count != uploaded {
            return Err(Error::Objects { count, uploaded });
        }
        for (index, (object, drawn)) in scene.objects.iter().zip(&self.drawn).enumerate() {
            let count = object.mesh.positions.len();
            let known = drawn.vertices.size() / size_of::<Vertex>() as u64;
            if count as u64 != known {
                return Err(Error::Object {
                    index,
                    name: object.name.clone(),
                    problem: format!("has {count} vertices, but {known} were uploaded"),
                });
            }
            let all = vertices(&object.mesh);
            self.kept_vertices.upload(queue, &drawn.vertices, all);
        }
        Ok(())
    }

    /// What they are drawn with.
    pub(crate) const ENTRIES: [&'static str; 2] = ["body_vertex", "body_fragment"];

    /// Draws all bodies with the pipeline and band that are set.
    pub(crate) fn draw(&self, pass: &mut RenderPass<'_>) {
        for (index, body) in self
            .drawn
            .iter()
            .enumerate()
            .filter(|(_, body)| body.count > 0)
        {
            pass.set_bind_group(1, &body.group, &[index as u32 * STRIDE as u32]);
            pass.set_vertex_buffer(0, body.vertices.slice(..));
            pass.set_index_buffer(body.indices.slice(..), wgpu::IndexFormat::Uint32);
            pass.draw_indexed(0..body.count, 0, 0..1);
        }
    }
}

/// Whether a body can be uploaded, or what is wrong with it.
fn check(device: &Device, object: &Object) -> Result<(), String> {
    let (mesh, limits) = (&object.mesh, device.limits());
    let vertices = mesh.positions.len();
    if mesh.normals.len() != vertices {
        return Err(format!(
            "has {} normals for {vertices} vertices",
            mesh.normals.len()
        ));
    }
    if !mesh.uvs.is_empty() && mesh.uvs.len() != vertices {
        return Err(format!(
            "has {} texture coordinates for {vertices} vertices",
            mesh.uvs.len()
        ));
    }
    if !mesh.colors.is_empty() && mesh.colors.len() != vertices {
        return Err(format!(
            "has {} colours for {vertices} vertices",
            mesh.colors.len()
        ));
    }
    if let Some(index) = mesh
        .triangles
        .as_flattened()
        .iter()
        .find(|&&i| i as usize >= vertices)
    {
        return Err(format!(
            "has a triangle with vertex {index}, but only {vertices} vertices"
        ));
    }
    let bytes = (vertices * size_of::<Vertex>()).max(size_of_val(&mesh.triangles[..])) as u64;
    if bytes > limits.max_buffer_size {
        return Err(format!(
            "needs a buffer of {bytes} bytes, but the device's limit `max_buffer_size` is {}",
            limits.max_buffer_size
        ));
    }
    let material = &object.material;
    let textures = [&material.texture, &material.finish_texture];
    let mut textures = textures.into_iter().flatten();
    textures.try_for_each(|texture| check_texture(texture, limits.max_texture_dimension_2d))
}

fn check_texture(texture: &Texture, side: u32) -> Result<(), String> {
    let Texture {
        width,
        height,
        rgba,
    } = texture;
    if *width == 0 || *height == 0 || *width > side || *height > side {
        return Err(format!(
            "has a texture of {width} by {height} texels; each side must be 1 to {side}"
        ));
    }
    if rgba.len() as u64 != u64::from(*width) * u64::from(*height) * 4 {
        let length = rgba.len();
        return Err(format!(
            "has a texture of {width} by {height} texels, but {length} bytes for it"
        ));
    }
    Ok(())
}

/// A mesh's vertices as the GPU reads them.
fn vertices(mesh: &Mesh) -> impl Iterator<Item = Vertex> + '_ {
    let vertices = mesh.positions.iter().zip(&mesh.normals).enumerate();
    vertices.map(|(i, (position, normal))| Vertex {
        position: *position,
        normal: *normal,
        uv: mesh.uvs.get(i).copied().unwrap_or_default(),
        color: mesh.colors.get(i).copied().unwrap_or([1.0; 3]),
    })
}

fn upload(
    device: &Device,
    queue: &Queue,
    object: &Object,
    layout: &Layout,
    records: &Buffer,
) -> Result<Drawn, Error> {
    let mesh = &object.mesh;
    let label = format!("gaunt body {}", object.name);
    let vertices: Vec<Vertex> = vertices(mesh).collect();
    let buffer = |contents: &[u8], usage| filled(device, &label, contents, usage);
    let white = Texture {
        width: 1,
        height: 1,
        rgba: vec![255; 4],
    };
    let texture = object.material.texture.as_ref().unwrap_or(&white);
    let view = uploaded(
        device,
        queue,
        &label,
        (texture, TextureFormat::Rgba8UnormSrgb),
    );
    let finish = object.material.finish_texture.as_ref();
    let finish = finish.filter(|_| !mesh.uvs.is_empty()).unwrap_or(&white);
    let finish = uploaded(device, queue, &label, (finish, TextureFormat::Rgba8Unorm));
    let record = wgpu::BindingResource::Buffer(wgpu::BufferBinding {
        buffer: records,
        offset: 0,
        size: wgpu::BufferSize::new(size_of::<Body>() as u64),
    });
    let color = wgpu::BindingResource::TextureView(&view);
    let told = wgpu::BindingResource::TextureView(&finish);
    let all = [("body", record), ("base_color", color), ("finish", told)];
    let group = layout.bind(device, &all);
    Ok(Drawn {
        vertices: buffer(
            bytemuck::cast_slice(&vertices),
            BufferUsages::VERTEX | BufferUsages::COPY_DST,
        )?,
        indices: buffer(bytemuck::cast_slice(&mesh.triangles), BufferUsages::INDEX)?,
        count: mesh.triangles.len() as u32 * 3,
        texture: texture_bytes(view.texture()) + texture_bytes(finish.texture()),
        group,
    })
}

fn uploaded(
    device: &Device,
    queue: &Queue,
    label: &str,
    (texture, format): (&Texture, TextureFormat),
) -> wgpu::TextureView {
    let descriptor = wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d {
            width: texture.width,
            height: texture.height,
            depth_or_array_layers: 1,
        },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    };
    device
        .create_texture_with_data(
            queue,
            &descriptor,
            TextureDataOrder::LayerMajor,
            &texture.rgba,
        )
        .create_view(&wgpu::TextureViewDescriptor {
            label: Some(label),
            ..Default::default()
        })
}
