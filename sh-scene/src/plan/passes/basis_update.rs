//! What bodies send on of the light that falls on them, told in few functions, bounce by bounce.

use crate::BasisBody;
use crate::plan::facts::counted;
use crate::plan::resource::{BASES, PATCH_LIGHT, RADIANCE, SENT};
use crate::plan::{Cost, Domain, Entry, Orders, Pass, Run, Slot};

/// Weights of a body's functions: in the first turn of what falls on it without bodies' help, then of what bodies, it itself
/// among them, have sent it in the turn before as well; and what patches and regions send on then.
pub static BASIS_UPDATE: Pass = Pass {
    name: "basis_update",
    slots: |_| {
        vec![
            Slot::read(BASES),
            Slot::read(RADIANCE),
            Slot::read(SENT).named(&["gathered"]),
            Slot::write(PATCH_LIGHT),
        ]
    },
    wanted: |facts| {
        let Ok(count) = facts.patched else {
            return not_asked(facts.patched);
        };
        let bodies = || BasisBody::all(&facts.scene.objects);
        let counts = || bodies().map(|body| body.basis.count());
        let held = bodies().map(|body| body.basis.held(body.basis.count()));
        let functions = match [counts().min(), counts().max()].map(Option::unwrap_or_default) {
            [low, high] if low == high => format!("{low} functions"),
            [low, high] => format!("{low} to {high} functions"),
        };
        let bounces = counted(facts.bounces() as usize, "bounce", "bounces");
        let whose = counted(count, "body", "bodies");
        let least = 100.0 * held.fold(1.0, f32::min);
        let reason = format!(
            "{whose} of {functions}, which tell at least {least:.0} % of what they were found by, send on what falls on them, for {bounces}."
        );
        Ok(vec![Run::in_turns(
            Domain::Patches,
            0..facts.bounces(),
            reason,
        )])
    },
    entries: |_| {
        let own = ["weigh", "shine", "raise"];
        own.map(|name| Entry::new("basis_update", name, Orders::Light))
            .into()
    },
    cost: |units| Cost {
        multiply_adds: units.weigh,
        nanoseconds: 0.0,
    },
};

/// Why no body sends by patches, where somebody asked for it.
pub(super) fn not_asked(why: Result<usize, &str>) -> Result<Vec<Run>, String> {
    match why {
        Err(why) if !why.is_empty() => Err(why.into()),
        _ => Ok(Vec::new()),
    }
}
