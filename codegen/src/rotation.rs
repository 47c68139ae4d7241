//! Rotation of SH vectors by a quaternion or a matrix.
//!
//! A rotation is split as R = R_z(α) R_y(β) R_z(γ), and R_y(β) = X⁻¹ R_z(β) X with X the quarter turn
//! about x. Turns about z mix pairs ±m only; X is a constant sparse matrix (exact square roots of
//! rationals). With a quaternion (x, y, z, w) the angles are never formed:
//!
//! ```text
//! P = (w + iz)/|w + iz| = e^{i(α+γ)/2},   Q = (y + ix)/|y + ix| = e^{i(γ−α)/2},
//! e^{iγ} = PQ,   e^{iα} = P Q̄,   cos β = w²+z²−x²−y²,   sin β = 2 |w + iz| |y + ix|.
//! ```
//!
//! Each of P and Q is as accurate as the quaternion's components, however small the tilt: there is no
//! cancellation near the pole, where formulas in Euler angles lose half their digits. Where one of them is
//! undefined (|x|, |y| < 1e-18) its direction has no effect, and 1 stands in.

use crate::basis::complex_powers;
use crate::exact::quarter_turn;
use crate::expr::{Graph, Value};

type Complex = [Value; 2];

fn multiply(g: &mut Graph, [a, b]: Complex, [c, d]: Complex, conjugate: bool) -> Complex {
    let (bd, bc) = (g.mul(b, d), g.mul(b, c));
    let (bd, ad_sign) = if conjugate {
        (bd, g.neg(d))
    } else {
        (g.neg(bd), d)
    };
    [g.mul_add(a, c, bd), g.mul_add(a, ad_sign, bc)]
}

/// `z / |z|`, or 1 where |z| is below 1e-18; and |z|².
fn unit(g: &mut Graph, [re, im]: Complex) -> (Complex, Value) {
    let square = g.mul(im, im);
    let square = g.mul_add(re, re, square);
    let tiny = g.constant(1e-36);
    let one = g.constant(1.0);
    let zero = g.constant(0.0);
    let root = g.sqrt(square);
    // Division before the choice: what the choice discards may be infinite.
    let (re, im) = (g.div(re, root), g.div(im, root));
    (
        [
            g.select(square, tiny, one, re),
            g.select(square, tiny, zero, im),
        ],
        square,
    )
}

/// Turn about z: (a, b) of ±m become (a c − b s, a s + b c) with c + is = e^{imα}.
fn about_z(g: &mut Graph, order: usize, f: &[Value], powers: &[Complex]) -> Vec<Value> {
    let mut out = f.to_vec();
    for l in 1..order {
        for (m, power) in powers.iter().enumerate().take(l + 1).skip(1) {
            let (i, j) = (l * l + l + m, l * l + l - m);
            let ab = [f[i], f[j]];
            let turned = multiply(g, ab, *power, false);
            out[i] = turned[0];
            out[j] = turned[1];
        }
    }
    out
}

/// The quarter turn about x, or its inverse (the transpose).
fn quarter(g: &mut Graph, order: usize, f: &[Value], inverse: bool) -> Vec<Value> {
    let mut out = Vec::with_capacity(f.len());
    for l in 0..order as i32 {
        for m in -l..=l {
            let mut sum = g.constant(0.0);
            for k in -l..=l {
                let (row, column) = if inverse { (k, m) } else { (m, k) };
                let d = quarter_turn(l as usize, row, column);
                if d.sign != 0 {
                    let c = g.constant(d.real().to_f64());
                    sum = g.mul_add(c, f[(l * l + l + k) as usize], sum);
                }
            }
            out.push(sum);
        }
    }
    out
}

/// The vector `f` rotated by the quaternion `q` = (x, y, z, w): (Rf)(s) = f(R⁻¹s).
pub fn rotate(g: &mut Graph, order: usize, f: &[Value], q: &[Value]) -> Vec<Value> {
    let (p, near) = unit(g, [q[3], q[2]]);
    let (r, far) = unit(g, [q[1], q[0]]);
    let gamma = multiply(g, p, r, false);
    let alpha = multiply(g, p, r, true);
    // Dividing by |q|² keeps this a rotation for quaternions that are unit only to rounding.
    let total = g.add(near, far);
    let difference = g.sub(near, far);
    let cos = g.div(difference, total);
    let both = g.mul(near, far);
    let root = g.sqrt(both);
    let twice = g.scale(2.0, root);
    let sin = g.div(twice, total);
    let powers = |g: &mut Graph, z: Complex| complex_powers(g, z, order);
    let (a, b, c) = (powers(g, alpha), powers(g, [cos, sin]), powers(g, gamma));
    let f = about_z(g, order, f, &c);
    let f = quarter(g, order, &f, false);
    let f = about_z(g, order, &f, &b);
    let f = quarter(g, order, &f, true);
    about_z(g, order, &f, &a)
}

/// A multiple of the quaternion of a rotation matrix, given row by row. Of the four ways to find it
/// (Shepperd 1978) the one without cancellation is chosen, by comparisons only.
pub fn quaternion(g: &mut Graph, m: &[Value]) -> Vec<Value> {
    let e = |r: usize, c: usize| m[3 * r + c];
    let one = g.constant(1.0);
    let mut square = |s: [bool; 3]| {
        let mut sum = one;
        for (i, minus) in s.into_iter().enumerate() {
            sum = if minus {
                g.sub(sum, e(i, i))
            } else {
                g.add(sum, e(i, i))
            };
        }
        sum
    };
    let squares = [
        square([false, true, true]),
        square([true, false, true]),
        square([true, true, false]),
        square([false, false, false]),
    ];
    let sum = |g: &mut Graph, a: usize, b: usize| g.add(e(a, b), e(b, a));
    let (xy, xz, yz) = (sum(g, 0, 1), sum(g, 0, 2), sum(g, 1, 2));
    let (wx, wy, wz) = (
        g.sub(e(2, 1), e(1, 2)),
        g.sub(e(0, 2), e(2, 0)),
        g.sub(e(1, 0), e(0, 1)),
    );
    let rows = [
        [squares[0], xy, xz, wx],
        [xy, squares[1], yz, wy],
        [xz, yz, squares[2], wz],
        [wx, wy, wz, squares[3]],
    ];
    let (mut best, mut row) = (squares[0], rows[0]);
    for i in 1..4 {
        for (value, other) in row.iter_mut().zip(rows[i]) {
            *value = g.select(best, squares[i], other, *value);
        }
        best = g.select(best, squares[i], squares[i], best);
    }
    row.to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::real::Real;

    /// The largest deviation of X Xᵀ from 1, for the test of the exact entries.
    fn orthogonality(order: usize) -> f64 {
        let mut worst = 0.0_f64;
        for l in 0..order as i32 {
            for a in -l..=l {
                for b in -l..=l {
                    let mut sum = Real::from(if a == b { -1.0 } else { 0.0 });
                    for k in -l..=l {
                        let entry = |r| quarter_turn(l as usize, r, k).real();
                        sum = sum + entry(a) * entry(b);
                    }
                    worst = worst.max(sum.to_f64().abs());
                }
            }
        }
        worst
    }

    #[test]
    fn quarter_turn_is_orthogonal() {
        assert!(orthogonality(6) < 1e-29);
    }

    /// A band-1 vector rotates as the vector (x, y, z) does.
    #[test]
    fn vectors_rotate_actively() {
        let mut g = Graph::default();
        let (f, q) = (g.inputs(0, 4), g.inputs(1, 4));
        g.outputs = rotate(&mut g, 2, &f, &q);
        let half = std::f64::consts::FRAC_PI_4;
        // 90° about z sends x̂ to ŷ; band 1 is (y, z, x).
        let out = g.evaluate(&[&[1.0, 0.0, 0.0, 1.0], &[0.0, 0.0, half.sin(), half.cos()]]);
        for (a, b) in out.iter().zip([1.0, 1.0, 0.0, 0.0]) {
            assert!((a - b).abs() < 1e-15, "{out:?}");
        }
        // 90° about x sends ŷ to ẑ.
        let out = g.evaluate(&[&[1.0, 1.0, 0.0, 0.0], &[half.sin(), 0.0, 0.0, half.cos()]]);
        for (a, b) in out.iter().zip([1.0, 0.0, 1.0, 0.0]) {
            assert!((a - b).abs() < 1e-15, "{out:?}");
        }
    }
}
