//! Checks of what the `gltf` crate takes on trust: that accessors have the type they are read as and lie
//! within their buffers.

use gltf::accessor::{Accessor, DataType, Dimensions};
use gltf::buffer::{Data, View};
use gltf::json::Root;
use gltf::json::validation::Checked;

/// Most elements that an accessor without bytes behind it may have.
const MOST_EMPTY: usize = 1 << 24;

/// Checks the header of a GLB (glTF 2.0, section 4.4.2), from whose length the crate subtracts the header's
/// own. Messages end in a full stop.
pub(crate) fn header(bytes: &[u8]) -> Result<(), String> {
    match bytes {
        [b'g', b'l', b'T', b'F', _, _, _, _, a, b, c, d, ..] => {
            match u32::from_le_bytes([*a, *b, *c, *d]) {
                length @ 0..12 => Err(format!(
                    "the glTF is damaged: its header says that the file has {length} bytes, and the header \
                     alone has 12."
                )),
                _ => Ok(()),
            }
        }
        _ => Ok(()),
    }
}

/// Checks what even the crate's own validation takes on trust. Messages end in a full stop.
pub(crate) fn document(root: &Root) -> Result<(), String> {
    for (m, mesh) in root.meshes.iter().enumerate() {
        for (p, primitive) in mesh.primitives.iter().enumerate() {
            let place = format!("meshes[{m}].primitives[{p}]");
            for (semantic, accessor) in &primitive.attributes {
                let (i, count) = (accessor.value(), root.accessors.len());
                if i >= count {
                    let name = match semantic {
                        Checked::Valid(semantic) => semantic.to_string(),
                        Checked::Invalid => "an attribute".to_string(),
                    };
                    return Err(format!(
                        "{place}: {name} names accessor {i}, but there are {count}."
                    ));
                }
            }
        }
    }
    for (i, animation) in root.animations.iter().enumerate() {
        for (c, channel) in animation.channels.iter().enumerate() {
            if matches!(channel.target.path, Checked::Invalid) {
                return Err(format!(
                    "animations[{i}].channels[{c}].target.path has to be translation, rotation, scale or weights."
                ));
            }
            let named = [
                ("sampler", channel.sampler.value(), animation.samplers.len()),
                ("node", channel.target.node.value(), root.nodes.len()),
            ];
            if let Some((what, index, count)) = named.iter().find(|(_, i, count)| i >= count) {
                return Err(format!(
                    "animations[{i}].channels[{c}] names {what} {index}, but there are {count}."
                ));
            }
        }
    }
    for (i, image) in root.images.iter().enumerate() {
        let missing = match (&image.uri, &image.buffer_view, &image.mime_type) {
            (Some(_), _, _) | (_, Some(_), Some(_)) => continue,
            (None, Some(_), None) => "mimeType, which a buffer view needs",
            (None, None, _) => "uri or bufferView",
        };
        return Err(format!("images[{i}] has no {missing}."));
    }
    Ok(())
}

/// Checks an accessor that is to be read as `dimensions` of one of `types`. The message says what is wrong
/// with it, and does not end in a full stop.
pub(crate) fn accessor(
    accessor: &Accessor,
    buffers: &[Data],
    dimensions: Dimensions,
    types: &[DataType],
) -> Result<(), String> {
    let index = accessor.index();
    if accessor.dimensions() != dimensions || !types.contains(&accessor.data_type()) {
        return Err(format!(
            "accessor {index} holds {:?} of {:?}, but {dimensions:?} of {types:?} was expected",
            accessor.dimensions(),
            accessor.data_type(),
        ));
    }
    let wrong = |message| format!("accessor {index} {message}");
    let (count, size) = (accessor.count(), accessor.size());
    match (accessor.view(), accessor.sparse()) {
        (Some(view), _) => span(&view, buffers, accessor.offset(), count, size).map_err(wrong)?,
        (None, Some(_)) if count <= MOST_EMPTY => {}
        (None, _) => return Err(wrong("has no buffer view".to_string())),
    }
    if let Some(sparse) = accessor.sparse() {
        let (indices, values) = (sparse.indices(), sparse.values());
        let count = sparse.count();
        span(
            &indices.view(),
            buffers,
            indices.offset(),
            count,
            indices.index_type().size(),
        )
        .map_err(wrong)?;
        span(&values.view(), buffers, values.offset(), count, size).map_err(wrong)?;
    }
    Ok(())
}

/// Checks that `count` elements of `size` bytes from `offset` on lie within the view.
fn span(
    view: &View,
    buffers: &[Data],
    offset: usize,
    count: usize,
    size: usize,
) -> Result<(), String> {
    if count == 0 {
        return Err("has no elements".to_string());
    }
    let stride = view.stride().unwrap_or(size);
    if stride < size {
        return Err(format!(
            "has elements of {size} bytes but a stride of {stride}"
        ));
    }
    let end = (count - 1)
        .checked_mul(stride)
        .and_then(|n| n.checked_add(offset)?.checked_add(size));
    match end {
        Some(end) if end <= view.length() => self::view(view, buffers),
        _ => Err(format!(
            "reads past the end of buffer view {}: {count} elements of {size} bytes from byte {offset} on do \
             not fit into {} bytes",
            view.index(),
            view.length(),
        )),
    }
}

/// Checks that a view lies within its buffer.
pub(crate) fn view(view: &View, buffers: &[Data]) -> Result<(), String> {
    let length = buffers
        .get(view.buffer().index())
        .map_or(0, |data| data.0.len());
    match view.offset().checked_add(view.length()) {
        Some(end) if end <= length => Ok(()),
        _ => Err(format!(
            "reads past the end of buffer {}: buffer view {} has {} bytes from byte {} on, the buffer {length}",
            view.buffer().index(),
            view.index(),
            view.length(),
            view.offset(),
        )),
    }
}

/// Checks that a URI's percent signs make text: the crate takes that for granted.
pub(super) fn decodable(uri: &str) -> Result<(), String> {
    if uri.starts_with("data:") || !uri.contains('%') {
        return Ok(());
    }
    let mut bytes = Vec::new();
    let mut rest = uri.as_bytes();
    while let Some((&first, others)) = rest.split_first() {
        let digits = others.get(..2).and_then(|d| std::str::from_utf8(d).ok());
        match digits.and_then(|d| u8::from_str_radix(d, 16).ok()) {
            Some(byte) if first == b'%' => {
                bytes.push(byte);
                rest = &others[2..];
            }
            _ => {
                bytes.push(first);
                rest = others;
            }
        }
    }
    match std::str::from_utf8(&bytes) {
        Ok(_) => Ok(()),
        Err(_) => Err(format!(
            "`{uri}` is not UTF-8 once its percent signs are decoded"
        )),
    }
}
