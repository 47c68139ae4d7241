//! The program as a person meets it: arguments in, text and files out.

mod misuse;
mod readme;
mod validate;

#[path = "../../../tests/shared/program.rs"]
mod program;
#[path = "../../../tests/shared/readme.rs"]
mod readme_text;

use std::process::Output;

/// Runs the program with arguments. No sphere set of the user's is read or written.
pub fn run(arguments: &[&str]) -> Output {
    let cache = [("GAUNT_CACHE", "")];
    program::run(env!("CARGO_BIN_EXE_gaunt-lab"), &cache, arguments, b"")
}

/// Standard output of a run that has to succeed.
#[track_caller]
pub fn success(arguments: &[&str]) -> String {
    let output = run(arguments);
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(
        output.status.success(),
        "gaunt-lab {arguments:?}: {complaint}"
    );
    String::from_utf8(output.stdout).expect("the output is UTF-8")
}

/// The sentence of a run that has to fail: exit code 1, nothing on standard output, no panic.
#[track_caller]
pub fn failure(arguments: &[&str]) -> String {
    let output = run(arguments);
    let sentence = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(1), "{arguments:?}: {sentence}");
    assert!(output.stdout.is_empty(), "{arguments:?}");
    assert!(!sentence.contains("panicked"), "{arguments:?}: {sentence}");
    sentence
}
