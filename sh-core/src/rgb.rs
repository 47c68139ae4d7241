//! Three colour channels.

use crate::{Lane, Routines, Sh};
use core::ops::{Add, Mul};

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
    ///
    /// ```
    /// use sh_core::{Sh3, ShRgb};
    /// assert_eq!(ShRgb::gray(Sh3::ONE).g, Sh3::ONE);
    /// ```
    pub fn gray(f: Sh<L, C>) -> Self {
        Self { r: f, g: f, b: f }
    }

    /// Every channel through `f`.
    ///
    /// ```
    /// use sh_core::{Sh3, ShRgb};
    /// let dimmed = ShRgb::gray(Sh3::ONE).map(|channel| channel * 0.5);
    /// assert_eq!(dimmed.b, Sh3::ONE * 0.5);
    /// ```
    pub fn map(self, f: impl Fn(Sh<L, C>) -> Sh<L, C>) -> Self {
        Self {
            r: f(self.r),
            g: f(self.g),
            b: f(self.b),
        }
    }

    /// Every channel at another order. See [`Sh::to_order`].
    ///
    /// ```
    /// use sh_core::{Sh2, Sh3, ShRgb};
    /// let light = ShRgb::gray(Sh3::cosine([0.0, 1.0, 0.0]));
    /// assert_eq!(light.to_order().b, Sh2::cosine([0.0, 1.0, 0.0]));
    /// ```
    pub fn to_order<const D: usize>(&self) -> ShRgb<L, D> {
        ShRgb {
            r: self.r.to_order(),
            g: self.g.to_order(),
            b: self.b.to_order(),
        }
    }

    /// Every channel's integral with `g`.
    ///
    /// ```
    /// use sh_core::{Sh3, ShRgb};
    /// let reflected = ShRgb::gray(Sh3::ONE).dot(&Sh3::cosine([0.0, 1.0, 0.0]));
    /// assert!(reflected.iter().all(|c| (c - 1.0).abs() < 1e-6));
    /// ```
    pub fn dot(&self, g: &Sh<L, C>) -> [L; 3]
    where
        [L; C]: Routines<L>,
    {
        [self.r.dot(g), self.g.dot(g), self.b.dot(g)]
    }

    /// The colour at the unit vector `d`.
    ///
    /// ```
    /// use sh_core::{Sh3, ShRgb};
    /// let sky = ShRgb { r: Sh3::ZERO, g: Sh3::ONE * 0.5, b: Sh3::ONE };
    /// assert_eq!(sky.evaluate([0.0, 1.0, 0.0]).map(|c| (c * 1e4).round()), [0.0, 5e3, 1e4]);
    /// ```
    pub fn evaluate(&self, d: impl Into<[L; 3]>) -> [L; 3]
    where
        [L; C]: Routines<L>,
    {
        self.dot(&Sh::basis(d))
    }
}

impl<const C: usize> ShRgb<f64, C> {
    /// Rounded to single precision, as what [`crate::project`] gives often is.
    ///
    /// ```
    /// let light = sh_core::project::equirectangular::<9>(2, 1, |_, _| [0.25; 3]).to_f32();
    /// assert!((light.evaluate([0.0, 1.0, 0.0])[0] - 0.25).abs() < 1e-6);
    /// ```
    pub fn to_f32(&self) -> ShRgb<f32, C> {
        ShRgb {
            r: self.r.to_f32(),
            g: self.g.to_f32(),
            b: self.b.to_f32(),
        }
    }
}

impl<const C: usize> ShRgb<f32, C> {
    /// In double precision; exact.
    ///
    /// ```
    /// use sh_core::{Sh2, ShRgb};
    /// assert_eq!(ShRgb::gray(Sh2::ONE).to_f64().r, Sh2::ONE.to_f64());
    /// ```
    pub fn to_f64(&self) -> ShRgb<f64, C> {
        ShRgb {
            r: self.r.to_f64(),
            g: self.g.to_f64(),
            b: self.b.to_f64(),
        }
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
