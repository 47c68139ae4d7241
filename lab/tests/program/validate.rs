//! `gaunt-lab validate`.

use crate::{failure, success};
use serde_json::Value;

/// The optimal case of spherical lights: one ball, whose sphere it is. What is left is the order of the light.
#[test]
fn a_ball_on_a_plane_sends_on_what_it_should() {
    let small = ["--size", "64x36", "--reference", "192"];
    let only = ["validate", "--json", "--only", "sphere,weights"];
    let text = success(&[&only[..], &small[..]].concat());
    let report: Value = serde_json::from_str(&text).expect("JSON");
    let rows = report["scenes"].as_array().expect("a list of scenes");
    let [row] = &rows[..] else {
        panic!("one scene: {text}")
    };
    let figure = |name: &str| row[name].as_f64().expect("a figure");
    assert_eq!(row["spheres"], 1);
    assert!(figure("share") > 0.005, "{text}");
    assert!(figure("direct") < 0.03, "{text}");
    assert!(figure("relative") < 0.2, "{text}");
    assert!(figure("relative_bias").abs() < 0.1, "{text}");
    // Nothing hides a single light but the horizon: both ways of blocking agree about as well as either is right.
    assert!((figure("runs") - figure("relative")).abs() < 0.1, "{text}");
    let weights = report["weights"].as_array().expect("a list of weights");
    assert!(!weights.is_empty());
    for row in weights {
        let [solid, slope] = ["solid_angle", "slope"].map(|k| row[k].as_f64().expect("a figure"));
        assert!(solid < slope && slope < 0.1, "{row}");
    }
    assert!(report["counts"].as_array().is_some_and(Vec::is_empty));
}

#[test]
fn names_that_are_not_there_are_told() {
    let complaint = failure(&["validate", "--only", "sphere,teapot"]);
    assert!(
        complaint.contains("\"teapot\"") && complaint.contains("bend-180"),
        "{complaint}"
    );
}
