//! Traits of other crates for the vector types, each behind its feature.

#[cfg(feature = "bytemuck")]
#[expect(
    unsafe_code,
    reason = "bytemuck's marker traits; its derive cannot see through a const generic"
)]
mod pod {
    use crate::{Sh, ShRgb};
    use bytemuck::{Pod, Zeroable};

    // SAFETY: `Sh` is transparent over `[L; C]`, which is `Zeroable`/`Pod` where `L` is.
    unsafe impl<L: Zeroable, const C: usize> Zeroable for Sh<L, C> {}
    // SAFETY: as above.
    unsafe impl<L: Pod, const C: usize> Pod for Sh<L, C> {}
    // SAFETY: three `Sh` of equal type in declaration order, no padding between arrays of one element type.
    unsafe impl<L: Zeroable, const C: usize> Zeroable for ShRgb<L, C> {}
    // SAFETY: as above.
    unsafe impl<L: Pod, const C: usize> Pod for ShRgb<L, C> {}

    macro_rules! stored {
        ($($type:ty)*) => { $(
            // SAFETY: one array of f32 or u32, of a size that its alignment divides: any bits are a value.
            unsafe impl Zeroable for $type {}
            // SAFETY: as above; no padding.
            unsafe impl Pod for $type {}
        )* };
    }
    stored!(crate::storage::Rgb2 crate::storage::Rgb3);
    #[cfg(feature = "half")]
    stored!(crate::storage::HalfRgb2 crate::storage::HalfRgb3);
}

#[cfg(feature = "approx")]
mod approximate {
    use crate::Sh;
    use approx::{AbsDiffEq, RelativeEq};

    impl<L: AbsDiffEq, const C: usize> AbsDiffEq for Sh<L, C>
    where
        L::Epsilon: Copy,
    {
        type Epsilon = L::Epsilon;
        fn default_epsilon() -> L::Epsilon {
            L::default_epsilon()
        }
        fn abs_diff_eq(&self, other: &Self, epsilon: L::Epsilon) -> bool {
            self.0
                .iter()
                .zip(&other.0)
                .all(|(a, b)| a.abs_diff_eq(b, epsilon))
        }
    }

    impl<L: RelativeEq, const C: usize> RelativeEq for Sh<L, C>
    where
        L::Epsilon: Copy,
    {
        fn default_max_relative() -> L::Epsilon {
            L::default_max_relative()
        }
        fn relative_eq(&self, other: &Self, epsilon: L::Epsilon, max_relative: L::Epsilon) -> bool {
            self.0
                .iter()
                .zip(&other.0)
                .all(|(a, b)| a.relative_eq(b, epsilon, max_relative))
        }
    }
}

#[cfg(feature = "glam")]
mod rotations {
    use crate::{Routines, Sh};
    use glam::Mat3;

    impl<const C: usize> Sh<f32, C>
    where
        [f32; C]: Routines<f32>,
    {
        /// Rotated by a glam matrix (feature `glam`). Directions and quaternions need no adapter: wherever
        /// three or four numbers are asked for, a `Vec3` or a `Quat` will do.
        ///
        /// ```
        /// use glam::{Mat3, Quat, Vec3};
        /// use sh_core::Sh4;
        /// let q = Quat::from_rotation_z(1.0);
        /// let turned = Sh4::basis(Vec3::X).rotate(q);
        /// assert!((turned - Sh4::basis(q * Vec3::X)).norm() < 1e-5);
        /// assert!((turned - Sh4::basis(Vec3::X).rotate_mat3(Mat3::from_quat(q))).norm() < 1e-5);
        /// ```
        pub fn rotate_mat3(&self, m: Mat3) -> Self {
            self.rotate_matrix(m.transpose().to_cols_array())
        }
    }
}

#[cfg(feature = "mint")]
mod interchange {
    use crate::{Lane, Routines, Sh};
    use mint::RowMatrix3;

    impl<L: Lane, const C: usize> Sh<L, C>
    where
        [L; C]: Routines<L>,
    {
        /// Rotated by a mint matrix (feature `mint`), by rows or by columns, and so by the matrix of any library
        /// that speaks mint. Directions and quaternions need no adapter: wherever three or four numbers are asked
        /// for, a `Vector3`, a `Point3` or a `Quaternion` will do. See [`Routines::rotate_matrix`].
        ///
        /// ```
        /// use mint::{ColumnMatrix3, Quaternion, RowMatrix3, Vector3};
        /// use sh_core::Sh4;
        /// let right = Vector3::from([1.0, 0.0, 0.0]);
        /// let f = Sh4::basis(right);
        /// // 90 degrees about z send x to y.
        /// let rows = RowMatrix3::from([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
        /// let half = std::f32::consts::FRAC_1_SQRT_2;
        /// let turn = Quaternion { v: Vector3::from([0.0, 0.0, half]), s: half };
        /// let up = Sh4::basis([0.0, 1.0, 0.0]);
        /// assert!((f.rotate_mint(rows) - up).norm() < 1e-5);
        /// assert!((f.rotate_mint(ColumnMatrix3::from(rows)) - up).norm() < 1e-5);
        /// assert!((f.rotate(turn) - up).norm() < 1e-5);
        /// ```
        pub fn rotate_mint(&self, m: impl Into<RowMatrix3<L>>) -> Self {
            self.rotate_matrix(m.into().into())
        }
    }
}
