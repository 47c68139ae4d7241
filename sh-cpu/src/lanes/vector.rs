//! Several numbers side by side.

use core::ops::{Add, Div, Mul, Neg, Sub};
use fearless_simd::prelude::*;
use fearless_simd::{
    Simd, f32x4, f32x8, f32x16, i32x4, i32x8, i32x16, mask32x4, mask32x8, mask32x16,
};
use sh_core::Lane;

/// Limits beyond which e^x is 0 or infinity in `f32`: e^-104 < 2^-150, e^89 > 2^128.
const EXP_RANGE: (f32, f32) = (-104.0, 89.0);

/// ln 2 = `LN2_HIGH` - `LN2_LOW`: the high part has 9 significant bits, so that its product with any
/// exponent (8 bits) is exact with or without fused arithmetic (Cody and Waite, 1980).
const LN2_HIGH: f32 = 0.693_359_375;
const LN2_LOW: f32 = 2.121_944_4e-4;

/// (e^r - 1 - r) / r² on |r| ≤ ln 2 / 2, highest power first: the polynomial of Cephes' `expf`
/// (Moshier, 1992), whose error there is below 2⁻²⁶ of the result.
const EXP_POLYNOMIAL: [f32; 6] = [
    1.987_569_1e-4,
    1.398_199_9e-3,
    8.333_452e-3,
    4.166_579_6e-2,
    1.666_666_5e-1,
    0.5,
];

macro_rules! vector_lane {
    ($(#[$doc:meta])* $name:ident, $count:literal, $float:ident, $int:ident, $mask:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub struct $name<S: Simd>(pub $float<S>);

        impl<S: Simd> $name<S> {
            /// Numbers side by side.
            pub const COUNT: usize = $count;

            /// Calls `work` within the instruction set that `self` carries.
            #[inline(always)]
            pub(crate) fn within<R>(self, work: impl FnOnce() -> R) -> R {
                self.0.simd.vectorize(work)
            }

            /// `value` in every lane.
            #[inline(always)]
            pub fn splat(simd: S, value: f32) -> Self {
                Self($float::splat(simd, value))
            }

            /// One value a lane.
            #[inline(always)]
            pub fn from_array(simd: S, values: [f32; $count]) -> Self {
                Self($float::simd_from(simd, values))
            }

            /// One value a lane.
            #[inline(always)]
            pub fn to_array(self) -> [f32; $count] {
                self.0.into()
            }

            /// 2 to the power of `exponent`, whole numbers in -126..=127, built from bits.
            #[inline(always)]
            fn power_of_two(exponent: $float<S>) -> $float<S> {
                let biased = $int::truncate_from(exponent + 127.0);
                (biased << 23).bitcast()
            }
        }

        impl<S: Simd> Add for $name<S> {
            type Output = Self;
            #[inline(always)]
            fn add(self, other: Self) -> Self {
                Self(self.0 + other.0)
            }
        }
        impl<S: Simd> Sub for $name<S> {
            type Output = Self;
            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                Self(self.0 - other.0)
            }
        }
        impl<S: Simd> Mul for $name<S> {
            type Output = Self;
            #[inline(always)]
            fn mul(self, other: Self) -> Self {
                Self(self.0 * other.0)
            }
        }
        impl<S: Simd> Div for $name<S> {
            type Output = Self;
            #[inline(always)]
            fn div(self, other: Self) -> Self {
                Self(self.0 / other.0)
            }
        }
        impl<S: Simd> Neg for $name<S> {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }

        impl<S: Simd> Lane for $name<S> {
            type Mask = $mask<S>;
            #[inline(always)]
            fn lift(self, value: f64) -> Self {
                Self($float::splat(self.0.simd, value as f32))
            }
            #[inline(always)]
            fn mul_add(self, factor: Self, term: Self) -> Self {
                Self(self.0.mul_add(factor.0, term.0))
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                Self(self.0.sqrt())
            }
            #[inline(always)]
            fn abs(self) -> Self {
                Self(self.0.abs())
            }
            /// At most 2 units in the last place off where the result is normal, one unit of the
            /// subnormal grid below; NaN stays NaN.
            #[inline(always)]
            fn exp(self) -> Self {
                let simd = self.0.simd;
                let splat = |value: f32| $float::splat(simd, value);
                let x = self.0.max(splat(EXP_RANGE.0)).min(splat(EXP_RANGE.1));
                // x = n ln 2 + r with |r| ≤ ln 2 / 2.
                let n = (x * core::f32::consts::LOG2_E).round_ties_even();
                let r = n.mul_add(splat(-LN2_HIGH), x);
                let r = n.mul_add(splat(LN2_LOW), r);
                let mut p = splat(EXP_POLYNOMIAL[0]);
                for coefficient in &EXP_POLYNOMIAL[1..] {
                    p = p.mul_add(r, splat(*coefficient));
                }
                let y = (r * r).mul_add(p, r) + 1.0;
                // 2^n in two steps: n reaches -150 and 128, beyond one exponent's range.
                let half = (n * 0.5).floor();
                let y = y * Self::power_of_two(half) * Self::power_of_two(n - half);
                Self(self.0.simd_eq(self.0).select(y, self.0))
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                Self(self.0.min(other.0))
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                Self(self.0.max(other.0))
            }
            #[inline(always)]
            fn lt(self, other: Self) -> Self::Mask {
                self.0.simd_lt(other.0)
            }
            #[inline(always)]
            fn select(mask: Self::Mask, then: Self, otherwise: Self) -> Self {
                Self(mask.select(then.0, otherwise.0))
            }
            #[inline(always)]
            fn any(mask: Self::Mask) -> bool {
                mask.any_true()
            }
        }
    };
}

vector_lane! {
    /// 8 numbers side by side.
    ///
    /// ```
    /// use fearless_simd::{Level, dispatch};
    /// use sh_core::Lane;
    /// use sh_cpu::lanes::Lanes8;
    ///
    /// let roots = dispatch!(Level::new(), simd => {
    ///     let squares = Lanes8::from_array(simd, [0.0, 1.0, 4.0, 9.0, 16.0, 25.0, 36.0, 49.0]);
    ///     squares.sqrt().to_array()
    /// });
    /// assert_eq!(roots, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]);
    /// ```
    Lanes8, 8, f32x8, i32x8, mask32x8
}

vector_lane! {
    /// 4 numbers side by side, as [`Lanes8`]: one register of SSE2, Neon or wasm.
    Lanes4, 4, f32x4, i32x4, mask32x4
}

vector_lane! {
    /// 16 numbers side by side, as [`Lanes8`].
    Lanes16, 16, f32x16, i32x16, mask32x16
}
