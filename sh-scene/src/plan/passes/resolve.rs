//! Samples to pixels: radiance times albedo, the environment where nothing is hit.

use crate::plan::resource::{ALBEDO, ENVIRONMENT, PICTURE, RADIANCE, RECEIVERS};
use crate::plan::{Cost, Domain, Entry, Orders, Pass, Run, Slot};

/// The picture.
pub static RESOLVE: Pass = Pass {
    name: "resolve",
    slots: |_| {
        vec![
            Slot::read(RECEIVERS).of(Domain::Samples),
            Slot::read(ALBEDO).of(Domain::Samples),
            Slot::read(RADIANCE).of(Domain::Samples),
            Slot::read_if_any(RADIANCE)
                .of(Domain::Gloss)
                .named(&["mirrored"]),
            Slot::read(ENVIRONMENT),
            Slot::write(PICTURE),
        ]
    },
    wanted: |facts| match facts.brought {
        true => Err("The light of a caller's receivers is no picture.".into()),
        false => Ok(vec![Run::once(
            Domain::Pixels,
            "Lit samples become pixels, with the environment behind them.",
        )]),
    },
    entries: |facts| {
        let gloss = ("GLOSS", facts.glossy > 0);
        vec![Entry::new("resolve", "resolve", Orders::None).with(&[gloss])]
    },
    cost: |_| Cost {
        multiply_adds: 0.0,
        nanoseconds: 60.0,
    },
};
