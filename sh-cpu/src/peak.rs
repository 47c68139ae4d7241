//! What the processor can do at most.

use crate::Path;
use crate::lanes::{Lanes1, Lanes4, Lanes8, Lanes16};
use fearless_simd::{Level, Simd};
use sh_core::Lane;
use std::hint::black_box;
use std::time::Instant;

/// Multiply-adds in flight: more than any processor's units times their latency, few enough for 16 registers.
const CHAINS: usize = 12;

/// Fused multiply-adds of `f32` a second on one thread, on the registers of a path: the best of several short runs of a
/// loop that does nothing else. An addition or a multiplication alone costs as much as both together.
///
/// Takes about 20 ms. The scalar path has no fused operation and is measured as a product and a sum.
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
    match path {
        Path::Scalar | Path::One(_) => 1,
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Path::Vector(level) if level.as_avx512().is_some() => {
            Lanes16::<fearless_simd::Avx512>::COUNT
        }
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Path::Vector(level) if level.as_avx2().is_some() => Lanes8::<fearless_simd::Avx2>::COUNT,
        Path::Vector(_) => 4,
    }
}

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn run(path: Path, rounds: usize, factor: f32) -> f32 {
    macro_rules! with {
        ($simd:expr, $lanes:ident, $count:literal) => {{
            let simd = $simd;
            simd.vectorize(
                #[inline(always)]
                || chains($lanes::from_array(simd, [factor; $count]), rounds).to_array()[0],
            )
        }};
    }
    match path {
        Path::Scalar => chains(factor, rounds),
        Path::One(level) => match (level.as_avx2(), level.as_sse2()) {
            (Some(avx2), _) => with!(avx2, Lanes1, 1),
            (None, Some(sse2)) => with!(sse2, Lanes1, 1),
            (None, None) => chains(factor, rounds),
        },
        Path::Vector(level) => {
            if let Some(avx512) = Level::as_avx512(level) {
                with!(avx512, Lanes16, 16)
            } else if let Some(avx2) = level.as_avx2() {
                with!(avx2, Lanes8, 8)
            } else if let Some(sse2) = level.as_sse2() {
                with!(sse2, Lanes4, 4)
            } else {
                chains(factor, rounds)
            }
        }
    }
}

#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
fn run(path: Path, rounds: usize, factor: f32) -> f32 {
    match path {
        Path::Scalar => chains(factor, rounds),
        Path::One(level) => fearless_simd::dispatch!(level, simd => {
            chains(Lanes1::from_array(simd, [factor; 1]), rounds).to_array()[0]
        }),
        Path::Vector(level) => fearless_simd::dispatch!(level, simd => {
            chains(Lanes4::from_array(simd, [factor; 4]), rounds).to_array()[0]
        }),
    }
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
