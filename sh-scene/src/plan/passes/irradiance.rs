//! Light without blockers.

use crate::plan::resource::{LIGHT, RADIANCE, RECEIVERS};
use crate::plan::{Cost, Entry, Orders, Pass, Run, Slot};

/// Unblocked light.
pub static IRRADIANCE: Pass = Pass {
    name: "irradiance",
    slots: |_| {
        vec![
            Slot::read(RECEIVERS),
            Slot::read(LIGHT),
            Slot::write(RADIANCE),
        ]
    },
    wanted: |facts| match facts.shadows {
        true => Err("The shadow pass gives unblocked light as well.".into()),
        false => Ok(vec![Run::once(
            facts.finest(),
            format!("{} reaches every receiver unblocked.", facts.light()),
        )]),
    },
    entries: |facts| {
        let entry = Entry::new("irradiance", "irradiance", Orders::Light);
        vec![entry.with(&facts.lamp_constants())]
    },
    cost: |units| Cost {
        multiply_adds: units.open,
        nanoseconds: 0.0,
    },
};
