//! Light through the visibility of all blocker spheres.

use crate::plan::facts::counted;
use crate::plan::resource::{BLOCKERS, LIGHT, RADIANCE};
use crate::plan::{Cost, Entry, Orders, Pass, Run, Slot};

/// Shadowed light.
pub static SHADOW: Pass = Pass {
    name: "shadow",
    slots: |at| {
        vec![
            Slot::receivers(at),
            Slot::read(BLOCKERS),
            Slot::read(LIGHT),
            Slot::write(RADIANCE),
        ]
    },
    wanted: |facts| {
        let mut runs = Vec::new();
        for at in facts.lit_points() {
            let reason = "Of the light on bodies' surfaces, other bodies leave a part.";
            runs.push(Run::once(at, reason));
        }
        if let Some(why) = facts.unblocked() {
            // What shades points alone is no shadow that anyone sees.
            return if runs.is_empty() {
                Err(why.into())
            } else {
                Ok(runs)
            };
        }
        let spheres = counted(facts.blockers, "blocker sphere", "blocker spheres");
        let accumulation = facts.settings.accumulation;
        let accumulated = match accumulation == facts.settings.order {
            true => String::new(),
            false => format!(", whose logarithms are accumulated in order {accumulation}"),
        };
        let light = facts.light();
        let reason = format!("{light} is cast into shadow by {spheres}{accumulated}.");
        let rest = "Edges and small folds, for which half resolution does not do, are shaded by themselves.";
        runs.extend(facts.seen(reason, rest));
        runs.extend(facts.gloss(&facts.mirrored()));
        Ok(runs)
    },
    entries: |facts| {
        let entry = Entry::new("shadow", "shadow", Orders::Both);
        let entry = entry.with(&facts.lamp_constants());
        // Without blockers it runs over points of bodies alone.
        match facts.unblocked() {
            None => facts.with_gloss(entry),
            Some(_) => vec![entry.with(&[("GLOSS", false)])],
        }
    },
    cost: |units| Cost {
        multiply_adds: units.shadow,
        nanoseconds: 0.0,
    },
};
