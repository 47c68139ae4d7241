//! The search for spheres that bound a body and have little volume outside it.
//!
//! The measure is equation (35) of Ren et al. 2006, E = Σ V(Sᵢ − T), and the way is that of their section 6.2 (after
//! Wang et al. 2006). The body is cut into pieces, of the surface and of a grid inside ([`super::pieces`]). Clusters of
//! pieces, made by flood fill ([`super::flood`]), and spheres about them, placed where they have least volume outside
//! ([`super::place`]), take turns (Lloyd 1982) as long as E falls. Then spheres are teleported (Cohen-Steiner et al.
//! 2004) until that does not help either ([`super::moves`]).
//!
//! Two things go beyond the paper, and together they lower E by a quarter:
//! - Pieces near a border lie in several spheres. So every sphere in turn is relieved of what others hold, which
//!   only ever lowers E, and spheres are nudged at random, their neighbours making up for it. That finds what is
//!   to gain between neighbours, where neither clustering nor teleportation looks.
//! - A sphere must hold whole pieces, and so overlaps its neighbours by half a piece. Where spheres meet, pieces are
//!   therefore cut finer, and the set is fitted anew to them, several times over.
//!
//! The search runs from three beginnings: seeds far apart, the body halved again and again, and that once more
//! without any move that could lose its order, because a grid of spheres is hard to beat where the body is a box.

use super::fit::Fit;
use super::flood::Neighbours;
use super::pieces::Pieces;
use super::place::{Priced, total};
use super::proof::Ball;
use super::random::Random;
use super::solid::{Disc, Solid};
use super::start::Beginning;
use super::state::State;
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Beginnings of the search.
const STARTS: usize = 3;
/// Rounds of clustering at most; fewer where one gains little.
const CLUSTERINGS: usize = 6;
/// Rounds of nudges and teleportation at most; fewer where one gains less than [`GAIN`].
const ROUNDS: usize = 4;
/// How often pieces are cut finer.
const REFINEMENTS: usize = 3;
/// A round that lowers E by less than this share is the last.
const GAIN: f64 = 0.01;
/// Sets that are worse than the best by more than this share are not refined.
const HOPE: f64 = 0.03;

/// Tells how much is done.
struct Steps<'a> {
    tell: &'a (dyn Fn(f32) + Sync),
    done: AtomicUsize,
}

impl Steps<'_> {
    /// In units of a round: the searches, and the refinements of one set.
    const ALL: usize = STARTS * (ROUNDS + 1) + 4 * REFINEMENTS;

    fn add(&self, steps: usize) {
        let done = self.done.fetch_add(steps, Ordering::Relaxed) + steps;
        (self.tell)((done as f32 / Self::ALL as f32).min(1.0));
    }
}

/// At most `count` balls that hold every piece of the body; `progress` is told the part that is
/// done.
pub(super) fn fit(
    pieces: &Pieces,
    solid: &Solid,
    count: usize,
    progress: &(dyn Fn(f32) + Sync),
) -> Vec<Ball> {
    let count = count.min(pieces.len());
    // One ball has no neighbours to gain from.
    let starts = if count == 1 { 1 } else { STARTS };
    let steps = Steps {
        tell: progress,
        done: AtomicUsize::new(0),
    };
    let exact = Disc::new(4096);
    let rated = |balls: Vec<Ball>| {
        let outside = |b: &Ball| solid.outside(b.center, b.radius, &exact);
        (balls.iter().map(outside).sum::<f64>(), balls)
    };
    let search = Fit::new(pieces, solid, Disc::new(40));
    let neighbours = search.neighbours();
    let (scattered, halved) = rayon::join(
        || search.scattered(count),
        || (starts > 1).then(|| search.halved_often(count)),
    );
    let from = |start: usize| {
        let beginning = halved.as_ref().filter(|_| start > 0).unwrap_or(&scattered);
        rated(search.from(start, beginning, &neighbours, &steps))
    };
    let mut sets: Vec<(f64, Vec<Ball>)> = (0..starts).into_par_iter().map(from).collect();
    let least = sets.iter().map(|(e, _)| *e).fold(f64::INFINITY, f64::min);
    sets.retain(|(e, _)| *e <= (1.0 + HOPE) * least);

    let shares = 4 / sets.len();
    let refine = |(e, balls): (f64, Vec<Ball>)| {
        let mut best = (e, balls.clone());
        let (mut balls, mut finer) = (balls, pieces.refined(&best.1));
        for k in 0..REFINEMENTS {
            balls = Fit::new(&finer, solid, Disc::new(200)).again(&balls);
            let now = rated(balls.clone());
            if now.0 < best.0 {
                best = now;
            }
            steps.add(shares);
            if k + 1 < REFINEMENTS {
                finer = finer.refined(&balls);
            }
        }
        best
    };
    let refined: Vec<(f64, Vec<Ball>)> = sets.into_par_iter().map(refine).collect();
    let best = refined.into_iter().min_by(|a, b| a.0.total_cmp(&b.0));
    progress(1.0);
    best.map_or_else(Vec::new, |(_, balls)| balls)
}

impl Fit<'_> {
    /// A search from one of the beginnings.
    fn from(
        &self,
        start: usize,
        beginning: &Beginning,
        neighbours: &Neighbours,
        steps: &Steps,
    ) -> Vec<Ball> {
        let Beginning {
            mut clusters,
            mut balls,
        } = beginning.clone();
        let count = balls.len();
        let moving = start < 2 && count > 1;
        for _ in 0..if moving { CLUSTERINGS } else { 0 } {
            clusters = self.flood(&clusters, &balls, neighbours);
            let next: Vec<Priced> = clusters
                .par_iter()
                .zip(&balls)
                .map(|(pieces, old)| self.place(pieces, Some(old.ball), true))
                .collect();
            let falls = total(&next) < 0.97 * total(&balls);
            if total(&next) < total(&balls) {
                balls = next;
            }
            if !falls {
                break;
            }
        }
        let mut state = State::new(self.pieces, balls);
        self.relieve_all(&mut state);
        steps.add(1);
        if moving {
            self.improve(&mut state, count, start as u64, steps);
        } else {
            steps.add(ROUNDS);
        }
        self.prune(&mut state);
        state.into_balls()
    }

    /// Nudges and teleports balls until that gains little.
    fn improve(&self, state: &mut State, count: usize, seed: u64, steps: &Steps) {
        let mut random = Random(seed);
        self.teleport(state, (4 * count).min(512));
        for round in 0..ROUNDS {
            let before = state.total();
            self.nudge(state, (16 * count).clamp(600, 1000), &mut random);
            self.teleport(state, count.min(128));
            steps.add(1);
            if state.total() > (1.0 - GAIN) * before || state.total() <= 0.0 {
                steps.add(ROUNDS - 1 - round);
                break;
            }
        }
    }

    /// A set for coarser pieces, fitted to these.
    fn again(&self, balls: &[Ball]) -> Vec<Ball> {
        let priced = balls.iter().map(|ball| self.placing.priced(*ball));
        let mut state = State::new(self.pieces, priced.collect());
        self.complete(&mut state);
        self.relieve_all(&mut state);
        self.nudge(&mut state, 200, &mut Random(balls.len() as u64));
        self.relieve_all(&mut state);
        self.prune(&mut state);
        state.into_balls()
    }
}
