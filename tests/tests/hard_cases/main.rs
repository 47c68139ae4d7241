#![doc = include_str!("../../../docs/HARD_CASES.md")]

use std::path::{Path, PathBuf};

mod blockers;
mod extremes;
mod occlusion;
mod series;
mod stacked;

/// All Rust files below a folder, but for what was built.
fn sources(folder: &Path, out: &mut Vec<PathBuf>) {
    let entries = std::fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    for entry in entries {
        let path = entry.expect("a folder's entry").path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if path.is_dir() && name != "target" && !name.starts_with('.') {
            sources(&path, out);
        } else if path.extension().is_some_and(|e| e == "rs") {
            out.push(path);
        }
    }
}

/// Tests that the page names exist: `modules::test`, where the modules are parts of the file's path.
#[test]
fn every_test_on_the_page_exists() {
    let page = include_str!("../../../docs/HARD_CASES.md");
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut files = Vec::new();
    sources(&root, &mut files);
    let mut count = 0;
    for name in page.split('`').filter(|word| word.contains("::")) {
        let (modules, test) = name.rsplit_once("::").expect("it has colons");
        if ["sh_tests", "hard_cases"].contains(&modules) {
            continue;
        }
        let declared = format!("fn {test}(");
        let modules: Vec<&str> = modules.split("::").filter(|m| *m != "tests").collect();
        let holds = |path: &&PathBuf| {
            let stem = path.with_extension("");
            let is_part = |module: &&str| stem.components().any(|part| part.as_os_str() == *module);
            modules.iter().all(is_part)
                && std::fs::read_to_string(path).is_ok_and(|text| text.contains(&declared))
        };
        // What both backends promise has a test in both.
        let expected = if modules == ["hard_scenes"] { 2 } else { 1 };
        let found = files.iter().filter(holds).count();
        assert!(
            found >= expected,
            "`{name}`: {found} of {expected} tests found"
        );
        count += 1;
    }
    assert!(count > 25, "{count} tests on the page");
}
