//! Projection of equirectangular environment maps.
//!
//! A map of `width` × `height` texels covers the sphere, +Y up: row edges are circles of polar angle
//! θ = π v from +Y, column edges meridians φ = 2π (u − ½), and (u, v) sees the direction
//!
//! ```text
//! (sin θ sin φ, cos θ, −sin θ cos φ)          the picture's centre is −Z, its right half +X
//! ```
//!
//! Texels are constant over their area, and the basis is integrated over that area: along a row in closed
//! form, across it by quadrature good to 1e-12. So a map of any size, down to one texel, has the coefficients
//! of exactly the function it stands for, and the solid angles add up to 4π.

use crate::{Routines, Sh, ShRgb, real};
use core::f64::consts::PI;

/// Gauss–Legendre nodes and weights, 5 points on −1..1: exact to degree 9.
const GAUSS: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];

/// The SH vectors of a map whose texel in column `x` (from the left) and row `y` (from the top) is
/// `texel(x, y)`. An empty map projects to zero.
///
/// ```
/// let gray = sh_core::project::equirectangular::<9>(7, 3, |_, _| [0.25; 3]);
/// assert!((gray.evaluate([0.0, 0.6, 0.8])[1] - 0.25).abs() < 1e-12);
/// ```
pub fn equirectangular<const C: usize>(
    width: usize,
    height: usize,
    mut texel: impl FnMut(usize, usize) -> [f32; 3],
) -> ShRgb<f64, C>
where
    [f64; C]: Routines<f64>,
{
    let order = <[f64; C]>::ORDER;
    let mut sums = [[0.0; C]; 3];
    for y in 0..height {
        let across = row_integrals::<C>(y, height);
        // Σ over the row of texel · ∫ cos mψ, ∫ sin mψ over the texel: 6 bands at most.
        let mut along = [[[0.0; 2]; 6]; 3];
        for x in 0..width {
            let value = texel(x, y);
            for (m, integral) in column_integrals(x, width).iter().enumerate().take(order) {
                for (sum, v) in along.iter_mut().zip(value) {
                    sum[m][0] += f64::from(v) * integral[0];
                    sum[m][1] += f64::from(v) * integral[1];
                }
            }
        }
        for (sum, along) in sums.iter_mut().zip(along) {
            for l in 0..order {
                let middle = l * l + l;
                sum[middle] += across[middle] * along[0][0];
                for m in 1..=l {
                    sum[middle + m] += across[middle + m] * along[m][0];
                    sum[middle - m] += across[middle + m] * along[m][1];
                }
            }
        }
    }
    // So far the polar axis was ẑ and the azimuth ψ = −φ: turn x̂ to −Z, ŷ to −X and ẑ to +Y.
    let [r, g, b] =
        sums.map(|f| Sh(f.rotate_matrix([0.0, -1.0, 0.0, 0.0, 0.0, 1.0, -1.0, 0.0, 0.0])));
    ShRgb { r, g, b }
}

/// ∫ y_lm sin θ dθ over a row at ψ = 0, for m ≥ 0.
fn row_integrals<const C: usize>(y: usize, height: usize) -> [f64; C]
where
    [f64; C]: Routines<f64>,
{
    let mut out = [0.0; C];
    // 5 points per π/16 integrate trigonometric polynomials of degree 6 to 1e-12.
    let parts = 16_usize.div_ceil(height);
    let step = PI / (height * parts) as f64;
    for part in 0..parts {
        let middle = ((y * parts + part) as f64 + 0.5) * step;
        for (node, weight) in GAUSS {
            let theta = middle + node * step / 2.0;
            let (sin, cos) = (real::sin(theta), real::cos(theta));
            let basis = <[f64; C]>::basis([sin, 0.0, cos]);
            for (sum, value) in out.iter_mut().zip(basis) {
                *sum += value * sin * weight * step / 2.0;
            }
        }
    }
    out
}

/// ∫ cos mψ dψ and ∫ sin mψ dψ over a column, ψ = −φ, for m = 0..6.
fn column_integrals(x: usize, width: usize) -> [[f64; 2]; 6] {
    let edge = |x: usize| {
        let psi = PI - 2.0 * PI * x as f64 / width as f64;
        [real::cos(psi), real::sin(psi)]
    };
    let (from, to) = (edge(x + 1), edge(x));
    let mut out = [[2.0 * PI / width as f64, 0.0]; 6];
    let (mut a, mut b) = ([1.0, 0.0], [1.0, 0.0]);
    let turn =
        |z: [f64; 2], by: [f64; 2]| [z[0] * by[0] - z[1] * by[1], z[0] * by[1] + z[1] * by[0]];
    for (m, integral) in out.iter_mut().enumerate().skip(1) {
        (a, b) = (turn(a, from), turn(b, to));
        *integral = [(b[1] - a[1]) / m as f64, (a[0] - b[0]) / m as f64];
    }
    out
}
