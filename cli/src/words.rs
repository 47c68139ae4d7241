//! Words in pictures, in the font that the program carries: no font of the system is ever asked for.

use crate::Error;
use ab_glyph::{Font, FontRef, Glyph, ScaleFont, point};
use image::RgbImage;

/// Red, green and blue, as a screen shows them.
pub type Color = [u8; 3];

/// Right and down, in pixels.
pub type Point = [f64; 2];

/// Which part of a text is at its position.
#[derive(Clone, Copy)]
pub enum Align {
    /// Its left end.
    Left,
    /// Its middle.
    Center,
    /// Its right end.
    Right,
}

/// A line of text, centred in height on its position.
pub struct Text {
    /// The text itself, one line.
    pub words: String,
    /// Where it is: `align` says which part of it.
    pub at: Point,
    /// The em square's side, in pixels.
    pub size: f64,
    /// Of the letters; the ground stays.
    pub color: Color,
    /// The bold font instead of the regular one.
    pub bold: bool,
    /// Which part of it is at `at`.
    pub align: Align,
    /// Reads upwards.
    pub upwards: bool,
}

/// Roboto, reduced to Latin letters; `assets/README.md` tells where it is from.
pub const FONTS: [&[u8]; 2] = [
    include_bytes!("../assets/Roboto-Regular.ttf"),
    include_bytes!("../assets/Roboto-Bold.ttf"),
];

/// Half the height of small letters over the font's size, which centres text on its position: in SVG files
/// plotters does the same.
const MIDDLE: f64 = 0.264;

/// The regular font and the bold one.
pub struct Fonts([FontRef<'static>; 2]);

impl Fonts {
    /// # Errors
    /// None, unless the program's own files are broken.
    pub fn new() -> Result<Self, Error> {
        let broken = |_| Error::Usage("cannot draw: the program's own font is broken".into());
        let [regular, bold] = FONTS.map(|bytes| FontRef::try_from_slice(bytes).map_err(broken));
        Ok(Self([regular?, bold?]))
    }

    /// How wide a regular text is.
    pub fn width(&self, words: &str, size: f64) -> f64 {
        let glyphs = glyphs(&self.0[0], words, size);
        glyphs.last().map_or(0.0, |(_, end)| *end)
    }

    /// Sets a text into a picture. What lies outside is cut off.
    pub fn set(&self, text: &Text, picture: &mut RgbImage) {
        let font = &self.0[usize::from(text.bold)];
        let glyphs = glyphs(font, &text.words, text.size);
        let width = glyphs.last().map_or(0.0, |(_, end)| *end);
        let start = match text.align {
            Align::Left => 0.0,
            Align::Center => width / 2.0,
            Align::Right => width,
        };
        // Fractions of a pixel go into the outlines; upwards text keeps none.
        let base = [-start, MIDDLE * text.size];
        let (corner, base) = if text.upwards {
            (text.at.map(f64::round), base)
        } else {
            ([0.0; 2], [text.at[0] + base[0], text.at[1] + base[1]])
        };
        for (mut glyph, _) in glyphs {
            glyph.position += point(base[0] as f32, base[1] as f32);
            let Some(outline) = font.outline_glyph(glyph) else {
                continue;
            };
            let from = outline.px_bounds().min;
            outline.draw(|x, y, cover| {
                let (x, y) = (
                    f64::from(from.x) + f64::from(x),
                    f64::from(from.y) + f64::from(y),
                );
                let [x, y] = if text.upwards {
                    [corner[0] + y, corner[1] - x]
                } else {
                    [x, y]
                };
                if x < 0.0 || y < 0.0 {
                    return;
                }
                if let Some(pixel) = picture.get_pixel_mut_checked(x as u32, y as u32) {
                    for (below, over) in pixel.0.iter_mut().zip(text.color) {
                        let (old, new) = (f32::from(*below), f32::from(over));
                        *below = (old + (new - old) * cover.clamp(0.0, 1.0)).round() as u8;
                    }
                }
            });
        }
    }
}

/// The glyphs of a text that starts at the origin of its baseline, each with where the next one begins.
fn glyphs(font: &FontRef<'_>, words: &str, size: f64) -> Vec<(Glyph, f64)> {
    // The crate counts from the lowest to the highest, sizes are those of the em square.
    let em = font.units_per_em().unwrap_or(1.0);
    let scaled = font.as_scaled(size as f32 * font.height_unscaled() / em);
    let mut at = 0.0;
    let place = |letter| {
        let mut glyph = scaled.scaled_glyph(letter);
        glyph.position = point(at, 0.0);
        at += scaled.h_advance(glyph.id);
        (glyph, f64::from(at))
    };
    words.chars().map(place).collect()
}
