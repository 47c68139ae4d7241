//! The light that spheres have sent on.

use crate::Blocking;
use crate::plan::resource::{BLOCKERS, EMISSION, RADIANCE, SENT};
use crate::plan::{Cost, Domain, Entry, Orders, Pass, Slot};

/// Light by way of spheres, added to radiance; kept apart from it at half resolution, where shadows are interpolated as a
/// share of their light, and for a caller's own receivers.
pub static LIGHT_GATHER: Pass = Pass {
    name: "light_gather",
    slots: |at| match at {
        Domain::Points | Domain::Patches => vec![
            Slot::receivers(at),
            Slot::read(BLOCKERS),
            Slot::read_before(EMISSION),
            Slot::add(SENT),
        ],
        Domain::Halves | Domain::Receivers => vec![
            Slot::receivers(at),
            Slot::read(BLOCKERS),
            Slot::read(EMISSION),
            Slot::add(SENT),
        ],
        _ => vec![
            Slot::receivers(at),
            Slot::read(BLOCKERS),
            Slot::read(EMISSION),
            Slot::modify(RADIANCE),
        ],
    },
    wanted: |facts| {
        facts.senders?;
        let hides = match facts.settings.indirect.unwrap_or_default().blocking {
            Blocking::Discs => {
                "each is a disc in the sky that nearer ones cover in part, in an order that is right whether bodies interlock or not"
            }
            Blocking::Runs => {
                "what is summed up for nearer spheres serves farther ones, and pairs are looked at one by one only where bodies interlock"
            }
            Blocking::Sphere => "every sphere is looked at with all that are nearer",
            Blocking::Object => "bodies hide each other as a whole",
        };
        let reason = format!("Bodies light each other and the ground; {hides}.");
        let mut runs = facts
            .bounced("What spheres send falls on the surfaces of others, to be sent on again.");
        let rest = "Edges and small folds gather what bodies send by themselves.";
        runs.extend(facts.seen(reason, rest));
        runs.extend(facts.gloss("Polished surfaces mirror what spheres send."));
        Ok(runs)
    },
    entries: |facts| {
        let entry = |name| Entry::new("light_gather", name, Orders::Light);
        facts.with_gloss(match facts.settings.indirect.unwrap_or_default().blocking {
            Blocking::Discs => entry("gather_discs"),
            Blocking::Runs | Blocking::Sphere => entry("gather_sums").with(&[("BY_BODIES", false)]),
            Blocking::Object => entry("gather_sums").with(&[("BY_BODIES", true)]),
        })
    },
    cost: |units| Cost {
        multiply_adds: units.gather,
        nanoseconds: 0.0,
    },
};
