//! What a translator leaves behind, brought into order: versions and entry points out, names and comments back.

use super::Language;
use super::source::{Source, comment, words};
use std::collections::{BTreeSet, HashMap, HashSet};

/// Columns of a line of code.
const COLUMNS: usize = 118;

/// The file: head, guard against a second inclusion, and the translated text.
pub fn file(language: Language, source: &Source, head: &str, text: &str) -> String {
    let chunks = chunks(&body(language, text));
    let names = declared(&chunks);
    let rename: HashMap<&str, String> = names
        .iter()
        .filter(|name| !name.starts_with(&source.prefix))
        .map(|name| (*name, own(name, &source.prefix)))
        .collect();
    let docs: HashMap<&str, &[String]> = source
        .declarations
        .iter()
        .map(|d| (d.name.as_str(), d.doc.as_slice()))
        .collect();
    let mut out = Vec::new();
    let mut told = HashSet::new();
    for chunk in &chunks {
        let doc = match subject(chunk) {
            // The type of a function's result comes before the function: the comment goes before both.
            Some(name) => {
                let name = name.strip_prefix("ret_").unwrap_or(name);
                docs.get(name).filter(|_| told.insert(name.to_string()))
            }
            None => None,
        };
        let text = words(&numbers_off(chunk, &names), |word| {
            rename.get(word).cloned()
        });
        let text: Vec<_> = text.lines().map(broken).collect();
        out.push(doc.map_or_else(String::new, |doc| comment(doc)) + &text.join("\n") + "\n");
    }
    let name = source.prefix.trim_end_matches('_').to_uppercase();
    let guard = format!("GAUNT_{name}_INCLUDED");
    format!(
        "{head}\n#ifndef {guard}\n#define {guard}\n\n{}\n#endif\n",
        out.join("\n")
    )
}

/// The text between what belongs to a whole shader.
fn body(language: Language, text: &str) -> String {
    let text = match language {
        Language::Msl => text,
        _ => text
            .split_once("void main()")
            .map_or(text, |(before, _)| before),
    };
    let lines = text
        .lines()
        .filter(|line| !line.starts_with("#version") && !line.starts_with("// language"));
    lines.collect::<Vec<_>>().join("\n")
}

/// The text in pieces, one a declaration. A type that is declared for a function's result stays with the function.
fn chunks(text: &str) -> Vec<String> {
    let mut chunks: Vec<String> = vec![String::new()];
    let mut blank = true;
    for line in text.lines() {
        let margin = !line.is_empty() && !line.starts_with([' ', '\t', '}', '{', ')']);
        let ends = chunks
            .last()
            .is_some_and(|c| c.ends_with("}\n") || c.ends_with(";\n"));
        let typedef = chunks
            .last()
            .is_some_and(|c| c.lines().count() == 1 && c.starts_with("typedef"));
        if margin && (blank || ends && !typedef) {
            chunks.push(String::new());
        }
        blank = line.is_empty();
        if let (false, Some(chunk)) = (blank, chunks.last_mut()) {
            *chunk += line;
            chunk.push('\n');
        }
    }
    chunks.retain(|chunk| !chunk.is_empty());
    chunks
}

/// A line, broken after commas where it is too long.
fn broken(line: &str) -> String {
    if line.len() <= COLUMNS {
        return line.to_string();
    }
    let indent = &line[..line.len() - line.trim_start().len()];
    let mut lines = vec![String::from(indent)];
    for part in line.trim_start().split_inclusive(", ") {
        let last = lines.len() - 1;
        if lines[last].len() + part.trim_end().len() > COLUMNS && !lines[last].trim().is_empty() {
            lines.push(format!("{indent}    "));
        }
        if let Some(line) = lines.last_mut() {
            *line += part;
        }
    }
    let lines: Vec<_> = lines.iter().map(|line| line.trim_end()).collect();
    lines.join("\n")
}

/// What a piece declares, if it declares something.
fn subject(chunk: &str) -> Option<&str> {
    let first = chunk.lines().next()?;
    if first.starts_with('#') || first.starts_with("using") || first.starts_with("precision") {
        return None;
    }
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let upto = |end: usize| first[..end].trim_end().rsplit(|c| !is_word(c)).next();
    if first.starts_with("typedef") {
        // `typedef float name[16];`
        return upto(first.rfind('[').unwrap_or(first.len()));
    }
    if let Some(rest) = first.strip_prefix("struct ") {
        return rest.split(|c| !is_word(c)).next();
    }
    let end = match (first.find('('), first.find('=')) {
        (Some(call), Some(equals)) if equals < call => equals,
        (Some(call), _) => call,
        (None, Some(equals)) => equals,
        (None, None) => first.len(),
    };
    // `float name[16] =`
    let declared = first[..end].trim_end();
    let declared = match declared.strip_suffix(']').and_then(|d| d.rfind('[')) {
        Some(at) => &declared[..at],
        None => declared,
    };
    declared
        .rsplit(|c| !is_word(c))
        .next()
        .filter(|name| !name.is_empty())
}

fn declared(chunks: &[String]) -> Vec<&str> {
    let mut names: Vec<&str> = chunks.iter().filter_map(|chunk| subject(chunk)).collect();
    // A result's type and its function are one piece: `typedef …; name name(…)`.
    for chunk in chunks {
        names.extend(
            chunk
                .lines()
                .skip(1)
                .filter(|l| l.starts_with("ret_"))
                .filter_map(subject),
        );
    }
    names.sort_unstable();
    names.dedup();
    names
}

/// A translator's own name under the prefix: `ret_sh4_product` becomes `sh4_product_result`.
fn own(name: &str, prefix: &str) -> String {
    match name.strip_prefix("ret_") {
        Some(function) if function.starts_with(prefix) => format!("{function}_result"),
        Some(function) => format!("{prefix}{}_result", function.trim_end_matches('_')),
        None => format!("{prefix}{}", name.trim_end_matches('_')),
    }
}

/// Translators keep names apart over the whole file and number them: `f_12`, `t7_`. Within one function the names it
/// had are enough, as long as nothing else there has them.
fn numbers_off(chunk: &str, globals: &[&str]) -> String {
    let mut present = BTreeSet::new();
    words(chunk, |word| {
        present.insert(word.to_string());
        None
    });
    let mut taken = present.clone();
    let mut short = HashMap::new();
    for word in &present {
        let Some((base, digits)) = word.rsplit_once('_') else {
            continue;
        };
        let numbered = match digits {
            "" => base.ends_with(|c: char| c.is_ascii_digit()),
            digits => digits.chars().all(|c| c.is_ascii_digit()),
        };
        let free =
            !base.is_empty() && !globals.contains(&base) && !globals.contains(&word.as_str());
        if numbered && free && taken.insert(base.to_string()) {
            short.insert(word.clone(), base.to_string());
        }
    }
    words(chunk, |word| short.get(word).cloned())
}
