//! What half precision promises, over all magnitudes and at the edges.

#![cfg(feature = "half")]

use sh_core::storage::{HalfRgb2, HalfRgb3};
use sh_core::{Sh2, Sh3, Sh6, ShRgb};

/// Numbers of every magnitude that f16 knows, and beyond, from a fixed sequence.
fn numbers() -> impl Iterator<Item = f32> {
    let mut state = 1_u32;
    (0..20_000).map(move |i| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let mantissa = 1.0 + (state >> 8) as f32 / (1 << 24) as f32;
        let sign = if state & 1 == 0 { 1.0 } else { -1.0 };
        sign * mantissa * 2.0_f32.powi(i % 40 - 26)
    })
}

#[test]
fn rounding_stays_below_what_is_stated() {
    let numbers: Vec<f32> = numbers().filter(|x| x.abs() <= 65504.0).collect();
    let mut worst = 0.0_f32;
    for chunk in numbers.chunks_exact(36) {
        let f = Sh6::from(<[f32; 36]>::try_from(chunk).unwrap());
        let back = Sh6::from_half(&f.to_half());
        for (a, b) in f.0.iter().zip(back.0) {
            let error = (a - b).abs();
            let permitted = (a.abs() / 2048.0).max(2.0_f32.powi(-25));
            assert!(error <= permitted, "{b} for {a}");
            worst = worst.max(error / permitted);
        }
    }
    assert!(worst > 0.9, "the stated error is too loose: {worst} of it");
}

#[test]
fn what_is_too_large_is_held_and_nan_stays() {
    let f = Sh2::from([1e30, f32::NEG_INFINITY, 65519.0, f32::NAN]);
    let back = Sh2::from_half(&f.to_half());
    assert_eq!(back.0[..3], [65504.0, -65504.0, 65504.0]);
    assert!(back[3].is_nan());
    assert_eq!(
        Sh2::from([0.0, -0.0, 1e-30, 0.0]).to_half(),
        [0x8000_0000, 0]
    );
}

#[test]
fn channels_do_not_mix() {
    let rgb = |r: f32, g: f32, b: f32| {
        let channel = |x: f32| Sh3::from([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]) * x;
        ShRgb {
            r: channel(r),
            g: channel(g),
            b: channel(b),
        }
    };
    // Small whole numbers are exact in f16.
    let light = rgb(1.0, -2.0, 16.0);
    let packed = HalfRgb3::from(light);
    assert_eq!(light, packed.into());
    assert_eq!(packed.words[15], 0);
    let light = light.to_order::<4>();
    let packed = HalfRgb2::from(light);
    assert_eq!(light, packed.into());
    assert_eq!(light, HalfRgb2::from_std140(&packed.std140()).into());
}
