//! What the tests share: cases, the truth of every routine, and calls by name.

pub mod accuracy;
pub mod call;
pub mod case;
pub mod data;
pub mod promises;
pub mod truth;
pub mod worst;

/// Runs a function that is generic over the number of coefficients at every order.
#[macro_export]
macro_rules! every_order {
    ($f:ident) => {
        $f::<4>();
        $f::<9>();
        $f::<16>();
        $f::<25>();
        $f::<36>();
    };
}

/// The README's Rust compiles and runs.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;
