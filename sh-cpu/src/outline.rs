//! Generated routines as functions of their own.
//!
//! Generated routines are inlined so that they take over the caller's instruction set. The largest of them,
//! some thousand operations, must not be copied into every place that uses them: the compiler's time grows
//! faster than the function (two products of order 6 inlined in 16 lanes take it minutes). Here each becomes
//! one function per lane type that enters its instruction set by itself; the call passes vectors through
//! memory, which costs little beside the routine. Lanes that are wider than a register are halved first: the
//! instructions are the same in another order, and only one function per instruction set remains.

use crate::lanes::{Lanes4, Lanes8, Lanes16};
use fearless_simd::Simd;
use fearless_simd::prelude::*;
use sh_core::{Lane, Routines};

/// A lane type with the large routines of `C` coefficients out of line. Implemented for `f32`, `f64` and the
/// vector lanes, for orders 2 to 6.
pub trait Outline<const C: usize>: Lane
where
    [Self; C]: Routines<Self>,
{
    /// [`Routines::exp_saturating`].
    fn exp_saturating(f: &[Self; C]) -> [Self; C];

    /// [`Routines::product_cosine`].
    fn product_cosine(f: &[Self; C], normal: [Self; 3]) -> [Self; C];
}

macro_rules! scalar {
    ($t:ty, $c:literal, $inline:meta) => {
        impl Outline<$c> for $t {
            #[$inline]
            fn exp_saturating(f: &[Self; $c]) -> [Self; $c] {
                Routines::exp_saturating(f)
            }

            #[$inline]
            fn product_cosine(f: &[Self; $c], normal: [Self; 3]) -> [Self; $c] {
                Routines::product_cosine(f, normal)
            }
        }
    };
}

/// One function that enters its instruction set.
macro_rules! whole {
    ($simd:expr, $call:expr) => {
        $simd.vectorize(
            #[inline(always)]
            || $call,
        )
    };
}

macro_rules! register {
    ($lanes:ident, $c:literal) => {
        impl<S: Simd> Outline<$c> for $lanes<S> {
            #[inline(never)]
            fn exp_saturating(f: &[Self; $c]) -> [Self; $c] {
                whole!(f[0].0.simd, Routines::exp_saturating(f))
            }

            #[inline(never)]
            fn product_cosine(f: &[Self; $c], normal: [Self; 3]) -> [Self; $c] {
                whole!(f[0].0.simd, Routines::product_cosine(f, normal))
            }
        }
    };
}

/// Both halves of every vector in an array.
macro_rules! halves {
    ($vectors:expr, $count:literal) => {{
        let (low, high) = $vectors[0].split();
        let (mut lows, mut highs) = ([low; $count], [high; $count]);
        for (i, vector) in $vectors.iter().enumerate() {
            (lows[i], highs[i]) = vector.split();
        }
        (lows, highs)
    }};
}

/// Both halves in the place of whole vectors of the same type as `$like`.
macro_rules! joined {
    ($like:expr, $low:expr, $high:expr) => {{
        let (low, high) = ($low, $high);
        let mut joined = *$like;
        for (i, whole) in joined.iter_mut().enumerate() {
            *whole = Self::join(low[i], high[i]);
        }
        joined
    }};
}

macro_rules! wide {
    ($lanes:ident, $half:ident, $c:literal) => {
        impl<S: Simd> Outline<$c> for $lanes<S> {
            #[inline(never)]
            fn exp_saturating(f: &[Self; $c]) -> [Self; $c] {
                let simd = f[0].0.simd;
                if const { <S::f32s as SimdBase<S>>::LEN >= Self::COUNT } {
                    return whole!(simd, Routines::exp_saturating(f));
                }
                whole!(simd, {
                    let (low, high) = halves!(f, $c);
                    joined!(f, $half::exp_saturating(&low), $half::exp_saturating(&high))
                })
            }

            #[inline(never)]
            fn product_cosine(f: &[Self; $c], normal: [Self; 3]) -> [Self; $c] {
                let simd = f[0].0.simd;
                if const { <S::f32s as SimdBase<S>>::LEN >= Self::COUNT } {
                    return whole!(simd, Routines::product_cosine(f, normal));
                }
                whole!(simd, {
                    let (low, high) = halves!(f, $c);
                    let (n_low, n_high) = halves!(&normal, 3);
                    let low = $half::product_cosine(&low, n_low);
                    joined!(f, low, $half::product_cosine(&high, n_high))
                })
            }
        }
    };
}

macro_rules! orders {
    ($($c:literal)*) => { $(
        scalar!(f32, $c, inline(never));
        // No pass computes in f64: compiled where somebody uses it.
        scalar!(f64, $c, inline);
        register!(Lanes4, $c);
        wide!(Lanes8, Lanes4, $c);
        wide!(Lanes16, Lanes8, $c);
    )* };
}

orders!(4 9 16 25 36);
