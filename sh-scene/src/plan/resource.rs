//! What passes hand each other, as data.

use std::borrow::Cow;
use std::collections::HashMap;

/// What a pass runs over, and what a resource has one element for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Domain {
    /// The scene as a whole.
    Scene,
    /// Points on the surfaces of bodies, as receivers: those around each sphere.
    Points,
    /// The spheres of all bodies.
    Spheres,
    /// Patches of bodies' surfaces, each with a point as a receiver.
    Patches,
    /// Texels of what lights with sharp shadows see: [`crate::LightViews`].
    Views,
    /// Receivers that the caller brings: vertices, or whatever else is to be lit.
    Receivers,
    /// A ray for every two by two pixels: [`crate::View::halves`].
    Halves,
    /// The samples of the picture: [`crate::View::samples`].
    Samples,
    /// The samples that half resolution does not do for: a list, different in every frame.
    Rest,
    /// The samples of the picture that mirror light: as many elements as it has samples.
    Gloss,
    /// The pixels of the picture.
    Pixels,
}

impl Domain {
    /// All of them.
    pub const ALL: [Self; 11] = [
        Self::Scene,
        Self::Points,
        Self::Spheres,
        Self::Patches,
        Self::Views,
        Self::Receivers,
        Self::Halves,
        Self::Samples,
        Self::Rest,
        Self::Gloss,
        Self::Pixels,
    ];

    /// The name that tables use.
    pub fn name(self) -> &'static str {
        match self {
            Self::Scene => "scene",
            Self::Points => "points",
            Self::Spheres => "spheres",
            Self::Patches => "patches",
            Self::Views => "views",
            Self::Receivers => "receivers",
            Self::Halves => "halves",
            Self::Samples => "samples",
            Self::Rest => "rest",
            Self::Gloss => "gloss",
            Self::Pixels => "pixels",
        }
    }

    /// The domain whose receivers its passes run over: what mirrors light are samples.
    pub fn receivers(self) -> Self {
        match self {
            Self::Gloss => Self::Samples,
            other => other,
        }
    }

    /// Whether what passes make for it stays as it is from frame to frame, as long as no body moves and no light changes: it
    /// has nothing to do with what looks at it.
    pub fn is_kept(self) -> bool {
        matches!(
            self,
            Self::Points | Self::Spheres | Self::Patches | Self::Views
        )
    }

    /// When its passes run: those of one phase are done, all bands of them, before those of the next begin.
    pub(super) fn phase(self) -> Phase {
        match self {
            Self::Scene | Self::Points | Self::Spheres | Self::Patches | Self::Views => {
                Phase::Bodies
            }
            Self::Receivers => Phase::Brought,
            Self::Halves => Phase::Coarse,
            Self::Samples | Self::Rest | Self::Gloss | Self::Pixels => Phase::Fine,
        }
    }
}

/// The order in which domains are worked off.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Phase {
    /// What bodies do to each other, whoever looks.
    Bodies,
    /// A caller's receivers.
    Brought,
    /// The picture at half resolution.
    Coarse,
    /// The picture.
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
    /// Bytes of an element on a GPU, where it lies in a buffer that passes share.
    pub bytes: u64,
    /// The name of that buffer: one for several resources of a domain of which each is gone when the next is there.
    pub memory: &'static str,
    /// What kernels call it, or the parts of it.
    pub bindings: &'static [&'static str],
}

impl Resource {
    /// Something that passes make, with an element for each of a domain, or of each set of receivers where that is none; and
    /// on a GPU: bytes an element, in a buffer of its own, and what kernels call it.
    pub const fn made(
        name: &'static str,
        element: &'static str,
        domain: Option<Domain>,
        (bytes, bindings): (u64, &'static [&'static str]),
    ) -> Self {
        Self {
            name,
            element,
            domain,
            given: false,
            bytes,
            memory: name,
            bindings,
        }
    }

    /// The same in the memory of another.
    const fn within(self, other: Self) -> Self {
        Self {
            memory: other.memory,
            ..self
        }
    }
}

/// Resources that are there before the first pass.
const fn given(
    name: &'static str,
    element: &'static str,
    bindings: &'static [&'static str],
) -> Resource {
    Resource {
        name,
        element,
        domain: Some(Domain::Scene),
        given: true,
        bytes: 0,
        memory: name,
        bindings,
    }
}

/// Meshes, their transforms and textures, and the ground.
pub const SURFACES: Resource = given(
    "surfaces",
    "mesh, transform and texture",
    &["body", "base_color", "finish"],
);

/// Spheres that block light, in world space, as the leaves of a tree: [`crate::Forest`].
pub const BLOCKERS: Resource = given("blockers", "node of a tree", &["nodes", "members"]);

/// Points on bodies' surfaces: [`crate::SurfaceSamples`].
pub const SURFACE_POINTS: Resource = given(
    "surface points",
    "point and normal",
    &["senders", "points", "stands", "exposed"],
);

/// The environment as SH vectors, and analytic lights: [`crate::Light`].
pub const LIGHT: Resource = given("light", "SH vector and emitters", &["lighting", "emitters"]);

/// The environment as a map: [`crate::EnvironmentMap`].
pub const ENVIRONMENT: Resource = given(
    "environment",
    "linear Rec.709 radiance of a texel",
    &["environment"],
);

/// Spots, points and suns: [`crate::PunctualLight`].
pub const PUNCTUAL_LIGHTS: Resource = given(
    "punctual lights",
    "light, and views from it",
    &["source", "lights", "views", "view"],
);

/// How near what is seen from lights with sharp shadows is. A GPU keeps it with the pass that makes it.
pub const NEARNESS: Resource = Resource::made(
    "nearness",
    "one over depth, or height above the farthest plane",
    Some(Domain::Views),
    (0, &["nearest", "coarse"]),
);

/// What each sphere sends on. A GPU keeps it with the pass that gathers it.
pub const EMISSION: Resource = Resource::made(
    "emission",
    "SH vector a channel",
    Some(Domain::Spheres),
    (0, &["emission"]),
);

/// Functions in which the irradiance of bodies is told, and what is seen of their patches: [`crate::IrradianceBasis`].
pub const BASES: Resource = given(
    "bases",
    "function, patch and region",
    &["bodies", "duals", "sends", "owns", "lobes"],
);

/// What each patch sends on, and each region. A GPU keeps it with the pass that gathers it.
pub const PATCH_LIGHT: Resource = Resource::made(
    "patch light",
    "radiance, and an SH vector a region and channel",
    Some(Domain::Patches),
    (0, &["light"]),
);

/// Positions and normals to light: [`crate::Receiver`] records; and which of them lie together.
pub const RECEIVERS: Resource = Resource::made(
    "receivers",
    "position and normal",
    None,
    (32, &["receivers", "clusters"]),
);

/// Base colour of each receiver, linear Rec.709, and how metallic it is.
pub const ALBEDO: Resource = Resource::made(
    "albedo",
    "linear Rec.709 reflectance and metallic",
    None,
    (16, &["albedo"]),
);

/// Radiance that albedo 1 would reflect at each receiver; of those that mirror light, the mean of what they see in their lobe.
pub const RADIANCE: Resource = Resource::made(
    "radiance",
    "linear Rec.709 radiance",
    None,
    (16, &["radiance"]),
);

/// The share of its light that each receiver gets through the blockers; in the memory of its radiance.
pub const SHARE: Resource =
    Resource::made("share", "share of a channel", None, (16, &[])).within(RADIANCE);

/// Radiance of samples, where half resolution does for it; in the memory of their radiance.
pub const UPSAMPLED: Resource = Resource::made(
    "upsampled radiance",
    "linear Rec.709 radiance",
    None,
    (16, &["radiance"]),
)
.within(RADIANCE);

/// What bodies send to each receiver, where it is kept apart from other light.
pub const SENT: Resource =
    Resource::made("sent", "linear Rec.709 radiance", None, (16, &["radiance"]));

/// The picture.
pub const PICTURE: Resource = Resource::made(
    "picture",
    "linear Rec.709 radiance",
    Some(Domain::Pixels),
    (16, &["picture"]),
);

/// What a plan gives of every pixel besides the picture, row by row from the top: four whole numbers each, which the
/// resource's own documentation tells the meaning of.
pub type Given = HashMap<Resource, Vec<[u32; 4]>>;

/// Memory that the passes of a plan work in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Buffer {
    /// What is in it.
    pub name: Cow<'static, str>,
    /// Index of the pass that owns or writes it, in the plan.
    pub pass: usize,
    /// Its size.
    pub bytes: u64,
}
