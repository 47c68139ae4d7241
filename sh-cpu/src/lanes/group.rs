//! Lanes, number by number.

use super::{Lanes1, Lanes4, Lanes8, Lanes16};
use fearless_simd::Simd;
use sh_core::Lane;

/// A lane type that is loaded and stored number by number.
pub(crate) trait Group: Lane {
    /// Numbers side by side.
    const COUNT: usize;
    /// Something of each lane.
    type Of<T: Copy + Sync>: Copy + AsRef<[T]> + Sync;
    /// The proof that the processor has the instructions.
    type Token: Copy + Sync;
    fn each<T: Copy + Sync>(value: impl Fn(usize) -> T) -> Self::Of<T>;
    fn gather(token: Self::Token, value: impl Fn(usize) -> f32) -> Self;
    fn store(self) -> Self::Of<f32>;
}

macro_rules! group {
    ($lanes:ident, $count:literal) => {
        impl<S: Simd> Group for $lanes<S> {
            const COUNT: usize = $count;
            type Of<T: Copy + Sync> = [T; $count];
            type Token = S;
            #[inline(always)]
            fn each<T: Copy + Sync>(value: impl Fn(usize) -> T) -> [T; $count] {
                let mut all = [value(0); $count];
                for (i, slot) in all.iter_mut().enumerate() {
                    *slot = value(i);
                }
                all
            }
            #[inline(always)]
            fn gather(token: S, value: impl Fn(usize) -> f32) -> Self {
                let mut values = [0.0; _];
                for (i, slot) in values.iter_mut().enumerate() {
                    *slot = value(i);
                }
                Self::from_array(token, values)
            }
            #[inline(always)]
            fn store(self) -> [f32; $count] {
                self.to_array()
            }
        }
    };
}

group!(Lanes1, 1);
group!(Lanes4, 4);
group!(Lanes8, 8);
group!(Lanes16, 16);
