//! The sum of all blockers' log visibilities at a receiver (Ren et al. 2006, equation 38).

use super::gloss::Gloss;
use super::vectors::{dot, each};
use sh_core::seen::Seen;
use sh_core::{Lane, Routines};
use sh_scene::Blocker;

/// Where a group of receivers is, which way it faces, and which body it is of.
#[derive(Clone, Copy, Debug)]
pub struct Point<L> {
    /// Position, in metres.
    pub position: [L; 3],
    /// Unit normal.
    pub normal: [L; 3],
    /// The body, as [`sh_scene::Receiver::object`] has it.
    pub object: L,
    /// How they mirror light, where that is asked for; else they reflect it diffusely.
    pub gloss: Option<Gloss<L>>,
}

impl<L: Lane> Point<L> {
    /// The lobe in which they reflect light.
    #[inline(always)]
    pub(crate) fn lobe<const C: usize>(&self) -> [L; C]
    where
        [L; C]: Routines<L>,
    {
        match &self.gloss {
            None => <[L; C]>::cosine(self.normal),
            Some(gloss) => gloss.lobe(),
        }
    }

    /// What they reflect of a light of which they would reflect `open` diffusely at albedo 1: of one in a direction, with the
    /// square of the sine of its angular radius.
    #[inline(always)]
    pub(crate) fn reflects(&self, open: L, direction: [L; 3], sine_square: L) -> L {
        match &self.gloss {
            None => open,
            Some(gloss) => {
                let (height, along) = (dot(direction, self.normal), dot(direction, gloss.view));
                open * gloss.mirrors(height, along, sine_square * open.lift(0.25))
            }
        }
    }

    /// 1 where a blocker is of the receiver's own body, 0 elsewhere.
    #[inline(always)]
    pub(crate) fn owns(&self, blocker: &Blocker) -> L {
        let (zero, one) = (self.object.lift(0.0), self.object.lift(1.0));
        if blocker.object == 0 {
            return zero;
        }
        let apart = (self.object - zero.lift(f64::from(blocker.object))).abs();
        L::select(apart.lt(zero.lift(0.5)), one, zero)
    }
}

/// Blockers whose replacements are worked out before any is added: the chain of square roots and divisions of
/// one is long, and in a short loop of their own the processor overlaps several. More than it overlaps would only have
/// to be stored and loaded again.
const BATCH: usize = 8;

/// What casts shadows on a group of receivers.
#[derive(Clone, Copy, Debug, Default)]
pub struct Blockers<'a> {
    /// Those that lie wholly in front of every receiver's tangent plane.
    pub front: &'a [Blocker],
    /// Those of which each receiver has to find out.
    pub across: &'a [Blocker],
}

/// `sum`, on the scale of [`Routines::accumulate_blocker`], plus the blockers' log visibilities, to be inlined into [`crate::Outline::accumulate`].
///
/// Cost per receiver and blocker at order 4: about 110 operations, a division and two square roots for one in
/// front; for one across the tangent plane 50 more, with three more divisions. A blocker behind the
/// tangent planes of all receivers in a group of lanes costs one dot product.
#[inline(always)]
pub(crate) fn accumulated<L: Lane, const C: usize>(
    sum: &[L; C],
    point: &Point<L>,
    blockers: Blockers,
) -> [L; C]
where
    [L; C]: Routines<L>,
    [L; 4]: Routines<L>,
{
    let mut sum = *sum;
    let mut batch = [nothing(point); BATCH];
    for blockers in blockers.front.chunks(BATCH) {
        for (seen, blocker) in batch.iter_mut().zip(blockers) {
            *seen = whole(blocker, point);
        }
        add_all(&mut sum, batch.iter().zip(blockers));
    }
    // Blockers that are behind all lanes are passed over, so that batches are full.
    let mut counting = [&Blocker::NONE; BATCH];
    let mut count = 0;
    for blocker in blockers.across {
        if let Some(seen) = above(blocker, point) {
            batch[count] = seen;
            counting[count] = blocker;
            count += 1;
            if count == BATCH {
                add_all(&mut sum, batch.iter().zip(counting));
                count = 0;
            }
        }
    }
    add_all(&mut sum, batch.iter().zip(counting).take(count));
    sum
}

/// Adds blockers as they are seen.
#[inline(always)]
fn add_all<'a, L: Lane + 'a, const C: usize>(
    sum: &mut [L; C],
    blockers: impl Iterator<Item = (&'a Seen<L>, &'a Blocker)>,
) where
    [L; C]: Routines<L>,
{
    for (seen, blocker) in blockers {
        // A sine of 0 adds exactly 0.
        *sum = added(sum, seen, &blocker.weights);
    }
}

/// A blocker that lies in front of all tangent planes, and is none of the own body's near by.
#[inline(always)]
pub(crate) fn whole<L: Lane>(blocker: &Blocker, point: &Point<L>) -> Seen<L> {
    let radius = point.object.lift(f64::from(blocker.radius));
    Seen::whole(seen_from(&blocker.center, point), radius)
}

/// A blocker by the rule of [`Seen::above`], which is left out where no receiver needs it; none where it lies behind all
/// tangent planes.
#[inline(always)]
pub(crate) fn above<L: Lane>(blocker: &Blocker, point: &Point<L>) -> Option<Seen<L>>
where
    [L; 4]: Routines<L>,
{
    let center = seen_from(&blocker.center, point);
    let radius = point.object.lift(f64::from(blocker.radius));
    let height = dot(center, point.normal);
    if !L::any((-radius).lt(height)) {
        return None;
    }
    let own = point.owns(blocker);
    // Beyond this a ball of the own body counts as others do.
    let reach = radius * radius * own * radius.lift(1.0 / (1.0 - sh_core::seen::OWN));
    let needed = L::any(height.lt(radius)) || L::any(dot(center, center).lt(reach));
    Some(if needed {
        Seen::above(center, point.normal, radius, own)
    } else {
        Seen::whole(center, radius)
    })
}

/// A blocker as receivers see it, with a sine of 0 where it does not count: whether it lies `in_front` of all tangent
/// planes is known.
#[inline(always)]
pub(crate) fn look<L: Lane>(blocker: &Blocker, in_front: bool, point: &Point<L>) -> Seen<L>
where
    [L; 4]: Routines<L>,
{
    if in_front {
        whole(blocker, point)
    } else {
        above(blocker, point).unwrap_or(nothing(point))
    }
}

#[inline(always)]
fn nothing<L: Lane>(point: &Point<L>) -> Seen<L> {
    let zero = point.object.lift(0.0);
    Seen {
        sine: zero,
        cosine: zero,
        direction: [zero; 3],
    }
}

/// A place, seen from receivers.
#[inline(always)]
pub(crate) fn seen_from<L: Lane>(center: &[f32; 3], point: &Point<L>) -> [L; 3] {
    each(
        #[inline(always)]
        |k| point.object.lift(f64::from(center[k])) - point.position[k],
    )
}

/// `sum`, on the scale of [`Routines::accumulate_blocker`], plus a blocker with its weights.
#[inline(always)]
pub(crate) fn added<L: Lane, const C: usize>(
    sum: &[L; C],
    seen: &Seen<L>,
    weights: &[f32; 6],
) -> [L; C]
where
    [L; C]: Routines<L>,
{
    let weights = <[L; C]>::zonal_from(
        #[inline(always)]
        |l| seen.sine.lift(f64::from(weights[l])),
    );
    sum.accumulate_blocker(seen.sine, seen.cosine, seen.direction, weights)
}
