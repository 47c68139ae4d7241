//! What SH vectors reflect of a light's.

use sh_core::{Lane, Routines};

/// max(0, L_c · H(N)) for the three channels.
#[inline(always)]
pub(crate) fn unblocked<L: Lane, const C: usize>(lobe: &[L; C], light: &[[f32; 3]]) -> [L; 3]
where
    [L; C]: Routines<L>,
{
    let zero = lobe[0].lift(0.0);
    let [red, green, blue] = reflected(lobe, light);
    [red.max(zero), green.max(zero), blue.max(zero)]
}

/// The light's three channels, the first of `K`, dotted with an SH vector.
#[inline(always)]
pub(crate) fn reflected<L: Lane, const C: usize, const K: usize>(
    f: &[L; C],
    light: &[[f32; K]],
) -> [L; 3] {
    let zero = f[0].lift(0.0);
    let mut sum = [zero; 3];
    for (coefficient, light) in f.iter().zip(light) {
        for (sum, &light) in sum.iter_mut().zip(light) {
            *sum = coefficient.mul_add(zero.lift(f64::from(light)), *sum);
        }
    }
    sum
}
