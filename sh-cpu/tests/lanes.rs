//! Vector lanes against f64, at every level the machine offers.

use fearless_simd::dispatch;
use proptest::prelude::*;
use sh_core::Lane;
use sh_cpu::lanes::{Lanes4, Lanes8, Lanes16};
use sh_cpu::levels;

/// Applies `$body` to eight values in all widths at every level and checks that the widths agree bit by
/// bit; evaluates to one result a level.
macro_rules! each_level {
    ($values:expr, |$x:ident| $body:expr) => {{
        let values: [f32; 8] = $values;
        let mut results = Vec::new();
        for level in levels() {
            let eight = dispatch!(level, simd => {
                let $x = Lanes8::from_array(simd, values);
                $body.to_array()
            });
            let twice = core::array::from_fn(|i| values[i % 8]);
            let sixteen = dispatch!(level, simd => {
                let $x = Lanes16::from_array(simd, twice);
                $body.to_array()
            });
            let four = dispatch!(level, simd => {
                let $x = Lanes4::from_array(simd, core::array::from_fn(|i| values[i]));
                $body.to_array()
            });
            for (i, other) in sixteen.iter().enumerate().chain(four.iter().enumerate()) {
                let narrow = eight[i % 8];
                assert!(
                    narrow.to_bits() == other.to_bits() || narrow.is_nan() && other.is_nan(),
                    "{level:?}: lane {i} of 8 has {narrow}, in another width {other}"
                );
            }
            results.push(eight);
        }
        results
    }};
}

/// Distance from the exact value in units in the last place of `exact` as f32; below the normal range in
/// units of the subnormal grid.
fn ulps(got: f32, exact: f64) -> f64 {
    let exponent = exact.abs().log2().floor().max(-126.0);
    (f64::from(got) - exact).abs() / (exponent - 23.0).exp2()
}

fn check_exp(values: [f32; 8], worst: &mut f64) {
    for result in each_level!(values, |x| x.exp()) {
        for (x, got) in values.into_iter().zip(result) {
            let exact = f64::from(x).exp();
            if x.is_nan() {
                assert!(got.is_nan(), "exp of NaN gave {got}");
            } else if exact >= f64::from(f32::MAX) * (1.0 + 6e-8) {
                assert_eq!(got, f32::INFINITY, "exp({x})");
            } else {
                let error = ulps(got, exact);
                *worst = worst.max(error);
                assert!(error <= 2.0, "exp({x:e}) = {got:e}, {error} ULP off");
            }
        }
    }
}

#[test]
fn exponential_over_all_magnitudes() {
    let mut worst = 0.0;
    // Every 4,001st bit pattern: both signs, subnormals, infinities and NaN among them.
    for start in (0..=u32::MAX - 8 * 4001).step_by(8 * 4001) {
        let values = core::array::from_fn(|i| f32::from_bits(start + i as u32 * 4001));
        check_exp(values, &mut worst);
    }
    // The range where the result is neither 0 nor infinite, evenly.
    for i in 0..200_000 {
        let values = core::array::from_fn(|k| -104.5 + (i * 8 + k) as f32 * (194.0 / 1.6e6));
        check_exp(values, &mut worst);
    }
    println!("worst error of exp: {worst:.3} ULP");
}

#[test]
fn exponential_at_the_edges() {
    let values = [
        f32::NEG_INFINITY,
        f32::INFINITY,
        f32::NAN,
        0.0,
        -0.0,
        1e-45,
        f32::MAX,
        f32::MIN,
    ];
    for result in each_level!(values, |x| x.exp()) {
        assert_eq!(result[..2], [0.0, f32::INFINITY]);
        assert!(result[2].is_nan());
        assert_eq!(result[3..], [1.0, 1.0, 1.0, f32::INFINITY, 0.0]);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn exponential_agrees_with_f64(values in prop::array::uniform8(-110.0_f32..95.0)) {
        check_exp(values, &mut 0.0);
    }

    /// The correctly rounded operations give what f32 gives, lane by lane.
    #[test]
    fn operations_agree_with_scalars(
        values in prop::array::uniform8(-1e6_f32..1e6),
        other in -1e3_f32..1e3,
    ) {
        let o = f64::from(other);
        let scalar = |f: fn(f32, f32) -> f32| values.map(|x| f(x, other));
        for result in each_level!(values, |x| x + x.lift(o)) {
            prop_assert_eq!(result, scalar(|x, o| x + o));
        }
        for result in each_level!(values, |x| x - x.lift(o)) {
            prop_assert_eq!(result, scalar(|x, o| x - o));
        }
        for result in each_level!(values, |x| x * x.lift(o)) {
            prop_assert_eq!(result, scalar(|x, o| x * o));
        }
        for result in each_level!(values, |x| x.lift(o) / x) {
            prop_assert_eq!(result, scalar(|x, o| o / x));
        }
        for result in each_level!(values, |x| (-x).abs().sqrt()) {
            prop_assert_eq!(result, scalar(|x, _| x.abs().sqrt()));
        }
        for result in each_level!(values, |x| x.min(x.lift(o))) {
            prop_assert_eq!(result, scalar(f32::min));
        }
        for result in each_level!(values, |x| x.max(x.lift(o))) {
            prop_assert_eq!(result, scalar(f32::max));
        }
        for result in each_level!(values, |x| Lane::select(x.lt(x.lift(o)), -x, x.lift(o))) {
            prop_assert_eq!(result, scalar(|x, o| if x < o { -x } else { o }));
        }
    }

    /// `mul_add` within one rounding of the product and one of the sum.
    #[test]
    fn mul_add_agrees_with_f64(values in prop::array::uniform8(-10.0_f32..10.0), term in -10.0_f32..10.0) {
        for result in each_level!(values, |x| x.mul_add(x, x.lift(f64::from(term)))) {
            for (x, got) in values.into_iter().zip(result) {
                let square = f64::from(x) * f64::from(x);
                let exact = square + f64::from(term);
                let bound = (square + exact.abs()) * f64::from(f32::EPSILON) * 0.5 * 1.001;
                prop_assert!((f64::from(got) - exact).abs() <= bound);
            }
        }
    }
}

#[test]
fn any_sees_every_lane() {
    for level in levels() {
        for lane in 0..16 {
            let (eight, sixteen, none) = dispatch!(level, simd => {
                let x = Lanes8::from_array(simd, core::array::from_fn(|i| if i == lane % 8 { -1.0 } else { 1.0 }));
                let y = Lanes16::from_array(simd, core::array::from_fn(|i| if i == lane { -1.0 } else { 1.0 }));
                let zero = y.lift(0.0);
                (
                    <Lanes8<_> as Lane>::any(x.lt(x.lift(0.0))),
                    <Lanes16<_> as Lane>::any(y.lt(zero)),
                    <Lanes16<_> as Lane>::any(y.abs().lt(zero)),
                )
            });
            assert!(eight && sixteen && !none, "{level:?}, lane {lane}");
        }
    }
}

#[test]
fn comparisons_with_nan_are_false() {
    let values = [f32::NAN; 8];
    for result in each_level!(values, |x| Lane::select(
        x.lt(x.lift(0.0)),
        x.lift(1.0),
        x.lift(2.0)
    )) {
        assert_eq!(result, [2.0; 8]);
    }
    for result in each_level!(values, |x| Lane::select(
        x.lift(0.0).lt(x),
        x.lift(1.0),
        x.lift(2.0)
    )) {
        assert_eq!(result, [2.0; 8]);
    }
}
