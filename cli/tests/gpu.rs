//! What of the program needs a GPU adapter. Without one every test shows as ignored, never as passed; with
//! `GAUNT_REQUIRE_GPU=1` a missing adapter is a failure.

use gaunt::eval::{Backend, Evaluator, answer};
use libtest_mimic::{Arguments, Failed, Trial};
use serde_json::{Value, json};
use std::process::Command;

const TESTS: [(&str, fn()); 4] = [
    (
        "every_routine_is_that_of_double_precision",
        every_routine_is_that_of_double_precision,
    ),
    ("what_has_no_wgsl_says_so", what_has_no_wgsl_says_so),
    (
        "pictures_are_those_of_the_cpu",
        pictures_are_those_of_the_cpu,
    ),
    ("frames_are_those_of_the_cpu", frames_are_those_of_the_cpu),
];

fn main() {
    let arguments = Arguments::from_args();
    let required = std::env::var_os("GAUNT_REQUIRE_GPU").is_some_and(|value| value != "0");
    let missing = gaunt::gpu::Gpu::open().err().map(|error| error.to_string());
    let trial = |&(name, test): &(&str, fn())| match missing.clone() {
        None => Trial::test(name, move || {
            test();
            Ok(())
        }),
        Some(reason) => Trial::test(name, move || Err(Failed::from(reason)))
            .with_kind("no GPU")
            .with_ignored_flag(!required),
    };
    libtest_mimic::run(&arguments, TESTS.iter().map(trial).collect()).exit();
}

fn evaluator() -> Backend {
    Backend::Gpu(Box::new(Evaluator::new().expect("there is an adapter")))
}

fn ask(backend: &mut Backend, request: &Value) -> Value {
    serde_json::from_str(&answer(backend, request.to_string().as_bytes()))
        .expect("answers are JSON")
}

fn every_routine_is_that_of_double_precision() {
    let mut gpu = evaluator();
    // Both forms of the product. All orders are compared where the routines are tested by themselves; a
    // software driver takes a minute to compile them.
    for order in [2_usize, 3, 5] {
        let vector = |seed: usize| -> Vec<f64> {
            (0..order * order)
                .map(|i| ((i * 37 + seed * 101) % 64) as f64 / 64.0 - 0.5)
                .collect()
        };
        let (f, g, h) = (vector(1), vector(2), vector(3));
        let (dir, quat) = ([0.48, -0.6, 0.64], [0.1, 0.7, -0.1, 0.7]);
        let z = &f[..order];
        for mut request in [
            json!({"op": "basis", "dir": dir}),
            json!({"op": "cosine", "dir": dir}),
            json!({"op": "zonal", "z": z, "dir": dir}),
            json!({"op": "product", "f": f, "g": g}),
            json!({"op": "square", "f": f}),
            json!({"op": "triple", "f": f, "g": g, "h": h}),
            json!({"op": "rotate", "f": f, "quat": quat}),
            json!({"op": "window", "f": f, "h": 5.5}),
            json!({"op": "cap", "angle": 0.8}),
            json!({"op": "cap", "angle": 3.0}),
            json!({"op": "cap_log", "angle": 0.8}),
            json!({"op": "exp", "f": f}),
            json!({"op": "exp", "f": f, "method": "hyb"}),
            json!({"op": "exp", "f": f, "method": "ol"}),
            json!({"op": "exp", "f": f, "method": "ps*:1"}),
            json!({"op": "exp", "f": f, "method": "ps*:5"}),
            json!({"op": "exp", "f": f, "method": "ps:7"}),
            json!({"op": "exp", "f": f, "method": "sampled"}),
            json!({"op": "exp", "f": f, "method": "saturating"}),
            json!({"op": "cap_log", "angle": 0.8, "method": "fitted:saturating"}),
        ] {
            request["order"] = json!(order);
            let numbers = |answer: Value| -> Vec<f64> {
                let list = answer["ok"]
                    .as_array()
                    .unwrap_or_else(|| panic!("{request}: {answer}"));
                list.iter().map(|x| x.as_f64().expect("a number")).collect()
            };
            let found = numbers(ask(&mut gpu, &request));
            let expected = numbers(ask(&mut Backend::F64, &request));
            assert_eq!(found.len(), expected.len(), "{request}");
            let scale = expected.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
            for (a, b) in found.iter().zip(&expected) {
                assert!((a - b).abs() <= 2e-5 * scale, "{request}: {a} for {b}");
            }
        }
    }
}

fn what_has_no_wgsl_says_so() {
    let mut gpu = evaluator();
    for request in [
        json!({"op": "log", "order": 2, "f": [3.0, 0.1, 0.1, 0.1]}),
        json!({"op": "cap_log", "order": 2, "angle": 0.5, "method": "eigen"}),
        json!({"op": "cap_log", "order": 2, "angle": 2.0}),
        json!({"op": "exp", "order": 2, "f": [0.1, 0.1, 0.1, 0.1], "method": "eigen"}),
    ] {
        let answer = ask(&mut gpu, &request);
        assert!(
            answer["error"].as_str().is_some_and(|e| e.contains("f64")),
            "{request}: {answer}"
        );
    }
    let large = json!({"op": "square", "order": 2, "f": [1e39, 0, 0, 0]});
    assert!(
        ask(&mut gpu, &large)["error"]
            .as_str()
            .is_some_and(|e| e.contains("single precision"))
    );
}

/// The built-in scene on both backends, as 8-bit pictures: 99.9 % of the pixels differ by 1 at most. Once more
/// smaller, where the blockers are accumulated above the light's order.
fn pictures_are_those_of_the_cpu() {
    compare("own", [320, 180], &[]);
    compare("above", [96, 54], &["--order", "4", "--accumulation", "6"]);
}

/// A mesh that bends, moves and stands under a sky that turns; the last of its frames, which the renderer of the
/// first has to show.
fn frames_are_those_of_the_cpu() {
    let folder = std::env::temp_dir().join(format!("gaunt-gpu-scene-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for temporary files");
    let scene = folder.join("scene.toml");
    let mesh = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../sh-bake/tests/good/animated.gltf"
    );
    let text = format!(
        "[[objects]]\nmesh = {mesh:?}\nspheres = 4\nclip = \"Wave\"\n\
         keys = [{{ time = 0 }}, {{ time = 1, translate = [0, 0, 2], rotate = [0, 40, 0] }}]\n\
         [environment]\nturn = 90\n"
    );
    std::fs::write(&scene, text).expect("a scene file");
    let scene = scene.to_str().expect("a path in UTF-8");
    let arguments = [scene, "--frames", "0..3", "--fps", "2"];
    compare("frames", [96, 54], &arguments);
    let _ = std::fs::remove_dir_all(&folder);
}

fn compare(name: &str, [width, height]: [u32; 2], arguments: &[&str]) {
    let folder = std::env::temp_dir().join(format!("gaunt-gpu-{name}-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for temporary files");
    let size = format!("{width}x{height}");
    let [cpu, gpu] = ["cpu", "gpu"].map(|backend| {
        let frames = arguments.contains(&"--frames");
        let [pattern, number] = match frames {
            true => ["%d", "2"],
            false => [""; 2],
        };
        let [out, last] = [pattern, number].map(|n| folder.join(format!("{backend}{n}.png")));
        let output = Command::new(env!("CARGO_BIN_EXE_gaunt"))
            .args(["render", "--size", &size, "--backend", backend, "-o"])
            .arg(&out)
            .args(arguments)
            .env(
                "GAUNT_CACHE",
                concat!(env!("CARGO_TARGET_TMPDIR"), "/gpu-cache"),
            )
            .output()
            .expect("the program starts");
        assert!(
            output.status.success(),
            "{}",
            String::from_utf8_lossy(&output.stderr)
        );
        image::open(&last).expect("a PNG").into_rgb8()
    });
    let _ = std::fs::remove_dir_all(&folder);
    let far = |(a, b): &(&image::Rgb<u8>, &image::Rgb<u8>)| {
        a.0.iter().zip(b.0).any(|(a, b)| a.abs_diff(b) > 1)
    };
    let count = cpu.pixels().zip(gpu.pixels()).filter(far).count();
    assert!(
        count <= (width * height / 1000) as usize,
        "{name}: {count} pixels differ by more than 1"
    );
}
