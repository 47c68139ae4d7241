//! The plan of a frame: the passes a scene calls for, and why.

/// The passes there are. Each is one file of this name in `kernels`, `sh-cpu` and `sh-gpu`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PassKind {
    /// Position, normal and albedo per sample.
    Gbuffer,
    /// Environment light without blockers.
    Irradiance,
    /// Environment light through the visibility of all blocker spheres.
    Shadow,
    /// Samples to pixels: radiance times albedo, the environment where nothing is hit.
    Resolve,
}

/// One pass and why this scene needs it.
#[derive(Clone, Debug, PartialEq)]
pub struct Pass {
    /// Which.
    pub kind: PassKind,
    /// Why it is in the plan, for a person.
    pub reason: String,
}

/// The passes of a frame, in order.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// In the order they run.
    pub passes: Vec<Pass>,
}
