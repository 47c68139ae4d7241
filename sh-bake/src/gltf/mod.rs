//! glTF 2.0, read by the `gltf` crate.

mod animation;
mod cameras;
mod check;
mod lights;
mod nodes;
mod texture;

use crate::error::{Error, one_line, shown};
use crate::model::ModelCamera;
use crate::raw::{Bind, RawFigure, RawPart, WHITE};
use gltf::Gltf;
use gltf::accessor::{DataType, Dimensions};
use gltf::buffer::{self, Data};
use gltf::mesh::{Mode, Primitive, Semantic};
use nodes::{Placed, Tree};
use sh_scene::{Finish, Material, PunctualLight};
use std::path::Path;

/// Required extensions that change nothing of what is read here.
const HARMLESS: [&str; 2] = ["KHR_lights_punctual", "KHR_materials_unlit"];

/// What a file holds.
pub(crate) struct Loaded {
    /// All triangles of the default scene (the first where none is named), a part for each primitive.
    pub(crate) parts: Vec<RawPart>,
    /// What moves them; none where the file has no animations.
    pub(crate) figure: Option<RawFigure>,
    /// Its cameras, in its space.
    pub(crate) cameras: Vec<ModelCamera>,
    /// Its lights, in its space.
    pub(crate) lights: Vec<PunctualLight>,
    /// What was passed over.
    pub(crate) warnings: Vec<String>,
}

/// Reads a file.
pub(crate) fn load(path: &Path, bytes: &[u8]) -> Result<Loaded, Error> {
    let wrong = |message: String| Error::file(path, message);
    let damaged = |e: gltf::Error| wrong(format!("the glTF is damaged: {e}."));

    check::header(bytes).map_err(wrong)?;
    // Before the crate's own validation, which refuses such files without saying which extension it is.
    let unchecked = Gltf::from_slice_without_validation(bytes).map_err(damaged)?;
    if let Some(name) = unchecked
        .extensions_required()
        .find(|name| !HARMLESS.contains(name))
    {
        return Err(wrong(format!(
            "extensionsRequired names {name}, which is not supported; save the file without it."
        )));
    }
    check::document(unchecked.as_json()).map_err(wrong)?;
    let Gltf { document, blob } = Gltf::from_slice(bytes).map_err(damaged)?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let buffers = buffers(&document, folder, blob).map_err(wrong)?;

    let mut warnings = Vec::new();
    let Some(scene) = document
        .default_scene()
        .or_else(|| document.scenes().next())
    else {
        return Err(wrong(
            "the glTF has no scene, and so no triangles.".to_string(),
        ));
    };
    let tree = Tree::new(&document, &scene, &buffers).map_err(wrong)?;
    let clips = animation::clips(&document, &tree, &buffers, &mut warnings).map_err(wrong)?;
    let moves = !clips.is_empty();
    let cameras = cameras::all(&tree, moves, &mut warnings);
    let lights = lights::all(&tree, moves, &mut warnings);
    for warning in &mut warnings {
        *warning = format!("{}: {warning}", shown(path));
    }
    let mut parts = Vec::new();
    for placed in &tree.meshes {
        let mesh = &placed.mesh;
        for primitive in mesh.primitives() {
            let name = match mesh.name() {
                Some(name) => format!(
                    "mesh {} ({}), primitive {}",
                    mesh.index(),
                    one_line(name),
                    primitive.index()
                ),
                None => format!("mesh {}, primitive {}", mesh.index(), primitive.index()),
            };
            let explain = |message: String| wrong(format!("{name}: {message}."));
            let mut part = surface(&primitive, &buffers, placed, moves).map_err(explain)?;
            if part.triangles.is_empty() {
                let display = shown(path);
                warnings.push(format!(
                    "{display}: {name} has no triangles and was passed over."
                ));
                continue;
            }
            part.material =
                material(&primitive, folder, &buffers, &mut part.uvs).map_err(explain)?;
            if let Some(sets) = apart(&primitive) {
                part.material.finish_texture = None;
                let display = shown(path);
                warnings.push(format!(
                    "{display}: {name}: its base colour has texture coordinates {}, its metallic-roughness texture {}; one set is read, and that texture was left out.",
                    sets[0], sets[1]
                ));
            }
            for wrong in clamp(&primitive, &mut part) {
                let display = shown(path);
                warnings.push(format!(
                    "{display}: {name}: {wrong}, and reflectances lie between 0 and 1; it was clamped."
                ));
            }
            part.name = name;
            parts.push(part);
        }
    }
    let figure = (!clips.is_empty()).then_some(RawFigure {
        joints: tree.joints,
        bones: tree.bones,
        clips,
    });
    Ok(Loaded {
        parts,
        figure,
        cameras,
        lights,
        warnings,
    })
}

/// The bytes of every buffer.
fn buffers(
    document: &gltf::Document,
    folder: &Path,
    blob: Option<Vec<u8>>,
) -> Result<Vec<Data>, String> {
    for buffer in document.buffers() {
        if let buffer::Source::Uri(uri) = buffer.source() {
            check::decodable(uri).map_err(|e| format!("buffers[{}].uri {e}.", buffer.index()))?;
        }
    }
    gltf::import_buffers(document, Some(folder), blob).map_err(|e| match e {
        gltf::Error::BufferLength { buffer, expected, actual } => format!(
            "buffers[{buffer}].byteLength says {expected} bytes, but there are {actual}: the file is cut off."
        ),
        gltf::Error::Io(e) => format!("a file that buffers[].uri names cannot be read: {e}."),
        e => format!("buffers[]: {e}."),
    })
}

/// A primitive's triangles where its node puts them, and what carries them, where it `moves`. Messages name the
/// attribute and have no full stop.
fn surface(
    primitive: &Primitive,
    buffers: &[Data],
    placed: &Placed,
    moves: bool,
) -> Result<RawPart, String> {
    let mut part = RawPart {
        name: String::new(),
        positions: Vec::new(),
        normals: Vec::new(),
        uvs: Vec::new(),
        colors: Vec::new(),
        triangles: Vec::new(),
        material: Material::diffuse(WHITE),
        bind: None,
    };
    if !matches!(
        primitive.mode(),
        Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan
    ) {
        return Ok(part);
    }
    for (semantic, accessor) in primitive.attributes() {
        let (dimensions, types): (_, &[DataType]) = match semantic {
            Semantic::Positions | Semantic::Normals => (Dimensions::Vec3, &[DataType::F32]),
            Semantic::TexCoords(_) => (
                Dimensions::Vec2,
                &[DataType::F32, DataType::U8, DataType::U16],
            ),
            // Colours may have an alpha, which counts for nothing here.
            Semantic::Colors(0) => (
                match accessor.dimensions() {
                    Dimensions::Vec4 => Dimensions::Vec4,
                    _ => Dimensions::Vec3,
                },
                &[DataType::F32, DataType::U8, DataType::U16],
            ),
            Semantic::Joints(0) => (Dimensions::Vec4, &[DataType::U8, DataType::U16]),
            Semantic::Weights(0) => (
                Dimensions::Vec4,
                &[DataType::F32, DataType::U8, DataType::U16],
            ),
            _ => continue,
        };
        let name = semantic.to_string();
        check::accessor(&accessor, buffers, dimensions, types)
            .map_err(|e| format!("{name}: {e}"))?;
    }
    let reader = primitive.reader(|buffer| buffers.get(buffer.index()).map(|data| &data.0[..]));
    let Some(positions) = reader.read_positions() else {
        return Ok(part);
    };
    part.positions = positions.collect();
    part.normals = reader
        .read_normals()
        .map(Iterator::collect)
        .unwrap_or_default();
    let corners: Vec<u32> = match primitive.indices() {
        Some(accessor) => {
            let types = [DataType::U8, DataType::U16, DataType::U32];
            check::accessor(&accessor, buffers, Dimensions::Scalar, &types)
                .map_err(|e| format!("indices: {e}"))?;
            reader
                .read_indices()
                .map(|i| i.into_u32().collect())
                .unwrap_or_default()
        }
        None => (0..part.positions.len() as u32).collect(),
    };
    part.triangles = match primitive.mode() {
        Mode::TriangleStrip => strip(&corners),
        Mode::TriangleFan => corners
            .windows(2)
            .skip(1)
            .map(|w| [corners[0], w[0], w[1]])
            .collect(),
        _ => corners.as_chunks::<3>().0.to_vec(),
    };
    if part.normals.len() != part.positions.len() {
        part.normals.clear();
    }
    let surface = primitive.material().pbr_metallic_roughness();
    let textures = [
        surface.base_color_texture(),
        surface.metallic_roughness_texture(),
    ];
    if let Some(set) = textures.into_iter().flatten().next() {
        let uvs = reader.read_tex_coords(set.tex_coord());
        part.uvs = uvs.map(|uvs| uvs.into_f32().collect()).unwrap_or_default();
    }
    if part.uvs.len() != part.positions.len() {
        part.uvs.clear();
    }
    part.colors = reader
        .read_colors(0)
        .map(|colors| colors.into_rgb_f32().collect())
        .unwrap_or_default();
    if let Some(color) = part
        .colors
        .iter()
        .find(|c| !c.iter().all(|c| c.is_finite()))
    {
        return Err(format!(
            "COLOR_0: a vertex has the colour {color:?}, and colours have to be finite"
        ));
    }
    if part.colors.len() != part.positions.len() {
        part.colors.clear();
    }
    let joints: Vec<[u16; 4]> = reader
        .read_joints(0)
        .map(|j| j.into_u16().collect())
        .unwrap_or_default();
    let weights: Vec<[f32; 4]> = reader
        .read_weights(0)
        .map(|w| w.into_f32().collect())
        .unwrap_or_default();
    let rest = moves.then(|| part.positions.clone());
    placed.placement.apply(&mut part, &joints, &weights)?;
    part.bind = rest.map(|positions| Bind {
        influences: placed.placement.influences(
            placed.first_bone,
            positions.len(),
            &joints,
            &weights,
        ),
        positions,
    });
    Ok(part)
}

/// A strip's triangles: every second one is turned, so that all face alike.
fn strip(corners: &[u32]) -> Vec<[u32; 3]> {
    let turned = |(k, w): (usize, &[u32])| {
        if k % 2 == 0 {
            [w[0], w[1], w[2]]
        } else {
            [w[1], w[0], w[2]]
        }
    };
    corners.windows(3).enumerate().map(turned).collect()
}

/// Base colour, finish and their textures. A texture without coordinates is left out, coordinates without a texture too.
fn material(
    primitive: &Primitive,
    folder: &Path,
    buffers: &[Data],
    uvs: &mut Vec<[f32; 2]>,
) -> Result<Material, String> {
    let surface = primitive.material().pbr_metallic_roughness();
    let [r, g, b, _] = surface.base_color_factor();
    let albedo = [r, g, b];
    let texture = match surface.base_color_texture() {
        Some(info) if !uvs.is_empty() => Some(texture::load(&info.texture(), folder, buffers)?),
        _ => None,
    };
    let finish_texture = match surface.metallic_roughness_texture() {
        Some(info) if !uvs.is_empty() => Some(texture::load(&info.texture(), folder, buffers)?),
        _ => None,
    };
    // Without any material nothing is said of how polished it is, and the defaults of one that is there are a metal's.
    let finish = match primitive.material().index() {
        None => Finish::DIFFUSE,
        Some(_) => Finish {
            roughness: surface.roughness_factor(),
            metallic: surface.metallic_factor(),
        },
    };
    if texture.is_none() && finish_texture.is_none() {
        uvs.clear();
    } else if let Some(uv) = uvs.iter().find(|uv| !uv.iter().all(|c| c.is_finite())) {
        return Err(format!(
            "TEXCOORD: a texture coordinate is {uv:?}, and they have to be finite"
        ));
    }
    Ok(Material {
        albedo,
        texture,
        finish,
        finish_texture,
    })
}

/// The sets of texture coordinates of base colour and finish, if they are two.
fn apart(primitive: &Primitive) -> Option<[u32; 2]> {
    let surface = primitive.material().pbr_metallic_roughness();
    let color = surface.base_color_texture()?.tex_coord();
    let finish = surface.metallic_roughness_texture()?.tex_coord();
    (color != finish).then_some([color, finish])
}

/// Takes what a part reflects to 0..=1. What was outside, without a full stop.
fn clamp(primitive: &Primitive, part: &mut RawPart) -> Vec<String> {
    let inside = |color: &[f32; 3]| color.iter().all(|c| (0.0..=1.0).contains(c));
    let mut wrong = Vec::new();
    let albedo = &mut part.material.albedo;
    if !inside(albedo) {
        let material = primitive.material().index().unwrap_or_default();
        wrong.push(format!(
            "materials[{material}].pbrMetallicRoughness.baseColorFactor is {albedo:?}"
        ));
        *albedo = albedo.map(|c| c.clamp(0.0, 1.0));
    }
    let Finish {
        roughness,
        metallic,
    } = &mut part.material.finish;
    for (name, factor) in [("roughnessFactor", roughness), ("metallicFactor", metallic)] {
        if !(0.0..=1.0).contains(factor) {
            let material = primitive.material().index().unwrap_or_default();
            wrong.push(format!(
                "materials[{material}].pbrMetallicRoughness.{name} is {factor:?}"
            ));
            *factor = factor.clamp(0.0, 1.0);
        }
    }
    if let Some(color) = part.colors.iter().find(|color| !inside(color)) {
        wrong.push(format!("COLOR_0 has the colour {color:?}"));
        for color in &mut part.colors {
            *color = color.map(|c| c.clamp(0.0, 1.0));
        }
    }
    wrong
}
