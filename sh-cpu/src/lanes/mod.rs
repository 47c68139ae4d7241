//! Vector lanes: 4, 8 or 16 `f32` side by side, for the generated routines.
//!
//! [`Lanes1`] is one number with the same instructions, to compare with.
//!
//! [`Lanes4`], [`Lanes8`] and [`Lanes16`] wrap the vectors of `fearless_simd`. Which instructions they become is
//! decided by the level `S` that they carry (SSE2 to AVX-512, Neon, wasm), and everything here is
//! `#[inline(always)]`: code written against [`sh_core::Lane`] turns into those instructions when, and only when,
//! it is inlined into a function that `fearless_simd::dispatch!` has entered.
//!
//! Registers that a value takes; the passes compute with those that take one:
//!
//! | level | [`Lanes4`] | [`Lanes8`] | [`Lanes16`] | `mul_add` |
//! |---|---|---|---|---|
//! | SSE2, SSE4.2 | 1 | 2 | 4 | two roundings |
//! | AVX2 | half | 1 | 2 | fused |
//! | AVX-512 | quarter | half | 1 | fused |
//! | Neon | 1 | 2 | 4 | fused |

mod enter;
pub(crate) mod group;
mod one;
pub(crate) mod path;
pub(crate) mod peak;
mod vector;

pub(crate) use enter::enter;
pub use one::Lanes1;
pub use vector::{Lanes4, Lanes8, Lanes16};
