//! A crate's modules, and which of them leads to which.

use crate::source::{Import, Named, Source};
use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::fmt;

/// A module that is a file.
struct Module {
    /// From the crate's root.
    path: Vec<String>,
    /// From the folder of sources.
    file: String,
    source: Source,
}

/// A crate's modules; the first is its root.
pub struct Modules {
    all: Vec<Module>,
    at: BTreeMap<Vec<String>, usize>,
}

/// One file names something of another.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Arrow {
    from: String,
    to: String,
    modules: [Vec<String>; 2],
    line: usize,
    path: String,
}

impl fmt::Display for Arrow {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self {
            from,
            to,
            line,
            path,
            ..
        } = self;
        write!(f, "{from}:{line} leads to {to} by `{path}`")
    }
}

/// Imports that lead to imports: more than anybody writes.
const DEEPEST: usize = 20;

impl Modules {
    /// The modules below the file `root`; `read` gives the text of a file.
    ///
    /// # Panics
    /// If a module that is declared has no file.
    pub fn new(root: &str, read: impl Fn(&str) -> Option<String>) -> Self {
        let mut modules = Self {
            all: Vec::new(),
            at: BTreeMap::new(),
        };
        let mut open = vec![(Vec::<String>::new(), root.to_string())];
        while let Some((path, file)) = open.pop() {
            let source = Source::parse(&read(&file).expect("a module's file"));
            for child in &source.children {
                let below: Vec<String> = path.iter().chain([child]).cloned().collect();
                let base = below.join("/");
                let found = [format!("{base}.rs"), format!("{base}/mod.rs")];
                let file = found.into_iter().find(|file| read(file).is_some());
                open.push((below, file.unwrap_or_else(|| panic!("no file of {base}"))));
            }
            modules.at.insert(path.clone(), modules.all.len());
            modules.all.push(Module { path, file, source });
        }
        modules
    }

    /// Whether a file declares modules and re-exports what is in them, and nothing else.
    fn is_table(&self, module: usize) -> bool {
        let Module { path, source, .. } = &self.all[module];
        let own = |import: &Import| {
            let target = self.target(module, &import.of.path, 0);
            target.is_none_or(|at| self.all[at].path.starts_with(path))
        };
        source.declares_only && source.named.is_empty() && source.imports.iter().all(own)
    }

    /// All arrows between files: none of a file that [declares only](Self::is_table), none to one.
    pub fn arrows(&self) -> BTreeSet<Arrow> {
        let mut arrows = BTreeSet::new();
        for (from, module) in self.all.iter().enumerate() {
            if self.is_table(from) {
                continue;
            }
            let imports = module.source.imports.iter().map(|import| &import.of);
            for named in imports.chain(&module.source.named) {
                for to in self.leads_to(from, named) {
                    if to != from {
                        arrows.insert(self.arrow(from, to, named));
                    }
                }
            }
        }
        arrows
    }

    fn arrow(&self, from: usize, to: usize, named: &Named) -> Arrow {
        let [a, b] = [from, to].map(|module| &self.all[module]);
        Arrow {
            from: a.file.clone(),
            to: b.file.clone(),
            modules: [a.path.clone(), b.path.clone()],
            line: named.line,
            path: named.path.join("::"),
        }
    }

    /// The file in which something is that a path names; of a table of modules all that it re-exports.
    fn leads_to(&self, from: usize, named: &Named) -> Vec<usize> {
        let Some(to) = self.target(from, &named.path, 0) else {
            return Vec::new();
        };
        if !self.is_table(to) {
            return vec![to];
        }
        let imports = self.all[to].source.imports.iter();
        let found = imports.filter_map(|import| self.target(to, &import.of.path, 0));
        found.filter(|&at| !self.is_table(at)).collect()
    }

    /// The module that a path leads to; none in another crate, and none for what is no path of modules.
    fn target(&self, from: usize, path: &[String], depth: usize) -> Option<usize> {
        if depth > DEEPEST {
            return None;
        }
        let (first, rest) = path.split_first()?;
        let above = |at: usize| {
            let path = &self.all[at].path;
            self.at.get(&path[..path.len().checked_sub(1)?]).copied()
        };
        match first.as_str() {
            "crate" => self.below(0, rest, depth),
            "self" => self.below(from, rest, depth),
            "super" => {
                let mut at = above(from)?;
                let mut rest = rest;
                while let Some((_, further)) = rest.split_first().filter(|(s, _)| *s == "super") {
                    at = above(at)?;
                    rest = further;
                }
                self.below(at, rest, depth)
            }
            _ => self.found(from, path, depth),
        }
    }

    /// What a path leads to within a module: the module itself where its items are not told apart.
    fn below(&self, at: usize, path: &[String], depth: usize) -> Option<usize> {
        let source = &self.all[at].source;
        let within = path.len() > 1 && source.children.contains(&path[0]);
        if path.is_empty() || source.items.contains(&path[0]) && !within {
            return Some(at);
        }
        let imported = self.is_imported(at, &path[0]);
        let found = self.found(at, path, depth);
        if imported { found } else { found.or(Some(at)) }
    }

    fn is_imported(&self, at: usize, name: &str) -> bool {
        let mut imports = self.all[at].source.imports.iter();
        imports.any(|import| import.name.as_deref() == Some(name))
    }

    /// What a path leads to that begins with a child or an import of a module.
    fn found(&self, at: usize, path: &[String], depth: usize) -> Option<usize> {
        let Module {
            source, path: own, ..
        } = &self.all[at];
        let (name, rest) = path.split_first()?;
        if source.children.contains(name) {
            let child: Vec<String> = own.iter().chain([name]).cloned().collect();
            return self.below(self.at[&child], rest, depth + 1);
        }
        let whole = |import: &Import| import.of.path.iter().chain(rest).cloned().collect();
        if let Some(import) = source
            .imports
            .iter()
            .find(|i| i.name.as_ref() == Some(name))
        {
            let whole: Vec<String> = whole(import);
            // An import that begins with its own name is of another crate.
            return (import.of.path[0] != *name)
                .then(|| self.target(at, &whole, depth + 1))
                .flatten();
        }
        let globs = source.imports.iter().filter(|import| import.name.is_none());
        globs.into_iter().find_map(|import| {
            let held = self.target(at, &import.of.path, depth + 1)?;
            let holds = &self.all[held].source;
            let known = holds.items.contains(name)
                || holds.children.contains(name)
                || self.is_imported(held, name);
            known.then(|| self.below(held, path, depth + 1)).flatten()
        })
    }
}

/// The circles of a crate, of files and of folders: of each module in which two or more children are in one, a shortest.
pub fn circles(arrows: &BTreeSet<Arrow>) -> BTreeMap<String, Vec<&Arrow>> {
    // By the module in which the two that an arrow joins are apart: which of its children leads to which.
    let mut levels: BTreeMap<String, Leads> = BTreeMap::new();
    for arrow in arrows {
        let [a, b] = &arrow.modules;
        let common = a.iter().zip(b).take_while(|(a, b)| a == b).count();
        let child = |path: &[String]| path.get(common).cloned().unwrap_or_default();
        let level = levels.entry(a[..common].join("::")).or_default();
        let leads = level.entry(child(a)).or_default();
        leads.entry(child(b)).or_insert(arrow);
    }
    let found = levels.into_iter();
    found
        .filter_map(|(level, leads)| Some((level, circle(&leads)?)))
        .collect()
}

/// Which child of a module leads to which, and an arrow that does; the module's own file has no name.
type Leads<'a> = BTreeMap<String, BTreeMap<String, &'a Arrow>>;

/// A shortest circle, if there is one.
fn circle<'a>(leads: &Leads<'a>) -> Option<Vec<&'a Arrow>> {
    let from = |start: &String| {
        let mut ways = BTreeMap::from([(start, Vec::new())]);
        let mut open = VecDeque::from([start]);
        while let Some(at) = open.pop_front() {
            for (next, arrow) in leads.get(at).into_iter().flatten() {
                let mut way = ways[at].clone();
                way.push(*arrow);
                if next == start {
                    return Some(way);
                }
                if !ways.contains_key(next) {
                    ways.insert(next, way);
                    open.push_back(next);
                }
            }
        }
        None
    };
    leads.keys().filter_map(from).min_by_key(Vec::len)
}

/// Arrows that point upwards, where `floors` are the modules of a crate's root from the lowest on.
///
/// # Panics
/// If a module is on no floor.
pub fn upward<'a>(arrows: &'a BTreeSet<Arrow>, floors: &[&str]) -> Vec<&'a Arrow> {
    let floor = |path: &Vec<String>| {
        let found = floors
            .iter()
            .position(|floor| path.first().is_some_and(|p| p == floor));
        found.unwrap_or_else(|| panic!("{path:?} is on no floor of {floors:?}"))
    };
    let is_upward = |arrow: &&Arrow| {
        let [from, to] = &arrow.modules;
        floor(from) < floor(to)
    };
    arrows.iter().filter(is_upward).collect()
}
