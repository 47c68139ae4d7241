//! Radiance that is no number, infinite or below 0: where something has gone wrong, before it is seen as a black or white
//! pixel or not at all.

use crate::plan::resource::{Given, RADIANCE, RECEIVERS};
use crate::plan::{Cost, Domain, Entry, Orders, Pass, Resource, Run, Slot};
use std::fmt;

/// How many samples of a pixel are invalid: no number, infinite, below 0 in a channel (each counted once, as the first of
/// these that it is); and how many met a surface and were looked at.
pub const INVALID_SAMPLES: Resource = Resource::made(
    "invalid samples",
    "counts: no number, infinite, negative, looked at",
    Some(Domain::Pixels),
    (16, &["invalid_samples"]),
);

/// Invalid samples of a picture.
pub static INVALID: Pass = Pass {
    name: "invalid",
    slots: |_| {
        vec![
            Slot::read(RECEIVERS)
                .of(Domain::Samples)
                .named(&["receivers"]),
            Slot::read(RADIANCE).of(Domain::Samples),
            Slot::write(INVALID_SAMPLES),
        ]
    },
    // What nobody asks for is nothing that a scene does without.
    wanted: |facts| {
        if !facts.asks(INVALID_SAMPLES) {
            return Ok(Vec::new());
        }
        let reason =
            "It was asked whether every sample's radiance is a number, finite and not negative.";
        Ok(vec![Run::once(Domain::Pixels, reason)])
    },
    entries: |_| vec![Entry::new("invalid", "invalid", Orders::None)],
    cost: |_| Cost {
        multiply_adds: 0.0,
        nanoseconds: 5.0,
    },
};

/// The invalid samples of a picture, told as a sentence.
///
/// ```
/// use sh_scene::passes::{INVALID_SAMPLES, InvalidSamples};
/// let given = [(INVALID_SAMPLES, vec![[0, 0, 0, 4], [1, 0, 2, 4]])].into();
/// let found = InvalidSamples::of(&given, 2).expect("it was asked for");
/// assert_eq!((found.samples, found.pixels), ([1, 0, 2], 1));
/// assert!(found.to_string().starts_with("3 samples of 1 pixel are invalid"));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct InvalidSamples {
    /// Those that are no number, infinite, below 0.
    pub samples: [u64; 3],
    /// Pixels that have any.
    pub pixels: u64,
    /// The first of these from the top, column and row; none where there is none.
    pub first: Option<[usize; 2]>,
}

impl InvalidSamples {
    /// What a frame `width` pixels wide gives; none where nobody asked for it.
    pub fn of(given: &Given, width: u32) -> Option<Self> {
        let counts = given.get(&INVALID_SAMPLES)?;
        let mut all = Self::default();
        for (index, [nan, infinite, negative, _]) in counts.iter().enumerate() {
            let found = [nan, infinite, negative].map(|count| u64::from(*count));
            if found == [0; 3] {
                continue;
            }
            for (sum, found) in all.samples.iter_mut().zip(found) {
                *sum += found;
            }
            all.pixels += 1;
            let width = width.max(1) as usize;
            all.first = all.first.or(Some([index % width, index / width]));
        }
        Some(all)
    }
}

impl fmt::Display for InvalidSamples {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some([x, y]) = self.first else {
            return f.write_str("No sample is invalid.");
        };
        let [nan, infinite, negative] = self.samples;
        let count = |count, one: &str, many: &str| match count {
            1 => format!("1 {one}"),
            _ => format!("{count} {many}"),
        };
        write!(
            f,
            "{} of {} {} invalid ({nan} no number, {infinite} infinite, {negative} negative), the first at column {x}, \
             row {y}; a scene that can be loaded should have none, so please report it",
            count(nan + infinite + negative, "sample", "samples"),
            count(self.pixels, "pixel", "pixels"),
            if nan + infinite + negative == 1 {
                "is"
            } else {
                "are"
            },
        )
    }
}
