//! Every file of `tests/corpus` is wrong in one way, and says so in a sentence that names the file and what
//! in it is wrong.

use sh_bake::{Model, load_environment, load_mesh, load_scene};
use sh_scene::motion::{Anchors, Pose, Rig};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Files that are wrong themselves, with what their message has to say.
const WRONG: &[(&str, &[&str])] = &[
    (
        "accessor_huge.gltf",
        &["mesh 0 (flag), primitive 0", "POSITION", "accessor 0"],
    ),
    (
        "accessor_missing.gltf",
        &["meshes[0].primitives[0]: POSITION names accessor 9, but there are 2"],
    ),
    (
        "accessor_past_end.gltf",
        &["mesh 0 (flag), primitive 0: POSITION: accessor 0 reads past the end"],
    ),
    ("animation_accessor.gltf", &["the glTF is damaged"]),
    (
        "animation_count.gltf",
        &["animations[0].channels[1]: there are 6 values for 2 times, but 2 are needed"],
    ),
    (
        "animation_far.gltf",
        &["animations[0].channels[1]", "within ±1e9"],
    ),
    (
        "animation_infinite.gltf",
        &["animations[1].channels[0]", "inf"],
    ),
    ("animation_interpolation.gltf", &["the glTF is damaged"]),
    (
        "animation_node.gltf",
        &["animations[1].channels[0] names node 9, but there are 4"],
    ),
    (
        "animation_past_end.gltf",
        &[
            "animations[0].channels[1]",
            "the sampler's input: accessor 5 reads past the end",
        ],
    ),
    (
        "animation_path.gltf",
        &["animations[1].channels[1].target.path has to be translation, rotation"],
    ),
    (
        "animation_rotation_zero.gltf",
        &["animations[0].channels[0]: key 1 has", "other than zero"],
    ),
    (
        "animation_sampler.gltf",
        &["animations[1].channels[1] names sampler 7, but there are 2"],
    ),
    (
        "animation_time_nan.gltf",
        &["animations[0].channels[0]: key 1 is at NaN seconds"],
    ),
    (
        "animation_times.gltf",
        &[
            "animations[0].channels[0]: key 2 is at 1 seconds",
            "above the one before",
        ],
    ),
    (
        "animation_type.gltf",
        &["animations[0].channels[0]: the sampler's output: accessor 0 holds Vec3"],
    ),
    ("b44_overflow.exr", &["the image cannot be decoded"]),
    (
        "bad_corner.obj",
        &["line 4", "`two` is no corner of a face"],
    ),
    ("bad_number.obj", &["line 1", "a position needs 3 numbers"]),
    (
        "block_huge.exr",
        &["524542 × 256 pixels, which 370 bytes cannot hold"],
    ),
    ("buffer_missing.gltf", &["buffers[]", "cannot be read"]),
    (
        "buffer_short.gltf",
        &["buffers[0].byteLength says 400 bytes, but there are 44"],
    ),
    (
        "color_nan.gltf",
        &[
            "mesh 0 (flag), primitive 0",
            "COLOR_0: a vertex has the colour [0.5, NaN, 0.0], and colours have to be finite",
        ],
    ),
    (
        "color_type.gltf",
        &["COLOR_0: accessor 1 holds Vec2 of F32, but Vec3 of"],
    ),
    ("control_character.hdr", &["`32-bit\\u{1b}[31m\\u{0}`"]),
    (
        "control_character.obj",
        &["line 4", "`3\\u{0}\\u{7}` is no corner"],
    ),
    (
        "data_window_huge.exr",
        &["20000000 × 2 pixels, which 441 bytes cannot hold"],
    ),
    (
        "display_window_huge.exr",
        &["60000 × 60000 pixels, which 441 bytes cannot hold"],
    ),
    (
        "draco.glb",
        &["extensionsRequired", "KHR_draco_mesh_compression"],
    ),
    ("empty.glb", &["the glTF is damaged"]),
    ("empty.obj", &["no triangles"]),
    (
        "image_cut_off.gltf",
        &["mesh 0, primitive 0", "images[0]", "cannot be decoded"],
    ),
    (
        "image_past_end.gltf",
        &[
            "mesh 0, primitive 0",
            "images[0]",
            "reads past the end of buffer 0",
        ],
    ),
    ("header_length.glb", &["says that the file has 0 bytes"]),
    (
        "index_huge.obj",
        &["line 4", "texture coordinate index -9 is out of range"],
    ),
    (
        "index_out_of_range.gltf",
        &[
            "mesh 0 (flag), primitive 0",
            "vertex index 7 is out of range 0..3",
        ],
    ),
    (
        "index_out_of_range.obj",
        &["line 4", "position index 4 is out of range: the file has 3"],
    ),
    (
        "index_type.gltf",
        &["mesh 0 (flag), primitive 0: indices: accessor 1 holds"],
    ),
    (
        "index_zero.obj",
        &["line 4", "position index 0 is out of range"],
    ),
    (
        "infinite_pixel.exr",
        &["pixel (column 2, row 1) has green inf"],
    ),
    (
        "infinite_position.obj",
        &["the position of vertex 1 has a coordinate inf"],
    ),
    (
        "joint_out_of_range.gltf",
        &["JOINTS_0: joint 3 is out of range 0..1"],
    ),
    (
        "light_missing.gltf",
        &["nodes[2].extensions.khrLightsPunctual.light: Index out of bounds"],
    ),
    (
        "light_of_no_kind.gltf",
        &["khrLightsPunctual.lights[0].type: Invalid value"],
    ),
    (
        "light_spot_without_cone.gltf",
        &["khrLightsPunctual.lights[0].spot: Missing data"],
    ),
    (
        "light_without_lights.gltf",
        &["nodes[2].extensions.khrLightsPunctual.light: Index out of bounds"],
    ),
    ("nan_pixel.exr", &["pixel (column 2, row 1) has green NaN"]),
    (
        "nan_position.gltf",
        &[
            "mesh 0 (flag), primitive 0",
            "the position of vertex 1 has a coordinate NaN",
        ],
    ),
    (
        "nan_position.obj",
        &["the position of vertex 1 has a coordinate NaN"],
    ),
    (
        "negative_pixel.exr",
        &["pixel (column 2, row 1) has green -0.5"],
    ),
    ("no_faces.obj", &["no triangles"]),
    ("no_scene.gltf", &["no scene"]),
    ("node_cycle.gltf", &["nodes[0] is met twice"]),
    ("not_an_image.hdr", &["cannot be decoded"]),
    ("not_json.gltf", &["the glTF is damaged"]),
    ("not_text.obj", &["not text after byte 8"]),
    ("percent.gltf", &["buffers[0].uri", "not UTF-8"]),
    ("points_only.gltf", &["no triangles"]),
    ("position_type.gltf", &["POSITION"]),
    (
        "size_huge.hdr",
        &["65535 × 65535 pixels, which 81 bytes cannot hold"],
    ),
    ("truncated.exr", &["cannot be decoded"]),
    ("truncated.glb", &["the glTF is damaged"]),
    ("truncated.hdr", &["cannot be decoded"]),
    ("truncated_header.glb", &["the glTF is damaged"]),
    (
        "view_past_end.gltf",
        &["POSITION", "reads past the end of buffer 0"],
    ),
    ("zero_area.gltf", &["no triangle", "area"]),
    ("zero_area.obj", &["no triangle", "area"]),
];

/// Scenes that are wrong: the file that the message has to name, if not the scene, and what it has to say.
const WRONG_SCENES: &[(&str, &str, &[&str])] = &[
    (
        "accumulation_below_order.toml",
        "",
        &[
            "line 6",
            "settings.accumulation_order is 4",
            "from the order, 5, to 6",
        ],
    ),
    (
        "accumulation_not_whole.toml",
        "",
        &[
            "line 5",
            "settings.accumulation_order is 4.5",
            "whole number",
        ],
    ),
    (
        "albedo_above_one.toml",
        "",
        &["line 3", "objects.albedo has 1.5 in it", "from 0 to 1"],
    ),
    (
        "roughness_above_one.toml",
        "",
        &["line 3", "objects.roughness is 1.5", "from 0 to 1"],
    ),
    (
        "gloss_no_boolean.toml",
        "",
        &["line 5", "settings.gloss", "true or false"],
    ),
    (
        "bad_map.toml",
        "negative_pixel.exr",
        &["pixel (column 2, row 1) has green -0.5"],
    ),
    ("bad_mesh.toml", "no_faces.obj", &["no triangles"]),
    (
        "clip_of_none.toml",
        "",
        &[
            "line 4",
            "triangle.glb: there is no clip `0`",
            "the file has none",
        ],
    ),
    (
        "blockers_and_spheres.toml",
        "",
        &["line 4", "objects.spheres", "objects.blockers is \"none\""],
    ),
    (
        "blockers_unknown.toml",
        "",
        &[
            "line 3",
            "objects.blockers is \"boxes\"",
            "\"spheres\" or \"none\"",
        ],
    ),
    (
        "clip_too_far.toml",
        "bursting.gltf",
        &["the clip takes a vertex to the coordinate", "within ±1e9"],
    ),
    (
        "clip_unknown.toml",
        "",
        &[
            "line 3",
            "animated.gltf: there is no clip `Walk`",
            "`Wave`, `Roll`",
        ],
    ),
    (
        "clip_wrong_kind.toml",
        "",
        &[
            "line 3",
            "objects.clip has to be a string or a whole number, not a list",
        ],
    ),
    (
        "keys_empty.toml",
        "",
        &["line 3", "objects.keys", "at least one is needed"],
    ),
    (
        "keys_negative_time.toml",
        "",
        &["line 3", "objects.keys.time is -1"],
    ),
    (
        "keys_no_list.toml",
        "",
        &[
            "line 3",
            "objects.keys has to be a list of tables, not a number",
        ],
    ),
    (
        "keys_no_tables.toml",
        "",
        &["line 3", "objects.keys has a number in it"],
    ),
    (
        "keys_no_time.toml",
        "",
        &["line 3", "objects.keys.time is missing"],
    ),
    (
        "keys_order.toml",
        "",
        &["line 5", "objects.keys.time is 0.5", "one before is at 1"],
    ),
    (
        "keys_typo.toml",
        "",
        &[
            "line 3",
            "`tranlate`",
            "in [objects.keys]",
            "did you mean `translate`?",
        ],
    ),
    (
        "repeat_of_nothing.toml",
        "",
        &["line 3", "objects.repeat", "there are no keys"],
    ),
    (
        "turn_wrong_kind.toml",
        "",
        &[
            "line 4",
            "environment.turn has to be a number",
            "not a string",
        ],
    ),
    (
        "control_character.toml",
        "",
        &["line 3", "the key `sca\\u{1b}le` is not known"],
    ),
    (
        "fov_too_wide.toml",
        "",
        &["line 5", "camera.fov is 180", "from 1 to 170"],
    ),
    (
        "indirect_blocking.toml",
        "",
        &[
            "line 6: indirect.blocking is \"spheres\", but it has to be one of \"discs\", \"runs\", \"sphere\", \"object\".",
        ],
    ),
    (
        "indirect_bounces.toml",
        "",
        &["line 6: indirect.bounces is 0", "from 1 to 16"],
    ),
    (
        "indirect_many_bounces.toml",
        "",
        &["line 6: indirect.bounces is 17", "from 1 to 16"],
    ),
    (
        "indirect_method.toml",
        "",
        &[
            "line 5: indirect.method is \"radiosity\"",
            "\"spherical-lights\"",
        ],
    ),
    (
        "indirect_method_kind.toml",
        "",
        &["line 5: indirect.method has to be a string, not a number"],
    ),
    (
        "indirect_no_method.toml",
        "",
        &["line 4: indirect.method is missing", "\"spherical-lights\""],
    ),
    (
        "indirect_typo.toml",
        "",
        &["line 6: the key `bounce` is not known in [indirect]; did you mean `bounces`?"],
    ),
    (
        "key_typo.toml",
        "",
        &["line 3", "`shperes`", "did you mean `spheres`?"],
    ),
    ("missing_map.toml", "nowhere.hdr", &["cannot be read"]),
    ("missing_mesh.toml", "nowhere.obj", &["cannot be read"]),
    (
        "nan_translate.toml",
        "",
        &["line 3", "objects.translate has NaN in it"],
    ),
    (
        "negative_intensity.toml",
        "",
        &["line 5", "environment.intensity is -1"],
    ),
    (
        "negative_scale.toml",
        "",
        &["line 3", "objects.scale is -1", "above 0"],
    ),
    (
        "no_mesh_key.toml",
        "",
        &["line 1", "objects.mesh is missing"],
    ),
    ("no_objects.toml", "", &["objects is missing"]),
    (
        "not_toml.toml",
        "",
        &["line 1", "the TOML cannot be understood"],
    ),
    ("not_utf8.toml", "", &["not UTF-8"]),
    (
        "nowhere_to_look.toml",
        "",
        &["line 6", "camera.target is the same point as camera.eye"],
    ),
    (
        "order_1.toml",
        "",
        &["line 5", "settings.order is 1", "from 2 to 6"],
    ),
    (
        "order_7.toml",
        "",
        &["line 5", "settings.order is 7", "from 2 to 6"],
    ),
    (
        "section_typo.toml",
        "",
        &["line 4", "`enviroment`", "did you mean `environment`?"],
    ),
    (
        "too_many_spheres.toml",
        "",
        &["line 3", "objects.spheres is 5000", "from 1 to 4096"],
    ),
    (
        "two_numbers.toml",
        "",
        &["line 3", "objects.rotate has to be three numbers"],
    ),
    ("unknown_map_format.toml", "empty.obj", &[".hdr", ".exr"]),
    (
        "unknown_mesh_format.toml",
        "key_typo.toml",
        &[".gltf", ".obj"],
    ),
    (
        "wrong_kind.toml",
        "",
        &[
            "line 3",
            "objects.spheres has to be a whole number",
            "not a string",
        ],
    ),
    (
        "zero_spheres.toml",
        "",
        &["line 3", "objects.spheres is 0", "from 1 to 4096"],
    ),
];

fn corpus() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus")
}

fn check(file: &str, named: &str, message: &str, expected: &[&str]) {
    let first = message
        .split(", line")
        .next()
        .unwrap_or_default()
        .split(": ")
        .next()
        .unwrap_or_default();
    assert!(
        first.ends_with(named),
        "{file}: the message does not begin with {named}: {message}"
    );
    for part in expected {
        assert!(
            message.contains(part),
            "{file}: `{part}` is not in: {message}"
        );
    }
    assert!(
        message.ends_with(['.', '?']),
        "{file}: no sentence: {message}"
    );
    assert!(
        !message.contains(char::is_control),
        "{file}: more than a line: {message:?}"
    );
}

#[test]
fn wrong_files_are_refused_in_a_sentence() {
    for (file, expected) in WRONG {
        let path = corpus().join(file);
        let error = match path.extension().and_then(|e| e.to_str()) {
            Some("hdr" | "exr") => load_environment(&path).err(),
            _ => load_mesh(&path).err(),
        };
        let message = error
            .unwrap_or_else(|| panic!("{file} was taken"))
            .to_string();
        check(file, file, &message, expected);
    }
}

#[test]
fn wrong_scenes_are_refused_in_a_sentence() {
    for (file, named, expected) in WRONG_SCENES {
        let error = load_scene(&corpus().join(file)).err();
        let message = error
            .unwrap_or_else(|| panic!("{file} was taken"))
            .to_string();
        check(
            file,
            if named.is_empty() { file } else { named },
            &message,
            expected,
        );
    }
}

#[test]
fn every_file_of_the_corpus_is_tried() {
    let tried: BTreeSet<String> = WRONG
        .iter()
        .map(|w| w.0)
        .chain(WRONG_SCENES.iter().map(|w| w.0))
        .map(str::to_string)
        .collect();
    let there: BTreeSet<String> = std::fs::read_dir(corpus())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    assert_eq!(tried, there);
}

#[test]
fn a_file_cut_off_anywhere_never_panics() {
    let good = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/good");
    let folder = std::env::temp_dir().join(format!("sh-bake-cut-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    for name in [
        "triangle.glb",
        "polygon.obj",
        "mirrored.gltf",
        "skinned.gltf",
        "animated.gltf",
        "ramp.exr",
        "grey.hdr",
    ] {
        let bytes = std::fs::read(good.join(name)).unwrap();
        let path = folder.join(name);
        for length in (0..bytes.len()).step_by(1 + bytes.len() / 200) {
            std::fs::write(&path, &bytes[..length]).unwrap();
            // Either outcome is right (a text cut between two faces is a text): not to panic is the point.
            let message = match name.ends_with("exr") || name.ends_with("hdr") {
                true => load_environment(&path).err(),
                false => load_mesh(&path).err(),
            };
            if let Some(error) = message {
                assert!(error.to_string().contains(name), "{error}");
            }
        }
    }
    std::fs::remove_dir_all(&folder).unwrap();
}

/// Poses a model by all its clips, at all kinds of times.
fn play(model: &Model) {
    let Some(figure) = &model.figure else {
        return;
    };
    for clip in &figure.clips {
        let rig = Rig::new(
            figure.skeleton.clone(),
            figure.bones.clone(),
            clip.clone(),
            figure.skins.clone(),
            Anchors::default(),
        );
        let rig = rig.expect("a rig that was read is one");
        let mut pose = Pose::default();
        for seconds in [-1.0, 0.0, 0.7, 1e9] {
            rig.set(seconds, &mut pose);
            for (skin, part) in rig.skins().iter().zip(&model.parts) {
                skin.pose(pose.bones(), &mut part.mesh.clone());
            }
        }
    }
}

#[test]
fn a_gltf_with_any_number_or_key_changed_never_panics() {
    let good = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/good");
    let folder = std::env::temp_dir().join(format!("sh-bake-changed-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let mut tried = 0;
    for name in ["mirrored.gltf", "skinned.gltf", "animated.gltf"] {
        let text = std::fs::read_to_string(good.join(name)).unwrap();
        let path = folder.join(name);
        let mut attempt = |changed: String| {
            tried += 1;
            std::fs::write(&path, changed).unwrap();
            match load_mesh(&path) {
                Ok(model) => play(&model),
                Err(error) => assert!(error.to_string().contains(name), "{error}"),
            }
        };
        // Numbers and keys stand on lines of their own.
        let lines: Vec<&str> = text.lines().collect();
        for (n, line) in lines.iter().enumerate() {
            let with = |new: &str| {
                let mut lines = lines.clone();
                lines[n] = new;
                lines.join("\n")
            };
            let (head, value) = line
                .rsplit_once(": ")
                .unwrap_or((line.trim_end_matches(char::is_alphanumeric), line));
            let number = value.trim().trim_end_matches(',').parse::<f64>().is_ok();
            let comma = if line.ends_with(',') { "," } else { "" };
            if number {
                let head = if line.contains(": ") {
                    format!("{head}: ")
                } else {
                    String::new()
                };
                for other in [
                    "0",
                    "1",
                    "2",
                    "9",
                    "-1",
                    "1e39",
                    "4294967295",
                    "18446744073709551615",
                ] {
                    attempt(with(&format!("{head}{other}{comma}")));
                }
            }
            if let Some((key, rest)) = line.split_once("\":") {
                attempt(with(&format!("{key}X\":{rest}")));
            }
        }
    }
    std::fs::remove_dir_all(&folder).unwrap();
    assert!(tried > 500, "{tried}");
}
