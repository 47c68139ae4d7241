//! The generated routines: for each order n and routine a function `sh{n}_{routine}`, and the trait that
//! finds them by vector length.

#![expect(
    clippy::many_single_char_names,
    clippy::too_many_arguments,
    clippy::double_parens,
    reason = "generated text"
)]

use crate::Lane;

include!(concat!(env!("OUT_DIR"), "/routines.rs"));
