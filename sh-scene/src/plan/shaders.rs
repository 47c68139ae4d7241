//! The pipelines of a plan: which entry point, of which orders, with which parts switched off for good.

use super::{Entry, Facts, Orders, Planned};
use std::fmt;

/// One pipeline: an entry point of a pass's kernel, specialised. No kernel asks at run time what a plan knows.
///
/// ```
/// # use sh_scene::*;
/// # fn shaders_of(scene: &Scene) {
/// for shader in &Plan::new(scene).shaders {
///     println!("{shader}"); // shadow, order 4, without LAMPS
/// }
/// # }
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Shader {
    /// The kernel: a file in `kernels`; its text, of these orders, is one shader module.
    pub kernel: &'static str,
    /// The entry point; `body` and `ground` are a vertex and a fragment stage.
    pub entry: &'static str,
    /// SH order of the light; none where the kernel has none.
    pub order: Option<usize>,
    /// SH order of accumulation; none where nothing is accumulated.
    pub accumulation: Option<usize>,
    /// The kernel's override constants, by name.
    pub constants: Vec<(&'static str, bool)>,
}

impl Shader {
    /// What tells its module from others: pipelines that agree here share one.
    pub fn module(&self) -> (&'static str, Option<usize>, Option<usize>) {
        (self.kernel, self.order, self.accumulation)
    }
}

/// Entry point, orders and what is switched off.
impl fmt::Display for Shader {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.entry)?;
        if let Some(order) = self.order {
            write!(f, ", order {order}")?;
        }
        if let Some(accumulation) = self.accumulation.filter(|a| Some(*a) != self.order) {
            write!(f, ", accumulated in {accumulation}")?;
        }
        for (name, on) in &self.constants {
            write!(f, ", {} {name}", if *on { "with" } else { "without" })?;
        }
        Ok(())
    }
}

/// The pipelines that passes need, each once, in the order of their first use.
pub(super) fn of(passes: &[Planned], facts: &Facts) -> Vec<Shader> {
    let mut all: Vec<Shader> = Vec::new();
    for entry in passes
        .iter()
        .flat_map(|planned| (planned.pass.entries)(facts))
    {
        let shader = specialised(entry, facts);
        if !all.contains(&shader) {
            all.push(shader);
        }
    }
    all
}

fn specialised(entry: Entry, facts: &Facts) -> Shader {
    let settings = facts.settings;
    Shader {
        kernel: entry.kernel,
        entry: entry.name,
        order: (entry.orders != Orders::None).then_some(settings.order),
        accumulation: (entry.orders == Orders::Both).then_some(settings.accumulation),
        constants: entry.constants,
    }
}
