//! How far a picture of radiance is from another.

use serde::Serialize;

/// Red, green and blue of every receiver, reflected at albedo 1.
pub type Radiance = Vec<[f32; 3]>;

/// Direct and indirect light of the same receivers, or differences of them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Parts {
    /// Light that no body has reflected.
    pub direct: Radiance,
    /// Light that at least one body has.
    pub indirect: Radiance,
}

impl Parts {
    /// Both together.
    pub fn total(&self) -> Radiance {
        let pairs = self.direct.iter().zip(&self.indirect);
        pairs
            .map(|(a, b)| std::array::from_fn(|c| a[c] + b[c]))
            .collect()
    }
}

/// Figures of a difference, all over the same scale. A receiver's error is the root of the mean square over its three
/// channels.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Figures {
    /// Root of the mean square of receivers' errors, less that of the truth's own (`noise`), which is independent of
    /// them; 0 where no more than noise is left. The mean and the percentile have the noise in them.
    pub rms: f64,
    /// Their mean.
    pub mean: f64,
    /// What 99 of 100 stay below.
    pub p99: f64,
    /// The mean of ours minus the truth, over all channels: above 0 where ours is too bright.
    pub bias: f64,
    /// Root of the mean square of the truth's own errors.
    pub noise: f64,
}

impl Figures {
    /// The difference of `ours` to `truth`, receiver by receiver, over `scale`. `errors` are random, of the size of the
    /// truth's own on average. All figures are 0 where there is no receiver.
    ///
    /// ```
    /// use gaunt::compare::Figures;
    /// let truth = [[1.0; 3], [2.0; 3]];
    /// let ours = [[1.0; 3], [2.5; 3]];
    /// let figures = Figures::new(&ours, &truth, &[[0.0; 3]; 2], 1.5);
    /// assert!((figures.mean - 0.25 / 1.5).abs() < 1e-12 && figures.bias == figures.mean);
    /// assert!((figures.p99 - 0.5 / 1.5).abs() < 1e-12);
    /// ```
    pub fn new(ours: &[[f32; 3]], truth: &[[f32; 3]], errors: &[[f32; 3]], scale: f64) -> Self {
        let mut each = Vec::with_capacity(truth.len());
        let (mut bias, mut noise) = (0.0, 0.0);
        for ((ours, truth), error) in ours.iter().zip(truth).zip(errors) {
            let mut squares = 0.0;
            for c in 0..3 {
                let off = f64::from(ours[c]) - f64::from(truth[c]);
                squares += off * off / 3.0;
                bias += off / 3.0;
                noise += f64::from(error[c]).powi(2) / 3.0;
            }
            each.push(squares.sqrt());
        }
        each.sort_by(f64::total_cmp);
        let count = each.len().max(1) as f64;
        // The nearest rank.
        let rank = (0.99 * each.len() as f64).ceil() as usize;
        let p99 = each.get(rank.saturating_sub(1)).copied();
        let over = |value: f64| value / scale;
        let squares = each.iter().map(|e| e * e).sum::<f64>();
        Self {
            rms: over(((squares - noise).max(0.0) / count).sqrt()),
            mean: over(each.iter().sum::<f64>() / count),
            p99: over(p99.unwrap_or(0.0)),
            bias: over(bias / count),
            noise: over((noise / count).sqrt()),
        }
    }
}

/// The mean of all receivers and channels, which errors are told in parts of; 1 in the dark.
pub fn scale(truth: &[[f32; 3]]) -> f64 {
    let sum: f64 = truth.iter().flatten().map(|c| f64::from(*c)).sum();
    if sum > 0.0 {
        sum / (3 * truth.len()) as f64
    } else {
        1.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_of_a_known_difference() {
        // Receiver i is off by i per cent, up and down in turn.
        let truth = vec![[2.0, 4.0, 6.0]; 200];
        let sign = |i: usize| if i.is_multiple_of(2) { 1.0 } else { -1.0 };
        let off = |i: usize| sign(i) * 0.01 * i as f32;
        let ours = truth.iter().enumerate();
        let ours: Vec<_> = ours.map(|(i, t)| t.map(|c| c + off(i))).collect();
        let scale = scale(&truth);
        assert!((scale - 4.0).abs() < 1e-12);
        let figures = Figures::new(&ours, &truth, &vec![[0.3, 0.0, 0.4]; 200], scale);
        let mean_square = (0..200).map(|i| f64::from(off(i)).powi(2)).sum::<f64>() / 200.0;
        let noise_square = 0.25 / 3.0;
        let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-6, "{a} {b}");
        close(figures.rms, (mean_square - noise_square).sqrt() / 4.0);
        close(figures.mean, 0.995 / 4.0);
        // The 198th of 200.
        close(figures.p99, 1.97 / 4.0);
        close(figures.bias, -0.005 / 4.0);
        close(figures.noise, f64::sqrt(noise_square) / 4.0);
        let noisy = Figures::new(&truth, &truth, &vec![[0.1; 3]; 200], scale);
        assert_eq!(noisy.rms, 0.0);
    }

    #[test]
    fn nothing_is_compared_without_receivers_or_light() {
        let none = Figures::new(&[], &[], &[], scale(&[]));
        assert_eq!(
            (none.rms, none.mean, none.p99, none.noise),
            (0.0, 0.0, 0.0, 0.0)
        );
        assert_eq!(scale(&[[0.0; 3]]), 1.0);
    }
}
