//! A body in small pieces, which a set of balls has to hold: the surface cut into triangles, and points of a grid
//! inside.

use super::proof::{Ball, halves, longest_squared};
use super::solid::{Solid, greater};
use glam::DVec3;
use std::collections::HashMap;

/// Pieces in one block.
const BLOCK: usize = 16;

/// Pieces over shared points. A point inside is a piece whose three corners are one.
pub(crate) struct Pieces {
    pub(crate) points: Vec<DVec3>,
    pub(crate) corners: Vec<[u32; 3]>,
    /// The corners themselves: what balls are held to, thousands of times.
    shapes: Vec<[DVec3; 3]>,
    /// Of each piece: its middle, and its normal times its area.
    pub(crate) middles: Vec<DVec3>,
    pub(crate) normals: Vec<DVec3>,
    /// Balls around each [`BLOCK`] pieces in a row, so that not all need be asked, and those pieces.
    blocks: Vec<Ball>,
    lanes: Vec<Lanes>,
    /// How far the points inside are apart.
    pub(super) spacing: f64,
}

/// Pieces of a block side by side: x, y and z of each one's middle and of its three corners.
struct Lanes([[f64; BLOCK]; 12]);

impl Lanes {
    /// At most [`BLOCK`] pieces; what is left of the lanes is nowhere.
    fn new(middles: &[DVec3], shapes: &[[DVec3; 3]]) -> Self {
        let mut lanes = [[f64::INFINITY; BLOCK]; 12];
        for (k, (middle, [a, b, c])) in middles.iter().zip(shapes).enumerate() {
            for (point, at) in [middle, a, b, c].into_iter().zip((0..12).step_by(3)) {
                for axis in 0..3 {
                    lanes[at + axis][k] = point[axis];
                }
            }
        }
        Self(lanes)
    }

    /// Of each piece the squared distance from a point to its middle, and to its farthest corner.
    fn distances(&self, from: DVec3) -> [[f64; BLOCK]; 2] {
        let [mx, my, mz, ax, ay, az, bx, by, bz, cx, cy, cz] = &self.0;
        let [x, y, z] = from.to_array();
        let squared = |px: f64, py: f64, pz: f64| {
            let (px, py, pz) = (px - x, py - y, pz - z);
            px * px + py * py + pz * pz
        };
        let mut all = [[0.0; BLOCK]; 2];
        let [middles, corners] = &mut all;
        for k in 0..BLOCK {
            middles[k] = squared(mx[k], my[k], mz[k]);
            let a = squared(ax[k], ay[k], az[k]);
            let b = squared(bx[k], by[k], bz[k]);
            let c = squared(cx[k], cy[k], cz[k]);
            corners[k] = greater(greater(a, b), c);
        }
        all
    }
}

/// The greatest square whose root, as it is rounded, is not above a radius.
fn greatest_square(radius: f64) -> f64 {
    // A few steps below to a few above.
    let mut square = radius * radius * (1.0 - 2.0 * f64::EPSILON);
    while square.is_finite() && square.next_up().sqrt() <= radius {
        square = square.next_up();
    }
    square
}

impl Pieces {
    /// Cuts the triangles into about `target` pieces, and into some ten times as many where they are needles. Of
    /// a mesh that has far more triangles than `target`, every n-th is taken. Points of a grid inside are added,
    /// about a quarter as many.
    pub(crate) fn new(
        points: &[DVec3],
        triangles: &[[u32; 3]],
        solid: &Solid,
        target: usize,
    ) -> Self {
        let mut cut = cut(points, triangles, target);
        let (spacing, inside) = solid.grid(target / 4);
        cut.extend(inside.into_iter().map(|p| [p; 3]));
        Self::of(cut, spacing)
    }

    /// The same body, cut finer where that lets balls shrink: where one ball alone holds a piece, and only just,
    /// and another reaches into it.
    pub(crate) fn refined(&self, balls: &[Ball]) -> Self {
        let mut holders = vec![0_u32; self.len()];
        let mut reached = vec![false; self.len()];
        let mut tight = vec![false; self.len()];
        for ball in balls {
            for piece in self.near(ball) {
                let corners = self.corners(piece);
                let piece = piece as usize;
                let needs = ball.needs(&corners);
                if needs <= ball.radius {
                    holders[piece] += 1;
                    tight[piece] |= needs + longest_squared(&corners).sqrt() > ball.radius;
                } else {
                    reached[piece] |= corners
                        .iter()
                        .any(|p| p.distance(ball.center) < ball.radius);
                }
            }
        }
        let mut cut = Vec::with_capacity(2 * self.len());
        for piece in 0..self.len() {
            let corners = self.corners(piece as u32);
            if holders[piece] == 1 && tight[piece] && reached[piece] {
                cut.extend(halves(corners).into_iter().flat_map(halves));
            } else {
                cut.push(corners);
            }
        }
        Self::of(cut, self.spacing)
    }

    /// The pieces of the blocks that a ball reaches into.
    fn near(&self, ball: &Ball) -> impl Iterator<Item = u32> {
        let ball = *ball;
        let blocks = self.blocks.iter().enumerate();
        blocks
            .filter(move |(_, block)| {
                block.center.distance(ball.center) <= ball.radius + block.radius
            })
            .flat_map(|(k, _)| (k * BLOCK) as u32..((k + 1) * BLOCK).min(self.len()) as u32)
    }

    fn of(mut cut: Vec<[DVec3; 3]>, spacing: f64) -> Self {
        sort_by_place(&mut cut);
        let mut pieces = Self {
            points: Vec::new(),
            corners: Vec::new(),
            shapes: Vec::new(),
            middles: cut.iter().map(|[a, b, c]| (a + b + c) / 3.0).collect(),
            normals: cut
                .iter()
                .map(|[a, b, c]| (b - a).cross(c - a) * 0.5)
                .collect(),
            blocks: Vec::new(),
            lanes: Vec::new(),
            spacing,
        };
        let mut known = HashMap::new();
        for corners in &cut {
            pieces.corners.push(corners.map(|p| {
                *known
                    .entry(p.to_array().map(f64::to_bits))
                    .or_insert_with(|| {
                        pieces.points.push(p);
                        pieces.points.len() as u32 - 1
                    })
            }));
        }
        pieces.blocks = cut.chunks(BLOCK).map(around).collect();
        let blocks = pieces.middles.chunks(BLOCK).zip(cut.chunks(BLOCK));
        pieces.lanes = blocks.map(|(m, shapes)| Lanes::new(m, shapes)).collect();
        pieces.shapes = cut;
        pieces
    }

    /// How many there are.
    pub(crate) fn len(&self) -> usize {
        self.corners.len()
    }

    /// Whether a piece is a point inside, and not one of the surface.
    pub(crate) fn is_inside(&self, piece: u32) -> bool {
        let [a, b, c] = self.corners[piece as usize];
        a == b && b == c
    }

    /// The corners of a piece.
    pub(crate) fn corners(&self, piece: u32) -> [DVec3; 3] {
        self.shapes[piece as usize]
    }

    /// The corners of several pieces, each point once.
    pub(crate) fn points_of(&self, pieces: &[u32]) -> Vec<DVec3> {
        let mut seen = vec![false; self.points.len()];
        // Whether a point is new is as good as chance: each is written, and the next one over it if it was not.
        let mut points = vec![DVec3::ZERO; 3 * pieces.len()];
        let mut count = 0;
        for &piece in pieces {
            for i in self.corners[piece as usize] {
                let seen = &mut seen[i as usize];
                points[count] = self.points[i as usize];
                count += usize::from(!std::mem::replace(seen, true));
            }
        }
        points.truncate(count);
        points
    }

    /// The pieces that a ball holds.
    pub(crate) fn held(&self, ball: &Ball) -> Vec<u32> {
        let mut held = Vec::new();
        let squared = ball.radius * ball.radius;
        let greatest = greatest_square(ball.radius);
        for (k, (block, lanes)) in self.blocks.iter().zip(&self.lanes).enumerate() {
            let distance = block.center.distance_squared(ball.center);
            let reach = ball.radius + block.radius;
            if distance > reach * reach * (1.0 + 1e-12) {
                continue;
            }
            let pieces = (k * BLOCK) as u32..((k + 1) * BLOCK).min(self.len()) as u32;
            if distance.sqrt() + block.radius < ball.radius {
                held.extend(pieces);
            } else {
                // Which piece is held is as good as chance: each is written, and the next one over it if it was not.
                let [middles, corners] = lanes.distances(ball.center);
                let mut count = held.len();
                held.resize(count + BLOCK, 0);
                for (lane, piece) in (k * BLOCK..).take(BLOCK).enumerate() {
                    held[count] = piece as u32;
                    let holds = (middles[lane] <= squared) & (corners[lane] <= greatest);
                    count += usize::from(holds);
                }
                held.truncate(count);
            }
        }
        held
    }
}

/// The triangles cut until no edge is longer than `target` pieces call for.
fn cut(points: &[DVec3], triangles: &[[u32; 3]], target: usize) -> Vec<[DVec3; 3]> {
    let area = |t: &[DVec3; 3]| 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).length();
    // A triangle without area is an edge of another one, or else of no account to the search.
    let at = |t: &[u32; 3]| t.map(|i| points[i as usize]);
    let flat = |t: &[DVec3; 3]| area(t) <= 1e-7 * longest_squared(t);
    let all_flat = triangles.iter().all(|t| flat(&at(t)));
    let stride = triangles.len().div_ceil(4 * target).max(1);
    let chosen = || {
        triangles
            .iter()
            .step_by(stride)
            .map(at)
            .filter(|t| all_flat || !flat(t))
    };
    let whole: f64 = chosen().map(|t| area(&t)).sum();
    // A right triangle with two equal sides and longest edge e has area e² / 4.
    // A needle has no area to limit its pieces: each halving of the edge makes three of one. So lengths set
    // an edge as well, which lies below the other for triangles of a common shape.
    let power = 3.0_f64.log2();
    let needles: f64 = chosen()
        .map(|t| longest_squared(&t).powf(0.5 * power))
        .sum();
    let edge_squared = (4.0 * whole / target as f64)
        .max((needles / (4 * target) as f64).powf(2.0 / power))
        .max(f64::MIN_POSITIVE);
    let mut pieces = Vec::new();
    let mut open = Vec::new();
    for t in chosen() {
        open.push((t, 0));
        while let Some((t, depth)) = open.pop() {
            if longest_squared(&t) > edge_squared && depth < 14 {
                open.extend(halves(t).map(|half| (half, depth + 1)));
            } else {
                pieces.push(t);
            }
        }
    }
    pieces
}

/// Puts pieces that are near each other near in the list: along a Z-order curve (Morton 1966) of 1,024 steps a side.
fn sort_by_place(pieces: &mut [[DVec3; 3]]) {
    let low = pieces
        .iter()
        .flatten()
        .copied()
        .fold(DVec3::INFINITY, DVec3::min);
    let high = pieces
        .iter()
        .flatten()
        .copied()
        .fold(DVec3::NEG_INFINITY, DVec3::max);
    let scale = 1023.0 / (high - low).max_element().max(f64::MIN_POSITIVE);
    let spread = |x: f64| {
        (0..10)
            .map(|bit| u64::from(x as u32 >> bit & 1) << (3 * bit))
            .sum::<u64>()
    };
    pieces.sort_by_cached_key(|[a, b, c]| {
        let [x, y, z] = (((a + b + c) / 3.0 - low) * scale).to_array().map(spread);
        x | y << 1 | z << 2
    });
}

/// A ball around pieces, a little larger than need be.
fn around(pieces: &[[DVec3; 3]]) -> Ball {
    let center = pieces.iter().flatten().sum::<DVec3>() / (3 * pieces.len()) as f64;
    let needs = |corners: &[DVec3; 3]| {
        Ball {
            center,
            radius: 0.0,
        }
        .needs(corners)
    };
    let radius = pieces.iter().map(needs).fold(0.0, f64::max) * (1.0 + 1e-9);
    Ball { center, radius }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRIANGLE: [DVec3; 3] = [DVec3::ZERO, DVec3::X, DVec3::Y];

    #[test]
    fn pieces_tile_the_triangle() {
        let solid = Solid::new(&TRIANGLE, &[[0, 1, 2]]);
        let pieces = Pieces::new(&TRIANGLE, &[[0, 1, 2]], &solid, 1000);
        assert!(
            pieces.len() > 900 && pieces.len() < 4000,
            "{}",
            pieces.len()
        );
        assert!(pieces.points.len() < pieces.len());
        let area: f64 = pieces.normals.iter().map(|n| n.length()).sum();
        assert!((area - 0.5).abs() < 1e-12, "{area}");
    }

    #[test]
    fn needles_do_not_become_a_multitude() {
        let needle = |k: u32| {
            let x = f64::from(k);
            [
                DVec3::new(x, 0.0, 0.0),
                DVec3::new(x, 1e3, 0.0),
                DVec3::new(x, 5e2, 1e-4),
            ]
        };
        let points: Vec<DVec3> = (0..200).flat_map(needle).collect();
        let triangles: Vec<[u32; 3]> = (0..200).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
        let pieces = cut(&points, &triangles, 1000).len();
        assert!(pieces > 1000 && pieces < 16_000, "{pieces}");
    }

    #[test]
    fn squares_are_told_apart_as_their_roots_are() {
        for k in 1..2000 {
            let radius = (f64::from(k) * 0.618_034).fract() * 10.0_f64.powi(k % 60 - 30);
            let greatest = greatest_square(radius);
            assert!(greatest.sqrt() <= radius && greatest.next_up().sqrt() > radius);
        }
        assert_eq!(greatest_square(0.0), 0.0);
    }

    #[test]
    fn blocks_hide_no_piece_from_a_ball() {
        let solid = Solid::new(&TRIANGLE, &[[0, 1, 2]]);
        let pieces = Pieces::new(&TRIANGLE, &[[0, 1, 2]], &solid, 2000);
        for (x, y, radius) in [
            (0.3, 0.3, 0.1),
            (0.0, 0.9, 0.4),
            (0.5, 0.5, 2.0),
            (3.0, 0.0, 1.0),
        ] {
            let ball = Ball {
                center: DVec3::new(x, y, 0.1),
                radius,
            };
            let all = 0..pieces.len() as u32;
            let expected: Vec<u32> = all.filter(|&i| ball.holds(&pieces.corners(i))).collect();
            assert_eq!(pieces.held(&ball), expected);
        }
    }
}
