//! The path tracer as a person asks for it: pictures, comparisons, their figures.

use crate::{Folder, success};
use serde_json::Value;

/// Two cubes of 8 vertices on y = 0, a red one and a white one beside it, on a grey ground under the built-in sky.
fn scene(folder: &Folder, more: &str) -> String {
    let cube = "
v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 2 -1\nv 1 2 -1\nv 1 2 1\nv -1 2 1
f 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1
";
    folder.put("cube.obj", cube);
    let cube = |albedo: &str, x: &str| {
        format!(
            "[[objects]]\nmesh = \"cube.obj\"\nspheres = 16\nalbedo = {albedo}\ntranslate = [{x}, 0, 0]\n"
        )
    };
    let cubes = cube("[0.9, 0.1, 0.1]", "-1.2") + &cube("0.9", "1.2");
    folder.put("scene.toml", cubes + more)
}

const INDIRECT: &str = "[indirect]\nmethod = \"spherical-lights\"\n";

/// The pixels of an EXR file.
fn pixels(path: &str) -> Vec<[f64; 3]> {
    let picture = image::open(path).expect("an EXR").into_rgb32f();
    picture
        .pixels()
        .map(|pixel| pixel.0.map(f64::from))
        .collect()
}

/// Mean red, green and blue of an EXR file.
fn mean(path: &str) -> [f64; 3] {
    let picture = image::open(path).expect("an EXR").into_rgb32f();
    let count = f64::from(picture.width() * picture.height());
    let mut sum = [0.0; 3];
    for pixel in picture.pixels() {
        for (sum, c) in sum.iter_mut().zip(pixel.0) {
            *sum += f64::from(c) / count;
        }
    }
    sum
}

#[test]
fn the_truth_is_near_what_the_passes_render() {
    let folder = Folder::new("reference");
    // The file of the scene without indirect light is another one.
    let unlit = scene(&folder, "");
    let unlit_text = std::fs::read_to_string(&unlit).expect("it was written");
    let unlit = folder.put("unlit.toml", unlit_text);
    let scene = scene(&folder, INDIRECT);
    let render_scene = |scene: &str, name: &str, more: &[&str]| {
        let out = folder.file(name);
        let usual = ["render", scene, "-o", &out, "--size", "48x32"];
        let text = success(&[&usual[..], more].concat());
        (mean(&out), text, std::fs::read(&out).expect("a picture"))
    };
    let render = |name: &str, more: &[&str]| render_scene(&scene, name, more);
    let passes = ["--backend", "cpu", "--order", "6"];
    render("ours.exr", &passes);
    render_scene(&unlit, "unlit.exr", &passes);
    let reference = ["--reference", "64", "--reference-light", "projected"];
    let (truth, text, bytes) = render("truth.exr", &reference);
    assert!(
        text.contains("16 paths a sample") && text.contains("one bounce"),
        "{text}"
    );
    let without = [&reference[..], &["--reference-bounces", "0"]].concat();
    let (direct, text, _) = render("direct.exr", &without);
    assert!(!text.contains("bounce"), "{text}");
    let of = |name: &str| pixels(&folder.file(name));
    let [ours, unlit, all, unbounced] =
        ["ours", "unlit", "truth", "direct"].map(|name| of(&format!("{name}.exr")));
    let bounced = |i: usize| all[i][0] - unbounced[i][0];
    // In red, which the red cube sends on: where much of the light is the bounce.
    let much: Vec<usize> = (0..all.len())
        .filter(|&i| bounced(i) > 0.12 * all[i][0])
        .collect();
    let sum = |of: &dyn Fn(usize) -> f64| much.iter().map(|&i| of(i)).sum::<f64>();
    let light = sum(&|i| all[i][0]);
    let bounce = sum(&bounced) / light;
    let found = sum(&|i| ours[i][0] - unlit[i][0]) / light;
    let whole = sum(&|i| ours[i][0]) / light;
    println!(
        "{} of {} pixels: the bounce is {bounce:.3} of the light, {found:.3} are found, {whole:.3} of all",
        much.len(),
        all.len()
    );
    assert!(much.len() > 200 && bounce > 0.2, "{} {bounce}", much.len());
    // Without indirect light that would be 0 of it, and a fifth of all would be missing.
    assert!((found / bounce - 1.0).abs() < 0.25, "{found} of {bounce}");
    assert!((whole - 1.0).abs() < 0.12, "{whole}");
    // The same once more, and darker where bodies do not reflect.
    assert_eq!(render("again.exr", &reference).2, bytes);
    assert!(direct[0] < truth[0] && direct[1] < truth[1]);
    // A ground that is shadowed lights bodies less, and what bodies send there comes back.
    let (ground, _, _) = render("ground.exr", &["--reference", "64", "--reflecting-ground"]);
    assert!(
        ground
            .iter()
            .zip(truth)
            .all(|(a, b)| (a / b - 1.0).abs() < 0.2)
    );
}

#[test]
fn frames_are_traced_one_by_one() {
    let folder = Folder::new("reference-frames");
    let keys = "keys = [{ time = 0 }, { time = 1, translate = [0, 3, 0] }]\n";
    folder.put("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let scene = folder.put(
        "scene.toml",
        format!("[[objects]]\nmesh = \"triangle.obj\"\nspheres = 1\n{keys}[camera]\neye = [0, 2, 9]\ntarget = [0, 1, 0]\n"),
    );
    let out = folder.file("f%d.png");
    let frames = ["--frames", "0..2", "--fps", "1", "--size", "16x16"];
    success(
        &[
            &["render", &scene, "-o", &out, "--reference", "4"],
            &frames[..],
        ]
        .concat(),
    );
    let read = |name: &str| std::fs::read(folder.file(name)).expect("a picture");
    assert_ne!(read("f0.png"), read("f1.png"));
}

#[test]
fn a_comparison_tells_its_figures_and_draws_its_sheet() {
    let folder = Folder::new("compare");
    let scene = scene(&folder, INDIRECT);
    let out = folder.file("sheet.png");
    let usual = ["compare", &scene, "--size", "48x32", "--reference", "64"];
    let text = success(&[&usual[..], &["--json", "-o", &out]].concat());
    let found: Value = serde_json::from_str(&text).expect("JSON");
    // Interpolated light errs, but by little: without it there is nothing to tell.
    let half = |found: &Value| found["half_resolution"]["rms"].as_f64();
    let rms = half(&found).expect("scenes are lit at half resolution");
    assert!(rms > 1e-5 && rms < 0.02, "{rms}");
    let text_of = std::fs::read_to_string(&scene).expect("it was written");
    let whole = format!("{text_of}[settings]\nhalf_resolution = false\n");
    let whole = folder.put("whole.toml", whole);
    let few = ["--size", "16x12", "--reference", "2", "--json"];
    let whole = success(&[&["compare", &whole], &few[..]].concat());
    assert_eq!(half(&serde_json::from_str(&whole).expect("JSON")), None);
    let figure = |kind: &str, name: &str| {
        let value = found[kind][name].as_f64();
        value.unwrap_or_else(|| panic!("no {kind}.{name} in {text}"))
    };
    for kind in [
        "direct",
        "indirect",
        "total",
        "direct_ground",
        "indirect_ground",
    ] {
        for name in ["rms", "mean", "p99", "noise"] {
            let value = figure(kind, name);
            assert!((0.0..1.0).contains(&value), "{kind}.{name} is {value}");
        }
        assert!(figure(kind, "mean") <= figure(kind, "p99"));
    }
    // The cubes light each other and the ground, and ours finds most of it.
    let share = found["indirect_share"].as_f64().expect("a share");
    assert!((0.005..0.3).contains(&share), "{share}");
    assert!(figure("indirect", "bias").abs() < 0.5 * share, "{text}");
    let sheet = image::open(&out).expect("a PNG").into_rgb8();
    assert!(sheet.width() > 4 * 48 && sheet.height() > 3 * 32);

    // Nothing but the times depends on the run.
    let again: Value =
        serde_json::from_str(&success(&[&usual[..], &["--json"]].concat())).expect("JSON");
    for kind in ["direct", "indirect", "total_ground"] {
        assert_eq!(found[kind], again[kind]);
    }
    let table = success(&usual);
    assert!(
        table.contains("| indirect light, the ground reflecting |"),
        "{table}"
    );
}

#[test]
fn without_indirect_light_both_have_none() {
    let folder = Folder::new("compare-direct");
    let scene = scene(&folder, "[ground]\nenabled = false\n");
    let small = ["--size", "32x24", "--reference", "32", "--json"];
    let text = success(&[&["compare", &scene], &small[..]].concat());
    let found: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(found["indirect"]["p99"], 0.0);
    assert_eq!(
        (&found["bounces"], &found["indirect_ground"]),
        (&0.into(), &Value::Null)
    );
    // What the map has besides what order 4 can show is an error of the light.
    let map = [&small[..], &["--reference-light", "map"]].concat();
    let text = success(&[&["compare", &scene], &map[..]].concat());
    let map: Value = serde_json::from_str(&text).expect("JSON");
    let rms = |found: &Value| found["direct"]["rms"].as_f64().expect("a figure");
    assert!(rms(&map) > rms(&found), "{} {}", rms(&map), rms(&found));
}
