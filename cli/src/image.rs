//! From radiance to files: exposure, tone curve, encoding.
//!
//! The passes end with linear radiance. For a screen it is scaled by an exposure that follows from the light
//! alone (so that two pictures under one light can be compared), bent towards white where it is too bright,
//! and encoded as sRGB. EXR files keep the radiance as it is.

use crate::Error;
use glam::Vec3;
use image::{ExtendedColorType, ImageEncoder, ImageFormat, Rgb32FImage};
use sh_scene::{Light, LightViews, Object, Scene};
use std::io::BufWriter;
use std::path::{Path, PathBuf};

/// A picture of linear Rec.709 radiance.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// `width * height` pixels, row by row from the top.
    pub pixels: Vec<[f32; 3]>,
}

/// What a white surface under the average light becomes on a screen, in linear terms before the tone curve.
const MIDDLE: f64 = 0.45;

/// Where the tone curve leaves the straight line, in linear terms.
const SHOULDER: f32 = 0.6;

/// How fast what is brighter than white loses its colour.
const BLEACH: f32 = 0.15;

/// The factor that brings the luminance of a white diffuse surface, in the light of a scene without shadows and averaged over all
/// directions it may face, to 0.45: 0.70 of an sRGB screen's range. 1 where there is no light.
///
/// Of the environment that average is the mean radiance: all bands but the first average to 0, and a cosine lobe over π
/// integrates to 1. Spots, points and suns are taken in the middle of each body, and averaged over these: a sun counts as what it would
/// in the environment.
///
/// ```
/// use sh_scene::{Camera, EnvironmentMap, Scene, Settings};
/// # let camera = Camera { eye: glam::Vec3::Z, target: glam::Vec3::ZERO, fov: 1.0 };
/// # let (objects, lights, punctual, ground, settings) = (vec![], vec![], vec![], None, Settings::default());
/// let environment = EnvironmentMap::constant([2.0; 3]);
/// let scene = Scene { environment, objects, lights, punctual, ground, camera, settings };
/// let exposure = gaunt::image::exposure(&scene.light()?, &scene);
/// assert!((exposure - 0.225).abs() < 1e-6);
/// # Ok::<(), sh_scene::LightError>(())
/// ```
pub fn exposure(light: &Light, scene: &Scene) -> f32 {
    let luminance = |[r, g, b]: [f64; 3]| 0.2126 * r + 0.7152 * g + 0.0722 * b;
    let first = light.coefficients.first();
    let first = first.map_or([0.0; 3], |c| c.map(f64::from));
    let mean = luminance(first) / (4.0 * std::f64::consts::PI).sqrt() + sharp(scene, luminance);
    if mean > 0.0 {
        (MIDDLE / mean) as f32
    } else {
        1.0
    }
}

/// The part of spots, points and suns: none of those that are no lights.
fn sharp(scene: &Scene, luminance: impl Fn([f64; 3]) -> f64) -> f64 {
    let lights = LightViews::of(scene).unwrap_or_default().lights;
    let bounds = scene.objects.iter().filter_map(Object::bounds);
    let mut places: Vec<Vec3> = bounds.map(|[low, high]| 0.5 * (low + high)).collect();
    if places.is_empty() {
        places.push(scene.camera.target);
    }
    let mut sum = 0.0;
    for (place, light) in places
        .iter()
        .flat_map(|place| lights.iter().map(move |l| (place, l)))
    {
        // A quarter is the mean of the cosine over all normals.
        sum +=
            0.25 * f64::from(light.seen(*place).share) * luminance(light.radiance.map(f64::from));
    }
    sum / places.len() as f64
}

/// The tone curve, 0..∞ to 0..1: straight up to 0.6, then a hyperbola to 1 without a kink. It acts on the
/// largest channel and scales the others with it, so that hues stay; what is far beyond white bleaches.
/// This is the shape of the Khronos PBR Neutral tone mapper (2024), without its offset for reflections.
///
/// ```
/// use gaunt::image::tone;
/// assert_eq!(tone([0.1, 0.3, 0.6]), [0.1, 0.3, 0.6]);
/// assert!(tone([8.0, 4.0, 1.0]).iter().all(|c| *c < 1.0));
/// ```
pub fn tone(color: [f32; 3]) -> [f32; 3] {
    // What is not a number fails the comparison and becomes black.
    let color = color.map(|c| if c > 0.0 { c.min(f32::MAX) } else { 0.0 });
    let peak = color[0].max(color[1]).max(color[2]);
    if peak <= SHOULDER {
        return color;
    }
    let room = 1.0 - SHOULDER;
    let bent = 1.0 - room * room / (peak + room - SHOULDER);
    let pale = 1.0 - 1.0 / (BLEACH * (peak - bent) + 1.0);
    color.map(|c| {
        let scaled = c / peak * bent;
        scaled + (bent - scaled) * pale
    })
}

/// The sRGB encoding (IEC 61966-2-1) of a linear value in 0..1, in 0..=255.
fn srgb(linear: f32) -> f32 {
    let encoded = if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * linear.powf(1.0 / 2.4) - 0.055
    };
    encoded * 255.0
}

/// A pixel as a screen shows it: exposed, toned, encoded, and dithered to 8 bits.
///
/// Soft shadows on a wide plane change by less than one of 256 steps over many pixels, and the eye sees
/// every such step as a contour. So each value is rounded up as often as its fraction says, in the pattern of
/// interleaved gradient noise (Jimenez 2014). Pure black and white stay what they are.
///
/// ```
/// use gaunt::image::screen;
/// assert_eq!(screen([0.0, 0.0, 0.0], 3, 4), [0, 0, 0]);
/// // 0.5 encodes to 187.5.
/// let gray = |x| screen([0.5; 3], x, 0)[0];
/// assert!((0..100).all(|x| gray(x) == 187 || gray(x) == 188));
/// ```
pub fn screen(color: [f32; 3], x: u32, y: u32) -> [u8; 3] {
    let along = 0.067_110_56 * f64::from(x) + 0.005_837_15 * f64::from(y);
    let threshold = (52.982_918_9 * along.fract()).fract() as f32;
    // Casting cuts the fraction off, and what is above 255.
    tone(color).map(|c| (srgb(c) + threshold) as u8)
}

/// The kinds of files that pictures are written to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// 8 bits, for a screen.
    Png,
    /// 32-bit floats, linear.
    Exr,
}

/// The ending of a file's name, in small letters.
pub fn ending(path: &Path) -> Option<String> {
    let ending = path.extension()?;
    Some(ending.to_string_lossy().to_ascii_lowercase())
}

impl Kind {
    fn of(path: &Path) -> Result<Self, Error> {
        match ending(path).as_deref() {
            Some("png") => Ok(Self::Png),
            Some("exr") => Ok(Self::Exr),
            _ => Err(Error::Usage(format!(
                "cannot write a picture to {}: its name must end in .png or .exr",
                path.display()
            ))),
        }
    }
}

/// A file that appears whole or not at all: it is written under another name in the same folder and renamed
/// at the end.
#[derive(Debug)]
pub struct Output {
    path: PathBuf,
    partial: PathBuf,
    file: Option<std::fs::File>,
}

impl Output {
    /// Makes sure, before the work, that the file can be written after it.
    pub fn create(path: &Path) -> Result<Self, Error> {
        let Some(name) = path.file_name().filter(|_| !path.is_dir()) else {
            let path = path.display();
            return Err(Error::Usage(format!(
                "cannot write to {path}: it is a folder"
            )));
        };
        let name = format!(".{}.{}.partial", name.to_string_lossy(), std::process::id());
        let partial = path.with_file_name(name);
        let file = std::fs::File::create(&partial)
            .map_err(|source| Error::file("write to", path.display(), source))?;
        Ok(Self {
            path: path.into(),
            partial,
            file: Some(file),
        })
    }

    /// Writes the file with `write` and puts it in its place.
    pub fn finish(
        mut self,
        write: impl FnOnce(&mut BufWriter<std::fs::File>) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let Some(file) = self.file.take() else {
            return Ok(());
        };
        let failed = |source| Error::file("write to", self.path.display(), source);
        let mut writer = BufWriter::new(file);
        write(&mut writer)?;
        writer
            .into_inner()
            .map_err(|error| failed(error.into_error()))?
            .sync_all()
            .map_err(failed)?;
        std::fs::rename(&self.partial, &self.path).map_err(failed)
    }
}

/// Where the file was not finished, nothing of it remains.
impl Drop for Output {
    fn drop(&mut self) {
        // Gone already after `finish`; otherwise nobody is left to tell of a failure.
        let _ = std::fs::remove_file(&self.partial);
    }
}

/// A picture's file, opened before the picture is there.
#[derive(Debug)]
pub struct PictureFile {
    output: Output,
    kind: Kind,
}

impl PictureFile {
    /// A file for a picture, PNG or EXR by its ending.
    pub fn create(path: &Path) -> Result<Self, Error> {
        let kind = Kind::of(path)?;
        Ok(Self {
            output: Output::create(path)?,
            kind,
        })
    }

    /// Writes the picture. `exposure` counts for PNG alone.
    pub fn finish(self, picture: Picture, exposure: f32) -> Result<(), Error> {
        let (width, height) = (picture.width, picture.height);
        let path = self.output.path.display().to_string();
        let failed = |source| Error::Encode { path, source };
        self.output.finish(|writer| match self.kind {
            Kind::Png => {
                let rows = picture.pixels.chunks(width as usize).zip(0..);
                let bytes: Vec<u8> = rows
                    .flat_map(|(row, y)| row.iter().zip(0..).map(move |(pixel, x)| (pixel, x, y)))
                    .flat_map(|(pixel, x, y)| screen(pixel.map(|c| c * exposure), x, y))
                    .collect();
                image::codecs::png::PngEncoder::new(writer)
                    .write_image(&bytes, width, height, ExtendedColorType::Rgb8)
                    .map_err(failed)
            }
            Kind::Exr => {
                let samples = picture.pixels.into_flattened();
                let count = samples.len();
                let image = Rgb32FImage::from_raw(width, height, samples).ok_or_else(|| {
                    Error::Usage(format!(
                        "{count} numbers do not make {width} by {height} pixels"
                    ))
                })?;
                image.write_to(writer, ImageFormat::OpenExr).map_err(failed)
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A sun counts in the exposure as much as it did in the sky that it was lifted from, and a point by where it stands.
    #[test]
    fn a_lifted_sun_keeps_the_exposure() {
        let sky = sh_scene::Sky::default().map(256, 128);
        let lifted = sky.lift_sun().expect("a sun");
        let scene = |environment, punctual| Scene {
            objects: Vec::new(),
            environment,
            lights: Vec::new(),
            punctual,
            ground: None,
            camera: sh_scene::Camera {
                eye: Vec3::Z,
                target: Vec3::ZERO,
                fov: 1.0,
            },
            settings: Default::default(),
        };
        let of = |scene: &Scene| exposure(&scene.light().expect("light"), scene);
        let whole = of(&scene(sky, Vec::new()));
        let without = of(&scene(lifted.map.clone(), Vec::new()));
        let parts = of(&scene(lifted.map, vec![lifted.sun]));
        assert!((parts / whole - 1.0).abs() < 0.01, "{parts} of {whole}");
        assert!(without > 1.2 * whole, "{without} of {whole}");
        let point = |height: f32| {
            let position = Vec3::Y * height;
            let shape = sh_scene::PunctualShape::Point {
                position,
                radius: 0.0,
            };
            let light = sh_scene::PunctualLight::new(shape, [1.0; 3]);
            of(&scene(
                sh_scene::EnvironmentMap::constant([0.0; 3]),
                vec![light],
            ))
        };
        assert!((point(2.0) / point(1.0) - 4.0).abs() < 1e-3);
    }

    #[test]
    fn the_tone_curve_rises_without_a_kink() {
        let mut before = 0.0;
        let mut slope_before = 1.0;
        for i in 1..4000 {
            let x = i as f32 / 1000.0;
            let y = tone([x; 3])[0];
            let slope = (y - before) * 1000.0;
            assert!(y > before && y < 1.0, "{x}: {before} {y}");
            assert!(
                (slope - slope_before).abs() < 0.02,
                "{x}: {slope_before} {slope}"
            );
            (before, slope_before) = (y, slope);
        }
    }

    #[test]
    fn the_tone_curve_keeps_order_and_survives_anything() {
        for color in [
            [f32::NAN; 3],
            [f32::INFINITY; 3],
            [-1.0, 0.5, 2.0],
            [1e30, 1.0, 0.0],
        ] {
            let [r, g, b] = tone(color);
            assert!(
                [r, g, b].iter().all(|c| (0.0..=1.0).contains(c)),
                "{color:?}: {r} {g} {b}"
            );
        }
        let [r, g, b] = tone([3.0, 2.0, 1.0]);
        assert!(r > g && g > b);
    }

    #[test]
    fn srgb_meets_its_fixed_points() {
        for (linear, encoded) in [
            (0.0, 0.0),
            (1.0, 255.0),
            (0.214_041_14, 127.5),
            (0.001, 3.2946),
        ] {
            assert!(
                (srgb(linear) - encoded).abs() < 1e-3,
                "{linear}: {}",
                srgb(linear)
            );
        }
    }

    #[test]
    fn dither_keeps_the_mean_of_every_shade() {
        for i in 0..60 {
            let shade = i as f32 / 100.0;
            let values = (0..64 * 64).map(|at| screen([shade; 3], at % 64, at / 64)[0]);
            let mean = values.map(f64::from).sum::<f64>() / (64.0 * 64.0);
            assert!(
                (mean - f64::from(srgb(shade))).abs() < 0.05,
                "{shade}: {mean}"
            );
        }
        assert_eq!(screen([1e9; 3], 5, 7), [255; 3]);
    }

    #[test]
    fn an_unfinished_file_leaves_nothing() {
        let folder = std::env::temp_dir().join(format!("gaunt-output-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let path = folder.join("picture.png");
        drop(Output::create(&path).unwrap());
        let failed = Output::create(&path)
            .unwrap()
            .finish(|_| Err(Error::Usage("no".into())));
        assert!(failed.is_err());
        assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 0);
        Output::create(&path).unwrap().finish(|_| Ok(())).unwrap();
        assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 1);
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
