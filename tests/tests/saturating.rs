//! What the exponential of the shadow pass promises of any input.

use proptest::prelude::*;
use sh_core::ROOT_FOUR_PI;
use sh_tests::call::{call_f32, call_f64};

/// The largest value of a sample, (1 + 0.2)²(1 − 0.05)².
const BRIGHTEST: f64 = 1.2996;

fn exp(order: usize, f: &[f64]) -> Vec<f64> {
    call_f64("exp_saturating", order, &[f.to_vec()])
}

fn norm(f: &[f64]) -> f64 {
    f.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    norm(&a.iter().zip(b).map(|(a, b)| a - b).collect::<Vec<_>>())
}

/// The largest gain of a band: what projection may add to the bound of the samples.
fn gain(order: usize) -> f64 {
    let (_, gains) = sh_codegen::fits::saturating(order);
    gains.into_iter().fold(0.0, f64::max)
}

/// An order and a vector of it.
fn vector() -> impl Strategy<Value = (usize, Vec<f64>)> {
    (2..=6_usize)
        .prop_flat_map(|order| (Just(order), prop::collection::vec(-1.0..1.0, order * order)))
}

/// One of the 24 rotations of the octahedron, as a product of quarter turns about x and z.
fn quarter_turns() -> impl Strategy<Value = Vec<[f64; 4]>> {
    let half = 0.5_f64.sqrt();
    let turn = prop::sample::select(vec![[half, 0.0, 0.0, half], [0.0, 0.0, half, half]]);
    prop::collection::vec(turn, 0..6)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, failure_persistence: None, ..ProptestConfig::default() })]

    /// The norm of the result is at most that of its brightest samples, for numbers of any finite size.
    #[test]
    fn bounded_for_any_finite_input((order, f) in vector(), exponent in -320.0..308.0_f64) {
        let large: Vec<f64> = f.iter().map(|x| x * 10.0_f64.powf(exponent)).collect();
        let bound = BRIGHTEST * ROOT_FOUR_PI * gain(order);
        prop_assert!(norm(&exp(order, &large)) <= bound * (1.0 + 1e-12));
        let narrow = f
            .iter()
            .map(|x| (*x as f32 * 10.0_f32.powf(exponent as f32 / 8.0)).clamp(f32::MIN, f32::MAX))
            .collect();
        let g: Vec<f64> = call_f32("exp_saturating", order, &[narrow])
            .into_iter()
            .map(f64::from)
            .collect();
        prop_assert!(norm(&g) <= bound * (1.0 + 1e-5), "{}", norm(&g));
    }

    /// Coefficients of sizes that have nothing to do with each other.
    #[test]
    fn bounded_for_mixed_magnitudes(
        order in 2..=6_usize,
        f in prop::collection::vec(prop::num::f32::NORMAL | prop::num::f32::SUBNORMAL | prop::num::f32::ZERO, 36),
    ) {
        let g = call_f32("exp_saturating", order, &[f[..order * order].to_vec()]);
        let norm = norm(&g.into_iter().map(f64::from).collect::<Vec<_>>());
        prop_assert!(norm <= BRIGHTEST * ROOT_FOUR_PI * gain(order) * (1.0 + 1e-5), "{norm}");
    }

    /// The samples lie symmetrically: turning by quarter turns before or after is the same, but for rounding.
    #[test]
    fn commutes_with_the_octahedral_group((order, f) in vector(), size in 0.0..30.0_f64, turns in quarter_turns()) {
        let mut before: Vec<f64> = f.iter().map(|x| x * size).collect();
        let mut after = exp(order, &before);
        for turn in turns {
            let rotate = |f: &Vec<f64>| call_f64("rotate", order, &[f.clone(), turn.to_vec()]);
            (before, after) = (rotate(&before), rotate(&after));
        }
        prop_assert!(distance(&exp(order, &before), &after) < 1e-12);
    }

    /// As blockers vanish, so does their shadow: h'(0) is 3/2.
    #[test]
    fn goes_to_one((order, f) in vector(), exponent in -300.0..-1.0_f64) {
        let f: Vec<f64> = f.iter().map(|x| x * 10.0_f64.powf(exponent)).collect();
        let mut one = vec![0.0; order * order];
        one[0] = ROOT_FOUR_PI;
        let off = distance(&exp(order, &f), &one);
        prop_assert!(off <= 1.8 * norm(&f) + 1e-14, "{off}");
    }

    /// Darkness added evenly never brightens: h is monotone.
    #[test]
    fn even_darkness_never_brightens((order, f) in vector(), size in 0.0..30.0_f64, dark in 0.0..10.0_f64) {
        let f: Vec<f64> = f.iter().map(|x| x * size).collect();
        let mut darker = f.clone();
        darker[0] -= dark;
        prop_assert!(exp(order, &darker)[0] <= exp(order, &f)[0] + 1e-13);
    }

    /// h itself, seen where all samples are the same: monotone, within 0..=1.2996, 0 from −1 down.
    #[test]
    fn the_function_is_monotone(order in 2..=6_usize, a in -3.0..1.0_f64, b in -3.0..1.0_f64) {
        let h = |x: f64| {
            let mut f = vec![0.0; order * order];
            f[0] = x * ROOT_FOUR_PI;
            exp(order, &f)[0] / ROOT_FOUR_PI
        };
        let (low, high) = (h(a.min(b)), h(a.max(b)));
        prop_assert!(0.0 <= low && low <= high + 1e-15 && high <= BRIGHTEST + 1e-14, "{low} {high}");
        prop_assert!(a.min(b) > -1.0 || low < 1e-15);
    }
}
