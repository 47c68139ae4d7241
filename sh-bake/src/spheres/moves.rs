//! Moves that lower the outside volume of a set of balls: each is tried, and undone where it does not help.

use super::fit::Fit;
use super::place::{Priced, farthest};
use super::proof::Ball;
use super::random::Random;
use super::state::State;
use glam::DVec3;

/// Neighbours that take over what a ball gives up.
const HEIRS: usize = 10;

impl Fit<'_> {
    /// Relieves each ball in turn, the costliest first, of the pieces that another one holds as well, and
    /// places it anew around the rest. Repeats until that gains little.
    pub(super) fn relieve_all(&self, state: &mut State) {
        for _ in 0..6 {
            let before = state.total();
            let order = state.costliest();
            self.relieve(state, &order, true, f64::INFINITY);
            state.keep();
            if state.total() > 0.99 * before {
                break;
            }
        }
    }

    /// Relieves the balls named in `order`, once. None as soon as E cannot fall below `limit` any more, even if the
    /// balls that are left came to have nothing outside.
    fn relieve(
        &self,
        state: &mut State,
        order: &[usize],
        thorough: bool,
        limit: f64,
    ) -> Option<()> {
        /// What sums are wrong by through rounding is less.
        const SLACK: f64 = 1e-9;
        let worth = |state: &State, i: usize| {
            let Priced { ball, outside } = state.balls()[i];
            outside + SLACK * ball.radius.powi(3)
        };
        let mut hope: f64 = order.iter().map(|&i| worth(state, i)).sum();
        let limit = limit + SLACK * (limit + hope);
        for &i in order {
            if state.total() - hope > limit {
                return None;
            }
            hope -= worth(state, i);
            let own = state.own(i);
            let old = state.balls()[i];
            let is_free = own.is_empty();
            let place = |own: &[u32]| self.place(own, Some(old.ball), thorough);
            let placed = state
                .memory
                .placed(i, own, old.ball.center, thorough, place);
            if is_free || placed.outside < old.outside {
                state.set(i, placed);
            }
        }
        Some(())
    }

    /// Teleportation: makes two of a costly ball, and one less elsewhere, as long as that lowers E.
    pub(super) fn teleport(&self, state: &mut State, attempts: usize) {
        /// So many splits without success end it.
        const PATIENCE: usize = 12;
        let mut failures = 0;
        for _ in 0..attempts {
            let Some(&worst) = state.costliest().get(failures) else {
                break;
            };
            let before = state.total();
            let limit = 0.999 * before;
            if self.split(state, worst, limit).is_some() && state.total() < limit {
                state.keep();
                failures = 0;
            } else {
                state.undo();
                failures += 1;
                if failures > PATIENCE {
                    break;
                }
            }
        }
    }

    /// Makes ball `split` two. The second is one that can be spared: its pieces go to the neighbours that grow
    /// least by it. None where E does not fall below `limit`.
    fn split(&self, state: &mut State, split: usize, limit: f64) -> Option<()> {
        let spare = self.spare(state, Some(split))?;
        let [first, second] = self.halved(&state.own(split));
        for (i, pieces) in [(split, first), (spare, second)] {
            state.set(i, self.place(&pieces, None, true));
        }
        // Those that grew, and those around the split, can be smaller now.
        let mut order = state.around(split, 6);
        order.extend([spare, split]);
        self.relieve(state, &order, true, limit)
    }

    /// Does without balls as long as that lowers E, as it does in a body that few balls fill.
    pub(super) fn prune(&self, state: &mut State) {
        while state.balls().iter().filter(|b| b.ball.radius > 0.0).count() > 1 {
            let before = state.total();
            if self.spare(state, None).is_none() || state.total() >= before {
                state.undo();
                break;
            }
            state.keep();
        }
    }

    /// Frees the ball that costs least to do without, and returns which: other than `split`, for which
    /// one that is free already serves best.
    fn spare(&self, state: &mut State, split: Option<usize>) -> Option<usize> {
        /// How many balls are looked at: those with the fewest pieces of their own.
        const CANDIDATES: usize = 8;
        let mut own: Vec<(usize, Vec<u32>)> = (0..state.balls().len())
            .filter(|&i| {
                Some(i) != split && (split.is_some() || state.balls()[i].ball.radius > 0.0)
            })
            .map(|i| (i, state.own(i)))
            .collect();
        own.sort_by_key(|(i, pieces)| (pieces.len(), *i));
        own.truncate(CANDIDATES);
        let without = |(i, pieces): &(usize, Vec<u32>)| {
            let grown = self.heirs(state, pieces, *i)?;
            let price = self.growth(state, &grown);
            Some((price - state.balls()[*i].outside, *i, grown))
        };
        let (_, spare, grown) = own
            .iter()
            .filter_map(without)
            .min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)))?;
        let free = self.place(&[], Some(state.balls()[spare].ball), false);
        state.set(spare, free);
        for (j, ball) in grown {
            state.set(j, self.placing.priced(ball));
        }
        Some(spare)
    }

    /// What balls that have grown cost more than before, roughly.
    fn growth(&self, state: &State, grown: &[(usize, Ball)]) -> f64 {
        let more = |(j, ball): &(usize, Ball)| {
            self.placing.rough(ball.center, ball.radius) - state.balls()[*j].outside
        };
        grown.iter().map(more).sum()
    }

    /// The neighbours of ball `i` that grow, as they are then, where each of the pieces goes to the one that has to
    /// grow least. None where there is no neighbour.
    fn heirs(&self, state: &State, pieces: &[u32], i: usize) -> Option<Vec<(usize, Ball)>> {
        let mut heirs: Vec<(usize, Ball)> = state
            .around(i, HEIRS)
            .into_iter()
            .map(|j| (j, state.balls()[j].ball))
            .collect();
        for &piece in pieces {
            let corners = self.pieces.corners(piece);
            let mut least = (0, f64::INFINITY, 0.0);
            for (k, (_, ball)) in heirs.iter().enumerate() {
                let needs = ball.needs(&corners);
                if needs - ball.radius < least.1 {
                    least = (k, needs - ball.radius, needs);
                }
            }
            let heir = &mut heirs.get_mut(least.0)?.1;
            heir.radius = heir.radius.max(least.2);
        }
        heirs.retain(|(j, ball)| ball.radius > state.balls()[*j].ball.radius);
        Some(heirs)
    }

    /// Gives the pieces that no ball holds to those that grow least by it.
    pub(super) fn complete(&self, state: &mut State) {
        let open: Vec<u32> = state.open();
        for piece in open {
            let corners = self.pieces.corners(piece);
            let growth =
                |i: usize| state.balls()[i].ball.needs(&corners) - state.balls()[i].ball.radius;
            let all = 0..state.balls().len();
            if let Some(i) = all.min_by(|&a, &b| growth(a).total_cmp(&growth(b)))
                && growth(i) > 0.0
            {
                let ball = state.balls()[i].ball;
                let grown = Ball {
                    center: ball.center,
                    radius: ball.needs(&corners),
                };
                state.set(i, self.placing.priced(grown));
            }
        }
    }

    /// Pieces in two halves: about the two that are farthest apart, and then about the halves' middles.
    pub(super) fn halved(&self, pieces: &[u32]) -> [Vec<u32>; 2] {
        let middles: Vec<DVec3> = pieces
            .iter()
            .map(|&i| self.pieces.middles[i as usize])
            .collect();
        if middles.is_empty() {
            return [Vec::new(), Vec::new()];
        }
        let a = farthest(&middles, middles[0]);
        let mut centers = [a, farthest(&middles, a)];
        let mut halves = [Vec::new(), Vec::new()];
        for _ in 0..4 {
            halves = [Vec::new(), Vec::new()];
            let mut sums = [DVec3::ZERO; 2];
            for (&piece, m) in pieces.iter().zip(&middles) {
                let side =
                    usize::from(m.distance_squared(centers[1]) < m.distance_squared(centers[0]));
                halves[side].push(piece);
                sums[side] += *m;
            }
            for side in 0..2 {
                if !halves[side].is_empty() {
                    centers[side] = sums[side] / halves[side].len() as f64;
                }
            }
        }
        halves
    }

    /// Moves at random: a ball is made smaller or larger a little way off, its neighbours make up for it, and what
    /// lowers E is kept. Clustering and teleportation end where no ball can be improved alone; what is left to
    /// gain lies between neighbours.
    pub(super) fn nudge(&self, state: &mut State, attempts: usize, random: &mut Random) {
        for _ in 0..attempts {
            let before = state.total();
            if self.nudged(state, before, random).is_some() && state.total() < before {
                state.keep();
            } else {
                state.undo();
            }
        }
    }

    fn nudged(&self, state: &mut State, before: f64, random: &mut Random) -> Option<()> {
        // The costlier a ball, the likelier.
        let mut rest = random.unit() * before;
        let i = state.balls().iter().position(|b| {
            rest -= b.outside;
            rest < 0.0
        })?;
        let old = state.balls()[i];
        let reach = random.unit();
        let ball = Ball {
            center: old.ball.center + random.in_ball() * (0.5 * reach * old.ball.radius),
            radius: old.ball.radius * (1.0 + reach * random.between(-0.5, 0.2)),
        };
        let own = state.own(i);
        let orphans: Vec<u32> = own
            .into_iter()
            .filter(|&piece| !ball.holds(&self.pieces.corners(piece)))
            .collect();
        let grown = self.heirs(state, &orphans, i)?;
        let moved = self.placing.rough(ball.center, ball.radius);
        let growth = self.growth(state, &grown);
        // Of the moves that helped in the end, hardly any cost more than this at first.
        if moved - old.outside + growth > 4.0 * old.outside {
            return None;
        }
        let mut touched: Vec<usize> = grown.iter().map(|(j, _)| *j).collect();
        state.set(i, self.placing.priced(ball));
        for (j, ball) in grown {
            state.set(j, self.placing.priced(ball));
        }
        touched.push(i);
        let near = state.around(i, 2 * HEIRS).into_iter().filter(|&j| {
            let other = state.balls()[j].ball;
            other.center.distance(ball.center) < other.radius + ball.radius && !touched.contains(&j)
        });
        let near: Vec<usize> = near.take(4).collect();
        touched.extend(near);
        self.relieve(state, &touched, false, before)
    }
}
