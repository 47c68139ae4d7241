//! Fitted functions: polynomials whose coefficients are data, rewritten by `gaunt-lab fit`.
//!
//! The files in `codegen/data/` hold one row of numbers a line, after the words it is found by; `#` starts a
//! comment. They are compiled in, so that nobody who builds this crate runs a fit.

use crate::expr::{Graph, Value};

const CAP_LOG: &str = include_str!("../data/cap_log.txt");
const CAP_LOG_TABLE: &str = include_str!("../data/cap_log_table.txt");
const LENS: &str = include_str!("../data/lens.txt");
const OPTIMAL_LINEAR: &str = include_str!("../data/optimal_linear.txt");
const BALL: &str = include_str!("../data/ball.txt");
const GLOSS: &str = include_str!("../data/gloss.txt");
const HORIZON: &str = include_str!("../data/horizon.txt");
const SATURATING: &str = include_str!("../data/saturating.txt");
const SHADING: &str = include_str!("../data/shading.txt");

/// What the cap logarithms are fitted to, as the data file names it: the exponentials, and the eigen logarithm
/// itself.
pub const CAP_LOGS: [&str; 9] = [
    "shading",
    "saturating",
    "sampled",
    "sampled_coarse",
    "sampled_fine",
    "ps_star",
    "hyb",
    "optimal_linear",
    "eigen",
];

/// The rows of a data file that start with these words, without them.
fn rows(text: &str, words: &[&str]) -> Vec<Vec<f64>> {
    text.lines()
        .filter_map(|line| line.split('#').next())
        .map(|line| line.split_whitespace().collect::<Vec<_>>())
        .filter(|row| row.len() > words.len() && row[..words.len()] == *words)
        .map(|row| {
            row[words.len()..]
                .iter()
                .map(|word| {
                    word.parse()
                        .unwrap_or_else(|_| panic!("fitted data: `{word}` is no number"))
                })
                .collect()
        })
        .collect()
}

/// One of the fitted numbers of a polished surface's lobe, of roughness and cosine.
fn of_gloss(g: &mut Graph, name: &[&str], roughness: Value, cosine: Value) -> Value {
    let (zero, one) = (g.constant(0.0), g.constant(1.0));
    let (two, minus_one) = (g.constant(2.0), g.constant(-1.0));
    let [x, y] = [roughness, cosine].map(|v| {
        let v = g.max(v, zero);
        let v = g.min(v, one);
        g.mul_add(two, v, minus_one)
    });
    // Rows begin with their power of x.
    let mut powers = rows(GLOSS, name).into_iter().rev();
    let highest = powers.next().expect("gloss.txt has all of its numbers");
    let mut sum = g.horner(&highest[1..], y);
    for row in powers {
        let along = g.horner(&row[1..], y);
        sum = g.mul_add(sum, x, along);
    }
    sum
}

/// What a polished surface's lobe mirrors of an even sky, and the part of it that grows with Fresnel's reflectance at
/// grazing angles.
pub fn gloss_energy(g: &mut Graph, roughness: Value, cosine: Value) -> Vec<Value> {
    let (zero, one, least) = (g.constant(0.0), g.constant(1.0), g.constant(LEAST_ENERGY));
    let energy = of_gloss(g, &["energy"], roughness, cosine);
    let energy = g.min(energy, one);
    let energy = g.max(energy, least);
    let grazing = of_gloss(g, &["grazing"], roughness, cosine);
    let grazing = g.max(grazing, zero);
    vec![energy, g.min(grazing, energy)]
}

/// Below what any surface mirrors: what is divided by.
const LEAST_ENERGY: f64 = 0.25;

/// The sine of the axis of a polished surface's lobe, over that of the mirrored direction.
pub fn gloss_tilt(g: &mut Graph, roughness: Value, cosine: Value) -> Value {
    let (zero, one) = (g.constant(0.0), g.constant(1.0));
    let tilt = of_gloss(g, &["tilt"], roughness, cosine);
    let tilt = g.max(tilt, zero);
    g.min(tilt, one)
}

/// The least roughness whose lobe, of which an order has but the lower bands, is nowhere below 0 by more than 3 % of its peak, for
/// orders from 2 on (two bands are, whatever the lobe): of a smoother one a sun would have dark rings.
const TOLD: [f64; 5] = [1.0, 0.88, 0.72, 0.6, 0.59];

/// The roughness in whose place light of an order has this one.
pub fn gloss_told(g: &mut Graph, order: usize, roughness: Value) -> Value {
    let (least, most) = (g.constant(TOLD[order - 2]), g.constant(1.0));
    let told = g.max(roughness, least);
    g.min(told, most)
}

/// The mean of P_l over a polished surface's lobe, about its axis.
pub fn gloss_lobe(g: &mut Graph, order: usize, roughness: Value, cosine: Value) -> Vec<Value> {
    let one = g.constant(1.0);
    let bands = (0..order).map(|l| match l {
        0 => one,
        _ => {
            let band = of_gloss(g, &["band", &l.to_string()], roughness, cosine);
            g.min(band, one)
        }
    });
    bands.collect()
}

/// Coefficients of a fitted cap logarithm, by what it is fitted to (see [`CAP_LOGS`]): for each band, powers of
/// u = 2 cos θ − 1, lowest first.
pub fn cap_log_coefficients(fitted_to: &str, order: usize) -> Vec<Vec<f64>> {
    let order_word = order.to_string();
    let bands = match fitted_to {
        "shading" => rows(SHADING, &["log", &order_word]),
        _ => rows(CAP_LOG, &[fitted_to, &order_word]),
    };
    assert_eq!(
        bands.len(),
        order,
        "there is no fit `{fitted_to}` of order {order}"
    );
    bands
}

/// The eigen logarithm of a cap's visibility at every whole degree 0..=179: n zonal coefficients each.
pub fn cap_log_table(order: usize) -> Vec<Vec<f64>> {
    rows(CAP_LOG_TABLE, &[&order.to_string()])
}

/// Coefficients of a and b of the optimal linear exponential for small norms, powers of ‖f̂‖, lowest first.
pub fn optimal_linear_coefficients(order: usize) -> Vec<Vec<f64>> {
    rows(OPTIMAL_LINEAR, &["small", &order.to_string()])
}

/// The same over the whole range: the norm that it ends at, and powers of ‖f̂‖ over that norm.
pub fn optimal_linear_wide(order: usize) -> (f64, Vec<Vec<f64>>) {
    let order = order.to_string();
    let range = rows(OPTIMAL_LINEAR, &["range", &order]);
    (range[0][0], rows(OPTIMAL_LINEAR, &["wide", &order]))
}

/// What the saturating exponential of an order is made of: the compression β and the gain of each band.
pub fn saturating(order: usize) -> (f64, Vec<f64>) {
    let row = &rows(SATURATING, &[&order.to_string()])[0];
    (row[0], row[1..].to_vec())
}

/// The compression β of `transfer`.
pub fn shading(order: usize) -> f64 {
    rows(SHADING, &["compression", &order.to_string()])[0][0]
}

/// `f_l(θ) = sin²θ · p_l(2 cos θ − 1)`: exactly 0 for θ = 0, and in proportion to the solid angle near it.
pub fn cap_log(g: &mut Graph, fitted_to: &str, order: usize, sin: Value, cos: Value) -> Vec<Value> {
    let square = g.mul(sin, sin);
    let coefficients = cap_log_coefficients(fitted_to, order);
    bands(g, &coefficients, &vec![square; order], cos)
}

/// Each band's factor times its polynomial.
fn bands(g: &mut Graph, coefficients: &[Vec<f64>], factors: &[Value], cos: Value) -> Vec<Value> {
    let two = g.constant(2.0);
    let minus_one = g.constant(-1.0);
    let u = g.mul_add(two, cos, minus_one);
    coefficients
        .iter()
        .zip(factors)
        .map(|(c, factor)| {
            let p = g.horner(c, u);
            g.mul(*factor, p)
        })
        .collect()
}

/// `f + zonal(cap_log(θ), d)`: what one blocker adds to a receiver's log visibility; `a` is f, sin θ, cos θ, d.
/// The factors that turn a zonal vector are multiplied into the fitted coefficients, and those of the basis stay
/// with the basis.
pub fn add_cap_log(g: &mut Graph, fitted_to: &str, order: usize, a: &[Vec<Value>]) -> Vec<Value> {
    let mut coefficients = cap_log_coefficients(fitted_to, order);
    for (l, band) in coefficients.iter_mut().enumerate() {
        for c in band {
            *c *= crate::basis::turn(l).to_f64();
        }
    }
    let square = g.mul(a[1][0], a[1][0]);
    let weights = bands(g, &coefficients, &vec![square; order], a[2][0]);
    let y = crate::basis::basis(g, order, &a[3]);
    (0..order * order)
        .map(|i| g.mul_add(weights[i.isqrt()], y[i], a[0][i]))
        .collect()
}

/// The sum of blockers on the scale of [`crate::basis::monic_basis`] plus one more, band l of it times `a[4][l]`; the
/// other arguments as in [`add_cap_log`].
pub fn accumulate(g: &mut Graph, fitted_to: &str, order: usize, a: &[Vec<Value>]) -> Vec<Value> {
    let square = g.mul(a[1][0], a[1][0]);
    let factors: Vec<_> = a[4].iter().map(|w| g.mul(*w, square)).collect();
    let coefficients = cap_log_coefficients(fitted_to, order);
    let weights = bands(g, &coefficients, &factors, a[2][0]);
    let y = crate::basis::monic_basis(g, order, &a[3]);
    (0..order * order)
        .map(|i| g.mul_add(weights[i.isqrt()], y[i], a[0][i]))
        .collect()
}

/// What [`accumulate`] leaves out: a factor for each coefficient.
pub fn accumulation_factors(order: usize) -> Vec<f64> {
    let leading = crate::basis::factors(order).into_iter().enumerate();
    leading
        .map(|(i, factor)| factor * crate::basis::turn(i.isqrt()).to_f64())
        .collect()
}

/// What is seen of a ball: for each band from 1 on, the polynomials P and Q in cos θ, lowest power first.
pub fn ball() -> Vec<[Vec<f64>; 2]> {
    let polynomial = |name: &str, band: usize| {
        let mut found = rows(BALL, &[name, &band.to_string()]);
        found.pop()
    };
    (1..)
        .map_while(|band| Some([polynomial("P", band)?, polynomial("Q", band)?]))
        .collect()
}

/// Band l of the basis at `d` times `p_l(θ) = 1 + cos θ (P(cos θ) + sin θ Q(cos θ))`.
pub fn ball_average(
    g: &mut Graph,
    order: usize,
    sin: Value,
    cos: Value,
    d: &[Value],
) -> Vec<Value> {
    let one = g.constant(1.0);
    let mut means = vec![one];
    for [p, q] in ball().iter().take(order - 1) {
        let (p, q) = (g.horner(p, cos), g.horner(q, cos));
        let sum = g.mul_add(sin, q, p);
        means.push(g.mul_add(cos, sum, one));
    }
    let y = crate::basis::basis(g, order, d);
    y.iter()
        .enumerate()
        .map(|(i, y)| g.mul(means[i.isqrt()], *y))
        .collect()
}

/// The common part of two discs: for the powers 1 and 2 of t, a polynomial in the ratio of their radii; that of power 3 is
/// what is left to 1.
pub fn lens() -> [Vec<f64>; 2] {
    ["1", "2"].map(|power| {
        let mut found = rows(LENS, &[power]);
        found.pop().expect("lens.txt has both powers")
    })
}

/// The sphere that the horizon cuts: for the powers 0, 1 and 2 of the square of its sine, polynomials in u, lowest power
/// first; and the numbers a, b and c of the divisor.
pub fn horizon() -> ([Vec<f64>; 3], [f64; 3]) {
    let row = |name: &str| {
        let mut found = rows(HORIZON, &[name]);
        found.pop().expect("horizon.txt has all powers")
    };
    let divisor = row("divisor");
    (
        ["0", "1", "2"].map(row),
        [divisor[0], divisor[1], divisor[2]],
    )
}

/// The largest u: a sphere that touches the plane from above, seen from where it does, leaves a divisor. In single precision
/// it is the same number.
const LARGEST_U: f64 = 1.0 - f32::EPSILON as f64;

/// The radius of the sphere that touches the horizon below a sphere's centre and hides as much as the part of that above it,
/// over the sphere's own: u (1 + (1 − u)(p_0(u) + x p_1(u) + x² p_2(u)) / ((1 − x)(1 + a u) + (1 − u)(b + c u))), with
/// u = (1 + w)/2 from the height w of its centre over its radius, held in −1..1, and x the square of the sine of its angular
/// radius. The divisor is what a receiver next to the sphere needs: how much it sees depends on 1 − u over 1 − x there.
pub fn horizon_radius(g: &mut Graph, height: Value, square: Value) -> Value {
    let (zero, half, one) = (g.constant(0.0), g.constant(0.5), g.constant(1.0));
    let share = g.mul_add(half, height, half);
    let share = g.max(share, zero);
    let largest = g.constant(LARGEST_U);
    let u = g.min(share, largest);
    let square = g.min(square, one);
    let (polynomials, [a, b, c]) = horizon();
    let [low, middle, high] = polynomials.map(|c| g.horner(&c, u));
    let sum = g.mul_add(square, high, middle);
    let sum = g.mul_add(square, sum, low);
    let rest = g.sub(one, u);
    let beside = g.sub(one, square);
    let (far, near) = (g.horner(&[1.0, a], u), g.horner(&[b, c], u));
    let near = g.mul(rest, near);
    let divisor = g.mul_add(beside, far, near);
    let sum = g.mul(rest, sum);
    let sum = g.div(sum, divisor);
    let radius = g.mul_add(u, sum, u);
    // Where it is nearly below, the polynomial may be.
    g.max(radius, zero)
}

/// Radii that are told apart from 0: their product is at least this.
const SMALLEST: f64 = 1e-12;

/// Which part of a disc of radius a is covered by one of radius b at the distance d: with q the smaller over the larger
/// radius, t = (a + b − d) / (2 min) held in 0..1, and f(t, q) the part of the smaller that is covered,
/// f min(1, b²/a²).
pub fn disc_covered(g: &mut Graph, a: Value, b: Value, d: Value) -> Value {
    let (zero, one, half) = (g.constant(0.0), g.constant(1.0), g.constant(0.5));
    let smallest = g.constant(SMALLEST);
    let product = g.mul(a, b);
    let product = g.max(product, smallest);
    let inverse = g.div(one, product);
    let (small, large) = (g.min(a, b), g.max(a, b));
    let square = g.mul(small, small);
    let q = g.mul(square, inverse);
    let sum = g.add(a, b);
    let inside = g.sub(sum, d);
    let t = g.mul(inside, large);
    let t = g.mul(t, inverse);
    let t = g.mul(t, half);
    let t = g.max(t, zero);
    let t = g.min(t, one);
    let [first, second] = lens().map(|c| g.horner(&c, q));
    let third = g.sub(one, first);
    let third = g.sub(third, second);
    let f = g.mul_add(third, t, second);
    let f = g.mul_add(f, t, first);
    let f = g.mul(f, t);
    // Short of touching the polynomial may be a little below 0.
    let f = g.max(f, zero);
    let squared = g.mul(b, b);
    let ratio = g.mul(squared, inverse);
    let ratio = g.mul(ratio, ratio);
    let ratio = g.min(ratio, one);
    g.mul(f, ratio)
}

/// `[a, b]` as polynomials in the norm.
pub fn optimal_linear(g: &mut Graph, order: usize, norm: Value) -> Vec<Value> {
    optimal_linear_coefficients(order)
        .iter()
        .map(|c| g.horner(c, norm))
        .collect()
}

/// `[a, b]` for any norm; beyond the range of the fit they stay as they are at its end.
pub fn optimal_linear_any(g: &mut Graph, order: usize, norm: Value) -> Vec<Value> {
    let (range, polynomials) = optimal_linear_wide(order);
    let end = g.constant(range);
    let inside = g.min(norm, end);
    let x = g.scale(1.0 / range, inside);
    polynomials.iter().map(|c| g.horner(c, x)).collect()
}
