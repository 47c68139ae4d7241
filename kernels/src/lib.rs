//! The WGSL of every pass, linked flat: one text a pass and order, ready for any WebGPU implementation.
//!
//! The sources are `kernels/*.wgsl`, one pass a file, and the pieces they share in `kernels/shared`. The
//! build script links them with the routines that `sh-codegen` generates; nothing of the linker or of the
//! generator is in the compiled crate.
//!
//! | pass | entry points | group 0 | group 1 |
//! |---|---|---|---|
//! | light_update | `place` | lighting (uniform), senders, points, cells, emission (written) | receivers (written) |
//! | | `project` | as above | radiance |
//! | | `raise` | as above | nodes |
//! | gbuffer | `body_vertex`, `body_fragment` | band (uniform) | body (uniform), base colour (texture) |
//! | | `ground_vertex`, `ground_fragment` | band (uniform) | |
//! | | `pack` | band (uniform), places, surfaces (textures) | receivers, albedos (storage, written) |
//! | irradiance | `irradiance` | lighting (uniform), emitters | receivers, radiance (written) |
//! | shadow | `shadow` | lighting (uniform), emitters, nodes | receivers, clusters, radiance (written) |
//! | shadowed_light | `shadowed_light` | as above | receivers, clusters, light (written: n² `vec4f` a receiver) |
//! | light_gather | `gather_discs`, `gather_sums` | lighting (uniform), nodes, members, emission | receivers, clusters, radiance (added to) |
//! | upsample | `shares` | band, lighting (uniform), emitters, rule (uniform) | half receivers, half radiance (to shares) |
//! | | `upsample` | as above | half receivers, half shares, receivers, radiance, what to shade anew and its clusters (three written), what is sent at half resolution |
//! | | `scatter` | as above | clusters, what is shaded anew, its radiance, radiance (written) |
//! | resolve | `resolve` | band (uniform), environment (texture) | receivers, albedo, radiance, picture (written) |
//! | vertices | `vertices` | source (uniform) | receivers (written), the host's vertices |
//! | screen | `from_positions`, `from_depth` | source (uniform) | receivers (written), the host's normals and positions or depth (textures) |
//! | | `to_texture` | as above | radiance, the host's texture (written) |
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

/// The passes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pass {
    /// What spheres send on.
    LightUpdate,
    /// Position, normal and albedo per sample; the same text for every order.
    Gbuffer,
    /// Light without blockers.
    Irradiance,
    /// Light through the visibility of all blocker spheres.
    Shadow,
    /// That light itself, before the cosine lobe.
    ShadowedLight,
    /// Light that spheres send on.
    LightGather,
    /// Radiance at half resolution to samples.
    Upsample,
    /// Samples to pixels; the same text for every order.
    Resolve,
    /// A host's vertices as receivers; the same text for every order.
    Vertices,
    /// A host's G-buffer as receivers, and radiance into its texture; the same text for every order.
    Screen,
}

impl Pass {
    /// All passes, in the order of a frame.
    pub const ALL: [Pass; 10] = [
        Pass::LightUpdate,
        Pass::Gbuffer,
        Pass::Irradiance,
        Pass::Shadow,
        Pass::ShadowedLight,
        Pass::LightGather,
        Pass::Upsample,
        Pass::Resolve,
        Pass::Vertices,
        Pass::Screen,
    ];

    /// The name of the pass and of its file.
    pub fn name(self) -> &'static str {
        match self {
            Pass::LightUpdate => "light_update",
            Pass::Gbuffer => "gbuffer",
            Pass::Irradiance => "irradiance",
            Pass::Shadow => "shadow",
            Pass::ShadowedLight => "shadowed_light",
            Pass::LightGather => "light_gather",
            Pass::Upsample => "upsample",
            Pass::Resolve => "resolve",
            Pass::Vertices => "vertices",
            Pass::Screen => "screen",
        }
    }
}

#[cfg(feature = "export")]
pub mod export;
#[cfg(feature = "export")]
#[expect(dead_code, reason = "only the build script links")]
mod link;

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
