//! What the tests share: cases, the truth of every routine, and calls by name.

pub mod accuracy;
pub mod call;
pub mod case;
pub mod promises;
pub mod truth;

/// The README's Rust compiles and runs.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;
