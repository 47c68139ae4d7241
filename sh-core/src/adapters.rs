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
