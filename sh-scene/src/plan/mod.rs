//! The plan of a frame: the passes a scene calls for, why, what they read and write, and what is left out.
//!
//! A pass is a declaration ([`Pass`], one a file in `plan/passes`): what it reads and writes, where it runs, which facts of
//! a scene want it, the pipelines it needs, what it costs. [`PASSES`] lists them, and nothing else does. All that is asked
//! of a plan follows from that: the order of passes and what is missing ([`Plan::check`]), the steps that a backend works
//! off one after the other ([`Plan::steps`]), shaders, estimates, and what is left out and why. A pass that is not in the
//! plan costs nothing: no dispatch, no memory, no shader.
//!
//! The plan is a function of the scene and its settings alone, so that an effect that is added and taken away again
//! leaves no trace. What needs no work in a frame because nothing has changed is told by [`crate::Tracker`].

mod check;
mod facts;
mod order;
mod pass;
pub mod passes;
pub mod resource;
mod schedule;
mod shaders;

pub use check::PlanError;
pub use facts::Facts;
pub use pass::{Access, Cost, Entry, Orders, Pass, Run, Slot, Units};
pub use passes::PASSES;
pub use resource::{Buffer, Domain, Resource};
pub use schedule::{Part, Step};
pub use shaders::Shader;

use crate::Scene;
use std::fmt;
use std::ops::Range;

/// One pass of a plan, where it runs and why this scene needs it.
#[derive(Clone, Debug, PartialEq)]
pub struct Planned {
    /// Which.
    pub pass: &'static Pass,
    /// What it runs over.
    pub at: Domain,
    /// Why it is in the plan, for a person: a sentence.
    pub reason: String,
    /// The turns in which it runs.
    pub turns: Range<u32>,
}

impl Planned {
    /// Its name.
    pub fn name(&self) -> &'static str {
        self.pass.name
    }

    /// What it is bound to.
    pub fn slots(&self) -> Vec<Slot> {
        (self.pass.slots)(self.at)
    }

    /// Whether it is this pass.
    pub fn is(&self, pass: &Pass) -> bool {
        self.pass == pass
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
///     println!("{} over {}: {}", pass.name(), pass.at.name(), pass.reason);
/// }
/// for left in &plan.left_out {
///     println!("no {}: {}", left.name, left.reason);
/// }
/// # }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// In the order they run.
    pub passes: Vec<Planned>,
    /// What this scene does without: nothing is computed, set aside or compiled for it.
    pub left_out: Vec<LeftOut>,
    /// What comes out of it: what it is for first, then whatever was asked for besides.
    pub gives: Vec<(Resource, Domain)>,
    /// The pipelines that the passes are made of on a GPU, each once.
    pub shaders: Vec<Shader>,
}

impl Plan {
    /// The passes that a picture of `scene` needs.
    pub fn new(scene: &Scene) -> Self {
        Self::giving(scene, &[])
    }

    /// As [`new`](Self::new), with `more` that passes can tell of every pixel, if somebody asks.
    ///
    /// ```
    /// # use sh_scene::*;
    /// # fn plan_of(scene: &Scene, asked: Resource) {
    /// let plan = Plan::giving(scene, &[asked]);
    /// assert_eq!(plan.gives.len(), 2);
    /// # }
    /// ```
    pub fn giving(scene: &Scene, more: &[Resource]) -> Self {
        let facts = Facts {
            asked: more.to_vec(),
            ..Facts::of(scene, false)
        };
        Self::of(&facts)
    }

    /// The passes that light a caller's own receivers in `scene`: vertices, or whatever else is to be lit.
    pub fn of_receivers(scene: &Scene) -> Self {
        Self::of(&Facts::of(scene, true))
    }

    fn of(facts: &Facts) -> Self {
        let (mut passes, mut left_out) = (Vec::new(), Vec::new());
        for pass in PASSES {
            match (pass.wanted)(facts) {
                Ok(runs) => passes.extend(runs.into_iter().map(|run| Planned {
                    pass,
                    at: run.at,
                    reason: run.reason,
                    turns: run.turns,
                })),
                Err(reason) => left_out.push(LeftOut {
                    name: pass.name,
                    reason,
                }),
            }
        }
        left_out.extend(facts.left_out());
        let passes = order::sorted(passes);
        Self {
            shaders: shaders::of(&passes, facts),
            gives: match facts.brought {
                true => vec![(resource::RADIANCE, Domain::Receivers)],
                false => [resource::PICTURE]
                    .iter()
                    .chain(&facts.asked)
                    .map(|&resource| (resource, Domain::Pixels))
                    .collect(),
            },
            left_out,
            passes,
        }
    }

    /// What comes out of it beside what it is for.
    pub fn besides(&self) -> impl Iterator<Item = Resource> {
        self.gives.iter().skip(1).map(|(resource, _)| *resource)
    }

    /// Whether any pass looks at blockers: without one there is no tree of them.
    pub fn is_blocked(&self) -> bool {
        self.touches(resource::BLOCKERS)
    }

    /// Whether any pass reads or writes a resource, of whatever domain.
    pub fn touches(&self, resource: Resource) -> bool {
        let mut slots = self.passes.iter().flat_map(Planned::slots);
        slots.any(|slot| slot.resource == resource && slot.access != Access::ReadIfAny)
    }

    /// The first pass that makes a resource of a domain.
    pub fn maker(&self, resource: Resource, domain: Domain) -> Option<usize> {
        let makes = |planned: &Planned| planned.pass.makes(planned.at, (resource, domain));
        self.passes.iter().position(makes)
    }

    /// Whether a pass is in the plan.
    pub fn has(&self, pass: &Pass) -> bool {
        self.passes.iter().any(|planned| planned.is(pass))
    }

    /// Whether any pass runs over a domain.
    pub fn runs_over(&self, domain: Domain) -> bool {
        self.passes.iter().any(|planned| planned.at == domain)
    }
}

/// One line a pass: its name and why it is there.
impl fmt::Display for Plan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, pass) in self.passes.iter().enumerate() {
            let end = if i == 0 { "" } else { "\n" };
            write!(f, "{end}{:<10} {}", pass.name(), pass.reason)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
