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
    ///
    /// ```
    /// use sh_core::Lane;
    /// let mask: <f32 as Lane>::Mask = Lane::lt(1.0, 2.0);
    /// assert!(mask);
    /// ```
    type Mask: Copy;

    /// `value` in every lane, rounded once to the lane's precision.
    ///
    /// ```
    /// use sh_core::Lane;
    /// assert_eq!(0.0_f32.lift(0.1), 0.1_f32);
    /// ```
    fn lift(self, value: f64) -> Self;

    /// `self * factor + term`. Fused where the target fuses, two roundings elsewhere: a fused operation
    /// without hardware is a library call that costs more than the routine around it.
    ///
    /// ```
    /// use sh_core::Lane;
    /// assert_eq!(Lane::mul_add(2.0_f32, 3.0, 4.0), 10.0);
    /// ```
    fn mul_add(self, factor: Self, term: Self) -> Self;

    /// Square root.
    ///
    /// Rounded correctly.
    ///
    /// ```
    /// use sh_core::Lane;
    /// assert_eq!(Lane::sqrt(9.0_f64), 3.0);
    /// ```
    fn sqrt(self) -> Self;

    /// Absolute value.
    ///
    /// ```
    /// use sh_core::Lane;
    /// assert_eq!(Lane::abs(-2.0_f32), 2.0);
    /// ```
    fn abs(self) -> Self;

    /// e to the power of `self`. Relative error at most 2 units in the last place for results in the
    /// normal range; below it 0 or a subnormal, above it infinity.
    ///
    /// ```
    /// use sh_core::Lane;
    /// assert!((Lane::exp(1.0_f64) - std::f64::consts::E).abs() < 1e-15);
    /// ```
    fn exp(self) -> Self;

    /// The smaller of both. Where one is NaN the result is unspecified.
    ///
    /// ```
    /// use sh_core::Lane;
    /// assert_eq!(Lane::min(1.0_f32, 2.0), 1.0);
    /// ```
    fn min(self, other: Self) -> Self;

    /// The larger of both. Where one is NaN the result is unspecified.
    ///
    /// ```
    /// use sh_core::Lane;
    /// assert_eq!(Lane::max(1.0_f32, 2.0), 2.0);
    /// ```
    fn max(self, other: Self) -> Self;

    /// `self < other`, lane by lane; false where either is NaN.
    ///
    /// ```
    /// use sh_core::Lane;
    /// assert!(Lane::lt(1.0_f32, 2.0) && !Lane::lt(f32::NAN, 2.0));
    /// ```
    fn lt(self, other: Self) -> Self::Mask;

    /// `then` where the mask holds, `otherwise` elsewhere.
    ///
    /// ```
    /// use sh_core::Lane;
    /// let (a, b) = (3.0_f32, 4.0);
    /// assert_eq!(f32::select(Lane::lt(a, b), a, b), 3.0);
    /// ```
    fn select(mask: Self::Mask, then: Self, otherwise: Self) -> Self;

    /// Whether the mask holds in any lane.
    ///
    /// ```
    /// use sh_core::Lane;
    /// assert!(f32::any(Lane::lt(1.0_f32, 2.0)));
    /// ```
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
