//! The truth of a comparison, and how far it is off: half the paths against the other half.

use super::measure::{Figures, Parts, Radiance};
use super::view::Seen;
use crate::Error;
use crate::truth::{self, narrow};
use rayon::prelude::*;
use sh_reference::paths;
use sh_scene::Scene;

/// The mean of two independent halves, and half their difference, whose mean square is that of the mean's own error.
pub struct Truth {
    /// The mean of both.
    pub parts: Parts,
    /// Half their difference.
    pub errors: Parts,
}

impl Truth {
    /// Traces all receivers, so many paths each, rounded up to two halves.
    pub fn trace(
        scene: &Scene,
        seen: &Seen,
        options: paths::Options,
        paths: u32,
        progress: &(dyn Fn(f32) + Sync),
    ) -> Result<Self, Error> {
        let tracer = truth::tracer(scene, options)?;
        let receivers = seen.receivers();
        let half = |number: usize| {
            let tell = |part: f32| progress(0.5 * (number as f32 + part));
            let first = number * receivers.len();
            truth::trace(&tracer, receivers, first, paths.div_ceil(2), &tell)
        };
        let halves = [half(0), half(1)];
        let all = |of: fn(&paths::Radiance) -> [f64; 3], sign: f64| {
            let pairs = halves[0].par_iter().zip(&halves[1]);
            let combined = pairs.map(|(a, b)| {
                let (a, b) = (of(a), of(b));
                narrow([0, 1, 2].map(|c| 0.5 * (a[c] + sign * b[c])))
            });
            combined.collect::<Radiance>()
        };
        let both = |sign: f64| Parts {
            direct: all(|r| r.direct, sign),
            indirect: all(|r| r.indirect, sign),
        };
        Ok(Self {
            parts: both(1.0),
            errors: both(-1.0),
        })
    }

    /// Figures of direct, indirect and all light.
    pub fn figures(&self, seen: &Seen, ours: &Parts, scale: f64) -> [Figures; 3] {
        let figures = |of: fn(&Parts) -> Radiance| {
            let [ours, truth, errors] =
                [ours, &self.parts, &self.errors].map(|parts| seen.covered(&of(parts)));
            Figures::new(&ours, &truth, &errors, scale)
        };
        [
            figures(|parts| parts.direct.clone()),
            figures(|parts| parts.indirect.clone()),
            figures(Parts::total),
        ]
    }
}
