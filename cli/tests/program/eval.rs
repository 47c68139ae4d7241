//! `gaunt eval`: every operation against the reference, and every way to ask wrongly.

use serde_json::{Value, json};
use sh_reference as truth;
use std::f64::consts::PI;

/// The answers to requests, one each.
fn answers(backend: &str, requests: &[Value]) -> Vec<Value> {
    let lines: Vec<_> = requests.iter().map(Value::to_string).collect();
    answers_to(backend, (lines.join("\n") + "\n").as_bytes())
}

fn answers_to(backend: &str, input: &[u8]) -> Vec<Value> {
    let output = crate::run(&["eval", "--backend", backend], input);
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let text = String::from_utf8(output.stdout).expect("answers are UTF-8");
    text.lines()
        .map(|line| serde_json::from_str(line).expect("answers are JSON"))
        .collect()
}

/// `count` numbers in -1..1, other ones for each seed.
fn numbers(seed: usize, count: usize) -> Vec<f64> {
    let mut state = (seed as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let mut next = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    (0..count).map(|_| next()).collect()
}

fn unit<const N: usize>(seed: usize) -> [f64; N] {
    let v = numbers(seed, N);
    let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    std::array::from_fn(|i| v[i] / length)
}

/// Requests of all kinds at an order, each with its true answer and the error that is permitted in double
/// precision, and in single precision.
fn cases(order: usize) -> Vec<(Value, Vec<f64>, [f64; 2])> {
    let c = order * order;
    let (f, g, h) = (
        numbers(order, c),
        numbers(order + 10, c),
        numbers(order + 20, c),
    );
    let z = numbers(order + 30, order);
    let (dir, quat) = (unit::<3>(order), unit::<4>(order + 5));
    let plain = [2e-14, 2e-5];
    let mut cases = vec![
        (
            json!({"op": "basis", "dir": dir}),
            truth::basis::basis(order, dir),
            plain,
        ),
        (
            json!({"op": "cosine", "dir": dir}),
            truth::zonal::cosine(order, dir),
            plain,
        ),
        (
            json!({"op": "zonal", "z": z, "dir": dir}),
            truth::zonal::rotated(&z, dir),
            plain,
        ),
        (
            json!({"op": "product", "f": f, "g": g}),
            truth::product::product(&f, &g),
            plain,
        ),
        (
            json!({"op": "square", "f": f}),
            truth::product::square(&f),
            plain,
        ),
        (
            json!({"op": "triple", "f": f, "g": g, "h": h}),
            vec![truth::product::triple(&f, &g, &h)],
            [1e-13, 1e-4],
        ),
        (
            json!({"op": "rotate", "f": f, "quat": quat}),
            truth::rotation::rotate(&f, quat),
            plain,
        ),
        (
            json!({"op": "window", "f": f, "h": 3.5}),
            truth::zonal::window(&f, 3.5),
            plain,
        ),
    ];
    // A positive function has a logarithm, and its eigenvalues stay away from the clip.
    let mut positive: Vec<f64> = f.iter().map(|x| 0.05 * x).collect();
    positive[0] = 3.0;
    let log = truth::log::eigen(&positive, truth::log::CLIP).expect("it is positive");
    cases.push((json!({"op": "log", "f": positive}), log, [1e-12, 1e-6]));
    for degree in [1, 2, 3, 4, 7] {
        let exp = truth::exp::ps_star(&f, degree);
        let method = format!("ps*:{degree}");
        cases.push((
            json!({"op": "exp", "f": f, "method": method}),
            exp,
            [1e-12, 1e-3],
        ));
    }
    for degree in [1, 5, 21] {
        let method = format!("ps:{degree}");
        let exp = truth::exp::series(&f, degree);
        cases.push((
            json!({"op": "exp", "f": f, "method": method}),
            exp,
            [1e-12, 1e-3],
        ));
    }
    let limit = truth::exp::series(&f, 60);
    cases.push((
        json!({"op": "exp", "f": f, "method": "eigen"}),
        limit,
        [1e-9, 1e-3],
    ));
    let samples = truth::log::samples(&positive, truth::log::CLIP, 100);
    cases.push((
        json!({"op": "log", "f": positive, "method": "samples"}),
        samples,
        [1e-12, 1e-6],
    ));
    cases.push((
        json!({"op": "exp", "f": f}),
        truth::exp::ps_star(&f, 2),
        [1e-12, 1e-3],
    ));
    for angle in [0.0, 1e-4, 0.3, 1.0, PI / 2.0, 2.5, PI] {
        let cap = truth::cap::visibility(order, angle);
        cases.push((json!({"op": "cap", "angle": angle}), cap, [1e-13, 1e-5]));
    }
    for angle in [0.1, 0.7, 1.5, 2.2] {
        let request = |method| json!({"op": "cap_log", "angle": angle, "method": method});
        let eigen =
            truth::log::cap_eigen(order, angle, truth::log::CLIP).expect("something is visible");
        cases.push((request("table"), eigen.clone(), [0.05, 0.05]));
        cases.push((request("eigen"), eigen, [1e-10, 1e-5]));
        let samples = truth::log::cap_samples(order, angle, truth::log::CLIP);
        cases.push((request("samples"), samples, [2e-3, 2e-3]));
    }
    for (request, ..) in &mut cases {
        request["order"] = json!(order);
    }
    cases
}

#[test]
fn every_operation_is_that_of_the_reference() {
    let cases: Vec<_> = (2..=6).flat_map(cases).collect();
    let requests: Vec<_> = cases.iter().map(|case| case.0.clone()).collect();
    for (backend, precision) in [("f64", 0), ("f32", 1)] {
        let answers = answers(backend, &requests);
        assert_eq!(answers.len(), cases.len());
        for ((request, expected, tolerances), answer) in cases.iter().zip(answers) {
            let found = answer["ok"]
                .as_array()
                .unwrap_or_else(|| panic!("{request}: {answer}"));
            assert_eq!(found.len(), expected.len(), "{request}");
            // Exponentials grow: the error goes with the largest coefficient.
            let scale = expected.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
            for (a, b) in found.iter().zip(expected) {
                let error = (a.as_f64().unwrap() - b).abs();
                assert!(
                    error <= tolerances[precision] * scale,
                    "{backend} {request}: {a} for {b}"
                );
            }
        }
    }
}

/// Blockers by the logarithm fitted to an exponential, summed, and the exponential of that: near the truth.
#[test]
fn every_exponential_takes_its_own_logarithm_back() {
    let caps = [
        ([0.0, 0.0, 1.0], 0.5),
        ([0.8, 0.0, 0.6], 0.4),
        ([0.0, -0.6, 0.8], 0.3),
    ];
    let truth = truth::arcs::project(
        4,
        &caps.map(|(axis, angle)| truth::visibility::Cap { axis, angle }),
    );
    for (exponential, fit) in [
        ("saturating", "fitted:saturating"),
        ("sampled", "fitted:sampled"),
        ("sampled:50", "fitted:sampled"),
        ("ps*:2", "fitted:ps*"),
        ("ps*:2", "fitted"),
        ("hyb", "fitted:hyb"),
        ("ps:21", "fitted:eigen"),
        ("eigen", "eigen"),
    ] {
        let logs = answers(
            "f64",
            &caps.map(
                |(_, angle)| json!({"op": "cap_log", "order": 4, "angle": angle, "method": fit}),
            ),
        );
        let mut sum = vec![0.0; 16];
        for ((axis, _), log) in caps.iter().zip(logs) {
            let zonal: Vec<f64> = serde_json::from_value(log["ok"].clone()).unwrap();
            let turned = truth::zonal::rotated(&zonal, *axis);
            sum.iter_mut().zip(turned).for_each(|(s, t)| *s += t);
        }
        let request = json!({"op": "exp", "order": 4, "f": sum, "method": exponential});
        let answer = answers("f64", &[request]).remove(0);
        let g: Vec<f64> = serde_json::from_value(answer["ok"].clone()).unwrap();
        let off = truth::basis::distance(&g, &truth.coefficients) / (4.0 * PI).sqrt();
        assert!(off < 0.06, "{exponential} of {fit}: {off}");
    }
}

#[test]
fn without_a_method_the_logarithm_is_the_eigen_one() {
    let request = |angle: f64, method: Value| {
        let mut request = json!({"op": "cap_log", "order": 4, "angle": angle});
        if !method.is_null() {
            request["method"] = method;
        }
        request
    };
    let answers = answers(
        "f64",
        &[
            request(0.4, Value::Null),
            request(0.4, json!("fitted")),
            request(0.4, json!("eigen")),
            request(2.0, Value::Null),
            request(2.0, json!("table")),
            request(2.0, json!("fitted")),
        ],
    );
    assert_eq!(answers[0], answers[1]);
    // The data file states the largest error of each band; none is above 0.55.
    for (a, b) in answers[1]["ok"]
        .as_array()
        .unwrap()
        .iter()
        .zip(answers[2]["ok"].as_array().unwrap())
    {
        let error = (a.as_f64().unwrap() - b.as_f64().unwrap()).abs();
        assert!(error > 0.0 && error < 0.55, "{error}");
    }
    assert_eq!(answers[3], answers[4]);
    assert!(
        answers[5]["error"].as_str().unwrap().contains("π/2"),
        "{}",
        answers[5]
    );
}

#[test]
fn hybrid_exponentials_of_small_vectors_are_near_the_series() {
    let f = [-0.3, 0.05, -0.02, 0.04];
    let requests =
        ["hyb", "ps*:9"].map(|method| json!({"op": "exp", "order": 2, "f": f, "method": method}));
    let [hyb, series] = answers("f64", &requests)
        .try_into()
        .map(|both: [Value; 2]| both.map(|a| a["ok"].as_array().unwrap().clone()))
        .unwrap();
    for (a, b) in hyb.iter().zip(&series) {
        assert!(
            (a.as_f64().unwrap() - b.as_f64().unwrap()).abs() < 1e-2,
            "{a} {b}"
        );
    }
}

#[test]
fn double_precision_goes_in_and_out_unharmed() {
    let f = [
        0.1,
        1.0 / 3.0,
        -2.2250738585072014e-308,
        1.7976931348623157e300,
    ];
    let answer = answers(
        "f64",
        &[json!({"op": "window", "order": 2, "f": f, "h": 1e300})],
    );
    let found: Vec<f64> = answer[0]["ok"]
        .as_array()
        .unwrap()
        .iter()
        .map(|x| x.as_f64().unwrap())
        .collect();
    assert_eq!(found, f);
}

#[test]
fn what_is_wrong_is_said_and_the_next_line_is_answered() {
    // Lines and what the answer has to name.
    let wrong: &[(&str, &str)] = &[
        ("", "empty"),
        ("   ", "empty"),
        ("hello", "not JSON"),
        ("{", "not JSON"),
        ("[1, 2]", "an array"),
        ("null", "null"),
        ("3", "a number"),
        (r#"{"order": 2, "f": [1, 2, 3, 4]}"#, "`op` is missing"),
        (r#"{"op": 7, "order": 2}"#, "`op` is a number"),
        (r#"{"op": "sqare", "order": 2, "f": [1, 2, 3, 4]}"#, "sqare"),
        (
            r#"{"op": "square", "f": [1, 2, 3, 4]}"#,
            "`order` is missing",
        ),
        (r#"{"op": "square", "order": 1, "f": [1]}"#, "`order` is 1"),
        (r#"{"op": "square", "order": 7, "f": []}"#, "`order` is 7"),
        (r#"{"op": "square", "order": -2, "f": []}"#, "`order` is -2"),
        (
            r#"{"op": "square", "order": 2.5, "f": []}"#,
            "`order` is 2.5",
        ),
        (r#"{"op": "square", "order": "2", "f": []}"#, "`order` is"),
        (r#"{"op": "square", "order": 2}"#, "`f` is missing"),
        (r#"{"op": "square", "order": 2, "f": 5}"#, "`f` is a number"),
        (
            r#"{"op": "square", "order": 2, "f": [1, 2, 3]}"#,
            "has 3 numbers; it needs 4 at order 2",
        ),
        (
            r#"{"op": "square", "order": 2, "f": [1, 2, 3, 4, 5]}"#,
            "has 5 numbers",
        ),
        (
            r#"{"op": "square", "order": 2, "f": [1, 2, 3, NaN]}"#,
            "not JSON",
        ),
        (
            r#"{"op": "square", "order": 2, "f": [1, 2, 3, Infinity]}"#,
            "not JSON",
        ),
        (
            r#"{"op": "square", "order": 2, "f": [1, 2, 3, 1e999]}"#,
            "out of range",
        ),
        (
            r#"{"op": "square", "order": 2, "f": [1, 2, 3, null]}"#,
            "`f[3]` is null",
        ),
        (
            r#"{"op": "square", "order": 2, "f": [1, 2, 3, "4"]}"#,
            "`f[3]` is a string",
        ),
        (
            r#"{"op": "square", "order": 2, "f": [1, 2, 3, 4], "g": [1, 2, 3, 4]}"#,
            "`g` is not an argument",
        ),
        (
            r#"{"op": "square", "order": 2, "f": [1e200, 1e200, 0, 0]}"#,
            "not finite",
        ),
        (
            r#"{"op": "product", "order": 2, "f": [1, 2, 3, 4]}"#,
            "`g` is missing",
        ),
        (
            r#"{"op": "triple", "order": 2, "f": [1, 2, 3, 4], "g": [1, 2, 3, 4]}"#,
            "`h` is missing",
        ),
        (
            r#"{"op": "zonal", "order": 3, "z": [1, 2], "dir": [0, 0, 1]}"#,
            "needs 3 at order 3",
        ),
        (
            r#"{"op": "basis", "order": 2, "dir": [0, 0, 1.01]}"#,
            "unit vector",
        ),
        (
            r#"{"op": "basis", "order": 2, "dir": [0, 0, 0]}"#,
            "unit vector",
        ),
        (
            r#"{"op": "basis", "order": 2, "dir": [1e300, 1e300, 0]}"#,
            "unit vector",
        ),
        (r#"{"op": "basis", "order": 2, "dir": [0, 1]}"#, "needs 3"),
        (
            r#"{"op": "rotate", "order": 2, "f": [1, 2, 3, 4], "quat": [0, 0, 0, 2]}"#,
            "unit vector",
        ),
        (
            r#"{"op": "cap", "order": 2, "angle": -0.1}"#,
            "between 0 and π",
        ),
        (
            r#"{"op": "cap", "order": 2, "angle": 3.2}"#,
            "between 0 and π",
        ),
        (
            r#"{"op": "cap", "order": 2, "angle": [1]}"#,
            "`angle` is an array",
        ),
        (
            r#"{"op": "cap_log", "order": 2, "angle": 1, "method": "best"}"#,
            "fitted:ol, fitted:eigen, table, eigen, samples",
        ),
        (
            r#"{"op": "cap_log", "order": 2, "angle": 1, "method": 3}"#,
            "`method` is a number",
        ),
        (
            r#"{"op": "exp", "order": 2, "f": [1, 2, 3, 4], "method": "ps*:x"}"#,
            "ps*:N",
        ),
        (
            r#"{"op": "exp", "order": 2, "f": [1, 2, 3, 4], "method": "ps*:0"}"#,
            "ps*:N",
        ),
        (
            r#"{"op": "exp", "order": 2, "f": [1, 2, 3, 4], "method": "ps*:99999999999999999999"}"#,
            "ps*:N",
        ),
        (
            r#"{"op": "exp", "order": 4, "f": [1, 2, 3, 4, 5, 6, 7, 8, 9, 1, 2, 3, 4, 5, 6, 7], "method": "sampled:14"}"#,
            "Q = 38, 50, 86 (at order 4)",
        ),
        (
            r#"{"op": "log", "order": 2, "f": [1, 2, 3, 4], "method": "fitted"}"#,
            "neither eigen nor samples",
        ),
        (
            r#"{"op": "exp", "order": 2, "f": [1e300, 1e300, 0, 0]}"#,
            "not finite",
        ),
        (
            r#"{"op": "window", "order": 2, "f": [1, 2, 3, 4], "h": 0}"#,
            "positive",
        ),
        (
            r#"{"op": "window", "order": 2, "f": [1, 2, 3, 4]}"#,
            "`h` is missing",
        ),
    ];
    let right = r#"{"op": "basis", "order": 2, "dir": [0, 0, 1]}"#;
    for backend in ["f64", "f32"] {
        let input: String = wrong
            .iter()
            .map(|(line, _)| format!("{line}\n{right}\n"))
            .collect();
        let answers = answers_to(backend, input.as_bytes());
        assert_eq!(answers.len(), 2 * wrong.len());
        for ((line, expected), pair) in wrong.iter().zip(answers.chunks(2)) {
            let error = pair[0]["error"]
                .as_str()
                .unwrap_or_else(|| panic!("{line}: {}", pair[0]));
            // Single precision says of large numbers that they are too large for it.
            let large = backend == "f32" && error.contains("beyond the range");
            assert!(error.contains(expected) || large, "{line}: {error}");
            assert!(pair[1]["ok"].is_array(), "after {line}: {}", pair[1]);
        }
    }
}

#[test]
fn bytes_that_are_no_text_and_a_missing_last_newline_are_answered() {
    let mut input = b"\xff\xfe{}\n".to_vec();
    input.extend_from_slice(b"[".repeat(100_000).as_slice());
    input.extend_from_slice(b"\n{\"op\": \"basis\", \"order\": 2, \"dir\": [1, 0, 0]}");
    let answers = answers_to("f64", &input);
    assert_eq!(answers.len(), 3);
    assert!(answers[0]["error"].as_str().unwrap().contains("UTF-8"));
    assert!(answers[1]["error"].as_str().unwrap().contains("not JSON"));
    assert!(answers[2]["ok"].is_array());
}

#[test]
fn no_input_has_no_answers() {
    assert!(answers_to("f64", b"").is_empty());
}
