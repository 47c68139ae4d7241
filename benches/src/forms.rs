//! All forms of product and square, for every order n: `sh{n}_product_direct`, `sh{n}_product_rings`,
//! `sh{n}_square_direct`, `sh{n}_square_rings`.

use sh_core::Lane;

include!(concat!(env!("OUT_DIR"), "/forms.rs"));
