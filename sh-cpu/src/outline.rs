//! Generated routines as functions of their own.
//!
//! Generated routines are inlined so that they take over the caller's instruction set. The largest of them,
//! some thousand operations, must not be copied into every place that uses them: the compiler's time grows
//! faster than the function (two products of order 6 inlined in 16 lanes take it minutes). Here each becomes
//! one function per lane type that enters its instruction set by itself; the call passes vectors through
//! memory, which costs little beside the routine.

use crate::lanes::{Lanes4, Lanes8, Lanes16};
use crate::shadow::visibility_past;
use fearless_simd::Simd;
use sh_core::{Lane, Routines};
use sh_scene::Sphere;

/// A lane type with the large routines of `C` coefficients out of line. Implemented for `f32`, `f64` and the
/// vector lanes, for orders 2 to 6; [`OutlineAll`] stands for all five orders.
pub trait Outline<const C: usize>: Lane
where
    [Self; C]: Routines<Self>,
{
    /// The visibility past all `spheres`: their logarithms, summed and exponentiated with `C` coefficients.
    fn visibility(position: [Self; 3], normal: [Self; 3], spheres: &[Sphere]) -> [Self; C];

    /// [`Routines::product_cosine`].
    fn product_cosine(f: &[Self; C], normal: [Self; 3]) -> [Self; C];
}

/// A lane type with [`Outline`] for orders 2 to 6.
pub trait OutlineAll: Outline<4> + Outline<9> + Outline<16> + Outline<25> + Outline<36> {}

impl<L> OutlineAll for L where L: Outline<4> + Outline<9> + Outline<16> + Outline<25> + Outline<36> {}

macro_rules! scalar {
    ($t:ty, $c:literal, $inline:meta) => {
        impl Outline<$c> for $t {
            #[$inline]
            fn visibility(
                position: [Self; 3],
                normal: [Self; 3],
                spheres: &[Sphere],
            ) -> [Self; $c] {
                visibility_past(position, normal, spheres)
            }

            #[$inline]
            fn product_cosine(f: &[Self; $c], normal: [Self; 3]) -> [Self; $c] {
                Routines::product_cosine(f, normal)
            }
        }
    };
}

macro_rules! vector {
    ($lanes:ident, $c:literal) => {
        impl<S: Simd> Outline<$c> for $lanes<S> {
            #[inline(never)]
            fn visibility(
                position: [Self; 3],
                normal: [Self; 3],
                spheres: &[Sphere],
            ) -> [Self; $c] {
                position[0].0.simd.vectorize(
                    #[inline(always)]
                    || visibility_past(position, normal, spheres),
                )
            }

            #[inline(never)]
            fn product_cosine(f: &[Self; $c], normal: [Self; 3]) -> [Self; $c] {
                f[0].0.simd.vectorize(
                    #[inline(always)]
                    || Routines::product_cosine(f, normal),
                )
            }
        }
    };
}

macro_rules! orders {
    ($($c:literal)*) => { $(
        scalar!(f32, $c, inline(never));
        // No pass computes in f64: compiled where somebody uses it.
        scalar!(f64, $c, inline);
        vector!(Lanes4, $c);
        vector!(Lanes8, $c);
        vector!(Lanes16, $c);
    )* };
}

orders!(4 9 16 25 36);
