//! Blockers that are behind a lamp, and do not hide it.
//!
//! The shadow pass sums up all blockers, and the sky is behind them all. A lamp may be before some of them. Where that
//! can be, for some receiver of a cluster, the lamp gets a sum of its own: that of all, less what is behind it
//! ([`sh_scene::order::Pair`] is the rule). Only blockers in about its direction count as behind, as far as a light of a
//! finite order mixes directions up: what lies aside of a lamp casts the same little blurred shadow on it, before or behind.
//! Most clusters have no such blocker, and pay nothing.
//!
//! A node of the cut that reaches around a lamp is looked into: its leaves count one by one.

use super::accumulate::{Blockers, Point, above, seen_from, whole};
use super::horizon::is_far;
use super::order::{power, share};
use super::vectors::{dot, each};
use glam::Vec3;
use sh_core::constants::{ASIDE, ASIDE_EDGE, MOST_LAMPS, NEAR, NEAREST, REACH, STEEP, WIDENED};
use sh_core::{Lane, Routines};
use sh_scene::order::{Ball, Pair, is_clear};
use sh_scene::{Blocker, Bounds, Emitter, Forest, Side};

/// What a cluster's lamps are not hidden by.
#[derive(Clone, Debug, Default)]
pub(crate) struct Behind {
    /// Of all lamps, one after another.
    changes: Vec<Change>,
    /// Which lamp, and where its changes end; they begin where those of the one before it end.
    lamps: Vec<(u8, u32)>,
}

/// One blocker's part in a lamp's sum.
#[derive(Clone, Copy, Debug)]
pub struct Change {
    blocker: Blocker,
    in_front: bool,
    /// How often it is added whatever the receiver: −1 for a node that its leaves take the place of, 1 for these, 0 for
    /// one that is in the sum.
    base: f32,
    /// Whether what is behind the lamp is taken away.
    parted: bool,
    most: f32,
    slope: f32,
}

impl Change {
    /// One that counts `base` times, wherever it is seen from.
    fn whole(blocker: Blocker, in_front: bool, base: f32) -> Self {
        Self {
            blocker,
            in_front,
            base,
            parted: false,
            most: 0.0,
            slope: 0.0,
        }
    }
}

impl Behind {
    /// Forgets everything.
    pub fn clear(&mut self) {
        self.changes.clear();
        self.lamps.clear();
    }

    /// Bit i: lamp i has a sum of its own.
    pub fn lamps(&self) -> u64 {
        let bits = self.lamps.iter().map(|(lamp, _)| 1 << lamp);
        bits.fold(0, |all, bit| all | bit)
    }

    /// Each lamp that has a sum of its own, with the changes that make it.
    pub fn each(&self) -> impl Iterator<Item = (usize, &[Change])> {
        let mut start = 0;
        self.lamps.iter().map(move |&(lamp, end)| {
            let changes = &self.changes[start..end as usize];
            start = end as usize;
            (usize::from(lamp), changes)
        })
    }

    /// Bytes that it takes.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.changes[..]) + size_of_val(&self.lamps[..])
    }

    /// Finds what is behind lamp `index`, of the blockers of a cluster and the nodes that these are.
    pub fn find(
        &mut self,
        (index, emitter): (usize, &Emitter),
        bounds: &Bounds,
        forest: &Forest,
        blockers: Blockers,
        nodes: [&[u32]; 2],
    ) {
        let Some(lamp) = ball(index, emitter) else {
            return;
        };
        let lists = [
            (blockers.front, nodes[0], true),
            (blockers.across, nodes[1], false),
        ];
        let before = self.changes.len();
        for (blockers, nodes, in_front) in lists {
            for (blocker, &node) in blockers.iter().zip(nodes) {
                let own = ball_of(blocker);
                let leaf = forest.nodes()[node as usize].is_leaf(node as usize);
                if leaf || is_clear(&lamp, &own) {
                    self.take_away(&lamp, *blocker, in_front, 0.0, bounds);
                } else {
                    self.look_into(&lamp, *blocker, node as usize, in_front, bounds, forest);
                }
            }
        }
        if self.changes.len() > before {
            self.lamps.push((index as u8, self.changes.len() as u32));
        }
    }

    /// Finds what of these blockers, with nothing known of the receivers, may be behind a lamp: all.
    pub fn take_all(&mut self, (index, emitter): (usize, &Emitter), blockers: &[Blocker]) {
        let Some(lamp) = ball(index, emitter) else {
            return;
        };
        for blocker in blockers {
            self.push(&lamp, *blocker, false, 0.0);
        }
        if !blockers.is_empty() {
            self.lamps.push((index as u8, self.changes.len() as u32));
        }
    }

    fn look_into(
        &mut self,
        lamp: &Ball,
        whole: Blocker,
        at: usize,
        in_front: bool,
        bounds: &Bounds,
        forest: &Forest,
    ) {
        self.changes.push(Change::whole(whole, in_front, -1.0));
        let end = forest.nodes()[at].skip as usize;
        for (below, leaf) in forest.nodes().iter().enumerate().take(end).skip(at + 1) {
            if !leaf.is_leaf(below) {
                continue;
            }
            let side = bounds.side(leaf.center.into(), leaf.radius);
            let blocker = Blocker::of(leaf);
            match side {
                Side::Behind => {}
                side => {
                    let in_front = side == Side::Front && is_far(leaf, bounds);
                    self.take_away(lamp, blocker, in_front, 1.0, bounds);
                }
            }
        }
    }

    /// One that is in the sum already, or has to be added to it, where it may be behind the lamp.
    fn take_away(
        &mut self,
        lamp: &Ball,
        blocker: Blocker,
        in_front: bool,
        base: f32,
        bounds: &Bounds,
    ) {
        let own = ball_of(&blocker);
        let settled = Pair::of(lamp, &own).is_settled(lamp, &own, bounds.center, bounds.radius);
        if settled || own.radius <= 0.0 || is_aside(lamp, &own, in_front, bounds) {
            if base != 0.0 {
                self.changes.push(Change::whole(blocker, in_front, base));
            }
        } else {
            self.push(lamp, blocker, in_front, base);
        }
    }

    fn push(&mut self, lamp: &Ball, blocker: Blocker, in_front: bool, base: f32) {
        let Pair { most, slope, .. } = Pair::of(lamp, &ball_of(&blocker));
        self.changes.push(Change {
            blocker,
            in_front,
            base,
            parted: true,
            most,
            slope,
        });
    }
}

/// A lamp that may be before a blocker: a ball, of those that are told apart.
fn ball(index: usize, emitter: &Emitter) -> Option<Ball> {
    let local = emitter.local != 0.0 && index < MOST_LAMPS;
    local.then(|| Ball::new(emitter.center, emitter.radius))
}

fn ball_of(blocker: &Blocker) -> Ball {
    Ball::new(blocker.center, blocker.radius)
}

/// Whether a blocker is aside of a lamp for every receiver of a cluster.
fn is_aside(lamp: &Ball, blocker: &Ball, in_front: bool, bounds: &Bounds) -> bool {
    let [to, towards] = [lamp, blocker].map(|ball| ball.center - bounds.center);
    let [far, near] = [to, towards].map(Vec3::length);
    let reach = bounds.radius * WIDENED;
    let [from, wide] = if in_front { [1.0; 2] } else { [NEAR, REACH] };
    if !(far > reach && near > reach + from * blocker.radius) {
        return false;
    }
    let spread = (reach / far).asin() + (reach / near).asin();
    let angle = (to.dot(towards) / (far * near)).clamp(-1.0, 1.0).acos();
    angle - spread - (wide * blocker.radius / (near - reach)).min(1.0).asin() > ASIDE_EDGE
}

/// A lamp's sum, on the scale of [`Routines::accumulate_blocker`]: that of all blockers, less what is behind it. What
/// [`crate::Outline::parted`] computes, to be inlined there.
#[inline(always)]
pub(crate) fn parted<L: Lane, const C: usize>(
    sum: &[L; C],
    point: &Point<L>,
    emitter: &Emitter,
    changes: &[Change],
) -> [L; C]
where
    [L; C]: Routines<L>,
    [L; 4]: Routines<L>,
{
    let (zero, one) = (point.object.lift(0.0), point.object.lift(1.0));
    let away = seen_from(&emitter.center, point);
    let square = |radius: f32| zero.lift(f64::from(radius) * f64::from(radius));
    let lamp = power(away, emitter.radius);
    let inverse = one / dot(away, away).sqrt().max(zero.lift(NEAREST));
    let direction = each(
        #[inline(always)]
        |k| away[k] * inverse,
    );
    let mut sum = *sum;
    for change in changes {
        let blocker = &change.blocker;
        let mut left = zero;
        if change.parted {
            // Most are before the lamp, or aside of it, for all of these receivers, and need not be looked at closely.
            let center = seen_from(&blocker.center, point);
            let share = share(change.slope, lamp, power(center, blocker.radius));
            left = share.mul_add(zero.lift(f64::from(change.most)), -one);
            // For a sphere s of radius r within a ball c of radius R: (d · s + r) / |s| is at most (d · c + R) / (|c| − R).
            let wide = if change.in_front {
                1.0
            } else {
                REACH * (1.0 + ASIDE as f32)
            };
            let edge = dot(direction, center) + zero.lift(f64::from(wide * blocker.radius));
            let edge = edge.max(zero);
            let far = dot(center, center);
            let near = L::any((far * zero.lift(ASIDE * ASIDE)).lt(edge * edge))
                || L::any(far.lt(square(NEAR * blocker.radius)));
            if change.base == 0.0 && !(near && L::any(left.lt(zero))) {
                continue;
            }
        }
        let seen = if change.in_front {
            whole(blocker, point)
        } else if let Some(seen) = above(blocker, point) {
            seen
        } else {
            continue;
        };
        let near = dot(direction, seen.direction) + seen.sine - zero.lift(ASIDE);
        let near = (near * zero.lift(STEEP)).max(zero).min(one);
        let part = left.mul_add(near, zero.lift(f64::from(change.base)));
        let weights = <[L; C]>::zonal_from(
            #[inline(always)]
            |l| part * zero.lift(f64::from(blocker.weights[l])),
        );
        sum = sum.accumulate_blocker(seen.sine, seen.cosine, seen.direction, weights);
    }
    sum
}
