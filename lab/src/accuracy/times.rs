//! Times of the methods, on one thread: what all blockers of a receiver cost, and the exponential of their sum.
//!
//! The smallest of several runs counts: other work on the machine only ever adds. Lanes are those of AVX2, where
//! the processor has it.

use super::lanes::{self, Blockers};
use super::methods::Method;
use super::sets::{Sets, logs};
use gaunt::exponential::Exponential;
use sh_core::Routines;
use sh_core::exp::{Calls, Outlined};
use std::collections::HashMap;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Vectors and blockers that are timed.
const COUNT: usize = 256;

/// Runs of which the fastest counts.
const RUNS: usize = 7;

/// No more runs after this time.
const ENOUGH: Duration = Duration::from_millis(60);

/// Nanoseconds for each of `count` things that `run` does.
fn fastest(count: usize, mut run: impl FnMut()) -> f64 {
    let start = Instant::now();
    let mut best = f64::INFINITY;
    for _ in 0..RUNS {
        let before = Instant::now();
        run();
        best = best.min(before.elapsed().as_nanos() as f64);
        if start.elapsed() > ENOUGH {
            break;
        }
    }
    best / count as f64
}

/// Measured once each: the cost of a blocker, and of an exponential.
pub struct Times<'a> {
    sets: &'a Sets,
    known: HashMap<String, [Option<f64>; 2]>,
}

impl<'a> Times<'a> {
    /// Nothing measured yet.
    pub fn new(sets: &'a Sets) -> Self {
        Self {
            sets,
            known: HashMap::new(),
        }
    }

    /// Nanoseconds a receiver by backend.
    pub fn of<const C: usize>(&mut self, method: &Method) -> [(&'static str, Option<f64>); 2]
    where
        Self: Measure<C>,
    {
        let sum = match method.exponential {
            None => "product",
            Some(Exponential::Saturating) => "saturating",
            Some(_) => "logarithm",
        };
        let blocker = self.once(sum.into(), |times| times.blocker(method.exponential));
        let after = match method.exponential {
            None => [Some(0.0); 2],
            Some(exponential) => self.once(format!("{exponential:?}"), |times| {
                times.exponential(exponential)
            }),
        };
        let blockers = self.sets.mean_blockers();
        let total = |i: usize| Some(blocker[i]? * blockers + after[i]?);
        [("scalar", total(0)), ("lanes", total(1))]
    }

    fn once(
        &mut self,
        name: String,
        measure: impl Fn(&Self) -> [Option<f64>; 2],
    ) -> [Option<f64>; 2] {
        if let Some(known) = self.known.get(&name) {
            return *known;
        }
        let measured = measure(self);
        self.known.insert(name, measured);
        measured
    }

    fn blockers(&self) -> Vec<Blockers<f32>> {
        let all = self.sets.random().iter().flatten().cycle();
        all.take(COUNT)
            .map(|cap| Blockers {
                sin: cap.angle.sin() as f32,
                cos: cap.angle.cos() as f32,
                axis: cap.axis.map(|x| x as f32),
            })
            .collect()
    }
}

/// What is measured at an order, nanoseconds in scalar numbers and in lanes.
pub trait Measure<const C: usize> {
    /// A blocker's part in the sum, or in the product where there is no exponential.
    fn blocker(&self, method: Option<Exponential>) -> [Option<f64>; 2];
    /// An exponential.
    fn exponential(&self, method: Exponential) -> [Option<f64>; 2];
}

/// All blockers together, one number at a time.
#[inline(never)]
fn together<const C: usize>(method: Option<Exponential>, blockers: &[Blockers<f32>]) -> [f32; C]
where
    [f32; C]: Routines<f32>,
{
    let mut sum = [0.0_f32; C];
    for b in blockers {
        sum = match method {
            None => {
                let zonal = <[f32; C]>::cap_visibility(b.cos, b.sin);
                let single = <[f32; C]>::zonal(zonal, b.axis);
                <Outlined as Calls<f32, C>>::product(&sum, &single)
            }
            Some(Exponential::Saturating) => sum.add_cap_log_saturating(b.sin, b.cos, b.axis),
            Some(_) => sum.add_cap_log(b.sin, b.cos, b.axis),
        };
    }
    sum
}

/// The instruction set that lanes are measured in.
macro_rules! with_lanes {
    ($simd:ident => $body:expr) => {{
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        {
            fearless_simd::Level::new()
                .as_avx2()
                .and_then(|$simd| $body)
        }
        #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
        {
            None
        }
    }};
}

macro_rules! measure {
    ($($c:literal)*) => { $(
        impl Measure<$c> for Times<'_> {
            fn blocker(&self, method: Option<Exponential>) -> [Option<f64>; 2] {
                let blockers = self.blockers();
                let scalar = fastest(COUNT, || {
                    black_box(together::<$c>(method, black_box(&blockers)));
                });
                let lanes = with_lanes!(simd => {
                    let groups: Vec<_> = (0..COUNT)
                        .map(|i| lanes::blocker(simd, |k| blockers[(i + 31 * k) % COUNT]))
                        .collect();
                    let nothing = lanes::nothing::<_, $c>(simd);
                    Some(fastest(COUNT * lanes::WIDTH, || {
                        black_box(lanes::together(method, &nothing, black_box(&groups)));
                    }))
                });
                [Some(scalar), lanes]
            }

            fn exponential(&self, method: Exponential) -> [Option<f64>; 2] {
                let vectors: Vec<[f32; $c]> = logs(self.sets, method.fit())[..COUNT].to_vec();
                // Eigenanalyses take long, and take as long for each.
                let count = if method == Exponential::Eigen { COUNT / 8 } else { COUNT };
                let scalar = fastest(count, || {
                    for f in black_box(&vectors[..count]) {
                        black_box(method.of(f));
                    }
                });
                let lanes = with_lanes!(simd => {
                    let groups = lanes::groups(simd, &vectors);
                    lanes::exponential(method, &groups[0])?;
                    Some(fastest(COUNT, || {
                        for f in black_box(&groups) {
                            black_box(lanes::exponential(method, f));
                        }
                    }))
                });
                [Some(scalar), lanes]
            }
        }
    )* };
}

measure!(4 9 16 25 36);
