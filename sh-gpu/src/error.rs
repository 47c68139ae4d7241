//! What can be wrong with what a host hands over.

/// Why a pass was not made, prepared or bound. Nothing has been recorded when one of these comes back.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// There are no kernels for this order.
    #[error("SH order {0} is not supported: orders 2 to 6 are")]
    Order(usize),
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
    /// More analytic lights than the pass has room for.
    #[error("{count} analytic lights do not fit the {capacity} that the pass was made for")]
    Emitters {
        /// How many came.
        count: usize,
        /// How many fit.
        capacity: u32,
    },
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
    /// A plan that makes no picture.
    #[error("the plan {0}")]
    Plan(&'static str),
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

impl Error {
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
