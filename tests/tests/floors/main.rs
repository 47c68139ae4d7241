//! Arrows between the files of a crate point downwards only: what files name of each other, by `use` or where they need it,
//! makes no circle, neither of files nor of folders, and where a crate has floors, nothing leads to a higher one.
//!
//! A file that only declares modules and re-exports what is in them is passed through. What is built for tests alone may
//! look at the house from above. Methods are found by their types, which are paths; where they are defined is not looked at.

mod arrows;
mod source;

use arrows::{Modules, circles, upward};
use std::path::Path;

/// The floors of sh-cpu, from the lowest on.
const FLOORS: [&str; 6] = ["error", "lanes", "device", "passes", "store", "run"];

/// Modules whose children are in a circle, and why they still are.
const KNOWN: [(&str, &str, &str); 14] = [
    (
        "sh-core",
        "convention",
        "engines' files use helpers that stand in the table of engines",
    ),
    (
        "kernels",
        "export",
        "the steps of an export return the error of the whole",
    ),
    (
        "sh-scene",
        "",
        "a light is made of emitters, whose errors are those of lights",
    ),
    (
        "sh-scene",
        "blockers",
        "the forest is made of what its parent defines and re-exports it",
    ),
    (
        "sh-scene",
        "motion",
        "parts of a motion return the error of the whole",
    ),
    (
        "sh-scene",
        "plan",
        "passes, checks and schedules are about the plan, which calls them",
    ),
    (
        "sh-gpu",
        "",
        "a kernel asks for pipelines, which are kept by what kernels are",
    ),
    (
        "lab",
        "accuracy",
        "charts and tables are children of the module that defines their rows",
    ),
    (
        "lab",
        "accuracy::chart",
        "a chart and the chart of two share heads and axes",
    ),
    (
        "lab",
        "bench",
        "what a world's bodies send is of the world's order",
    ),
    (
        "lab",
        "bench::rays",
        "scenes use the numbers of the bench that runs them",
    ),
    (
        "lab",
        "bench::scenes",
        "scenes are built of the plans, faces and lamps of their table",
    ),
    ("lab", "fit", "fits print rows as the whole does"),
    (
        "lab",
        "validate",
        "the report is printed by a child of the module that defines it",
    ),
];

/// The workspace's crates: folder and root file, of programs as well.
fn roots() -> Vec<(String, &'static str)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let text = std::fs::read_to_string(root.join("Cargo.toml")).expect("the workspace");
    let workspace: toml::Table = text.parse().expect("the workspace's TOML");
    let members = workspace["workspace"]["members"]
        .as_array()
        .expect("members");
    let members = members.iter().filter_map(toml::Value::as_str);
    let all =
        members.flat_map(|member| ["lib.rs", "main.rs"].map(|file| (member.to_string(), file)));
    all.filter(|(member, file)| root.join(member).join("src").join(file).exists())
        .collect()
}

fn modules(member: &str, file: &str) -> Modules {
    let sources = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("..")
        .join(member)
        .join("src");
    Modules::new(file, |file| {
        std::fs::read_to_string(sources.join(file)).ok()
    })
}

#[test]
fn no_crate_has_a_circle() {
    let mut wrong = Vec::new();
    let mut known = Vec::new();
    let roots = roots();
    assert!(roots.len() >= 12, "{roots:?}");
    for (member, file) in &roots {
        let arrows = modules(member, file).arrows();
        for (level, circle) in circles(&arrows) {
            if KNOWN.iter().any(|(m, l, _)| m == member && *l == level) {
                known.push((member.clone(), level));
                continue;
            }
            let steps: Vec<String> = circle.iter().map(|arrow| format!("    {arrow}")).collect();
            wrong.push(format!(
                "{member}: a circle in `{level}`\n{}",
                steps.join("\n")
            ));
        }
    }
    for (member, level, _) in KNOWN {
        if !known.contains(&(member.into(), level.into())) {
            wrong.push(format!(
                "{member}: no circle in `{level}` any more, so that it need not be known"
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn nothing_leads_to_a_higher_floor_of_sh_cpu() {
    let arrows = modules("sh-cpu", "lib.rs").arrows();
    assert!(arrows.len() > 100, "{}", arrows.len());
    let upward = upward(&arrows, &FLOORS);
    let lines: Vec<String> = upward.iter().map(ToString::to_string).collect();
    assert!(lines.is_empty(), "{}", lines.join("\n"));
}

/// A crate of these files.
fn made(files: &[(&str, &str)]) -> Modules {
    let text = |name: &str| {
        files
            .iter()
            .find(|(file, _)| *file == name)
            .map(|(_, text)| (*text).into())
    };
    Modules::new("lib.rs", text)
}

/// The levels of its circles, and the arrows that lead to a higher of two floors.
fn found(files: &[(&str, &str)]) -> (Vec<String>, Vec<String>) {
    let arrows = made(files).arrows();
    let upward = upward(&arrows, &["low", "high"]);
    let upward = upward.iter().map(ToString::to_string).collect();
    (circles(&arrows).into_keys().collect(), upward)
}

const LIB: (&str, &str) = (
    "lib.rs",
    "//! A crate.\nmod low;\nmod high;\npub use high::{High, make};\npub use low::Low;",
);

#[test]
fn an_arrow_is_seen_whatever_way_it_is_written() {
    let high = ("high.rs", "pub struct High; pub fn make() -> High { High }");
    let down = (
        "high.rs",
        "use crate::Low; pub struct High(Low); pub fn make() -> High { High(Low) }",
    );
    assert_eq!(
        found(&[LIB, down, ("low.rs", "pub struct Low;")]),
        (vec![], vec![])
    );
    for low in [
        "use crate::high::High; pub struct Low(High);",
        "use crate::{high::{self as above}}; pub struct Low(above::High);",
        "use super::High; pub struct Low(High);",
        "pub struct Low(crate::High);",
        "pub struct Low; fn f() { use crate::high::make; make(); }",
        "pub struct Low; mod inner { pub fn f() -> super::super::High { super::super::make() } }",
        "pub struct Low; macro_rules! m { () => { $crate::make() }; }",
        "use super::*; pub struct Low(High);",
    ] {
        let (circles, up) = found(&[LIB, high, ("low.rs", low)]);
        assert!(
            circles.is_empty() && !up.is_empty(),
            "{low}: {circles:?}, {up:?}"
        );
        assert!(
            up[0].starts_with("low.rs:1 leads to high.rs by `"),
            "{up:?}"
        );
        assert_eq!(found(&[LIB, down, ("low.rs", low)]).0, [""], "{low}");
    }
    for low in [
        "/// Below [`crate::High`].\npub struct Low;",
        "pub struct Low; #[cfg(test)] mod tests { use crate::High; fn f(_: High) {} }",
        "use elsewhere::high::High; pub struct Low(High);",
        "pub struct Low; mod inner { use super::Low; pub fn f(_: Low) {} }",
    ] {
        assert_eq!(
            found(&[LIB, high, ("low.rs", low)]),
            (vec![], vec![]),
            "{low}"
        );
    }
}

#[test]
fn folders_may_be_in_a_circle_where_no_files_are() {
    let files = |d: &'static str| {
        [
            ("lib.rs", "mod low;\nmod high;"),
            ("high.rs", "mod a;\nmod b;\npub use a::A;\npub use b::B;"),
            ("high/a.rs", "pub struct A(crate::low::C);"),
            ("high/b.rs", "pub struct B;"),
            ("low.rs", "mod c;\nmod d;\npub use c::C;"),
            ("low/c.rs", "pub struct C;"),
            ("low/d.rs", d),
        ]
    };
    let (circles, up) = found(&files("pub struct D;"));
    assert!(circles.is_empty() && up.is_empty(), "{circles:?} {up:?}");
    assert_eq!(found(&files("pub struct D(crate::high::B);")).0, [""]);
    // A child that needs what its parent defines, and is needed there.
    let parent = (
        "low.rs",
        "mod c;\nmod d;\npub use c::C;\npub const ONE: u32 = c::TWO;",
    );
    let mut files = files("pub struct D;");
    files[4] = parent;
    files[5] = ("low/c.rs", "pub struct C; pub const TWO: u32 = super::ONE;");
    assert_eq!(found(&files).0, ["low"]);
}
