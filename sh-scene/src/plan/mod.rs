//! The plan of a frame: the passes a scene calls for, why, what they read and write, and what is left out.
//!
//! A pass that is not in the plan costs nothing: no dispatch, no memory, no shader. A backend looks
//! through the list and does what it names, in order. New passes enter as one more [`PassKind`] and, where
//! they make something new (a light view, an array of depths, a picture at half resolution), one more
//! [`Resource`] with its [`Resolution`]; what is here stays as it is.
//!
//! The plan is a function of the scene and its settings alone, so that an effect that is added and taken away again
//! leaves no trace. What needs no work in a frame because nothing has changed is told by [`crate::Tracker`].

mod reasons;
mod resources;
mod shaders;

pub use resources::{Buffer, Resolution, Resource};
pub use shaders::Shader;

use crate::Scene;
use reasons::Called;
use std::fmt;

/// The passes there are. Each is one file of this name in `kernels`, `sh-cpu` and `sh-gpu`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PassKind {
    /// Position, normal and albedo per sample.
    Gbuffer,
    /// Light without blockers.
    Irradiance,
    /// Light through the visibility of all blocker spheres.
    Shadow,
    /// What the spheres of bodies send on of the light that falls on the surface around them, bounce by bounce.
    LightUpdate,
    /// The light that spheres have sent on, added to radiance.
    LightGather,
    /// Radiance at half resolution to samples, by a joint bilateral filter; what that cannot give is shaded anew.
    Upsample,
    /// Samples to pixels: radiance times albedo, the environment where nothing is hit.
    Resolve,
}

impl PassKind {
    /// The name that files, tables and messages use.
    pub fn name(self) -> &'static str {
        match self {
            Self::Gbuffer => "gbuffer",
            Self::Irradiance => "irradiance",
            Self::Shadow => "shadow",
            Self::LightUpdate => "light_update",
            Self::LightGather => "light_gather",
            Self::Upsample => "upsample",
            Self::Resolve => "resolve",
        }
    }
}

/// One pass and why this scene needs it.
#[derive(Clone, Debug, PartialEq)]
pub struct Pass {
    /// Which.
    pub kind: PassKind,
    /// How many elements it computes.
    pub at: Resolution,
    /// Why it is in the plan, for a person: a sentence.
    pub reason: String,
}

impl Pass {
    /// What the pass reads.
    pub fn reads(&self) -> &'static [Resource] {
        use Resource::*;
        let half = self.at == Resolution::Halves;
        match self.kind {
            PassKind::Gbuffer => &[Surfaces],
            PassKind::Irradiance => &[Receivers, Light],
            PassKind::Shadow if half => &[HalfReceivers, Blockers, Light],
            PassKind::Shadow => &[Receivers, Blockers, Light],
            PassKind::LightUpdate => &[SurfacePoints, Blockers, Light],
            PassKind::LightGather if half => &[HalfReceivers, HalfRadiance, Blockers, Emission],
            PassKind::LightGather => &[Receivers, Radiance, Blockers, Emission],
            PassKind::Upsample => &[HalfReceivers, HalfRadiance, Receivers, Blockers, Light],
            PassKind::Resolve => &[Receivers, Albedo, Radiance, Environment],
        }
    }

    /// What the pass writes.
    pub fn writes(&self) -> &'static [Resource] {
        use Resource::*;
        let half = self.at == Resolution::Halves;
        match self.kind {
            PassKind::Gbuffer if half => &[HalfReceivers],
            PassKind::Gbuffer => &[Receivers, Albedo],
            PassKind::Shadow | PassKind::LightGather if half => &[HalfRadiance],
            PassKind::LightUpdate => &[Emission],
            PassKind::LightGather => &[Radiance],
            PassKind::Irradiance | PassKind::Shadow | PassKind::Upsample => &[Radiance],
            PassKind::Resolve => &[Picture],
        }
    }
}

/// Something that a scene does without, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct LeftOut {
    /// What: the name of a pass, or of a part of one.
    pub name: &'static str,
    /// Why there is no work for it, for a person: a sentence.
    pub reason: String,
}

/// The passes of a frame, in order, and the shaders they are made of.
///
/// ```
/// # use sh_scene::*;
/// # fn plan_of(scene: &Scene) {
/// let plan = Plan::new(scene);
/// for pass in &plan.passes {
///     println!("{}: {}", pass.kind.name(), pass.reason);
/// }
/// for left in &plan.left_out {
///     println!("no {}: {}", left.name, left.reason);
/// }
/// # }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// In the order they run.
    pub passes: Vec<Pass>,
    /// What this scene does without: nothing is computed, set aside or compiled for it.
    pub left_out: Vec<LeftOut>,
    /// The pipelines that the passes are made of on a GPU, each once.
    pub shaders: Vec<Shader>,
}

impl Plan {
    /// The passes that `scene` needs.
    pub fn new(scene: &Scene) -> Self {
        let called = Called::of(scene);
        let mut passes = Vec::new();
        let mut add = |kind, at, reason: String| passes.push(Pass { kind, at, reason });
        if let Some((update, _)) = &called.bounce {
            add(PassKind::LightUpdate, Resolution::Spheres, update.clone());
        }
        if called.half {
            let reason = "Soft light changes little from pixel to pixel: a ray for every two by two is enough.";
            add(PassKind::Gbuffer, Resolution::Halves, reason.to_string());
            add(PassKind::Shadow, Resolution::Halves, called.shadow());
            if let Some((_, gather)) = &called.bounce {
                add(PassKind::LightGather, Resolution::Halves, gather.clone());
            }
        }
        add(PassKind::Gbuffer, Resolution::Samples, called.gbuffer());
        if called.half {
            let reason = "Samples take the light of their surface from half resolution; edges and small folds are shaded by themselves.";
            add(PassKind::Upsample, Resolution::Samples, reason.to_string());
        } else if called.shadows {
            add(PassKind::Shadow, Resolution::Samples, called.shadow());
        } else {
            let reason = called.irradiance();
            add(PassKind::Irradiance, Resolution::Samples, reason);
        }
        if let (Some((_, gather)), false) = (&called.bounce, called.half) {
            add(PassKind::LightGather, Resolution::Samples, gather.clone());
        }
        add(
            PassKind::Resolve,
            Resolution::Pixels,
            "Lit samples become pixels, with the environment behind them.".to_string(),
        );
        Self {
            shaders: shaders::of(&passes, &called),
            left_out: called.left_out(),
            passes,
        }
    }

    /// Whether any pass looks at blockers: without one there is no tree of them.
    pub fn is_blocked(&self) -> bool {
        self.has(PassKind::Shadow) || self.has(PassKind::LightUpdate)
    }

    /// Whether a pass of this kind is in the plan.
    pub fn has(&self, kind: PassKind) -> bool {
        self.passes.iter().any(|pass| pass.kind == kind)
    }
}

/// One line a pass: its name and why it is there.
impl fmt::Display for Plan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, pass) in self.passes.iter().enumerate() {
            let end = if i == 0 { "" } else { "\n" };
            write!(f, "{end}{:<10} {}", pass.kind.name(), pass.reason)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
