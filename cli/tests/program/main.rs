//! The program as a person meets it: arguments in, text and files out.

mod corpus;
mod eval;
mod export;
mod frames;
mod misuse;
mod plan;
mod readme;
mod render;
mod tables;
mod truth;

#[path = "../../../tests/shared/program.rs"]
mod program;
#[path = "../../../tests/shared/readme.rs"]
mod readme_text;

pub use program::Folder;
use std::process::Output;
use std::sync::OnceLock;

/// Runs the program with arguments and text on standard input.
pub fn run(arguments: &[&str], input: &[u8]) -> Output {
    let cache = [("GAUNT_CACHE", cache())];
    program::run(env!("CARGO_BIN_EXE_gaunt"), &cache, arguments, input)
}

/// A folder for sphere sets, empty at first: all runs of these tests share it, and never the user's own.
fn cache() -> &'static str {
    static CACHE: OnceLock<&str> = OnceLock::new();
    CACHE.get_or_init(|| {
        let folder = concat!(env!("CARGO_TARGET_TMPDIR"), "/program-cache");
        let _ = std::fs::remove_dir_all(folder);
        folder
    })
}

/// Standard output of a run that has to succeed.
#[track_caller]
pub fn success(arguments: &[&str]) -> String {
    let output = run(arguments, b"");
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "gaunt {arguments:?}: {complaint}");
    String::from_utf8(output.stdout).expect("the output is UTF-8")
}
