//! The resolve pass: samples to pixels.

use super::gbuffer::Gbuffer;
use crate::device::check::{check_environment, check_length, check_view};
use crate::device::rays::Rays;
use crate::error::Error;
use glam::Vec3A;
use rayon::prelude::*;
use sh_scene::{EnvironmentMap, Tiles, View};
use std::ops::Range;

/// Resolves the pixel rows under the rows of tiles `rows` of `view`'s samples into `pixels` (linear Rec.709, as many
/// rows as there are in them).
///
/// `samples` and `radiance` hold these tiles. A sample
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
    let oversample = View::OVERSAMPLE;
    let tiles = Tiles {
        rows: rows.len() as u32,
        ..view.samples().tiles()
    };
    let first = rows.start * Tiles::SIDE;
    let last = (rows.end * Tiles::SIDE).min(view.samples().rows);
    let count = width * (last.saturating_sub(first) / oversample) as usize;
    check_length("samples.receivers", tiles.len(), samples.receivers.len())?;
    check_length("samples.albedo", tiles.len(), samples.albedo.len())?;
    check_length("radiance", tiles.len(), radiance.len())?;
    check_length("pixels", count, pixels.len())?;
    let rays = Rays::new(view, view.samples());
    let share = 1.0 / (oversample * oversample) as f32;
    pixels
        .par_chunks_mut(width)
        .enumerate()
        .for_each(|(row, pixels)| {
            for (column, pixel) in pixels.iter_mut().enumerate() {
                let mut sum = Vec3A::ZERO;
                for sub in 0..oversample * oversample {
                    let x = column as u32 * oversample + sub % oversample;
                    let y = row as u32 * oversample + sub / oversample;
                    let at = tiles.index(x, y);
                    sum += if samples.receivers[at].covered != 0 {
                        Vec3A::from(samples.albedo[at]) * Vec3A::from(radiance[at])
                    } else {
                        environment.sample(rays.through(x, first + y).into()).into()
                    };
                }
                *pixel = (sum * share).into();
            }
        });
    Ok(())
}
