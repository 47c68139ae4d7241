//! What is known of a body before frames need it.

use super::records::Patch;
use sh_core::constants::MOST_COEFFICIENTS;

/// A point of a body's surface at which irradiance is told; each stands for as much area as the others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BasisSample {
    /// Where, in metres, object space.
    pub position: [f32; 3],
    /// Unit normal, object space.
    pub normal: [f32; 3],
    /// Linear Rec.709 reflectance, each in 0..=1.
    pub albedo: [f32; 3],
}

/// What is known of a body: [`IrradianceBasis::new`](crate::IrradianceBasis::new) makes of it what frames need.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BasisParts {
    /// Points on the surface: whole regions, patch by patch. The first of each patch is where light is looked up.
    pub samples: Vec<BasisSample>,
    /// The area that each of them stands for, in square metres.
    pub area: f32,
    /// The values of the functions at all samples, function by function; the first is 1.
    pub values: Vec<f32>,
    /// The patches, region by region.
    pub patches: Vec<Patch>,
    /// The integral of the basis over the directions in which a patch is seen, times the cosine, in the mean of its samples:
    /// coefficients of order 6.
    pub lobes: Vec<[f32; MOST_COEFFICIENTS]>,
    /// What the body gives each of its patches of each function, patch by patch; empty where it gives itself nothing.
    pub own: Vec<[f32; 3]>,
    /// How much of the lights that the functions were found by the first, the first two, ... tell.
    pub held: Vec<f32>,
}
