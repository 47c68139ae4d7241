//! Batches: arrays of vectors, laid out so that lanes load what lies side by side.
//!
//! With W lanes and I numbers a vector, W vectors form a group:
//!
//! ```text
//! group 0: number 0 of vectors 0..W | number 1 of vectors 0..W | … | number I−1 of vectors 0..W
//! group 1: number 0 of vectors W..2W | …
//! ```
//! For W = 1 that is an array of vectors.

use crate::fused::Fused;
use fearless_simd::Simd;
use sh_core::Lane;
use sh_cpu::lanes::{Lanes8, Lanes16};

/// A lane type that is loaded from a slice and stored to one.
pub trait Group: Lane {
    /// Numbers side by side.
    const COUNT: usize;
    /// The proof that the processor has the instructions.
    type Token: Copy;
    /// The first `COUNT` numbers of `from`.
    fn load(token: Self::Token, from: &[f32]) -> Self;
    /// Writes the first `COUNT` numbers of `to`.
    fn store(self, to: &mut [f32]);
}

impl Group for f32 {
    const COUNT: usize = 1;
    type Token = ();
    #[inline(always)]
    fn load((): (), from: &[f32]) -> Self {
        from[0]
    }
    #[inline(always)]
    fn store(self, to: &mut [f32]) {
        to[0] = self;
    }
}

impl Group for Fused {
    const COUNT: usize = 1;
    type Token = ();
    #[inline(always)]
    fn load((): (), from: &[f32]) -> Self {
        Self(from[0])
    }
    #[inline(always)]
    fn store(self, to: &mut [f32]) {
        to[0] = self.0;
    }
}

macro_rules! group {
    ($lanes:ident, $count:literal) => {
        impl<S: Simd> Group for $lanes<S> {
            const COUNT: usize = $count;
            type Token = S;
            #[inline(always)]
            fn load(token: S, from: &[f32]) -> Self {
                Self::from_array(token, *from.first_chunk().expect("a whole group"))
            }
            #[inline(always)]
            fn store(self, to: &mut [f32]) {
                *to.first_chunk_mut().expect("a whole group") = self.to_array();
            }
        }
    };
}

group!(Lanes8, 8);
group!(Lanes16, 16);

/// Applies `routine` to a batch, group by group; an incomplete last group is left out.
#[inline(always)]
pub fn sweep<G: Group, const I: usize, const O: usize>(
    token: G::Token,
    input: &[f32],
    output: &mut [f32],
    routine: impl Fn(&[G; I]) -> [G; O],
) {
    let groups = input.chunks_exact(I * G::COUNT);
    for (input, output) in groups.zip(output.chunks_exact_mut(O * G::COUNT)) {
        // Without a barrier the compiler computes neighbouring scalar calls side by side, which it cannot do
        // in a pass that branches: one at a time should mean that.
        core::hint::black_box(());
        let x: [G; I] = core::array::from_fn(|i| G::load(token, &input[i * G::COUNT..]));
        for (y, to) in routine(&x).iter().zip(output.chunks_exact_mut(G::COUNT)) {
            y.store(to);
        }
    }
}

/// `count` numbers in −1..1, the same for every run.
pub fn numbers(count: usize) -> Vec<f32> {
    let mut state = 1_u32;
    (0..count)
        .map(|_| {
            // Numerical Recipes' generator; its upper bits are good enough for data.
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as f32 / (1_u32 << 23) as f32 - 1.0
        })
        .collect()
}
