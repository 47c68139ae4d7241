//! Environment maps from HDR and EXR files.

use crate::error::{Error, read};
use exr::math::Vec2;
use exr::meta::{BlockDescription, MetaData};
use image::codecs::hdr::HdrDecoder;
use image::codecs::openexr::OpenExrDecoder;
use image::{DynamicImage, ImageDecoder, ImageError, ImageFormat};
use sh_scene::EnvironmentMap;
use std::io::Cursor;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

/// More pixels than any compression puts into a byte. Deflate makes at most 1,032 bytes of one, which is 172
/// pixels of three halves; after DWA, which leaves 12 bytes of a block of 64 equal pixels, it is 5,500. Run
/// lengths reach 2,000 in rows of 16,384 equal pixels.
const MOST_PIXELS_A_BYTE: u64 = 16_384;

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
    let bytes = read(path)?;
    let size = bytes.len();
    // The decoders make room for whatever sizes the header says, before they read a pixel.
    let most = MOST_PIXELS_A_BYTE * size as u64;
    let impossible = |width: u64, height: u64| {
        let message = format!(
            "the header says {width} × {height} pixels, which {size} bytes cannot hold: the file is damaged."
        );
        Error::file(path, message)
    };
    if format == ImageFormat::OpenExr
        && let Some([width, height]) = largest_block(&bytes, most)
    {
        return Err(impossible(width, height));
    }
    let bytes = Cursor::new(bytes);
    let undecodable =
        |e: ImageError| Error::file(path, format!("the image cannot be decoded: {e}."));
    let decoder: Box<dyn ImageDecoder> = match format {
        // The format's first line is `#?RADIANCE` by the book, but many programs write another name there.
        ImageFormat::Hdr => Box::new(HdrDecoder::new_nonstrict(bytes).map_err(undecodable)?),
        _ => Box::new(OpenExrDecoder::new(bytes).map_err(undecodable)?),
    };
    let (width, height) = decoder.dimensions();
    if u64::from(width) * u64::from(height) > most {
        return Err(impossible(width.into(), height.into()));
    }
    // Where arithmetic is checked for overflow, the EXR decoder ends in a panic on some damaged files.
    let image = catch_unwind(AssertUnwindSafe(|| DynamicImage::from_decoder(decoder)))
        .map_err(|_| Error::file(path, "the image cannot be decoded: it is damaged."))?
        .map_err(undecodable)?
        .into_rgb32f();
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

/// The first data window, tile or block of rows of an EXR's layers that has more than `most` pixels: none of
/// them needs to be as large as the picture. None in a file that is no EXR: its decoder will say so.
fn largest_block(bytes: &[u8], most: u64) -> Option<[u64; 2]> {
    let header = MetaData::read_from_buffered(bytes, false).ok()?;
    let blocks = header.headers.iter().flat_map(|layer| {
        let Vec2(width, height) = layer.layer_size;
        let block = match layer.blocks {
            BlockDescription::Tiles(tiles) => tiles.tile_size,
            // However few rows there are, the decoder makes room for as many as the compression takes.
            BlockDescription::ScanLines => Vec2(width, layer.compression.scan_lines_per_block()),
        };
        [Vec2(width, height), block]
    });
    blocks
        .map(|size| [size.0 as u64, size.1 as u64])
        .find(|[width, height]| width.saturating_mul(*height) > most)
}
