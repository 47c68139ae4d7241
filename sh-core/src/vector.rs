//! The SH vector types: n² coefficients of one function, or of three colour channels.

use crate::{Lane, Routines};
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

/// Order 2: 4 coefficients.
pub type Sh2 = Sh<f32, 4>;
/// Order 3: 9 coefficients.
pub type Sh3 = Sh<f32, 9>;
/// Order 4: 16 coefficients.
pub type Sh4 = Sh<f32, 16>;
/// Order 5: 25 coefficients.
pub type Sh5 = Sh<f32, 25>;
/// Order 6: 36 coefficients.
pub type Sh6 = Sh<f32, 36>;
/// Order 2 in double precision.
pub type Sh2d = Sh<f64, 4>;
/// Order 3 in double precision.
pub type Sh3d = Sh<f64, 9>;
/// Order 4 in double precision.
pub type Sh4d = Sh<f64, 16>;
/// Order 5 in double precision.
pub type Sh5d = Sh<f64, 25>;
/// Order 6 in double precision.
pub type Sh6d = Sh<f64, 36>;

/// √(4π): the DC coefficient of the function that is 1 everywhere.
pub const ROOT_FOUR_PI: f64 = 3.544_907_701_811_032;

macro_rules! constants {
    ($($t:ty)*) => { $(
        impl<const C: usize> Sh<$t, C> {
            /// The function that is 0 everywhere.
            pub const ZERO: Self = Self([0.0; C]);
            /// The function that is 1 everywhere: (√(4π), 0, 0, …).
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
    pub fn basis(d: impl Into<[L; 3]>) -> Self {
        Self(Routines::basis(d.into()))
    }

    /// The cosine lobe about the unit normal `d`, over π. See [`Routines::cosine`].
    pub fn cosine(d: impl Into<[L; 3]>) -> Self {
        Self(Routines::cosine(d.into()))
    }

    /// The zonal vector `z` turned to the unit vector `d`. See [`Routines::zonal`].
    pub fn zonal(z: <[L; C] as Routines<L>>::Zonal, d: impl Into<[L; 3]>) -> Self {
        Self(Routines::zonal(z, d.into()))
    }

    /// The function's value at the unit vector `d`.
    pub fn evaluate(&self, d: impl Into<[L; 3]>) -> L {
        Routines::dot(&self.0, &Routines::basis(d.into()))
    }

    /// The projected product `f * g`. See [`Routines::product`].
    pub fn product(&self, g: &Self) -> Self {
        Self(self.0.product(&g.0))
    }

    /// The product with itself. See [`Routines::square`].
    pub fn square(&self) -> Self {
        Self(self.0.square())
    }

    /// ∫ f g. See [`Routines::dot`].
    pub fn dot(&self, g: &Self) -> L {
        self.0.dot(&g.0)
    }

    /// ∫ f g h. See [`Routines::triple`].
    pub fn triple(&self, g: &Self, h: &Self) -> L {
        self.0.triple(&g.0, &h.0)
    }

    /// Rotated by the unit quaternion (x, y, z, w). See [`Routines::rotate`].
    pub fn rotate(&self, q: impl Into<[L; 4]>) -> Self {
        Self(self.0.rotate(q.into()))
    }

    /// Rotated by the rotation matrix, given row by row. See [`Routines::rotate_matrix`].
    pub fn rotate_matrix(&self, m: [L; 9]) -> Self {
        Self(self.0.rotate_matrix(m))
    }

    /// Windowed to width `h`. See [`Routines::window`].
    pub fn window(&self, h: L) -> Self {
        Self(self.0.window(h))
    }

    /// √∫ f².
    pub fn norm(&self) -> L {
        self.dot(self).sqrt()
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

/// One SH vector a colour channel, linear Rec.709.
///
/// ```
/// use sh_core::{Sh4, ShRgb};
/// let white = ShRgb::gray(Sh4::ONE);
/// let lit = white.map(|channel| channel * 0.5);
/// assert_eq!(lit.evaluate([0.0, 1.0, 0.0]).map(|c| (c * 1e4).round()), [5000.0; 3]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct ShRgb<L, const C: usize> {
    /// Red.
    pub r: Sh<L, C>,
    /// Green.
    pub g: Sh<L, C>,
    /// Blue.
    pub b: Sh<L, C>,
}

impl<L: Lane, const C: usize> ShRgb<L, C> {
    /// The same vector in every channel.
    pub fn gray(f: Sh<L, C>) -> Self {
        Self { r: f, g: f, b: f }
    }

    /// Every channel through `f`.
    pub fn map(self, f: impl Fn(Sh<L, C>) -> Sh<L, C>) -> Self {
        Self {
            r: f(self.r),
            g: f(self.g),
            b: f(self.b),
        }
    }

    /// Every channel's integral with `g`.
    pub fn dot(&self, g: &Sh<L, C>) -> [L; 3]
    where
        [L; C]: Routines<L>,
    {
        [self.r.dot(g), self.g.dot(g), self.b.dot(g)]
    }

    /// The colour at the unit vector `d`.
    pub fn evaluate(&self, d: impl Into<[L; 3]>) -> [L; 3]
    where
        [L; C]: Routines<L>,
    {
        self.dot(&Sh::basis(d))
    }
}

impl<L: Lane, const C: usize> Add for ShRgb<L, C> {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self {
            r: self.r + o.r,
            g: self.g + o.g,
            b: self.b + o.b,
        }
    }
}

impl<L: Lane, const C: usize> Mul<L> for ShRgb<L, C> {
    type Output = Self;
    fn mul(self, factor: L) -> Self {
        self.map(|channel| channel * factor)
    }
}
