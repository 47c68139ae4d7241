//! The SH vector types: n² coefficients of one function, or of three colour channels.

use crate::{Lane, Routines, constants};
use core::ops::{Add, AddAssign, Index, IndexMut, Mul, Neg, Sub, SubAssign};

/// A spherical function of order n as its `C` = n² coefficients, index l·l + l + m.
///
/// A plain array with the operations of a vector space; everything particular to spherical harmonics comes
/// from [`Routines`], which the array inside implements.
///
/// ```
/// use sh_core::{Routines, Sh4};
/// let up = Sh4::basis([0.0, 0.0, 1.0]);
/// let f = up * 2.0 + Sh4::ONE;
/// assert!((f.evaluate([0.0, 0.0, 1.0]) - 1.0 - 2.0 * up.dot(&up)).abs() < 1e-5);
/// ```
#[repr(transparent)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sh<L, const C: usize>(pub [L; C]);

macro_rules! aliases {
    ($($name:ident: $t:ident, $c:literal, $order:literal, $precision:literal;)*) => { $(
        #[doc = concat!("Order ", $order, ", ", $c, " coefficients, in ", $precision, " precision.")]
        ///
        /// ```
        #[doc = concat!("use sh_core::{", stringify!($name), "};")]
        #[doc = concat!("let up = ", stringify!($name), "::cosine([0.0, 1.0, 0.0]);")]
        #[doc = concat!("assert_eq!(up.0.len(), ", $c, ");")]
        /// // All around 1 is reflected as 1.
        #[doc = concat!("assert!((up.dot(&", stringify!($name), "::ONE) - 1.0).abs() < 1e-6);")]
        /// ```
        pub type $name = Sh<$t, $c>;
    )* };
}
aliases! {
    Sh2: f32, 4, 2, "single";
    Sh3: f32, 9, 3, "single";
    Sh4: f32, 16, 4, "single";
    Sh5: f32, 25, 5, "single";
    Sh6: f32, 36, 6, "single";
    Sh2d: f64, 4, 2, "double";
    Sh3d: f64, 9, 3, "double";
    Sh4d: f64, 16, 4, "double";
    Sh5d: f64, 25, 5, "double";
    Sh6d: f64, 36, 6, "double";
}

/// √(4π): the DC coefficient of the function that is 1 everywhere.
///
/// ```
/// use sh_core::{ROOT_FOUR_PI, Sh2d};
/// assert_eq!(Sh2d::ONE.0, [ROOT_FOUR_PI, 0.0, 0.0, 0.0]);
/// ```
pub const ROOT_FOUR_PI: f64 = constants::ROOT_FOUR_PI;

macro_rules! constants {
    ($($t:ty)*) => { $(
        impl<const C: usize> Sh<$t, C> {
            /// The function that is 0 everywhere.
            ///
            /// ```
            /// use sh_core::Sh3;
            /// assert_eq!(Sh3::ZERO.evaluate([0.0, 1.0, 0.0]), 0.0);
            /// ```
            pub const ZERO: Self = Self([0.0; C]);
            /// The function that is 1 everywhere: (√(4π), 0, 0, …).
            ///
            /// ```
            /// use sh_core::Sh3;
            /// assert!((Sh3::ONE.evaluate([0.0, 0.6, 0.8]) - 1.0).abs() < 1e-6);
            /// ```
            pub const ONE: Self = {
                let mut c = [0.0; C];
                c[0] = ROOT_FOUR_PI as $t;
                Self(c)
            };
        }
        impl<const C: usize> Default for Sh<$t, C> {
            fn default() -> Self {
                Self::ZERO
            }
        }
    )* };
}
constants!(f32 f64);

impl<L: Lane, const C: usize> Sh<L, C>
where
    [L; C]: Routines<L>,
{
    /// The basis functions at the unit vector `d`. See [`Routines::basis`].
    ///
    /// ```
    /// use sh_core::Sh2;
    /// let y = Sh2::basis([0.0, 1.0, 0.0]);
    /// // y₁ = √(3/4π) (y, z, x)
    /// assert!((y[1] - 0.4886025).abs() < 1e-6 && y[2] == 0.0 && y[3] == 0.0);
    /// ```
    pub fn basis(d: impl Into<[L; 3]>) -> Self {
        Self(Routines::basis(d.into()))
    }

    /// The cosine lobe about the unit normal `d`, over π. See [`Routines::cosine`].
    ///
    /// ```
    /// use sh_core::Sh3;
    /// let sky = Sh3::ONE * 2.0;
    /// // What a white surface reflects of it.
    /// assert!((sky.dot(&Sh3::cosine([0.0, 1.0, 0.0])) - 2.0).abs() < 1e-6);
    /// ```
    pub fn cosine(d: impl Into<[L; 3]>) -> Self {
        Self(Routines::cosine(d.into()))
    }

    /// The zonal vector `z` turned to the unit vector `d`. See [`Routines::zonal`].
    ///
    /// ```
    /// use sh_core::{Sh4, cap};
    /// let z = cap::visibility::<16>(0.5).map(|c| c as f32);
    /// let past = Sh4::zonal(z, [0.0, 1.0, 0.0]);
    /// assert!(past.evaluate([0.0, 1.0, 0.0]) < past.evaluate([0.0, -1.0, 0.0]));
    /// ```
    pub fn zonal(z: <[L; C] as Routines<L>>::Zonal, d: impl Into<[L; 3]>) -> Self {
        Self(Routines::zonal(z, d.into()))
    }

    /// The function's value at the unit vector `d`.
    ///
    /// `f(d) = Σ f_i y_i(d)`, Ren et al. 2006, eq. 2: in f32 within n² u ‖f‖ of it.
    ///
    /// ```
    /// use sh_core::Sh2;
    /// let f = Sh2::from([0.0, 1.0, 0.0, 0.0]);
    /// assert!((f.evaluate([0.0, -1.0, 0.0]) + 0.4886025).abs() < 1e-6);
    /// ```
    pub fn evaluate(&self, d: impl Into<[L; 3]>) -> L {
        Routines::dot(&self.0, &Routines::basis(d.into()))
    }

    /// The projected product `f * g`. See [`Routines::product`].
    ///
    /// ```
    /// use sh_core::Sh4;
    /// let f = Sh4::cosine([0.0, 1.0, 0.0]);
    /// assert!((f.product(&Sh4::ONE) - f).norm() < 1e-6);
    /// ```
    pub fn product(&self, g: &Self) -> Self {
        Self(self.0.product(&g.0))
    }

    /// The product with itself. See [`Routines::square`].
    ///
    /// ```
    /// use sh_core::Sh4;
    /// let f = Sh4::cosine([0.0, 1.0, 0.0]);
    /// assert!((f.square() - f.product(&f)).norm() < 1e-6);
    /// ```
    pub fn square(&self) -> Self {
        Self(self.0.square())
    }

    /// ∫ f g. See [`Routines::dot`].
    ///
    /// ```
    /// use sh_core::Sh2;
    /// assert_eq!(Sh2::from([1.0, 2.0, 3.0, 4.0]).dot(&Sh2::from([0.0, 1.0, 0.0, 1.0])), 6.0);
    /// ```
    pub fn dot(&self, g: &Self) -> L {
        self.0.dot(&g.0)
    }

    /// ∫ f g h. See [`Routines::triple`].
    ///
    /// ```
    /// use sh_core::Sh4;
    /// let (light, normal) = (Sh4::ONE * 3.0, Sh4::cosine([0.0, 1.0, 0.0]));
    /// let half = Sh4::ONE * 0.5;
    /// assert!((light.triple(&half, &normal) - 1.5).abs() < 1e-5);
    /// ```
    pub fn triple(&self, g: &Self, h: &Self) -> L {
        self.0.triple(&g.0, &h.0)
    }

    /// Rotated by the unit quaternion (x, y, z, w). See [`Routines::rotate`].
    ///
    /// ```
    /// use sh_core::Sh4;
    /// // 90 degrees about z send x to y.
    /// let half = std::f32::consts::FRAC_1_SQRT_2;
    /// let turned = Sh4::basis([1.0, 0.0, 0.0]).rotate([0.0, 0.0, half, half]);
    /// assert!((turned - Sh4::basis([0.0, 1.0, 0.0])).norm() < 1e-5);
    /// ```
    pub fn rotate(&self, q: impl Into<[L; 4]>) -> Self {
        Self(self.0.rotate(q.into()))
    }

    /// Rotated by the rotation matrix, given row by row. See [`Routines::rotate_matrix`].
    ///
    /// ```
    /// use sh_core::Sh4;
    /// // 90 degrees about z send x to y.
    /// let turned = Sh4::basis([1.0, 0.0, 0.0])
    ///     .rotate_matrix([0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
    /// assert!((turned - Sh4::basis([0.0, 1.0, 0.0])).norm() < 1e-5);
    /// ```
    pub fn rotate_matrix(&self, m: [L; 9]) -> Self {
        Self(self.0.rotate_matrix(m))
    }

    /// Windowed to width `h`. See [`Routines::window`].
    ///
    /// ```
    /// use sh_core::Sh4;
    /// let sharp = Sh4::basis([0.0, 1.0, 0.0]);
    /// let soft = sharp.window(8.0);
    /// assert_eq!(soft[0], sharp[0]);
    /// assert!(soft.norm() < sharp.norm());
    /// ```
    pub fn window(&self, h: L) -> Self {
        Self(self.0.window(h))
    }

    /// √∫ f².
    ///
    /// ```
    /// use sh_core::Sh2;
    /// assert_eq!(Sh2::from([0.0, 3.0, 0.0, -4.0]).norm(), 5.0);
    /// ```
    pub fn norm(&self) -> L {
        self.dot(self).sqrt()
    }
}

impl<L: Lane, const C: usize> Sh<L, C> {
    /// The same function at another order, of D = n² coefficients: bands above it are left out, missing ones are 0.
    ///
    /// ```
    /// use sh_core::{Sh2, Sh3};
    /// let f = Sh3::from([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]);
    /// assert_eq!(f.to_order(), Sh2::from([1.0, 2.0, 3.0, 4.0]));
    /// assert_eq!(f.to_order::<16>().to_order(), f);
    /// ```
    pub fn to_order<const D: usize>(&self) -> Sh<L, D> {
        let zero = self.0[0].lift(0.0);
        Sh(core::array::from_fn(|i| {
            self.0.get(i).copied().unwrap_or(zero)
        }))
    }
}

impl<const C: usize> Sh<f64, C> {
    /// Rounded to single precision.
    ///
    /// ```
    /// use sh_core::{Sh2, Sh2d};
    /// assert_eq!(Sh2d::ONE.to_f32(), Sh2::ONE);
    /// ```
    pub fn to_f32(&self) -> Sh<f32, C> {
        Sh(self.0.map(|x| x as f32))
    }
}

impl<const C: usize> Sh<f32, C> {
    /// In double precision; exact.
    ///
    /// ```
    /// use sh_core::Sh2;
    /// assert_eq!(Sh2::ONE.to_f64().to_f32(), Sh2::ONE);
    /// ```
    pub fn to_f64(&self) -> Sh<f64, C> {
        Sh(self.0.map(f64::from))
    }
}

impl<L, const C: usize> From<[L; C]> for Sh<L, C> {
    fn from(coefficients: [L; C]) -> Self {
        Self(coefficients)
    }
}

impl<L, const C: usize> From<Sh<L, C>> for [L; C] {
    fn from(f: Sh<L, C>) -> Self {
        f.0
    }
}

impl<L: Lane, const C: usize> Add for Sh<L, C> {
    type Output = Self;
    fn add(mut self, other: Self) -> Self {
        self += other;
        self
    }
}

impl<L: Lane, const C: usize> Sub for Sh<L, C> {
    type Output = Self;
    fn sub(mut self, other: Self) -> Self {
        self -= other;
        self
    }
}

impl<L: Lane, const C: usize> Neg for Sh<L, C> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(|x| -x))
    }
}

impl<L: Lane, const C: usize> Mul<L> for Sh<L, C> {
    type Output = Self;
    fn mul(self, factor: L) -> Self {
        Self(self.0.map(|x| x * factor))
    }
}

impl<L: Lane, const C: usize> AddAssign for Sh<L, C> {
    fn add_assign(&mut self, other: Self) {
        for (a, b) in self.0.iter_mut().zip(other.0) {
            *a = *a + b;
        }
    }
}

impl<L: Lane, const C: usize> SubAssign for Sh<L, C> {
    fn sub_assign(&mut self, other: Self) {
        for (a, b) in self.0.iter_mut().zip(other.0) {
            *a = *a - b;
        }
    }
}

impl<L, const C: usize> Index<usize> for Sh<L, C> {
    type Output = L;
    fn index(&self, i: usize) -> &L {
        &self.0[i]
    }
}

impl<L, const C: usize> IndexMut<usize> for Sh<L, C> {
    fn index_mut(&mut self, i: usize) -> &mut L {
        &mut self.0[i]
    }
}
