//! Whether a plan gives what it is for.

use super::resource::RECEIVERS;
use super::{Access, Domain, PASSES, Pass, Plan, Planned, Resource};

/// Why a plan cannot be worked off.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PlanError {
    /// Nothing makes what a pass needs.
    #[error("the plan has no {missing} pass, which would give {wanting} its {resource}")]
    Missing {
        /// The passes that would do.
        missing: String,
        /// What is not there.
        resource: &'static str,
        /// What needs it.
        wanting: &'static str,
    },
    /// It gives something else than what is asked of it.
    #[error(
        "the plan gives {given}, but {wanted} is asked for: Plan::new plans a picture, Plan::of_receivers the radiance of receivers"
    )]
    Gives {
        /// What comes out of it.
        given: String,
        /// What should.
        wanted: &'static str,
    },
    /// A pass comes before what it needs.
    #[error(
        "the plan's passes are out of order: {before} needs the {resource} of {after}, which comes later"
    )]
    Order {
        /// What comes too early.
        before: &'static str,
        /// What comes too late.
        after: &'static str,
        /// What they have in common.
        resource: &'static str,
    },
}

impl Plan {
    /// Whether it gives a resource, and [`check`](Self::check).
    ///
    /// # Errors
    /// Where it gives something else, and as `check`.
    pub fn check_for(&self, wanted: Resource) -> Result<(), PlanError> {
        let given = self.gives.iter().map(|(given, _)| *given);
        if !given.clone().any(|given| given == wanted) {
            let names = given.map(|given| given.name);
            return Err(PlanError::Gives {
                given: names.collect::<Vec<_>>().join(", "),
                wanted: wanted.name,
            });
        }
        self.check()
    }

    /// Whether every pass finds what it reads, and what it is for comes out.
    ///
    /// # Errors
    /// The first thing that is missing or comes too late.
    pub fn check(&self) -> Result<(), PlanError> {
        for (index, pass) in self.passes.iter().enumerate() {
            for slot in pass.slots() {
                let what = slot.bound(pass.at);
                match slot.access {
                    Access::Read | Access::Modify => self.made((pass.name(), index), what)?,
                    // A turn before, whoever makes it may come later in the plan.
                    Access::ReadBefore => self.made((pass.name(), self.passes.len()), what)?,
                    Access::ReadIfAny | Access::Write | Access::Add => {}
                }
            }
        }
        let asked = ("the caller", self.passes.len());
        let mut gives = self.gives.iter();
        gives.try_for_each(|given| self.made(asked, *given))
    }

    /// Whether something is there when a pass asks for it.
    fn made(
        &self,
        (wanting, index): (&'static str, usize),
        what: (Resource, Domain),
    ) -> Result<(), PlanError> {
        let resource = what.0.name;
        if what.0.given || what == (RECEIVERS, Domain::Receivers) {
            return Ok(());
        }
        let makes = |planned: &&Planned| planned.pass.makes(planned.at, what);
        let (earlier, later) = self.passes.split_at(index);
        if earlier.iter().any(|planned| makes(&planned)) {
            return Ok(());
        }
        if let Some(after) = later.iter().find(makes) {
            return Err(PlanError::Order {
                before: wanting,
                after: after.name(),
                resource,
            });
        }
        let would = |pass: &&&Pass| Domain::ALL.iter().any(|at| pass.makes(*at, what));
        let mut names: Vec<&str> = PASSES.iter().filter(would).map(|pass| pass.name).collect();
        let last = names.pop().unwrap_or("such");
        let missing = match names.is_empty() {
            true => last.into(),
            false => format!("{} or {last}", names.join(", ")),
        };
        Err(PlanError::Missing {
            missing,
            resource,
            wanting,
        })
    }
}
