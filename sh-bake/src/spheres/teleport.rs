//! Moves that change which balls there are: the costliest are split, and those that can be spared go.

use super::cover::Cover;
use super::fit::{Fit, costliest, farthest, total};
use super::place::Priced;
use super::surface::Ball;
use glam::DVec3;
use rayon::prelude::*;

impl Fit<'_> {
    /// Splits the costliest balls as long as that lowers E: of a few at a time the best.
    pub(super) fn teleport(&self, balls: &mut Vec<Priced>, attempts: usize) {
        /// How many splits are tried side by side, and how many such groups without success end it.
        const GROUP: usize = 4;
        const PATIENCE: usize = 3;
        let mut cover = Cover::new(self, balls);
        let mut failures = 0;
        for _ in 0..attempts {
            let worst = costliest(balls);
            let group = worst.iter().skip(failures * GROUP).take(GROUP).enumerate();
            let best = group
                .collect::<Vec<_>>()
                .into_par_iter()
                .filter_map(|(place, &i)| Some((place, self.split(balls, &cover, i)?)))
                .min_by(|(a, (x, _)), (b, (y, _))| total(x).total_cmp(&total(y)).then(a.cmp(b)));
            match best {
                Some((_, trial)) if total(&trial.0) < 0.997 * total(balls) => {
                    (*balls, cover) = trial;
                    failures = 0;
                }
                _ if failures + 1 < PATIENCE => failures += 1,
                _ => break,
            }
        }
    }

    /// The set with ball `split` made two. The second is one that can be spared: its pieces go to the
    /// neighbours that grow least by it.
    fn split(&self, balls: &[Priced], cover: &Cover, split: usize) -> Option<(Vec<Priced>, Cover)> {
        let (mut trial, mut cover) = (balls.to_vec(), cover.clone());
        let spare = self.spare(&mut trial, &mut cover, Some(split))?;
        let [first, second] = self.halved(&cover.own(split));
        for (i, pieces) in [(split, first), (spare, second)] {
            trial[i] = self.place(&pieces, None);
            cover.update(self, &trial, i);
        }
        // Those that grew, and those around the split, can be smaller now.
        let center = balls[split].ball.center;
        let distance = |i: usize| trial[i].ball.center.distance(center) - trial[i].ball.radius;
        let mut near: Vec<usize> = (0..trial.len())
            .filter(|&i| trial[i].ball.radius > 0.0)
            .collect();
        near.sort_by(|&a, &b| distance(a).total_cmp(&distance(b)).then(a.cmp(&b)));
        near.truncate(6);
        let grown = |i: &usize| trial[*i].ball != balls[*i].ball && !near.contains(i);
        let order: Vec<usize> = (0..trial.len())
            .filter(grown)
            .chain(near.iter().copied())
            .collect();
        self.relieve_some(&mut trial, &mut cover, &order);
        Some((trial, cover))
    }

    /// Does without balls as long as that lowers E, as it does in a body that few balls fill.
    pub(super) fn prune(&self, balls: &mut Vec<Priced>) {
        let mut cover = Cover::new(self, balls);
        while balls.iter().filter(|b| b.ball.radius > 0.0).count() > 1 {
            let (mut trial, mut trial_cover) = (balls.clone(), cover.clone());
            let spared = self.spare(&mut trial, &mut trial_cover, None);
            if spared.is_none() || total(&trial) >= total(balls) {
                break;
            }
            (*balls, cover) = (trial, trial_cover);
        }
    }

    /// Frees the ball that costs least to do without, and returns which: other than `split`, for which
    /// one that is free already serves best.
    fn spare(
        &self,
        balls: &mut [Priced],
        cover: &mut Cover,
        split: Option<usize>,
    ) -> Option<usize> {
        /// How many balls are looked at: those with the fewest pieces of their own.
        const CANDIDATES: usize = 8;
        let mut own: Vec<(usize, Vec<u32>)> = (0..balls.len())
            .filter(|&i| Some(i) != split && (split.is_some() || balls[i].ball.radius > 0.0))
            .map(|i| (i, cover.own(i)))
            .collect();
        own.sort_by_key(|(i, pieces)| (pieces.len(), *i));
        own.truncate(CANDIDATES);
        let without = |(i, pieces): &(usize, Vec<u32>)| {
            // Radii the others need once they have taken over.
            let mut radii: Vec<f64> = balls.iter().map(|b| b.ball.radius).collect();
            for &piece in pieces {
                let corners = self.surface.corners(piece as usize);
                let growth = |j: usize| balls[j].ball.needs(&corners) - radii[j];
                let others = (0..balls.len()).filter(|j| j != i && radii[*j] > 0.0);
                let j = others.min_by(|&a, &b| growth(a).total_cmp(&growth(b)))?;
                radii[j] = radii[j].max(balls[j].ball.needs(&corners));
            }
            let grown: Vec<(usize, Priced)> = (0..balls.len())
                .filter(|&j| radii[j] > balls[j].ball.radius)
                .map(|j| {
                    (
                        j,
                        self.priced(Ball {
                            center: balls[j].ball.center,
                            radius: radii[j],
                        }),
                    )
                })
                .collect();
            let price: f64 = grown
                .iter()
                .map(|(j, b)| b.outside - balls[*j].outside)
                .sum();
            Some((price - balls[*i].outside, *i, grown))
        };
        let (_, spare, grown) = own
            .iter()
            .filter_map(without)
            .min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)))?;
        balls[spare] = self.place(&[], Some(balls[spare].ball));
        cover.update(self, balls, spare);
        for (j, priced) in grown {
            balls[j] = priced;
            cover.update(self, balls, j);
        }
        Some(spare)
    }

    fn priced(&self, ball: Ball) -> Priced {
        Priced {
            ball,
            outside: self.solid.outside(ball.center, ball.radius, &self.disc),
        }
    }

    /// Pieces in two halves: about the two that are farthest apart, and then about the halves' middles.
    fn halved(&self, pieces: &[u32]) -> [Vec<u32>; 2] {
        let middles: Vec<DVec3> = pieces.iter().map(|&i| self.middles[i as usize]).collect();
        if middles.is_empty() {
            return [Vec::new(), Vec::new()];
        }
        let a = farthest(&middles, |m| m.distance_squared(middles[0]));
        let mut centers = [a, farthest(&middles, |m| m.distance_squared(a))];
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
}
