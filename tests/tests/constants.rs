//! Constants that stand both in kernels and in Rust have one value.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Kernels' names of what is called otherwise in Rust.
const RENAMED: [(&str, &str); 6] = [
    ("ASIDE_EDGE", "EDGE"),
    ("MOST_LAMPS", "LAMPS"),
    ("WHOLE", "ROOT_FOUR_PI"),
    ("HIGHEST", "COEFFICIENTS"),
    ("HALF_MAX", "LARGEST"),
    ("ROOM", "KEPT"),
];

/// Names that mean something else in each language.
const UNRELATED: [&str; 4] = ["CHUNK", "LARGEST", "NONE", "STEPS"];

fn files(folder: &Path, extension: &str, out: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("a folder of the repository") {
        let path = entry.expect("a folder's entry").path();
        if path.is_dir() {
            files(&path, extension, out);
        } else if path.extension().is_some_and(|e| e == extension) {
            out.push(path);
        }
    }
}

/// The value of a number, or of a quotient or product of two, of either language.
fn value(text: &str) -> Option<f64> {
    for (sign, apply) in [
        ('/', (|a, b| a / b) as fn(f64, f64) -> f64),
        ('*', |a, b| a * b),
    ] {
        if let Some((a, b)) = text.split_once(sign) {
            return Some(apply(value(a)?, value(b)?));
        }
    }
    let text = text.trim().replace('_', "");
    if text.ends_with("PI") {
        return Some(std::f64::consts::PI);
    }
    if let Some(hex) = text.strip_prefix("0x") {
        let whole = u32::from_str_radix(hex.trim_end_matches('u'), 16);
        return whole.ok().map(f64::from);
    }
    text.trim_end_matches('u').parse().ok()
}

/// All constants that are numbers, by name: where each is and what it is.
fn constants(folders: &[&str], extension: &str) -> BTreeMap<String, Vec<(PathBuf, f64)>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut all: BTreeMap<String, Vec<(PathBuf, f64)>> = BTreeMap::new();
    let mut paths = Vec::new();
    for folder in folders {
        files(&root.join(folder), extension, &mut paths);
    }
    for path in paths {
        let text = std::fs::read_to_string(&path).expect("a file of the repository");
        for line in text.lines() {
            let line = line.trim();
            let line = line.strip_prefix("pub(crate) ").unwrap_or(line);
            let line = line.strip_prefix("pub ").unwrap_or(line);
            let declared = line.strip_prefix("const ").and_then(|rest| {
                let (name, rest) = rest.split_once(": ")?;
                let (_, rest) = rest.split_once(" = ")?;
                Some((name, value(rest.split(';').next()?)?))
            });
            if let Some((name, value)) = declared {
                let found = all.entry(name.into()).or_default();
                found.push((path.clone(), value));
            }
        }
    }
    all
}

#[test]
fn kernels_and_rust_have_the_same_constants() {
    // What is exported is printed from these.
    let mut kernels = constants(&["kernels"], "wgsl");
    kernels.retain(|name, _| !name.starts_with("sh"));
    let rust = constants(
        &["sh-core/src", "sh-scene/src", "sh-cpu/src", "kernels/src"],
        "rs",
    );
    let mut compared = Vec::new();
    let mut broken = Vec::new();
    for (name, found) in &kernels {
        let renamed = RENAMED.iter().find(|(kernel, _)| kernel == name);
        let twin = renamed.map_or(name.as_str(), |(_, rust)| rust);
        if UNRELATED.contains(&name.as_str()) {
            continue;
        }
        let Some(twins) = rust.get(twin) else {
            assert!(renamed.is_none(), "{twin} is no constant of Rust");
            println!("{name}: no twin");
            continue;
        };
        compared.push(name.as_str());
        for (path, value) in found {
            // What a kernel calls so may be the twin of one of several.
            let same = |(_, twin): &(PathBuf, f64)| (twin - value).abs() <= 1e-7 * value.abs();
            if !twins.iter().any(same) {
                broken.push(format!(
                    "{name} is {value} in {}, {twins:?}",
                    path.display()
                ));
            }
        }
    }
    println!("{} compared: {compared:?}", compared.len());
    assert!(broken.is_empty(), "{}", broken.join("\n"));
    assert!(compared.len() >= 15, "{compared:?}");
}
