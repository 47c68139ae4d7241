//! What is printed from tables: operation counts and projections.

use crate::{Folder, success};
use serde_json::Value;

/// Multiplications and additions that a routine may take at orders 2 to 6.
const PERMITTED: [(&str, [[u64; 2]; 5]); 2] = [
    (
        "product",
        [[16, 6], [96, 74], [329, 274], [937, 860], [2051, 1995]],
    ),
    (
        "square",
        [[14, 3], [77, 43], [246, 157], [699, 507], [1556, 1189]],
    ),
];

#[test]
fn operation_counts_are_within_bounds() {
    let counts: Vec<Value> = serde_json::from_str(&success(&["ops", "--json"])).expect("JSON");
    for (routine, permitted) in PERMITTED {
        for (order, [mul, add]) in (2..).zip(permitted) {
            let found: Vec<_> = counts
                .iter()
                .filter(|c| c["routine"] == routine && c["order"] == order)
                .collect();
            assert_eq!(found.len(), 1, "{routine} at order {order}");
            let count = |what: &str| found[0][what].as_u64().unwrap();
            assert!(count("mul") > 0 && count("mul") <= mul, "{}", found[0]);
            assert!(count("add") > 0 && count("add") <= add, "{}", found[0]);
        }
    }
}

#[test]
fn counts_are_also_a_table() {
    let text = success(&["ops"]);
    assert!(
        text.lines().any(|line| line.starts_with("rotate ")),
        "{text}"
    );
}

/// An HDR file of one colour.
fn constant_map(folder: &Folder, rgb: [f32; 3]) -> String {
    let path = folder.file("constant.hdr");
    let image = image::Rgb32FImage::from_pixel(8, 4, image::Rgb(rgb));
    image.save(&path).expect("writing an HDR file");
    path
}

#[test]
fn a_constant_map_projects_to_its_mean() {
    let folder = Folder::new("project");
    let map = constant_map(&folder, [2.0, 1.0, 0.5]);
    let text = success(&["project", &map, "--order", "3", "--json"]);
    let coefficients: Vec<[f64; 3]> = serde_json::from_str(&text).expect("JSON");
    assert_eq!(coefficients.len(), 9);
    let one = (4.0 * std::f64::consts::PI).sqrt();
    for (i, rgb) in coefficients.iter().enumerate() {
        for (found, radiance) in rgb.iter().zip([2.0, 1.0, 0.5]) {
            let expected = if i == 0 { radiance * one } else { 0.0 };
            assert!((found - expected).abs() < 1e-12, "coefficient {i}: {found}");
        }
    }
    let table = success(&["project", &map, "--order", "2"]);
    assert_eq!(table.lines().count(), 5, "{table}");
}
