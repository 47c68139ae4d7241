//! `gaunt plan`: passes, reasons, and what each costs.

use crate::{Folder, run, success};
use serde_json::Value;

const SMALL: [&str; 4] = ["--size", "40x30", "--backend", "cpu"];

/// Two bodies, one of which moves, that light each other.
fn scene(folder: &Folder) -> String {
    scene_with(
        folder,
        "keys = [{ time = 0 }, { time = 1, translate = [0, 1, 0] }]\n",
    )
}

/// The same with a motion of choice.
fn scene_with(folder: &Folder, motion: &str) -> String {
    let tetra = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    folder.put("tetra.obj", tetra);
    let text = format!(
        "[[objects]]\nmesh = \"tetra.obj\"\nspheres = 4\n{motion}\
        [[objects]]\nmesh = \"tetra.obj\"\nspheres = 4\ntranslate = [2, 0, 0]\n\
        [indirect]\nmethod = \"spherical-lights\"\n"
    );
    folder.put("scene.toml", text)
}

fn plan(arguments: &[&str]) -> Value {
    plan_of(arguments, "40x30")
}

fn plan_of(arguments: &[&str], size: &str) -> Value {
    let usual = ["--size", size, "--backend", "cpu", "--json"];
    let text = success(&[&["plan"], arguments, &usual].concat());
    serde_json::from_str(&text).expect("JSON")
}

fn names(list: &Value) -> Vec<&str> {
    let all = list.as_array().expect("a list").iter();
    all.map(|entry| entry["name"].as_str().expect("a name"))
        .collect()
}

#[test]
fn a_plan_tells_passes_and_their_cost() {
    let folder = Folder::new("plan");
    let scene = scene(&folder);
    let told = plan(&[&scene]);
    let passes = told["passes"].as_array().expect("passes");
    for pass in passes {
        for key in ["dispatches", "bytes", "ms", "estimated_ms"] {
            assert!(pass[key].as_f64().is_some_and(|n| n > 0.0), "{key}: {pass}");
        }
        let reason = pass["reason"].as_str().expect("a reason");
        assert!(reason.ends_with('.'), "{reason}");
    }
    // Times are those of the passes: together most of a frame and no more than it, and more for more pixels.
    let ms = |told: &Value, name: &str| -> f64 {
        let passes = told["passes"].as_array().expect("passes").iter();
        let named = passes.filter(|pass| name.is_empty() || pass["name"] == name);
        named.map(|pass| pass["ms"].as_f64().expect("a time")).sum()
    };
    let large = plan_of(&[&scene], "320x240");
    let frame = large["frame_ms"].as_f64().expect("a time");
    let share = ms(&large, "") / frame;
    assert!(
        (0.5..1.2).contains(&share),
        "passes take {share} of a frame"
    );
    for name in ["gbuffer", "shadow", "resolve"] {
        let [few, many] = [&told, &large].map(|told| ms(told, name));
        assert!(
            many > 4.0 * few,
            "{name}: {few} ms, {many} for 64 times the pixels"
        );
    }
    let found = names(&told["passes"]);
    for name in [
        "light_update",
        "gbuffer",
        "shadow",
        "light_gather",
        "upsample",
        "resolve",
    ] {
        assert!(found.contains(&name), "{name}: {found:?}");
    }
    // One of both bodies stands still, and the sky does.
    let idle = names(&told["idle"]);
    assert!(
        idle.contains(&"blockers") && idle.contains(&"light"),
        "{idle:?}"
    );
    assert_eq!(told["projections"], 0);
    assert_eq!(
        names(&told["left_out"]),
        ["irradiance", "punctual", "lamps"]
    );
    let bytes = |list: &str| -> u64 {
        let all = told[list].as_array().expect("a list").iter();
        all.map(|entry| entry["bytes"].as_u64().expect("bytes"))
            .sum()
    };
    assert_eq!(bytes("passes"), bytes("buffers"));
    assert_eq!(told["bytes"], bytes("passes"));

    let open = plan(&[&scene, "--shadows", "off"]);
    // What falls on bodies' surfaces is shaded all the same, since they light each other.
    let passes = open["passes"].as_array().expect("a list").iter();
    let mut shadows = passes.filter(|pass| pass["name"] == "shadow");
    assert!(shadows.all(|pass| pass["at"] == "points"));
    assert!(names(&open["left_out"]).contains(&"shadow"));

    let text = success(&[&["plan", &scene], &SMALL[..]].concat());
    for words in [
        "1 of 2 objects did not move",
        "Left out",
        "Memory",
        "tasks handed to the threads",
    ] {
        assert!(text.contains(words), "no `{words}` in: {text}");
    }
}

#[test]
fn effects_are_switched_on_one_by_one() {
    let folder = Folder::new("effects");
    // Nothing moves by itself.
    let scene = scene_with(&folder, "");
    let arguments = [&["plan", &scene, "--effects"], &SMALL[..]].concat();
    let rows: Vec<Value> =
        serde_json::from_str(&success(&[&arguments[..], &["--json"]].concat())).expect("JSON");
    assert_eq!(rows.len(), 8);
    let shaders: Vec<_> = rows.iter().map(|row| row["shaders"].as_u64()).collect();
    assert!(shaders.first() < shaders.last(), "{shaders:?}");
    for row in &rows {
        assert!(row["ms"].as_f64().is_some_and(|ms| ms > 0.0), "{row}");
        assert!(
            row["bytes"].as_u64().is_some_and(|bytes| bytes > 0),
            "{row}"
        );
        assert_eq!(
            row["idle"],
            Value::Array(Vec::new()),
            "all passes work: {row}"
        );
    }
    // Points of eight spheres gather once, and the spheres send on once more.
    let tasks = |row: usize| rows[row]["dispatches"].as_u64().expect("a count");
    assert_eq!(tasks(7) - tasks(6), 16);
    let text = success(&arguments);
    assert_eq!(text.trim_end().lines().count(), 2 + 8, "{text}");
}

#[test]
fn what_cannot_be_planned_is_told() {
    let output = run(&["plan", "nowhere.toml"], b"");
    assert!(!output.status.success() && output.stdout.is_empty());
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(complaint.contains("nowhere.toml"), "{complaint}");
}
