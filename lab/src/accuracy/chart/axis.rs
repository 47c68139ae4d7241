//! Logarithmic axes.

/// A logarithmic scale along one side of a panel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Axis {
    /// The least and greatest value.
    values: [f64; 2],
    /// Where they are, in pixels.
    pixels: [f64; 2],
}

impl Axis {
    /// From the least to the greatest value, each at its pixel.
    pub fn new(values: [f64; 2], pixels: [f64; 2]) -> Self {
        Self { values, pixels }
    }

    /// Where a value is. What lies beyond an end is at that end.
    pub fn at(&self, value: f64) -> f64 {
        let [least, greatest] = self.values;
        let part = (value.clamp(least, greatest) / least).ln() / (greatest / least).ln();
        self.pixels[0] + part * (self.pixels[1] - self.pixels[0])
    }

    /// Whether a value lies between the ends.
    pub fn holds(&self, value: f64) -> bool {
        (self.values[0]..=self.values[1]).contains(&value)
    }

    /// Round values to write at the axis: the most that leave so many pixels to each.
    pub fn ticks(&self, room: f64) -> Vec<f64> {
        let [least, greatest] = self.values;
        let decades = least.log10().floor() as i32..=greatest.log10().ceil() as i32;
        for mantissas in [
            &[1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0][..],
            &[1.0, 1.5, 2.0, 3.0, 5.0, 7.0],
            &[1.0, 2.0, 5.0],
            &[1.0, 3.0],
            &[1.0],
        ] {
            let ticks: Vec<f64> = decades
                .clone()
                // Dividing by a whole power is exact to rounding: 0.03 stays 0.03.
                .flat_map(|e| {
                    mantissas.iter().map(move |m| {
                        if e < 0 {
                            m / 10_f64.powi(-e)
                        } else {
                            m * 10_f64.powi(e)
                        }
                    })
                })
                .filter(|tick| self.holds(*tick))
                .collect();
            let apart = |pair: &[f64]| (self.at(pair[1]) - self.at(pair[0])).abs() >= room;
            if ticks.windows(2).all(apart) {
                return ticks;
            }
        }
        Vec::new()
    }
}

/// The least and greatest of the values that a logarithmic axis can have, with a margin, as a factor, at either
/// end; none if there is no such value.
pub(super) fn range(values: impl Iterator<Item = f64>, below: f64, above: f64) -> Option<[f64; 2]> {
    let usable = values.filter(|value| value.is_normal() && *value > 0.0);
    let ends = usable.fold(None, |ends: Option<[f64; 2]>, value| {
        let [least, greatest] = ends.unwrap_or([value; 2]);
        Some([least.min(value), greatest.max(value)])
    });
    // Ends must be numbers still, even beside the largest.
    ends.map(|[least, greatest]| {
        [
            (least / below).max(f64::MIN_POSITIVE),
            (greatest * above).min(f64::MAX),
        ]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_axis_is_logarithmic_and_ends_at_its_ends() {
        let axis = Axis::new([1.0, 100.0], [0.0, 200.0]);
        for (value, pixel) in [
            (1.0, 0.0),
            (10.0, 100.0),
            (100.0, 200.0),
            (0.0, 0.0),
            (1e9, 200.0),
            (f64::INFINITY, 200.0),
        ] {
            assert!((axis.at(value) - pixel).abs() < 1e-9, "{value}");
        }
    }

    #[test]
    fn ticks_are_round_and_apart() {
        let axis = Axis::new([0.028, 0.31], [400.0, 0.0]);
        assert_eq!(
            axis.ticks(20.0),
            [0.03, 0.04, 0.05, 0.06, 0.08, 0.1, 0.15, 0.2, 0.3]
        );
        assert_eq!(axis.ticks(60.0), [0.05, 0.1, 0.2]);
        assert_eq!(
            Axis::new([0.5, 2e6], [0.0, 400.0]).ticks(40.0),
            [1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6]
        );
    }

    #[test]
    fn a_range_passes_over_what_has_no_logarithm() {
        let values = [2.0, 0.0, -1.0, f64::NAN, f64::INFINITY, 8.0];
        assert_eq!(range(values.into_iter(), 2.0, 4.0), Some([1.0, 32.0]));
        assert_eq!(range([0.0, f64::NAN].into_iter(), 2.0, 2.0), None);
    }
}
