//! Values of the basis that SciPy computed: the judge of signs and order.
//!
//! Gaunt coefficients, products and logarithms come out alike under most sign conventions, so nothing
//! computed here could notice a wrong one. `data/sph_harm.csv` holds 44 directions (axes, corners, tilts of
//! 1e-2, 1e-5 and 1e-9 from both poles, a spiral) and 36 values each; `data/make_sph_harm.py` wrote it and
//! says how real functions follow from SciPy's complex ones.

/// The text of the table.
const TABLE: &str = include_str!("../data/sph_harm.csv");

/// Order of the table's vectors.
pub const ORDER: usize = 6;

/// One row of the table.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// A unit vector, up to rounding.
    pub direction: [f64; 3],
    /// The basis in that direction, index l·l + l + m. SciPy's error is at most 2e-15.
    pub values: [f64; ORDER * ORDER],
}

/// The whole table.
///
/// ```
/// for sample in sh_reference::scipy::samples() {
///     let found = sh_reference::basis::basis(6, sample.direction);
///     assert!(found.iter().zip(sample.values).all(|(a, b)| (a - b).abs() < 1e-14));
/// }
/// ```
pub fn samples() -> Vec<Sample> {
    TABLE
        .lines()
        .filter(|line| !line.starts_with('#'))
        .map(parse)
        .collect()
}

fn parse(line: &str) -> Sample {
    let mut numbers = line
        .split(',')
        .map(|text| text.parse().expect("sph_harm.csv holds numbers only"));
    let mut next = || {
        numbers
            .next()
            .expect("each row of sph_harm.csv has 39 numbers")
    };
    Sample {
        direction: [(); 3].map(|()| next()),
        values: [(); ORDER * ORDER].map(|()| next()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::basis::basis;
    use crate::testing::assert_close;

    #[test]
    fn basis_is_scipys() {
        let samples = samples();
        assert_eq!(samples.len(), 44);
        for sample in samples {
            let squares: f64 = sample.direction.iter().map(|c| c * c).sum();
            assert!((squares - 1.0).abs() < 1e-15);
            assert_close(&basis(ORDER, sample.direction), &sample.values, 3e-15);
        }
    }

    #[test]
    fn lower_orders_are_prefixes() {
        for sample in samples() {
            for order in 1..ORDER {
                assert_close(
                    &basis(order, sample.direction),
                    &sample.values[..order * order],
                    3e-15,
                );
            }
        }
    }
}
