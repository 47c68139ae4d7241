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
mod validate;

use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};
use std::sync::OnceLock;

/// Runs the program with arguments and text on standard input.
pub fn run(arguments: &[&str], input: &[u8]) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_gaunt"))
        .args(arguments)
        .env("GAUNT_CACHE", cache())
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut stdin = child.stdin.take().expect("standard input is a pipe");
    let input = input.to_vec();
    // Apart from reading, so that neither waits for the other. The program may end before it reads all.
    let writer = std::thread::spawn(move || drop(stdin.write_all(&input)));
    let output = child.wait_with_output().expect("the program ends");
    writer.join().expect("the input was written");
    output
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

/// A folder for one test, empty at first and gone afterwards.
pub struct Folder(PathBuf);

impl Folder {
    /// A folder named after a test.
    pub fn new(test: &str) -> Self {
        let path = std::env::temp_dir().join(format!("gaunt-{test}-{}", std::process::id()));
        let _ = std::fs::remove_dir_all(&path);
        std::fs::create_dir_all(&path).expect("a folder for temporary files");
        Self(path)
    }

    /// The path of a file in it.
    pub fn file(&self, name: &str) -> String {
        self.0
            .join(name)
            .to_str()
            .expect("a path in UTF-8")
            .to_string()
    }

    /// Writes a file into it.
    pub fn put(&self, name: &str, contents: impl AsRef<[u8]>) -> String {
        std::fs::write(self.0.join(name), contents).expect("writing a temporary file");
        self.file(name)
    }

    /// The names of the files in it, sorted.
    pub fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(&self.0).expect("the folder is there");
        let mut names: Vec<_> = entries
            .map(|e| e.unwrap().file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}
