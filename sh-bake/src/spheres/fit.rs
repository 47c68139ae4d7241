//! The search for spheres that bound a surface and have little volume outside it.
//!
//! The measure is equation (35) of Ren et al. 2006, E = Σ V(Sᵢ − T). As in their section 6.2 the search
//! alternates, after Lloyd 1982, between giving each piece of the surface to the sphere that needs least
//! outside volume to reach it and moving each sphere to where it bounds its pieces with least outside
//! volume. Two things are different. A sphere is moved by a pattern search that starts from several depths
//! under its pieces, instead of Powell's method, so that it finds the middle of the body. And since pieces
//! near a border lie in several spheres, every sphere in turn is relieved of what others hold
//! ([`Fit::relieve`]): that only ever lowers E and sets spheres free, which then split the worst ones
//! (teleportation, after Cohen-Steiner et al. 2004).

use super::place::{self, Priced, TIE};
use super::solid::{Disc, Solid};
use super::surface::{Ball, Surface};
use glam::DVec3;
use rayon::prelude::*;

/// What the search works on.
pub(crate) struct Fit<'a> {
    surface: &'a Surface,
    solid: &'a Solid,
    disc: Disc,
    /// Of each piece: its middle, and its normal times its area.
    middles: Vec<DVec3>,
    normals: Vec<DVec3>,
}

impl<'a> Fit<'a> {
    pub(crate) fn new(surface: &'a Surface, solid: &'a Solid) -> Self {
        let corners = |i| surface.corners(i);
        let middles = (0..surface.pieces.len())
            .map(corners)
            .map(|[a, b, c]| (a + b + c) / 3.0);
        let normals = (0..surface.pieces.len())
            .map(corners)
            .map(|[a, b, c]| (b - a).cross(c - a) * 0.5);
        Self {
            surface,
            solid,
            disc: Disc::new(80),
            middles: middles.collect(),
            normals: normals.collect(),
        }
    }

    /// At most `count` balls that together hold every piece.
    pub(crate) fn run(&self, count: usize) -> Vec<Ball> {
        let count = count.min(self.middles.len());
        let mut clusters = self.seed(count);
        let mut best: Vec<Priced> = Vec::new();
        // Effort shrinks as the set grows: each round costs about pieces × spheres.
        let rounds = (256 / count).clamp(1, 3);
        for round in 0..rounds {
            let mut balls: Vec<Priced> = clusters
                .par_iter()
                .map(|pieces| self.place(pieces, None))
                .collect();
            for _ in 0..3 {
                clusters = self.assign(&balls);
                balls = clusters
                    .par_iter()
                    .zip(&balls)
                    .map(|(pieces, old)| self.place(pieces, Some(old.ball)))
                    .collect();
            }
            self.relieve(&mut balls);
            self.teleport(&mut balls, count.clamp(8, 128));
            self.relieve(&mut balls);
            if round == 0 || total(&balls) < total(&best) {
                best = balls.clone();
            }
            clusters = self.assign(&balls);
        }
        self.prune(&mut best);
        best.iter()
            .map(|priced| priced.ball)
            .filter(|ball| ball.radius > 0.0)
            .collect()
    }

    /// The first clusters: seeds as far from each other as can be, then a few rounds of plain k-means over
    /// the middles of the pieces.
    fn seed(&self, count: usize) -> Vec<Vec<u32>> {
        let middle = self.middles.iter().sum::<DVec3>() / self.middles.len() as f64;
        let mut centers = vec![farthest(&self.middles, |m| m.distance_squared(middle))];
        let mut distance = vec![f64::INFINITY; self.middles.len()];
        while centers.len() < count {
            let newest = centers[centers.len() - 1];
            for (d, m) in distance.iter_mut().zip(&self.middles) {
                *d = d.min(m.distance_squared(newest));
            }
            let next = (0..distance.len()).max_by(|&a, &b| distance[a].total_cmp(&distance[b]));
            centers.extend(next.map(|i| self.middles[i]));
        }
        let mut clusters = Vec::new();
        for _ in 0..4 {
            let nearest: Vec<usize> = self
                .middles
                .par_iter()
                .map(|m| least(centers.iter().map(|c| m.distance_squared(*c))))
                .collect();
            clusters = grouped(&nearest, count);
            for (center, pieces) in centers.iter_mut().zip(&clusters) {
                if !pieces.is_empty() {
                    let sum: DVec3 = pieces.iter().map(|&i| self.middles[i as usize]).sum();
                    *center = sum / pieces.len() as f64;
                }
            }
        }
        clusters
    }

    /// Gives each piece to the ball that needs least outside volume to hold it.
    fn assign(&self, balls: &[Priced]) -> Vec<Vec<u32>> {
        /// Radii at which a ball's outside volume is tabulated: up to twice its own.
        const STEPS: usize = 16;
        let tables: Vec<[f64; STEPS + 1]> = balls
            .par_iter()
            .map(|b| {
                std::array::from_fn(|k| {
                    let radius = b.ball.radius * 2.0 * k as f64 / STEPS as f64;
                    // The small share of the whole ball breaks ties between balls inside the solid.
                    self.solid.outside(b.ball.center, radius, &self.disc) + TIE * radius.powi(3)
                })
            })
            .collect();
        let price = |i: usize, radius: f64| {
            let at = radius / balls[i].ball.radius * (STEPS as f64 / 2.0);
            let k = at as usize;
            if k < STEPS {
                tables[i][k] + (tables[i][k + 1] - tables[i][k]) * (at - k as f64)
            } else {
                // Farther out: as the ball's volume grows.
                tables[i][STEPS] + 4.19 * (radius.powi(3) - (2.0 * balls[i].ball.radius).powi(3))
            }
        };
        let owner: Vec<usize> = (0..self.middles.len())
            .into_par_iter()
            .map(|piece| {
                let corners = self.surface.corners(piece);
                least(balls.iter().enumerate().map(|(i, b)| match b.ball.radius {
                    0.0 => f64::INFINITY,
                    _ => price(i, b.ball.needs(&corners)),
                }))
            })
            .collect();
        grouped(&owner, balls.len())
    }

    /// The ball that holds the given pieces with least outside volume that a search finds, from `old` among
    /// other places; one of radius 0 for no pieces.
    fn place(&self, pieces: &[u32], old: Option<Ball>) -> Priced {
        let mut ids: Vec<u32> = pieces
            .iter()
            .flat_map(|&i| self.surface.pieces[i as usize])
            .collect();
        ids.sort_unstable();
        ids.dedup();
        let points: Vec<DVec3> = ids
            .iter()
            .map(|&i| self.surface.points[i as usize])
            .collect();
        let old = old.map(|ball| ball.center);
        if points.is_empty() {
            let ball = Ball {
                center: old.unwrap_or_default(),
                radius: 0.0,
            };
            return Priced { ball, outside: 0.0 };
        }
        let normal: DVec3 = pieces.iter().map(|&i| self.normals[i as usize]).sum();
        place::place(
            self.solid,
            &self.disc,
            &points,
            normal.normalize_or_zero(),
            old,
        )
    }

    /// The pieces that a ball holds.
    fn held(&self, ball: &Ball) -> Vec<u32> {
        let squared = ball.radius * ball.radius;
        let holds = |&piece: &u32| {
            self.middles[piece as usize].distance_squared(ball.center) <= squared
                && ball.holds(&self.surface.corners(piece as usize))
        };
        (0..self.middles.len() as u32).filter(holds).collect()
    }

    /// Relieves each ball in turn, the costliest first, of the pieces that another one holds as well, and
    /// places it anew around the rest. Repeats until that gains little.
    fn relieve(&self, balls: &mut [Priced]) {
        let mut cover = Cover::new(self, balls);
        for _ in 0..6 {
            let before = total(balls);
            let order = costliest(balls);
            self.relieve_some(balls, &mut cover, &order);
            if total(balls) > 0.99 * before {
                break;
            }
        }
    }

    /// Relieves the balls named in `order`, once.
    fn relieve_some(&self, balls: &mut [Priced], cover: &mut Cover, order: &[usize]) {
        for &i in order {
            let own = cover.own(i);
            let placed = self.place(&own, Some(balls[i].ball));
            if own.is_empty() || placed.outside < balls[i].outside {
                balls[i] = placed;
                cover.update(self, balls, i);
            }
        }
    }

    /// Splits the costliest balls as long as that lowers E: of a few at a time the best.
    fn teleport(&self, balls: &mut Vec<Priced>, attempts: usize) {
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
    fn prune(&self, balls: &mut Vec<Priced>) {
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

/// Which ball holds which pieces.
#[derive(Clone)]
struct Cover {
    /// The pieces each ball holds.
    held: Vec<Vec<u32>>,
    /// How many balls hold each piece.
    holders: Vec<u32>,
}

impl Cover {
    fn new(fit: &Fit, balls: &[Priced]) -> Self {
        let held: Vec<Vec<u32>> = balls.par_iter().map(|b| fit.held(&b.ball)).collect();
        let mut holders = vec![0; fit.middles.len()];
        for &piece in held.iter().flatten() {
            holders[piece as usize] += 1;
        }
        Self { held, holders }
    }

    /// The pieces that ball `i` alone holds.
    fn own(&self, i: usize) -> Vec<u32> {
        self.held[i]
            .iter()
            .copied()
            .filter(|&piece| self.holders[piece as usize] == 1)
            .collect()
    }

    /// Enters ball `i`, which has changed.
    fn update(&mut self, fit: &Fit, balls: &[Priced], i: usize) {
        for &piece in &self.held[i] {
            self.holders[piece as usize] -= 1;
        }
        self.held[i] = fit.held(&balls[i].ball);
        for &piece in &self.held[i] {
            self.holders[piece as usize] += 1;
        }
    }
}

/// The balls by their outside volume, largest first.
fn costliest(balls: &[Priced]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..balls.len()).collect();
    order.sort_by(|&a, &b| {
        balls[b]
            .outside
            .total_cmp(&balls[a].outside)
            .then(a.cmp(&b))
    });
    order
}

/// E of equation (35).
fn total(balls: &[Priced]) -> f64 {
    balls.iter().map(|b| b.outside).sum()
}

/// Where the least value stands; the first of equals.
fn least(values: impl Iterator<Item = f64>) -> usize {
    values
        .enumerate()
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map_or(0, |(i, _)| i)
}

/// The point of largest `measure`. `points` is not empty.
fn farthest(points: &[DVec3], measure: impl Fn(&DVec3) -> f64) -> DVec3 {
    points
        .iter()
        .max_by(|a, b| measure(a).total_cmp(&measure(b)))
        .copied()
        .unwrap_or_default()
}

/// Indices by the group they belong to.
fn grouped(group: &[usize], count: usize) -> Vec<Vec<u32>> {
    let mut groups = vec![Vec::new(); count];
    for (i, &g) in group.iter().enumerate() {
        groups[g].push(i as u32);
    }
    groups
}
