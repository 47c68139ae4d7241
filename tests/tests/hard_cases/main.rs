#![doc = include_str!("../../../docs/HARD_CASES.md")]

mod blockers;
mod extremes;
mod occlusion;
mod series;
mod stacked;

/// Tests that the page names exist.
#[test]
fn every_test_on_the_page_exists() {
    let page = include_str!("../../../docs/HARD_CASES.md");
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut count = 0;
    for name in page.split('`').filter(|word| word.contains("::")) {
        let (module, test) = name.rsplit_once("::").expect("it has colons");
        let paths = match module {
            "sh_tests" | "hard_cases" => continue,
            "saturating" => vec!["tests/tests/saturating.rs".to_string()],
            "motion" => vec!["sh-scene/tests/motion.rs".to_string()],
            "clips" => vec!["sh-bake/tests/clips.rs".to_string()],
            "clusters" => vec!["sh-cpu/tests/clusters.rs".to_string()],
            "self_shadow" => vec!["sh-cpu/tests/self_shadow.rs".to_string()],
            "hard_scenes" => ["sh-cpu/tests", "sh-gpu/tests/gpu"]
                .map(|folder| format!("{folder}/hard_scenes.rs"))
                .to_vec(),
            _ => match module.strip_prefix("shading_cases::") {
                Some(file) => vec![format!("tests/shared/shading_cases/{file}.rs")],
                None => vec![format!("tests/tests/hard_cases/{module}.rs")],
            },
        };
        for path in paths {
            let text = std::fs::read_to_string(root.join(&path))
                .unwrap_or_else(|error| panic!("`{name}`: {path}: {error}"));
            let found = text.contains(&format!("fn {test}("));
            assert!(found, "{path} has no `{test}`");
        }
        count += 1;
    }
    assert!(count > 25, "{count} tests on the page");
}
