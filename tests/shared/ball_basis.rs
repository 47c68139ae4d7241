//! A body whose light is told in few functions, made without looking for any.

use glam::Vec3;
use sh_core::Routines;
use sh_scene::basis::{BasisParts, Disc, Escape, Facet, PATCH_SAMPLES, Patch, REGION_PATCHES};
use sh_scene::{BasisSample, IrradianceBasis};
use std::sync::Arc;

/// Functions and patches of a ball, some of whose light falls on itself; from numbers in 0..1.
pub fn ball_basis(
    number: &mut impl FnMut() -> f32,
    radius: f32,
    functions: usize,
) -> Arc<IrradianceBasis> {
    let place = |k: usize| {
        let height = 1.0 - (2.0 * k as f32 + 1.0) / SAMPLES as f32;
        let (sin, cos) = (2.399_963 * k as f32).sin_cos();
        let flat = (1.0 - height * height).sqrt();
        Vec3::new(flat * cos, height, flat * sin)
    };
    let places = (0..SAMPLES).map(|k| (place(k) * radius, place(k)));
    let area = 4.0 * std::f32::consts::PI * radius * radius / SAMPLES as f32;
    basis(number, &places.collect::<Vec<_>>(), area, functions)
}

/// The same of a square that faces up.
#[allow(dead_code, reason = "not all tests that share this need one")]
pub fn panel_basis(
    number: &mut impl FnMut() -> f32,
    side: f32,
    functions: usize,
) -> Arc<IrradianceBasis> {
    // Runs of 4, 16 and 64 are squares (Morton order).
    let bits = |k: usize, from: usize| {
        let of = |bit: usize| (k >> (2 * bit + from) & 1) << bit;
        (0..4).map(of).sum::<usize>() as f32
    };
    let place = |k: usize| Vec3::new(bits(k, 0), 0.0, bits(k, 1)) * side / 16.0;
    let places = (0..SAMPLES).map(|k| (place(k), Vec3::Y));
    let area = (side / 16.0).powi(2);
    basis(number, &places.collect::<Vec<_>>(), area, functions)
}

const SAMPLES: usize = 2 * PATCH_SAMPLES * REGION_PATCHES;

/// Of places with normals, each for as much area.
fn basis(
    number: &mut impl FnMut() -> f32,
    places: &[(Vec3, Vec3)],
    area: f32,
    functions: usize,
) -> Arc<IrradianceBasis> {
    let samples = places.len();
    let patches = samples / PATCH_SAMPLES;
    let mut values = vec![1.0; samples];
    values.extend((samples..samples * functions).map(|_| number() * 2.0 - 1.0));
    let patch = |own: &[(Vec3, Vec3)]| {
        let discs = std::array::from_fn(|k| Disc::new(own[k].0, own[k].1 * area));
        let facing: Vec3 = own.iter().map(|(_, normal)| normal).sum();
        let escape = Escape {
            linear: [0.1, -0.2, 0.1],
            square: [0.9, 0.8, 1.0, 0.1, 0.0, -0.1],
        };
        let middle = own.iter().map(|(place, _)| place).sum::<Vec3>() / PATCH_SAMPLES as f32;
        Patch {
            whole: Facet::new(Disc::new(middle, facing * area), &escape),
            discs,
        }
    };
    let lobes = (0..patches).map(|m| {
        let own = &places[m * PATCH_SAMPLES..][..PATCH_SAMPLES];
        let facing: Vec3 = own.iter().map(|(_, normal)| normal).sum();
        <[f32; 36]>::cosine(facing.normalize().to_array()).map(|y| y * 3.0)
    });
    let parts = BasisParts {
        samples: places
            .iter()
            .map(|(place, normal)| BasisSample {
                position: (*place).into(),
                normal: (*normal).into(),
                albedo: [number(), number(), number()],
            })
            .collect(),
        area,
        values,
        patches: places.chunks(PATCH_SAMPLES).map(patch).collect(),
        lobes: lobes.collect(),
        own: (0..patches * functions)
            .map(|_| [0.1 * number(), 0.05, 0.1 * number()])
            .collect(),
        held: vec![0.5; functions],
    };
    Arc::new(IrradianceBasis::new(parts).expect("it fits together"))
}
