//! Pictures side by side with captions, in one PNG file.

use crate::Error;
use crate::image::{Output, ending, screen};
use crate::words::{Align, Fonts, Text};
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder, Rgb, RgbImage};
use std::path::Path;

/// Pixels between pictures.
const GAP: u32 = 10;

/// Pixels above each picture, for its caption.
const CAPTION: u32 = 26;

/// Pixels above all.
const HEAD: u32 = 44;

/// The height of letters, in pixels.
const SIZE: f64 = 17.0;

const INK: [u8; 3] = [30, 30, 34];

/// A picture of a sheet: linear radiance, row by row, with the exposure already in it.
pub struct Cell {
    /// What stands above it.
    pub caption: String,
    /// Row by row from the top left.
    pub pixels: Vec<[f32; 3]>,
}

/// Whether a sheet can be written to a file of this name.
pub fn check(file: &Path) -> Result<(), Error> {
    match ending(file).as_deref() {
        Some("png") => Ok(()),
        _ => Err(Error::Usage(format!(
            "cannot write a sheet to {}: its name must end in .png",
            file.display()
        ))),
    }
}

/// Writes rows of pictures of one size under a title.
pub fn write(
    output: Output,
    file: &Path,
    title: &str,
    rows: &[Vec<Cell>],
    [width, height]: [u32; 2],
) -> Result<(), Error> {
    let sheet = draw(title, rows, [width, height])?;
    let path = file.display().to_string();
    output.finish(|writer| {
        // Noise is dear to keep: what can be saved is worth the time.
        PngEncoder::new_with_quality(writer, CompressionType::Best, FilterType::Adaptive)
            .write_image(
                &sheet,
                sheet.width(),
                sheet.height(),
                ExtendedColorType::Rgb8,
            )
            .map_err(|source| Error::Encode { path, source })
    })
}

fn draw(title: &str, rows: &[Vec<Cell>], [width, height]: [u32; 2]) -> Result<RgbImage, Error> {
    let fonts = Fonts::new()?;
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0) as u32;
    let (across, down) = (width + GAP, height + CAPTION + GAP);
    let size = [GAP + columns * across, HEAD + rows.len() as u32 * down];
    let mut sheet = RgbImage::from_pixel(size[0], size[1], Rgb([255; 3]));
    let write = |words: &str, at: [u32; 2], size: f64, bold: bool, sheet: &mut RgbImage| {
        let text = Text {
            words: words.into(),
            at: at.map(f64::from),
            size,
            color: INK,
            bold,
            align: Align::Left,
            upwards: false,
        };
        fonts.set(&text, sheet);
    };
    // Bold letters are wider than the regular ones that are measured.
    let room = 0.9 * f64::from(columns * across) / fonts.width(title, SIZE).max(1.0);
    write(
        title,
        [GAP, HEAD / 2],
        SIZE * room.min(1.2),
        true,
        &mut sheet,
    );
    for (row, cells) in (0..).zip(rows) {
        for (column, cell) in (0..).zip(cells) {
            let (left, top) = (GAP + column * across, HEAD + row * down);
            let at = [left, top + CAPTION / 2];
            // Narrower than its picture.
            let room = f64::from(width) / fonts.width(&cell.caption, SIZE).max(1.0);
            write(&cell.caption, at, SIZE * room.min(1.0), false, &mut sheet);
            for (i, pixel) in (0..).zip(&cell.pixels) {
                let (x, y) = (i % width, i / width);
                let (x, y) = (left + x, top + CAPTION + y);
                sheet.put_pixel(x, y, Rgb(screen(*pixel, x, y)));
            }
        }
    }
    Ok(sheet)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_picture_has_its_place() -> Result<(), Error> {
        let cell = |color: [f32; 3]| Cell {
            caption: "gj".into(),
            pixels: vec![color; 8 * 4],
        };
        let red = [1e3, 0.0, 0.0];
        let rows = [vec![cell([0.0; 3]), cell(red)], vec![cell([0.0; 3])]];
        let sheet = draw("A title", &rows, [8, 4])?;
        let black = sheet.pixels().filter(|p| p.0 == [0; 3]).count();
        assert_eq!(black, 2 * 32);
        let at = sheet.get_pixel(GAP + 8 + GAP, HEAD + CAPTION);
        assert!(at.0[0] > 250 && at.0 != [255; 3], "{at:?}");
        // Words stand above the pictures alone.
        let inked = |from: u32, to: u32| {
            let pixels = (from..to).flat_map(|y| (0..sheet.width()).map(move |x| (x, y)));
            pixels
                .filter(|(x, y)| sheet.get_pixel(*x, *y).0[0] < 100)
                .count()
        };
        assert!(inked(0, HEAD) > 10 && inked(HEAD, HEAD + CAPTION) > 10);
        assert_eq!(inked(HEAD + CAPTION + 4, HEAD + CAPTION + 4 + GAP), 0);
        assert!(check(Path::new("a.PNG")).is_ok() && check(Path::new("a.exr")).is_err());
        Ok(())
    }
}
