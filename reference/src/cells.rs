//! Cells of a cube map: pieces of the sphere of directions that split into four, without poles.

use crate::quadrature::gauss_legendre;
use crate::vec3::{Vec3, angle, normalize};

/// Directions (1, a, b)/√(1+a²+b²), their coordinates permuted and signed by the face, for a and b within
/// `half` of the cell's own.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cell {
    face: usize,
    a: f64,
    b: f64,
    half: f64,
}

/// The four corners of a square, from its middle.
const CORNERS: [(f64, f64); 4] = [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)];

impl Cell {
    /// The six faces cut into `count²` cells each: together the sphere.
    pub(crate) fn grid(count: usize) -> impl Iterator<Item = Cell> {
        let half = 1.0 / count as f64;
        let middle = move |i: usize| (2 * i + 1) as f64 * half - 1.0;
        (0..6 * count * count).map(move |i| {
            let (face, within) = (i / (count * count), i % (count * count));
            let (a, b) = (middle(within % count), middle(within / count));
            Cell { face, a, b, half }
        })
    }

    fn direction(&self, a: f64, b: f64) -> Vec3 {
        let forward = if self.face < 3 { 1.0 } else { -1.0 };
        let mut s = [forward, a, b];
        s.rotate_right(self.face % 3);
        normalize(s)
    }

    pub(crate) fn center(&self) -> Vec3 {
        self.direction(self.a, self.b)
    }

    /// The largest angle between the centre and any point of the cell: that to a corner, because the
    /// edges are great circles.
    pub(crate) fn reach(&self) -> f64 {
        let Cell { a, b, half, .. } = *self;
        let away = |(i, j)| angle(self.center(), self.direction(a + i * half, b + j * half));
        CORNERS.map(away).into_iter().fold(0.0, f64::max)
    }

    /// In steradians: the solid angle of 0..a, 0..b is atan(ab/√(1+a²+b²)).
    pub(crate) fn solid_angle(&self) -> f64 {
        let quadrant = |a: f64, b: f64| (a * b).atan2((1.0 + a * a + b * b).sqrt());
        let Cell { a, b, half, .. } = *self;
        quadrant(a + half, b + half) - quadrant(a - half, b + half) - quadrant(a + half, b - half)
            + quadrant(a - half, b - half)
    }

    pub(crate) fn split(&self) -> [Cell; 4] {
        let half = 0.5 * self.half;
        CORNERS.map(|(i, j)| {
            let (a, b) = (self.a + i * half, self.b + j * half);
            Cell {
                a,
                b,
                half,
                ..*self
            }
        })
    }

    /// Hands nodes and weights of the product of two Gauss–Legendre rules, given on −1..1, to `add`; the
    /// density of solid angle is (1+a²+b²)^(−3/2). On a cell of half width h the error falls about as
    /// (h/2)^(2·nodes).
    pub(crate) fn each_node(&self, rule: &[(f64, f64)], mut add: impl FnMut(Vec3, f64)) {
        let half = self.half;
        for (i, di) in rule {
            for (j, dj) in rule {
                let (a, b) = (self.a + half * i, self.b + half * j);
                let density = (1.0 + a * a + b * b).powf(-1.5);
                add(self.direction(a, b), half * di * half * dj * density);
            }
        }
    }
}

/// The rule [`Cell::each_node`] wants, so fine that SH vectors of order 12 are integrated to 1e-12 on cells
/// of half width 2^−(level+2).
pub(crate) fn rule_at(level: usize) -> Vec<(f64, f64)> {
    gauss_legendre(12usize.saturating_sub(2 * level).max(3), -1.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::basis::basis;
    use crate::quadrature::accumulate;
    use crate::testing::{assert_close, directions};
    use std::f64::consts::PI;

    #[test]
    fn grids_make_up_the_sphere() {
        for count in [1, 2, 5] {
            let sum: f64 = Cell::grid(count).map(|cell| cell.solid_angle()).sum();
            assert!((sum - 4.0 * PI).abs() < 1e-12);
        }
    }

    #[test]
    fn each_direction_is_near_one_center() {
        let cells: Vec<Cell> = Cell::grid(4).collect();
        for s in directions(300) {
            assert!(
                cells
                    .iter()
                    .any(|cell| angle(s, cell.center()) <= cell.reach())
            );
        }
    }

    #[test]
    fn parts_and_nodes_make_up_the_cell() {
        for cell in Cell::grid(4) {
            let mut by_nodes = 0.0;
            cell.each_node(&rule_at(0), |s, k| {
                by_nodes += k;
                assert!(angle(s, cell.center()) <= cell.reach());
            });
            assert!((by_nodes - cell.solid_angle()).abs() < 1e-14);
            let of_parts: f64 = cell.split().iter().map(Cell::solid_angle).sum();
            assert!((of_parts - cell.solid_angle()).abs() < 1e-14);
        }
    }

    #[test]
    fn rules_are_fine_enough_at_every_level() {
        let mut cell = Cell::grid(4).nth(21).unwrap();
        let fine = gauss_legendre(16, -1.0, 1.0);
        for level in 0..10 {
            let [found, truth] = [&rule_at(level), &fine].map(|rule| {
                let mut sum = vec![0.0; 144];
                cell.each_node(rule, |s, k| accumulate(&mut sum, k, &basis(12, s)));
                sum
            });
            assert_close(&found, &truth, 1e-11 * cell.solid_angle());
            cell = cell.split()[level % 4];
        }
    }
}
