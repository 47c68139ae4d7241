//! The `light_view` pass: how near what is seen from lights with sharp shadows is. By rays, through the middles of texels, as a GPU draws.

use crate::device::geometry::Geometry;
use crate::device::light_views::Views;
use glam::{Vec3, Vec3A};
use rayon::prelude::*;
use sh_core::constants::{NOWHERE, VIEW_BLOCK};

/// Looks from all lights.
pub(crate) fn light_view(geometry: &Geometry, views: &mut Views) {
    let side = views.seen.side;
    views.nearest.clear();
    views
        .nearest
        .resize(views.seen.views.len() * side * side, NOWHERE);
    let scale = 2.0 / side as f32;
    let all = &views.seen.views;
    let rows = views.nearest.par_chunks_mut(side).enumerate();
    rows.for_each(|(row, nearest)| {
        let view = &all[row / side];
        let up = 1.0 - ((row % side) as f32 + 0.5) * scale;
        for (column, nearest) in nearest.iter_mut().enumerate() {
            let across = (column as f32 + 0.5) * scale - 1.0;
            let [origin, direction] = view.ray([across, up]).map(Vec3A::from);
            let unit = direction.normalize();
            *nearest = match geometry.cast(origin, unit) {
                None => NOWHERE,
                Some(hit) => view
                    .place(Vec3::from(hit.position))
                    .map_or(NOWHERE, |[_, _, nearness]| nearness),
            };
        }
    });
    let (block, count) = (VIEW_BLOCK as usize, views.seen.views.len());
    views.coarse.clear();
    coarsen(&views.nearest, side, count, block, &mut views.coarse);
    let once = views.coarse.clone();
    coarsen(&once, side / block, count, block, &mut views.coarse);
    let twice = &views.coarse[once.len()..].to_vec();
    let last = side / block / block;
    coarsen(twice, last, count, last, &mut views.coarse);
}

/// Appends the nearest of each block of `block` by `block` elements of so many squares.
fn coarsen(fine: &[f32], side: usize, count: usize, block: usize, coarse: &mut Vec<f32>) {
    let across = side / block;
    for square in 0..count {
        for row in 0..across {
            for column in 0..across {
                let mut nearest = NOWHERE;
                for y in 0..block {
                    let first = (square * side + row * block + y) * side + column * block;
                    let texels = &fine[first..first + block];
                    nearest = texels.iter().fold(nearest, |nearest, k| nearest.max(*k));
                }
                coarse.push(nearest);
            }
        }
    }
}
