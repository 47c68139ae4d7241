//! Position, normal and albedo of what a camera's rays meet.

use crate::plan::facts::counted;
use crate::plan::resource::{ALBEDO, RECEIVERS, SURFACES};
use crate::plan::{Cost, Domain, Entry, Orders, Pass, Run, Slot};

/// Receivers of a picture.
pub static GBUFFER: Pass = Pass {
    name: "gbuffer",
    slots: |at| match at {
        // Nobody asks for the albedo there.
        Domain::Halves => vec![Slot::read(SURFACES), Slot::write(RECEIVERS)],
        _ => vec![
            Slot::read(SURFACES),
            Slot::write(RECEIVERS),
            Slot::write(ALBEDO),
        ],
    },
    wanted: |facts| {
        if facts.brought {
            return Err("Receivers are the caller's: no camera looks for them.".into());
        }
        let bodies = counted(facts.scene.objects.len(), "object", "objects");
        let surfaces = match facts.scene.ground {
            Some(_) => format!("{bodies} and the ground"),
            None => bodies,
        };
        let mut runs = Vec::new();
        if facts.half {
            let reason = "Soft light changes little from pixel to pixel: a ray for every two by two is enough.";
            runs.push(Run::once(Domain::Halves, reason));
        }
        runs.push(Run::once(
            Domain::Samples,
            format!("The camera's rays have to find {surfaces}."),
        ));
        Ok(runs)
    },
    entries: |facts| {
        let there = [
            ("body", facts.drawn > 0),
            ("ground", facts.scene.ground.is_some()),
            ("pack", true),
        ];
        let there = there.into_iter().filter(|(_, there)| *there);
        there
            .map(|(name, _)| Entry::new("gbuffer", name, Orders::None))
            .collect()
    },
    cost: |_| Cost {
        multiply_adds: 0.0,
        nanoseconds: 450.0,
    },
};
