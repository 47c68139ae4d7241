//! The generated routines: for each order n and routine a function `sh{n}_{routine}`, and the trait that
//! finds them by vector length.

#![expect(
    clippy::approx_constant,
    clippy::let_and_return,
    reason = "generated text names every value and writes every constant out"
)]

use crate::Lane;

include!(concat!(env!("OUT_DIR"), "/routines.rs"));
