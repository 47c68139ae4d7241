//! All forms of product and square, for every order n: `sh{n}_product_direct`, `sh{n}_product_rings`,
//! `sh{n}_square_direct`, `sh{n}_square_rings`.

#![expect(
    clippy::many_single_char_names,
    clippy::double_parens,
    reason = "generated text"
)]

use sh_core::Lane;

include!(concat!(env!("OUT_DIR"), "/forms.rs"));
