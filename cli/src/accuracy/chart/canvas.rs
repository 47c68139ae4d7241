//! A drawing as a list of shapes and texts, and its two kinds of file.
//!
//! The same list becomes an SVG file, whose text the viewer sets in a font of its own, and a PNG file, whose
//! text is set here in the font that the program carries: no font of the system is ever asked for.

use crate::Error;
use crate::image::Output;
use ab_glyph::{Font, FontRef, Glyph, ScaleFont, point};
use image::{ExtendedColorType, ImageEncoder, RgbImage, imageops};
use plotters::backend::{BitMapBackend, DrawingBackend, SVGBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{
    FontDesc, FontFamily, FontStyle, FontTransform, RGBAColor, RGBColor, ShapeStyle, TextStyle,
    WHITE,
};
use std::io::Write;
use std::path::Path;

/// Red, green and blue, as a screen shows them.
pub(super) type Color = [u8; 3];

/// Right and down, in pixels of the PNG file.
pub(super) type Point = [f64; 2];

/// Which part of a text is at its position.
#[derive(Clone, Copy)]
pub(super) enum Align {
    Left,
    Center,
    Right,
}

struct Shape {
    points: Vec<Point>,
    color: Color,
    opacity: f64,
    /// The width of a line; none fills.
    width: Option<f64>,
}

struct Text {
    words: String,
    at: Point,
    size: f64,
    color: Color,
    bold: bool,
    align: Align,
    /// Reads upwards.
    upwards: bool,
}

/// What is to be drawn. All text is over all shapes.
pub(super) struct Canvas {
    size: [u32; 2],
    fonts: [FontRef<'static>; 2],
    shapes: Vec<Shape>,
    texts: Vec<Text>,
}

/// Roboto, reduced to Latin letters; `assets/README.md` tells where it is from.
const FONTS: [&[u8]; 2] = [
    include_bytes!("../../../assets/Roboto-Regular.ttf"),
    include_bytes!("../../../assets/Roboto-Bold.ttf"),
];

/// Names for a viewer of SVG files.
const FAMILIES: &str = "Roboto, Helvetica, Arial, Liberation Sans, sans-serif";

/// Half the height of small letters over the font's size, which centres text on its position: in SVG files
/// plotters does the same.
const MIDDLE: f64 = 0.264;

/// Plotters rounds positions to whole units; a pixel has so many of them, along and down. The PNG file is the
/// average of its units.
const UNITS: u32 = 3;

impl Canvas {
    /// An empty one, so many pixels wide and high.
    pub fn new(size: [u32; 2]) -> Result<Self, Error> {
        let broken = |_| Error::Usage("cannot draw: the program's own font is broken".into());
        let [regular, bold] = FONTS.map(|bytes| FontRef::try_from_slice(bytes).map_err(broken));
        Ok(Self {
            size,
            fonts: [regular?, bold?],
            shapes: Vec::new(),
            texts: Vec::new(),
        })
    }

    /// A line through points.
    pub fn line(&mut self, points: &[Point], color: Color, width: f64) {
        self.shapes.push(Shape {
            points: points.to_vec(),
            color,
            opacity: 1.0,
            width: Some(width),
        });
    }

    /// A filled polygon.
    pub fn fill(&mut self, points: &[Point], color: Color, opacity: f64) {
        self.shapes.push(Shape {
            points: points.to_vec(),
            color,
            opacity,
            width: None,
        });
    }

    /// A line of text, centred in height on its position.
    pub fn text(&mut self, words: &str, at: Point, size: f64, color: Color, align: Align) {
        self.texts.push(Text {
            words: words.into(),
            at,
            size,
            color,
            bold: false,
            align,
            upwards: false,
        });
    }

    /// The same in bold.
    pub fn bold(&mut self, words: &str, at: Point, size: f64, color: Color, align: Align) {
        self.text(words, at, size, color, align);
        self.texts.last_mut().expect("pushed above").bold = true;
    }

    /// The same, centred and read upwards.
    pub fn upwards(&mut self, words: &str, at: Point, size: f64, color: Color) {
        self.text(words, at, size, color, Align::Center);
        self.texts.last_mut().expect("pushed above").upwards = true;
    }

    /// How wide a text is.
    pub fn width(&self, words: &str, size: f64) -> f64 {
        let glyphs = glyphs(&self.fonts[0], words, size);
        glyphs.last().map_or(0.0, |(_, end)| *end)
    }

    /// Writes the file: SVG or PNG by its ending.
    pub fn write(&self, path: &Path) -> Result<(), Error> {
        let kind = Kind::of(path)?;
        let output = Output::create(path)?;
        let name = path.display().to_string();
        let encode = |source| Error::Encode {
            path: name.clone(),
            source,
        };
        let other = |error: &dyn std::fmt::Display| {
            let source = std::io::Error::other(error.to_string());
            encode(image::ImageError::IoError(source))
        };
        match kind {
            Kind::Svg => {
                let svg = self.svg().map_err(|error| other(&error))?;
                output.finish(|file| {
                    let written = file.write_all(svg.as_bytes());
                    written.map_err(|source| Error::file("write to", path.display(), source))
                })
            }
            Kind::Png => {
                let picture = self.picture().map_err(|error| other(&error))?;
                let [width, height] = self.size;
                output.finish(|file| {
                    image::codecs::png::PngEncoder::new(file)
                        .write_image(&picture, width, height, ExtendedColorType::Rgb8)
                        .map_err(encode)
                })
            }
        }
    }

    fn svg(&self) -> Result<String, String> {
        let mut svg = String::new();
        let units = self.size.map(|side| side * UNITS);
        {
            let mut backend = SVGBackend::with_string(&mut svg, (units[0], units[1]));
            self.paint(&mut backend)?;
            for text in &self.texts {
                let horizontal = match text.align {
                    Align::Left => HPos::Left,
                    Align::Center => HPos::Center,
                    Align::Right => HPos::Right,
                };
                let style = [FontStyle::Normal, FontStyle::Bold][usize::from(text.bold)];
                // Plotters divides a font's size by this factor.
                let size = text.size * f64::from(UNITS) * 1.24;
                let font = FontDesc::new(FontFamily::Name(FAMILIES), size, style);
                let [r, g, b] = text.color;
                let color = RGBColor(r, g, b);
                let mut style = TextStyle::from(font)
                    .color(&color)
                    .pos(Pos::new(horizontal, VPos::Center));
                if text.upwards {
                    style = style.transform(FontTransform::Rotate270);
                }
                let drawn = backend.draw_text(&text.words, &style, whole(text.at));
                drawn.map_err(|e| e.to_string())?;
            }
            backend.present().map_err(|e| e.to_string())?;
        }
        // As large as the PNG file, whatever the units.
        let size = |[width, height]: [u32; 2]| format!("width=\"{width}\" height=\"{height}\"");
        Ok(svg.replacen(&size(units), &size(self.size), 1))
    }

    fn picture(&self) -> Result<RgbImage, String> {
        let [width, height] = self.size.map(|side| side * UNITS);
        let mut fine = RgbImage::new(width, height);
        {
            let mut backend = BitMapBackend::with_buffer(&mut fine, (width, height));
            self.paint(&mut backend)?;
            backend.present().map_err(|e| e.to_string())?;
        }
        let mut picture = imageops::thumbnail(&fine, self.size[0], self.size[1]);
        for text in &self.texts {
            self.set(text, &mut picture);
        }
        Ok(picture)
    }

    /// A white ground and the shapes. Fails with what the backend says.
    fn paint(&self, backend: &mut impl DrawingBackend) -> Result<(), String> {
        let [width, height] = self.size.map(|side| (side * UNITS) as i32);
        let ground = backend.draw_rect((0, 0), (width, height), &WHITE, true);
        ground.map_err(|error| error.to_string())?;
        for shape in &self.shapes {
            let [r, g, b] = shape.color;
            let color = RGBAColor(r, g, b, shape.opacity);
            let points = shape.points.iter().map(|p| whole(*p));
            let drawn = match shape.width {
                None => backend.fill_polygon(points, &color),
                Some(width) => {
                    let stroke_width = (width * f64::from(UNITS)).round() as u32;
                    let style = ShapeStyle {
                        color,
                        filled: false,
                        stroke_width,
                    };
                    backend.draw_path(points, &style)
                }
            };
            drawn.map_err(|error| error.to_string())?;
        }
        Ok(())
    }

    /// Sets a text into the picture.
    fn set(&self, text: &Text, picture: &mut RgbImage) {
        let glyphs = glyphs(&self.fonts[usize::from(text.bold)], &text.words, text.size);
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
        let font = &self.fonts[usize::from(text.bold)];
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

/// A position in units.
fn whole(at: Point) -> (i32, i32) {
    let [x, y] = at.map(|side| (side * f64::from(UNITS)).round() as i32);
    (x, y)
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

/// Whether a chart can be written to a file of this name.
pub(super) fn check(path: &Path) -> Result<(), Error> {
    Kind::of(path).map(|_| ())
}

/// The kinds of files that charts are written to.
enum Kind {
    Svg,
    Png,
}

impl Kind {
    fn of(path: &Path) -> Result<Self, Error> {
        match crate::image::ending(path).as_deref() {
            Some("svg") => Ok(Self::Svg),
            Some("png") => Ok(Self::Png),
            _ => Err(Error::Usage(format!(
                "cannot write a chart to {}: its name must end in .svg or .png",
                path.display()
            ))),
        }
    }
}
