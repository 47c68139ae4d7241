//! What spheres send to receivers.

use super::accumulate::{Point, look, seen_from};
use super::emission::Emission;
use super::light::reflected;
use super::light_cut::Met;
use super::order::power;
use super::vectors::each;
use sh_core::seen::Seen;
use sh_core::{Lane, Routines};

/// Receivers that light comes to.
#[derive(Clone, Copy)]
pub(super) struct At<'a, L> {
    pub(super) point: Point<L>,
    pub(super) lights: &'a Emission,
    sum: [L; 3],
}

impl<'a, L: Lane> At<'a, L> {
    #[inline(always)]
    pub(super) fn new(point: &Point<L>, lights: &'a Emission) -> Self {
        Self {
            point: *point,
            lights,
            sum: [point.object.lift(0.0); 3],
        }
    }

    #[inline(always)]
    pub(super) fn look(&self, met: &Met) -> Seen<L>
    where
        [L; 4]: Routines<L>,
    {
        look(&met.blocker, met.in_front, &self.point)
    }

    /// Their power against a sphere.
    #[inline(always)]
    pub(super) fn power(&self, met: &Met) -> L {
        power(
            seen_from(&met.blocker.center, &self.point),
            met.blocker.radius,
        )
    }

    /// Adds what a sphere gives of which `visible` is seen, the cosine included.
    #[inline(always)]
    pub(super) fn add<const C: usize>(&mut self, met: &Met, seen: &Seen<L>, visible: L)
    where
        [L; C]: Routines<L>,
    {
        let zero = visible.lift(0.0);
        let back = [-seen.direction[0], -seen.direction[1], -seen.direction[2]];
        let weights = <[L; C]>::ball_average(seen.sine, seen.cosine, back);
        let mean = reflected(&weights, self.lights.of(met.node));
        let most = self.lights.brightest_of(met.node);
        let visible = visible.max(zero);
        for (c, sum) in self.sum.iter_mut().enumerate() {
            let mean = mean[c].max(zero).min(zero.lift(f64::from(most[c])));
            *sum = (visible * zero.lift(f64::from(met.gain[c]))).mul_add(mean, *sum);
        }
    }

    /// What was added, between 0 and the brightest of all lights.
    #[inline(always)]
    pub(super) fn bounded(&self) -> [L; 3] {
        let zero = self.point.object.lift(0.0);
        let brightest = self.lights.brightest();
        each(
            #[inline(always)]
            |c| {
                let most = zero.lift(f64::from(brightest[c]));
                // What is not a number fails the comparison.
                L::select(zero.lt(self.sum[c]), self.sum[c].min(most), zero)
            },
        )
    }
}
