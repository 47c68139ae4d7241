//! Quadrature rules with the symmetry of the octahedron, solved from what they have to integrate.
//!
//! A rule of Lebedev (1976) is a set of orbits under sign flips and permutations of the axes, of one weight each. By that
//! symmetry it integrates every monomial with an odd power to 0, and since x² + y² + z² = 1 all even ones up to degree D
//! follow from those of degree D alone. What is left is one equation for each way to part D/2 among three axes, and as many
//! unknowns: the orbits' weights, and where the orbits lie that are free to move. Newton's method solves them from a guess
//! of one digit, so that no digit of a rule is typed here.

use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;

/// A kind of orbit, by one of its points.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Orbit {
    /// (1, 0, 0): 6 points.
    Vertices,
    /// (0, 1, 1)/√2: 12 points.
    Edges,
    /// (1, 1, 1)/√3: 8 points.
    Faces,
    /// (a, a, √(1 − 2a²)) from about this a: 24 points.
    Diagonal(f64),
    /// (a, √(1 − a²), 0) from about this a: 24 points.
    Plane(f64),
}

use Orbit::{Diagonal, Edges, Faces, Plane, Vertices};

/// Points, the degree up to which they are exact, orbits with guesses.
const RULES: [(usize, u32, &[Orbit]); 7] = [
    (6, 3, &[Vertices]),
    (14, 5, &[Vertices, Faces]),
    (26, 7, &[Vertices, Edges, Faces]),
    (38, 9, &[Vertices, Faces, Plane(0.5)]),
    (50, 11, &[Vertices, Edges, Faces, Diagonal(0.3)]),
    (
        86,
        15,
        &[Vertices, Faces, Diagonal(0.4), Diagonal(0.7), Plane(0.4)],
    ),
    (
        110,
        17,
        &[
            Vertices,
            Faces,
            Diagonal(0.2),
            Diagonal(0.69),
            Diagonal(0.4),
            Plane(0.5),
        ],
    ),
];

impl Orbit {
    /// Where it lies, if it is free to.
    fn guess(self) -> Option<f64> {
        match self {
            Diagonal(a) | Plane(a) => Some(a),
            Vertices | Edges | Faces => None,
        }
    }

    /// The point that stands for it; `a` is where it lies.
    fn point(self, a: f64) -> [f64; 3] {
        match self {
            Vertices => [1.0, 0.0, 0.0],
            Edges => [0.0, 0.5_f64.sqrt(), 0.5_f64.sqrt()],
            Faces => [(1.0_f64 / 3.0).sqrt(); 3],
            Diagonal(_) => [a, a, (1.0 - 2.0 * a * a).sqrt()],
            Plane(_) => [a, (1.0 - a * a).sqrt(), 0.0],
        }
    }

    /// All of its points.
    fn points(self, a: f64) -> Vec<[f64; 3]> {
        let [x, y, z] = self.point(a);
        let turned = [
            [x, y, z],
            [x, z, y],
            [y, x, z],
            [y, z, x],
            [z, x, y],
            [z, y, x],
        ];
        let mut all: Vec<[f64; 3]> = Vec::new();
        for point in turned {
            for signs in 0..8_u32 {
                let flipped = |k: usize| match (signs >> k) & 1 {
                    0 => point[k],
                    _ => 0.0 - point[k],
                };
                let point = [0, 1, 2].map(flipped);
                if !all.contains(&point) {
                    all.push(point);
                }
            }
        }
        all
    }
}

/// A number as the sum of two, twice as many digits (Dekker 1971): with the rounding of single ones, weights would be off in
/// their last digit or two.
#[derive(Clone, Copy)]
struct Double(f64, f64);

impl Double {
    fn plus(self, other: Self) -> Self {
        let sum = self.0 + other.0;
        let part = sum - self.0;
        let off = (self.0 - (sum - part)) + (other.0 - part);
        Self::joined(sum, off + self.1 + other.1)
    }

    fn times(self, other: Self) -> Self {
        let product = self.0 * other.0;
        let off = self.0.mul_add(other.0, -product);
        Self::joined(product, off + self.0 * other.1 + self.1 * other.0)
    }

    fn joined(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self(sum, low - (sum - high))
    }

    fn power(self, exponent: u32) -> Self {
        (0..exponent).fold(Self(1.0, 0.0), |power, _| power.times(self))
    }
}

impl Orbit {
    /// Squares of the point that stands for it, and how many points there are.
    fn squares(self, a: f64) -> ([Double; 3], f64) {
        let [zero, one] = [0.0, 1.0].map(|x| Double(x, 0.0));
        let square = Double(a, 0.0).times(Double(a, 0.0));
        let less = |count: f64| one.plus(square.times(Double(-count, 0.0)));
        let third = 1.0 / 3.0;
        let third = Double(third, 3.0_f64.mul_add(-third, 1.0) / 3.0);
        match self {
            Vertices => ([one, zero, zero], 6.0),
            Edges => ([zero, Double(0.5, 0.0), Double(0.5, 0.0)], 12.0),
            Faces => ([third; 3], 8.0),
            Diagonal(_) => ([square, square, less(2.0)], 24.0),
            Plane(_) => ([square, less(1.0), zero], 24.0),
        }
    }
}

/// Numerator and denominator of the mean of x^a y^b z^c over the sphere, for even powers: (a−1)!!(b−1)!!(c−1)!!/(a+b+c+1)!!.
fn moment(powers: [u32; 3]) -> [f64; 2] {
    let double = |n: u32| -> f64 { (1..=n).rev().step_by(2).map(f64::from).product() };
    let top = powers.map(|p| double(p.saturating_sub(1))).iter().product();
    [top, double(powers.iter().sum::<u32>() + 1)]
}

/// All ways to part an even degree among three axes, in even powers, the largest first.
fn monomials(degree: u32) -> Vec<[u32; 3]> {
    let mut all = Vec::new();
    for a in (0..=degree).step_by(2) {
        for b in (0..=degree - a).step_by(2) {
            let powers = [a, b, degree - a - b];
            if a >= b && b >= powers[2] {
                all.push(powers);
            }
        }
    }
    all
}

/// By how much of itself each moment of the rule with these unknowns, weights first, is off.
fn residuals(orbits: &[Orbit], monomials: &[[u32; 3]], unknowns: &DVector<f64>) -> DVector<f64> {
    let axes = [
        [0, 1, 2],
        [0, 2, 1],
        [1, 0, 2],
        [1, 2, 0],
        [2, 0, 1],
        [2, 1, 0],
    ];
    let residual = |powers: &[u32; 3]| {
        let [top, bottom] = moment(*powers);
        let mut sum = Double(-6.0 * top, 0.0);
        for ((orbit, a), weight) in placed(orbits, unknowns).zip(unknowns.iter()) {
            let (squares, count) = orbit.squares(a);
            let share = Double(*weight, 0.0).times(Double(count * bottom, 0.0));
            for axes in axes {
                let power = |k: usize| squares[axes[k]].power(powers[k] / 2);
                sum = sum.plus(share.times(power(0)).times(power(1)).times(power(2)));
            }
        }
        sum.0 / (6.0 * top)
    };
    DVector::from_iterator(monomials.len(), monomials.iter().map(residual))
}

/// Orbits with where they lie.
fn placed<'a>(
    orbits: &'a [Orbit],
    unknowns: &'a DVector<f64>,
) -> impl Iterator<Item = (Orbit, f64)> + 'a {
    let mut places = unknowns.iter().skip(orbits.len());
    orbits.iter().map(move |orbit| {
        let place = orbit.guess().and_then(|_| places.next());
        (*orbit, place.copied().unwrap_or(0.0))
    })
}

/// The points of the rule of `count`, with weights that sum to 4π.
///
/// ```
/// let rule = sh_reference::octahedral::points(50);
/// let square: f64 = rule.iter().map(|(p, w)| w * p[2] * p[2]).sum();
/// assert!((square - 4.0 * std::f64::consts::PI / 3.0).abs() < 1e-13);
/// ```
///
/// # Panics
/// If there is no rule of that many points: 6, 14, 26, 38, 50, 86 and 110 exist.
pub fn points(count: usize) -> Vec<([f64; 3], f64)> {
    let (_, degree, orbits) = *RULES
        .iter()
        .find(|rule| rule.0 == count)
        .unwrap_or_else(|| panic!("no octahedral rule of {count} points"));
    let unknowns = solved(count, degree, orbits);
    let mut all = Vec::new();
    for ((orbit, a), weight) in placed(orbits, &unknowns).zip(unknowns.iter()) {
        let weight = 4.0 * PI * weight;
        all.extend(orbit.points(a).into_iter().map(|point| (point, weight)));
    }
    all
}

/// Weights and places that integrate all of a degree.
fn solved(count: usize, degree: u32, orbits: &[Orbit]) -> DVector<f64> {
    let monomials = monomials(degree - 1);
    let guesses = orbits.iter().filter_map(|orbit| orbit.guess());
    let even = std::iter::repeat_n(1.0 / count as f64, orbits.len());
    let mut unknowns = DVector::from_iterator(monomials.len(), even.chain(guesses));
    let size = unknowns.len();
    for _ in 0..60 {
        let off = residuals(orbits, &monomials, &unknowns);
        let mut slopes = DMatrix::zeros(size, size);
        for k in 0..size {
            let step = 1e-6;
            let moved = |by: f64| {
                let mut unknowns = unknowns.clone();
                unknowns[k] += by;
                residuals(orbits, &monomials, &unknowns)
            };
            slopes.set_column(k, &((moved(step) - moved(-step)) / (2.0 * step)));
        }
        let step = slopes.lu().solve(&off).expect("the moments tell all apart");
        unknowns -= &step;
        if step.amax() < 1e-18 {
            break;
        }
    }
    unknowns
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::basis::basis;

    #[test]
    fn rules_have_their_points_inside_the_octant_and_positive_weights() {
        for (count, _, _) in RULES {
            let rule = points(count);
            assert_eq!(rule.len(), count);
            for (point, weight) in rule {
                let length: f64 = point.iter().map(|x| x * x).sum();
                assert!((length - 1.0).abs() < 1e-14, "{count}: {point:?}");
                assert!(weight > 0.0, "{count}: {weight}");
            }
        }
    }

    /// By the basis, which nothing above knows of: orthonormal where the product of two has a degree that the rule takes.
    #[test]
    fn rules_integrate_to_their_degree_and_no_further() {
        for (count, degree, _) in RULES {
            let rule = points(count);
            let bands = degree as usize + 2;
            let mut sums = vec![0.0; bands * bands];
            for (point, weight) in &rule {
                for (sum, y) in sums.iter_mut().zip(basis(bands, *point)) {
                    *sum += weight * y;
                }
            }
            sums[0] -= (4.0 * PI).sqrt();
            let (within, beyond) = sums.split_at((bands - 1) * (bands - 1));
            let most = |sums: &[f64]| sums.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            assert!(most(within) < 1e-13, "{count}: {:e}", most(within));
            assert!(most(beyond) > 1e-3, "{count}: {:e}", most(beyond));
        }
    }
}
