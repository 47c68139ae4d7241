//! The WGSL of every pass, linked flat: one text a pass and order, ready for any WebGPU implementation.
//!
//! The sources are `kernels/*.wgsl`, one pass a file, and the pieces they share in `kernels/shared`. The
//! build script links them with the routines that `sh-codegen` generates; nothing of the linker or of the
//! generator is in the compiled crate.
//!
//! What they are bound to stands in the kernels, and is listed from there ([`Pass::entries`]):
//!
#![doc = include_str!(concat!(env!("OUT_DIR"), "/passes.md"))]
//!
//! Compute entry points have workgroups of [`WORKGROUP`] invocations and count elements row by row over a
//! two-dimensional dispatch; how many there are follows from the size of the bound buffers. `shadow`, `light_gather`,
//! `upsample` and `scatter` count clusters or tiles along y and z instead, and the entry points of `light_update` spheres
//! or nodes.
//!
//! ```
//! let wgsl = sh_kernels::source(sh_kernels::Pass::Shadow, 4).expect("orders 2 to 6 exist");
//! assert!(wgsl.contains("fn shadow("));
//! assert!(sh_kernels::source(sh_kernels::Pass::Shadow, 7).is_none());
//! ```

#![forbid(unsafe_code)]

/// The lowest SH order there are kernels for.
pub const MIN_ORDER: usize = 2;

mod bindings;

pub use bindings::{Binding, EntryPoint, Kind, Stage};

#[cfg(feature = "export")]
pub mod export;
#[cfg(feature = "export")]
#[expect(dead_code, reason = "only the build script links")]
mod link;

include!(concat!(env!("OUT_DIR"), "/passes.rs"));
// `MAX_ORDER` and `WORKGROUP`, which kernels have as well, and `linked`, which looks a text up.
include!(concat!(env!("OUT_DIR"), "/sources.rs"));

/// The flat WGSL text of a pass at an SH order, or `None` for an order outside [`MIN_ORDER`] to
/// [`MAX_ORDER`]. The shadow pass accumulates in the same order; see [`shadow`].
pub fn source(pass: Pass, order: usize) -> Option<&'static str> {
    linked(pass.name(), order, order)
}

/// The shadow pass for light of an SH order that accumulates logarithms in the order `accumulation`, at least
/// `order`: of the exponential of that sum the lower bands are more accurate than those of a sum of their own.
/// `None` outside [`MIN_ORDER`] to [`MAX_ORDER`].
///
/// ```
/// assert!(sh_kernels::shadow(4, 6).is_some_and(|wgsl| wgsl.contains("sh6_transfer")));
/// assert!(sh_kernels::shadow(4, 3).is_none());
/// ```
pub fn shadow(order: usize, accumulation: usize) -> Option<&'static str> {
    linked(Pass::Shadow.name(), order, accumulation)
}

/// As [`shadow`], for [`Pass::ShadowedLight`].
///
/// ```
/// assert!(sh_kernels::shadowed_light(4, 6).is_some_and(|wgsl| wgsl.contains("fn shadowed_light(")));
/// ```
pub fn shadowed_light(order: usize, accumulation: usize) -> Option<&'static str> {
    linked(Pass::ShadowedLight.name(), order, accumulation)
}

/// The routines of an SH order as a WGSL function library, without any pass: all that sh-codegen generates,
/// and the exponentials that are made of products, `sh4_exp_product_series`, `sh4_exp_ps_star`, `sh4_exp_hyb` and
/// `sh4_exp_optimal_linear` at order 4. `None` for an order outside [`MIN_ORDER`] to [`MAX_ORDER`].
pub fn library(order: usize) -> Option<&'static str> {
    linked("library", order, order)
}
