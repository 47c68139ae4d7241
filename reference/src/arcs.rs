//! The visibility past circular caps, exact to rounding, by integrals along the border of their union.
//!
//! On the unit sphere a basis function of band l has the Laplacian Δy = −l(l+1) y, so that by Gauss's theorem its
//! integral over the union C of the caps is, for l ≥ 1, one along the border,
//!
//! ```text
//! ∫_C y dω = −1/(l(l+1)) ∮ ∇y·ν ds        ν out of C, at right angles to its border
//! ```
//!
//! of which the visibility, 1 outside C, has the opposite. The border is made of arcs of circles (module `edges`).
//! On a circle ∇y·ν is a trigonometric polynomial in azimuth of degree ≤ l. It is given by its values at 2n−1
//! equidistant azimuths φ_k, and its integral over arcs is theirs weighted by that of the Dirichlet kernel,
//!
//! ```text
//! w_k = 1/(2n−1) Σ_j c_j ∫_arcs cos j(φ − φ_k) dφ        c_0 = 1, c_j = 2 for 1 ≤ j ≤ n−1.
//! ```
//!
//! Edges that nearly touch or nearly coincide cost no accuracy, as they do where cells or latitudes are cut at
//! them. Band 0 is the area of the union, a sum over arcs of the area between each and a point p: a triangle
//! (van Oosterom & Strackee, "The Solid Angle of a Plane Triangle", 1983, eq. 8), and the piece between its side
//! and the arc. The sum is known up to multiples of 4π, which the areas of the caps decide.

use crate::basis::{band, derivative};
use crate::edges::{Border, Edge, border};
use crate::quadrature::{Estimate, accumulate};
use crate::sampled::directions;
use crate::vec3::{Vec3, add, cross, dot, length, sub};
use crate::visibility::Cap;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A cap that reaches out of another by less lies in it, in radians. Well above rounding.
const SLACK: f64 = 1e-13;

/// SH vector of the visibility past `caps`. A cap of angle 0 or less covers nothing, one of π or more everything;
/// an axis need not be of length 1. Order 6 takes about 0.1 ms for twelve caps, and the time grows as the square
/// of the number of caps that lie in no other.
///
/// `error` is an estimate of the L2 norm of the error, rarely above 1e-11 and as a rule a hundred times the
/// truth: what all caps add if they stick out of others by 1e-13 radians, which is not looked at more closely;
/// rounding; and four times the gap by which the arcs fail to join, should rounding ever tear the border.
///
/// ```
/// use sh_reference::{arcs, cap, visibility::Cap};
/// let found = arcs::project(3, &[Cap { axis: [0.0, 0.0, 1.0], angle: 0.5 }; 100]);
/// assert!(found.error < 1e-11);
/// assert!((found.coefficients[6] - cap::visibility(3, 0.5)[2]).abs() < 1e-14);
/// ```
///
/// # Panics
/// If an axis is 0, or any number not finite.
pub fn project(order: usize, caps: &[Cap]) -> Estimate {
    assert!(order > 0, "an SH vector has order 1 or more");
    for (i, cap) in caps.iter().enumerate() {
        assert!(
            cap.angle.is_finite() && cap.axis.iter().all(|c| c.is_finite()),
            "cap {i} is not finite: {cap:?}"
        );
        assert!(cap.axis != [0.0; 3], "cap {i} has no direction: {cap:?}");
    }
    let mut coefficients = vec![0.0; order * order];
    let full = (4.0 * PI).sqrt();
    // What one steradian is in norm, and one radian of slack along an edge.
    let share = order as f64 / full;
    let edges = match border(caps, SLACK) {
        Border::All => {
            return Estimate {
                coefficients,
                error: share * TAU * SLACK,
            };
        }
        Border::Edges(edges) => edges,
    };
    let (mut perimeter, mut gap, mut arcs) = (0.0, [0.0; 3], 0);
    let mut pieces = Vec::new();
    for edge in &edges {
        let bare = edge.bare();
        perimeter += TAU * edge.angle.sin();
        arcs += bare.len();
        for &(from, to) in &bare {
            gap = add(gap, sub(edge.point(to), edge.point(from)));
            cut(edge, from, to, &mut pieces);
        }
        flux(order, edge, &bare, &mut coefficients);
    }
    for (i, c) in coefficients.iter_mut().enumerate().skip(1) {
        *c /= (band(i) * (band(i) + 1)) as f64;
    }
    let (area, outside) = area(&edges, &pieces);
    coefficients[0] = (4.0 * PI - area) / full;
    let rounding = 4e-15 * share * (1 + arcs) as f64;
    Estimate {
        coefficients,
        error: share * (SLACK * perimeter + outside) + 4.0 * length(gap) + rounding,
    }
}

/// Adds ∫ ∇y·ν ds over the arcs `bare` of an edge to `sum`.
fn flux(order: usize, edge: &Edge, bare: &[(f64, f64)], sum: &mut [f64]) {
    if bare.is_empty() {
        return;
    }
    // c_j ∫ cos jφ dφ and c_j ∫ sin jφ dφ.
    let moments: Vec<(f64, f64)> = (0..order)
        .map(|j| {
            let mut moment = (0.0, 0.0);
            for &(from, to) in bare {
                // About the middle of the arc, so that a short one is integrated to its own precision.
                let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
                let j = j as f64;
                let width = if j == 0.0 {
                    2.0 * half
                } else {
                    4.0 * (j * half).sin() / j
                };
                moment.0 += width * (j * middle).cos();
                moment.1 += width * (j * middle).sin();
            }
            moment
        })
        .collect();
    let count = 2 * order - 1;
    for k in 0..count {
        let azimuth = TAU * k as f64 / count as f64;
        let weight: f64 = moments
            .iter()
            .enumerate()
            .map(|(j, (cos, sin))| {
                let (s, c) = (j as f64 * azimuth).sin_cos();
                cos * c + sin * s
            })
            .sum();
        let slopes = derivative(order, edge.point(azimuth), edge.outwards(azimuth));
        accumulate(sum, weight / count as f64 * edge.angle.sin(), &slopes);
    }
}

/// A piece of an arc, short enough that its ends are far from opposite.
struct Piece {
    from: Vec3,
    to: Vec3,
    /// Between the arc and the great circle through both ends, in steradians, positive if the arc bulges outwards.
    bulge: f64,
}

fn cut(edge: &Edge, from: f64, to: f64, pieces: &mut Vec<Piece>) {
    let count = ((to - from) / FRAC_PI_2).ceil().max(1.0);
    let width = (to - from) / count;
    // The sector of the cap less the triangle of two sides θ with `width` between them.
    let (sin, cos) = (0.5 * edge.angle).sin_cos();
    let (s, c) = (sin * sin, cos * cos);
    let triangle = 2.0 * (s * width.sin()).atan2(c + s * width.cos());
    let bulge = 2.0 * s * width - triangle;
    let mut last = edge.point(from);
    for k in 1..=count as usize {
        let next = edge.point(from + width * k as f64);
        pieces.push(Piece {
            from: last,
            to: next,
            bulge,
        });
        last = next;
    }
}

/// Area of the union in steradians, and by how much the sum had left the range that the caps' areas allow.
fn area(edges: &[Edge], pieces: &[Piece]) -> (f64, f64) {
    let caps = edges
        .iter()
        .map(|edge| 4.0 * PI * (0.5 * edge.angle).sin().powi(2));
    let lowest = caps.clone().fold(0.0, f64::max);
    let highest = caps.sum::<f64>().min(4.0 * PI);
    if pieces.is_empty() {
        // No border: nothing or everything.
        return (if edges.is_empty() { 0.0 } else { 4.0 * PI }, 0.0);
    }
    // Opposite p the side of a triangle may leave in any direction, so that no piece should end there.
    let clearance = |p: &Vec3| {
        pieces
            .iter()
            .map(|piece| 1.0 + dot(*p, piece.from))
            .fold(2.0, f64::min)
    };
    let p = directions(13)
        .max_by(|a, b| clearance(a).total_cmp(&clearance(b)))
        .unwrap_or([0.0, 0.0, 1.0]);
    let sum: f64 = pieces
        .iter()
        .map(|piece| {
            let (a, b) = (piece.from, piece.to);
            let solid = dot(p, cross(a, sub(b, a)));
            2.0 * solid.atan2(1.0 + dot(p, a) + dot(a, b) + dot(b, p)) + piece.bulge
        })
        .sum();
    let turns = ((0.5 * (lowest + highest) - sum) / (4.0 * PI)).round();
    let area = sum + 4.0 * PI * turns;
    let within = area.clamp(lowest, highest);
    (within, (area - within).abs())
}

#[cfg(test)]
mod tests;
