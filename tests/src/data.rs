//! The fitted constants, read here from `codegen/data/`, and the fixed numbers of the routines that use them, typed from their
//! documentation: so the truth of a fitted function shares its data with the generator, and no code.

/// A file of fitted data.
#[derive(Clone, Copy, Debug)]
pub struct Data(&'static str);

/// Polynomials of what is seen of a ball.
pub const BALL: Data = Data(include_str!("../../codegen/data/ball.txt"));
/// Logarithms of caps.
pub const CAP_LOG: Data = Data(include_str!("../../codegen/data/cap_log.txt"));
/// The lobe of a polished surface.
pub const GLOSS: Data = Data(include_str!("../../codegen/data/gloss.txt"));
/// The sphere that a horizon cuts.
pub const HORIZON: Data = Data(include_str!("../../codegen/data/horizon.txt"));
/// The common part of two discs.
pub const LENS: Data = Data(include_str!("../../codegen/data/lens.txt"));
/// Factors of the optimal linear exponential.
pub const OPTIMAL_LINEAR: Data = Data(include_str!("../../codegen/data/optimal_linear.txt"));
/// Compression and gains of the saturating exponential.
pub const SATURATING: Data = Data(include_str!("../../codegen/data/saturating.txt"));
/// Compression of the transfer, and its logarithm.
pub const SHADING: Data = Data(include_str!("../../codegen/data/shading.txt"));

impl Data {
    /// The numbers of each line that starts with these words.
    ///
    /// # Panics
    /// If there is no such line.
    pub fn rows(self, words: &str) -> Vec<Vec<f64>> {
        let lines = self.0.lines().filter(|line| !line.starts_with('#'));
        let numbers = lines.filter_map(|line| {
            let rest = line.strip_prefix(words)?.strip_prefix(' ')?;
            let number = |word: &str| word.parse().expect("a number");
            Some(rest.split(' ').map(number).collect())
        });
        let rows: Vec<Vec<f64>> = numbers.collect();
        assert!(
            !rows.is_empty(),
            "no line of the data starts with `{words}`"
        );
        rows
    }

    /// The numbers of the only such line.
    ///
    /// # Panics
    /// If there are none or several.
    pub fn row(self, words: &str) -> Vec<f64> {
        let [row] = <[_; 1]>::try_from(self.rows(words)).expect("one line");
        row
    }
}

/// The polynomials of a cap's logarithm, band by band, in u = 2 cos θ − 1.
pub fn cap_log(fitted_to: &str, order: usize) -> Vec<Vec<f64>> {
    let bands = match fitted_to {
        "shading" => SHADING.rows(&format!("log {order}")),
        _ => CAP_LOG.rows(&format!("{fitted_to} {order}")),
    };
    assert_eq!(bands.len(), order);
    bands
}

/// How many points samples are taken at, by order from 2: coarsely, as a rule, and finely.
pub fn points(order: usize, fineness: usize) -> usize {
    [
        [6, 14, 26],
        [14, 26, 38],
        [38, 50, 86],
        [50, 86, 110],
        [50, 86, 110],
    ][order - 2][fineness]
}

/// The scale of coefficient i of an accumulated sum of logarithms: √(4π/(2l+1)), which turns a zonal function, times the
/// leading factor of the basis function, K_lm (2l)!/(2^l l! (l−m)!), with √2 for m ≠ 0.
pub fn accumulation_factor(i: usize) -> f64 {
    let l = i.isqrt();
    let m = i.abs_diff(l * l + l);
    let factorial = |n: usize| (1..=n).map(|k| k as f64).product::<f64>();
    let lead = factorial(2 * l) / (2_f64.powi(l as i32) * factorial(l) * factorial(l - m));
    let both = if m == 0 { 1.0 } else { 2.0 };
    // K_lm √(4π/(2l+1)) is the root of (l−m)!/(l+m)!.
    (both * factorial(l - m) / factorial(l + m)).sqrt() * lead
}
