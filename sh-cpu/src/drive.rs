//! Running a kernel over receivers: lanes side by side, groups of lanes in chunks, chunks on threads.
//!
//! ```text
//! receivers  |---- chunk ----|---- chunk ----|--     one task of the thread pool each
//!            |8|8|8|8|8|8|8|8|                       one call of the kernel each (4, 8 or 16 lanes)
//! ```
//! Chunks and groups lie at fixed places, so the result does not depend on the number of threads. A chunk
//! allocates nothing.

use crate::lanes::{Lanes4, Lanes8, Lanes16};
use crate::outline::{Outline, OutlineAll};
use crate::resolve::check_length;
use crate::{Error, Path};
use fearless_simd::{Level, Simd};
use rayon::prelude::*;
use sh_core::{Lane, Routines};
use sh_scene::{Light, Receiver};

/// Receivers a task: some hundred microseconds of work with a hundred blockers.
const CHUNK: usize = 256;

/// The lowest and the highest SH order that there are routines for.
const MIN_ORDER: usize = 2;
pub(crate) const MAX_ORDER: usize = 6;

/// What is computed for a receiver.
pub(crate) trait Kernel: Sync {
    /// Red, green and blue radiance reflected by albedo 1. `C` is the number of SH coefficients.
    fn shade<L: OutlineAll + Outline<C>, const C: usize>(
        &self,
        position: [L; 3],
        normal: [L; 3],
    ) -> [L; 3]
    where
        [L; C]: Routines<L>;
}

/// A lane type that is loaded and stored number by number.
trait Group: Lane {
    /// Numbers side by side.
    const COUNT: usize;
    /// The proof that the processor has the instructions.
    type Token: Copy;
    fn gather(token: Self::Token, value: impl Fn(usize) -> f32) -> Self;
    fn scatter(self, take: impl FnMut(usize, f32));
}

impl Group for f32 {
    const COUNT: usize = 1;
    type Token = ();
    #[inline(always)]
    fn gather((): (), value: impl Fn(usize) -> f32) -> Self {
        value(0)
    }
    #[inline(always)]
    fn scatter(self, mut take: impl FnMut(usize, f32)) {
        take(0, self);
    }
}

macro_rules! group {
    ($lanes:ident) => {
        impl<S: Simd> Group for $lanes<S> {
            const COUNT: usize = $lanes::<S>::COUNT;
            type Token = S;
            #[inline(always)]
            fn gather(token: S, value: impl Fn(usize) -> f32) -> Self {
                let mut values = [0.0; _];
                for (i, slot) in values.iter_mut().enumerate() {
                    *slot = value(i);
                }
                Self::from_array(token, values)
            }
            #[inline(always)]
            fn scatter(self, mut take: impl FnMut(usize, f32)) {
                for (i, value) in self.to_array().into_iter().enumerate() {
                    take(i, value);
                }
            }
        }
    };
}

group!(Lanes4);
group!(Lanes8);
group!(Lanes16);

/// Calls `groups` within the instruction set of `$path`, in lanes that fill its registers. `dispatch!` would
/// compile every level; on x86 these are the ones that somebody runs.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
macro_rules! enter {
    ($path:expr, $receivers:expr, $radiance:expr, $kernel:expr, $k:ty, $c:literal) => {{
        macro_rules! with {
            ($simd:expr, $lanes:ident) => {{
                let simd = $simd;
                simd.vectorize(
                    #[inline(always)]
                    || groups::<$lanes<_>, $k, $c>(simd, $receivers, $radiance, $kernel),
                )
            }};
        }
        let level = match $path {
            Path::Scalar => None,
            Path::Vector(level) => Some(level),
        };
        // A level has those below it.
        if let Some(avx512) = level.and_then(Level::as_avx512) {
            with!(avx512, Lanes16)
        } else if let Some(avx2) = level.and_then(Level::as_avx2) {
            with!(avx2, Lanes8)
        } else if let Some(sse2) = level.and_then(Level::as_sse2) {
            with!(sse2, Lanes4)
        } else {
            groups::<f32, $k, $c>((), $receivers, $radiance, $kernel)
        }
    }};
}

#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
macro_rules! enter {
    ($path:expr, $receivers:expr, $radiance:expr, $kernel:expr, $k:ty, $c:literal) => {
        match $path {
            Path::Scalar => groups::<f32, $k, $c>((), $receivers, $radiance, $kernel),
            Path::Vector(level) => fearless_simd::dispatch!(level, simd => {
                groups::<Lanes4<_>, $k, $c>(simd, $receivers, $radiance, $kernel)
            }),
        }
    };
}

/// What runs one chunk with `$c` coefficients. (A macro, because a generic function cannot say that its number
/// of coefficients suits every instruction set.)
macro_rules! chunk_of {
    ($k:ty, $c:literal) => {
        |path, receivers, radiance, kernel| enter!(path, receivers, radiance, kernel, $k, $c)
    };
}

/// Runs `kernel` for every receiver. Radiance is 0 where a receiver is not covered.
pub(crate) fn drive<K: Kernel>(
    path: Path,
    receivers: &[Receiver],
    light: &Light,
    radiance: &mut [[f32; 3]],
    kernel: &K,
) -> Result<(), Error> {
    check_length("radiance", receivers.len(), radiance.len())?;
    check_light(light)?;
    let run: fn(Path, &[Receiver], &mut [[f32; 3]], &K) = match light.order {
        2 => chunk_of!(K, 4),
        3 => chunk_of!(K, 9),
        4 => chunk_of!(K, 16),
        5 => chunk_of!(K, 25),
        6 => chunk_of!(K, 36),
        order => return Err(Error::Order { order }),
    };
    receivers
        .par_chunks(CHUNK)
        .zip(radiance.par_chunks_mut(CHUNK))
        .for_each(|(receivers, radiance)| run(path, receivers, radiance, kernel));
    Ok(())
}

/// Whether a light is of an order that there is, and whole.
pub(crate) fn check_light(light: &Light) -> Result<(), Error> {
    let (order, found) = (light.order, light.coefficients.len());
    if !(MIN_ORDER..=MAX_ORDER).contains(&order) {
        return Err(Error::Order { order });
    }
    if found != order * order {
        return Err(Error::Coefficients { order, found });
    }
    Ok(())
}

/// One chunk, group by group. A lane whose receiver is not covered, or missing at the end, repeats the
/// group's first covered one, so that it neither adds work nor brings in numbers that mean nothing.
#[inline(always)]
fn groups<G: Group + OutlineAll + Outline<C>, K: Kernel, const C: usize>(
    token: G::Token,
    receivers: &[Receiver],
    radiance: &mut [[f32; 3]],
    kernel: &K,
) where
    [G; C]: Routines<G>,
{
    for (receivers, radiance) in receivers
        .chunks(G::COUNT)
        .zip(radiance.chunks_mut(G::COUNT))
    {
        radiance.fill([0.0; 3]);
        let Some(spare) = receivers.iter().find(|receiver| receiver.covered != 0) else {
            continue;
        };
        let at = |i: usize| {
            receivers
                .get(i)
                .filter(|receiver| receiver.covered != 0)
                .unwrap_or(spare)
        };
        // Plain loops and array literals: closures of the standard library's array functions are not always
        // inlined, and would be compiled without the instruction set.
        let position = |k: usize| G::gather(token, |i| at(i).position[k]);
        let normal = |k: usize| G::gather(token, |i| at(i).normal[k]);
        let position = [position(0), position(1), position(2)];
        let normal = [normal(0), normal(1), normal(2)];
        let shaded = kernel.shade::<G, C>(position, normal);
        for (k, channel) in shaded.into_iter().enumerate() {
            channel.scatter(|i, value| {
                if receivers
                    .get(i)
                    .is_some_and(|receiver| receiver.covered != 0)
                {
                    radiance[i][k] = value;
                }
            });
        }
    }
}
