//! Windowing of visibility, which Ren et al. 2006, section 7, propose: why the shadow pass has none.

use sh_codegen::fits;
use sh_codegen::octahedral;
use sh_codegen::sampled::{Fineness, points};
use sh_core::Routines;
use sh_reference::basis::{basis, evaluate};
use sh_reference::quadrature::Rule;
use sh_reference::shaded::{Kind, Set, sets, transfer};
use sh_reference::zonal::{cosine, window};
use sh_tests::every_order;
use std::f64::consts::PI;

/// How much an error of each band counts: the size of a coefficient of half a sky of 0.35 over 0.1 all around and a spot of
/// 15 degrees that is 6 bright, over that of the mean.
const BANDS: [f64; 6] = [1.0, 0.36, 0.27, 0.27, 0.26, 0.25];

/// What the shadow pass's samples say of visibility, projected: (1 + x/4)^4 as `transfer` documents it.
fn visibility(order: usize, f: &[f64]) -> Vec<f64> {
    let rest: f64 = f[1..].iter().map(|f| f * f).sum();
    let root = (1.0 + fits::shading(order) * rest / (4.0 * PI)).sqrt();
    let mut g = vec![0.0; order * order];
    for (point, weight) in octahedral::points(points(order, Fineness::Medium)) {
        let x = (evaluate(f, point) / root).clamp(-4.0, 0.5);
        for (g, y) in g.iter_mut().zip(basis(order, point)) {
            *g += weight * (1.0 + x / 4.0).powi(4) * y;
        }
    }
    g
}

/// RMS of the transfer's error without a window of visibility, with one of width 4 n, and with the 2 n of the paper: visibility
/// is projected, windowed, and multiplied with the cosine lobe.
fn errors<const C: usize>(all: &[Set]) -> [f64; 3]
where
    [f64; C]: Routines<f64>,
{
    let order = <[f64; C]>::ORDER;
    let rule = Rule::sphere(4 * order);
    let mut squares = [0.0; 3];
    for set in all {
        let sum = set.caps.iter().fold([0.0; C], |sum, cap| {
            let weights = <[f64; C]>::zonal_from(|_| 1.0);
            sum.accumulate_blocker(cap.angle.sin(), cap.angle.cos(), cap.axis, weights)
        });
        let truth = transfer(order, set);
        let g = visibility(order, &sum.accumulated_log());
        let lobe = cosine(2 * order - 1, set.normal);
        for (squares, width) in squares.iter_mut().zip([f64::INFINITY, 4.0, 2.0]) {
            let g = if width.is_finite() {
                window(&g, width * order as f64)
            } else {
                g.clone()
            };
            let found = rule.project(order, |s| evaluate(&g, s) * evaluate(&lobe, s));
            for (i, (found, truth)) in found.iter().zip(&truth).enumerate() {
                *squares += ((found - truth) * BANDS[i.isqrt()]).powi(2);
            }
        }
    }
    squares.map(|sum| (sum / all.len() as f64).sqrt())
}

#[test]
fn windowed_visibility_is_farther_from_the_truth() {
    fn check<const C: usize>()
    where
        [f64; C]: Routines<f64>,
    {
        for kind in [Kind::Separate, Kind::Few, Kind::Large, Kind::Touching] {
            let order = <[f64; C]>::ORDER;
            let [none, wide, narrow] = errors::<C>(&sets(kind, 7, 60));
            println!("order {order}, {kind:?}: {none:.4}, {wide:.4}, {narrow:.4}");
            // At order 2 alone, where a shadow is little more than a direction, a window can gain.
            assert!(order == 2 || none < 1.03 * wide && 1.03 * none < narrow);
        }
    }
    every_order!(check);
}
