//! The checked-in fitted constants are what `gaunt fit` computes.

/// Numbers of a data file, comments apart.
fn numbers(text: &str) -> Vec<f64> {
    text.lines()
        .filter_map(|line| line.split('#').next())
        .flat_map(str::split_whitespace)
        .map(|word| word.parse().expect("data files hold numbers"))
        .collect()
}

#[test]
fn checked_in_data_is_the_fit() {
    for file in gaunt::fit::all(&|_| {}) {
        let path = format!(
            "{}/../codegen/data/{}",
            env!("CARGO_MANIFEST_DIR"),
            file.name
        );
        let checked_in = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"));
        let (a, b) = (numbers(&checked_in), numbers(&file.text));
        assert_eq!(a.len(), b.len(), "{}", file.name);
        for (i, (a, b)) in a.iter().zip(&b).enumerate() {
            // Another processor may round an eigenanalysis differently.
            assert!(
                (a - b).abs() <= 1e-5 * (1.0 + a.abs()),
                "{}, number {i}: {a}, refitted {b}",
                file.name
            );
        }
    }
}
