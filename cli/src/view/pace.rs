//! How large a picture may be so that the next one is there in time.

/// Seconds that a picture may take while something moves.
const BUDGET: f64 = 0.06;

/// While something moves each side may be divided by one of these.
const DIVISORS: [u32; 5] = [1, 2, 3, 4, 6];

/// What pictures have taken lately.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Pace {
    /// Seconds a pixel; 0 at first.
    pixel: f64,
    divisor: usize,
}

impl Pace {
    /// Notes what a picture took.
    pub fn note(&mut self, [width, height]: [u32; 2], seconds: f64) {
        let pixel = seconds / (f64::from(width) * f64::from(height));
        self.pixel = match self.pixel > 0.0 {
            true => 0.6 * self.pixel + 0.4 * pixel,
            false => pixel,
        };
    }

    /// The size of a picture while something moves, for one that is `full` when nothing does.
    pub fn moving(&mut self, full: [u32; 2]) -> [u32; 2] {
        let pixels = f64::from(full[0]) * f64::from(full[1]);
        let seconds = |divisor: u32| self.pixel * pixels / f64::from(divisor * divisor);
        let fits = DIVISORS
            .iter()
            .position(|&divisor| seconds(divisor) <= BUDGET);
        let fits = fits.unwrap_or(DIVISORS.len() - 1);
        // Back to a finer picture only where it takes clearly less than it may: sizes that alternate are unquiet.
        let finer = seconds(DIVISORS[fits]) <= 0.7 * BUDGET;
        if fits > self.divisor || finer {
            self.divisor = fits;
        }
        full.map(|side| even(side.div_ceil(DIVISORS[self.divisor])))
    }
}

/// The next even number: at half resolution every ray then stands for two by two pixels.
pub(super) fn even(side: u32) -> u32 {
    side.max(2).next_multiple_of(2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slow_pictures_become_smaller_and_fast_ones_large_again() {
        let mut pace = Pace::default();
        let full = [1280, 720];
        assert_eq!(pace.moving(full), full, "nothing is known yet");
        pace.note(full, 0.3);
        let small = pace.moving(full);
        assert!(small[0] <= 1280 / 2, "{small:?}");
        for _ in 0..20 {
            pace.note(full, 0.01);
        }
        assert_eq!(pace.moving(full), full);
        for _ in 0..20 {
            pace.note(full, 100.0);
        }
        let least = pace.moving(full);
        assert!(least[0] >= 200 && least[1] >= 100, "{least:?}");
    }

    #[test]
    fn a_picture_on_the_edge_keeps_its_size() {
        let mut pace = Pace::default();
        pace.note([1000, 1000], BUDGET * 1.05);
        assert_eq!(pace.moving([1000, 1000]), [500, 500]);
        for _ in 0..9 {
            pace.note([500, 500], BUDGET * 0.95 / 4.0);
        }
        assert_eq!(pace.moving([1000, 1000]), [500, 500]);
    }
}
