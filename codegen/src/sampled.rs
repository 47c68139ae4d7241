//! Exponentials taken at samples: a function of each sample of a log visibility, projected back.
//!
//! A product series truncates to order n after every product, and what it cuts off grows with the blockers
//! that overlap. At samples nothing is cut off before the end, and any function may stand in for e^x; one that
//! is bounded bounds the result for whatever goes in.

use crate::basis;
use crate::exact::legendre_derivative;
use crate::expr::{Graph, Value};
use crate::fits;
use crate::octahedral::{pointwise, pointwise_towards};

/// The most that an exponent counts for in the clamped exponential.
pub const CLAMP: f64 = 0.15;

/// How fine the rule is that samples are taken on.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Fineness {
    /// Few points: for speed.
    Coarse,
    /// Where more points gain little.
    Medium,
    /// More points than pay.
    Fine,
}

/// Points of the rule of an order.
pub fn points(order: usize, fineness: Fineness) -> usize {
    let [coarse, medium, fine] = match order {
        2 => [6, 14, 26],
        3 => [14, 26, 38],
        4 => [38, 50, 86],
        5 => [50, 86, 110],
        _ => [50, 86, 110],
    };
    match fineness {
        Fineness::Coarse => coarse,
        Fineness::Medium => medium,
        Fineness::Fine => fine,
    }
}

/// `Σ_q w_q exp(min(f(s_q), c)) y(s_q)` with c = [`CLAMP`].
pub fn clamped(g: &mut Graph, order: usize, fineness: Fineness, f: &[Value]) -> Vec<Value> {
    let gains = vec![1.0; order];
    let clamp = g.constant(CLAMP);
    let points = points(order, fineness);
    pointwise(g, order, points, &gains, f, |g, x| {
        let x = g.min(x, clamp);
        g.exp(x)
    })
}

/// Where the saturating function reaches 0.
pub const DARK: f64 = -1.0;

/// Where it stops to grow.
pub const BRIGHT: f64 = 0.2;

/// Its second zero is at 1/`BEND`, beyond [`BRIGHT`].
pub const BEND: f64 = 0.25;

/// The largest square of a norm that is told apart from larger ones.
const LARGEST_SQUARE: f64 = 1e37;

/// `f / √(1 + β ‖f̂‖²/4π)`: ripples of many blockers, which grow with their number, become those of a few. Before samples
/// are taken, because sums of large coefficients may overflow where their samples do not.
fn compressed(g: &mut Graph, beta: f64, f: &[Value]) -> Vec<Value> {
    let square = g.dot(&f[1..], &f[1..]);
    // A square that overflows would make the factor 0, and darkness light.
    let largest = g.constant(LARGEST_SQUARE);
    let square = g.min(square, largest);
    let (one, beta) = (
        g.constant(1.0),
        g.constant(beta / (4.0 * std::f64::consts::PI)),
    );
    let sum = g.mul_add(beta, square, one);
    let root = g.sqrt(sum);
    let factor = g.div(one, root);
    f.iter().map(|f| g.mul(*f, factor)).collect()
}

/// Compressed, `x = f / √(1 + β ‖f̂‖²/4π)`, then `h(t) = ((1 + t)(1 − t/4))²` of each sample, t = x(s) held in
/// −1..0.2, and band l of the projection times a gain.
pub fn saturating(g: &mut Graph, order: usize, f: &[Value]) -> Vec<Value> {
    let (beta, gains) = fits::saturating(order);
    let x = compressed(g, beta, f);
    let one = g.constant(1.0);
    let (dark, bright) = (g.constant(DARK), g.constant(BRIGHT));
    let (bend, slope) = (g.constant(-BEND), g.constant(1.0 - BEND));
    let points = points(order, Fineness::Medium);
    pointwise(g, order, points, &gains, &x, |g, x| {
        let x = g.max(x, dark);
        let t = g.min(x, bright);
        let linear = g.mul_add(bend, t, slope);
        let root = g.mul_add(t, linear, one);
        g.mul(root, root)
    })
}

/// The largest value that a sample of the saturating exponential takes: 1.2996.
pub fn brightest() -> f64 {
    ((1.0 + BRIGHT) * (1.0 - BEND * BRIGHT)).powi(2)
}

/// Where a sample of `transfer` stops to grow: (1 + 1/8)⁴ = 1.6018.
pub const TRANSFER_BRIGHT: f64 = 0.5;

/// Compressed as in [`saturating`], then `h(x) = (1 + x/4)⁴` of each sample, x held in −4..1/2, times the cosine lobe about
/// `d`, projected. The lobe has all bands that couple light of the order with a visibility of the order.
pub fn transfer(g: &mut Graph, order: usize, f: &[Value], d: &[Value]) -> Vec<Value> {
    let (odd, even) = lobe(2 * order - 2);
    let odd = g.constant(odd);
    through(g, order, f, d, |g, cosine| {
        let squared = g.mul(cosine, cosine);
        let lobe = g.horner(&even, squared);
        g.mul_add(odd, cosine, lobe)
    })
}

/// The same with a lobe about `d` of which band l is `w[l]`, held in −1..1, times that of a lobe of no width.
pub fn transfer_lobe(
    g: &mut Graph,
    order: usize,
    f: &[Value],
    d: &[Value],
    w: &[Value],
) -> Vec<Value> {
    // Powers of the cosine, from those of each band's polynomial.
    let mut powers = vec![None; order];
    let (most, least) = (g.constant(1.0), g.constant(-1.0));
    for (l, w) in w.iter().enumerate() {
        let w = g.min(*w, most);
        let w = g.max(w, least);
        let scale = (2 * l + 1) as f64 / (4.0 * std::f64::consts::PI);
        for (power, c) in legendre_derivative(l, 0).iter().enumerate() {
            let c = scale * c.real().to_f64();
            if c != 0.0 {
                let c = g.constant(c);
                powers[power] = Some(match powers[power] {
                    Some(sum) => g.mul_add(c, w, sum),
                    None => g.mul(c, w),
                });
            }
        }
    }
    let powers: Vec<Value> = powers.into_iter().flatten().collect();
    through(g, order, f, d, |g, cosine| {
        let mut all = powers.iter().rev();
        let last = *all.next().expect("an order has bands");
        all.fold(last, |sum, power| g.mul_add(sum, cosine, *power))
    })
}

/// Samples of the visibility whose logarithm is `f`, each times a function of its cosine with `d`, projected.
fn through(
    g: &mut Graph,
    order: usize,
    f: &[Value],
    d: &[Value],
    mut lobe: impl FnMut(&mut Graph, Value) -> Value,
) -> Vec<Value> {
    let x = compressed(g, fits::shading(order), f);
    let (quarter, one) = (g.constant(0.25), g.constant(1.0));
    let (dark, bright) = (g.constant(0.0), g.constant(1.0 + TRANSFER_BRIGHT / 4.0));
    let points = points(order, Fineness::Medium);
    pointwise_towards(g, order, points, &x, d, |g, x, cosine| {
        let root = g.mul_add(quarter, x, one);
        let root = g.max(root, dark);
        let root = g.min(root, bright);
        let square = g.mul(root, root);
        let visible = g.mul(square, square);
        let lobe = lobe(g, cosine);
        g.mul(visible, lobe)
    })
}

/// The cosine lobe over π up to band `last`, Σ A_l/π (2l+1)/4π P_l, as a polynomial in the cosine: the factor of the cosine
/// itself, and those of the powers of its square. No other odd power occurs.
fn lobe(last: usize) -> (f64, Vec<f64>) {
    let mut polynomial = vec![0.0; last + 1];
    for l in 0..=last {
        let scale = basis::lobe_band(l) * (2 * l + 1) as f64 / (4.0 * std::f64::consts::PI);
        for (sum, c) in polynomial.iter_mut().zip(legendre_derivative(l, 0)) {
            *sum += scale * c.real().to_f64();
        }
    }
    let even = polynomial.iter().copied().step_by(2).collect();
    (polynomial[1], even)
}
