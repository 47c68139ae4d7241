//! What passes hand each other, and how much of it there is.

/// What passes hand each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Resource {
    /// Meshes, their transforms and textures, and the ground.
    Surfaces,
    /// Positions and normals to light: [`crate::Receiver`] records.
    Receivers,
    /// Linear Rec.709 reflectance of each receiver.
    Albedo,
    /// Radiance that albedo 1 would reflect at each receiver.
    Radiance,
    /// As `Receivers`, at half the picture's resolution.
    HalfReceivers,
    /// As `Radiance`, at half the picture's resolution.
    HalfRadiance,
    /// The spheres that block light, in world space: [`crate::Forest`].
    Blockers,
    /// Points on bodies' surfaces: [`crate::SurfaceSamples`].
    SurfacePoints,
    /// What each sphere sends on, as an SH vector.
    Emission,
    /// The environment as SH vectors, and analytic lights: [`crate::Light`].
    Light,
    /// The environment as a map: [`crate::EnvironmentMap`].
    Environment,
    /// The picture: linear Rec.709, 32-bit floats.
    Picture,
}

impl Resource {
    /// How many elements it has.
    pub fn resolution(self) -> Resolution {
        match self {
            Self::Surfaces | Self::Blockers | Self::Light | Self::Environment => Resolution::Fixed,
            Self::SurfacePoints => Resolution::Fixed,
            Self::Emission => Resolution::Spheres,
            Self::Receivers | Self::Albedo | Self::Radiance => Resolution::Samples,
            Self::HalfReceivers | Self::HalfRadiance => Resolution::Halves,
            Self::Picture => Resolution::Pixels,
        }
    }
}

/// Memory that the passes of a plan work in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Buffer {
    /// What is in it.
    pub name: &'static str,
    /// Index of the pass that owns or writes it, in the plan.
    pub pass: usize,
    /// Its size.
    pub bytes: u64,
}

/// What the size of a resource follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Resolution {
    /// One element a sample of the [`crate::View`]: [`crate::View::samples`].
    Samples,
    /// One element every two by two pixels: [`crate::View::halves`].
    Halves,
    /// One element a pixel of the picture.
    Pixels,
    /// One element a sphere.
    Spheres,
    /// The scene, not the picture. It is there before the first pass.
    Fixed,
}
