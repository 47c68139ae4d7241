//! The linker: imports, placeholders, pruning, and what it says when something is wrong.

#[path = "../src/link.rs"]
#[expect(dead_code, reason = "what items are made of is the build script's")]
mod link;

use link::{Choice, Library, LinkError, Modules};

fn files(list: &[(&str, &str)]) -> impl Fn(&str) -> Option<String> + use<> {
    let list: Vec<(String, String)> = list
        .iter()
        .map(|(n, t)| (n.to_string(), t.to_string()))
        .collect();
    move |name| list.iter().find(|(n, _)| n == name).map(|(_, t)| t.clone())
}

fn of(order: usize) -> Choice {
    Choice {
        order,
        accumulation: 6,
    }
}

fn link(
    root: &str,
    choice: Choice,
    read: &dyn Fn(&str) -> Option<String>,
) -> Result<String, LinkError> {
    let library = Library::new("fn helper() {\n}\n\nfn idle() {\n}\n")?;
    let constants =
        Library::new("const SIZE: u32 = 4u;\n\n// Of nobody.\nconst SPARE: u32 = 5u;\n")?;
    let modules = Modules {
        read,
        libraries: &[&library],
        constants: &constants,
    };
    Ok(link::flat(&link::items(root, choice, modules)?, &constants))
}

#[test]
fn of_the_library_only_what_is_reached_stays() {
    let pass = format!("#import library\nfn used() {{\n    helper();\n}}\n{MAIN}");
    let text = link("pass", of(4), &files(&[("pass", &pass)])).unwrap();
    assert!(text.contains("fn helper()") && !text.contains("idle"));
}

#[test]
fn of_shared_constants_only_what_is_mentioned_stays() {
    let used = "#import constants\nfn used() {\n    let size = SIZE;\n}\n";
    // Where there is an entry point, and where all else stays.
    for (text, all) in [
        (format!("{used}{MAIN}"), false),
        (format!("#import library\n{used}"), true),
    ] {
        let text = link("pass", of(4), &files(&[("pass", &text)])).unwrap();
        assert_eq!(text.matches("const SIZE: u32 = 4u;").count(), 1, "{text}");
        assert!(
            !text.contains("SPARE") && !text.contains("nobody"),
            "{text}"
        );
        assert_eq!(text.contains("idle"), all);
    }
}

const MAIN: &str = "@compute @workgroup_size(64)\nfn main() {\n    used();\n}\n";

#[test]
fn imports_come_first_and_once() {
    let pass = format!("#import a\n#import b\n{MAIN}");
    let read = files(&[
        ("pass", &pass),
        ("a", "#import b\nfn used() {\n    deep();\n}\n"),
        ("b", "fn deep() {}\n"),
    ]);
    let text = link("pass", of(4), &read).unwrap();
    assert_eq!(text.matches("fn deep()").count(), 1);
    let at = |what: &str| text.find(what).unwrap();
    assert!(at("fn deep()") < at("fn used()") && at("fn used()") < at("fn main()"));
}

#[test]
fn unused_items_go_and_keep_their_comments_to_themselves() {
    let pass = format!(
        "// About the file.\n\n// Unused.\nfn idle() {{}}\n\nconst SIZE: u32 = 4u;\n\n\
         // Used.\nfn used() {{\n    let size = SIZE;\n}}\n{MAIN}"
    );
    let text = link("pass", of(4), &files(&[("pass", &pass)])).unwrap();
    assert!(text.contains("// Used.\nfn used()") && text.contains("const SIZE"));
    assert!(!text.contains("idle") && !text.contains("Unused.") && !text.contains("About"));
}

#[test]
fn fields_and_variables_are_no_items() {
    let pass = format!(
        "fn idle() {{\n}}\n\nfn lazy() {{\n}}\n\nfn used(lazy: Wide) -> f32 {{\n    let width = lazy.idle;\n    \
         return width;\n}}\n\nstruct Wide {{\n    idle: f32,\n}}\n{MAIN}"
    );
    let text = link("pass", of(4), &files(&[("pass", &pass)])).unwrap();
    assert!(text.contains("struct Wide") && !text.contains("fn idle") && !text.contains("fn lazy"));
}

#[test]
fn placeholders_are_filled_in() {
    let pass = format!(
        "fn used() {{\n    var f: array<f32, $C> = sh$N_narrow(sh$A_wide($Bu));\n}}\n{MAIN}"
    );
    let text = link("pass", of(3), &files(&[("pass", &pass)])).unwrap();
    assert!(text.contains("array<f32, 9> = sh3_narrow(sh6_wide(36u))"));
}

fn error(pass: &str) -> LinkError {
    link(
        "shadow",
        of(4),
        &files(&[("shadow", pass), ("bad", "\n\nfn f() {\n    $Q\n}\n")]),
    )
    .unwrap_err()
}

#[test]
fn errors_name_file_and_line() {
    let unknown = error(&format!("{MAIN}\n#import shared/nowhere\n"));
    assert_eq!((unknown.file.as_str(), unknown.line), ("shadow.wgsl", 6));
    assert!(
        unknown
            .to_string()
            .starts_with("shadow.wgsl:6: imports `shared/nowhere`")
    );
    let placeholder = error("#import bad\n");
    assert_eq!(
        (placeholder.file.as_str(), placeholder.line),
        ("bad.wgsl", 4)
    );
    assert!(placeholder.message.contains("`$Q`"));
    let open = error("fn f() {\n    return;\n");
    assert_eq!(open.line, 2);
    let nameless = error("}\n");
    assert_eq!(nameless.line, 1);
    assert_eq!(
        link("none", of(4), &files(&[])).unwrap_err().file,
        "none.wgsl"
    );
}
