//! The SH exponential of a log visibility, twin of `kernels/shared/exponential.wgsl`.

use crate::outline::Outline;
use sh_core::{ROOT_FOUR_PI, Routines};

/// Halvings that bring any finite norm of f32 (2^128) below 1/4.
const MOST_HALVINGS: u32 = 132;

/// exp*(f) by PS*-2 (Ren et al. 2006, equations 20 to 22): isolate the constant band, halve p times, take the
/// factored series of degree 2, square p times, with the smallest p for which ‖f̂‖ / 2^p < 1/4.
///
/// Two things differ from [`sh_core::exp::ps_star`], and neither in exact arithmetic. The constant band's
/// factor exp(f₀/√4π) is spread over the squarings, 2^-p of it before the first: a sum over hundreds of
/// blockers has a large f̂ and a small factor, and f̂ alone would overflow first. And the squares are calls
/// instead of inlined text, because two copies at order 6 in 16 lanes take the compiler minutes.
#[inline(always)]
pub(crate) fn exponential<L: Outline<C>, const C: usize>(f: &[L; C]) -> [L; C]
where
    [L; C]: Routines<L>,
{
    let (zero, one) = (f[0].lift(0.0), f[0].lift(1.0));
    let (half, quarter) = (zero.lift(0.5), zero.lift(0.25));
    let mut rest = *f;
    rest[0] = zero;
    // Every lane has its own p; the loop ends with the largest.
    let mut norm = rest.dot(&rest).sqrt();
    let mut scale = one;
    let mut halvings = zero;
    let mut most = 0;
    while most < MOST_HALVINGS {
        let small = norm.lt(quarter);
        let finer = L::select(small, scale, scale * half);
        if !L::any(finer.lt(scale)) {
            break;
        }
        halvings = L::select(small, halvings, halvings + one);
        norm = L::select(small, norm, norm * half);
        scale = finer;
        most += 1;
    }
    let constant = (f[0] * scale * zero.lift(1.0 / ROOT_FOUR_PI)).exp();
    for band in &mut rest {
        *band = *band * scale;
    }
    let squared = L::square(&rest);
    let mut g = rest;
    for (g, squared) in g.iter_mut().zip(squared) {
        *g = constant * squared.mul_add(half, *g);
    }
    g[0] = constant.mul_add(zero.lift(ROOT_FOUR_PI), g[0]);
    let mut done = zero;
    for _ in 0..most {
        let squared = L::square(&g);
        let more = done.lt(halvings);
        for (g, squared) in g.iter_mut().zip(squared) {
            *g = L::select(more, squared, *g);
        }
        done = done + one;
    }
    g
}
