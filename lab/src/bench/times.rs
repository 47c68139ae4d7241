//! What benches tell of times.

use serde::Serialize;

/// A stage and its time.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct Stage {
    pub name: &'static str,
    /// Median milliseconds.
    pub ms: f64,
}

/// The middle of some values; not a number of none.
pub(super) fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}
