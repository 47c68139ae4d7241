//! SH products on rings: a transform in latitude, a direct product in azimuth.
//!
//! Two functions of degree n−1 are evaluated on circles of latitude, where each is a trigonometric
//! polynomial in the azimuth,
//!
//! ```text
//! f(z, φ) = a₀ + 2 Σ_m (a_m cos mφ + b_m sin mφ),     a_m = √½ Σ_l √(k_lm/π) (1−z²)^(m/2) Q_lm(z) f_lm  (m > 0)
//! ```
//!
//! multiplied there, cut off at m = n−1 (higher azimuthal orders belong to coefficients that the product
//! drops), and projected back by quadrature in z. What is integrated has degree 3(n−1) in z, so a rule that
//! is exact for that degree makes the result exact. Rings come in pairs ±z that share their work by parity:
//! l+m even is even in z. Gauss–Lobatto rules put two nodes on the poles, where only m = 0 is left and a
//! ring is one number; with an odd count one node is the equator, where odd l+m vanish.
//!
//! The cost grows as n³ (transform) + n³ (rings) where the term-by-term product grows as n⁵.

use crate::exact::{legendre_derivative, normalisation};
use crate::expr::{Graph, Value};
use crate::real::Real;

/// How the nodes of a rule in z are placed.
struct Node {
    z: Real,
    weight: Real,
}

/// P_n(z) and its first and second derivatives.
fn legendre(n: usize, z: Real) -> [Real; 3] {
    let mut out = [Real::from(0.0); 3];
    for (m, value) in out.iter_mut().enumerate() {
        for c in legendre_derivative(n, m).iter().rev() {
            *value = *value * z + c.real();
        }
    }
    out
}

/// The Gauss–Lobatto rule of `count` nodes, exact to degree 2·count − 3: nodes z ≥ 0, from the pole down.
fn lobatto(count: usize) -> Vec<Node> {
    let n = count - 1;
    let scale = Real::from(2.0) / Real::from((count * n) as f64);
    (0..count.div_ceil(2))
        .map(|i| {
            let mut z = Real::from((std::f64::consts::PI * i as f64 / n as f64).cos());
            if i == 0 {
                z = Real::from(1.0);
            } else if 2 * i == n {
                z = Real::from(0.0);
            } else {
                // Interior nodes are the zeros of P'_n; Newton from the Chebyshev guess.
                for _ in 0..12 {
                    let [_, d, dd] = legendre(n, z);
                    z = z - d / dd;
                }
            }
            let [p, ..] = legendre(n, z);
            Node {
                z,
                weight: scale / (p * p),
            }
        })
        .collect()
}

/// The rings of an order: latitude nodes z ≥ 0 and the tables of one ring pair each.
pub struct Rings {
    order: usize,
    rings: Vec<Ring>,
}

struct Ring {
    pole: bool,
    equator: bool,
    /// Per coefficient: to the ring's amplitude, and back (weight included).
    forward: Vec<f64>,
    back: Vec<f64>,
}

/// A function on one circle: a₀, then a_m and b_m for m = 1..n−1. Zeros are constants.
type Circle = Vec<Value>;

impl Rings {
    /// The rule for an order.
    pub fn new(order: usize) -> Self {
        let degree = 3 * (order - 1);
        // An odd degree's integrands are even in z only up to degree − 1.
        let count = (degree + 3).div_ceil(2);
        let rings = lobatto(count)
            .into_iter()
            .map(|node| Ring::new(order, &node))
            .collect();
        Self { order, rings }
    }

    /// Amplitudes on the rings at +z and −z (one of them at the equator).
    fn circles(&self, g: &mut Graph, ring: &Ring, f: &[Value]) -> Vec<Circle> {
        let n = self.order as i32;
        let mut above = Vec::new();
        let mut below = Vec::new();
        for m in azimuths(n) {
            let part = |g: &mut Graph, odd: i32| {
                let mut sum = g.constant(0.0);
                for l in (m.abs()..n).filter(|l| (l + m.abs()) % 2 == odd) {
                    let i = (l * l + l + m) as usize;
                    let c = g.constant(ring.forward[i]);
                    sum = g.mul_add(c, f[i], sum);
                }
                sum
            };
            if ring.pole && m != 0 {
                let zero = g.constant(0.0);
                above.push(zero);
                below.push(zero);
                continue;
            }
            let even = part(g, 0);
            if ring.equator {
                above.push(even);
                continue;
            }
            let odd = part(g, 1);
            above.push(g.add(even, odd));
            below.push(g.sub(even, odd));
        }
        if ring.equator {
            vec![above]
        } else {
            vec![above, below]
        }
    }

    /// Projects circles back and adds to `out`.
    fn project(&self, g: &mut Graph, ring: &Ring, circles: &[Circle], out: &mut [Value]) {
        let n = self.order as i32;
        for (slot, m) in azimuths(n).enumerate() {
            if ring.pole && m != 0 {
                continue;
            }
            let above = circles[0][slot];
            let (even, odd) = match circles.get(1) {
                Some(below) => (g.add(above, below[slot]), g.sub(above, below[slot])),
                None => (above, g.constant(0.0)),
            };
            for l in m.abs()..n {
                let i = (l * l + l + m) as usize;
                let c = g.constant(ring.back[i]);
                let part = if (l + m.abs()) % 2 == 0 { even } else { odd };
                out[i] = g.mul_add(c, part, out[i]);
            }
        }
    }

    /// `h = f * g`.
    pub fn product(&self, g: &mut Graph, a: &[Value], b: &[Value]) -> Vec<Value> {
        let mut out = vec![g.constant(0.0); self.order * self.order];
        for ring in &self.rings {
            let ca = self.circles(g, ring, a);
            let cb = self.circles(g, ring, b);
            let products: Vec<_> = ca
                .iter()
                .zip(&cb)
                .map(|(a, b)| multiply(g, self.order, a, b))
                .collect();
            self.project(g, ring, &products, &mut out);
        }
        out
    }

    /// `h = f * f`.
    pub fn square(&self, g: &mut Graph, a: &[Value]) -> Vec<Value> {
        let mut out = vec![g.constant(0.0); self.order * self.order];
        for ring in &self.rings {
            let circles = self.circles(g, ring, a);
            let squares: Vec<_> = circles.iter().map(|a| square(g, self.order, a)).collect();
            self.project(g, ring, &squares, &mut out);
        }
        out
    }
}

impl Ring {
    fn new(order: usize, node: &Node) -> Self {
        let one = Real::from(1.0);
        let pole = node.z == one;
        let equator = node.z == Real::from(0.0);
        let sine = (one - node.z * node.z).sqrt();
        let mut forward = vec![0.0; order * order];
        let mut back = vec![0.0; order * order];
        for (i, (to, from)) in forward.iter_mut().zip(&mut back).enumerate() {
            let (l, m) = crate::exact::band(i);
            let m = m.unsigned_abs() as usize;
            let mut value = (normalisation(l, m).real() / Real::PI).sqrt();
            let mut polynomial = Real::from(0.0);
            for c in legendre_derivative(l, m).iter().rev() {
                polynomial = polynomial * node.z + c.real();
            }
            value = value * polynomial;
            for _ in 0..m {
                value = value * sine;
            }
            // ∫ h cos mφ dφ = 2π a_m, for m = 0 and, with f = a₀ + 2 Σ …, for m > 0 alike.
            let circle = Real::from(2.0) * Real::PI * node.weight;
            *to = (if m == 0 {
                value
            } else {
                value * Real::from(0.5)
            })
            .to_f64();
            *from = (value * circle).to_f64();
        }
        Self {
            pole,
            equator,
            forward,
            back,
        }
    }
}

/// 0, 1, −1, 2, −2, …: where a circle keeps its amplitudes.
fn azimuths(n: i32) -> impl Iterator<Item = i32> {
    std::iter::once(0).chain((1..n).flat_map(|m| [m, -m]))
}

fn part(circle: &Circle, m: usize) -> [Value; 2] {
    [circle[2 * m - 1], circle[2 * m]]
}

/// Adds the complex product (a − ib)(c − id) of two amplitudes, or of the first and the second's conjugate.
fn accumulate(g: &mut Graph, sum: &mut [Value; 2], x: [Value; 2], y: [Value; 2], conjugate: bool) {
    let flip = |g: &mut Graph, v: Value, yes: bool| if yes { g.neg(v) } else { v };
    sum[0] = g.mul_add(x[0], y[0], sum[0]);
    let t = flip(g, y[1], !conjugate);
    sum[0] = g.mul_add(x[1], t, sum[0]);
    sum[1] = g.mul_add(x[1], y[0], sum[1]);
    let t = flip(g, y[1], conjugate);
    sum[1] = g.mul_add(x[0], t, sum[1]);
}

/// The product of two trigonometric polynomials of degree n−1, cut off at degree n−1.
fn multiply(g: &mut Graph, order: usize, a: &Circle, b: &Circle) -> Circle {
    let zero = g.constant(0.0);
    let mut mean = zero;
    for i in 1..a.len() {
        mean = g.mul_add(a[i], b[i], mean);
    }
    let two = g.constant(2.0);
    mean = g.mul(two, mean);
    let mut out = vec![g.mul_add(a[0], b[0], mean)];
    for k in 1..order {
        let mut sum = [zero, zero];
        for (i, s) in sum.iter_mut().enumerate() {
            *s = g.mul_add(a[0], part(b, k)[i], zero);
            *s = g.mul_add(b[0], part(a, k)[i], *s);
        }
        for j in 1..k {
            accumulate(g, &mut sum, part(a, j), part(b, k - j), false);
        }
        for j in k + 1..order {
            accumulate(g, &mut sum, part(a, j), part(b, j - k), true);
            accumulate(g, &mut sum, part(b, j), part(a, j - k), true);
        }
        out.extend(sum);
    }
    out
}

/// The square of a trigonometric polynomial of degree n−1, cut off at degree n−1.
fn square(g: &mut Graph, order: usize, a: &Circle) -> Circle {
    let zero = g.constant(0.0);
    let two = g.constant(2.0);
    let mut mean = zero;
    for x in &a[1..] {
        mean = g.mul_add(*x, *x, mean);
    }
    mean = g.mul(two, mean);
    let mut out = vec![g.mul_add(a[0], a[0], mean)];
    // Every term but an amplitude's own square comes twice: work with one doubled factor.
    let doubled: Circle = a.iter().map(|x| g.mul(two, *x)).collect();
    for k in 1..order {
        let mut sum = [zero, zero];
        for (i, s) in sum.iter_mut().enumerate() {
            *s = g.mul(doubled[0], part(a, k)[i]);
        }
        for j in 1..k.div_ceil(2) {
            accumulate(g, &mut sum, part(&doubled, j), part(a, k - j), false);
        }
        if k % 2 == 0 {
            let [c, s] = part(a, k / 2);
            let minus = g.neg(s);
            sum[0] = g.mul_add(c, c, sum[0]);
            sum[0] = g.mul_add(s, minus, sum[0]);
            sum[1] = g.mul_add(part(&doubled, k / 2)[0], s, sum[1]);
        }
        for j in k + 1..order {
            accumulate(g, &mut sum, part(&doubled, j), part(a, j - k), true);
        }
        out.extend(sum);
    }
    out
}
