//! Functions taken from coefficients to samples and back, by rules with the symmetry of the octahedron.
//!
//! A rule of Lebedev (1976) is a set of orbits: points that sign flips and permutations of (x, y, z) turn into
//! each other, of one weight. Every basis function is even or odd in x, in y and in z, which splits the n²
//! functions into eight classes. The partial sums of the classes at one point (a, b, c) with a, b, c ≥ 0,
//!
//! ```text
//! E_k = Σ_{i in class k} f_i y_i(a, b, c)
//! ```
//!
//! give the function at all eight points (±a, ±b, ±c) by sums and differences alone (a butterfly), and the same
//! backwards. A coordinate that is 0 halves the points and the classes.

use crate::basis::basis;
use crate::exact::band;
use crate::expr::{Graph, Value};

/// An orbit by one of its points.
#[derive(Clone, Copy)]
enum Orbit {
    /// (1, 0, 0): 6 points.
    Vertices(f64),
    /// (0, 1, 1)/√2: 12 points.
    Edges(f64),
    /// (1, 1, 1)/√3: 8 points.
    Faces(f64),
    /// (a, a, √(1−2a²)): 24 points.
    Diagonal(f64, f64),
    /// (a, √(1−a²), 0): 24 points.
    Plane(f64, f64),
}

use Orbit::{Diagonal, Edges, Faces, Plane, Vertices};

/// Orbits with their weights (which sum to 1 over all points), by the number of points.
///
/// Lebedev, "Quadratures on a sphere", 1976; exact for degrees 3, 5, 7, 9, 11, 15 and 17.
const RULES: [(usize, &[Orbit]); 7] = [
    (6, &[Vertices(1.0 / 6.0)]),
    (14, &[Vertices(1.0 / 15.0), Faces(3.0 / 40.0)]),
    (
        26,
        &[Vertices(1.0 / 21.0), Edges(4.0 / 105.0), Faces(9.0 / 280.0)],
    ),
    (
        38,
        &[
            Vertices(1.0 / 105.0),
            Faces(9.0 / 280.0),
            Plane(0.459_700_843_380_983_1, 1.0 / 35.0),
        ],
    ),
    (
        50,
        &[
            Vertices(4.0 / 315.0),
            Edges(64.0 / 2835.0),
            Faces(27.0 / 1280.0),
            Diagonal(0.301_511_344_577_763_6, 14641.0 / 725_760.0),
        ],
    ),
    (
        86,
        &[
            Vertices(0.011_544_011_544_011_54),
            Faces(0.011_943_909_085_856_28),
            Diagonal(0.369_602_846_454_150_2, 0.011_110_555_710_603_40),
            Diagonal(0.694_354_006_602_666_4, 0.011_876_501_294_537_14),
            Plane(0.374_243_039_090_341_2, 0.011_812_303_746_904_48),
        ],
    ),
    (
        110,
        &[
            Vertices(0.003_828_270_494_937_162),
            Faces(0.009_793_737_512_487_512),
            Diagonal(0.185_115_635_344_736_2, 0.008_211_737_283_191_111),
            Diagonal(0.690_421_048_382_292_2, 0.009_942_814_891_178_103),
            Diagonal(0.395_689_473_055_941_9, 0.009_595_471_336_070_963),
            Plane(0.478_369_028_812_150_2, 0.009_694_996_361_663_028),
        ],
    ),
];

/// A point with coordinates ≥ 0 that stands for all its sign flips.
struct Octant {
    point: [f64; 3],
    /// Weight of each point on the unit sphere, 4π over all.
    weight: f64,
}

fn octants(points: usize) -> Vec<Octant> {
    let (_, orbits) = RULES
        .iter()
        .find(|(count, _)| *count == points)
        .unwrap_or_else(|| panic!("no octahedral rule of {points} points"));
    let mut out = Vec::new();
    for orbit in *orbits {
        let (x, y, z, weight) = match *orbit {
            Vertices(w) => (1.0, 0.0, 0.0, w),
            Edges(w) => (0.0, 0.5_f64.sqrt(), 0.5_f64.sqrt(), w),
            Faces(w) => {
                let a = (1.0_f64 / 3.0).sqrt();
                (a, a, a, w)
            }
            Diagonal(a, w) => (a, a, (1.0 - 2.0 * a * a).sqrt(), w),
            Plane(a, w) => (a, (1.0 - a * a).sqrt(), 0.0, w),
        };
        let mut seen: Vec<[f64; 3]> = Vec::new();
        for point in [
            [x, y, z],
            [x, z, y],
            [y, x, z],
            [y, z, x],
            [z, x, y],
            [z, y, x],
        ] {
            if !seen.contains(&point) {
                seen.push(point);
                out.push(Octant {
                    point,
                    weight: weight * 4.0 * std::f64::consts::PI,
                });
            }
        }
    }
    out
}

/// The points of a rule with their weights, which sum to 4π.
///
/// ```
/// let area: f64 = sh_codegen::octahedral::points(50).iter().map(|p| p.1).sum();
/// assert!((area - 4.0 * std::f64::consts::PI).abs() < 1e-12);
/// ```
///
/// # Panics
/// If there is no rule of that many points: 6, 14, 26, 38, 50, 86 and 110 exist.
pub fn points(count: usize) -> Vec<([f64; 3], f64)> {
    let mut out = Vec::new();
    for Octant { point, weight } in octants(count) {
        for signs in 0..8_usize {
            let flip = |axis: usize| (signs >> axis) & 1 == 1;
            if (0..3).any(|axis| flip(axis) && point[axis] == 0.0) {
                continue;
            }
            let signed = std::array::from_fn(|axis| {
                if flip(axis) {
                    -point[axis]
                } else {
                    point[axis]
                }
            });
            out.push((signed, weight));
        }
    }
    out
}

/// In which axes a basis function is odd: bit 0 for x, 1 for y, 2 for z.
fn parity(index: usize) -> usize {
    let (l, m) = band(index);
    let k = m.unsigned_abs() as usize;
    // Re (x + iy)^k is even in y, Im odd; the rest of the k factors are x.
    let y = usize::from(m < 0);
    ((k + y) % 2) | (y << 1) | (((l + k) % 2) << 2)
}

/// The basis functions at a direction that is handed in.
fn at_direction(order: usize) -> Graph {
    let mut g = Graph::default();
    let d = g.inputs(0, 3);
    g.outputs = basis(&mut g, order, &d);
    g
}

/// f ↦ Σ_q w_q h(f(s_q)) y(s_q), band l times `gains[l]`: to the samples of a rule, a function of each, and back.
pub fn pointwise(
    g: &mut Graph,
    order: usize,
    points: usize,
    gains: &[f64],
    f: &[Value],
    mut h: impl FnMut(&mut Graph, Value) -> Value,
) -> Vec<Value> {
    at_samples(g, order, points, gains, f, |g, _, values| {
        for value in values {
            *value = h(g, *value);
        }
    })
}

/// f ↦ Σ_q w_q h(f(s_q), s_q · d) y(s_q): as [`pointwise`], of a sample and of the cosine between its direction and
/// `d`.
pub fn pointwise_towards(
    g: &mut Graph,
    order: usize,
    points: usize,
    f: &[Value],
    d: &[Value],
    mut h: impl FnMut(&mut Graph, Value, Value) -> Value,
) -> Vec<Value> {
    let gains = vec![1.0; order];
    at_samples(g, order, points, &gains, f, |g, point, values| {
        // One coordinate a class: the butterfly gives the cosines at all sign flips.
        let mut cosines = vec![g.constant(0.0); values.len()];
        let axes = (0..3).filter(|axis| point[*axis] != 0.0);
        for (slot, axis) in axes.enumerate() {
            cosines[1 << slot] = g.scale(point[axis], d[axis]);
        }
        butterfly(g, &mut cosines);
        for (value, cosine) in values.iter_mut().zip(cosines) {
            *value = h(g, *value, cosine);
        }
    })
}

/// To the samples of a rule, a function of those of an octant's point and its sign flips, and back.
fn at_samples(
    g: &mut Graph,
    order: usize,
    points: usize,
    gains: &[f64],
    f: &[Value],
    mut h: impl FnMut(&mut Graph, &[f64; 3], &mut [Value]),
) -> Vec<Value> {
    let basis = at_direction(order);
    let mut out = vec![g.constant(0.0); order * order];
    for Octant { point, weight } in octants(points) {
        let axes: Vec<usize> = (0..3).filter(|axis| point[*axis] != 0.0).collect();
        // A function that is odd in a coordinate that is 0 vanishes; the others' class has a bit for each
        // coordinate that is not.
        let class = |i: usize| {
            let bit = |(slot, axis): (usize, &usize)| ((parity(i) >> axis) & 1) << slot;
            axes.iter().enumerate().map(bit).sum::<usize>()
        };
        let y: Vec<f64> = basis
            .evaluate(&[&point])
            .into_iter()
            .enumerate()
            .map(|(i, y)| {
                let vanishes =
                    (0..3).any(|axis| point[axis] == 0.0 && (parity(i) >> axis) & 1 == 1);
                if vanishes || y.abs() < 1e-14 { 0.0 } else { y }
            })
            .collect();
        let mut values = vec![g.constant(0.0); 1 << axes.len()];
        for (i, y) in y.iter().enumerate().filter(|(_, y)| **y != 0.0) {
            let y = g.constant(*y);
            values[class(i)] = g.mul_add(y, f[i], values[class(i)]);
        }
        butterfly(g, &mut values);
        h(g, &point, &mut values);
        butterfly(g, &mut values);
        for (i, y) in y.iter().enumerate().filter(|(_, y)| **y != 0.0) {
            let c = g.constant(weight * y * gains[band(i).0]);
            out[i] = g.mul_add(c, values[class(i)], out[i]);
        }
    }
    out
}

/// Sums over classes with the sign that each class has at each point; its own inverse but for a factor.
fn butterfly(g: &mut Graph, values: &mut [Value]) {
    let mut step = 1;
    while step < values.len() {
        for i in (0..values.len()).filter(|i| i & step == 0) {
            let (a, b) = (values[i], values[i | step]);
            values[i] = g.add(a, b);
            values[i | step] = g.sub(a, b);
        }
        step *= 2;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫ x^a y^b z^c over the unit sphere, for even powers: 4π (a−1)!!(b−1)!!(c−1)!!/(a+b+c+1)!!.
    fn moment(powers: [i32; 3]) -> f64 {
        let double = |n: i32| -> f64 { (1..=n).rev().step_by(2).map(f64::from).product() };
        let top: f64 = powers.iter().map(|p| double(p - 1)).product();
        4.0 * std::f64::consts::PI * top / double(powers.iter().sum::<i32>() + 1)
    }

    #[test]
    fn rules_are_exact_to_their_degree_and_no_further() {
        for (count, degree) in [
            (6, 3),
            (14, 5),
            (26, 7),
            (38, 9),
            (50, 11),
            (86, 15),
            (110, 17),
        ] {
            let rule = points(count);
            assert_eq!(rule.len(), count);
            let mut beyond = 0.0_f64;
            for a in (0..=degree + 1).step_by(2) {
                for b in (0..=degree + 1 - a).step_by(2) {
                    for c in (0..=degree + 1 - a - b).step_by(2) {
                        let sum: f64 = rule
                            .iter()
                            .map(|(p, w)| w * p[0].powi(a) * p[1].powi(b) * p[2].powi(c))
                            .sum();
                        let off = (sum - moment([a, b, c])).abs();
                        if a + b + c > degree {
                            beyond = beyond.max(off);
                        } else {
                            assert!(off < 5e-14, "{count} points, x^{a} y^{b} z^{c}: {off:e}");
                        }
                    }
                }
            }
            assert!(beyond > 1e-9, "{count} points are better than stated");
        }
    }

    #[test]
    fn the_identity_comes_back() {
        for (order, count) in [(2, 6), (3, 14), (4, 26), (5, 38), (6, 50), (6, 110)] {
            let mut g = Graph::default();
            let f = g.inputs(0, order * order);
            g.outputs = pointwise(&mut g, order, count, &[1.0; 6], &f, |_, v| v);
            let values: Vec<f64> = (0..order * order).map(|i| (i as f64).sin()).collect();
            for (a, b) in g.evaluate(&[&values]).iter().zip(&values) {
                assert!((a - b).abs() < 1e-14, "order {order}, {count} points");
            }
        }
    }

    #[test]
    fn samples_are_those_of_the_rule() {
        // Squares by samples, against the sum over the points in any order.
        let (order, count) = (4, 50);
        let mut g = Graph::default();
        let f = g.inputs(0, 16);
        g.outputs = pointwise(&mut g, order, count, &[1.0; 4], &f, |g, v| g.mul(v, v));
        let values: Vec<f64> = (0..16).map(|i| (1.0 + i as f64).sin()).collect();
        let basis = at_direction(order);
        let mut sum = [0.0; 16];
        for (point, weight) in points(count) {
            let y = basis.evaluate(&[&point]);
            let v: f64 = y.iter().zip(&values).map(|(a, b)| a * b).sum();
            sum.iter_mut()
                .zip(&y)
                .for_each(|(s, y)| *s += weight * v * v * y);
        }
        for (a, b) in g.evaluate(&[&values]).iter().zip(sum) {
            assert!((a - b).abs() < 1e-13);
        }
    }
}
