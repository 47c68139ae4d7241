//! The linker: one flat WGSL text out of a pass, the pieces it imports and the generated library.
//!
//! Three things happen, all of them to lines of text, so that what comes out reads like what went in:
//!
//! 1. **Imports.** A line `#import shared/x` at the start of a line brings in the module `shared/x` and
//!    what that imports, each once, before the importing text. `#import library` is the library that
//!    sh-codegen generates for the order at hand, `#import constants` what it prints of the constants that
//!    Rust has as well. An import that does not exist is an error that names file and line.
//! 2. **Specialisation.** `$N` stands for the order and `$C` for its number of coefficients, as in
//!    `sh$N_product` and `array<f32, $C>`; `$A` and `$B` for the same of the order that logarithms are
//!    accumulated in.
//! 3. **Pruning.** Only what the entry points reach stays: drivers compile every function they are given. Of what
//!    has no entry points all stays, but of the shared constants those that it mentions.
//!
//! The linker knows the items of a module by their form: an item starts at the left margin, with its
//! comments and attributes, and ends with the first line at the left margin that ends in `}` or `;`.

use std::collections::HashSet;
use std::fmt;

/// What was wrong with a module, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LinkError {
    /// The module's file, as in `shared/records.wgsl`.
    pub file: String,
    /// Line, from 1.
    pub line: usize,
    /// What was wrong and what would be right.
    pub message: String,
}

impl fmt::Display for LinkError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}", self.file, self.line, self.message)
    }
}

impl std::error::Error for LinkError {}

/// A declaration at the top level of a module.
#[derive(Clone, Debug)]
pub struct Item {
    /// Its text, with its comments and attributes.
    pub text: String,
    /// That without comments.
    pub code: String,
    /// What it declares.
    pub name: String,
    /// The words that it mentions.
    pub uses: HashSet<String>,
    /// Whether it is an entry point.
    pub entry: bool,
}

/// What the placeholders stand for.
#[derive(Clone, Copy, Debug)]
pub struct Choice {
    /// SH order.
    pub order: usize,
    /// SH order of the accumulated logarithms, at least `order`.
    pub accumulation: usize,
}

/// A generated text, taken apart once for all that import it.
pub struct Library(pub Vec<Item>);

impl Library {
    /// From its text, which holds neither imports nor placeholders.
    pub fn new(text: &str) -> Result<Self, LinkError> {
        let mut items = Vec::new();
        let choice = Choice {
            order: 0,
            accumulation: 0,
        };
        let nothing = |_: &str| None;
        gather(
            "library",
            text,
            choice,
            &Modules {
                read: &nothing,
                libraries: &[],
                constants: &Self(Vec::new()),
            },
            &mut HashSet::new(),
            &mut items,
        )?;
        Ok(Self(items))
    }
}

/// What can be imported.
#[derive(Clone, Copy)]
pub struct Modules<'a> {
    /// A module's text by its import name, if there is such a module.
    pub read: &'a dyn Fn(&str) -> Option<String>,
    /// What `library` stands for: one library or several.
    pub libraries: &'a [&'a Library],
    /// What `constants` stands for.
    pub constants: &'a Library,
}

/// All items of the module `root`, those of its imports first.
pub fn items(root: &str, choice: Choice, modules: Modules<'_>) -> Result<Vec<Item>, LinkError> {
    let read = modules.read;
    let mut items = Vec::new();
    let mut seen = HashSet::from([root.to_string()]);
    let text = read(root).ok_or_else(|| LinkError {
        file: format!("{root}.wgsl"),
        line: 1,
        message: "there is no such module".into(),
    })?;
    gather(root, &text, choice, &modules, &mut seen, &mut items)?;
    Ok(items)
}

/// One text of what the entry points reach, or, where there are none, of all items and those of `shared` that they mention.
pub fn flat(items: &[Item], shared: &Library) -> String {
    let library = !items.iter().any(|i| i.entry);
    let own = |item: &Item| !shared.0.iter().any(|of| of.name == item.name);
    let kept = reached(items, |item| item.entry || library && own(item));
    let texts: Vec<_> = kept.iter().map(|i| i.text.as_str()).collect();
    texts.join("\n")
}

/// The items that the chosen ones mention, directly or through others, and themselves; in their order.
pub fn reached(items: &[Item], chosen: impl Fn(&Item) -> bool) -> Vec<&Item> {
    let mut names = HashSet::new();
    let mut open: Vec<&Item> = items.iter().filter(|i| chosen(i)).collect();
    while let Some(item) = open.pop() {
        if names.insert(&item.name) {
            open.extend(items.iter().filter(|i| item.uses.contains(&i.name)));
        }
    }
    items.iter().filter(|i| names.contains(&i.name)).collect()
}

/// Appends the items of a module, those of its imports first.
fn gather(
    module: &str,
    text: &str,
    choice: Choice,
    modules: &Modules<'_>,
    seen: &mut HashSet<String>,
    items: &mut Vec<Item>,
) -> Result<(), LinkError> {
    let mut own = Vec::new();
    let mut item = String::new();
    for (number, line) in text.lines().enumerate() {
        let error = |message: String| LinkError {
            file: format!("{module}.wgsl"),
            line: number + 1,
            message,
        };
        if let Some(import) = line.strip_prefix("#import") {
            let import = import.trim();
            if seen.insert(import.to_string()) {
                let generated = match import {
                    "library" => Some(modules.libraries),
                    "constants" => Some(&[modules.constants][..]),
                    _ => None,
                };
                if let Some(generated) = generated {
                    items.extend(generated.iter().flat_map(|library| &library.0).cloned());
                    continue;
                }
                let text = (modules.read)(import).ok_or_else(|| {
                    error(format!(
                        "imports `{import}`, but there is no {import}.wgsl; a module is named by its path \
                         without the ending, or `library` for the generated routines, or `constants` for the constants \
                         that Rust has as well"
                    ))
                })?;
                gather(import, &text, choice, modules, seen, items)?;
            }
            continue;
        }
        let line = match line.contains('$') {
            true => specialise(line, choice).map_err(error)?,
            false => line.to_string(),
        };
        if line.trim().is_empty() && strip_comment(&item).trim().is_empty() {
            // A comment that stands alone belongs to the module, not to the item after it.
            item.clear();
            continue;
        }
        item += &line;
        item.push('\n');
        let code = strip_comment(&line);
        if !code.starts_with([' ', '\t']) && code.trim_end().ends_with(['}', ';']) {
            own.push(parse(std::mem::take(&mut item)).ok_or_else(|| {
                error("this line ends something that declares no name: a function, struct, const, alias or var was expected".into())
            })?);
        }
    }
    if !strip_comment(&item).trim().is_empty() {
        return Err(LinkError {
            file: format!("{module}.wgsl"),
            line: text.lines().count(),
            message: "the last item does not end with `}` or `;` at the left margin".into(),
        });
    }
    items.extend(own);
    Ok(())
}

/// A line with its placeholders filled in.
fn specialise(line: &str, choice: Choice) -> Result<String, String> {
    let Choice {
        order,
        accumulation,
    } = choice;
    let line = line
        .replace("$N", &order.to_string())
        .replace("$C", &(order * order).to_string())
        .replace("$A", &accumulation.to_string())
        .replace("$B", &(accumulation * accumulation).to_string());
    match line.find('$') {
        None => Ok(line),
        Some(at) => Err(format!(
            "`{}` is no placeholder; there are $N, the order, $C, its number of coefficients, and $A and $B, the \
             same of the accumulation",
            line[at..].chars().take(2).collect::<String>()
        )),
    }
}

/// The text without its `//` comments.
fn strip_comment(text: &str) -> String {
    let code = text
        .lines()
        .map(|line| line.split("//").next().unwrap_or(""));
    code.collect::<Vec<_>>().join("\n")
}

/// The names of other items that code may mean: not those of fields, and not those that it declares itself.
fn mentioned(code: &str) -> HashSet<String> {
    let is_word = |c: char| c.is_alphanumeric() || c == '_' || c == '@';
    let (mut all, mut own) = (HashSet::new(), HashSet::new());
    let (mut rest, mut before) = (code, "");
    while let Some(at) = rest.find(is_word) {
        let (between, word) = rest.split_at(at);
        let (word, after) = word.split_at(word.find(|c| !is_word(c)).unwrap_or(word.len()));
        let declared = ["let", "var", "const"].contains(&before) && between.trim().is_empty();
        if declared || (after.starts_with(':') && before != "case") {
            own.insert(word.to_string());
        } else if !between.ends_with('.') {
            all.insert(word.to_string());
        }
        (rest, before) = (after, word);
    }
    &all - &own
}

/// Finds an item's name and the names it mentions.
fn parse(text: String) -> Option<Item> {
    let code = strip_comment(&text);
    let words: Vec<&str> = code
        .split(|c: char| !(c.is_alphanumeric() || c == '_' || c == '@'))
        .filter(|w| !w.is_empty())
        .collect();
    const ADDRESSING: [&str; 7] = [
        "uniform",
        "storage",
        "workgroup",
        "private",
        "read",
        "write",
        "read_write",
    ];
    let keyword = words
        .iter()
        .position(|w| ["fn", "struct", "const", "alias", "var", "override"].contains(w))?;
    let name = words[keyword + 1..]
        .iter()
        .find(|w| !ADDRESSING.contains(w))?
        .to_string();
    let mut uses = mentioned(&code);
    uses.remove(&name);
    let entry = words[..keyword]
        .iter()
        .any(|w| ["@compute", "@vertex", "@fragment"].contains(w));
    Some(Item {
        text,
        code,
        name,
        uses,
        entry,
    })
}
