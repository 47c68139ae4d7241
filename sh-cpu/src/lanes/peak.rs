//! What the processor can do at most.

use super::enter;
use super::group::Group;
use super::path::Path;
use sh_core::Lane;
use std::hint::black_box;
use std::time::Instant;

/// Multiply-adds in flight: more than any processor's units times their latency, few enough for 16 registers.
const CHAINS: usize = 12;

/// Fused multiply-adds of `f32` a second on one thread, on the registers of a path: the best of several short runs of a
/// loop that does nothing else. An addition or a multiplication alone costs as much as both together.
///
/// Takes about 20 ms. Where a level has no fused operation (SSE2), a product and a sum are measured.
pub fn multiply_adds_per_second(path: Path) -> f64 {
    const ROUNDS: usize = 100_000;
    let mut best = f64::INFINITY;
    for _ in 0..20 {
        let start = Instant::now();
        let sum = run(path, black_box(ROUNDS), black_box(0.999_9));
        let seconds = start.elapsed().as_secs_f64();
        black_box(sum);
        best = best.min(seconds);
    }
    (ROUNDS * CHAINS * lanes(path)) as f64 / best
}

/// How many numbers a path computes side by side.
pub fn lanes(path: Path) -> usize {
    fn count<G: Group>(_: G::Token) -> usize {
        G::COUNT
    }
    enter!(path, Lanes, simd => count::<Lanes<_>>(simd))
}

fn run(path: Path, rounds: usize, factor: f32) -> f32 {
    enter!(path, Lanes, simd => first(chains(Lanes::from_array(simd, [factor; _]), rounds)))
}

#[inline(always)]
fn first<G: Group>(all: G) -> f32 {
    all.store().as_ref()[0]
}

#[inline(always)]
fn chains<L: Lane>(factor: L, rounds: usize) -> L {
    let mut sums = [factor; CHAINS];
    for _ in 0..rounds {
        for sum in &mut sums {
            *sum = sum.mul_add(factor, factor);
        }
    }
    let mut total = sums[0];
    for sum in &sums[1..] {
        total = total + *sum;
    }
    total
}
