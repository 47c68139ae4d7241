//! The contract of a pass, as data: everything that is asked of it before it runs.

use super::facts::Facts;
use super::resource::{Domain, Resource};
use std::fmt;
use std::ops::Range;

/// One pass: a value of this type in a file of its own in `plan/passes`, a kernel and its twin of that name.
pub struct Pass {
    /// The name that files, tables and messages use.
    pub name: &'static str,
    /// What it reads and writes where it runs over a domain.
    pub slots: fn(Domain) -> Vec<Slot>,
    /// Where a scene wants it to run, and why; or why there is no work for it, in a sentence. No runs:
    /// nobody asked for it, which is nothing that a scene does without.
    pub wanted: fn(&Facts) -> Result<Vec<Run>, String>,
    /// The pipelines that it needs on a GPU.
    pub entries: fn(&Facts) -> Vec<Entry>,
    /// What one element of its domain costs.
    pub cost: fn(&Units) -> Cost,
}

impl Pass {
    /// Whether it makes a resource of a domain where it runs `at` one.
    pub fn makes(&self, at: Domain, what: (Resource, Domain)) -> bool {
        let slots = (self.slots)(at);
        let mut made = slots.iter().filter(|slot| slot.access.makes());
        made.any(|slot| slot.bound(at) == what)
    }
}

/// Passes are told apart by name.
impl PartialEq for Pass {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for Pass {}

impl fmt::Debug for Pass {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "pass {}", self.name)
    }
}

/// A domain that a pass runs over, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// What it runs over.
    pub at: Domain,
    /// Why it is in the plan: a sentence for a person.
    pub reason: String,
    /// Those turns of its domain's phase in which it runs. The passes of a turn are done before the next begins.
    pub turns: Range<u32>,
}

impl Run {
    /// In the first turn, which is the only one where nothing is done again.
    pub fn once(at: Domain, reason: impl Into<String>) -> Self {
        Self::in_turns(at, 0..1, reason)
    }

    /// In these turns.
    pub fn in_turns(at: Domain, turns: Range<u32>, reason: impl Into<String>) -> Self {
        let reason = reason.into();
        Self { at, reason, turns }
    }
}

/// What a pass does with a resource.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// Needs it.
    Read,
    /// Needs it where there is such a thing.
    ReadIfAny,
    /// Needs it as the turn before has left it.
    ReadBefore,
    /// Makes it.
    Write,
    /// Needs it and changes it in place.
    Modify,
    /// Adds to it; the first that does finds 0.
    Add,
}

impl Access {
    /// Whether the resource is there after it.
    pub fn makes(self) -> bool {
        matches!(self, Self::Write | Self::Add)
    }
}

/// A resource that a pass is bound to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slot {
    /// What it is.
    pub resource: Resource,
    /// Whose it is; none where it is that of the pass's own domain.
    pub of: Option<Domain>,
    /// What is done with it.
    pub access: Access,
    /// What the pass's kernel calls it, or the parts of it.
    pub bindings: &'static [&'static str],
}

impl Slot {
    const fn new(resource: Resource, access: Access) -> Self {
        let of = resource.domain;
        Self {
            resource,
            of,
            access,
            bindings: resource.bindings,
        }
    }

    /// Reads a resource.
    pub const fn read(resource: Resource) -> Self {
        Self::new(resource, Access::Read)
    }

    /// Reads the receivers that a pass runs over.
    pub fn receivers(at: Domain) -> Self {
        Self::read(super::resource::RECEIVERS).of(at.receivers())
    }

    /// Reads a resource where there is one.
    pub const fn read_if_any(resource: Resource) -> Self {
        Self::new(resource, Access::ReadIfAny)
    }

    /// Reads a resource as the turn before has left it.
    pub const fn read_before(resource: Resource) -> Self {
        Self::new(resource, Access::ReadBefore)
    }

    /// Makes a resource.
    pub const fn write(resource: Resource) -> Self {
        Self::new(resource, Access::Write)
    }

    /// Changes a resource in place.
    pub const fn modify(resource: Resource) -> Self {
        Self::new(resource, Access::Modify)
    }

    /// Adds to a resource; the first pass that does finds 0.
    pub const fn add(resource: Resource) -> Self {
        Self::new(resource, Access::Add)
    }

    /// The same of another set of receivers than the pass runs over.
    pub const fn of(self, domain: Domain) -> Self {
        Self {
            of: Some(domain),
            ..self
        }
    }

    /// By other names in the pass's kernel.
    pub const fn named(self, bindings: &'static [&'static str]) -> Self {
        Self { bindings, ..self }
    }

    /// Which resource of which domain it is for a pass that runs `at` one.
    pub fn bound(&self, at: Domain) -> (Resource, Domain) {
        (self.resource, self.of.unwrap_or(at))
    }
}

/// Which SH orders a kernel's text is made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Orders {
    /// It has none.
    None,
    /// That of the light.
    Light,
    /// That of the light and that of accumulation.
    Both,
}

/// An entry point of a kernel, with what is switched on or off in it for good.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// The kernel: a file in `kernels`.
    pub kernel: &'static str,
    /// The entry point.
    pub name: &'static str,
    /// What its text depends on.
    pub orders: Orders,
    /// Override constants.
    pub constants: Vec<(&'static str, bool)>,
}

impl Entry {
    /// Without constants.
    pub fn new(kernel: &'static str, name: &'static str, orders: Orders) -> Self {
        let constants = Vec::new();
        Self {
            kernel,
            name,
            orders,
            constants,
        }
    }

    /// With these constants as well.
    pub fn with(mut self, constants: &[(&'static str, bool)]) -> Self {
        self.constants.extend(constants);
        self
    }
}

/// What parts of a receiver's work cost in a scene, in multiply-adds; and what there is of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Units {
    /// Light in the open.
    pub open: f64,
    /// Light through all blockers of a cut.
    pub shadow: f64,
    /// What spheres send to it.
    pub gather: f64,
    /// What a sphere makes of the light on its points.
    pub send: f64,
    /// What patches send to it.
    pub patches: f64,
    /// What a patch's part of its body's functions is.
    pub weigh: f64,
}

/// What an element of a pass's domain costs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cost {
    /// Multiply-adds in vector lanes.
    pub multiply_adds: f64,
    /// Nanoseconds of one thread besides, on an x86-64 of 2023.
    pub nanoseconds: f64,
}
