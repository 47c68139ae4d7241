//! Singular values, by rotating columns until they are at right angles to each other (Hestenes 1958, "Inversion of matrices
//! by biorthogonalization and related results"; Golub and Van Loan, section 8.6.3): slow beside other ways, small, and as
//! exact for small singular values as for large ones.

/// What a matrix is made of: A = Σ σₖ uₖ vₖᵀ, from the largest σ on.
pub(super) struct Singular {
    /// The uₖ: unit vectors; none where σₖ is 0.
    pub left: Vec<Vec<f64>>,
    pub values: Vec<f64>,
    /// The vₖ: unit vectors.
    pub right: Vec<Vec<f64>>,
}

/// Columns are at right angles where the cosine between them is below this.
const RIGHT: f64 = 1e-14;

/// Rounds over all pairs: each about squares what is left, so that ten do for any matrix.
const ROUNDS: usize = 40;

/// Of the matrix with these columns.
pub(super) fn singular(mut columns: Vec<Vec<f64>>) -> Singular {
    let count = columns.len();
    // Large ones first: fewer rounds.
    let mut order: Vec<usize> = (0..count).collect();
    let norms: Vec<f64> = columns.iter().map(|c| dot(c, c)).collect();
    order.sort_by(|a, b| norms[*b].total_cmp(&norms[*a]));
    let mut right: Vec<Vec<f64>> = Vec::new();
    let mut sorted = Vec::new();
    for &from in &order {
        let mut unit = vec![0.0; count];
        unit[from] = 1.0;
        right.push(unit);
        sorted.push(std::mem::take(&mut columns[from]));
    }
    let mut columns = sorted;
    for _ in 0..ROUNDS {
        let mut turned = false;
        for low in 0..count {
            for high in low + 1..count {
                let (a, b) = pair(&mut columns, low, high);
                let [aa, bb, ab] = [dot(a, a), dot(b, b), dot(a, b)];
                if ab.abs() <= RIGHT * (aa * bb).sqrt() || !ab.is_finite() {
                    continue;
                }
                turned = true;
                let slope = (bb - aa) / (2.0 * ab);
                let tangent = slope.signum() / (slope.abs() + slope.hypot(1.0));
                let cosine = 1.0 / tangent.hypot(1.0);
                turn(a, b, cosine, cosine * tangent);
                let (a, b) = pair(&mut right, low, high);
                turn(a, b, cosine, cosine * tangent);
            }
        }
        if !turned {
            break;
        }
    }
    let values: Vec<f64> = columns.iter().map(|c| dot(c, c).sqrt()).collect();
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|a, b| values[*b].total_cmp(&values[*a]));
    let unit = |k: usize| -> Vec<f64> {
        let scale = if values[k] > 0.0 { values[k] } else { 1.0 };
        columns[k].iter().map(|x| x / scale).collect()
    };
    Singular {
        left: order.iter().map(|&k| unit(k)).collect(),
        right: order.iter().map(|&k| right[k].clone()).collect(),
        values: order.iter().map(|&k| values[k]).collect(),
    }
}

impl Singular {
    /// How far Σ σₖ uₖ vₖᵀ is from a matrix, over the size of that.
    pub fn error(&self, columns: &[Vec<f64>]) -> f64 {
        let (mut off, mut all) = (0.0, 0.0);
        for (j, column) in columns.iter().enumerate() {
            let mut rest = column.clone();
            for ((left, value), right) in self.left.iter().zip(&self.values).zip(&self.right) {
                let scale = value * right[j];
                for (rest, left) in rest.iter_mut().zip(left) {
                    *rest -= scale * left;
                }
            }
            off += dot(&rest, &rest);
            all += dot(column, column);
        }
        if all > 0.0 { (off / all).sqrt() } else { off }
    }
}

/// Two columns at once.
fn pair(all: &mut [Vec<f64>], low: usize, high: usize) -> (&mut [f64], &mut [f64]) {
    let (before, after) = all.split_at_mut(high);
    (&mut before[low], &mut after[0])
}

fn turn(a: &mut [f64], b: &mut [f64], cosine: f64, sine: f64) {
    for (a, b) in a.iter_mut().zip(b) {
        (*a, *b) = (cosine * *a - sine * *b, sine * *a + cosine * *b);
    }
}

/// Several sums side by side: one alone waits for itself.
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let ([a, rest_a], [b, rest_b]) = (split(a), split(b));
    let mut sums = [0.0; 8];
    for (a, b) in a.as_chunks::<8>().0.iter().zip(b.as_chunks::<8>().0) {
        for ((sum, a), b) in sums.iter_mut().zip(a).zip(b) {
            *sum += a * b;
        }
    }
    let rest: f64 = rest_a.iter().zip(rest_b).map(|(a, b)| a * b).sum();
    sums.iter().sum::<f64>() + rest
}

fn split(all: &[f64]) -> [&[f64]; 2] {
    let (whole, rest) = all.split_at(all.len() / 8 * 8);
    [whole, rest]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers(rows: usize, columns: usize, seed: f64) -> Vec<Vec<f64>> {
        let at = |i: usize| (seed + 12.9898 * i as f64).sin() * 43.7;
        let column = |j: usize| (0..rows).map(|i| at(j * rows + i).fract()).collect();
        (0..columns).map(column).collect()
    }

    fn check(columns: &[Vec<f64>], what: &str) -> Singular {
        let found = singular(columns.to_vec());
        assert!(found.error(columns) < 1e-13, "{what}");
        assert!(found.values.is_sorted_by(|a, b| a >= b), "{what}");
        let rank = found.values.iter().filter(|s| **s > 1e-12).count();
        for vectors in [&found.left[..rank], &found.right] {
            for (i, a) in vectors.iter().enumerate() {
                for (j, b) in vectors.iter().enumerate() {
                    let expected = if i == j { 1.0 } else { 0.0 };
                    assert!((dot(a, b) - expected).abs() < 1e-12, "{what}: {i} {j}");
                }
            }
        }
        found
    }

    /// Shapes and ranks of every kind come back from what they are taken apart into.
    #[test]
    fn a_matrix_is_what_it_is_made_of() {
        for (rows, columns) in [(1, 1), (3, 3), (40, 7), (7, 40), (64, 64), (200, 30)] {
            check(&numbers(rows, columns, 0.3), "full");
            check(&vec![vec![1.0; rows]; columns], "ones");
            check(&vec![vec![0.0; rows]; columns], "nothing");
            let mut twice = numbers(rows, columns, 0.7);
            twice.extend(twice.clone());
            let found = check(&twice, "twice");
            let rank = found.values.iter().filter(|s| **s > 1e-12).count();
            assert!(rank <= columns.min(rows), "{rank}");
        }
    }

    /// Columns at known angles: the singular values of [a b] are known in closed form.
    #[test]
    fn values_are_those_of_the_closed_form() {
        for angle in [1e-6_f64, 0.1, 1.0, 1.5] {
            let columns = [vec![1.0, 0.0], vec![angle.cos(), angle.sin()]];
            let found = check(&columns, "angle");
            let expected = [(1.0 + angle.cos()).sqrt(), (1.0 - angle.cos()).sqrt()];
            for (found, expected) in found.values.iter().zip(expected) {
                assert!(
                    (found - expected).abs() < 1e-10,
                    "{angle}: {found} {expected}"
                );
            }
        }
        // Values many orders apart are all exact.
        let scales = [1.0, 1e-3, 1e-6, 1e-9];
        let mut columns = vec![vec![0.0; 4]; 4];
        for (k, scale) in scales.iter().enumerate() {
            columns[3 - k][k] = *scale;
        }
        let found = check(&columns, "scales");
        for (found, scale) in found.values.iter().zip(scales) {
            assert!((found / scale - 1.0).abs() < 1e-12);
        }
    }
}
