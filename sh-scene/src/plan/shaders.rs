//! The pipelines of a plan: which entry point, of which orders, with which parts switched off for good.

use super::reasons::Called;
use super::{Pass, PassKind};
use crate::Blocking;
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
    /// The pass whose kernel it is of; its text, of these orders, is one shader module.
    pub pass: PassKind,
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
    pub fn module(&self) -> (PassKind, Option<usize>, Option<usize>) {
        (self.pass, self.order, self.accumulation)
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
pub(super) fn of(passes: &[Pass], called: &Called) -> Vec<Shader> {
    let lamps = [
        ("LAMPS", called.lamps > 0),
        ("DISTRIBUTIONS", called.uneven > 0),
    ];
    let mut all: Vec<Shader> = Vec::new();
    for pass in passes {
        let mut add = |kind, entry, constants: &[(&'static str, bool)]| {
            let shader = specialised(kind, entry, constants.to_vec(), called);
            if !all.contains(&shader) {
                all.push(shader);
            }
        };
        let kind = pass.kind;
        match kind {
            PassKind::Gbuffer => {
                if called.drawn > 0 {
                    add(kind, "body", &[]);
                }
                if called.scene.ground.is_some() {
                    add(kind, "ground", &[]);
                }
                add(kind, "pack", &[]);
            }
            PassKind::Irradiance => add(kind, "irradiance", &lamps),
            PassKind::Shadow => add(kind, "shadow", &lamps),
            PassKind::LightUpdate => {
                add(PassKind::Shadow, "shadow", &lamps);
                for entry in ["place", "project", "raise"] {
                    add(kind, entry, &[]);
                }
            }
            PassKind::LightGather => {
                let blocking = called.settings.indirect.unwrap_or_default().blocking;
                let entry = match blocking {
                    Blocking::Discs => "gather_discs",
                    Blocking::Runs | Blocking::Sphere | Blocking::Object => "gather_sums",
                };
                let by_bodies = [("BY_BODIES", blocking == Blocking::Object)];
                let discs = blocking == Blocking::Discs;
                add(kind, entry, if discs { &[] } else { &by_bodies });
            }
            PassKind::Upsample => {
                let sent = ("SENT", called.bounce.is_some());
                add(PassKind::Shadow, "shadow", &lamps);
                add(kind, "shares", &lamps);
                add(kind, "upsample", &[lamps[0], lamps[1], sent]);
                add(kind, "scatter", &[]);
            }
            PassKind::Resolve => add(kind, "resolve", &[]),
        }
    }
    all
}

fn specialised(
    pass: PassKind,
    entry: &'static str,
    constants: Vec<(&'static str, bool)>,
    called: &Called,
) -> Shader {
    let settings = called.settings;
    let plain = matches!(pass, PassKind::Gbuffer | PassKind::Resolve);
    let accumulates = pass == PassKind::Shadow;
    Shader {
        pass,
        entry,
        order: (!plain).then_some(settings.order),
        accumulation: accumulates.then_some(settings.accumulation),
        constants,
    }
}
