//! Vectors of lanes.

use sh_core::Lane;

/// Three values. (The standard library's `from_fn` is not always inlined, and would then be compiled without
/// the instruction set.)
#[inline(always)]
pub(crate) fn each<L>(value: impl Fn(usize) -> L) -> [L; 3] {
    [value(0), value(1), value(2)]
}

#[inline(always)]
pub(crate) fn dot<L: Lane>(a: [L; 3], b: [L; 3]) -> L {
    a[0].mul_add(b[0], a[1].mul_add(b[1], a[2] * b[2]))
}
