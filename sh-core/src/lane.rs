//! What a routine computes with: one number, or several side by side.
//!
//! Every generated routine and everything in this crate that runs once per receiver is written against
//! [`Lane`], so that the scalar path and the vector path are one text. This crate implements the trait
//! for `f32` and `f64`; vector newtypes (8 or 16 `f32` side by side) live where the instruction set is
//! known, in `sh-cpu`.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// One number, or a fixed count of numbers that are computed side by side.
///
/// No operation lets one lane see another, except [`Lane::any`]. A constant is made by [`Lane::lift`]
/// from a value at hand and not from nothing, because vector types carry the proof that the processor
/// has their instructions.
///
/// ```
/// use sh_core::Lane;
/// fn hypotenuse<L: Lane>(a: L, b: L) -> L {
///     a.mul_add(a, b * b).sqrt()
/// }
/// assert_eq!(hypotenuse(3.0_f32, 4.0), 5.0);
/// assert_eq!(hypotenuse(3.0_f64, 4.0), 5.0);
/// ```
pub trait Lane:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The outcome of a comparison, one truth value a lane.
    type Mask: Copy;

    /// `value` in every lane, rounded once to the lane's precision.
    fn lift(self, value: f64) -> Self;

    /// `self * factor + term`. Fused where the target fuses, two roundings elsewhere: a fused operation
    /// without hardware is a library call that costs more than the routine around it.
    fn mul_add(self, factor: Self, term: Self) -> Self;

    /// Square root.
    fn sqrt(self) -> Self;

    /// Absolute value.
    fn abs(self) -> Self;

    /// e to the power of `self`. Relative error at most 2 units in the last place for results in the
    /// normal range; below it 0 or a subnormal, above it infinity.
    fn exp(self) -> Self;

    /// The smaller of both. Where one is NaN the result is unspecified.
    fn min(self, other: Self) -> Self;

    /// The larger of both. Where one is NaN the result is unspecified.
    fn max(self, other: Self) -> Self;

    /// `self < other`, lane by lane; false where either is NaN.
    fn lt(self, other: Self) -> Self::Mask;

    /// `then` where the mask holds, `otherwise` elsewhere.
    fn select(mask: Self::Mask, then: Self, otherwise: Self) -> Self;

    /// Whether the mask holds in any lane.
    fn any(mask: Self::Mask) -> bool;
}

macro_rules! scalar_lane {
    ($t:ty, $exp:ident, $sqrt:ident) => {
        impl Lane for $t {
            type Mask = bool;
            #[inline(always)]
            fn lift(self, value: f64) -> Self {
                value as $t
            }
            #[inline(always)]
            fn mul_add(self, factor: Self, term: Self) -> Self {
                #[cfg(all(feature = "std", target_feature = "fma"))]
                return <$t>::mul_add(self, factor, term);
                #[cfg(not(all(feature = "std", target_feature = "fma")))]
                return self * factor + term;
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                crate::real::$sqrt(self)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                if self < 0.0 { -self } else { self }
            }
            #[inline(always)]
            fn exp(self) -> Self {
                crate::real::$exp(self)
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                if other < self { other } else { self }
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                if self < other { other } else { self }
            }
            #[inline(always)]
            fn lt(self, other: Self) -> bool {
                self < other
            }
            #[inline(always)]
            fn select(mask: bool, then: Self, otherwise: Self) -> Self {
                if mask { then } else { otherwise }
            }
            #[inline(always)]
            fn any(mask: bool) -> bool {
                mask
            }
        }
    };
}

scalar_lane!(f32, expf, sqrtf);
scalar_lane!(f64, exp, sqrt);
