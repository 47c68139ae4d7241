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
