//! The f64 truth of every generated routine, from the reference's recurrences, quadratures and sampling rules. A fitted
//! function is its documentation's formula with the numbers of its data file ([`data`]); how near it is to what it was
//! fitted to is `tests/tests/fitted.rs`. Nothing here calls the generator.

use crate::data;
use sh_reference as reference;
use std::collections::BTreeMap;
use std::sync::LazyLock;

fn three(v: &[f64]) -> [f64; 3] {
    v.try_into().expect("a direction")
}

fn four(v: &[f64]) -> [f64; 4] {
    v.try_into().expect("a quaternion")
}

/// Polynomials, lowest power first.
fn polynomial(c: &[f64], x: f64) -> f64 {
    c.iter()
        .enumerate()
        .map(|(k, c)| c * x.powi(k as i32))
        .sum()
}

fn cap_log(fitted_to: &str, order: usize, sin: f64, cos: f64) -> Vec<f64> {
    data::cap_log(fitted_to, order)
        .iter()
        .map(|c| sin * sin * polynomial(c, 2.0 * cos - 1.0))
        .collect()
}

fn add_cap_log(fitted_to: &str, order: usize, a: &[Vec<f64>]) -> Vec<f64> {
    let zonal = cap_log(fitted_to, order, a[1][0], a[2][0]);
    let turned = reference::zonal::rotated(&zonal, three(&a[3]));
    a[0].iter().zip(turned).map(|(f, t)| f + t).collect()
}

/// The column of [`data::points`] that routines take unless their name says otherwise.
const MEDIUM: usize = 1;

/// The points and weights of an order's rule: solved once.
fn rule(order: usize, fineness: usize) -> &'static [([f64; 3], f64)] {
    type Rule = Vec<([f64; 3], f64)>;
    static RULES: LazyLock<BTreeMap<usize, Rule>> = LazyLock::new(|| {
        let all = (2..=6).flat_map(|order| [0, 1, 2].map(|fineness| data::points(order, fineness)));
        all.map(|count| (count, reference::octahedral::points(count)))
            .collect()
    });
    &RULES[&data::points(order, fineness)]
}

/// Samples of f on a rule, a function of each, projected back.
fn pointwise(order: usize, fineness: usize, f: &[f64], h: impl Fn(f64) -> f64) -> Vec<f64> {
    let mut sum = vec![0.0; order * order];
    for &(point, weight) in rule(order, fineness) {
        let value = h(reference::basis::evaluate(f, point));
        for (sum, y) in sum.iter_mut().zip(reference::basis::basis(order, point)) {
            *sum += weight * value * y;
        }
    }
    sum
}

/// The saturating exponential as its documentation defines it.
fn saturating(order: usize, f: &[f64]) -> Vec<f64> {
    let row = data::SATURATING.row(&order.to_string());
    let (beta, gains) = (row[0], &row[1..]);
    let rest: f64 = f[1..].iter().map(|f| f * f).sum();
    let root = (1.0 + beta * rest / (4.0 * std::f64::consts::PI)).sqrt();
    let x: Vec<f64> = f.iter().map(|f| f / root).collect();
    let mut g = pointwise(order, MEDIUM, &x, |x| {
        let t = x.clamp(-1.0, 0.2);
        ((1.0 + t) * (1.0 - t / 4.0)).powi(2)
    });
    for (i, g) in g.iter_mut().enumerate() {
        *g *= gains[i.isqrt()];
    }
    g
}

/// The transfer as its documentation defines it: samples of f on a rule, the shading exponential of each, times the lobe.
fn transfer(order: usize, f: &[f64], lobe: &[f64]) -> Vec<f64> {
    let rest: f64 = f[1..].iter().map(|f| f * f).sum();
    let beta = data::SHADING.row(&format!("compression {order}"))[0];
    let root = (1.0 + beta * rest / (4.0 * std::f64::consts::PI)).sqrt();
    let x: Vec<f64> = f.iter().map(|f| f / root).collect();
    let mut sum = vec![0.0; order * order];
    for &(point, weight) in rule(order, MEDIUM) {
        let t = reference::basis::evaluate(&x, point).clamp(-4.0, 0.5);
        let value = (1.0 + t / 4.0).powi(4) * reference::basis::evaluate(lobe, point);
        for (sum, y) in sum.iter_mut().zip(reference::basis::basis(order, point)) {
            *sum += weight * value * y;
        }
    }
    sum
}

/// One of the numbers of a polished surface's lobe, of its roughness and a cosine.
fn gloss(name: &str, a: &[Vec<f64>]) -> f64 {
    let [x, y] = [0, 1].map(|i| 2.0 * a[i][0].clamp(0.0, 1.0) - 1.0);
    let powers = (0..5).map(|power| data::GLOSS.row(&format!("{name} {power}")));
    let terms = powers
        .enumerate()
        .map(|(i, row)| polynomial(&row, y) * x.powi(i as i32));
    terms.sum()
}

/// A rotation matrix's action on a vector, by quadrature like the quaternion's.
fn rotate_matrix(f: &[f64], m: &[f64]) -> Vec<f64> {
    let order = reference::basis::order_of(f.len());
    let back = |s: [f64; 3]| std::array::from_fn(|c| (0..3).map(|r| m[3 * r + c] * s[r]).sum());
    reference::quadrature::Rule::sphere(2 * (order - 1))
        .project(order, |s| reference::basis::evaluate(f, back(s)))
}

/// The clamped exponential of one sample.
fn clamped(x: f64) -> f64 {
    x.min(0.15).exp()
}

/// What the routine should return for these arguments, or `None` for a routine nobody has written the truth
/// of.
pub fn truth(routine: &str, order: usize, a: &[Vec<f64>]) -> Option<Vec<f64>> {
    let product = |f: &[f64], g: &[f64]| reference::product::product(f, g);
    let dot = |f: &[f64], g: &[f64]| reference::basis::dot(f, g);
    let triangle = |i: usize| (0..=i).map(move |j| (i, j));
    Some(match routine {
        "basis" => reference::basis::basis(order, three(&a[0])),
        "cosine" => reference::zonal::cosine(order, three(&a[0])),
        "zonal" => reference::zonal::rotated(&a[0], three(&a[1])),
        "product" => product(&a[0], &a[1]),
        "square" => product(&a[0], &a[0]),
        "product_cosine" => product(&a[0], &reference::zonal::cosine(order, three(&a[1]))),
        "triple" => vec![dot(&product(&a[0], &a[1]), &a[2])],
        "dot" => vec![dot(&a[0], &a[1])],
        "product_matrix" => {
            let columns: Vec<_> = (0..order * order)
                .map(|j| {
                    let mut unit = vec![0.0; order * order];
                    unit[j] = 1.0;
                    product(&a[0], &unit)
                })
                .collect();
            (0..order * order)
                .flat_map(triangle)
                .map(|(i, j)| columns[j][i])
                .collect()
        }
        "matrix_apply" => {
            let mut out = vec![0.0; order * order];
            for ((i, j), m) in (0..order * order).flat_map(triangle).zip(&a[0]) {
                out[i] += m * a[1][j];
                if i != j {
                    out[j] += m * a[1][i];
                }
            }
            out
        }
        "rotate" => reference::rotation::rotate(&a[0], four(&a[1])),
        "rotate_matrix" => rotate_matrix(&a[0], &a[1]),
        "window" => reference::zonal::window(&a[0], a[1][0]),
        "cap_visibility" => reference::cap::visibility(order, a[1][0].atan2(a[0][0])),
        "cap_log" => cap_log("eigen", order, a[0][0], a[1][0]),
        "cap_log_shading" => cap_log("shading", order, a[0][0], a[1][0]),
        "cap_log_saturating" => cap_log("saturating", order, a[0][0], a[1][0]),
        "add_cap_log" => add_cap_log("eigen", order, a),
        "add_cap_log_saturating" => add_cap_log("saturating", order, a),
        "accumulate_blocker" | "accumulate_blocker_saturating" => {
            let fit = match routine {
                "accumulate_blocker" => "shading",
                _ => "saturating",
            };
            let mut zonal = cap_log(fit, order, a[1][0], a[2][0]);
            for (z, w) in zonal.iter_mut().zip(&a[4]) {
                *z *= w;
            }
            let turned = reference::zonal::rotated(&zonal, three(&a[3]));
            let scale = (0..).map(data::accumulation_factor);
            a[0].iter()
                .zip(turned.iter().zip(scale))
                .map(|(f, (t, scale))| f + t / scale)
                .collect()
        }
        "accumulated_log" => {
            let scale = (0..).map(data::accumulation_factor);
            a[0].iter().zip(scale).map(|(f, scale)| f * scale).collect()
        }
        "ball_average" => {
            let (sin, cos) = (a[0][0], a[1][0]);
            let mean = |l: usize| match l {
                0 => 1.0,
                l => {
                    let [p, q] = ["P", "Q"].map(|name| data::BALL.row(&format!("{name} {l}")));
                    1.0 + cos * (polynomial(&p, cos) + sin * polynomial(&q, cos))
                }
            };
            let basis = reference::basis::basis(order, three(&a[2]));
            let weighted = basis.iter().enumerate();
            weighted.map(|(i, y)| mean(i.isqrt()) * y).collect()
        }
        "disc_covered" => {
            let [a, b, d] = [a[0][0], a[1][0], a[2][0]];
            let (small, large) = (a.min(b), a.max(b));
            let t = ((a + b - d) / (2.0 * small)).clamp(0.0, 1.0);
            let [first, second] =
                ["1", "2"].map(|power| polynomial(&data::LENS.row(power), small / large));
            let f = t * (first + t * (second + t * (1.0 - first - second)));
            vec![f.max(0.0) * (b / a).powi(2).min(1.0)]
        }
        "transfer" => {
            let lobe = reference::zonal::cosine(2 * order - 1, three(&a[1]));
            transfer(order, &a[0], &lobe)
        }
        "transfer_lobe" => {
            let y = reference::basis::basis(order, three(&a[1]));
            let bands = (0..order).flat_map(|l| vec![a[2][l].clamp(-1.0, 1.0); 2 * l + 1]);
            let lobe: Vec<f64> = y.iter().zip(bands).map(|(y, w)| y * w).collect();
            transfer(order, &a[0], &lobe)
        }
        "gloss_lobe" => {
            let bands = (1..order).map(|l| gloss(&format!("band {l}"), a).min(1.0));
            std::iter::once(1.0).chain(bands).collect()
        }
        "gloss_told" => vec![
            a[0][0]
                .max([1.0, 0.88, 0.72, 0.6, 0.59][order - 2])
                .min(1.0),
        ],
        "gloss_tilt" => vec![gloss("tilt", a).clamp(0.0, 1.0)],
        "gloss_energy" => {
            let energy = gloss("energy", a).clamp(0.25, 1.0);
            vec![energy, gloss("grazing", a).clamp(0.0, energy)]
        }
        "horizon_radius" => {
            // A sphere that touches from above, seen from where it does, is as any next to it.
            let u = (0.5 + 0.5 * a[0][0]).clamp(0.0, 1.0 - f64::from(f32::EPSILON));
            let (rest, x) = (1.0 - u, a[1][0].min(1.0));
            let [low, middle, high] =
                ["0", "1", "2"].map(|power| polynomial(&data::HORIZON.row(power), u));
            let divisor = data::HORIZON.row("divisor");
            let [a, b, c] = divisor[..].try_into().expect("three numbers");
            let sum = low + x * middle + x * x * high;
            let below = (1.0 - x) * (1.0 + a * u) + rest * (b + c * u);
            vec![(u * (1.0 + rest * sum / below)).max(0.0)]
        }
        "exp_saturating" => saturating(order, &a[0]),
        "exp_sampled" => pointwise(order, MEDIUM, &a[0], clamped),
        "exp_sampled_coarse" => pointwise(order, 0, &a[0], clamped),
        "exp_sampled_fine" => pointwise(order, 2, &a[0], clamped),
        "optimal_linear" => data::OPTIMAL_LINEAR
            .rows(&format!("small {order}"))
            .iter()
            .map(|c| polynomial(c, a[0][0]))
            .collect(),
        "optimal_linear_wide" => {
            let range = data::OPTIMAL_LINEAR.row(&format!("range {order}"))[0];
            let polynomials = data::OPTIMAL_LINEAR.rows(&format!("wide {order}"));
            let x = a[0][0].min(range) / range;
            polynomials.iter().map(|c| polynomial(c, x)).collect()
        }
        _ => return None,
    })
}
