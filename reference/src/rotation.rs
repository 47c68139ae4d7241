//! Rotation of an SH vector, by sampling the rotated function and projecting it.
//!
//! Active: (Rf)(s) = f(R⁻¹ s), so a function that peaks at d peaks at R d afterwards. Rotation keeps bands
//! apart, so order n stays order n and a rule of degree 2(n−1) is exact.

use crate::basis::{evaluate, order_of};
use crate::quadrature::Rule;
use crate::vec3::{Vec3, add, cross, scale};

/// The vector `v` turned by a quaternion `[x, y, z, w]`, which is normalised first (so that one rounded to
/// f32 still is a rotation).
///
/// ```
/// use sh_reference::rotation::turn;
/// let quarter = std::f64::consts::FRAC_1_SQRT_2;
/// let turned = turn([0.0, 0.0, quarter, quarter], [1.0, 0.0, 0.0]);
/// assert!((turned[1] - 1.0).abs() < 1e-15);
/// ```
///
/// # Panics
/// If the quaternion is 0 or not finite.
pub fn turn(quaternion: [f64; 4], v: [f64; 3]) -> [f64; 3] {
    let length = quaternion.iter().map(|c| c * c).sum::<f64>().sqrt();
    assert!(
        length > 0.0 && length.is_finite(),
        "{quaternion:?} is no rotation"
    );
    let [x, y, z, w] = quaternion.map(|c| c / length);
    let axis: Vec3 = [x, y, z];
    // v + 2 w (a × v) + 2 a × (a × v).
    let once = cross(axis, v);
    add(v, scale(add(scale(once, w), cross(axis, once)), 2.0))
}

/// The rotation that undoes `quaternion`.
pub fn inverse([x, y, z, w]: [f64; 4]) -> [f64; 4] {
    [-x, -y, -z, w]
}

/// The quaternion of a turn by `angle` (radians, right-handed) about the unit vector `axis`.
pub fn about(axis: [f64; 3], angle: f64) -> [f64; 4] {
    let (sin, cos) = (0.5 * angle).sin_cos();
    let [x, y, z] = scale(axis, sin);
    [x, y, z, cos]
}

/// The rotated SH vector. Error some 1e-14·|f|.
///
/// ```
/// use sh_reference::{basis::basis, rotation::*};
/// let q = about([0.0, 1.0, 0.0], 0.5);
/// let rotated = rotate(&basis(4, [0.0, 0.0, 1.0]), q);
/// let expected = basis(4, turn(q, [0.0, 0.0, 1.0]));
/// assert!(rotated.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-14));
/// ```
pub fn rotate(f: &[f64], quaternion: [f64; 4]) -> Vec<f64> {
    let order = order_of(f.len());
    let back = inverse(quaternion);
    Rule::sphere(2 * (order - 1)).project(order, |s| evaluate(f, turn(back, s)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::basis::{basis, norm};
    use crate::testing::{assert_close, directions, numbers};
    use crate::vec3::normalize;
    use std::f64::consts::FRAC_PI_2;

    fn quaternions() -> Vec<[f64; 4]> {
        (0..8)
            .map(|i| about(directions(8)[i], 0.7 * i as f64 - 2.0))
            .collect()
    }

    #[test]
    fn quarter_turns_go_the_right_way_round() {
        let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert_close(&turn(about(x, FRAC_PI_2), y), &z, 1e-15);
        assert_close(&turn(about(y, FRAC_PI_2), z), &x, 1e-15);
        assert_close(&turn(about(z, FRAC_PI_2), x), &y, 1e-15);
    }

    #[test]
    fn the_first_band_turns_as_a_vector() {
        for q in quaternions() {
            let v = [0.3, -1.2, 0.7];
            // y_1 is (y, z, x).
            let [x, y, z] = turn(q, v);
            assert_close(&rotate(&[0.4, v[1], v[2], v[0]], q), &[0.4, y, z, x], 1e-14);
        }
    }

    #[test]
    fn a_peak_goes_where_it_is_turned() {
        for q in quaternions() {
            for d in directions(5) {
                assert_close(&rotate(&basis(6, d), q), &basis(6, turn(q, d)), 1e-13);
            }
        }
    }

    #[test]
    fn there_and_back() {
        for q in quaternions() {
            for order in [1, 3, 6, 9] {
                let f = numbers(7, order * order);
                let rotated = rotate(&f, q);
                assert!((norm(&rotated) - norm(&f)).abs() < 1e-13);
                assert_close(&rotate(&rotated, inverse(q)), &f, 1e-13);
            }
        }
    }

    #[test]
    fn length_of_the_quaternion_does_not_matter() {
        let f = numbers(8, 16);
        let q = about(normalize([1.0, 2.0, 3.0]), 1.0);
        assert_close(&rotate(&f, q.map(|c| 3.0 * c)), &rotate(&f, q), 1e-14);
    }
}
