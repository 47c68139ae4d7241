//! Frames of a motion: one file each, the same whatever was rendered before.

use crate::{Folder, run, success};
use serde_json::Value;

const ANIMATED: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../sh-bake/tests/good/animated.gltf"
);

const SMALL: [&str; 4] = ["--size", "32x24", "--backend", "cpu"];

/// A scene in which everything moves.
fn scene(folder: &Folder) -> String {
    let text = format!(
        "[[objects]]\nmesh = {ANIMATED:?}\nspheres = 4\nclip = \"Wave\"\n\
         keys = [{{ time = 0 }}, {{ time = 1, translate = [0, 0, 2], rotate = [0, 90, 0] }}]\nrepeat = true\n\
         [environment]\nturn = 90\n"
    );
    folder.put("scene.toml", text)
}

#[test]
fn every_frame_becomes_a_file_and_stands_for_itself() {
    let folder = Folder::new("frames");
    let scene = scene(&folder);
    let (out, report) = (folder.file("f%03d.png"), folder.file("report.json"));
    let render = |frames: &str, out: &str| {
        let rest = [
            "render", &scene, "--frames", frames, "--fps", "4", "-o", out,
        ];
        success(&[&rest[..], &SMALL, &["--json", &report]].concat())
    };
    let text = render("3..7", &out);
    for sentence in [
        "4 frames, 3 to 6, 4 a second",
        "plays its clip `Wave`",
        "moves along its keys",
        "turns by 90 degrees a second",
        "Time of all 4 frames",
    ] {
        assert!(text.contains(sentence), "no `{sentence}` in: {text}");
    }
    let names: Vec<String> = (3..7).map(|n| format!("f{n:03}.png")).collect();
    let mut expected = names.clone();
    expected.extend(["report.json".to_string(), "scene.toml".to_string()]);
    assert_eq!(folder.names(), expected);
    let read: Value = serde_json::from_slice(&std::fs::read(&report).unwrap()).expect("JSON");
    assert_eq!(
        read["frames"],
        serde_json::json!({"first": 3, "count": 4, "fps": 4.0})
    );
    let stages = read["stages"].as_array().unwrap();
    assert!(stages.iter().any(|stage| stage["stage"] == "pose"));

    let bytes: Vec<_> = names
        .iter()
        .map(|name| std::fs::read(folder.file(name)).unwrap())
        .collect();
    for pair in bytes.windows(2) {
        assert_ne!(pair[0], pair[1], "nothing moved");
    }
    render("5..=5", &folder.file("alone%d.png"));
    assert_eq!(std::fs::read(folder.file("alone5.png")).unwrap(), bytes[2]);
}

#[test]
fn a_mesh_file_plays_its_first_clip_or_the_one_that_is_named() {
    let folder = Folder::new("clips");
    let render = |name: &str, more: &[&str]| {
        let out = folder.file(name);
        let text = success(&[&["render", ANIMATED, "-o", &out], &SMALL[..], more].concat());
        (text, std::fs::read(out.replace("%d", "3")).unwrap())
    };
    let frames = ["--frames", "3..4", "--fps", "4"];
    let (text, first) = render("a%d.png", &frames);
    assert!(text.contains("plays its clip `Wave`"), "{text}");
    assert_eq!(
        render("b%d.png", &[&frames[..], &["--clip", "Wave"]].concat()).1,
        first
    );
    let (text, second) = render("c%d.png", &[&frames[..], &["--clip", "1"]].concat());
    assert!(text.contains("plays its clip `Roll`"), "{text}");
    assert_ne!(first, second);
    // One picture needs no frames, and a clip is then shown as it begins.
    let (text, _) = render("d.png", &["--clip", "Roll"]);
    assert!(text.contains("plays its clip `Roll`"), "{text}");
    let (text, _) = render("e.png", &[]);
    assert!(!text.contains("plays"), "{text}");
}

#[test]
fn where_nothing_moves_it_is_said() {
    let folder = Folder::new("still");
    folder.put("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let (mesh, out) = (folder.file("a.obj"), folder.file("%02d.exr"));
    let text = success(
        &[
            &["render", &mesh, "--frames", "8..10", "-o", &out],
            &SMALL[..],
        ]
        .concat(),
    );
    assert!(text.contains("Nothing in the scene moves"), "{text}");
    let read = |name| std::fs::read(folder.file(name)).unwrap();
    assert_eq!(read("08.exr"), read("09.exr"));
}

#[test]
fn a_clip_that_is_not_there_leaves_no_file() {
    let folder = Folder::new("no-clip");
    let out = folder.file("f%d.png");
    let arguments = [
        "render", ANIMATED, "--frames", "0..2", "--clip", "Walk", "-o", &out,
    ];
    let output = run(&arguments, b"");
    let sentence = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert!(
        sentence.contains("the file has `Wave`, `Roll`."),
        "{sentence}"
    );
    assert!(folder.names().is_empty());
}
