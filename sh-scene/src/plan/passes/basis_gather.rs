//! The light that patches have sent on.

use super::basis_update::not_asked;
use crate::plan::resource::{BASES, BLOCKERS, PATCH_LIGHT, RADIANCE, SENT};
use crate::plan::{Cost, Domain, Entry, Orders, Pass, Slot};

/// Light by way of patches, added to radiance; kept apart from it at half resolution, where shadows are interpolated as a
/// share of their light, and for a caller's own receivers.
pub static BASIS_GATHER: Pass = Pass {
    name: "basis_gather",
    slots: |at| {
        let sent = match at {
            Domain::Points | Domain::Patches | Domain::Halves | Domain::Receivers => {
                Slot::add(SENT)
            }
            _ => Slot::modify(RADIANCE),
        };
        let light = match at {
            Domain::Points | Domain::Patches => Slot::read_before(PATCH_LIGHT),
            _ => Slot::read(PATCH_LIGHT),
        };
        vec![
            Slot::receivers(at),
            Slot::read(BLOCKERS),
            Slot::read(BASES).named(&["bodies", "patches", "regions"]),
            light.of(Domain::Patches),
            sent,
        ]
    },
    wanted: |facts| {
        if facts.patched.is_err() {
            return not_asked(facts.patched);
        }
        let reason = "Bodies light each other and the ground; of each patch is seen what its own body and the discs of nearer spheres leave of it.";
        let mut runs = facts.bounced(
            "What patches send falls on the surfaces of other bodies, to be sent on again.",
        );
        let rest = "Edges and small folds gather what bodies send by themselves.";
        runs.extend(facts.seen(reason, rest));
        runs.extend(facts.gloss("Polished surfaces mirror what patches send."));
        Ok(runs)
    },
    entries: |facts| {
        let entry = |own| {
            let entry = Entry::new("basis_gather", "gather", Orders::Light);
            entry.with(&[("OWN_LIGHT", own)])
        };
        let mut all = facts.with_gloss(entry(true));
        // Points of patches have what their own body gives them in their weights.
        if facts.bounces() > 1 {
            all.push(entry(false).with(&[("GLOSS", false)]));
        }
        all
    },
    cost: |units| Cost {
        multiply_adds: units.patches,
        nanoseconds: 0.0,
    },
};
