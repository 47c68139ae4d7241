//! What passes hand each other, as data.

/// What a pass runs over, and what a resource has one element for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Domain {
    /// The scene as a whole.
    Scene,
    /// The spheres of all bodies.
    Spheres,
    /// Receivers that the caller brings: vertices, or whatever else is to be lit.
    Receivers,
    /// A ray for every two by two pixels: [`crate::View::halves`].
    Halves,
    /// The samples of the picture: [`crate::View::samples`].
    Samples,
    /// The samples that half resolution does not do for: a list, different in every frame.
    Rest,
    /// The pixels of the picture.
    Pixels,
}

impl Domain {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::Scene,
        Self::Spheres,
        Self::Receivers,
        Self::Halves,
        Self::Samples,
        Self::Rest,
        Self::Pixels,
    ];

    /// The name that tables use.
    pub fn name(self) -> &'static str {
        match self {
            Self::Scene => "scene",
            Self::Spheres => "spheres",
            Self::Receivers => "receivers",
            Self::Halves => "halves",
            Self::Samples => "samples",
            Self::Rest => "rest",
            Self::Pixels => "pixels",
        }
    }

    /// When its passes run: those of one phase are done, all bands of them, before those of the next begin.
    pub(super) fn phase(self) -> Phase {
        match self {
            Self::Scene | Self::Spheres | Self::Receivers => Phase::Once,
            Self::Halves => Phase::Coarse,
            Self::Samples | Self::Rest | Self::Pixels => Phase::Fine,
        }
    }
}

/// The order in which domains are worked off.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Phase {
    Once,
    Coarse,
    Fine,
}

/// What passes hand each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Resource {
    /// The name that messages and memory tables use.
    pub name: &'static str,
    /// What one element is.
    pub element: &'static str,
    /// What there is one element for; none for what each set of receivers has one of its own of.
    pub domain: Option<Domain>,
    /// Whether it is there before the first pass.
    pub given: bool,
}

/// Resources of this name and element: those of each set of receivers.
const fn of_receivers(name: &'static str, element: &'static str) -> Resource {
    Resource {
        name,
        element,
        domain: None,
        given: false,
    }
}

/// Resources that are there before the first pass.
const fn given(name: &'static str, element: &'static str) -> Resource {
    Resource {
        name,
        element,
        domain: Some(Domain::Scene),
        given: true,
    }
}

/// Meshes, their transforms and textures, and the ground.
pub const SURFACES: Resource = given("surfaces", "mesh, transform and texture");

/// Spheres that block light, in world space, as the leaves of a tree: [`crate::Forest`].
pub const BLOCKERS: Resource = given("blockers", "node of a tree");

/// Points on bodies' surfaces: [`crate::SurfaceSamples`].
pub const SURFACE_POINTS: Resource = given("surface points", "point and normal");

/// The environment as SH vectors, and analytic lights: [`crate::Light`].
pub const LIGHT: Resource = given("light", "SH vector and emitters");

/// The environment as a map: [`crate::EnvironmentMap`].
pub const ENVIRONMENT: Resource = given("environment", "linear Rec.709 radiance of a texel");

/// What each sphere sends on.
pub const EMISSION: Resource = Resource {
    name: "emission",
    element: "SH vector a channel",
    domain: Some(Domain::Spheres),
    given: false,
};

/// Positions and normals to light: [`crate::Receiver`] records.
pub const RECEIVERS: Resource = of_receivers("receivers", "position and normal");

/// Linear Rec.709 reflectance of each receiver.
pub const ALBEDO: Resource = of_receivers("albedo", "linear Rec.709 reflectance");

/// Radiance that albedo 1 would reflect at each receiver.
pub const RADIANCE: Resource = of_receivers("radiance", "linear Rec.709 radiance");

/// The share of its light that each receiver gets through the blockers; in the memory of its radiance.
pub const SHARE: Resource = of_receivers("share", "share of a channel");

/// Radiance of samples, where half resolution does for it; in the memory of their radiance.
pub const UPSAMPLED: Resource = of_receivers("upsampled radiance", "linear Rec.709 radiance");

/// What spheres send to each receiver, where it is kept apart from other light.
pub const SENT: Resource = of_receivers("sent", "linear Rec.709 radiance");

/// The picture.
pub const PICTURE: Resource = Resource {
    name: "picture",
    element: "linear Rec.709 radiance",
    domain: Some(Domain::Pixels),
    given: false,
};

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
