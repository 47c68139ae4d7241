//! Which vector path a pass takes.

use fearless_simd::Level;

/// How many receivers are computed side by side, and with which instructions.
///
/// [`Path::best`] is what the passes take by themselves; any other choice is for tests and benchmarks.
/// Results of different paths agree within rounding and are not the same bits.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub enum Path {
    /// One, with the instructions of this level, fused multiply-adds above all ([`crate::lanes::Lanes1`]): what
    /// vectors are compared with. With the feature `one-lane`, as it takes nearly as long to build as the vectors.
    #[cfg(feature = "one-lane")]
    One(Level),
    /// As many as a register of this level holds; the processor is known to have its instructions.
    ///
    /// On x86 a pass is compiled for SSE2 ([`crate::lanes::Lanes4`]), AVX2 ([`crate::lanes::Lanes8`]) and
    /// AVX-512 ([`crate::lanes::Lanes16`]), and a level between two of them runs as the lower. Elsewhere
    /// registers hold four.
    Vector(Level),
}

impl Path {
    /// The fastest path on this processor.
    pub fn best() -> Self {
        Self::Vector(Level::new())
    }

    /// Every path this processor offers, from the plainest on.
    pub fn all() -> Vec<Self> {
        let mut all = Vec::new();
        #[cfg(feature = "one-lane")]
        all.push(Self::One(Level::new()));
        all.extend(levels().into_iter().map(Self::Vector));
        all
    }
}

/// Every level this processor offers, from the plainest on.
pub fn levels() -> Vec<Level> {
    let best = Level::new();
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    {
        let lower = [
            best.as_sse2().map(Level::Sse2),
            best.as_sse4_2().map(Level::Sse4_2),
            best.as_avx2().map(Level::Avx2),
            best.as_avx512().map(Level::Avx512),
        ];
        let found: Vec<Level> = lower.into_iter().flatten().collect();
        if !found.is_empty() {
            return found;
        }
    }
    vec![best]
}
