//! The balls of a fit while it is being improved, with what each holds; changes can be taken back.

use super::memory::Memory;
use super::pieces::Pieces;
use super::place::{Priced, total};
use super::proof::Ball;

/// Balls, and which holds which pieces.
pub(super) struct State<'a> {
    pieces: &'a Pieces,
    balls: Vec<Priced>,
    /// The pieces each ball holds.
    held: Vec<Vec<u32>>,
    /// How many balls hold each piece.
    holders: Vec<u32>,
    /// What balls were before they were changed, and what they held.
    journal: Vec<(usize, Priced, Vec<u32>)>,
    /// How balls were placed anew.
    pub(super) memory: Memory,
}

impl<'a> State<'a> {
    pub(super) fn new(pieces: &'a Pieces, balls: Vec<Priced>) -> Self {
        let held: Vec<Vec<u32>> = balls.iter().map(|b| pieces.held(&b.ball)).collect();
        let mut holders = vec![0; pieces.len()];
        for &piece in held.iter().flatten() {
            holders[piece as usize] += 1;
        }
        Self {
            pieces,
            memory: Memory::new(balls.len()),
            balls,
            held,
            holders,
            journal: Vec::new(),
        }
    }

    pub(super) fn balls(&self) -> &[Priced] {
        &self.balls
    }

    /// The balls in use.
    pub(super) fn into_balls(self) -> Vec<Ball> {
        let balls = self.balls.into_iter().map(|priced| priced.ball);
        balls.filter(|ball| ball.radius > 0.0).collect()
    }

    /// E of equation (35).
    pub(super) fn total(&self) -> f64 {
        total(&self.balls)
    }

    /// The pieces that ball `i` alone holds.
    pub(super) fn own(&self, i: usize) -> Vec<u32> {
        let alone = |piece: &u32| self.holders[*piece as usize] == 1;
        self.held[i].iter().copied().filter(alone).collect()
    }

    /// The pieces that no ball holds.
    pub(super) fn open(&self) -> Vec<u32> {
        let all = 0..self.holders.len() as u32;
        all.filter(|&piece| self.holders[piece as usize] == 0)
            .collect()
    }

    /// Puts another ball in the place of ball `i`.
    pub(super) fn set(&mut self, i: usize, ball: Priced) {
        let held = self.pieces.held(&ball.ball);
        let before = std::mem::replace(&mut self.balls[i], ball);
        let held_before = self.exchange(i, held);
        self.journal.push((i, before, held_before));
    }

    fn exchange(&mut self, i: usize, held: Vec<u32>) -> Vec<u32> {
        for &piece in &self.held[i] {
            self.holders[piece as usize] -= 1;
        }
        for &piece in &held {
            self.holders[piece as usize] += 1;
        }
        std::mem::replace(&mut self.held[i], held)
    }

    /// Makes all changes so far final.
    pub(super) fn keep(&mut self) {
        self.journal.clear();
    }

    /// Takes all changes back since [`State::keep`].
    pub(super) fn undo(&mut self) {
        while let Some((i, ball, held)) = self.journal.pop() {
            self.balls[i] = ball;
            self.exchange(i, held);
        }
    }

    /// The balls by their outside volume, largest first.
    pub(super) fn costliest(&self) -> Vec<usize> {
        let outside = |i: usize| self.balls[i].outside;
        let mut order: Vec<usize> = (0..self.balls.len()).collect();
        order.sort_by(|&a, &b| outside(b).total_cmp(&outside(a)).then(a.cmp(&b)));
        order
    }

    /// The `count` balls in use that come nearest to ball `i`, nearest first, without itself.
    pub(super) fn around(&self, i: usize, count: usize) -> Vec<usize> {
        let center = self.balls[i].ball.center;
        let gap = |j: usize| {
            let ball = self.balls[j].ball;
            ball.center.distance(center) - ball.radius
        };
        let mut others: Vec<(f64, usize)> = (0..self.balls.len())
            .filter(|&j| j != i && self.balls[j].ball.radius > 0.0)
            .map(|j| (gap(j), j))
            .collect();
        let by_gap = |a: &(f64, usize), b: &(f64, usize)| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1));
        if others.len() > count {
            others.select_nth_unstable_by(count, by_gap);
            others.truncate(count);
        }
        others.sort_by(by_gap);
        others.into_iter().map(|(_, j)| j).collect()
    }
}
