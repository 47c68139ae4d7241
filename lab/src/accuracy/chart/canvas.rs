//! A drawing as a list of shapes and texts, and its two kinds of file.
//!
//! The same list becomes an SVG file, whose text the viewer sets in a font of its own, and a PNG file, whose
//! text is set here in the font that the program carries: no font of the system is ever asked for.

use gaunt::Error;
use gaunt::image::Output;
pub(super) use gaunt::words::{Align, Color, Point};
use gaunt::words::{Fonts, Text};
use image::{ExtendedColorType, ImageEncoder, RgbImage, imageops};
use plotters::backend::{BitMapBackend, DrawingBackend, SVGBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{
    FontDesc, FontFamily, FontStyle, FontTransform, RGBAColor, RGBColor, ShapeStyle, TextStyle,
    WHITE,
};
use std::io::Write;
use std::path::Path;

struct Shape {
    points: Vec<Point>,
    color: Color,
    opacity: f64,
    /// The width of a line; none fills.
    width: Option<f64>,
}

/// What is to be drawn. All text is over all shapes.
pub(super) struct Canvas {
    size: [u32; 2],
    fonts: Fonts,
    shapes: Vec<Shape>,
    texts: Vec<Text>,
}

/// Names for a viewer of SVG files.
const FAMILIES: &str = "Roboto, Helvetica, Arial, Liberation Sans, sans-serif";

/// Plotters rounds positions to whole units; a pixel has so many of them, along and down. The PNG file is the
/// average of its units.
const UNITS: u32 = 3;

impl Canvas {
    /// An empty one, so many pixels wide and high.
    pub fn new(size: [u32; 2]) -> Result<Self, Error> {
        Ok(Self {
            size,
            fonts: Fonts::new()?,
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
        self.fonts.width(words, size)
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
            self.fonts.set(text, &mut picture);
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
}

/// A position in units.
fn whole(at: Point) -> (i32, i32) {
    let [x, y] = at.map(|side| (side * f64::from(UNITS)).round() as i32);
    (x, y)
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
        match gaunt::image::ending(path).as_deref() {
            Some("svg") => Ok(Self::Svg),
            Some("png") => Ok(Self::Png),
            _ => Err(Error::Usage(format!(
                "cannot write a chart to {}: its name must end in .svg or .png",
                path.display()
            ))),
        }
    }
}
