//! The checked-in fitted constants are what `gaunt-lab fit` computes.

/// The rows of a data file as words, comments apart.
fn rows(text: &str) -> Vec<Vec<&str>> {
    text.lines()
        .filter_map(|line| line.split('#').next())
        .map(|line| line.split_whitespace().collect::<Vec<_>>())
        .filter(|row| !row.is_empty())
        .collect()
}

/// How far a number may be off, for another processor may round differently: an eigenanalysis a little, and where
/// a fit by many small steps ends a little more.
fn tolerance(file: &str, row: &[&str]) -> f64 {
    let steps = match file {
        "cap_log.txt" => row[0] != "eigen",
        file => matches!(file, "saturating.txt" | "shading.txt" | "horizon.txt"),
    };
    if steps { 1e-3 } else { 1e-5 }
}

#[test]
fn checked_in_data_is_the_fit() {
    for file in gaunt_lab::fit::all(None, &|_| {}) {
        let path = format!(
            "{}/../codegen/data/{}",
            env!("CARGO_MANIFEST_DIR"),
            file.name
        );
        let checked_in = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"));
        let (ours, refitted) = (rows(&checked_in), rows(&file.text));
        assert_eq!(ours.len(), refitted.len(), "{}", file.name);
        for (a, b) in ours.iter().zip(&refitted) {
            assert_eq!(a.len(), b.len(), "{}: {a:?}", file.name);
            let permitted = tolerance(file.name, a);
            for (x, y) in a.iter().zip(b) {
                match (x.parse::<f64>(), y.parse::<f64>()) {
                    (Ok(x), Ok(y)) => assert!(
                        (x - y).abs() <= permitted * (1.0 + x.abs()),
                        "{}, {} {}: {x}, refitted {y}",
                        file.name,
                        a[0],
                        a[1]
                    ),
                    _ => assert_eq!(x, y, "{}", file.name),
                }
            }
        }
    }
}
