//! Environment maps from HDR and EXR files.

use crate::error::{Error, read};
use image::codecs::hdr::HdrDecoder;
use image::{DynamicImage, ImageFormat, ImageReader};
use sh_scene::EnvironmentMap;
use std::io::Cursor;
use std::path::Path;

/// Loads an equirectangular radiance map, Radiance HDR or OpenEXR by the ending of its name, of any size;
/// see [`EnvironmentMap`] for which way it faces. Colours are taken as linear Rec.709.
///
/// # Errors
/// Where the file cannot be read or decoded, or has a pixel that is negative, infinite or not a number.
pub fn load_environment(path: &Path) -> Result<EnvironmentMap, Error> {
    let ending = path
        .extension()
        .and_then(|e| e.to_str())
        .unwrap_or("")
        .to_ascii_lowercase();
    let format = match ending.as_str() {
        "hdr" | "pic" => ImageFormat::Hdr,
        "exr" => ImageFormat::OpenExr,
        _ => {
            return Err(Error::Format {
                path: path.into(),
                known: ".hdr, .pic and .exr",
            });
        }
    };
    let bytes = Cursor::new(read(path)?);
    let decoded = match format {
        // The format's first line is `#?RADIANCE` by the book, but many programs write another name there.
        ImageFormat::Hdr => HdrDecoder::new_nonstrict(bytes).and_then(DynamicImage::from_decoder),
        _ => ImageReader::with_format(bytes, format).decode(),
    };
    let image = decoded
        .map_err(|e| Error::file(path, format!("the image cannot be decoded: {e}.")))?
        .into_rgb32f();
    let (width, height) = image.dimensions();
    let pixels: Vec<[f32; 3]> = image.pixels().map(|p| p.0).collect();
    if width == 0 || height == 0 {
        return Err(Error::file(path, "the image has no pixels."));
    }
    for (i, pixel) in pixels.iter().enumerate() {
        if let Some(channel) = pixel.iter().position(|c| !(c.is_finite() && *c >= 0.0)) {
            let (x, y) = (i as u32 % width, i as u32 / width);
            let message = format!(
                "pixel (column {x}, row {y}) has {} {}, and radiance has to be finite and not negative.",
                ["red", "green", "blue"][channel],
                pixel[channel],
            );
            return Err(Error::file(path, message));
        }
    }
    Ok(EnvironmentMap {
        width,
        height,
        pixels,
    })
}
