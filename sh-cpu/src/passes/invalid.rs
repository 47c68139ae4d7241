//! The invalid pass: how many of a pixel's samples have radiance that is no number, infinite or below 0.

use super::gbuffer::Gbuffer;
use crate::device::check::{check_length, check_view};
use crate::error::Error;
use rayon::prelude::*;
use sh_scene::{Tiles, View};
use std::ops::Range;

/// Counts the invalid samples of the pixel rows under the rows of tiles `rows` of `view`'s samples into `counts`, as many
/// rows as there are in them: no number, infinite, negative in a channel, and all that met a surface.
///
/// `samples` and `radiance` hold these tiles.
pub fn invalid(
    view: &View,
    rows: Range<u32>,
    samples: &Gbuffer,
    radiance: &[[f32; 3]],
    counts: &mut [[u32; 4]],
) -> Result<(), Error> {
    check_view(view)?;
    let width = view.width as usize;
    let tiles = Tiles {
        rows: rows.len() as u32,
        ..view.samples().tiles()
    };
    check_length("samples.receivers", tiles.len(), samples.receivers.len())?;
    check_length("radiance", tiles.len(), radiance.len())?;
    let all = counts.par_chunks_mut(width).enumerate();
    all.for_each(|(row, counts)| {
        for (count, column) in counts.iter_mut().zip(0..) {
            *count = [0; 4];
            for sub in 0..View::OVERSAMPLE * View::OVERSAMPLE {
                let x = column * View::OVERSAMPLE + sub % View::OVERSAMPLE;
                let y = row as u32 * View::OVERSAMPLE + sub / View::OVERSAMPLE;
                let at = tiles.index(x, y);
                if samples.receivers[at].covered != 0 {
                    count[3] += 1;
                    if let Some(what) = what(radiance[at]) {
                        count[what] += 1;
                    }
                }
            }
        }
    });
    Ok(())
}

/// Which count a radiance goes to; none for one that is as it should be.
#[inline]
fn what(radiance: [f32; 3]) -> Option<usize> {
    // Nearly all of them, at the cost of a few comparisons.
    if radiance.iter().all(|x| (0.0..=f32::MAX).contains(x)) {
        return None;
    }
    let worst = radiance.iter().map(|x| match x {
        x if x.is_nan() => 0,
        x if x.is_infinite() => 1,
        _ => 2,
    });
    // What is neither is finite and may be as it should be: another channel is not.
    worst.min()
}
