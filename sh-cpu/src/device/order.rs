//! In which order spheres hide each other: [`sh_scene::order`], in lanes.

use super::vectors::dot;
use sh_core::Lane;

/// The power of receivers against a sphere whose centre is so far `away` from them: [`sh_scene::order::Ball::power`].
#[inline(always)]
pub(super) fn power<L: Lane>(away: [L; 3], radius: f32) -> L {
    let radius = f64::from(radius);
    dot(away, away) - away[0].lift(radius * radius)
}

/// The share of what a nearer sphere covers that it hides of a farther one, from the power against each.
#[inline(always)]
pub(super) fn share<L: Lane>(slope: f32, farther: L, nearer: L) -> L {
    let half = farther.lift(0.5);
    let share = (farther - nearer).mul_add(farther.lift(f64::from(slope)), half);
    share.max(farther.lift(0.0)).min(farther.lift(1.0))
}
