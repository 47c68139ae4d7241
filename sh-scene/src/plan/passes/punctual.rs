//! The light of spots, points and suns.

use crate::plan::facts::counted;
use crate::plan::resource::{NEARNESS, PUNCTUAL_LIGHTS, RADIANCE};
use crate::plan::{Cost, Domain, Entry, Orders, Pass, Run, Slot};

/// Light with sharp shadows, added to radiance, at full resolution.
pub static PUNCTUAL: Pass = Pass {
    name: "punctual",
    slots: |at| {
        vec![
            Slot::receivers(at),
            Slot::read(PUNCTUAL_LIGHTS).named(&["source", "lights", "views"]),
            Slot::read_if_any(NEARNESS).of(Domain::Views),
            Slot::modify(RADIANCE),
        ]
    },
    wanted: |facts| {
        if facts.punctual == 0 {
            return Err("There is no spot, point or sun.".into());
        }
        let lights = counted(
            facts.punctual,
            "spot, point or sun",
            "spots, points and suns",
        );
        let shadows = match facts.views() {
            true => "whose shadows are as sharp as their size makes them",
            false => "which nothing hides",
        };
        let mut runs = Vec::new();
        for at in facts.lit_points() {
            let reason = "Bodies send on what spots, points and suns give them.";
            runs.push(Run::once(at, reason));
        }
        let reason = format!("{lights}, {shadows}, light what is seen.");
        runs.push(Run::once(facts.finest(), reason));
        runs.extend(facts.gloss("Polished surfaces mirror spots, points and suns as highlights."));
        Ok(runs)
    },
    entries: |facts| {
        let entry = Entry::new("punctual", "punctual", Orders::Light);
        facts.with_gloss(entry.with(&[("VIEWS", facts.views())]))
    },
    cost: |_| Cost {
        multiply_adds: 0.0,
        nanoseconds: 150.0,
    },
};
