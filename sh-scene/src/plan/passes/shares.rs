//! Radiance at half resolution to the share that it is of that without blockers.

use super::upsample;
use crate::plan::resource::{LIGHT, RADIANCE, RECEIVERS, SHARE};
use crate::plan::{Cost, Domain, Entry, Orders, Pass, Run, Slot};

/// Shares of light: what is interpolated, as they change less from pixel to pixel than light itself.
pub static SHARES: Pass = Pass {
    name: "shares",
    slots: |_| {
        vec![
            Slot::read(RECEIVERS).named(&["half_receivers"]),
            Slot::read(LIGHT),
            Slot::read(RADIANCE).named(&["half_radiance"]),
            Slot::write(SHARE).named(&["half_radiance"]),
        ]
    },
    wanted: |facts| {
        upsample::needed(facts)?;
        Ok(vec![Run::once(
            Domain::Halves,
            "What is interpolated is the share of its light that a receiver gets, which normals change little.",
        )])
    },
    entries: |facts| {
        let entry = Entry::new("upsample", "shares", Orders::Light);
        vec![entry.with(&facts.lamp_constants())]
    },
    cost: |units| Cost {
        multiply_adds: units.open,
        nanoseconds: 0.0,
    },
};
