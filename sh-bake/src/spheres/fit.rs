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

use super::cover::Cover;
use super::place::{self, Priced, TIE};
use super::solid::{Disc, Solid};
use super::surface::{Ball, Surface};
use glam::DVec3;
use rayon::prelude::*;

/// What the search works on.
pub(crate) struct Fit<'a> {
    pub(super) surface: &'a Surface,
    pub(super) solid: &'a Solid,
    pub(super) disc: Disc,
    /// Of each piece: its middle, and its normal times its area.
    pub(super) middles: Vec<DVec3>,
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
    pub(super) fn place(&self, pieces: &[u32], old: Option<Ball>) -> Priced {
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
    pub(super) fn held(&self, ball: &Ball) -> Vec<u32> {
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
    pub(super) fn relieve_some(&self, balls: &mut [Priced], cover: &mut Cover, order: &[usize]) {
        for &i in order {
            let own = cover.own(i);
            let placed = self.place(&own, Some(balls[i].ball));
            if own.is_empty() || placed.outside < balls[i].outside {
                balls[i] = placed;
                cover.update(self, balls, i);
            }
        }
    }
}

/// The balls by their outside volume, largest first.
pub(super) fn costliest(balls: &[Priced]) -> Vec<usize> {
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
pub(super) fn total(balls: &[Priced]) -> f64 {
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
pub(super) fn farthest(points: &[DVec3], measure: impl Fn(&DVec3) -> f64) -> DVec3 {
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
