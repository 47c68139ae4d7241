//! Light at half resolution to samples, by a joint bilateral filter, and the list of those that it does not do for.

use crate::plan::resource::{LIGHT, RECEIVERS, SENT, SHARE, UPSAMPLED};
use crate::plan::{Cost, Domain, Entry, Facts, Orders, Pass, Run, Slot};

/// Light of samples from that of their surface at half resolution.
pub static UPSAMPLE: Pass = Pass {
    name: "upsample",
    slots: |_| {
        vec![
            Slot::read(RECEIVERS)
                .of(Domain::Halves)
                .named(&["half_receivers"]),
            Slot::read(SHARE).of(Domain::Halves).named(&["half_shares"]),
            Slot::read_if_any(SENT)
                .of(Domain::Halves)
                .named(&["half_sent"]),
            Slot::read(RECEIVERS).named(&["receivers"]),
            Slot::read(LIGHT),
            Slot::write(UPSAMPLED),
            Slot::write(RECEIVERS)
                .of(Domain::Rest)
                .named(&["anew", "clusters"]),
        ]
    },
    wanted: |facts| {
        needed(facts)?;
        Ok(vec![Run::once(
            Domain::Samples,
            "Samples take the light of their surface from half resolution.",
        )])
    },
    entries: |facts| {
        let [lamps, distributions] = facts.lamp_constants();
        let sent = ("SENT", facts.sends());
        let entry = Entry::new("upsample", "upsample", Orders::Light);
        vec![entry.with(&[lamps, distributions, sent])]
    },
    cost: |units| Cost {
        multiply_adds: units.open,
        nanoseconds: 60.0,
    },
};

/// Why there is nothing to upsample, if there is not.
pub(super) fn needed(facts: &Facts) -> Result<(), String> {
    match (facts.half, facts.shadows) {
        (true, _) => Ok(()),
        (_, true) if facts.brought => Err("Every receiver of the caller's is shaded.".into()),
        (_, true) => Err("Shadows are computed for every sample, as the settings ask.".into()),
        (_, false) => {
            Err("Without shadows, light costs less than taking it from half resolution.".into())
        }
    }
}
