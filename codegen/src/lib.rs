//! Exact Gaunt coefficients, expression graphs, factored spherical harmonic routines, and their text in Rust
//! and WGSL.
//!
//! ```text
//! exact  Γ and other constants as signed roots of rationals        real   …rounded once
//! expr   expression graphs                                         basis, direct, rings, octahedral, sampled, rotation, fits: what fills them
//! routines  the typed table of all routines                        emit   graphs to Rust and WGSL
//! constants  the typed table of constants that both languages share
//! ```
//!
//! The crate depends on nothing, reads and writes no file, and searches for nothing at run time: it is made
//! to be called from build scripts, unoptimised. Fitted constants are data in `codegen/data/`.
//!
//! ```
//! let product = sh_codegen::routines::find("product").unwrap();
//! assert_eq!(product.ops(2), sh_codegen::expr::Ops { mul: 16, add: 6, exp: 0 });
//! assert!(sh_codegen::emit::wgsl::function(product, 2).contains("fn sh2_product("));
//! ```

pub mod basis;
pub mod constants;
pub mod direct;
pub mod emit;
pub mod exact;
pub mod expr;
pub mod fits;
pub mod octahedral;
pub mod real;
pub mod rings;
pub mod rotation;
pub mod routines;
pub mod sampled;

/// All WGSL routines of an order; the same as [`emit::wgsl::library`].
pub use emit::wgsl;
