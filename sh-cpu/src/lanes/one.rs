//! One number, with the instructions of a level.

use core::ops::{Add, Div, Mul, Neg, Sub};
use fearless_simd::Simd;
use sh_core::Lane;

/// One `f32` whose `mul_add` is fused, where the level `S` fuses. Nothing is faster one receiver at a time, so this is
/// what vector lanes are compared with: both differ in width alone.
///
/// Plain `f32` fuses only in a build whose baseline processor does.
#[derive(Clone, Copy, Debug)]
pub struct Lanes1<S: Simd> {
    value: f32,
    simd: S,
}

impl<S: Simd> Lanes1<S> {
    /// Numbers side by side.
    pub const COUNT: usize = 1;

    /// One value.
    #[inline(always)]
    pub fn from_array(simd: S, [value]: [f32; 1]) -> Self {
        Self { value, simd }
    }

    /// One value.
    #[inline(always)]
    pub fn to_array(self) -> [f32; 1] {
        [self.value]
    }

    /// Calls `work` within the instruction set that `self` carries.
    #[inline(always)]
    pub(crate) fn within<R>(self, work: impl FnOnce() -> R) -> R {
        self.simd.vectorize(work)
    }

    #[inline(always)]
    fn with(self, value: f32) -> Self {
        Self { value, ..self }
    }
}

macro_rules! operator {
    ($($operator:ident, $method:ident;)*) => { $(
        impl<S: Simd> $operator for Lanes1<S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.with($operator::$method(self.value, other.value))
            }
        }
    )* };
}

operator! {
    Add, add;
    Sub, sub;
    Mul, mul;
    Div, div;
}

impl<S: Simd> Neg for Lanes1<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.with(-self.value)
    }
}

impl<S: Simd> Lane for Lanes1<S> {
    type Mask = bool;
    #[inline(always)]
    fn lift(self, value: f64) -> Self {
        self.with(value as f32)
    }
    /// Without the instruction this would be a slow call, so levels that lack it round twice.
    #[inline(always)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        self.with(if fuses(self.simd) {
            self.value.mul_add(factor.value, term.value)
        } else {
            self.value * factor.value + term.value
        })
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        self.with(self.value.sqrt())
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.with(self.value.abs())
    }
    #[inline(always)]
    fn exp(self) -> Self {
        self.with(self.value.exp())
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.with(Lane::min(self.value, other.value))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.with(Lane::max(self.value, other.value))
    }
    #[inline(always)]
    fn lt(self, other: Self) -> bool {
        self.value < other.value
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

/// Whether a level has fused multiply-adds: a constant once compiled.
#[inline(always)]
fn fuses<S: Simd>(simd: S) -> bool {
    let level = simd.level();
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    return level.as_avx2().is_some();
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
    return !level.is_fallback();
}
