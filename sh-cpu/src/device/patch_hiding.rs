//! What nearer spheres leave of a disc in the sky: each covers a share of it, by how far their edges overlap, and shares
//! that are left multiply.

use super::accumulate::{Point, look, seen_from};
use super::patch_lights::Placed;
use super::vectors::{dot, each};
use sh_core::constants::{NEAREST, ROOM};
use sh_core::{Lane, Routines};
use sh_scene::Blocker;
use std::f64::consts::PI;

/// A sphere as receivers see it.
#[derive(Clone, Copy)]
pub struct Hidden<L> {
    direction: [L; 3],
    sine: L,
    cosine: L,
    /// One over the sine.
    steep: L,
    /// How far its middle is.
    far: L,
    /// One over twice its radius.
    inverse: f32,
}

impl<L: Lane> Hidden<L> {
    /// Nothing.
    #[inline(always)]
    pub(crate) fn nothing(zero: L) -> Self {
        Self {
            direction: [zero; 3],
            sine: zero,
            cosine: zero.lift(1.0),
            steep: zero,
            far: zero,
            inverse: 0.0,
        }
    }
}

/// A sphere as receivers see it.
#[inline(always)]
pub(super) fn see<L: Lane>(hider: &Blocker, point: &Point<L>) -> Hidden<L>
where
    [L; 4]: Routines<L>,
{
    let seen = look(hider, false, point);
    let (zero, one) = (seen.sine.lift(0.0), seen.sine.lift(1.0));
    let away = seen_from(&hider.center, point);
    Hidden {
        direction: seen.direction,
        sine: seen.sine,
        cosine: (-seen.sine).mul_add(seen.sine, one).max(zero).sqrt(),
        steep: one / seen.sine.max(one.lift(NEAREST)),
        far: dot(away, away).sqrt(),
        inverse: 0.5 / hider.radius.max(NEAREST as f32),
    }
}

/// A direction of a body's space in the world.
#[inline(always)]
pub(super) fn world<L: Lane>(placed: &Placed, [x, y, z]: [L; 3]) -> [L; 3] {
    let turn = placed.turn.to_cols_array_2d();
    let lift = |v: f32| x.lift(f64::from(v));
    each(
        #[inline(always)]
        |k| {
            let [a, b, c] = turn[k];
            x.mul_add(lift(a), y.mul_add(lift(b), z * lift(c)))
        },
    )
}

/// The disc in the sky that something is taken for.
#[derive(Clone, Copy)]
pub(super) struct Cone<L> {
    direction: [L; 3],
    far: L,
    sine: L,
    cosine: L,
    /// One over the sine.
    steep: L,
}

impl<L: Lane> Cone<L> {
    /// The direction back to the receiver.
    #[inline(always)]
    pub(super) fn back(&self) -> [L; 3] {
        let [x, y, z] = self.direction;
        [-x, -y, -z]
    }

    /// Its direction, and the square of the sine of its angular radius.
    #[inline(always)]
    pub(super) fn told(&self) -> ([L; 3], L) {
        (self.direction, self.sine * self.sine)
    }

    /// That of the same place in the world, if it is one in the space of a body.
    #[inline(always)]
    pub(super) fn world(&self, placed: &Placed) -> Self {
        Self {
            direction: world(placed, self.direction),
            far: self.far * self.far.lift(f64::from(placed.scale)),
            ..*self
        }
    }

    /// That of a disc so far away along a vector.
    #[inline(always)]
    pub(super) fn towards(away: [L; 3], (square, far): (L, L), area: f32) -> Self {
        let inverse = far.lift(1.0) / far;
        let direction = each(
            #[inline(always)]
            |k| away[k] * inverse,
        );
        Self::new(direction, (square, far), f64::from(area) / PI)
    }

    /// That of a disc in this unit direction, so far away, of this area over π.
    #[inline(always)]
    pub(super) fn new(direction: [L; 3], (square, far): (L, L), area: f64) -> Self {
        let one = far.lift(1.0);
        let whole = square + far.lift(area);
        let inverse = (one / whole).sqrt();
        let root = area.sqrt();
        Self {
            direction,
            far,
            sine: inverse * far.lift(root),
            cosine: inverse * far,
            steep: whole * inverse * far.lift(1.0 / root),
        }
    }
}

/// Which spheres may hide a part of a ball from some of these receivers: those of a cluster lie farther apart.
#[inline(always)]
pub(super) fn may_hide<'a, L: Lane>(
    (direction, far): ([L; 3], L),
    radius: f64,
    (hiding, kept): (&[u8], &[Hidden<L>; ROOM]),
    found: &'a mut [u8; ROOM],
) -> &'a [u8] {
    let one = far.lift(1.0);
    let sine = (far.lift(radius) / far).min(one);
    let cosine = (-sine).mul_add(sine, one).max(far.lift(0.0)).sqrt();
    let within = far.lt(far.lift(radius));
    let mut count = 0;
    for &at in hiding {
        let other = &kept[usize::from(at) % ROOM];
        let least = other.cosine.mul_add(cosine, -(other.sine * sine));
        let near = L::select(within, one, dot(direction, other.direction) - least);
        if L::any(far.lift(0.0).lt(near)) {
            found[count % ROOM] = at;
            count += 1;
        }
    }
    &found[..count.min(ROOM)]
}

/// What some spheres leave of a disc in the sky.
#[inline(always)]
pub(super) fn left<L: Lane>(cone: &Cone<L>, hiding: &[u8], kept: &[Hidden<L>; ROOM]) -> L {
    let (zero, one) = (cone.far.lift(0.0), cone.far.lift(1.0));
    let mut left = one;
    for &at in hiding {
        let other = &kept[usize::from(at) % ROOM];
        // From cos (a + b), where the discs touch, to cos (a − b), where one lies in the other.
        let across = other.sine * cone.sine;
        let over =
            dot(cone.direction, other.direction) - other.cosine.mul_add(cone.cosine, -across);
        if !L::any(zero.lt(over)) {
            continue;
        }
        let x = over * other.steep * cone.steep * one.lift(0.5);
        let x = x.max(zero).min(one);
        let x = x * x * (one.lift(3.0) - x - x);
        let size = other.sine * cone.steep;
        let size = (size * size).min(one);
        let inverse = one.lift(f64::from(other.inverse));
        let before = (cone.far - other.far).mul_add(inverse, one.lift(0.5));
        let before = before.max(zero).min(one);
        left = left * (-(x * size)).mul_add(before, one);
    }
    left
}
