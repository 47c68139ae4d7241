//! Entering the instruction set of a path.

/// Evaluates `$body` within the instruction set of `$path`: in it `$lanes` is the lane type that fills a register, and
/// `$simd` the proof that the processor has the instructions. (A macro, because a generic closure cannot be written down.)
///
/// `fearless_simd::dispatch!` would compile every level; on x86 these are the ones that somebody runs.
#[cfg(all(
    any(target_arch = "x86", target_arch = "x86_64"),
    target_feature = "sse2"
))]
macro_rules! enter {
    ($path:expr, $lanes:ident, $simd:ident => $body:expr) => {{
        use fearless_simd::{Level, Simd};
        use $crate::lanes::path::Path;
        macro_rules! with {
            ($level:expr, $of:ident) => {{
                use $crate::lanes::$of as $lanes;
                let $simd = $level;
                $simd.vectorize(
                    #[inline(always)]
                    || $body,
                )
            }};
        }
        match $path {
            #[cfg(feature = "one-lane")]
            Path::One(level) => match (Level::as_avx2(level), level.as_sse2()) {
                (Some(avx2), _) => with!(avx2, Lanes1),
                (None, Some(sse2)) => with!(sse2, Lanes1),
                (None, None) => unreachable!("the build's baseline has SSE2"),
            },
            // A level has those below it.
            Path::Vector(level) => {
                if let Some(avx512) = Level::as_avx512(level) {
                    with!(avx512, Lanes16)
                } else if let Some(avx2) = level.as_avx2() {
                    with!(avx2, Lanes8)
                } else if let Some(sse2) = level.as_sse2() {
                    with!(sse2, Lanes4)
                } else {
                    unreachable!("the build's baseline has SSE2")
                }
            }
        }
    }};
}

#[cfg(not(all(
    any(target_arch = "x86", target_arch = "x86_64"),
    target_feature = "sse2"
)))]
macro_rules! enter {
    ($path:expr, $lanes:ident, $simd:ident => $body:expr) => {{
        use $crate::lanes::path::Path;
        match $path {
            #[cfg(feature = "one-lane")]
            Path::One(level) => fearless_simd::dispatch!(level, $simd => {
                use $crate::lanes::Lanes1 as $lanes;
                $body
            }),
            Path::Vector(level) => fearless_simd::dispatch!(level, $simd => {
                use $crate::lanes::Lanes4 as $lanes;
                $body
            }),
        }
    }};
}

pub(crate) use enter;
