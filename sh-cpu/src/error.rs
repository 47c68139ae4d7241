//! What can be wrong with what a caller hands in.

/// Why a pass did not run. Nothing has been written then.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// An SH order without routines.
    #[error(transparent)]
    Order(#[from] sh_core::OrderError),
    /// An order of accumulation that there is not for a light.
    #[error(
        "logarithms of visibility for light of order {order} cannot be accumulated at order {accumulation}: orders {order} to 6 can"
    )]
    Accumulation {
        /// The light's order.
        order: usize,
        /// The order of accumulation asked for.
        accumulation: usize,
    },
    /// A light whose vector does not fit its order.
    #[error("a light of order {order} has {} coefficients, not {found}", order * order)]
    Coefficients {
        /// The light's order.
        order: usize,
        /// The number of coefficients it came with.
        found: usize,
    },
    /// A buffer of another length than the receivers it belongs to.
    #[error("{buffer} has {found} entries for {expected} samples: it needs one each")]
    Length {
        /// Which buffer.
        buffer: &'static str,
        /// Samples or pixels there are.
        expected: usize,
        /// Entries found.
        found: usize,
    },
    /// Clusters that leave receivers out or hold some twice.
    #[error(
        "cluster {index} holds receivers {} to {}, but it has to begin at {next}, where the one before it ends",
        range.start, range.end
    )]
    Clusters {
        /// Which cluster.
        index: usize,
        /// What it holds.
        range: std::ops::Range<usize>,
        /// Where it should begin.
        next: usize,
    },
    /// Baked log visibilities of another order or number than the pass needs.
    #[error(
        "there are {found} baked numbers, but {expected} are needed: {coefficients} for each receiver"
    )]
    Baked {
        /// Numbers needed.
        expected: usize,
        /// Numbers found.
        found: usize,
        /// Numbers a receiver.
        coefficients: usize,
    },
    /// A mesh, texture or transform of an object that contradicts itself.
    #[error("object {index} (\"{name}\"): {problem}")]
    Object {
        /// Index into the scene's objects.
        index: usize,
        /// The object's name.
        name: String,
        /// What is wrong and what would be right.
        problem: String,
    },
    /// A camera that sees nothing.
    #[error("the camera cannot be used: {problem}")]
    Camera {
        /// What is wrong and what would be right.
        problem: String,
    },
    /// A picture without pixels, or with more than fit.
    #[error(
        "a picture of {width} by {height} pixels cannot be made: each side must be 1 to {MAX_SIDE}"
    )]
    Size {
        /// Pixels across.
        width: u32,
        /// Pixels down.
        height: u32,
    },
    /// An environment map whose pixels do not fit its size.
    #[error("an environment map of {width} by {height} texels has {found} pixels")]
    Environment {
        /// Texels across.
        width: u32,
        /// Texels down.
        height: u32,
        /// Pixels found.
        found: usize,
    },
    /// A plan that cannot be worked off.
    #[error(transparent)]
    Plan(#[from] sh_scene::PlanError),
    /// A pass that is not in the table.
    #[error("the pass {pass} is not one that the CPU has")]
    NoTwin {
        /// Its name.
        pass: &'static str,
    },
    /// A pass that looks through a camera where there is none.
    #[error("a pass needs a camera, but receivers are the caller's")]
    NoCamera,
    /// Settings that give no light.
    #[error(transparent)]
    Light(#[from] sh_scene::LightError),
}

/// Largest width and height of a picture, in pixels.
pub const MAX_SIDE: u32 = 16_384;
