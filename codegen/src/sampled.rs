//! Exponentials taken at samples: a function of each sample of a log visibility, projected back.
//!
//! A product series truncates to order n after every product, and what it cuts off grows with the blockers
//! that overlap. At samples nothing is cut off before the end, and any function may stand in for e^x; one that
//! is bounded bounds the result for whatever goes in.

use crate::expr::{Graph, Value};
use crate::fits;
use crate::octahedral::pointwise;

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

/// Compressed, `x = f / √(1 + β ‖f̂‖²/4π)`, then `h(t) = ((1 + t)(1 − t/4))²` of each sample, t = x(s) held in
/// −1..0.2, and band l of the projection times a gain.
pub fn saturating(g: &mut Graph, order: usize, f: &[Value]) -> Vec<Value> {
    let (beta, gains) = fits::saturating(order);
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
    // Before the samples are taken: sums of large coefficients may overflow where their samples do not.
    let x: Vec<_> = f.iter().map(|f| g.mul(*f, factor)).collect();
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
