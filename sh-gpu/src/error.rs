//! What can be wrong with what a host hands over.

/// Why a pass was not made, prepared or bound. Nothing has been recorded when one of these comes back.
///
/// ```
/// use sh_gpu::Error;
/// let error = Error::Blockers { count: 300, capacity: 256 };
/// assert_eq!(error.to_string(), "300 blocker spheres do not fit the 256 that the pass was made for");
/// let memory = wgpu::Error::OutOfMemory { source: "no device memory".into() };
/// assert_eq!(Error::from(memory), Error::OutOfMemory);
/// ```
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// There are no kernels for this order.
    #[error(transparent)]
    Order(#[from] sh_core::OrderError),
    /// There is no kernel that accumulates in this order for light of that one.
    #[error(
        "logarithms of visibility for light of order {order} cannot be accumulated at order {accumulation}: orders \
         {order} to 6 can"
    )]
    Accumulation {
        /// The order of the light.
        order: usize,
        /// The order of accumulation asked for.
        accumulation: usize,
    },
    /// The light has another order than the pass, or its coefficients do not fit its order.
    #[error(
        "the light has order {order} and {coefficients} coefficients, but the pass was made for order {expected}, \
         which has {}", .expected * .expected
    )]
    Light {
        /// The light's order.
        order: usize,
        /// How many coefficients it brings.
        coefficients: usize,
        /// The order of the pass.
        expected: usize,
    },
    /// More blockers than the pass has room for.
    #[error("{count} blocker spheres do not fit the {capacity} that the pass was made for")]
    Blockers {
        /// How many came.
        count: usize,
        /// How many fit.
        capacity: u32,
    },
    /// Bodies that do not have the spheres of the tree of blockers.
    #[error(
        "the bodies have {count} spheres, but the tree of blockers has {expected}; they have to be the same ones"
    )]
    Spheres {
        /// How many all bodies have together.
        count: usize,
        /// How many leaves the tree has.
        expected: usize,
    },
    /// Other points on bodies' surfaces than the pass was made for.
    #[error(
        "the bodies have {count} spheres with {points} surface points, but the pass was made for {spheres} with {expected}"
    )]
    Points {
        /// How many spheres there are.
        count: usize,
        /// How many points they have.
        points: usize,
        /// How many spheres there were.
        spheres: usize,
        /// How many points they had.
        expected: usize,
    },
    /// Bodies whose light is told in functions that the pass was not made for.
    #[error(
        "{bodies} bodies have {patches} patches, but the pass was made for {expected} with {made_for}, each with as many functions"
    )]
    Patches {
        /// How many bodies there are.
        bodies: usize,
        /// How many patches they have.
        patches: usize,
        /// How many bodies there were.
        expected: usize,
        /// How many patches they had.
        made_for: usize,
    },
    /// More analytic lights than the pass has room for.
    #[error("{count} analytic lights do not fit the {capacity} that the pass was made for")]
    Emitters {
        /// How many came.
        count: usize,
        /// How many fit.
        capacity: u32,
    },
    /// Other lights with sharp shadows than the pass was made for.
    #[error(
        "{lights} spots, points and suns have {views} views, but the passes were made for {expected} with {made_for}"
    )]
    Punctual {
        /// How many lights there are.
        lights: usize,
        /// How many pictures are taken from them.
        views: usize,
        /// How many lights there were.
        expected: usize,
        /// How many views they had.
        made_for: usize,
    },
    /// A light with sharp shadows that is none.
    #[error("{problem}")]
    PunctualLight {
        /// What is wrong with it.
        problem: String,
    },
    /// Lamps with a distribution, for a pass that was made without.
    #[error("an analytic light has a distribution, but the pass was made for even ones")]
    Distributions,
    /// A size goes over what the device was requested with.
    #[error("{what} needs {needed}, but the device's limit `{limit}` is {available}")]
    Limit {
        /// What is too large.
        what: &'static str,
        /// What it needs.
        needed: u64,
        /// The limit's name, as in `wgpu::Limits`.
        limit: &'static str,
        /// What there is.
        available: u64,
    },
    /// A buffer binding that a pass cannot use.
    #[error("the binding `{binding}` {problem}")]
    Binding {
        /// Which, as the kernel names it.
        binding: &'static str,
        /// What is wrong with it, and what would be right.
        problem: String,
    },
    /// A picture without pixels, or a camera without direction.
    #[error("the view of {width} by {height} pixels {problem}")]
    View {
        /// Pixels across.
        width: u32,
        /// Pixels down.
        height: u32,
        /// What is wrong with it, and what would be right.
        problem: &'static str,
    },
    /// A scene that does not match the one whose meshes were uploaded, or that contradicts itself.
    #[error("object {index} (`{name}`) {problem}")]
    Object {
        /// Index into the scene's objects.
        index: usize,
        /// The object's name.
        name: String,
        /// What is wrong with it, and what would be right.
        problem: String,
    },
    /// The number of objects changed since the meshes were uploaded.
    #[error("the scene has {count} objects, but the meshes of {uploaded} were uploaded")]
    Objects {
        /// How many the scene has now.
        count: usize,
        /// How many were uploaded.
        uploaded: usize,
    },
    /// A plan that cannot be worked off.
    #[error(transparent)]
    Plan(#[from] sh_scene::PlanError),
    /// A pass that the GPU does not have, or has made no room for.
    #[error("the GPU has no pass {pass} for this plan")]
    NoPass {
        /// Its name.
        pass: &'static str,
    },
    /// Something that no pass of the plan makes.
    #[error("no pass of this plan makes the {resource} that another one is bound to")]
    NoResource {
        /// What it is.
        resource: &'static str,
    },
    /// The device ran out of memory while it made what was asked for. What was made before stays usable.
    #[error("the device has no memory left for this; free some of it, or ask for less")]
    OutOfMemory,
    /// The device refused something: a buffer of another device, or one that was destroyed.
    #[error("the device refused this: {0}")]
    Validation(String),
    /// The device failed in a way of its own, as in compiling a shader.
    #[error("the device failed: {0}")]
    Internal(String),
    /// The device is gone, with everything on it.
    #[error("the device is lost: {0}")]
    DeviceLost(String),
    /// A G-buffer's texture, or the target, that a pass cannot use.
    #[error("the texture `{texture}` {problem}")]
    Texture {
        /// Which.
        texture: &'static str,
        /// What is wrong with it, and what would be right.
        problem: String,
    },
    /// Vertices that are not where they are said to be.
    #[error("the vertices {0}")]
    Vertices(String),
    /// An environment map whose texels do not fill it.
    #[error("the environment map of {width} by {height} texels brings {texels}")]
    Environment {
        /// Texels across.
        width: u32,
        /// Texels down.
        height: u32,
        /// Texels there are.
        texels: usize,
    },
    /// An environment map in the place of one that has another size.
    #[error(
        "the environment map has {} by {} texels, but the one that was uploaded has {} by {}",
        size[0], size[1], uploaded[0], uploaded[1]
    )]
    EnvironmentSize {
        /// Texels across and down.
        size: [u32; 2],
        /// Those of the map that it would replace.
        uploaded: [u32; 2],
    },
}

impl From<sh_scene::LightError> for Error {
    fn from(error: sh_scene::LightError) -> Self {
        Self::PunctualLight {
            problem: error.to_string(),
        }
    }
}

impl From<wgpu::Error> for Error {
    fn from(error: wgpu::Error) -> Self {
        match error {
            wgpu::Error::OutOfMemory { .. } => Self::OutOfMemory,
            wgpu::Error::Validation { description, .. } => Self::Validation(description),
            wgpu::Error::Internal { description, .. } => Self::Internal(description),
        }
    }
}

impl Error {
    /// For a device that shows no memory any more, and does not say why.
    pub(crate) fn lost() -> Self {
        Self::DeviceLost("it was destroyed, or its driver gave up".into())
    }

    /// `Ok` where `needed` is within the limit.
    pub(crate) fn within(
        what: &'static str,
        needed: u64,
        limit: &'static str,
        available: u64,
    ) -> Result<(), Self> {
        if needed <= available {
            return Ok(());
        }
        Err(Self::Limit {
            what,
            needed,
            limit,
            available,
        })
    }
}
