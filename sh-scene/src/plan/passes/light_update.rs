//! What the spheres of bodies send on of the light that falls on the surface around them, bounce by bounce.

use crate::plan::facts::counted;
use crate::plan::resource::{BLOCKERS, EMISSION, LIGHT, SURFACE_POINTS};
use crate::plan::{Cost, Domain, Entry, Orders, Pass, Run, Slot};

/// Light that spheres send on.
pub static LIGHT_UPDATE: Pass = Pass {
    name: "light_update",
    slots: |_| {
        vec![
            Slot::read(SURFACE_POINTS),
            Slot::read(BLOCKERS),
            Slot::read(LIGHT),
            Slot::write(EMISSION),
        ]
    },
    wanted: |facts| {
        let lights = facts.senders?;
        let bounces = facts.settings.indirect.unwrap_or_default().bounces;
        let bounces = counted(bounces as usize, "bounce", "bounces");
        let spheres = counted(lights, "sphere sends", "spheres send");
        Ok(vec![Run {
            at: Domain::Spheres,
            reason: format!("{spheres} on what falls on the surface around them, for {bounces}."),
        }])
    },
    entries: |facts| {
        let lit = Entry::new("shadow", "shadow", Orders::Both).with(&facts.lamp_constants());
        let own = ["place", "project", "raise"];
        let own = own.map(|name| Entry::new("light_update", name, Orders::Light));
        [vec![lit], own.into()].concat()
    },
    cost: |units| Cost {
        multiply_adds: units.points
            * (units.shadow + (units.bounces - 1.0).max(0.0) * units.gather),
        nanoseconds: 0.0,
    },
};
