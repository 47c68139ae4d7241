//! Light that patches send on to a receiver.
//!
//! A disc of area A, of which the receiver lies h in front and which lies h' above the receiver's horizon, at the distance
//! t, sends it of its radiance
//!
//! ```text
//! F = A h h' / (π t⁴)
//! ```
//!
//! as what albedo 1 reflects. So near that single discs would be seen the receiver is *lifted*: instead of h it is √(h² + ε²)
//! off the plane of the disc, with ε of half the distance of discs. A plane of them gives what it gives then, from
//! wherever it is looked at: a half space all of the light, one that ends at the receiver's feet a half. A region sends
//! I(ω) cos θ' / (π t²), with its intensity I by direction. A region gives way to its patches where a receiver is near, and a
//! patch to four smaller discs.
//!
//! Of both is seen what nearer spheres leave: each covers a share of the disc, by how far their edges overlap, and shares
//! that are left multiply, which for a disc that is small beside the spheres is what they leave together. A sphere counts as
//! far as its middle is nearer than the patch.
//!
//! What a body gives itself is told by its functions ([`sh_scene::IrradianceBasis::bounced`]). A receiver on it takes
//! what is told at its patches, by how near they are and how much they face the same way.

use super::accumulate::{Point, dot, each, look, seen_from};
use super::patch_cut::{Part, PatchCut};
use super::patch_lights::{Lit, PatchLights, Placed};
use sh_core::constants::{
    BEHIND, ENTIRE, JOINED, LIFTED, NEAREST, REFINED, REGION_PATCHES, ROOM, SPLIT,
};
use sh_core::{Lane, Routines};
use sh_scene::Blocker;
use sh_scene::basis::{Disc, Patch};
use std::f64::consts::PI;

/// A sphere as receivers see it, in the space of the body that it hides.
#[derive(Clone, Copy)]
pub struct Hidden<L> {
    direction: [L; 3],
    sine: L,
    cosine: L,
    /// How far its middle is.
    far: L,
    /// One over twice its radius.
    inverse: L,
}

/// Receivers in the space of a body.
struct Local<L> {
    position: [L; 3],
    normal: [L; 3],
}

/// What [`crate::Outline::gathered_patches`] computes, to be inlined there.
#[inline(always)]
pub(crate) fn patches<L: Lane, const C: usize>(
    point: &Point<L>,
    cut: &PatchCut,
    (bodies, lights): (&[Placed], &PatchLights),
    own: bool,
    kept: &mut [Hidden<L>; ROOM],
) -> [L; 3]
where
    [L; C]: Routines<L>,
    [L; 4]: Routines<L>,
{
    let (zero, one) = (point.object.lift(0.0), point.object.lift(1.0));
    let mut sum = [zero; 3];
    let (mut hiders, mut parts, mut first_hiding) = (0, 0, 0);
    for source in &cut.sources {
        let (first_hider, first_part) = (hiders, parts);
        (hiders, parts) = (source.hiders_end as usize, source.parts_end as usize);
        let (placed, lit) = (
            &bodies[source.body as usize],
            &lights.bodies[source.body as usize],
        );
        let local = local(point, placed);
        let mut others = one;
        if source.own {
            let apart = (point.object - zero.lift(f64::from(placed.object))).abs();
            let mine = L::select(apart.lt(zero.lift(0.5)), one, zero);
            others = one - mine;
            if own && !lit.own.is_empty() && L::any(zero.lt(mine)) {
                let given = itself(&local, placed, lit);
                for (sum, given) in sum.iter_mut().zip(given) {
                    *sum = mine.mul_add(given, *sum);
                }
            }
            if !L::any(zero.lt(others)) {
                continue;
            }
        }
        for (kept, hider) in kept.iter_mut().zip(&cut.hiders[first_hider..hiders]) {
            *kept = see(hider, placed, point);
        }
        for part in &cut.parts[first_part..parts] {
            let hiding = &cut.hiding[first_hiding..part.hiding_end as usize];
            first_hiding = part.hiding_end as usize;
            let given = region::<L, C>(
                &local,
                part,
                placed,
                lit,
                #[inline(always)]
                |towards, far, sine| left(towards, far, sine, hiding, kept),
            );
            for (sum, given) in sum.iter_mut().zip(given) {
                *sum = others.mul_add(given, *sum);
            }
        }
    }
    let brightest = lights.brightest;
    each(
        #[inline(always)]
        |c| {
            let most = zero.lift(f64::from(brightest[c]));
            // What is not a number fails the comparison.
            L::select(zero.lt(sum[c]), sum[c].min(most), zero)
        },
    )
}

#[inline(always)]
fn local<L: Lane>(point: &Point<L>, placed: &Placed) -> Local<L> {
    let zero = point.object.lift(0.0);
    let lift = |x: f32| zero.lift(f64::from(x));
    let (turn, local) = (placed.turn.to_cols_array_2d(), placed.local);
    let matrix = local.matrix3.to_cols_array_2d();
    let offset = local.translation.to_array();
    let p = point.position;
    Local {
        position: each(
            #[inline(always)]
            |k| {
                let along = p[2].mul_add(lift(matrix[2][k]), lift(offset[k]));
                p[0].mul_add(lift(matrix[0][k]), p[1].mul_add(lift(matrix[1][k]), along))
            },
        ),
        normal: turned(&turn, point.normal),
    }
}

#[inline(always)]
fn turned<L: Lane>(turn: &[[f32; 3]; 3], v: [L; 3]) -> [L; 3] {
    let lift = |x: f32| v[0].lift(f64::from(x));
    each(
        #[inline(always)]
        |k| {
            v[0].mul_add(
                lift(turn[0][k]),
                v[1].mul_add(lift(turn[1][k]), v[2] * lift(turn[2][k])),
            )
        },
    )
}

/// What is seen of a place: how far it is, squared and not, and the unit vector towards it.
#[inline(always)]
fn towards<L: Lane>(center: [f32; 3], local: &Local<L>) -> (L, L, [L; 3]) {
    let tiny = local.position[0].lift(NEAREST);
    let away = each(
        #[inline(always)]
        |k| tiny.lift(f64::from(center[k])) - local.position[k],
    );
    let square = dot(away, away).max(tiny);
    let far = square.sqrt();
    let inverse = tiny.lift(1.0) / far;
    let direction = each(
        #[inline(always)]
        |k| away[k] * inverse,
    );
    (square, far, direction)
}

/// What a region gives, as a whole or patch by patch.
#[inline(always)]
fn region<L: Lane, const C: usize>(
    local: &Local<L>,
    part: &Part,
    placed: &Placed,
    lit: &Lit,
    left: impl Fn([L; 3], L, L) -> L,
) -> [L; 3]
where
    [L; C]: Routines<L>,
{
    let at = part.region as usize;
    let region = &placed.shape.regions[at];
    let (square, far, direction) = towards(region.center, local);
    let (zero, one) = (far.lift(0.0), far.lift(1.0));
    let mut sum = [zero; 3];
    // Whether it counts as a whole: 0 nearby, 1 from afar.
    let radii = f64::from(region.radius).max(NEAREST) * (ENTIRE - REFINED);
    let start = REFINED / (ENTIRE - REFINED);
    let whole = far.mul_add(far.lift(1.0 / radii), -far.lift(start));
    let whole = whole.max(zero).min(one);
    if part.whole {
        let facing = dot(direction, local.normal).max(zero) * whole;
        if L::any(zero.lt(facing)) {
            let radius = far.lift(f64::from(region.radius));
            let seen = left(direction, far, (radius / far).min(one));
            let back = [-direction[0], -direction[1], -direction[2]];
            let basis = <[L; C]>::basis(back);
            let open = facing * seen / (square * far.lift(PI));
            let emission = &lit.emission[at * C..][..C];
            for (c, sum) in sum.iter_mut().enumerate() {
                let mut intensity = zero;
                for (y, of) in basis.iter().zip(emission) {
                    intensity = y.mul_add(far.lift(f64::from(of[c])), intensity);
                }
                *sum = open.mul_add(intensity.max(zero), *sum);
            }
        }
    }
    let near = one - whole;
    if part.patches == 0 || !L::any(zero.lt(near)) {
        return sum;
    }
    let mut rest = part.patches;
    while rest != 0 {
        let m = at * REGION_PATCHES + rest.trailing_zeros() as usize;
        rest &= rest - 1;
        let patch = &placed.patches[m];
        if patch.whole.area <= 0.0 {
            continue;
        }
        let (given, away) = given(&patch.whole, local);
        let square = dot(away, away);
        let far = square.sqrt();
        // Whether it counts as a whole.
        let roots = f64::from(patch.whole.area).sqrt() * (JOINED - SPLIT);
        let start = SPLIT / (JOINED - SPLIT);
        let whole = far.mul_add(far.lift(1.0 / roots), -far.lift(start));
        let whole = whole.max(zero).min(one);
        let mut open = given * whole;
        if L::any(whole.lt(one)) {
            let mut parts = zero;
            for disc in patch.discs.iter().filter(|disc| disc.area > 0.0) {
                parts = parts + self::given(disc, local).0;
            }
            open = (one - whole).mul_add(parts, open);
        }
        let open = open * near;
        if !L::any(zero.lt(open)) {
            continue;
        }
        let inverse = one / far;
        let direction = each(
            #[inline(always)]
            |k| away[k] * inverse,
        );
        let back = [-direction[0], -direction[1], -direction[2]];
        let area = far.lift(f64::from(patch.whole.area) / PI);
        let radius = (area / (area + square)).sqrt();
        let given = open * escape(patch, back) * left(direction, far, radius);
        let radiance = &lit.radiance[m];
        for (c, sum) in sum.iter_mut().enumerate() {
            *sum = given.mul_add(far.lift(f64::from(radiance[c])), *sum);
        }
    }
    sum
}

/// What a disc gives of its radiance, and the way to it from where the receiver is lifted to.
#[inline(always)]
fn given<L: Lane>(disc: &Disc, local: &Local<L>) -> (L, [L; 3]) {
    let zero = local.position[0].lift(0.0);
    let one = zero.lift(1.0);
    let lift = |x: f32| zero.lift(f64::from(x));
    let normal = each(
        #[inline(always)]
        |k| lift(disc.normal[k]),
    );
    let away = each(
        #[inline(always)]
        |k| lift(disc.center[k]) - local.position[k],
    );
    let height = -dot(away, normal);
    let least = f64::from(disc.area).sqrt() * LIFTED;
    let lifted = height.mul_add(height, zero.lift(least * least)).sqrt();
    let up = lifted - height;
    let away = each(
        #[inline(always)]
        |k| (-up).mul_add(normal[k], away[k]),
    );
    let above = dot(away, local.normal).max(zero);
    let front = height.mul_add(zero.lift(1.0 / (least * BEHIND)), one);
    let front = front.max(zero).min(one);
    let inverse = one / dot(away, away);
    let open = zero.lift(f64::from(disc.area) / PI) * inverse * inverse;
    (open * lifted * above * front, away)
}

/// How much of a patch its own body leaves to be seen from a direction.
#[inline(always)]
fn escape<L: Lane>(patch: &Patch, [x, y, z]: [L; 3]) -> L {
    let [b, square, mixed] = &patch.escape;
    let lift = |v: f32| x.lift(f64::from(v));
    let along = |v: &[f32; 4], a: L, b: L, c: L| {
        a.mul_add(lift(v[0]), b.mul_add(lift(v[1]), c * lift(v[2])))
    };
    let even = along(square, x * x, y * y, z * z);
    let mixed = along(mixed, x * y, y * z, z * x);
    let seen = along(b, x, y, z) + even + mixed + mixed;
    seen.max(x.lift(0.0)).min(x.lift(1.0))
}

/// A sphere as receivers see it, in the space of a body.
#[inline(always)]
fn see<L: Lane>(hider: &Blocker, placed: &Placed, point: &Point<L>) -> Hidden<L>
where
    [L; 4]: Routines<L>,
{
    let seen = look(hider, false, point);
    let (zero, one) = (seen.sine.lift(0.0), seen.sine.lift(1.0));
    let away = seen_from(&hider.center, point);
    let inverse = one.lift(1.0 / f64::from(placed.scale));
    let radius = f64::from(hider.radius / placed.scale);
    Hidden {
        direction: turned(&placed.turn.to_cols_array_2d(), seen.direction),
        sine: seen.sine,
        cosine: (-seen.sine).mul_add(seen.sine, one).max(zero).sqrt(),
        far: dot(away, away).sqrt() * inverse,
        inverse: one.lift(0.5 / radius.max(NEAREST)),
    }
}

/// What some spheres leave of a disc in a direction, so far away, of so large an angular radius.
#[inline(always)]
fn left<L: Lane>(direction: [L; 3], far: L, sine: L, hiding: &[u8], kept: &[Hidden<L>; ROOM]) -> L {
    let (zero, one) = (far.lift(0.0), far.lift(1.0));
    let cosine = (-sine).mul_add(sine, one).max(zero).sqrt();
    let mut left = one;
    for &at in hiding {
        let other = &kept[usize::from(at) % ROOM];
        // From cos (a + b), where the discs touch, to cos (a − b), where one lies in the other.
        let across = other.sine * sine;
        let over = dot(direction, other.direction) - other.cosine.mul_add(cosine, -across);
        if !L::any(zero.lt(over)) {
            continue;
        }
        let twice = (across + across).max(far.lift(NEAREST));
        let x = (over / twice).max(zero).min(one);
        let x = x * x * (far.lift(3.0) - x - x);
        let size = (other.sine * other.sine / (sine * sine).max(far.lift(NEAREST))).min(one);
        let before = (far - other.far).mul_add(other.inverse, far.lift(0.5));
        let before = before.max(zero).min(one);
        left = left * (-(x * size)).mul_add(before, one);
    }
    left
}

impl<L: Lane> Hidden<L> {
    /// Nothing.
    #[inline(always)]
    pub(crate) fn nothing(zero: L) -> Self {
        Self {
            direction: [zero; 3],
            sine: zero,
            cosine: zero.lift(1.0),
            far: zero,
            inverse: zero,
        }
    }
}

/// What a body gives a receiver on it: what it gives its patches, by nearness.
#[inline(always)]
fn itself<L: Lane>(local: &Local<L>, placed: &Placed, lit: &Lit) -> [L; 3] {
    let zero = local.position[0].lift(0.0);
    let (mut sum, mut all) = ([zero; 3], zero.lift(NEAREST));
    for (patch, own) in placed.patches.iter().zip(&lit.own) {
        let disc = &patch.whole;
        let away = each(
            #[inline(always)]
            |k| zero.lift(f64::from(disc.center[k])) - local.position[k],
        );
        let normal = each(
            #[inline(always)]
            |k| zero.lift(f64::from(disc.normal[k])),
        );
        let facing = dot(normal, local.normal).max(zero);
        let area = zero.lift(0.5 * f64::from(disc.area));
        let near = facing * area / (dot(away, away) + area);
        let near = near * near;
        all = all + near;
        for (c, sum) in sum.iter_mut().enumerate() {
            *sum = near.mul_add(zero.lift(f64::from(own[c])), *sum);
        }
    }
    let inverse = zero.lift(1.0) / all;
    [sum[0] * inverse, sum[1] * inverse, sum[2] * inverse]
}
