//! Clusters by flood fill, after section 6.2 of Ren et al. 2006.
//!
//! From the pieces at the balls' centres outward, the piece that costs least goes to the ball that it costs least. The
//! cost is the volume that the ball has outside the body once it has grown to hold the piece. A cluster grows from
//! piece to neighbouring piece, so that it does not leap across a gap.

use super::fit::Fit;
use super::place::{Priced, TIE};
use super::solid::greater;
use super::start::{grouped, least};
use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap};

/// Radii at which a ball's outside volume is tabulated, up to twice its own.
const RADII: usize = 16;

/// What it would cost to give a piece to a ball, as one number: the cost, the piece, the ball, in this order. The
/// greatest is the cheapest, for a heap that hands out the greatest.
type Offer = Reverse<u128>;

fn offer(cost: f64, piece: u32, ball: u32) -> Offer {
    // Bits of numbers from 0 upwards are in the order of the numbers, those below 0 in the opposite one.
    let bits = cost.to_bits();
    let sign = 1 << 63;
    let ordered = if bits & sign == 0 { bits | sign } else { !bits };
    Reverse(u128::from(ordered) << 64 | u128::from(piece) << 32 | u128::from(ball))
}

/// The cost, the piece and the ball of an offer.
fn terms(Reverse(offer): Offer) -> (f64, u32, u32) {
    let ordered = (offer >> 64) as u64;
    let sign = 1 << 63;
    let bits = if ordered & sign == 0 {
        !ordered
    } else {
        ordered ^ sign
    };
    (f64::from_bits(bits), (offer >> 32) as u32, offer as u32)
}

/// What balls cost by their radius.
struct Prices<'a> {
    balls: &'a [Priced],
    tables: Vec<[f64; RADII + 1]>,
}

impl Prices<'_> {
    fn at(&self, ball: usize, radius: f64) -> f64 {
        let own = self.balls[ball].ball.radius;
        if own <= 0.0 {
            return f64::INFINITY;
        }
        let table = &self.tables[ball];
        let at = radius / own * (RADII as f64 / 2.0);
        let k = at as usize;
        if k < RADII {
            let price = table[k] + (table[k + 1] - table[k]) * (at - k as f64);
            price.min(table[k + 1])
        } else {
            // Farther out: as the ball's volume grows.
            table[RADII] + 4.19 * (radius.powi(3) - (2.0 * own).powi(3))
        }
    }
}

impl Fit<'_> {
    /// New clusters about the balls, whose clusters so far are given.
    pub(super) fn flood(
        &self,
        clusters: &[Vec<u32>],
        balls: &[Priced],
        neighbours: &Neighbours,
    ) -> Vec<Vec<u32>> {
        let table = |b: &Priced| {
            let mut least = 0.0;
            std::array::from_fn(|k| {
                let radius = b.ball.radius * 2.0 * k as f64 / RADII as f64;
                // The small share of the whole ball breaks ties between balls inside the solid.
                let price = self.placing.rough(b.ball.center, radius) + TIE * radius.powi(3);
                // A larger ball costs no less, whatever few chords make of it.
                least = greater(least, price);
                least
            })
        };
        let prices = Prices {
            balls,
            tables: balls.iter().map(table).collect(),
        };
        let needs = |ball: usize, piece: u32| balls[ball].ball.needs(&self.pieces.corners(piece));
        let mut radii = vec![0.0_f64; balls.len()];
        let mut owner = vec![usize::MAX; self.pieces.len()];
        // One offer of each ball for each piece will do: it is made anew when its ball has grown.
        let words = balls.len().div_ceil(64);
        let mut offered = vec![0_u64; words * self.pieces.len()];
        let mut is_new = |piece: u32, ball: usize| {
            let word = &mut offered[piece as usize * words + ball / 64];
            let before = *word;
            *word |= 1 << (ball % 64);
            *word != before
        };
        let mut offers = BinaryHeap::new();
        for (ball, cluster) in clusters.iter().enumerate() {
            let center = balls[ball].ball.center;
            let distance = |i: u32| self.pieces.middles[i as usize].distance_squared(center);
            let nearest = cluster
                .iter()
                .copied()
                .min_by(|&a, &b| distance(a).total_cmp(&distance(b)));
            offers.extend(
                nearest.map(|piece| offer(prices.at(ball, needs(ball, piece)), piece, ball as u32)),
            );
        }
        while let Some((cost, piece, ball)) = offers.pop().map(terms) {
            if owner[piece as usize] != usize::MAX {
                continue;
            }
            let i = ball as usize;
            let radius = needs(i, piece).max(radii[i]);
            let now = prices.at(i, radius);
            if now > cost {
                // The ball has grown since.
                offers.push(offer(now, piece, ball));
                continue;
            }
            radii[i] = radius;
            owner[piece as usize] = i;
            for &other in neighbours.of(piece) {
                if owner[other as usize] == usize::MAX && is_new(other, i) {
                    let cost = prices.at(i, needs(i, other).max(radius));
                    offers.push(offer(cost, other, ball));
                }
            }
        }
        // What no flood has reached.
        for (piece, owner) in owner
            .iter_mut()
            .enumerate()
            .filter(|(_, owner)| **owner == usize::MAX)
        {
            let cost = |i: usize| prices.at(i, needs(i, piece as u32).max(radii[i]));
            *owner = least((0..balls.len()).map(cost));
        }
        grouped(&owner, balls.len())
    }

    /// Which pieces are neighbours: those at a common point, and those of which one is inside whose middles lie in
    /// cells of a grid that touch.
    pub(super) fn neighbours(&self) -> Neighbours {
        let pieces = self.pieces;
        let mut pairs: Vec<u64> = Vec::new();
        let pair = |a: u32, b: u32| u64::from(a) << 32 | u64::from(b);
        let mut at_point = vec![Vec::new(); pieces.points.len()];
        for piece in 0..pieces.len() as u32 {
            for &point in &pieces.corners[piece as usize] {
                at_point[point as usize].push(piece);
            }
        }
        for around in &at_point {
            for &a in around {
                pairs.extend(around.iter().filter(|b| **b != a).map(|&b| pair(a, b)));
            }
        }
        if pieces.spacing <= 0.0 {
            // There are no points inside.
            return Neighbours::new(pieces.len(), pairs);
        }
        let cell = |piece: u32| {
            let at = pieces.middles[piece as usize] / pieces.spacing;
            at.to_array().map(|c| c.floor() as i64)
        };
        let mut cells: HashMap<[i64; 3], Vec<u32>> = HashMap::new();
        for piece in 0..pieces.len() as u32 {
            cells.entry(cell(piece)).or_default().push(piece);
        }
        for a in (0..pieces.len() as u32).filter(|&a| pieces.is_inside(a)) {
            let [x, y, z] = cell(a);
            for k in 0..27 {
                let beside = [(x, k % 3), (y, k / 3 % 3), (z, k / 9)]
                    .map(|(at, k)| at.saturating_add(k - 1));
                for &b in cells
                    .get(&beside)
                    .into_iter()
                    .flatten()
                    .filter(|b| **b != a)
                {
                    pairs.push(pair(a, b));
                    if !pieces.is_inside(b) {
                        pairs.push(pair(b, a));
                    }
                }
            }
        }
        Neighbours::new(pieces.len(), pairs)
    }
}

/// The neighbours of piece i are `all[starts[i]..starts[i + 1]]`.
pub(super) struct Neighbours {
    starts: Vec<u32>,
    all: Vec<u32>,
}

impl Neighbours {
    /// Of pairs that are one number: a piece, and below it the neighbour.
    fn new(count: usize, mut pairs: Vec<u64>) -> Self {
        pairs.sort_unstable();
        pairs.dedup();
        let mut starts = vec![0; count + 1];
        for pair in &pairs {
            starts[(pair >> 32) as usize + 1] += 1;
        }
        for i in 0..count {
            starts[i + 1] += starts[i];
        }
        let all = pairs.into_iter().map(|pair| pair as u32).collect();
        Self { starts, all }
    }

    fn of(&self, piece: u32) -> &[u32] {
        let i = piece as usize;
        &self.all[self.starts[i] as usize..self.starts[i + 1] as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cheapest_offer_comes_first_and_is_what_was_put_in() {
        let sorted = [
            (-2.0, 7, 1),
            (-1e-300, 0, 3),
            (0.0, 5, 0),
            (1e-9, 2, 8),
            (1.0, 4, 2),
            (1.0, 4, 6),
            (1.0, 5, 1),
            (f64::INFINITY, 0, 0),
        ];
        // In some other order.
        let mut offers: BinaryHeap<Offer> = (0..sorted.len())
            .map(|k| sorted[3 * k % sorted.len()])
            .map(|(cost, piece, ball)| offer(cost, piece, ball))
            .collect();
        for expected in sorted {
            assert_eq!(offers.pop().map(terms), Some(expected));
        }
        assert!(offers.is_empty());
    }
}
