//! The light of samples that half resolution does not do for, back to where they are.

use super::upsample;
use crate::plan::resource::{RADIANCE, RECEIVERS, UPSAMPLED};
use crate::plan::{Cost, Domain, Entry, Orders, Pass, Run, Slot};

/// Light of the rest, to its samples.
pub static SCATTER: Pass = Pass {
    name: "scatter",
    slots: |_| {
        vec![
            Slot::read(RECEIVERS).named(&["shaded_receivers", "shaded_clusters"]),
            Slot::read(RADIANCE).named(&["shaded"]),
            // What it writes lies among that.
            Slot::read(UPSAMPLED).of(Domain::Samples).named(&[]),
            Slot::write(RADIANCE).of(Domain::Samples),
        ]
    },
    wanted: |facts| {
        upsample::needed(facts)?;
        Ok(vec![Run::once(
            Domain::Rest,
            "What was shaded by itself goes back to its samples.",
        )])
    },
    entries: |_| vec![Entry::new("upsample", "scatter", Orders::Light)],
    cost: |_| Cost {
        multiply_adds: 0.0,
        nanoseconds: 5.0,
    },
};
