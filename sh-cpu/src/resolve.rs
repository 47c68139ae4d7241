//! The resolve pass: samples to pixels.

use crate::Error;
use crate::gbuffer::{Gbuffer, Rays, check_view};
use glam::Vec3A;
use rayon::prelude::*;
use sh_scene::{EnvironmentMap, View};
use std::ops::Range;

/// Resolves the pixel rows `rows` of `view` into `pixels` (`view.width * rows.len()`, linear Rec.709).
///
/// `samples` and `radiance` hold the sample rows under them, `View::OVERSAMPLE` for each pixel row. A sample
/// is albedo times radiance where it is covered, and the environment along its ray elsewhere; a pixel is the
/// mean of its samples (a box filter).
pub fn resolve(
    view: &View,
    rows: Range<u32>,
    samples: &Gbuffer,
    radiance: &[[f32; 3]],
    environment: &EnvironmentMap,
    pixels: &mut [[f32; 3]],
) -> Result<(), Error> {
    check_view(view)?;
    check_environment(environment)?;
    let width = view.width as usize;
    let oversample = View::OVERSAMPLE as usize;
    let count = width * rows.len();
    check_length(
        "samples.receivers",
        count * oversample * oversample,
        samples.receivers.len(),
    )?;
    check_length(
        "samples.albedo",
        count * oversample * oversample,
        samples.albedo.len(),
    )?;
    check_length("radiance", count * oversample * oversample, radiance.len())?;
    check_length("pixels", count, pixels.len())?;
    let rays = Rays::new(view);
    let columns = width * oversample;
    let share = 1.0 / (oversample * oversample) as f32;
    let first = rows.start;
    pixels
        .par_chunks_mut(width)
        .zip(rows)
        .for_each(|(pixels, row)| {
            for (x, pixel) in pixels.iter_mut().enumerate() {
                let mut sum = Vec3A::ZERO;
                for sub in 0..oversample * oversample {
                    let column = x * oversample + sub % oversample;
                    let line = sub / oversample;
                    let at = ((row - first) as usize * oversample + line) * columns + column;
                    sum += if samples.receivers[at].covered != 0 {
                        Vec3A::from(samples.albedo[at]) * Vec3A::from(radiance[at])
                    } else {
                        let y = row * View::OVERSAMPLE + line as u32;
                        environment
                            .sample(rays.through(column as u32, y).into())
                            .into()
                    };
                }
                *pixel = (sum * share).into();
            }
        });
    Ok(())
}

/// Whether a map has as many pixels as it says, and any.
pub(crate) fn check_environment(map: &EnvironmentMap) -> Result<(), Error> {
    let texels = map.width as usize * map.height as usize;
    if texels == 0 || texels != map.pixels.len() {
        return Err(Error::Environment {
            width: map.width,
            height: map.height,
            found: map.pixels.len(),
        });
    }
    Ok(())
}

/// Whether a buffer has one entry a sample.
pub(crate) fn check_length(
    buffer: &'static str,
    expected: usize,
    found: usize,
) -> Result<(), Error> {
    if expected == found {
        Ok(())
    } else {
        Err(Error::Length {
            buffer,
            expected,
            found,
        })
    }
}
