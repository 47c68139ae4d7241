//! The functions of a body.

use super::samples::{Spread, needed, spread};
use super::singular::{dot, singular};
use super::training::{RAYS, Training, training};
use crate::rays::Rays;
use glam::Vec3;
use sh_scene::basis::{BasisParts, Disc, Facet, PATCH_SAMPLES, Patch};
use sh_scene::{BasisSample, IrradianceBasis, Material, Mesh};

/// Finds at most `most` functions (at least one) in which the irradiance of a body is written that is made of these parts, and
/// what its patches are; none for a body without a triangle of any extent. Takes a second or two on two cores. The same
/// input gives the same functions, whatever the number of threads. Telling `progress` the part that is done, 0 to 1, from
/// several threads.
///
/// ```
/// use sh_bake::{irradiance_basis, shapes};
/// use sh_scene::Material;
/// let (knot, white) = (shapes::torus_knot(2, 3, 1.0, 0.4, 0.25), Material::diffuse([1.0; 3]));
/// let basis = irradiance_basis(&[(&knot, &white)], 16, &|_| {}).unwrap();
/// // Of all lights that it was taught by, 16 functions tell most.
/// assert!(basis.held(16) > 0.8);
/// // Light that falls evenly is the first function alone.
/// let even = vec![[0.5, 1.0, 2.0]; basis.points().len()];
/// assert!((basis.weights(&even)[0][2] - 2.0).abs() < 1e-4);
/// ```
///
/// # Panics
/// Where singular values are wrong: what they are taken from is put together again each time, to see.
pub fn irradiance_basis(
    parts: &[(&Mesh, &Material)],
    most: usize,
    progress: &(dyn Fn(f32) + Sync),
) -> Option<IrradianceBasis> {
    let rays = Rays::of(parts)?;
    let Spread {
        samples,
        parts: discs,
        patches,
    } = spread(parts, needed(parts, &rays));
    if samples.is_empty() {
        return None;
    }
    let done = std::sync::atomic::AtomicUsize::new(0);
    let tell = || {
        let done = 1 + done.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
        progress(0.8 * done as f32 / samples.len() as f32);
    };
    let Training {
        columns,
        met,
        escape,
        lobes,
    } = training(&samples, &rays, &tell);
    let most = most.clamp(1, IrradianceBasis::MOST);
    let (functions, held) = functions(&columns, samples.len(), most);
    let own = own(&functions, &samples, &met);
    progress(1.0);
    let area = (rays.area() / samples.len() as f64) as f32;
    let disc = |(center, facing): &(Vec3, Vec3), area: f32| Disc::new(*center, *facing * area);
    let patches = patches.iter().zip(discs.as_chunks().0).zip(&escape);
    let patch = |((whole, discs), escape): ((_, &[_; PATCH_SAMPLES]), _)| {
        let whole = disc(whole, area * PATCH_SAMPLES as f32);
        Patch {
            whole: Facet::new(whole, escape),
            discs: discs.each_ref().map(|d| disc(d, area)),
        }
    };
    IrradianceBasis::new(BasisParts {
        area,
        patches: patches.map(patch).collect(),
        values: functions.iter().flatten().map(|x| *x as f32).collect(),
        samples,
        lobes,
        own,
        held,
    })
}

/// The functions, and how much of the columns so many of them tell.
fn functions(columns: &[Vec<f64>], samples: usize, most: usize) -> (Vec<Vec<f64>>, Vec<f32>) {
    let count = samples as f64;
    let mean = |column: &Vec<f64>| column.iter().sum::<f64>() / count;
    let all: f64 = columns.iter().map(|c| dot(c, c)).sum();
    let even: f64 = columns.iter().map(|c| mean(c).powi(2) * count).sum();
    let rest = |column: &Vec<f64>| {
        let mean = mean(column);
        column.iter().map(|x| x - mean).collect()
    };
    let rest: Vec<Vec<f64>> = columns.iter().map(rest).collect();
    let found = singular(rest.clone());
    let error = found.error(&rest);
    assert!(error < 1e-9, "singular values are off by {error}");
    let share = |told: f64| if all > 0.0 { (told / all) as f32 } else { 1.0 };
    let (mut functions, mut held) = (vec![vec![1.0; samples]], vec![share(even)]);
    let mut told = even;
    // What is left of rounding tells nothing.
    let least = found.values.first().map_or(0.0, |most| most * 1e-9);
    for (value, left) in found.values.iter().zip(&found.left).take(most - 1) {
        if *value <= least || *value * value <= all * 1e-16 {
            break;
        }
        told += value * value;
        functions.push(left.iter().map(|x| x * count.sqrt()).collect());
        held.push(share(told));
    }
    (functions, held)
}

/// What the body gives each patch of each function, patch by patch; nothing where no ray from any meets it.
fn own(functions: &[Vec<f64>], samples: &[BasisSample], met: &[Vec<u32>]) -> Vec<[f32; 3]> {
    if met.iter().all(Vec::is_empty) {
        return Vec::new();
    }
    let on = |patch: &[Vec<u32>], function: &Vec<f64>| {
        let mut sum = [0.0; 3];
        for &at in patch.iter().flatten() {
            let (albedo, value) = (samples[at as usize].albedo, function[at as usize]);
            for (sum, albedo) in sum.iter_mut().zip(albedo) {
                *sum += f64::from(albedo) * value;
            }
        }
        sum.map(|sum| (sum / (RAYS * patch.len()) as f64) as f32)
    };
    let patches = met.chunks(PATCH_SAMPLES);
    let rows = patches.flat_map(|patch| functions.iter().map(move |function| on(patch, function)));
    rows.collect()
}
