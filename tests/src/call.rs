//! Generated routines by name and order.

use sh_core::generated;

fn array<L: Copy, const N: usize>(values: &[L]) -> [L; N] {
    values.try_into().expect("a case has the routine's shapes")
}

include!(concat!(env!("OUT_DIR"), "/call.rs"));
