//! Light that patches send on to a receiver.
//!
//! A disc of area A, of which the receiver lies h in front and which lies h' above the receiver's horizon, at the distance
//! t, sends it of its radiance
//!
//! ```text
//! F = A h h' / (π t⁴)
//! ```
//!
//! as what albedo 1 reflects. That is what its middle sends; what the disc does differs from it by a² / 8 of the Laplacian of that
//! in its plane, a² = A / π. With the normals n and n' of disc and receiver that comes to
//!
//! ```text
//! F = A / (π t² (t² + a²)) · (h h' (1 + x (2 − 3 h² / t²)) − x h² n · n')        x = a² / t²
//! ```
//!
//! in which 1 + a² / t² was divided by so that it is exact on the axis of a disc that faces the receiver, from any distance.
//!
//! So near that single discs would be seen the receiver is *lifted* instead: in place of h it is √(h² + ε²)
//! off the plane of the disc, with ε of half the distance of discs. A plane of them gives what it gives then, from
//! wherever it is looked at: a half space all of the light, one that ends at the receiver's feet a half. A region that is flat is one
//! disc; another sends I(ω) cos θ' / (π t²), with its intensity I by direction. Where a receiver is near, a region gives way to its quarters, one
//! that is not flat or near to its patches, and a patch that is near to four smaller discs.
//!
//! Of all of them is seen what nearer spheres leave: each covers a share of the disc, by how far their edges overlap, and shares
//! that are left multiply, which for a disc that is small beside the spheres is what they leave together. A sphere counts as
//! far as its middle is nearer than the patch.
//!
//! What a body gives itself is told by its functions ([`sh_scene::IrradianceBasis::bounced`]). A receiver on it takes
//! what is told at the patches around, by how near they are and how much they face the same way.

use super::accumulate::Point;
use super::gloss::Gloss;
use super::patch_cut::{Part, PatchCut};
use super::patch_hiding::{Cone, Hidden, left, may_hide, see, world};
use super::patch_lights::{Lit, PatchLights, Placed};
use super::vectors::{dot, each};
use sh_core::constants::{
    ASKEW, BEHIND, ENTIRE, JOINED, LIFTED, NEAREST, QUARTERS, REFINED, REGION_PATCHES, ROOM, SPLIT,
    WITHIN,
};
use sh_core::{Lane, Routines};
use sh_scene::basis::{Disc, Facet};
use std::f64::consts::PI;

/// Receivers in the space of a body.
struct Local<'a, L> {
    position: [L; 3],
    normal: [L; 3],
    /// How they mirror light, and the direction to the eye.
    gloss: Option<(&'a Gloss<L>, [L; 3])>,
}

impl<L: Lane> Local<'_, L> {
    /// As [`Point::reflects`].
    #[inline(always)]
    fn reflects(&self, open: L, cone: &Cone<L>) -> L {
        match &self.gloss {
            None => open,
            Some((gloss, view)) => {
                let (direction, square) = cone.told();
                let (height, along) = (dot(direction, self.normal), dot(direction, *view));
                open * gloss.mirrors(height, along, square)
            }
        }
    }
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
    for (kept, hider) in kept.iter_mut().zip(&cut.hiders) {
        *kept = see(hider, point);
    }
    let (mut parts, mut around) = (0, 0);
    for source in &cut.sources {
        let (first_part, first_around) = (parts, around);
        (parts, around) = (source.parts_end as usize, source.around_end as usize);
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
                let given = itself(&local, &cut.around[first_around..around], placed, lit);
                for (sum, given) in sum.iter_mut().zip(given) {
                    *sum = mine.mul_add(given, *sum);
                }
            }
            if !L::any(zero.lt(others)) {
                continue;
            }
        }
        let before = first_part.checked_sub(1).map(|last| cut.parts[last]);
        let mut first_hiding = before.map_or(0, |part| part.hiding_end as usize);
        for part in &cut.parts[first_part..parts] {
            let hiding = &cut.hiding[first_hiding..part.hiding_end as usize];
            first_hiding = part.hiding_end as usize;
            let given = region::<L, C>(&local, part, (placed, lit), (hiding, kept));
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
fn local<'a, L: Lane>(point: &'a Point<L>, placed: &Placed) -> Local<'a, L> {
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
        gloss: match &point.gloss {
            None => None,
            Some(gloss) => Some((gloss, turned(&turn, gloss.view))),
        },
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

/// What a region gives: as a whole, by its quarters, or patch by patch.
#[inline(always)]
fn region<L: Lane, const C: usize>(
    local: &Local<L>,
    part: &Part,
    (placed, lit): (&Placed, &Lit),
    (hiding, kept): (&[u8], &[Hidden<L>; ROOM]),
) -> [L; 3]
where
    [L; C]: Routines<L>,
{
    let at = part.region as usize;
    let region = &placed.shape.regions[at];
    let (square, far, direction) = towards(region.center, local);
    let (zero, one) = (far.lift(0.0), far.lift(1.0));
    let mut sum = [zero; 3];
    let mut few = [0; ROOM];
    let hiding = match part.patches {
        0 => hiding,
        _ => {
            let around = f64::from(region.radius) * AROUND;
            let towards = (world(placed, direction), far);
            may_hide(towards, around, (hiding, kept), &mut few)
        }
    };
    // Whether it counts as a whole: 0 nearby, 1 from afar.
    let whole;
    if region.whole.disc.area > 0.0 {
        let seen = Seen::of(&region.whole.disc, local);
        whole = seen.whole;
        let open = seen.open * whole;
        if part.whole && L::any(zero.lt(open)) {
            let cone = seen.cone();
            let shown = escape(&region.whole, cone.back());
            let open =
                local.reflects(open, &cone) * shown * left(&cone.world(placed), hiding, kept);
            let all = at * REGION_PATCHES..(at + 1) * REGION_PATCHES;
            add(&mut sum, lit.mean(all), open);
        }
    } else {
        whole = afar(
            far,
            f64::from(region.radius).max(NEAREST),
            [REFINED, ENTIRE],
        );
        let facing = dot(direction, local.normal).max(zero) * whole;
        if part.whole && L::any(zero.lt(facing)) {
            let radius = f64::from(region.radius).max(NEAREST);
            let cone = Cone::new(direction, (square, far), radius * radius);
            let seen = left(&cone.world(placed), hiding, kept);
            let basis = <[L; C]>::basis(cone.back());
            let open = local.reflects(facing, &cone) * seen / (square * far.lift(PI));
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
    for (quarter, facet) in region.quarters.iter().enumerate() {
        let mut rest = part.patches >> (quarter * QUARTER) & ((1 << QUARTER) - 1);
        if rest == 0 {
            continue;
        }
        let first = at * REGION_PATCHES + quarter * QUARTER;
        let mut near = near;
        if facet.disc.area > 0.0 {
            let seen = Seen::of(&facet.disc, local);
            let open = seen.open * seen.whole * near;
            if L::any(zero.lt(open)) {
                let cone = seen.cone();
                let open = local.reflects(open, &cone)
                    * escape(facet, cone.back())
                    * left(&cone.world(placed), hiding, kept);
                add(&mut sum, lit.mean(first..first + QUARTER), open);
            }
            near = near * (one - seen.whole);
            if !L::any(zero.lt(near)) {
                continue;
            }
        }
        while rest != 0 {
            let m = first + rest.trailing_zeros() as usize;
            rest &= rest - 1;
            let patch = &placed.patches[m];
            let disc = &patch.whole.disc;
            if disc.area <= 0.0 {
                continue;
            }
            let seen = Seen::of(disc, local);
            let mut open = seen.open * seen.whole;
            if L::any(seen.whole.lt(one)) {
                let mut parts = zero;
                for disc in patch.discs.iter().filter(|disc| disc.area > 0.0) {
                    parts = parts + lifted(disc, local);
                }
                open = (one - seen.whole).mul_add(parts, open);
            }
            let open = open * near;
            if !L::any(zero.lt(open)) {
                continue;
            }
            let cone = seen.lifted();
            let open = local.reflects(open, &cone)
                * escape(&patch.whole, cone.back())
                * left(&cone.world(placed), hiding, kept);
            add(&mut sum, lit.radiance[m], open);
        }
    }
    sum
}

/// 0 up to so many times a length, 1 from so many on.
#[inline(always)]
fn afar<L: Lane>(far: L, length: f64, [from, to]: [f64; 2]) -> L {
    let lengths = length * (to - from);
    let start = from / (to - from);
    let afar = far.mul_add(far.lift(1.0 / lengths), -far.lift(start));
    afar.max(far.lift(0.0)).min(far.lift(1.0))
}

#[inline(always)]
fn add<L: Lane>(sum: &mut [L; 3], radiance: [f32; 3], open: L) {
    for (sum, radiance) in sum.iter_mut().zip(radiance) {
        *sum = open.mul_add(open.lift(f64::from(radiance)), *sum);
    }
}

/// The ball around all discs of a region, over that around its samples: with what receivers are lifted off them.
const AROUND: f64 = 1.5;

/// Patches of a quarter of a region.
const QUARTER: usize = REGION_PATCHES / QUARTERS;

/// A disc as a receiver sees it.
struct Seen<'a, L> {
    disc: &'a Disc,
    away: [L; 3],
    square: L,
    far: L,
    height: L,
    /// What it gives of its radiance to whoever is not next to it.
    open: L,
    /// Whether it counts as a whole: 0 nearby, 1 from afar.
    whole: L,
}

impl<'a, L: Lane> Seen<'a, L> {
    #[inline(always)]
    fn of(disc: &'a Disc, local: &Local<L>) -> Self {
        let zero = local.position[0].lift(0.0);
        let one = zero.lift(1.0);
        let (away, normal) = (way(disc, local), facing(disc, zero));
        let height = -dot(away, normal);
        let front = height.max(zero);
        let above = dot(away, local.normal);
        let square = dot(away, away).max(zero.lift(NEAREST));
        let area = f64::from(disc.area) / PI;
        let wide = square + zero.lift(area);
        let inverse = one / (square * wide);
        let size = zero.lift(area) * wide * inverse;
        let steep = front * front * wide * inverse;
        let bent = size * steep.mul_add(zero.lift(-3.0), zero.lift(2.0));
        let aside = size * front * dot(normal, local.normal);
        let open = above.mul_add(bent, above) - aside;
        let far = square.sqrt();
        Self {
            disc,
            away,
            square,
            far,
            height,
            open: open.max(zero) * front * inverse * zero.lift(area),
            whole: afar(far, f64::from(disc.area).sqrt(), [SPLIT, JOINED]),
        }
    }

    /// The disc in the sky that it is.
    #[inline(always)]
    fn cone(&self) -> Cone<L> {
        Cone::towards(self.away, (self.square, self.far), self.disc.area)
    }

    /// That from where the receiver is lifted to.
    #[inline(always)]
    fn lifted(&self) -> Cone<L> {
        let (away, _) = lift(self.disc, self.away, self.height);
        let square = dot(away, away);
        Cone::towards(away, (square, square.sqrt()), self.disc.area)
    }
}

#[inline(always)]
fn way<L: Lane>(disc: &Disc, local: &Local<L>) -> [L; 3] {
    each(
        #[inline(always)]
        |k| local.position[0].lift(f64::from(disc.center[k])) - local.position[k],
    )
}

#[inline(always)]
fn facing<L: Lane>(disc: &Disc, like: L) -> [L; 3] {
    each(
        #[inline(always)]
        |k| like.lift(f64::from(disc.normal[k])),
    )
}

/// The way to a disc from where a receiver is lifted to that is so high above its plane, and how high that is.
#[inline(always)]
fn lift<L: Lane>(disc: &Disc, away: [L; 3], height: L) -> ([L; 3], L) {
    let least = f64::from(disc.area).sqrt() * LIFTED;
    let lifted = height.mul_add(height, height.lift(least * least)).sqrt();
    let (up, normal) = (lifted - height, facing(disc, height));
    let away = each(
        #[inline(always)]
        |k| (-up).mul_add(normal[k], away[k]),
    );
    (away, lifted)
}

/// What a disc gives of its radiance to a receiver that is lifted.
#[inline(always)]
fn lifted<L: Lane>(disc: &Disc, local: &Local<L>) -> L {
    let zero = local.position[0].lift(0.0);
    let one = zero.lift(1.0);
    let away = way(disc, local);
    let height = -dot(away, facing(disc, zero));
    let (away, lifted) = lift(disc, away, height);
    let above = dot(away, local.normal).max(zero);
    let least = f64::from(disc.area).sqrt() * LIFTED;
    let front = height.mul_add(zero.lift(1.0 / (least * BEHIND)), one);
    let front = front.max(zero).min(one);
    let inverse = one / dot(away, away);
    let open = zero.lift(f64::from(disc.area) / PI) * inverse * inverse;
    open * lifted * above * front
}

/// How much of a part of it a body leaves to be seen from a direction.
#[inline(always)]
fn escape<L: Lane>(facet: &Facet, [x, y, z]: [L; 3]) -> L {
    let [b, square, mixed] = &facet.escape;
    let lift = |v: f32| x.lift(f64::from(v));
    let along = |v: &[f32; 4], a: L, b: L, c: L| {
        a.mul_add(lift(v[0]), b.mul_add(lift(v[1]), c * lift(v[2])))
    };
    let even = along(square, x * x, y * y, z * z);
    let mixed = along(mixed, x * y, y * z, z * x);
    let seen = along(b, x, y, z) + even + mixed + mixed;
    seen.max(x.lift(0.0)).min(x.lift(1.0))
}

/// What a body gives a receiver on it: what it gives its patches, by nearness.
#[inline(always)]
fn itself<L: Lane>(local: &Local<L>, around: &[u32], placed: &Placed, lit: &Lit) -> [L; 3] {
    let zero = local.position[0].lift(0.0);
    let one = zero.lift(1.0);
    let (mut sum, mut all) = ([zero; 3], zero.lift(NEAREST));
    for &m in around {
        let disc = &placed.patches[m as usize].whole.disc;
        let own = &lit.own[m as usize];
        let away = way(disc, local);
        let square = dot(away, away);
        let reach = WITHIN * WITHIN * f64::from(disc.area);
        let within = square
            .mul_add(zero.lift(-1.0 / reach.max(NEAREST)), one)
            .max(zero);
        let facing = dot(facing(disc, zero), local.normal).max(zero) + zero.lift(ASKEW);
        let area = zero.lift(0.5 * f64::from(disc.area));
        let near = facing * area / (square + area) * within;
        let near = near * near;
        all = all + near;
        for (c, sum) in sum.iter_mut().enumerate() {
            *sum = near.mul_add(zero.lift(f64::from(own[c])), *sum);
        }
    }
    let inverse = one / all;
    [sum[0] * inverse, sum[1] * inverse, sum[2] * inverse]
}
