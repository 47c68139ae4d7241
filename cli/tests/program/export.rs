//! Files that other renderers include.

use crate::{Folder, run, success};
use std::process::Output;

const CHECKED_IN: &str = include_str!("../../../kernels/include/sh4.wgsl");

fn complaint(output: &Output) -> String {
    assert!(!output.status.success());
    String::from_utf8_lossy(&output.stderr).into_owned()
}

#[test]
fn wgsl_is_what_is_checked_in() {
    let folder = Folder::new("export-wgsl");
    let out = folder.file("deep/er");
    let said = success(&["export", "--lang", "wgsl", "-o", &out]);
    assert!(said.contains("sh4.wgsl"), "{said}");
    let text = std::fs::read_to_string(format!("{out}/sh4.wgsl")).unwrap();
    assert!(text == CHECKED_IN);
}

#[test]
fn glsl_comes_in_three_versions_and_halves_in_two() {
    let folder = Folder::new("export-glsl");
    let out = folder.file("all");
    let base = [
        "export", "--lang", "glsl", "--order", "2", "--prefix", "mine_", "-o",
    ];
    success(&[base.as_slice(), &[&out, "--routines", "dot,zonal"]].concat());
    let names = |folder: &str| -> Vec<String> {
        let files = std::fs::read_dir(folder).unwrap();
        let mut names: Vec<_> = files
            .map(|f| f.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    };
    assert_eq!(
        names(&out),
        ["mine_300es.glsl", "mine_330.glsl", "mine_450.glsl"]
    );
    let text = std::fs::read_to_string(format!("{out}/mine_330.glsl")).unwrap();
    assert!(text.contains("float mine_dot(float f[4], float g[4])"));
    let out = folder.file("halves");
    success(&[base.as_slice(), &[&out, "--routines", "pack_half"]].concat());
    assert_eq!(names(&out), ["mine_300es.glsl", "mine_450.glsl"]);
}

#[test]
fn everything_fits_into_one_archive() {
    let folder = Folder::new("export-archive");
    let [first, second] = ["a.tar.gz", "b.tar.gz"].map(|name| folder.file(name));
    let said = success(&["export", "--all", "-o", &first]);
    // Eight files an order, notes on the two that are bytes, and the page and the licences.
    assert_eq!(said.lines().count(), 5 * 10 + 3 + 1, "{said}");
    success(&["export", "--all", "-o", &second]);
    let [first, second] = [first, second].map(|path| std::fs::read(path).unwrap());
    assert!(first == second);
    assert_eq!(folder.names(), ["a.tar.gz", "b.tar.gz"]);
    let mut archive = tar::Archive::new(flate2::read::GzDecoder::new(first.as_slice()));
    let names: Vec<_> = archive
        .entries()
        .unwrap()
        .map(|entry| entry.unwrap().path().unwrap().display().to_string())
        .collect();
    assert_eq!(names.len(), 53);
    let inside = concat!("gaunt-shaders-", env!("CARGO_PKG_VERSION"), "/sh6.hlsl");
    assert!(names.iter().any(|name| name == inside));
}

#[test]
fn what_cannot_be_exported_is_told_and_leaves_nothing() {
    let folder = Folder::new("export-misuse");
    let out = folder.file("nothing");
    let try_it = |arguments: &[&str]| {
        let all = [&["export", "-o", &out], arguments].concat();
        complaint(&run(&all, b""))
    };
    let unknown = try_it(&["--lang", "msl", "--routines", "divide"]);
    assert!(
        unknown.contains("no routine `divide`; there are accumulate_blocker, "),
        "{unknown}"
    );
    assert!(try_it(&["--lang", "cuda"]).contains("wgsl, glsl, hlsl, msl and spirv"));
    assert!(try_it(&["--lang", "wgsl", "--order", "7"]).contains("2 to 6"));
    assert!(try_it(&["--lang", "hlsl", "--prefix", "9"]).contains("a prefix is a letter"));
    assert!(try_it(&[]).contains("--lang"));
    assert!(folder.names().is_empty());
    let file = folder.put("file", "");
    let blocked = complaint(&run(&["export", "--lang", "wgsl", "-o", &file], b""));
    assert!(blocked.contains("make the folder"), "{blocked}");
}
