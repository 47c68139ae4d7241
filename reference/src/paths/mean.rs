//! The mean of paths, and how far it may be off.

/// What a receiver reflects at albedo 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Radiance {
    /// Light that no body has reflected; red, green and blue.
    pub direct: [f64; 3],
    /// Light that at least one body has reflected.
    pub indirect: [f64; 3],
    /// Standard error of `direct`. It is estimated from the spread of eighths of the paths as if these were
    /// independent; they rather make up for each other, and the true error is usually smaller. Infinite for one path.
    pub direct_error: [f64; 3],
    /// Standard error of `indirect`.
    pub indirect_error: [f64; 3],
}

impl Radiance {
    /// All light.
    ///
    /// ```
    /// # use sh_reference::paths::Radiance;
    /// let seen = Radiance { direct: [1.0; 3], indirect: [0.5; 3], ..Radiance::default() };
    /// assert_eq!(seen.total(), [1.5; 3]);
    /// ```
    pub fn total(&self) -> [f64; 3] {
        [0, 1, 2].map(|c| self.direct[c] + self.indirect[c])
    }
}

/// Parts whose means are compared. A part of a Sobol sequence is spread as evenly as the whole.
const PARTS: usize = 8;

/// Adds up paths in their order.
pub(super) struct Mean {
    paths: usize,
    parts: usize,
    added: usize,
    /// Direct and indirect light of each part.
    sums: [[[f64; 3]; 2]; PARTS],
    counts: [f64; PARTS],
}

impl Mean {
    pub fn new(paths: u32) -> Self {
        assert!(paths > 0, "a mean of no paths");
        let paths = paths as usize;
        Self {
            paths,
            parts: paths.min(PARTS),
            added: 0,
            sums: [[[0.0; 3]; 2]; PARTS],
            counts: [0.0; PARTS],
        }
    }

    pub fn add(&mut self, path: [[f64; 3]; 2]) {
        let part = self.added * self.parts / self.paths;
        for (sum, light) in self.sums[part].iter_mut().zip(path) {
            for (sum, c) in sum.iter_mut().zip(light) {
                *sum += c;
            }
        }
        self.counts[part] += 1.0;
        self.added += 1;
    }

    /// The mean; where light rings, nothing below 0.
    pub fn radiance(&self, rings: bool) -> Radiance {
        let mut radiance = Radiance::default();
        for c in 0..3 {
            let [direct, indirect] = [0, 1].map(|kind| self.one(kind, c));
            let [a, b] =
                [direct, indirect].map(|[mean, _]| if rings { mean.max(0.0) } else { mean });
            (radiance.direct[c], radiance.indirect[c]) = (a, b);
            (radiance.direct_error[c], radiance.indirect_error[c]) = (direct[1], indirect[1]);
        }
        radiance
    }

    /// Mean and standard error of one number.
    fn one(&self, kind: usize, channel: usize) -> [f64; 2] {
        let parts = || self.counts[..self.parts].iter().zip(&self.sums);
        let count = self.added as f64;
        let mean = parts().map(|(_, sum)| sum[kind][channel]).sum::<f64>() / count;
        if self.parts < 2 {
            return [mean, f64::INFINITY];
        }
        let spread = parts().map(|(n, sum)| n * (sum[kind][channel] / n - mean).powi(2));
        let error = (spread.sum::<f64>() / (count * (self.parts - 1) as f64)).sqrt();
        [mean, error]
    }
}
