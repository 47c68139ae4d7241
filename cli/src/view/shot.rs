//! A picture of the window, to a file.

use crate::Error;
use crate::image::{Output, ending};
use egui::ColorImage;
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder};
use std::path::{Path, PathBuf};

/// A file for the picture, opened before it is there.
pub(super) struct Shot {
    output: Output,
    path: PathBuf,
}

/// Opens the file.
///
/// # Errors
/// Where it cannot be written or is no PNG file by its name.
pub(super) fn open(path: &Path) -> Result<Shot, Error> {
    if ending(path).as_deref() != Some("png") {
        return Err(Error::Usage(format!(
            "cannot write a picture of the window to {}: its name must end in .png",
            path.display()
        )));
    }
    let output = Output::create(path)?;
    let path = path.into();
    Ok(Shot { output, path })
}

/// Writes the picture and tells where it is and where it was drawn. A window is opaque.
pub(super) fn write(shot: Shot, picture: &ColorImage, place: &str) -> Result<String, Error> {
    let Shot { output, path } = shot;
    let [width, height] = picture.size.map(|side| side as u32);
    let pixels = picture.pixels.iter().flat_map(|c| [c.r(), c.g(), c.b()]);
    let bytes: Vec<u8> = pixels.collect();
    output.finish(|writer| {
        let encoder = PngEncoder::new(writer);
        let written = encoder.write_image(&bytes, width, height, ExtendedColorType::Rgb8);
        written.map_err(|source| Error::Encode {
            path: path.display().to_string(),
            source,
        })
    })?;
    let path = path.display();
    Ok(format!(
        "{path}: the window, {width} x {height} pixels, drawn {place}."
    ))
}
