//! sh-core without a standard library.

#![no_std]

use sh_core::{Sh3, exp};

/// The visibility behind blockers whose logarithms add up to `sum`.
pub fn visible(sum: &Sh3) -> Sh3 {
    Sh3::from(exp::hyb(&sum.0))
}
