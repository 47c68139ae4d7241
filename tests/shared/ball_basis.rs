//! A body whose light is told in few functions, made without looking for any.

use glam::Vec3;
use sh_core::Routines;
use sh_scene::basis::{BasisParts, Disc, Escape, PATCH_SAMPLES, Patch, REGION_PATCHES};
use sh_scene::{BasisSample, IrradianceBasis};
use std::sync::Arc;

/// Functions and patches of a ball, some of whose light falls on itself; from numbers in 0..1.
pub fn ball_basis(
    number: &mut impl FnMut() -> f32,
    radius: f32,
    functions: usize,
) -> Arc<IrradianceBasis> {
    let samples: usize = 2 * PATCH_SAMPLES * REGION_PATCHES;
    let patches = samples / PATCH_SAMPLES;
    let directions: Vec<Vec3> = (0..samples)
        .map(|k| {
            let height = 1.0 - (2.0 * k as f32 + 1.0) / samples as f32;
            let (sin, cos) = (2.399_963 * k as f32).sin_cos();
            let flat = (1.0 - height * height).sqrt();
            Vec3::new(flat * cos, height, flat * sin)
        })
        .collect();
    let area = 4.0 * std::f32::consts::PI * radius * radius / samples as f32;
    let mut values = vec![1.0; samples];
    values.extend((samples..samples * functions).map(|_| number() * 2.0 - 1.0));
    let patch = |own: &[Vec3]| {
        let discs = std::array::from_fn(|k| Disc::new(own[k] * radius, own[k] * area));
        let facing: Vec3 = own.iter().sum();
        let escape = Escape {
            linear: [0.1, -0.2, 0.1],
            square: [0.9, 0.8, 1.0, 0.1, 0.0, -0.1],
        };
        let middle = facing / PATCH_SAMPLES as f32 * radius;
        Patch::new(Disc::new(middle, facing * area), discs, &escape)
    };
    let lobes = (0..patches).map(|m| {
        let facing: Vec3 = directions[m * PATCH_SAMPLES..][..PATCH_SAMPLES]
            .iter()
            .sum();
        <[f32; 36]>::cosine(facing.normalize().to_array()).map(|y| y * 3.0)
    });
    let parts = BasisParts {
        samples: directions
            .iter()
            .map(|towards| BasisSample {
                position: (*towards * radius).into(),
                normal: (*towards).into(),
                albedo: [number(), number(), number()],
            })
            .collect(),
        area,
        values,
        patches: directions.chunks(PATCH_SAMPLES).map(patch).collect(),
        lobes: lobes.collect(),
        own: (0..patches * functions)
            .map(|_| [0.1 * number(), 0.05, 0.1 * number()])
            .collect(),
        held: vec![0.5; functions],
    };
    Arc::new(IrradianceBasis::new(parts).expect("it fits together"))
}
