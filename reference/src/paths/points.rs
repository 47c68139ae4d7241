//! The numbers that paths are made of: Sobol's points with Owen's scrambling, in pairs.
//!
//! Every pair of a path has a scrambling and an order of its own (padding, as in Burley, "Practical Hash-based Owen
//! Scrambling", 2020), so that each is spread evenly over the paths whatever the number of pairs. Nothing is drawn one
//! after the other from a generator: a pair follows from the seed, the path's number and its own, whatever thread asks.

/// Points of one sequence that the crate has.
const SEQUENCE: u32 = 1 << 16;

/// The pairs of one path, one after the other.
pub(super) struct Points {
    index: u32,
    seed: u32,
    pair: u32,
}

impl Points {
    /// Those of path number `index` among all of one seed.
    pub fn new(index: u32, seed: u32) -> Self {
        Self {
            index: index % SEQUENCE,
            // What lies beyond the end of the sequence goes on in another.
            seed: mix(seed ^ mix(index / SEQUENCE)),
            pair: 0,
        }
    }

    /// The next pair, each in 0..1 with 24 bits.
    pub fn pair(&mut self) -> [f64; 2] {
        self.pair += 1;
        let seed = self.seed ^ mix(self.pair);
        [0, 1].map(|dimension| f64::from(sobol_burley::sample(self.index, dimension, seed)))
    }
}

/// The finaliser of MurmurHash3 behind a constant, so that 0 is no fixed point.
pub(super) fn mix(x: u32) -> u32 {
    let mut x = x ^ 0x9e37_79b9;
    x = (x ^ (x >> 16)).wrapping_mul(0x85eb_ca6b);
    x = (x ^ (x >> 13)).wrapping_mul(0xc2b2_ae35);
    x ^ (x >> 16)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of 256 points of each pair, one falls into each of 16 by 16 squares.
    #[test]
    fn every_pair_is_spread_evenly() {
        for number in 0..40 {
            let mut seen = [false; 256];
            for index in 0..256 {
                let mut points = Points::new(index, 7);
                for _ in 0..number {
                    points.pair();
                }
                let [x, y] = points.pair().map(|c| (16.0 * c) as usize);
                seen[16 * y + x] = true;
            }
            assert!(seen.iter().all(|s| *s), "pair {number}");
        }
    }

    #[test]
    fn pairs_and_seeds_are_independent() {
        let column = |seed: u32, pair: usize| -> Vec<f64> {
            let first = |index| {
                let mut points = Points::new(index, seed);
                for _ in 0..pair {
                    points.pair();
                }
                points.pair()[0] - 0.5
            };
            (0..4096).map(first).collect()
        };
        let correlation = |a: &[f64], b: &[f64]| {
            12.0 * a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>() / a.len() as f64
        };
        let first = column(1, 0);
        assert!((correlation(&first, &first) - 1.0).abs() < 1e-2);
        for other in [column(1, 1), column(1, 2), column(2, 0), column(3, 5)] {
            let found = correlation(&first, &other);
            // Three times what independent numbers have.
            assert!(found.abs() < 3.0 / 64.0, "{found}");
        }
    }

    #[test]
    fn long_sequences_do_not_repeat() {
        let at = |index| Points::new(index, 3).pair();
        assert_eq!(at(5), at(5));
        assert_ne!(at(5), at(5 + SEQUENCE));
    }
}
