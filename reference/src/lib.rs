//! The f64 truth against which Gaunt is tested: slow, obvious, and written apart from everything it judges.
//!
//! Nothing here comes out of the code generator or calls `sh-core`. The basis is a recurrence, everything
//! else is *sample on a quadrature rule and project*, eq. 1 of Ren et al., "Real-time Soft Shadows in
//! Dynamic Scenes using Spherical Harmonic Exponentiation" (SIGGRAPH 2006), which the modules cite as
//! "Ren 2006". A rule is exact for polynomials up to its degree, so that the product, the rotation and the
//! cosine lobe are exact up to rounding (about 1e-14 relative); where an integrand is not a polynomial, the
//! function says what error it makes or returns an estimate of it.
//!
//! | module | truth of |
//! |---|---|
//! | [`basis`] | the real SH basis, any order, and reconstruction |
//! | [`scipy`] | the basis again, from SciPy: a table of values |
//! | [`quadrature`] | integrals and projections of functions on the sphere |
//! | [`octahedral`] | sampling rules, solved from their moments |
//! | [`product`] | Gaunt tensor, product, square, triple product, product matrix |
//! | [`rotation`] | rotation by a quaternion |
//! | [`zonal`] | zonal vectors turned to a direction, the cosine lobe, the window |
//! | [`cap`] | the visibility past a sphere |
//! | [`ball`] | how much is seen of what a sphere emits |
//! | [`lens`] | the common part of two discs, flat and on the sphere |
//! | [`log`] | the SH logarithm, by eigenvalues and by samples |
//! | [`exp`] | the SH exponential, exact and by the series of Ren 2006 |
//! | [`environment`] | the projection of an equirectangular map |
//! | [`visibility`] | the visibility past many spheres, the light that is left |
//! | [`arcs`] | the same visibility, exact to rounding and fast, along the edges of the caps |
//! | [`blockers`] | the random sets of caps that accuracy is measured on |
//! | [`shaded`] | such sets above a horizon, and what they do to light |
//! | [`horizon`] | what a receiver sees of a sphere that its horizon cuts |
//! | [`raycast`] | the visibility past triangles, one ray at a time |
//! | [`paths`] | all light of a scene: shadows and diffuse bounces, path by path |
//! | [`spheres`] | the volume of spheres outside a mesh; sphere sets made in simpler ways |
//! | [`sampled`] | SH vector and light behind any visibility |
//!
//! # Conventions
//!
//! SH vectors are slices of `n²` coefficients, index `l·l + l + m`, of the real orthonormal basis without
//! Condon–Shortley phase: y₁ = √(3/4π)·(y, z, x). Directions are unit vectors `[x, y, z]`, angles radians,
//! quaternions `[x, y, z, w]`. A slice whose length is no square, or two slices of different order, are
//! mistakes of the calling program and panic; so does an order of 0.
//!
//! ```
//! use sh_reference::{basis, product};
//! let f = basis::basis(4, [0.0, 0.6, 0.8]);
//! let one = product::one(4);
//! let same = product::product(&f, &one);
//! assert!(f.iter().zip(&same).all(|(a, b)| (a - b).abs() < 1e-13));
//! ```

pub mod arcs;
pub mod ball;
pub mod basis;
pub mod blockers;
pub mod cap;
pub mod environment;
pub mod exp;
pub mod gloss;
pub mod horizon;
pub mod lens;
pub mod log;
pub mod octahedral;
pub mod paths;
pub mod product;
pub mod quadrature;
pub mod raycast;
pub mod rotation;
pub mod sampled;
pub mod scipy;
pub mod shaded;
pub mod spheres;
pub mod visibility;
pub mod zonal;

mod cells;
mod edges;
mod vec3;

#[cfg(test)]
mod testing;
