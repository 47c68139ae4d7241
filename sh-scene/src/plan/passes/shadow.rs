//! Light through the visibility of all blocker spheres.

use crate::plan::facts::counted;
use crate::plan::resource::{BLOCKERS, LIGHT, RADIANCE, RECEIVERS};
use crate::plan::{Cost, Domain, Entry, Orders, Pass, Run, Slot};

/// Shadowed light.
pub static SHADOW: Pass = Pass {
    name: "shadow",
    slots: |_| {
        vec![
            Slot::read(RECEIVERS),
            Slot::read(BLOCKERS),
            Slot::read(LIGHT),
            Slot::write(RADIANCE),
        ]
    },
    wanted: |facts| {
        if !facts.settings.shadows {
            return Err("Shadows are switched off.".into());
        }
        if !facts.shadows {
            return Err("Nothing in the scene has blocker spheres.".into());
        }
        let spheres = counted(facts.blockers, "blocker sphere", "blocker spheres");
        let accumulation = facts.settings.accumulation;
        let accumulated = match accumulation == facts.settings.order {
            true => String::new(),
            false => format!(", whose logarithms are accumulated in order {accumulation}"),
        };
        let first = format!(
            "{} is cast into shadow by {spheres}{accumulated}.",
            facts.light()
        );
        if !facts.half {
            return Ok(vec![Run {
                at: facts.finest(),
                reason: first,
            }]);
        }
        let rest = "Edges and small folds, for which half resolution does not do, are shaded by themselves.";
        Ok(vec![
            Run {
                at: Domain::Halves,
                reason: first,
            },
            Run {
                at: Domain::Rest,
                reason: rest.into(),
            },
        ])
    },
    entries: |facts| {
        let entry = Entry::new("shadow", "shadow", Orders::Both);
        vec![entry.with(&facts.lamp_constants())]
    },
    cost: |units| Cost {
        multiply_adds: units.shadow,
        nanoseconds: 0.0,
    },
};
