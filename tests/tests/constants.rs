//! A number that kernels and Rust both need stands in neither: both get it from the table of `sh_codegen::constants`.

use sh_codegen::constants::{self, Constant, Value};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Where kernels are, and where Rust computes the same.
const KERNELS: [&str; 1] = ["kernels"];
const RUST: [&str; 5] = [
    "sh-core/src",
    "sh-scene/src",
    "sh-cpu/src",
    "sh-gpu/src",
    "kernels/src",
];

fn files(folder: &Path, extension: &str, out: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("a folder of the repository") {
        let path = entry.expect("a folder's entry").path();
        // What is exported is printed from the rest.
        if path.is_dir() && !path.ends_with("include") {
            files(&path, extension, out);
        } else if path.extension().is_some_and(|e| e == extension) {
            out.push(path);
        }
    }
}

/// A line of code, without its comment, and where it stands.
struct Line {
    file: String,
    code: String,
}

/// All lines of some folders that are code.
fn lines(folders: &[&str], extension: &str) -> Vec<Line> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut paths = Vec::new();
    for folder in folders {
        files(&root.join(folder), extension, &mut paths);
    }
    let of = |path: &PathBuf| {
        let text = std::fs::read_to_string(path).expect("a file of the repository");
        let file = path.strip_prefix(&root).expect("within").display();
        let line = |line: &str| Line {
            file: file.to_string(),
            code: line.split("//").next().unwrap_or_default().to_string(),
        };
        text.lines().map(line).collect::<Vec<_>>()
    };
    paths.iter().flat_map(of).collect()
}

/// Words and numbers of a line of code.
fn words(code: &str) -> impl Iterator<Item = &str> {
    code.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == '.'))
        .flat_map(|word| word.split(".."))
        .filter(|word| !word.is_empty())
}

fn is_number(word: &str) -> bool {
    word.starts_with(|c: char| c.is_ascii_digit())
}

/// The constants whose value is typed, not made of others: each with the file that it is in.
fn typed(lines: &[Line]) -> BTreeMap<String, String> {
    let typed = |line: &Line| {
        let (_, rest) = line.code.split_once("const ")?;
        let (name, value) = rest.split_once(" = ")?;
        let (name, _) = name.split_once(':')?;
        // As in `u32::MAX`.
        let limit = |word: &str| ["u8", "u32", "f32", "MAX"].contains(&word);
        let mut words = words(value);
        words
            .all(|word| is_number(word) || limit(word))
            .then_some(name.to_string())
    };
    let found = lines
        .iter()
        .filter_map(|line| Some((typed(line)?, line.file.clone())));
    found.collect()
}

/// Numbers of at least four significant digits, as both languages round them: few of them mean two things. Each with the
/// file that it is in.
fn telling(lines: &[Line]) -> BTreeMap<u32, String> {
    let number = |word: &str| {
        let word = word.replace('_', "");
        let digits = word.split('e').next()?.replace('.', "");
        let telling = word.contains('.') && digits.trim_matches('0').len() >= 4;
        let value = word.trim_end_matches("f32").trim_end_matches("f64");
        value
            .parse::<f64>()
            .ok()
            .filter(|_| telling && is_number(&word))
    };
    let mut all = BTreeMap::new();
    for line in lines {
        for value in words(&line.code).filter_map(number) {
            all.insert(
                (value as f32).to_bits(),
                format!("{value} in {}", line.file),
            );
        }
    }
    all
}

#[test]
fn no_constant_is_typed_in_both_languages() {
    let [kernels, rust] = [lines(&KERNELS, "wgsl"), lines(&RUST, "rs")];
    let [kernels, rust] = [typed(&kernels), typed(&rust)];
    let mut twice = Vec::new();
    for (name, file) in &kernels {
        if let Some(twin) = rust.get(name) {
            twice.push(format!("{name} in {file} and {twin}"));
        }
    }
    for (name, file) in kernels.iter().chain(&rust) {
        if constants::find(name).is_some() {
            twice.push(format!("{name} in {file} and the table"));
        }
    }
    assert!(twice.is_empty(), "{}", twice.join("\n"));
    // The reader itself: it has to find those that are in one language alone.
    assert!(kernels.contains_key("LARGEST_SHARE") && kernels.contains_key("NO_LAMP"));
    assert!(rust.contains_key("MIN_WEIGHT") && rust.contains_key("MIN_ORDER"));
}

#[test]
fn no_number_is_typed_in_both_languages() {
    let [kernels, rust] = [lines(&KERNELS, "wgsl"), lines(&RUST, "rs")];
    let [kernels, rust] = [telling(&kernels), telling(&rust)];
    let both = kernels.iter().filter_map(|(value, place)| {
        let twin = rust.get(value)?;
        Some(format!("{place} and {twin}"))
    });
    let single = |constant: &Constant| match constant.value {
        Value::Double(value) => Some((value as f32).to_bits()),
        Value::Single(value) => Some(value.to_bits()),
        _ => None,
    };
    let named = constants::all().filter_map(|constant| Some((single(constant)?, constant.name)));
    let shared: BTreeMap<u32, &str> = named.collect();
    let again = kernels.iter().chain(&rust).filter_map(|(value, place)| {
        let name = shared.get(value)?;
        Some(format!("{place} is {name} of the table"))
    });
    let twice: Vec<String> = both.chain(again).collect();
    assert!(twice.is_empty(), "{}", twice.join("\n"));
    let known = |all: &BTreeMap<u32, String>, value: f32| all.contains_key(&value.to_bits());
    assert!(known(&kernels, 57.295_78) && known(&rust, 0.693_359_4));
}

#[test]
fn shared_constants_are_used_in_both_languages() {
    let [kernels, rust] = [lines(&KERNELS, "wgsl"), lines(&RUST, "rs")];
    let [kernels, rust] = [&kernels, &rust].map(|lines| {
        let words = lines.iter().flat_map(|line| words(&line.code));
        words.collect::<BTreeSet<&str>>()
    });
    let lonely = constants::all()
        .map(|constant| constant.name)
        .filter(|name| !(kernels.contains(name) && rust.contains(name)));
    let lonely: Vec<&str> = lonely.collect();
    assert!(
        lonely.is_empty(),
        "one language alone has {lonely:?}: they belong where they are used"
    );
}
