//! The f64 truth of every generated routine, from the reference's recurrences and quadratures.

use sh_codegen::fits;
use sh_reference as reference;

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

fn cap_log(order: usize, sin: f64, cos: f64) -> Vec<f64> {
    fits::cap_log_coefficients(order)
        .iter()
        .map(|c| sin * sin * polynomial(c, 2.0 * cos - 1.0))
        .collect()
}

/// A rotation matrix's action on a vector, by quadrature like the quaternion's.
fn rotate_matrix(f: &[f64], m: &[f64]) -> Vec<f64> {
    let order = reference::basis::order_of(f.len());
    let back = |s: [f64; 3]| std::array::from_fn(|c| (0..3).map(|r| m[3 * r + c] * s[r]).sum());
    reference::quadrature::Rule::sphere(2 * (order - 1))
        .project(order, |s| reference::basis::evaluate(f, back(s)))
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
        "cap_log" => cap_log(order, a[0][0], a[1][0]),
        "add_cap_log" => {
            let zonal = cap_log(order, a[1][0], a[2][0]);
            let turned = reference::zonal::rotated(&zonal, three(&a[3]));
            a[0].iter().zip(turned).map(|(f, t)| f + t).collect()
        }
        "optimal_linear" => fits::optimal_linear_coefficients(order)
            .iter()
            .map(|c| polynomial(c, a[0][0]))
            .collect(),
        _ => return None,
    })
}
