//! What weights of functions are found with, and what they tell.

use super::parts::BasisParts;
use sh_core::constants::{FEWER, PATCH_SAMPLES};

/// What patches are told of: of each function, patch by patch, times the weights; nowhere below 0.
pub(super) fn told(rows: &[[f32; 3]], weights: &[[f32; 3]]) -> Vec<[f32; 3]> {
    let row = |row: &[[f32; 3]]| {
        let mut sum = [0.0; 3];
        for (own, weight) in row.iter().zip(weights) {
            for ((sum, own), weight) in sum.iter_mut().zip(own).zip(weight) {
                *sum += own * weight;
            }
        }
        sum.map(|x: f32| x.max(0.0))
    };
    rows.chunks_exact(weights.len().max(1)).map(row).collect()
}

/// How many of a body's points tell so many functions of the light that bodies have sent: a part of them, if that leaves four a
/// function.
pub(super) fn few(patches: usize, count: usize) -> usize {
    let few = patches / FEWER;
    if few >= 4 * count { few } else { patches }
}

/// All patches: of every few the first, then all others.
pub(super) fn order(patches: usize, few: usize) -> Vec<usize> {
    if few == patches {
        return (0..patches).collect();
    }
    let first = |patch: &usize| patch.is_multiple_of(FEWER);
    let (mut order, rest): (Vec<usize>, Vec<usize>) = (0..patches).partition(first);
    order.extend(rest);
    order
}

/// What each patch sends on of each function, in the mean of its samples.
pub(super) fn sends(parts: &BasisParts, count: usize) -> Vec<[f32; 3]> {
    let all = parts.samples.len();
    let mean = |patch: usize, i: usize| {
        let mut sum = [0.0; 3];
        for at in patch * PATCH_SAMPLES..(patch + 1) * PATCH_SAMPLES {
            let value = parts.values[i * all + at];
            for (sum, albedo) in sum.iter_mut().zip(parts.samples[at].albedo) {
                // What is no number is not above 0.
                let albedo = if albedo > 0.0 { albedo.min(1.0) } else { 0.0 };
                *sum += value * albedo / PATCH_SAMPLES as f32;
            }
        }
        sum
    };
    let patches = 0..all / PATCH_SAMPLES;
    patches
        .flat_map(|patch| (0..count).map(move |i| (patch, i)))
        .map(|(patch, i)| mean(patch, i))
        .collect()
}

/// The weights of irradiance at so many points, by what they are found with.
pub(super) fn found(dual: &[f32], points: usize, irradiance: &[[f32; 3]]) -> Vec<[f32; 3]> {
    let weight = |dual: &[f32]| {
        let mut sum = [0.0; 3];
        for (value, light) in dual.iter().zip(irradiance) {
            for (sum, light) in sum.iter_mut().zip(light) {
                *sum += value * light;
            }
        }
        sum
    };
    dual.chunks_exact(points).map(weight).collect()
}

/// How dear weights are, over what they tell: what points tell apart loses a thousandth by it, what they do not stays small.
const STIFF: f64 = 1e-3;

/// What weights are found with, of functions at all samples: (ΨᵀΨ)⁻¹ Ψᵀ at the points of these patches. Where points do not tell
/// two functions apart, neither gets more than its share.
pub(super) fn dual(values: &[f32], count: usize, patches: &[usize]) -> Option<Vec<f32>> {
    let samples = values.len() / count;
    let at = |i: usize, point: usize| {
        let sample = patches[point] * PATCH_SAMPLES;
        f64::from(values[i * samples + sample])
    };
    let points = patches.len();
    let dot = |i: usize, j: usize| (0..points).map(|p| at(i, p) * at(j, p)).sum::<f64>();
    let mut square: Vec<Vec<f64>> = (0..count)
        .map(|i| (0..count).map(|j| dot(i, j)).collect())
        .collect();
    // The constant is always told apart: even light is its weight alone, to the last bit.
    for (i, row) in square.iter_mut().enumerate().skip(1) {
        row[i] += STIFF * points as f64;
    }
    let mut sides: Vec<Vec<f64>> = (0..count)
        .map(|i| (0..points).map(|p| at(i, p)).collect())
        .collect();
    // Gauss without pivots: the matrix is symmetric, and positive by what was added.
    for i in 0..count {
        let pivot = square[i][i];
        if pivot.is_nan() || pivot <= 0.0 {
            return None;
        }
        let (row, side) = (square[i].clone(), sides[i].clone());
        for j in (0..count).filter(|j| *j != i) {
            let factor = square[j][i] / pivot;
            for (x, own) in square[j].iter_mut().zip(&row) {
                *x -= factor * own;
            }
            for (x, own) in sides[j].iter_mut().zip(&side) {
                *x -= factor * own;
            }
        }
    }
    let solved = sides.iter().zip(square.iter().enumerate());
    let rows = solved.flat_map(|(side, (i, row))| side.iter().map(move |x| (x / row[i]) as f32));
    Some(rows.collect())
}
