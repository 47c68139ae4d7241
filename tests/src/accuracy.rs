//! The table of permitted errors.

use serde::Deserialize;
use std::collections::BTreeMap;

/// Permitted errors by number type, in units u times the arguments' norms.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Permitted {
    /// In f64, u = 2⁻⁵³.
    pub f64: Option<f64>,
    /// In f32 and vector lanes, u = 2⁻²⁴.
    pub f32: Option<f64>,
    /// In f32 on a GPU.
    pub gpu: Option<f64>,
}

/// An exception with its reason.
#[derive(Clone, Debug, Deserialize)]
pub struct Exception {
    /// Why the default does not do.
    pub reason: String,
    /// The errors that differ from the default.
    #[serde(flatten)]
    pub permitted: Permitted,
}

/// The whole table.
#[derive(Clone, Debug, Deserialize)]
pub struct Table {
    default: Permitted,
    /// Exceptions by routine.
    #[serde(flatten)]
    pub exceptions: BTreeMap<String, Exception>,
}

/// A number type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Number {
    /// Double precision.
    F64,
    /// Single precision, scalar or lanes.
    F32,
    /// Single precision on a GPU.
    Gpu,
}

impl Number {
    /// Half the distance from 1 to the next number.
    pub fn unit(self) -> f64 {
        match self {
            Self::F64 => 0.5 * f64::EPSILON,
            Self::F32 | Self::Gpu => 0.5 * f64::from(f32::EPSILON),
        }
    }

    fn of(self, p: &Permitted) -> Option<f64> {
        match self {
            Self::F64 => p.f64,
            Self::F32 => p.f32,
            Self::Gpu => p.gpu,
        }
    }
}

impl Table {
    /// The table in `tests/accuracy.toml`.
    pub fn load() -> Self {
        toml::from_str(include_str!("../accuracy.toml")).expect("accuracy.toml is a valid table")
    }

    /// The default, in units.
    pub fn default(&self, number: Number) -> f64 {
        number
            .of(&self.default)
            .expect("the default has every number type")
    }

    /// The exception for a routine, in units, if there is one.
    pub fn exception(&self, routine: &str, number: Number) -> Option<f64> {
        number.of(&self.exceptions.get(routine)?.permitted)
    }

    /// What a routine is permitted, in units.
    pub fn permitted(&self, routine: &str, number: Number) -> f64 {
        self.exception(routine, number)
            .unwrap_or_else(|| self.default(number))
    }
}

/// How much more than what is measured an entry may permit.
pub const SLACK: f64 = 4.0;

impl Table {
    /// What is wrong with the table, given the worst error of each routine in scalar f32, in units: an entry
    /// that permits less than is measured, one that permits more than [`SLACK`] times as much, or an exception
    /// that the default covers. Entries for other number types are upper bounds alone, so that other hardware
    /// and other libraries stay green; but they too have to exceed the default.
    pub fn complaints(&self, measured: &BTreeMap<&str, f64>) -> Vec<String> {
        let mut complaints = Vec::new();
        let mut judge = |what: &str, permitted: f64, measured: f64| {
            if measured > permitted {
                complaints.push(format!(
                    "{what} errs by {measured:.1} units, {permitted} permitted"
                ));
            }
            if permitted > SLACK * measured {
                complaints.push(format!(
                    "{what} errs by {measured:.1} units, {permitted} permitted: that is loose"
                ));
            }
        };
        let mut rest = ("the default, by `nothing`".to_string(), 0.0);
        for (routine, error) in measured {
            match self.exception(routine, Number::F32) {
                Some(permitted) => judge(&format!("`{routine}`"), permitted, *error),
                None if *error > rest.1 => rest = (format!("the default, by `{routine}`"), *error),
                None => {}
            }
        }
        judge(&rest.0, self.default(Number::F32), rest.1);
        for (routine, exception) in &self.exceptions {
            for number in [Number::F64, Number::F32, Number::Gpu] {
                let default = self.default(number);
                let permitted = number.of(&exception.permitted);
                let needless = match number {
                    Number::F32 => measured
                        .get(routine.as_str())
                        .is_some_and(|m| *m <= default),
                    _ => permitted.is_some_and(|permitted| permitted <= default),
                };
                if permitted.is_some() && needless {
                    complaints.push(format!("`{routine}` needs no exception in {number:?}"));
                }
            }
        }
        complaints
    }
}

/// The largest error of `got` against `want`, in units of `number` times `scale`. NaN counts as infinite.
pub fn error(got: &[f64], want: &[f64], number: Number, scale: f64) -> f64 {
    assert_eq!(got.len(), want.len());
    got.iter().zip(want).fold(0.0, |worst: f64, (g, w)| {
        let e = (g - w).abs() / (number.unit() * scale);
        if e.is_nan() {
            f64::INFINITY
        } else {
            worst.max(e)
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tight_loose_and_needless_entries_are_told() {
        let table: Table = toml::from_str(
            "default = { f64 = 10, f32 = 10, gpu = 10 }\n[a]\nf32 = 40\ngpu = 40\nreason = \"r\"",
        )
        .unwrap();
        let complaints = |a: f64, b: f64| table.complaints(&BTreeMap::from([("a", a), ("b", b)]));
        assert!(complaints(30.0, 9.0).is_empty());
        assert!(complaints(41.0, 9.0)[0].starts_with("`a` errs by 41.0"));
        assert!(complaints(9.9, 9.0)[0].ends_with("loose"));
        assert!(complaints(9.9, 9.0)[1].contains("needs no exception"));
        assert!(complaints(30.0, 11.0)[0].starts_with("the default, by `b`"));
        assert!(complaints(30.0, 2.0)[0].ends_with("loose"));
    }
}
