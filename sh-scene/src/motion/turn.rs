//! The rotation in a matrix.

use glam::{DMat3, DQuat};

/// The rotation R that is nearest to a matrix in the least squares' sense: of the greatest trace of Rᵀ m. Where the
/// matrix stretches that is the rotation of its polar decomposition; one that flattens or mirrors has one too. Of a
/// matrix from which no rotation is nearest, such as zero, it is the identity.
///
/// As a quaternion it is the eigenvector of the largest eigenvalue of a symmetric 4×4 matrix (Davenport 1968; Horn
/// 1987, "Closed-form solution of absolute orientation using unit quaternions"), found by Jacobi's rotations.
pub(super) fn rotation(m: DMat3) -> DQuat {
    let ([xx, yx, zx], [xy, yy, zy], [xz, yz, zz]) = (
        m.x_axis.to_array(),
        m.y_axis.to_array(),
        m.z_axis.to_array(),
    );
    let mut a = [
        [xx - yy - zz, xy + yx, xz + zx, zy - yz],
        [xy + yx, yy - xx - zz, yz + zy, xz - zx],
        [xz + zx, yz + zy, zz - xx - yy, yx - xy],
        [zy - yz, xz - zx, yx - xy, xx + yy + zz],
    ];

    let size = a
        .as_flattened()
        .iter()
        .fold(0.0, |most: f64, c| most.max(c.abs()));
    if !(size > 0.0 && size.is_finite()) {
        return DQuat::IDENTITY;
    }
    let mut vectors = [[0.0; 4]; 4];
    for (i, vector) in vectors.iter_mut().enumerate() {
        vector[i] = 1.0;
    }
    // Each sweep squares what is left beside the diagonal: six are more than enough for four rows.
    for _ in 0..8 {
        for (p, q) in [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)] {
            clear(&mut a, &mut vectors, p, q, 1e-18 * size);
        }
    }
    let largest = (0..4).fold(3, |best, i| if a[i][i] > a[best][best] { i } else { best });
    let second = (0..4).filter(|i| *i != largest).map(|i| a[i][i]);
    if a[largest][largest] - second.fold(f64::NEG_INFINITY, f64::max) <= 1e-9 * size {
        return DQuat::IDENTITY;
    }
    let [x, y, z, w] = vectors.map(|row| row[largest]);
    let turn = DQuat::from_xyzw(x, y, z, w).normalize();
    if w < 0.0 { -turn } else { turn }
}

/// Turns rows and columns p and q of a symmetric matrix, so that what couples them becomes 0, and the vectors with them
/// (Golub and Van Loan, "Matrix Computations", section 8.5).
fn clear(a: &mut [[f64; 4]; 4], vectors: &mut [[f64; 4]; 4], p: usize, q: usize, least: f64) {
    if a[p][q].abs() <= least {
        return;
    }
    let ratio = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
    let tangent = ratio.signum() / (ratio.abs() + ratio.hypot(1.0));
    let cosine = 1.0 / tangent.hypot(1.0);
    let sine = tangent * cosine;
    let turn = |row: &mut [f64; 4]| {
        (row[p], row[q]) = (
            cosine * row[p] - sine * row[q],
            sine * row[p] + cosine * row[q],
        );
    };
    a.iter_mut().for_each(turn);
    let (row, other) = (a[p], a[q]);
    a[p] = std::array::from_fn(|k| cosine * row[k] - sine * other[k]);
    a[q] = std::array::from_fn(|k| sine * row[k] + cosine * other[k]);
    vectors.iter_mut().for_each(turn);
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    fn turns() -> impl Iterator<Item = DQuat> {
        (0..200).map(|k| {
            let k = f64::from(k);
            let axis = DVec3::new((k * 1.3).sin(), (k * 0.7).cos(), (k * 2.1).sin() + 0.1);
            DQuat::from_axis_angle(axis.normalize(), k * 0.0157)
        })
    }

    #[test]
    fn a_stretched_rotation_is_found_whatever_it_is_stretched_by() {
        let stretch = DMat3::from_cols(
            DVec3::new(2.0, 0.3, 0.0),
            DVec3::new(0.3, 0.7, -0.1),
            DVec3::new(0.0, -0.1, 1.0),
        );
        for q in turns() {
            for m in [DMat3::IDENTITY, stretch, stretch * 1e-6, stretch * 1e9] {
                let found = rotation(DMat3::from_quat(q) * m);
                assert!(found.dot(q).abs() > 1.0 - 1e-12, "{q} {found}");
                assert!(found.w >= 0.0 && found.is_normalized());
            }
        }
    }

    #[test]
    fn half_turns_are_found() {
        for axis in [DVec3::X, DVec3::Y, DVec3::Z, DVec3::new(0.6, 0.0, 0.8)] {
            let q = DQuat::from_axis_angle(axis, std::f64::consts::PI);
            assert!(rotation(DMat3::from_quat(q)).dot(q).abs() > 1.0 - 1e-12);
        }
    }

    #[test]
    fn what_flattens_or_mirrors_has_the_nearest_rotation() {
        for q in turns() {
            for scale in [DVec3::new(1.0, 0.5, 0.0), DVec3::new(1.0, 0.8, -0.3)] {
                let found = rotation(DMat3::from_quat(q) * DMat3::from_diagonal(scale));
                assert!(found.dot(q).abs() > 1.0 - 1e-12, "{q} {found}");
            }
        }
    }

    #[test]
    fn where_no_rotation_is_nearest_nothing_turns() {
        let line = DMat3::from_diagonal(DVec3::X);
        for m in [
            DMat3::ZERO,
            -DMat3::IDENTITY,
            line,
            DMat3::IDENTITY * f64::NAN,
        ] {
            assert_eq!(rotation(m), DQuat::IDENTITY);
        }
    }
}
