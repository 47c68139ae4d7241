//! Base colour textures of glTF files.

use super::check;
use gltf::buffer::Data;
use gltf::image::{Data as Image, Format, Source};
use sh_scene::Texture;
use std::path::Path;

/// Decodes a texture's image to 8-bit RGBA. Messages have no full stop.
pub(crate) fn load(
    texture: &gltf::Texture,
    folder: &Path,
    buffers: &[Data],
) -> Result<Texture, String> {
    let image = texture.source();
    let name = format!("images[{}]", image.index());
    match image.source() {
        Source::View { view, .. } => check::view(&view, buffers),
        Source::Uri { uri, .. } => check::decodable(uri),
    }
    .map_err(|e| format!("{name} {e}"))?;
    let image = Image::from_source(image.source(), Some(folder), buffers).map_err(|e| {
        let e = e.to_string();
        let e = e.trim_end_matches(['.', ' ', '\n']);
        format!("{name}, the base colour texture, cannot be decoded: {e}")
    })?;
    let rgba = rgba(&image);
    if image.width == 0 || rgba.len() != image.width as usize * image.height as usize * 4 {
        return Err(format!("{name}, the base colour texture, is empty"));
    }
    Ok(Texture {
        width: image.width,
        height: image.height,
        rgba,
    })
}

/// Any pixel format as 8-bit RGBA: grey is spread, 16 bits lose the lower 8, floats (which only HDR images
/// have) are cut to 0..=1.
fn rgba(image: &Image) -> Vec<u8> {
    let (channels, bytes) = match image.format {
        Format::R8 => (1, 1),
        Format::R8G8 => (2, 1),
        Format::R8G8B8 => (3, 1),
        Format::R8G8B8A8 => (4, 1),
        Format::R16 => (1, 2),
        Format::R16G16 => (2, 2),
        Format::R16G16B16 => (3, 2),
        Format::R16G16B16A16 => (4, 2),
        Format::R32G32B32FLOAT => (3, 4),
        Format::R32G32B32A32FLOAT => (4, 4),
    };
    let value = |b: &[u8]| match *b {
        [v] => v,
        [_, high] => high,
        [a, b, c, d] => (f32::from_le_bytes([a, b, c, d]).clamp(0.0, 1.0) * 255.0) as u8,
        _ => 0,
    };
    image
        .pixels
        .chunks_exact(channels * bytes)
        .flat_map(|pixel| {
            let at = |c: usize| value(&pixel[c * bytes..(c + 1) * bytes]);
            match channels {
                1 => [at(0), at(0), at(0), 255],
                2 => [at(0), at(0), at(0), at(1)],
                3 => [at(0), at(1), at(2), 255],
                _ => [at(0), at(1), at(2), at(3)],
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn floats_are_cut_to_what_reflects_and_what_is_no_number_is_black() {
        let pixels = [f32::NAN, f32::INFINITY, -1.0, 0.5, 7.0, 0.0];
        let image = Image {
            pixels: pixels.into_iter().flat_map(f32::to_le_bytes).collect(),
            format: Format::R32G32B32FLOAT,
            width: 2,
            height: 1,
        };
        assert_eq!(rgba(&image), [0, 255, 0, 255, 127, 255, 0, 255]);
    }
}
