//! Which vector path a pass takes.

use fearless_simd::Level;

/// How many receivers are computed side by side.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Width {
    /// One: plain `f32`, compiled for the build's baseline processor.
    One,
    /// Eight: [`crate::lanes::Lanes8`].
    Eight,
    /// Sixteen: [`crate::lanes::Lanes16`]; eight where registers hold four.
    Sixteen,
}

/// A vector path: the instruction set and the number of lanes.
///
/// [`Path::best`] is what the passes take by themselves; any other choice is for tests and benchmarks.
/// Results of different paths agree within rounding and are not the same bits. On x86 a pass is compiled
/// for SSE2 (8 lanes), AVX2 (8 and 16) and AVX-512 (16); a level between two of them runs as the lower.
#[derive(Clone, Copy, Debug)]
pub struct Path {
    /// The instructions to use; the processor is known to have them.
    pub level: Level,
    /// The number of lanes.
    pub width: Width,
}

impl Path {
    /// The fastest path on this processor: one native register a value, so 16 lanes with AVX-512 and 8
    /// elsewhere.
    pub fn best() -> Self {
        let level = Level::new();
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        let wide = level.as_avx512().is_some();
        #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
        let wide = false;
        let width = if wide { Width::Sixteen } else { Width::Eight };
        Self { level, width }
    }

    /// `width` lanes with the best instructions there are.
    pub fn of_width(width: Width) -> Self {
        Self {
            level: Level::new(),
            width,
        }
    }

    /// Every path this processor offers, from the plainest on.
    pub fn all() -> Vec<Self> {
        let mut paths = vec![Self::of_width(Width::One)];
        for level in levels() {
            for width in [Width::Eight, Width::Sixteen] {
                paths.push(Self { level, width });
            }
        }
        paths
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
