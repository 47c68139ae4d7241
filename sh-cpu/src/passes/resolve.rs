//! The resolve pass: samples to pixels.

use super::gbuffer::Gbuffer;
use crate::device::check::{check_environment, check_length, check_view};
use crate::device::rays::Rays;
use crate::error::Error;
use glam::Vec3A;
use rayon::prelude::*;
use sh_core::constants::{FACING, NEAREST};
use sh_core::gloss::Reflectance;
use sh_scene::{EnvironmentMap, Tiles, View};
use std::ops::Range;

/// The light of some tiles of samples.
#[derive(Clone, Copy, Debug)]
pub struct SampleLight<'a> {
    /// What albedo 1 reflects.
    pub radiance: &'a [[f32; 3]],
    /// The mean of what samples that mirror light see in their lobe; none where none does.
    pub mirrored: Option<&'a [[f32; 3]]>,
}

/// Resolves the pixel rows under the rows of tiles `rows` of `view`'s samples into `pixels` (linear Rec.709, as many
/// rows as there are in them).
///
/// `samples` and what is `lit` hold these tiles. A sample
/// is albedo times radiance where it is covered, what it mirrors added as [`Reflectance`] has it, and the environment along its ray
/// elsewhere; a pixel is the mean of its samples (a box filter).
pub fn resolve(
    view: &View,
    rows: Range<u32>,
    samples: &Gbuffer,
    lit: SampleLight,
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
    check_length("radiance", tiles.len(), lit.radiance.len())?;
    if let Some(mirrored) = lit.mirrored {
        check_length("mirrored", tiles.len(), mirrored.len())?;
    }
    check_length("pixels", count, pixels.len())?;
    let eye = Vec3A::from(view.camera.eye);
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
                        shown(samples, lit, at, eye)
                    } else {
                        environment.sample(rays.through(x, first + y).into()).into()
                    };
                }
                *pixel = (sum * share).into();
            }
        });
    Ok(())
}

/// What a covered sample sends to the eye.
fn shown(samples: &Gbuffer, lit: SampleLight, at: usize, eye: Vec3A) -> Vec3A {
    let ([red, green, blue, metallic], receiver) = (samples.albedo[at], &samples.receivers[at]);
    let radiance = Vec3A::from(lit.radiance[at]);
    let (Some(mirrored), Some(roughness)) = (lit.mirrored, receiver.roughness()) else {
        return Vec3A::new(red, green, blue) * radiance;
    };
    let away = eye - Vec3A::from(receiver.position);
    let inverse = 1.0 / away.length().max(NEAREST as f32);
    let facing = (away * inverse).dot(receiver.normal.into());
    let facing = facing.max(FACING as f32).min(1.0);
    let parts = Reflectance::new([red, green, blue], metallic, roughness, facing);
    Vec3A::from(parts.diffuse) * radiance + Vec3A::from(parts.mirrored) * Vec3A::from(mirrored[at])
}
