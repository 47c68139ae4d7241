//! Every public item has documentation with an example that runs.
//!
//! Read from the sources: rustfmt puts every item on a line of its own, with what is said of it above. What counts are
//! modules, types, traits, constants, functions and methods, those of traits too; fields and variants are shown by
//! the example of their type. Items that the compiler warns about where they lack documentation at all
//! (`missing_docs`) are the same.

use std::fs;
use std::path::{Path, PathBuf};

/// A public item: where it is, its line, and whether it has an example.
struct Item {
    place: String,
    line: String,
    example: bool,
}

const KINDS: [&str; 8] = [
    "mod ", "struct ", "enum ", "trait ", "type ", "const ", "static ", "fn ",
];

/// What follows `pub ` where the line declares an item; fields and re-exports do not.
fn declares(line: &str) -> bool {
    let line = line.strip_prefix("unsafe ").unwrap_or(line);
    KINDS.iter().any(|kind| line.starts_with(kind)) || line.starts_with("const fn ")
}

/// A code block that is not marked as text or as not to be run.
fn shows(doc: &[String]) -> bool {
    doc.iter().any(|line| line.trim() == "```")
        && doc
            .iter()
            .filter(|line| line.trim_start().starts_with("```"))
            .all(|line| {
                let language = line.trim_start().trim_start_matches('`');
                matches!(language, "" | "text")
            })
}

fn items(place: &str, text: &str, found: &mut Vec<Item>) {
    let mut doc = Vec::new();
    // Inside `pub trait … {` items are public without saying so; it ends at the brace in its own column.
    let mut public_trait = None;
    for line in text.lines() {
        let bare = line.trim_start();
        let indent = line.len() - bare.len();
        if let Some(said) = bare.strip_prefix("///") {
            doc.push(said.to_string());
            continue;
        }
        if let Some(said) = bare.strip_prefix("#[doc = concat!(\"") {
            doc.push(said.to_string());
            continue;
        }
        if bare.starts_with("#[") || bare.starts_with("//") {
            continue;
        }
        if public_trait == Some(indent) && bare.starts_with('}') {
            public_trait = None;
        }
        let declared = match bare.strip_prefix("pub ") {
            Some(rest) => declares(rest),
            None => public_trait.is_some_and(|outer| indent == outer + 4) && declares(bare),
        };
        // A module's documentation is in its own file.
        if declared && !bare.starts_with("pub mod ") {
            found.push(Item {
                place: place.to_string(),
                line: bare.to_string(),
                example: shows(&doc),
            });
        }
        if bare.starts_with("pub trait ") && !bare.ends_with("{}") {
            public_trait = Some(indent);
        }
        doc.clear();
    }
}

fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut out = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            out.extend(sources(&path));
        } else {
            out.push(path);
        }
    }
    out.sort();
    out
}

/// Every public item of the crate.
fn all() -> Vec<Item> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut found = Vec::new();
    let mut public_modules = vec!["lib".to_string()];
    let files = sources(&root);
    for path in &files {
        let text = fs::read_to_string(path).unwrap();
        let modules = text.lines().filter_map(|l| l.strip_prefix("pub mod "));
        public_modules.extend(modules.map(|m| m.trim_end_matches(';').to_string()));
    }
    for path in &files {
        let text = fs::read_to_string(path).unwrap();
        let place = path.strip_prefix(&root).unwrap().display().to_string();
        let stem = path.file_stem().unwrap().to_str().unwrap();
        let folder = path
            .parent()
            .unwrap()
            .file_name()
            .unwrap()
            .to_str()
            .unwrap();
        let name = if stem == "mod" { folder } else { stem };
        if public_modules.iter().any(|module| module == name) {
            let head = text.lines().filter_map(|l| l.strip_prefix("//!"));
            found.push(Item {
                place: place.clone(),
                line: format!("mod {name}"),
                example: shows(&head.map(str::to_string).collect::<Vec<_>>()),
            });
        }
        items(&place, &text, &mut found);
    }
    // Of what is generated only the trait is public; it comes first.
    let generated = include_str!(concat!(env!("OUT_DIR"), "/routines.rs"));
    let end = generated
        .find("\nimpl")
        .expect("implementations follow the trait");
    items("generated", &generated[..end], &mut found);
    found
}

#[test]
fn every_public_item_has_an_example() {
    let all = all();
    let lacking: Vec<String> = all
        .iter()
        .filter(|item| !item.example)
        .map(|item| format!("{}: {}", item.place, item.line))
        .collect();
    println!(
        "{} public items, {} with an example",
        all.len(),
        all.len() - lacking.len()
    );
    assert!(
        lacking.is_empty(),
        "without an example:\n{}",
        lacking.join("\n")
    );
    // The reader itself: some of each kind must have been found.
    for known in [
        "mod exp",
        "struct Sh<",
        "trait Lane:",
        "fn exp(self)",
        "type $name",
        "const ONE",
        "enum Fit",
        "fn cap_log(",
    ] {
        assert!(
            all.iter().any(|item| item.line.contains(known)),
            "{known} was not found"
        );
    }
}

#[test]
fn what_has_no_example_is_found() {
    let text = "\
/// Said.
///
/// ```
/// assert!(true);
/// ```
pub fn shown() {}

/// Said.
pub fn bare() {}

/// Said.
///
/// ```ignore
/// nothing();
/// ```
pub const fn ignored() {}

/// Said.
pub trait Open {
    /// Said.
    fn method();
}

pub struct Fields {
    pub field: u32,
}

fn private() {}
";
    let mut found = Vec::new();
    items("here", text, &mut found);
    let told: Vec<(&str, bool)> = found.iter().map(|i| (i.line.as_str(), i.example)).collect();
    assert_eq!(
        told,
        [
            ("pub fn shown() {}", true),
            ("pub fn bare() {}", false),
            ("pub const fn ignored() {}", false),
            ("pub trait Open {", false),
            ("fn method();", false),
            ("pub struct Fields {", false),
        ]
    );
}
