//! Bad input: a sentence on standard error, exit code 1, and no file that was not there before.

use crate::{Folder, run};

/// Runs what has to fail; the sentence.
#[track_caller]
fn failure(arguments: &[&str]) -> String {
    let output = run(arguments, b"");
    let sentence = String::from_utf8(output.stderr).expect("errors are UTF-8");
    assert_eq!(
        output.status.code(),
        Some(1),
        "gaunt {arguments:?}: {sentence}"
    );
    assert!(
        output.stdout.is_empty(),
        "gaunt {arguments:?} prints although it fails"
    );
    assert!(!sentence.contains("panicked"), "{sentence}");
    sentence
}

#[test]
fn a_scene_that_is_wrong_leaves_no_picture() {
    let folder = Folder::new("scenes");
    let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    folder.put("good.obj", format!("{triangle}f 1 2 3\n"));
    folder.put("index.obj", format!("{triangle}f 1 2 9\n"));
    folder.put("empty.obj", triangle);
    folder.put("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.put("cut.glb", b"glTF\x02\0\0\0\xff\0\0\0");
    folder.put(
        "cut.hdr",
        "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n",
    );
    let object = |mesh: &str| format!("[[objects]]\nmesh = \"{mesh}\"\n");
    let good = object("good.obj");
    // Scenes and what the sentence has to name.
    let scenes = [
        (object("missing.obj"), "missing.obj"),
        (object("index.obj"), "index.obj"),
        (object("empty.obj"), "empty.obj"),
        (object("nan.obj"), "nan.obj"),
        (object("cut.glb"), "cut.glb"),
        (format!("{good}spheres = 0\n"), "spheres"),
        (format!("{good}sphere = 64\n"), "sphere"),
        (format!("{good}[settings]\norder = 1\n"), "order"),
        (format!("{good}[settings]\norder = 7\n"), "order"),
        (
            format!("{good}[settings]\naccumulation_order = 3\n"),
            "accumulation_order",
        ),
        (
            format!("{good}[environment]\nmap = \"missing.hdr\"\n"),
            "missing.hdr",
        ),
        (
            format!("{good}[environment]\nmap = \"cut.hdr\"\n"),
            "cut.hdr",
        ),
        ("objects = 3".to_string(), "objects"),
        ("[[objects]".to_string(), "scene.toml"),
        (String::new(), "scene.toml"),
    ];
    let before = {
        folder.put("scene.toml", "");
        folder.names()
    };
    for (scene, named) in scenes {
        let path = folder.put("scene.toml", &scene);
        let (out, report) = (folder.file("out.png"), folder.file("report.json"));
        let sentence = failure(&[
            "render", &path, "-o", &out, "--json", &report, "--size", "16x16",
        ]);
        assert!(sentence.contains(named), "{scene}\n{sentence}");
        assert_eq!(folder.names(), before, "{scene}");
    }
}

/// The loaders' own collection of bad files, each rendered as a scene would be.
#[test]
fn every_bad_file_is_refused_with_its_name() {
    let corpus = concat!(env!("CARGO_MANIFEST_DIR"), "/../sh-bake/tests/corpus");
    let folder = Folder::new("corpus");
    let out = folder.file("out.png");
    let mut count = 0;
    for entry in std::fs::read_dir(corpus).expect("the collection is there") {
        let path = entry.expect("an entry").path();
        let name = path
            .file_name()
            .expect("a name")
            .to_string_lossy()
            .into_owned();
        let ending = path
            .extension()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        let path = path.to_str().expect("a path in UTF-8");
        let sentence = match ending.as_str() {
            "toml" | "obj" | "gltf" | "glb" => {
                failure(&["render", path, "-o", &out, "--size", "8x8"])
            }
            "hdr" | "exr" => failure(&["project", path, "--json"]),
            // Parts of other files.
            _ => continue,
        };
        assert!(
            sentence.starts_with("gaunt: ") && sentence.trim_end().ends_with(['.', '?']),
            "{name}: {sentence}"
        );
        // A scene may be wrong through the file it names.
        assert!(
            ending == "toml" || sentence.contains(&name),
            "{name}: {sentence}"
        );
        assert!(folder.names().is_empty(), "{name}");
        count += 1;
    }
    assert!(count > 20, "only {count} files");
}

#[test]
fn a_picture_that_was_there_survives_a_failure() {
    let folder = Folder::new("survives");
    let out = folder.put("out.png", "an old picture");
    failure(&["render", &folder.file("missing.toml"), "-o", &out]);
    assert_eq!(std::fs::read(&out).unwrap(), b"an old picture");
}

#[test]
fn options_that_make_no_sense_are_refused() {
    let folder = Folder::new("options");
    let out = folder.file("out.png");
    let refused: &[(&[&str], &str)] = &[
        (&["render", "-o", &out, "--order", "1"], "--order"),
        (&["render", "-o", &out, "--order", "7"], "--order"),
        (
            &["render", "-o", &out, "--accumulation", "7"],
            "--accumulation is 7",
        ),
        (
            &["render", "-o", &out, "--accumulation", "x"],
            "--accumulation",
        ),
        (
            &["render", "-o", &out, "--order", "5", "--accumulation", "4"],
            "must not be below the SH order, which is 5",
        ),
        (&["render", "-o", &out, "--quality", "best"], "--quality"),
        (&["render", "-o", &out, "--size", "0x10"], "--size"),
        (&["render", "-o", &out, "--size", "16"], "--size"),
        (&["render", "-o", &out, "--size", "99999x2"], "--size"),
        (&["render", "-o", &out, "--shadows", "maybe"], "--shadows"),
        (&["render", "-o", &out, "--backend", "quantum"], "--backend"),
        (&["render", "-o", &out, "--exposure", "NaN"], "--exposure"),
        (&["render", "-o", &folder.file("out.jpg")], ".png or .exr"),
        (
            &["render", "-o", &out, "--frames", "0..3"],
            "one number in it, %d or %04d",
        ),
        (
            &[
                "render",
                "-o",
                &folder.file("%d-%d.png"),
                "--frames",
                "0..3",
            ],
            "one number in it",
        ),
        (
            &["render", "-o", &folder.file("%d.jpg"), "--frames", "0..3"],
            ".png or .exr",
        ),
        (
            &["render", "-o", &folder.file("%d.png"), "--frames", "3..3"],
            "there is no frame in 3..3",
        ),
        (
            &["render", "-o", &folder.file("%d.png"), "--frames", "all"],
            "a range like 0..60",
        ),
        (
            &[
                "render",
                "-o",
                &folder.file("%d.png"),
                "--frames",
                "0..3",
                "--fps",
                "0",
            ],
            "above 0",
        ),
        (
            &["render", "-o", &out, "--clip", "Walk"],
            "the built-in scene has none",
        ),
        (
            &["render", "-o", &folder.file("no/such/folder/out.png")],
            "out.png",
        ),
        (
            &["project", &folder.file("missing.hdr"), "--order", "3"],
            "missing.hdr",
        ),
        (
            &["project", &folder.file("missing.txt"), "--order", "3"],
            "missing.txt",
        ),
        (&["render", "-o", &out, "--reference", "0"], "--reference"),
        (
            &["render", "-o", &out, "--reference", "8", "--backend", "gpu"],
            "--backend cpu or auto, not with gpu",
        ),
        (
            &["render", "-o", &out, "--reference", "8", "--shadows", "off"],
            "--shadows off",
        ),
        (
            &[
                "render",
                "-o",
                &out,
                "--reference",
                "8",
                "--half-resolution",
                "on",
            ],
            "--half-resolution on",
        ),
        (
            &["render", "-o", &out, "--reference-bounces", "2"],
            "--reference",
        ),
        (&["compare", "--reference", "1"], "--reference"),
        (&["compare", "--size", "9000x9"], "at most 8192 pixels"),
        (
            &["compare", "-o", &folder.file("sheet.exr")],
            "must end in .png",
        ),
        (
            &["compare", &folder.file("missing.toml"), "-o", &out],
            "missing.toml",
        ),
        (&["eval", "--backend", "f16"], "--backend"),
        (&["sing"], "sing"),
    ];
    for (arguments, named) in refused {
        let sentence = failure(arguments);
        assert!(sentence.contains(named), "{arguments:?}: {sentence}");
    }
    assert!(folder.names().is_empty());
}

#[test]
fn an_environment_with_impossible_light_is_refused() {
    let folder = Folder::new("light");
    for (name, bad) in [
        ("negative.exr", -1.0),
        ("infinite.exr", f32::INFINITY),
        ("nan.exr", f32::NAN),
    ] {
        let path = folder.file(name);
        let mut map = image::Rgb32FImage::from_pixel(8, 4, image::Rgb([1.0; 3]));
        map.put_pixel(3, 2, image::Rgb([1.0, bad, 1.0]));
        map.save(&path).expect("writing an EXR file");
        let sentence = failure(&["project", &path, "--order", "3", "--json"]);
        assert!(sentence.contains(name), "{sentence}");
    }
}

#[test]
fn help_is_no_failure() {
    for arguments in [
        &["--help"][..],
        &["render", "--help"],
        &["eval", "--help"],
        &["--version"],
    ] {
        let output = run(arguments, b"");
        assert_eq!(output.status.code(), Some(0), "{arguments:?}");
        assert!(
            !output.stdout.is_empty() && output.stderr.is_empty(),
            "{arguments:?}"
        );
    }
}
