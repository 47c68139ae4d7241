//! Reads from the items of a module what its entry points are bound to. Only the build script does.

use crate::link::{Item, reached};
use std::fmt::Write;

/// An entry point.
pub struct Entry {
    pub name: String,
    /// A variant of `Stage`.
    stage: &'static str,
    bound: Vec<Declared>,
}

/// A declaration of something that is bound.
struct Declared {
    group: u32,
    binding: u32,
    name: String,
    ty: String,
    /// A variant of `Kind`.
    kind: &'static str,
}

/// The entry points of a module, with what they reach. Items are those of the module and of its imports.
pub fn entries(items: &[Item]) -> Result<Vec<Entry>, String> {
    let entry = |entry: &Item| {
        let reached = reached(items, |item| item.name == entry.name).into_iter();
        let bound = reached.filter_map(|item| declared(item).transpose());
        let mut bound = bound.collect::<Result<Vec<_>, _>>()?;
        bound.sort_by_key(|of| (of.group, of.binding));
        Ok(Entry {
            name: entry.name.clone(),
            stage: stage(&entry.code),
            bound,
        })
    };
    items.iter().filter(|item| item.entry).map(entry).collect()
}

/// Entry points as Rust text: the elements of a slice of `EntryPoint`.
pub fn rust(entries: &[Entry]) -> String {
    let mut text = String::new();
    for Entry { name, stage, bound } in entries {
        let _ = write!(
            text,
            "EntryPoint {{ name: {name:?}, stage: Stage::{stage}, bindings: &["
        );
        for of in bound {
            let Declared {
                group,
                binding,
                name,
                ty,
                kind,
            } = of;
            let _ = write!(
                text,
                "Binding {{ group: {group}, binding: {binding}, name: {name:?}, ty: {ty:?}, kind: Kind::{kind} }}, "
            );
        }
        text += "] }, ";
    }
    text
}

impl Entry {
    /// What a group holds, for a reader.
    pub fn words(&self, group: u32) -> String {
        let bound = self.bound.iter().filter(|of| of.group == group);
        let words = bound.map(|of| match of.kind {
            "Read" => of.name.clone(),
            "Uniform" => format!("{} (uniform)", of.name),
            "Written" => format!("{} (written)", of.name),
            "Target" => format!("{} (texture, written)", of.name),
            _ => format!("{} (texture)", of.name),
        });
        words.collect::<Vec<_>>().join(", ")
    }
}

fn stage(code: &str) -> &'static str {
    match (code.contains("@vertex"), code.contains("@fragment")) {
        (true, _) => "Vertex",
        (_, true) => "Fragment",
        _ => "Compute",
    }
}

/// What an item binds, if it does.
fn declared(item: &Item) -> Result<Option<Declared>, String> {
    let code = item.code.trim();
    if !code.starts_with("@group(") {
        return Ok(None);
    }
    let odd = || {
        format!(
            "`{code}` was expected to read `@group(g) @binding(b) var<space> name: type;`, or \
             `@group(g) @binding(b) var name: texture;` of a kind that kernels/src/declared.rs knows"
        )
    };
    let number = |attribute: &str| {
        let (_, rest) = code.split_once(attribute)?;
        rest.split_once(')')?.0.parse::<u32>().ok()
    };
    let (group, binding) = number("@group(").zip(number("@binding(")).ok_or_else(odd)?;
    let (head, ty) = code.split_once(": ").ok_or_else(odd)?;
    let ty = ty.trim_end_matches(';').to_string();
    let (_, space) = head.split_once("var").ok_or_else(odd)?;
    let texture = !space.starts_with('<');
    let kind = match (space.split_once('>').map(|(space, _)| space), ty.as_str()) {
        (Some("<uniform"), _) => "Uniform",
        (Some("<storage, read_write"), _) => "Written",
        (Some("<storage, read"), _) => "Read",
        (_, "texture_2d<f32>") if texture => "Floats",
        (_, "texture_2d<u32>") if texture => "Integers",
        (_, "texture_depth_2d") if texture => "Depth",
        (_, "texture_storage_2d<rgba16float, write>") if texture => "Target",
        _ => return Err(odd()),
    };
    Ok(Some(Declared {
        group,
        binding,
        name: item.name.clone(),
        ty,
        kind,
    }))
}
