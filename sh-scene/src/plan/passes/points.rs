//! Points on bodies' surfaces, to be lit.

use crate::plan::facts::counted;
use crate::plan::resource::{RECEIVERS, SENT, SURFACE_POINTS};
use crate::plan::{Cost, Domain, Entry, Orders, Pass, Run, Slot};

/// Points of the surface around each sphere where their body is now, as receivers, which bodies have sent nothing to yet.
pub static POINTS: Pass = Pass {
    name: "points",
    slots: |_| {
        vec![
            Slot::read(SURFACE_POINTS),
            Slot::write(RECEIVERS).of(Domain::Points),
            // By the host, which clears it.
            Slot::write(SENT).of(Domain::Points).named(&[]),
        ]
    },
    wanted: |facts| {
        facts.senders?;
        let count = counted(facts.points, "point", "points");
        let reason = format!("{count} on bodies' surfaces tell what falls on them.");
        Ok(vec![Run::once(Domain::Points, reason)])
    },
    entries: |_| vec![Entry::new("light_update", "place", Orders::Light)],
    cost: |_| Cost {
        multiply_adds: 30.0,
        nanoseconds: 0.0,
    },
};
