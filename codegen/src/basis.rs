//! Basis functions and what follows from them band by band: rotated zonal vectors, the cosine lobe, the
//! window, the visibility of a circular cap.

use crate::exact::{band, legendre_derivative, normalisation};
use crate::expr::{Graph, Value};
use crate::real::Real;

/// All n² basis functions at the unit vector `d` = (x, y, z).
///
/// y_lm = √(k_lm/π) Q_lm(z) · Re or Im (x + iy)^|m|, Q evaluated by Horner's rule in z² with its constant
/// factor multiplied in.
pub fn basis(g: &mut Graph, order: usize, d: &[Value]) -> Vec<Value> {
    functions(g, order, d, polynomial)
}

/// As [`basis`], each function over its [`factors`]: Q begins with 1, so that constants cost nothing.
pub fn monic_basis(g: &mut Graph, order: usize, d: &[Value]) -> Vec<Value> {
    functions(g, order, d, |i| {
        let q = polynomial(i);
        let leading = q[q.len() - 1];
        q.iter().map(|c| c / leading).collect()
    })
}

/// What the functions of [`monic_basis`] have to be multiplied with.
pub fn factors(order: usize) -> Vec<f64> {
    let leading = |i: usize| polynomial(i).last().copied().unwrap_or(1.0);
    (0..order * order).map(leading).collect()
}

/// Q of basis function i with its constant factor, every second power of z, lowest first.
fn polynomial(i: usize) -> Vec<f64> {
    let (l, m) = band(i);
    let k = m.unsigned_abs() as usize;
    let norm = (normalisation(l, k).real() / Real::PI).sqrt();
    legendre_derivative(l, k)
        .iter()
        .skip((l - k) % 2)
        .step_by(2)
        .map(|c| (norm * c.real()).to_f64())
        .collect()
}

fn functions(
    g: &mut Graph,
    order: usize,
    d: &[Value],
    polynomial: impl Fn(usize) -> Vec<f64>,
) -> Vec<Value> {
    let powers = complex_powers(g, [d[0], d[1]], order);
    let z2 = g.mul(d[2], d[2]);
    (0..order * order)
        .map(|i| {
            let (l, m) = band(i);
            let k = m.unsigned_abs() as usize;
            let odd = (l - k) % 2;
            let even = g.horner(&polynomial(i), z2);
            match (m, odd) {
                (0, 0) => even,
                (0, _) => g.mul(d[2], even),
                (_, 0) => g.mul(even, powers[k][usize::from(m < 0)]),
                _ => {
                    let q = g.mul(even, d[2]);
                    g.mul(q, powers[k][usize::from(m < 0)])
                }
            }
        })
        .collect()
}

/// Re and Im of (c + is)^m for m < count; the entry for 0 is the constant 1.
pub fn complex_powers(g: &mut Graph, z: [Value; 2], count: usize) -> Vec<[Value; 2]> {
    let mut powers = vec![[g.constant(1.0), g.constant(0.0)], z];
    for m in 2..count {
        // The fewest multiplications deep, so that errors grow slowly: z² z², z⁴ z.
        let half = m.next_power_of_two() / 2;
        let ([a, b], [c, d]) = (powers[half], powers[m - half]);
        let re = if a == c {
            let (sum, difference) = (g.add(a, b), g.sub(a, b));
            g.mul(sum, difference)
        } else {
            let bd = g.mul(b, d);
            let minus = g.neg(bd);
            g.mul_add(a, c, minus)
        };
        let im = if a == c {
            let twice = g.scale(2.0, a);
            g.mul(twice, b)
        } else {
            let bc = g.mul(b, c);
            g.mul_add(a, d, bc)
        };
        powers.push([re, im]);
    }
    powers
}

/// `f_lm = w_l v_lm`.
pub fn scale_bands(g: &mut Graph, weights: &[Value], v: &[Value]) -> Vec<Value> {
    v.iter()
        .enumerate()
        .map(|(i, v)| g.mul(weights[band(i).0], *v))
        .collect()
}

/// A zonal vector about +Z turned to the direction `d`: `f_lm = √(4π/(2l+1)) z_l y_lm(d)`.
pub fn zonal(g: &mut Graph, order: usize, z: &[Value], d: &[Value]) -> Vec<Value> {
    let weights: Vec<_> = (0..order)
        .map(|l| g.scale(turn(l).to_f64(), z[l]))
        .collect();
    let y = basis(g, order, d);
    scale_bands(g, &weights, &y)
}

/// √(4π/(2l+1)).
pub(crate) fn turn(l: usize) -> Real {
    (Real::from(4.0) * Real::PI / Real::from(2.0 * l as f64 + 1.0)).sqrt()
}

/// The cosine lobe about `d` over π: `f_lm = (A_l/π) y_lm(d)`, A_l/π = 1, 2/3, 1/4, 0, −1/24, 0.
pub fn cosine(g: &mut Graph, order: usize, d: &[Value]) -> Vec<Value> {
    let weights: Vec<_> = (0..order).map(|l| g.constant(lobe_band(l))).collect();
    let y = basis(g, order, d);
    scale_bands(g, &weights, &y)
}

/// A_l/π of the cosine lobe: 1, 2/3, and of other bands, of which only the even ones have any,
/// 2 (−1)^(l/2 − 1) l! / ((l + 2)(l − 1) 2^l (l/2)!²) (Ramamoorthi and Hanrahan 2001, equation 19).
pub(crate) fn lobe_band(l: usize) -> f64 {
    match l {
        0 => 1.0,
        1 => 2.0 / 3.0,
        l if l % 2 == 1 => 0.0,
        l => {
            // l! / (2^l (l/2)!²) = Π (2k − 1) / 2k
            let middle: f64 = (1..=l / 2)
                .map(|k| (2 * k - 1) as f64 / (2 * k) as f64)
                .product();
            let sign = if l % 4 == 0 { -1.0 } else { 1.0 };
            2.0 * sign * middle / ((l + 2) * (l - 1)) as f64
        }
    }
}

/// `f_lm α_l` with α_l = cos(π/2 · l/h), 0 for l ≥ h.
pub fn window(g: &mut Graph, order: usize, f: &[Value], h: Value) -> Vec<Value> {
    let quarter = g.constant((Real::PI / Real::from(2.0)).to_f64());
    let x = g.div(quarter, h);
    let x2 = g.mul(x, x);
    // cos to full double precision on 0..π/2: the first term left out is (π/2)²²/22! = 2e-17. A wider
    // argument needs h < 1, where every band but the first is cut.
    let mut term = 1.0;
    let taylor: Vec<f64> = (0..11)
        .map(|i| {
            let c = term;
            term /= -f64::from((2 * i + 1) * (2 * i + 2));
            c
        })
        .collect();
    let mut cosines = vec![g.constant(1.0), g.horner(&taylor, x2)];
    let twice = g.scale(2.0, cosines[1]);
    for l in 2..order {
        let minus = g.neg(cosines[l - 2]);
        let next = g.mul_add(twice, cosines[l - 1], minus);
        cosines.push(next);
    }
    let zero = g.constant(0.0);
    let weights: Vec<_> = (0..order)
        .map(|l| {
            if l == 0 {
                return cosines[0];
            }
            let band = g.constant(l as f64);
            g.select(band, h, cosines[l], zero)
        })
        .collect();
    scale_bands(g, &weights, f)
}

/// Zonal coefficients of a cap's visibility, 0 within the angle θ of +Z and 1 elsewhere, from cos θ and
/// sin θ.
///
/// g_0 = √π (1 + cos θ), g_l = −√(π(2l+1))/(l(l+1)) sin²θ P_l'(cos θ): the integral of P_l from cos θ to 1
/// in the form that keeps its relative accuracy for small caps.
pub fn cap_visibility(g: &mut Graph, order: usize, cos: Value, sin: Value) -> Vec<Value> {
    let s2 = g.mul(sin, sin);
    let c2 = g.mul(cos, cos);
    let root_pi = g.constant(Real::PI.sqrt().to_f64());
    let mut out = vec![g.mul_add(root_pi, cos, root_pi)];
    for l in 1..order {
        let scale = (Real::PI * Real::from(2.0 * l as f64 + 1.0)).sqrt()
            / Real::from(-((l * l + l) as f64));
        let q = legendre_derivative(l, 1);
        let odd = (l - 1) % 2;
        let coefficients: Vec<f64> = q
            .iter()
            .skip(odd)
            .step_by(2)
            .map(|c| (scale * c.real()).to_f64())
            .collect();
        let mut p = g.horner(&coefficients, c2);
        if odd == 1 {
            p = g.mul(p, cos);
        }
        out.push(g.mul(p, s2));
    }
    out
}
