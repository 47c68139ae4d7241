//! Points on bodies' surfaces, to be lit.

use crate::plan::facts::counted;
use crate::plan::resource::{BASES, RECEIVERS, SENT, SURFACE_POINTS};
use crate::plan::{Cost, Domain, Entry, Orders, Pass, Run, Slot};

/// Points of the surface around each sphere, or of each patch, where their body is now, as receivers, which bodies have sent
/// nothing to yet.
pub static POINTS: Pass = Pass {
    name: "points",
    slots: |at| {
        let (surface, of) = match at {
            Domain::Patches => (Slot::read(BASES).named(&["bodies", "points"]), at),
            _ => (Slot::read(SURFACE_POINTS), Domain::Points),
        };
        vec![
            surface,
            Slot::write(RECEIVERS).of(of),
            // By the host, which clears it.
            Slot::write(SENT).of(of).named(&[]),
        ]
    },
    wanted: |facts| {
        if let (Err(why), Err(_)) = (facts.senders, facts.patched) {
            return Err(why.into());
        }
        let run = |at| {
            let [count, whose] = match at {
                Domain::Patches => [facts.patches, 1],
                _ => [facts.points, 0],
            };
            let count = counted(count, "point", "points");
            let whose = ["bodies' surfaces tell", "patches tell"][whose];
            Run::once(at, format!("{count} on {whose} what falls on them."))
        };
        Ok(facts.lit_points().into_iter().map(run).collect())
    },
    entries: |facts| {
        let of = |at| match at {
            Domain::Patches => Entry::new("basis_update", "place", Orders::Light),
            _ => Entry::new("light_update", "place", Orders::Light),
        };
        facts.lit_points().into_iter().map(of).collect()
    },
    cost: |_| Cost {
        multiply_adds: 30.0,
        nanoseconds: 0.0,
    },
};
