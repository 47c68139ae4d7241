//! The `punctual` pass: light of spots, points and suns, added to that of receivers.

use crate::device::check::check_length;
use crate::device::gloss::Gloss;
use crate::device::light_views::Views;
use crate::error::Error;
use glam::Vec3;
use rayon::prelude::*;
use sh_scene::punctual::above;
use sh_scene::{Receiver, Tiles};

/// Adds what albedo 1 reflects of all lights, or, seen from `eye`, what is mirrored of them.
///
/// # Errors
/// Where there is not a radiance for every receiver.
pub(crate) fn punctual(
    receivers: &[Receiver],
    views: &Views,
    eye: Option<[f32; 3]>,
    radiance: &mut [[f32; 3]],
) -> Result<(), Error> {
    check_length("radiance", receivers.len(), radiance.len())?;
    let chunks = receivers.par_chunks(Tiles::AREA);
    let lit = chunks.zip(radiance.par_chunks_mut(Tiles::AREA));
    lit.for_each(|(receivers, radiance)| {
        for (index, (receiver, radiance)) in receivers.iter().zip(radiance).enumerate() {
            if receiver.covered == 0 {
                continue;
            }
            let given = given(receiver, views, eye, turn(index));
            for (radiance, given) in radiance.iter_mut().zip(given) {
                *radiance += given;
            }
        }
    });
    Ok(())
}

/// A sample's own turn among the four of its pixel.
fn turn(index: usize) -> u32 {
    let side = Tiles::SIDE as usize;
    (index % side % 2 + index / side % 2 * 2) as u32
}

fn given(receiver: &Receiver, views: &Views, eye: Option<[f32; 3]>, turn: u32) -> [f32; 3] {
    let (place, normal) = (Vec3::from(receiver.position), Vec3::from(receiver.normal));
    let gloss = match (eye, receiver.roughness()) {
        (None, _) => None,
        (Some(_), None) => return [0.0; 3],
        (Some(eye), Some(roughness)) => Some(Gloss::new::<4>(
            receiver.position,
            receiver.normal,
            eye,
            roughness,
        )),
    };
    let mut sum = [0.0; 3];
    for light in &views.seen.lights {
        let seen = light.seen(place);
        let cosine = seen.direction.dot(normal);
        let mut share = seen.share * above(cosine, seen.sine);
        // What is no number is dark.
        if share.is_nan() || share <= 0.0 {
            continue;
        }
        if let Some(gloss) = &gloss {
            let along = seen.direction.dot(gloss.view.into());
            share *= gloss.mirrors(cosine, along, 0.25 * seen.sine * seen.sine);
        }
        share *= views.visible(light, place, normal, turn);
        for (sum, radiance) in sum.iter_mut().zip(light.radiance) {
            *sum += share * radiance;
        }
    }
    sum
}
