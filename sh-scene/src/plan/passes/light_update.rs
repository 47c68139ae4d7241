//! What the spheres of bodies send on of the light that falls on the surface around them, bounce by bounce.

use crate::plan::facts::counted;
use crate::plan::resource::{BLOCKERS, EMISSION, RADIANCE, SENT, SURFACE_POINTS};
use crate::plan::{Cost, Domain, Entry, Orders, Pass, Run, Slot};

/// Light that spheres send on: in the first turn of what falls on them without bodies' help, then of what bodies have sent
/// them in the turn before as well.
pub static LIGHT_UPDATE: Pass = Pass {
    name: "light_update",
    slots: |_| {
        vec![
            Slot::read(SURFACE_POINTS),
            Slot::read(BLOCKERS),
            Slot::read(RADIANCE).of(Domain::Points),
            Slot::read(SENT).of(Domain::Points).named(&["gathered"]),
            Slot::write(EMISSION),
        ]
    },
    wanted: |facts| {
        let lights = facts.senders?;
        let bounces = counted(facts.bounces() as usize, "bounce", "bounces");
        let spheres = counted(lights, "sphere sends", "spheres send");
        let reason = format!("{spheres} on what falls on the surface around them, for {bounces}.");
        Ok(vec![Run::in_turns(
            Domain::Spheres,
            0..facts.bounces(),
            reason,
        )])
    },
    entries: |_| {
        let own = ["project", "raise"];
        own.map(|name| Entry::new("light_update", name, Orders::Light))
            .into()
    },
    cost: |units| Cost {
        multiply_adds: units.send,
        nanoseconds: 0.0,
    },
};
