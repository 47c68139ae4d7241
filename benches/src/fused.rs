//! One `f32` whose `mul_add` is fused.
//!
//! `f32` itself fuses only in a build whose baseline processor does. A function that has entered an
//! instruction set at run time may fuse as well, and this type does: so that the scalar path and the
//! vector path differ in width alone.

use core::ops::{Add, Div, Mul, Neg, Sub};
use sh_core::Lane;

/// A number that fuses. Without the instruction, `mul_add` is a slow call.
#[derive(Clone, Copy, Debug)]
pub struct Fused(pub f32);

macro_rules! operator {
    ($($operator:ident, $method:ident;)*) => { $(
        impl $operator for Fused {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self($operator::$method(self.0, other.0))
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

impl Neg for Fused {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Lane for Fused {
    type Mask = bool;
    #[inline(always)]
    fn lift(self, value: f64) -> Self {
        Self(value as f32)
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
    #[inline(always)]
    fn exp(self) -> Self {
        Self(self.0.exp())
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(Lane::min(self.0, other.0))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(Lane::max(self.0, other.0))
    }
    #[inline(always)]
    fn lt(self, other: Self) -> bool {
        self.0 < other.0
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
