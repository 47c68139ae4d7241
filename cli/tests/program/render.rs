//! Pictures: right size, right light, whole files.

use crate::{Folder, success};
use serde_json::Value;

/// A cube of 8 vertices on y = 0.
const CUBE: &str = "
v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 2 -1\nv 1 2 -1\nv 1 2 1\nv -1 2 1
f 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1
";

fn scene(folder: &Folder) -> String {
    folder.put("cube.obj", CUBE);
    folder.put(
        "scene.toml",
        "[[objects]]\nmesh = \"cube.obj\"\nspheres = 16\n",
    )
}

#[test]
fn the_built_in_scene_becomes_a_picture() {
    let folder = Folder::new("built-in");
    let (out, report) = (folder.file("picture.png"), folder.file("report.json"));
    let text = success(&[
        "render",
        "-o",
        &out,
        "--size",
        "64x36",
        "--backend",
        "cpu",
        "--json",
        &report,
    ]);
    for word in ["picture.png", "gbuffer", "shadow", "resolve", "total"] {
        assert!(text.contains(word), "no `{word}` in: {text}");
    }
    let picture = image::open(&out).expect("a PNG").into_rgb8();
    assert_eq!(picture.dimensions(), (64, 36));
    // Neither one colour nor all black or white: there is something to see.
    let mean = picture.iter().map(|c| f64::from(*c)).sum::<f64>() / (64.0 * 36.0 * 3.0);
    assert!((50.0..220.0).contains(&mean), "{mean}");
    assert!(picture.iter().max().unwrap() - picture.iter().min().unwrap() > 100);

    let report: Value = serde_json::from_slice(&std::fs::read(report).unwrap()).expect("JSON");
    assert_eq!(
        (&report["width"], &report["height"], &report["backend"]),
        (&64.into(), &36.into(), &"cpu".into())
    );
    let passes: Vec<_> = report["plan"]
        .as_array()
        .unwrap()
        .iter()
        .map(|p| p["pass"].clone())
        .collect();
    // Those that make the picture, in order; others may only look at it.
    let mut rest = passes.iter();
    for pass in [
        "gbuffer", "shadow", "shares", "gbuffer", "upsample", "shadow", "scatter", "resolve",
    ] {
        assert!(rest.any(|p| p == pass), "no {pass} in {passes:?}");
    }
    let stages = report["stages"].as_array().unwrap();
    assert!(
        passes
            .iter()
            .all(|pass| stages.iter().any(|stage| stage["stage"] == *pass))
    );
    assert_eq!(
        folder.names(),
        ["picture.png", "report.json"],
        "nothing half written stays"
    );
}

/// Luminance of an EXR file, pixel by pixel.
fn radiance(path: &str) -> Vec<f32> {
    let picture = image::open(path).expect("an EXR").into_rgb32f();
    picture
        .pixels()
        .map(|p| 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2])
        .collect()
}

#[test]
fn shadows_only_take_light_away() {
    let folder = Folder::new("shadows");
    let scene = scene(&folder);
    let render = |name: &str, shadows: &str, order: &str| {
        let out = folder.file(name);
        let size = ["--size", "48x32", "--backend", "cpu"];
        let text = success(
            &[
                &[
                    "render",
                    &scene,
                    "-o",
                    &out,
                    "--shadows",
                    shadows,
                    "--order",
                    order,
                ],
                &size[..],
            ]
            .concat(),
        );
        assert_eq!(text.contains("irradiance"), shadows == "off", "{text}");
        radiance(&out)
    };
    for order in ["2", "4", "6"] {
        let (with, without) = (
            render("on.exr", "on", order),
            render("off.exr", "off", order),
        );
        assert_eq!((with.len(), without.len()), (48 * 32, 48 * 32));
        assert!(
            with.iter()
                .zip(&without)
                .all(|(a, b)| *a <= b * 1.0001 + 1e-6)
        );
        let darker = with
            .iter()
            .zip(&without)
            .filter(|(a, b)| **a < 0.9 * **b)
            .count();
        assert!(
            darker > 20,
            "order {order}: only {darker} pixels are darker with shadows"
        );
    }
}

#[test]
fn the_same_picture_has_the_same_bytes() {
    let folder = Folder::new("same");
    let scene = scene(&folder);
    let render = |name: &str| {
        let out = folder.file(name);
        success(&[
            "render",
            &scene,
            "-o",
            &out,
            "--size",
            "40x30",
            "--backend",
            "cpu",
        ]);
        std::fs::read(out).unwrap()
    };
    assert_eq!(render("a.png"), render("b.png"));
}

#[test]
fn quality_and_orders_win_over_the_scene() {
    let folder = Folder::new("quality");
    folder.put("cube.obj", CUBE);
    let scene = folder.put(
        "scene.toml",
        "[[objects]]\nmesh = \"cube.obj\"\nspheres = 16\n[settings]\norder = 2\naccumulation_order = 3\n",
    );
    let (out, report) = (folder.file("picture.exr"), folder.file("report.json"));
    // Arguments, and the orders of light and accumulation that have to come of them.
    let cases: [(&[&str], [usize; 2]); 5] = [
        (&[], [2, 3]),
        (&["--order", "3"], [3, 3]),
        (&["--accumulation", "5"], [2, 5]),
        (&["--quality", "accurate", "--order", "5"], [5, 5]),
        (&["--quality", "fast", "--accumulation", "4"], [3, 4]),
    ];
    let mut pictures = Vec::new();
    for (arguments, [order, accumulation]) in cases {
        let rest = [
            "render",
            &scene,
            "-o",
            &out,
            "--size",
            "24x16",
            "--backend",
            "cpu",
            "--json",
            &report,
        ];
        let text = success(&[&rest[..], arguments].concat());
        let sentence =
            format!("Light of SH order {order}, shadows accumulated in order {accumulation}.");
        assert!(text.contains(&sentence), "{arguments:?}: {text}");
        assert_eq!(
            text.contains(&format!("are accumulated in order {accumulation}.")),
            order != accumulation,
            "{arguments:?}: {text}"
        );
        let report: Value = serde_json::from_slice(&std::fs::read(&report).unwrap()).expect("JSON");
        assert_eq!(
            (&report["order"], &report["accumulation"]),
            (&order.into(), &accumulation.into())
        );
        pictures.push(radiance(&out));
    }
    assert_ne!(pictures[0], pictures[2], "accumulation changes the shadow");
}
