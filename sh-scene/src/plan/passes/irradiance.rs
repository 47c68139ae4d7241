//! Light without blockers.

use crate::plan::resource::{LIGHT, RADIANCE};
use crate::plan::{Cost, Entry, Orders, Pass, Run, Slot};

/// Unblocked light.
pub static IRRADIANCE: Pass = Pass {
    name: "irradiance",
    slots: |at| {
        vec![
            Slot::receivers(at),
            Slot::read(LIGHT),
            Slot::write(RADIANCE),
        ]
    },
    wanted: |facts| match facts.shadows {
        true => Err("The shadow pass gives unblocked light as well.".into()),
        false => {
            let reason = format!("{} reaches every receiver unblocked.", facts.light());
            let mut runs = vec![Run::once(facts.finest(), reason)];
            runs.extend(facts.gloss(&facts.mirrored()));
            Ok(runs)
        }
    },
    entries: |facts| {
        let entry = Entry::new("irradiance", "irradiance", Orders::Light);
        facts.with_gloss(entry.with(&facts.lamp_constants()))
    },
    cost: |units| Cost {
        multiply_adds: units.open,
        nanoseconds: 0.0,
    },
};
