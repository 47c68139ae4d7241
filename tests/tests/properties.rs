//! Identities that hold for any input, at every order.

use proptest::prelude::*;
use sh_core::{ROOT_FOUR_PI, Routines};
use sh_reference::rotation;

/// The largest difference.
fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter()
        .zip(b)
        .fold(0.0, |worst, (a, b)| worst.max((a - b).abs()))
}

fn quaternion() -> impl Strategy<Value = [f64; 4]> {
    prop::array::uniform4(-1.0..1.0)
        .prop_filter("not near zero", |q: &[f64; 4]| {
            q.iter().map(|x| x * x).sum::<f64>() > 0.01
        })
        .prop_map(|q| {
            let length = q.iter().map(|x| x * x).sum::<f64>().sqrt();
            q.map(|x| x / length)
        })
}

macro_rules! at_order {
    ($name:ident, $c:literal) => {
        mod $name {
            use super::*;

            fn vector() -> impl Strategy<Value = [f64; $c]> {
                prop::collection::vec(-1.0..1.0, $c).prop_map(|v| v.try_into().expect("as many as asked"))
            }

            proptest! {
                #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

                #[test]
                fn product_commutes(f in vector(), g in vector()) {
                    prop_assert!(distance(&f.product(&g), &g.product(&f)) < 1e-13);
                }

                #[test]
                fn one_is_neutral(f in vector()) {
                    let mut one = [0.0; $c];
                    one[0] = ROOT_FOUR_PI;
                    prop_assert!(distance(&f.product(&one), &f) < 1e-13);
                }

                #[test]
                fn square_is_product_with_itself(f in vector()) {
                    prop_assert!(distance(&f.square(), &f.product(&f)) < 1e-13);
                }

                #[test]
                fn product_is_its_matrix(f in vector(), g in vector()) {
                    prop_assert!(distance(&<[f64; $c]>::matrix_apply(&f.product_matrix(), &g), &f.product(&g)) < 1e-12);
                }

                #[test]
                fn triple_is_symmetric(f in vector(), g in vector(), h in vector()) {
                    prop_assert!((f.triple(&g, &h) - h.triple(&f, &g)).abs() < 1e-12);
                    prop_assert!((f.triple(&g, &h) - f.product(&h).dot(&g)).abs() < 1e-12);
                }

                #[test]
                fn rotation_commutes_with_product(f in vector(), g in vector(), q in quaternion()) {
                    let late = f.product(&g).rotate(q);
                    prop_assert!(distance(&late, &f.rotate(q).product(&g.rotate(q))) < 1e-12);
                }

                #[test]
                fn rotation_keeps_the_norm_and_turns_back(f in vector(), q in quaternion()) {
                    let turned = f.rotate(q);
                    prop_assert!((turned.dot(&turned) - f.dot(&f)).abs() < 1e-12);
                    prop_assert!(distance(&turned.rotate([-q[0], -q[1], -q[2], q[3]]), &f) < 1e-13);
                }

                #[test]
                fn rotated_function_is_the_function_rotated(f in vector(), q in quaternion(), d in quaternion()) {
                    let length = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
                    prop_assume!(length > 0.1);
                    let d = [d[0] / length, d[1] / length, d[2] / length];
                    let at = |f: &[f64; $c], d: [f64; 3]| f.dot(&<[f64; $c]>::basis(d));
                    prop_assert!((at(&f.rotate(q), rotation::turn(q, d)) - at(&f, d)).abs() < 1e-12);
                }

                #[test]
                fn a_matrix_rotates_as_its_quaternion(f in vector(), q in quaternion()) {
                    prop_assert!(distance(&f.rotate_matrix(sh_tests::case::matrix(q)), &f.rotate(q)) < 1e-13);
                }
            }
        }
    };
}
at_order!(order_two, 4);
at_order!(order_three, 9);
at_order!(order_four, 16);
at_order!(order_five, 25);
at_order!(order_six, 36);

/// ∫ y_i y_j = δ_ij, by a rule that is exact for it.
#[test]
fn basis_is_orthonormal() {
    let rule = sh_reference::quadrature::Rule::sphere(10);
    for i in 0..36 {
        for j in 0..36 {
            let integral = rule.integrate(|d| {
                let y = <[f64; 36]>::basis(d);
                y[i] * y[j]
            });
            let want = if i == j { 1.0 } else { 0.0 };
            assert!((integral - want).abs() < 1e-13, "⟨{i}, {j}⟩ = {integral}");
        }
    }
}
