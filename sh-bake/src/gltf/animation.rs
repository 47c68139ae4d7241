//! Animations as clips (glTF 2.0, section 3.11).

use super::check;
use super::nodes::Tree;
use crate::error::one_line;
use glam::{Quat, Vec3, Vec4};
use gltf::accessor::{DataType, Dimensions};
use gltf::animation::util::ReadOutputs;
use gltf::animation::{Channel, Property};
use gltf::buffer::Data;
use gltf::scene::Transform;
use sh_scene::motion::{Clip, Interpolation, JointTracks, Track, Trs};
use std::collections::BTreeMap;

/// Values beyond this are taken as damage.
const FARTHEST: f32 = 1e9;

/// All of the document's animations. `warnings` get what was passed over. Messages end in a full stop.
pub(super) fn clips(
    document: &gltf::Document,
    tree: &Tree,
    buffers: &[Data],
    warnings: &mut Vec<String>,
) -> Result<Vec<Clip>, String> {
    let mut clips = Vec::new();
    for animation in document.animations() {
        let place = format!("animations[{}]", animation.index());
        let mut tracks: BTreeMap<u32, JointTracks> = BTreeMap::new();
        let mut morphs = false;
        for channel in animation.channels() {
            if channel.target().property() == Property::MorphTargetWeights {
                morphs = true;
                continue;
            }
            let node = channel.target().node();
            // What is outside the scene moves nothing.
            let Some(joint) = tree.joint_of[node.index()] else {
                continue;
            };
            let tracks = tracks.entry(joint).or_insert_with(|| JointTracks {
                joint,
                rest: parts(node.transform()),
                translation: None,
                rotation: None,
                scale: None,
            });
            let read = read(&channel, buffers, tracks);
            read.map_err(|e| format!("{place}.channels[{}]: {e}.", channel.index()))?;
        }
        let name = animation.name().map(one_line).unwrap_or_default();
        if morphs {
            warnings.push(format!(
                "{place} moves morph targets, which are not supported: what they would bend stays as it is."
            ));
        }
        clips.push(Clip::new(name, tracks.into_values().collect()));
    }
    Ok(clips)
}

/// A node's transform in parts, where a matrix is one: animated nodes have none by the book.
fn parts(transform: Transform) -> Trs {
    let (translation, rotation, scale) = transform.decomposed();
    Trs {
        translation: translation.into(),
        rotation: Quat::from_vec4(Vec4::from(rotation).normalize_or(Vec4::W)),
        scale: scale.into(),
    }
}

/// Reads a channel into the tracks of its node. Messages have no full stop.
fn read(channel: &Channel, buffers: &[Data], tracks: &mut JointTracks) -> Result<(), String> {
    let sampler = channel.sampler();
    let (input, output) = (sampler.input(), sampler.output());
    check::accessor(&input, buffers, Dimensions::Scalar, &[DataType::F32])
        .map_err(|e| format!("the sampler's input: {e}"))?;
    let (dimensions, types): (_, &[DataType]) = match channel.target().property() {
        Property::Rotation => (
            Dimensions::Vec4,
            &[
                DataType::F32,
                DataType::I8,
                DataType::U8,
                DataType::I16,
                DataType::U16,
            ],
        ),
        _ => (Dimensions::Vec3, &[DataType::F32]),
    };
    check::accessor(&output, buffers, dimensions, types)
        .map_err(|e| format!("the sampler's output: {e}"))?;
    let reader = channel.reader(|buffer| buffers.get(buffer.index()).map(|data| &data.0[..]));
    let times: Vec<f32> = reader
        .read_inputs()
        .map(Iterator::collect)
        .unwrap_or_default();
    let interpolation = match sampler.interpolation() {
        gltf::animation::Interpolation::Step => Interpolation::Step,
        gltf::animation::Interpolation::Linear => Interpolation::Linear,
        gltf::animation::Interpolation::CubicSpline => Interpolation::Cubic,
    };
    match reader.read_outputs() {
        Some(ReadOutputs::Translations(values)) => {
            tracks.translation = Some(vectors(times, values, interpolation)?);
        }
        Some(ReadOutputs::Scales(values)) => {
            tracks.scale = Some(vectors(times, values, interpolation)?);
        }
        Some(ReadOutputs::Rotations(values)) => {
            let values = values.into_f32().map(Quat::from_array).collect();
            let track = Track::new(times, values, interpolation).map_err(|e| e.to_string())?;
            tracks.rotation = Some(track);
        }
        _ => return Err("the sampler's output cannot be read".into()),
    }
    Ok(())
}

/// A track of translations or scales.
fn vectors(
    times: Vec<f32>,
    values: impl Iterator<Item = [f32; 3]>,
    interpolation: Interpolation,
) -> Result<Track<Vec3>, String> {
    let values: Vec<Vec3> = values.map(Vec3::from).collect();
    if let Some(far) = values.iter().find(|v| v.abs().max_element() > FARTHEST) {
        return Err(format!(
            "the sampler's output has a value {far}, and values have to be within ±{FARTHEST:e}"
        ));
    }
    Track::new(times, values, interpolation).map_err(|e| e.to_string())
}
