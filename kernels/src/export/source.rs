//! The WGSL of an order under the names of an export: what is asked for and what that needs.

use super::ascii::{plain, wrapped};
use super::{ExportError, Request, prefix};
use crate::link::{Item, Library, reached};
use crate::linked;

/// Columns of a line of comment, with its slashes.
const COLUMNS: usize = 120;

/// A declaration under its exported name.
pub struct Declaration {
    /// The name, with the prefix.
    pub name: String,
    /// Without the prefix: the routine's name, or what only other declarations use.
    pub routine: Option<String>,
    /// Lines of comment, without slashes.
    pub doc: Vec<String>,
    /// The WGSL.
    pub code: String,
}

/// The library that was asked for.
pub struct Source {
    /// SH order.
    pub order: usize,
    /// What every name starts with.
    pub prefix: String,
    /// In an order in which nothing is used before it is declared.
    pub declarations: Vec<Declaration>,
}

impl Source {
    /// Looks the request up. Errors are those of the request.
    pub fn new(request: &Request<'_>) -> Result<Self, ExportError> {
        let order = request.order;
        let text = linked("export", order, order).ok_or(ExportError::Order(order))?;
        let prefix = prefix(request);
        check(&prefix)?;
        let library = Library::new(text).map_err(|error| ExportError::Translation {
            language: "WGSL",
            message: error.to_string(),
        })?;
        let own = format!("sh{order}_");
        let routine = |item: &Item| {
            let function = item.text.contains(&format!("fn {}(", item.name));
            item.name
                .strip_prefix(&own)
                .filter(|_| function)
                .map(str::to_string)
        };
        let known: Vec<String> = library.0.iter().filter_map(routine).collect();
        let halves = |name: &str| name.ends_with("_half");
        for name in request.routines {
            if !known.iter().any(|k| k == name) {
                let mut known = known.clone();
                known.sort();
                return Err(ExportError::Routine {
                    name: name.to_string(),
                    known: known.join(", "),
                });
            }
            if halves(name) && !request.language.packs_halves() {
                return Err(ExportError::Inexpressible {
                    name: name.to_string(),
                    language: request.language.name(),
                });
            }
        }
        let chosen = |item: &Item| {
            routine(item).is_some_and(|name| match request.routines {
                [] => request.language.packs_halves() || !halves(&name),
                some => some.contains(&name.as_str()),
            })
        };
        let names: Vec<&str> = library.0.iter().map(|item| item.name.as_str()).collect();
        let rename = |word: &str, comment: bool| match word.strip_prefix(&own) {
            Some(rest) => Some(format!("{prefix}{rest}")),
            None if !comment && names.contains(&word) => Some(format!("{prefix}{word}")),
            None => None,
        };
        let declarations = reached(&library.0, chosen)
            .into_iter()
            .map(|item| {
                let (doc, code) = parts(&item.text);
                let doc = doc
                    .iter()
                    .map(|line| words(&plain(line), |w| rename(w, true)));
                Declaration {
                    name: rename(&item.name, false).unwrap_or_default(),
                    routine: routine(item),
                    doc: doc.flat_map(|line| wrapped(&line, COLUMNS - 3)).collect(),
                    code: words(&code, |w| rename(w, false)),
                }
            })
            .collect();
        Ok(Self {
            order,
            prefix,
            declarations,
        })
    }

    /// The routines' names, without prefix, in their order.
    pub fn functions(&self) -> Vec<String> {
        let routines = self.declarations.iter().filter_map(|d| d.routine.clone());
        routines.collect()
    }

    /// All of it as WGSL, with comments.
    pub fn wgsl(&self) -> String {
        let texts: Vec<_> = self
            .declarations
            .iter()
            .map(|d| comment(&d.doc) + &d.code)
            .collect();
        texts.join("\n")
    }
}

/// Lines of comment with their slashes.
pub fn comment(lines: &[String]) -> String {
    let lines = lines
        .iter()
        .map(|line| format!("// {line}").trim_end().to_string() + "\n");
    lines.collect()
}

/// An item's comment, without slashes, and its code.
fn parts(text: &str) -> (Vec<String>, String) {
    let is_comment = |line: &&str| line.starts_with("//");
    let doc = text.lines().take_while(is_comment);
    let doc = doc.map(|line| line.trim_start_matches('/').trim().to_string());
    let code: Vec<_> = text.lines().skip_while(is_comment).collect();
    (doc.collect(), code.join("\n") + "\n")
}

/// The text with each word, a run of letters, digits and underscores, as `change` wants it.
pub fn words(text: &str, mut change: impl FnMut(&str) -> Option<String>) -> String {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find(is_word) {
        let (before, from) = rest.split_at(start);
        let (word, after) = from.split_at(from.find(|c| !is_word(c)).unwrap_or(from.len()));
        out += before;
        match change(word) {
            Some(changed) => out += &changed,
            None => out += word,
        }
        rest = after;
    }
    out + rest
}

/// Whether every language would take names with this prefix. What they reserve beyond that shows in the
/// translation.
fn check(prefix: &str) -> Result<(), ExportError> {
    let fine = prefix.len() <= 33
        && prefix.starts_with(|c: char| c.is_ascii_alphabetic())
        && prefix
            .chars()
            .all(|c| c.is_ascii_alphanumeric() || c == '_')
        && !prefix.contains("__")
        && !prefix.starts_with("gl_");
    match fine {
        true => Ok(()),
        false => Err(ExportError::Prefix(prefix.to_string())),
    }
}
