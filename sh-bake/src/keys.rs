//! Reading a table of a scene file key by key, with errors that name the file, the line and the key.

use crate::error::{Error, one_line};
use glam::Vec3;
use std::fmt::Display;
use std::ops::{Range, RangeInclusive};
use std::path::{Path, PathBuf};
use toml::de::{DeTable, DeValue};

/// Coordinates and factors beyond this leave what `f32` can square.
pub(crate) const FAR: f32 = 1e9;

/// The file that tables are from.
#[derive(Clone, Copy)]
pub(crate) struct Source<'a> {
    pub(crate) path: &'a Path,
    pub(crate) text: &'a str,
}

impl Source<'_> {
    /// The line of a place in the text, from 1.
    fn line(&self, span: &Range<usize>) -> usize {
        let before = self.text.get(..span.start).unwrap_or(self.text);
        before.matches('\n').count() + 1
    }

    /// An error at a place in the text.
    pub(crate) fn error(&self, span: &Range<usize>, message: impl Display) -> Error {
        Error::Scene {
            path: self.path.to_path_buf(),
            line: self.line(span),
            message: one_line(&message.to_string()),
        }
    }
}

/// A table with its name, for instance `camera` or `objects`.
pub(crate) struct Section<'a> {
    source: Source<'a>,
    name: &'a str,
    span: Range<usize>,
    table: &'a DeTable<'a>,
}

impl<'a> Section<'a> {
    /// The table, if it has no keys but those `known`.
    pub(crate) fn new(
        source: Source<'a>,
        name: &'a str,
        span: Range<usize>,
        table: &'a DeTable<'a>,
        known: &[&str],
    ) -> Result<Self, Error> {
        for key in table.keys() {
            let found = key.get_ref().as_ref();
            if !known.contains(&found) {
                let place = if name.is_empty() {
                    String::new()
                } else {
                    format!(" in [{name}]")
                };
                let hint = match nearest(found, known) {
                    Some(near) => format!("; did you mean `{near}`?"),
                    None => format!(", which knows {}.", known.join(", ")),
                };
                return Err(source.error(
                    &key.span(),
                    format!("the key `{found}` is not known{place}{hint}"),
                ));
            }
        }
        Ok(Self {
            source,
            name,
            span,
            table,
        })
    }

    /// Where the table, or its key, stands.
    pub(crate) fn error(&self, key: &str, message: impl Display) -> Error {
        let span = self
            .table
            .get(key)
            .map_or(self.span.clone(), |value| value.span());
        let dot = if key.is_empty() || self.name.is_empty() {
            ""
        } else {
            "."
        };
        self.source
            .error(&span, format!("{}{dot}{key} {message}", self.name))
    }

    /// Whether a key is there.
    pub(crate) fn has(&self, key: &str) -> bool {
        self.table.contains_key(key)
    }

    fn value(&self, key: &str) -> Option<&'a DeValue<'a>> {
        self.table.get(key).map(|value| value.get_ref())
    }

    /// A string.
    pub(crate) fn string(&self, key: &str) -> Result<Option<&'a str>, Error> {
        match self.value(key) {
            None => Ok(None),
            Some(DeValue::String(text)) => Ok(Some(text.as_ref())),
            Some(other) => {
                Err(self.error(key, format!("has to be a string, not {}.", kind(other))))
            }
        }
    }

    /// A string, or a whole number as one.
    pub(crate) fn string_or_count(&self, key: &str) -> Result<Option<String>, Error> {
        match self.value(key) {
            None => Ok(None),
            Some(DeValue::String(text)) => Ok(Some(text.to_string())),
            Some(value) => match integer(value).filter(|n| *n >= 0) {
                Some(n) => Ok(Some(n.to_string())),
                None => Err(self.error(
                    key,
                    format!("has to be a string or a whole number, not {}.", kind(value)),
                )),
            },
        }
    }

    /// The line on which a key stands, from 1.
    pub(crate) fn line(&self, key: &str) -> usize {
        let span = self.table.get(key).map_or(self.span.clone(), |v| v.span());
        self.source.line(&span)
    }

    /// True or false.
    pub(crate) fn boolean(&self, key: &str) -> Result<Option<bool>, Error> {
        match self.value(key) {
            None => Ok(None),
            Some(DeValue::Boolean(value)) => Ok(Some(*value)),
            Some(other) => Err(self.error(
                key,
                format!("has to be true or false, not {}.", kind(other)),
            )),
        }
    }

    /// A whole number within a range.
    pub(crate) fn count(
        &self,
        key: &str,
        range: RangeInclusive<usize>,
    ) -> Result<Option<usize>, Error> {
        let Some(value) = self.value(key) else {
            return Ok(None);
        };
        let wanted = format!(
            "has to be a whole number from {} to {}",
            range.start(),
            range.end()
        );
        match (integer(value), number(value)) {
            (Some(n), _) => match usize::try_from(n).ok().filter(|n| range.contains(n)) {
                Some(n) => Ok(Some(n)),
                None => Err(self.error(key, format!("is {n}, but it {wanted}."))),
            },
            (None, Some(n)) => Err(self.error(key, format!("is {n}, but it {wanted}."))),
            (None, None) => Err(self.error(key, format!("{wanted}, not {}.", kind(value)))),
        }
    }

    /// A number that `allowed` allows; `wanted` says which those are ("above 0").
    pub(crate) fn number(
        &self,
        key: &str,
        wanted: &str,
        allowed: impl Fn(f32) -> bool,
    ) -> Result<Option<f32>, Error> {
        let Some(value) = self.value(key) else {
            return Ok(None);
        };
        match number(value) {
            Some(n) if n.is_finite() && allowed(n) => Ok(Some(n)),
            Some(n) => Err(self.error(key, format!("is {n}, but it has to be a number {wanted}."))),
            None => Err(self.error(
                key,
                format!("has to be a number {wanted}, not {}.", kind(value)),
            )),
        }
    }

    /// A list of tables, as sections of this name that know these keys.
    pub(crate) fn sections(
        &self,
        key: &str,
        name: &'a str,
        known: &[&str],
    ) -> Result<Option<Vec<Section<'a>>>, Error> {
        let entries = match self.value(key) {
            None => return Ok(None),
            Some(DeValue::Array(entries)) => entries,
            Some(other) => {
                let found = kind(other);
                return Err(self.error(key, format!("has to be a list of tables, not {found}.")));
            }
        };
        let section = |entry: &'a toml::Spanned<DeValue<'a>>| match entry.get_ref() {
            DeValue::Table(table) => Section::new(self.source, name, entry.span(), table, known),
            other => Err(self.source.error(
                &entry.span(),
                format!(
                    "{name} has {} in it, but it has to be a list of tables.",
                    kind(other)
                ),
            )),
        };
        entries
            .iter()
            .map(section)
            .collect::<Result<_, _>>()
            .map(Some)
    }

    /// A list of colours, each three numbers, or one for a gray.
    pub(crate) fn colors(&self, key: &str) -> Result<Option<Vec<[f32; 3]>>, Error> {
        let color = |value: &DeValue| match value {
            DeValue::Array(array) => {
                let channels = array.iter().map(|v| number(v.get_ref()));
                let channels = channels.collect::<Option<Vec<f32>>>()?;
                <[f32; 3]>::try_from(channels).ok()
            }
            other => number(other).map(|n| [n; 3]),
        };
        let colors = match self.value(key) {
            None => return Ok(None),
            Some(DeValue::Array(array)) => array.iter().map(|v| color(v.get_ref())).collect(),
            Some(_) => None,
        };
        colors.map(Some).ok_or_else(|| {
            let message = "has to be a list of numbers, or of triples like [0.1, 0.2, 0.3].";
            self.error(key, message)
        })
    }

    /// Three numbers that `allowed` allows. One number stands for three equal ones where `spread` says so.
    pub(crate) fn triple(
        &self,
        key: &str,
        wanted: &str,
        spread: bool,
        allowed: impl Fn(f32) -> bool,
    ) -> Result<Option<[f32; 3]>, Error> {
        let Some(value) = self.value(key) else {
            return Ok(None);
        };
        let numbers: Option<Vec<f32>> = match value {
            DeValue::Array(array) => array.iter().map(|v| number(v.get_ref())).collect(),
            other if spread => number(other).map(|n| vec![n; 3]),
            _ => None,
        };
        let triple = numbers.and_then(|n| <[f32; 3]>::try_from(n).ok());
        match triple {
            Some(triple) => match triple.iter().find(|n| !n.is_finite() || !allowed(**n)) {
                None => Ok(Some(triple)),
                Some(n) => Err(self.error(
                    key,
                    format!("has {n} in it, but it has to be three numbers {wanted}."),
                )),
            },
            None => Err(self.error(
                key,
                format!("has to be three numbers {wanted}, like [0.1, 0.2, 0.3]."),
            )),
        }
    }
}

/// What a value is, for a person.
/// Reflectances.
pub(crate) fn albedo(section: &Section) -> Result<Option<[f32; 3]>, Error> {
    section.triple("albedo", "from 0 to 1", true, |n| (0.0..=1.0).contains(&n))
}

/// A path as the scene file means it.
pub(crate) fn beside(scene: &Path, path: &str) -> PathBuf {
    scene.parent().unwrap_or(Path::new("")).join(path)
}

fn kind(value: &DeValue) -> &'static str {
    match value {
        DeValue::String(_) => "a string",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}

fn integer(value: &DeValue) -> Option<i64> {
    match value {
        DeValue::Integer(n) => i64::from_str_radix(n.as_str(), n.radix()).ok(),
        _ => None,
    }
}

fn number(value: &DeValue) -> Option<f32> {
    match value {
        DeValue::Float(n) => n.as_str().parse().ok(),
        other => integer(other).map(|n| n as f32),
    }
}

/// The known key that is least different from the one found, if it is near.
fn nearest<'k>(found: &str, known: &[&'k str]) -> Option<&'k str> {
    let by_distance = known
        .iter()
        .map(|key| (distance(&found.to_lowercase(), key), *key));
    by_distance
        .min()
        .filter(|(d, key)| *d <= 1 + key.len() / 3)
        .map(|(_, key)| key)
}

/// How many letters have to be put in, taken out or changed to make `a` into `b` (Levenshtein 1966).
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let changed = diagonal + usize::from(x != *y);
            diagonal = row[j + 1];
            row[j + 1] = changed.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}

/// A direction of any length but 0; there is somewhere to `go`.
pub(crate) fn towards(s: &Section, key: &str, go: &str) -> Result<Option<Vec3>, Error> {
    let given = s.triple(key, "of any length but 0", false, |n| n.abs() < FAR)?;
    let direction = given.map(Vec3::from);
    match direction {
        Some(direction) if direction.try_normalize().is_none() => {
            let message = format!("has no length, so there is nowhere to {go}.");
            Err(s.error(key, message))
        }
        _ => Ok(direction),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_are_those_of_the_textbook() {
        assert_eq!(distance("kitten", "sitting"), 3);
        assert_eq!(distance("", "abc"), 3);
        assert_eq!(distance("same", "same"), 0);
    }

    #[test]
    fn near_keys_are_found_and_far_ones_are_not() {
        let known = ["mesh", "spheres", "translate", "rotate", "scale", "albedo"];
        assert_eq!(nearest("shperes", &known), Some("spheres"));
        assert_eq!(nearest("Mesh", &known), Some("mesh"));
        assert_eq!(nearest("color", &known), None);
    }
}
