//! Spherical harmonic mathematics for lighting: products, squares, product matrices, rotations, windows,
//! exponentials and logarithms of spherical functions of order 2 to 6, without a standard library.
//!
//! # Conventions
//! *Order* n means n bands l = 0..n−1 and n² coefficients, index l·l + l + m. The basis is real and
//! orthonormal, with the sign usual in graphics (no Condon–Shortley): y₁ = √(3/4π) (y, z, x). Coordinates are
//! right-handed, +Y is up, angles are radians. Rotations are active: (Rf)(s) = f(R⁻¹ s). A *zonal* vector has
//! the n coefficients of m = 0 about +Z. The function 1 is (√(4π), 0, 0, …).
//!
//! # What there is
//! - [`Sh`] (aliases [`Sh2`]…[`Sh6`], [`Sh2d`]…[`Sh6d`]) and [`ShRgb`]: vectors with their linear algebra.
//! - [`Routines`]: what is generated for every order, on plain arrays and for any [`Lane`].
//! - [`ORDERS`], [`OrderError`] for any other, and [`for_order!`] for one that is known at run time.
//! - [`exp`]: the SH exponential; [`log`] (feature `log`) and [`cap`]: logarithms of visibility.
//! - [`project`]: environment maps to SH vectors.
//! - [`convention`]: vectors as Unity, Unreal, Filament and three.js write them, and other axes.
//! - [`storage`]: vectors in uniform and storage buffers, in half precision.
//!
//! The same text computes with `f32`, `f64` and vector lanes. In single precision a product errs by at most
//! 16 u ‖f‖‖g‖ and a rotation by 1e-6 ‖f‖ (u = 2⁻²⁴); the f64 forms are good to the same count of *their* u.
//!
//! # Features
//! All of them add and none takes away; without any but `std` the crate depends on nothing at run time, and its build
//! script on the generator alone.
//!
//! | feature | brings |
//! |---|---|
//! | `std` (default) | elementary functions of the standard library |
//! | `libm` | elementary functions of the crate libm, without a standard library; one of the two has to be on |
//! | `log` | the SH logarithm of any vector, by eigenanalysis (nalgebra) |
//! | `glam`, `mint` | rotation by their matrices; their vectors and quaternions are taken as they are |
//! | `bytemuck` | `Pod` and `Zeroable` |
//! | `half` | storage in half precision |
//! | `approx` | approximate comparison |
//!
//! ```
//! use sh_core::{Sh4, cap};
//! // Light from above, half of the sky hidden, on a surface that faces up.
//! let light = Sh4::cosine([0.0, 1.0, 0.0]) * 3.0;
//! let visible = Sh4::zonal(cap::visibility::<16>(1.0).map(|c| c as f32), [1.0, 0.0, 0.0]);
//! let radiance = light.triple(&visible, &Sh4::cosine([0.0, 1.0, 0.0]));
//! assert!(radiance > 0.0 && radiance < light.dot(&Sh4::cosine([0.0, 1.0, 0.0])));
//! ```

#![cfg_attr(not(feature = "std"), no_std)]
#![deny(unsafe_code)]
#![cfg_attr(
    not(all(feature = "half", feature = "log")),
    allow(
        rustdoc::broken_intra_doc_links,
        reason = "without a feature there is nothing to link to where its items are spoken of"
    )
)]

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("sh-core needs elementary functions: enable the feature `std` (default) or `libm`");

mod adapters;
pub mod cap;
#[doc(hidden)]
pub mod constants;
pub mod convention;
pub mod exp;
mod generated;
pub mod gloss;
mod lane;
#[cfg(feature = "log")]
pub mod log;
mod order;
pub mod project;
mod real;
mod rgb;
pub mod seen;
pub mod storage;
mod vector;

pub use generated::Routines;
pub use lane::Lane;
pub use order::{ORDERS, OrderError};
pub use rgb::ShRgb;
pub use vector::{ROOT_FOUR_PI, Sh, Sh2, Sh2d, Sh3, Sh3d, Sh4, Sh4d, Sh5, Sh5d, Sh6, Sh6d};
