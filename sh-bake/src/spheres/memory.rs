//! What a search has placed lately, so that nothing is placed twice.
//!
//! Most moves are taken back, and the next one nearby may find the same balls with the same pieces of their own: about
//! one time in six, in the built-in scene.

use super::place::Priced;
use glam::DVec3;

/// How many placements are kept of a ball.
const KEPT: usize = 16;

/// The last placements of each ball.
pub(super) struct Memory(Vec<Vec<Placed>>);

struct Placed {
    pieces: Vec<u32>,
    old: DVec3,
    thorough: bool,
    found: Priced,
}

impl Memory {
    pub(super) fn new(balls: usize) -> Self {
        Self((0..balls).map(|_| Vec::with_capacity(KEPT)).collect())
    }

    /// What ball `i` became about these pieces, or else what `place` makes of it now.
    pub(super) fn placed(
        &mut self,
        i: usize,
        pieces: Vec<u32>,
        old: DVec3,
        thorough: bool,
        place: impl FnOnce(&[u32]) -> Priced,
    ) -> Priced {
        let kept = &mut self.0[i];
        let same = |p: &Placed| p.old == old && p.thorough == thorough && p.pieces == pieces;
        if let Some(at) = kept.iter().position(same) {
            // What is asked for again stays longest.
            kept[at..].rotate_left(1);
            return kept[kept.len() - 1].found;
        }
        if kept.len() == KEPT {
            kept.remove(0);
        }
        let found = place(&pieces);
        kept.push(Placed {
            pieces,
            old,
            thorough,
            found,
        });
        found
    }
}

#[cfg(test)]
mod tests {
    use super::super::proof::Ball;
    use super::*;

    #[test]
    fn only_what_is_the_same_in_all_is_not_placed_again() {
        let mut memory = Memory::new(2);
        let mut ask = |i: usize, pieces: &[u32], x: f64, thorough: bool| {
            let mut asked = false;
            let place = |pieces: &[u32]| {
                asked = true;
                let center = DVec3::splat(x);
                let radius = pieces.len() as f64;
                Priced {
                    ball: Ball { center, radius },
                    outside: 1.0,
                }
            };
            let found = memory.placed(i, pieces.to_vec(), DVec3::splat(x), thorough, place);
            assert_eq!(found.ball.radius, pieces.len() as f64);
            asked
        };
        assert!(ask(0, &[1, 2], 0.0, true));
        assert!(ask(1, &[1, 2], 0.0, true));
        assert!(ask(0, &[1, 3], 0.0, true));
        assert!(ask(0, &[1, 2], 1.0, true));
        assert!(ask(0, &[1, 2], 0.0, false));
        assert!(!ask(0, &[1, 2], 0.0, true));
        // What was asked for last outlives what was not.
        for k in 0..KEPT as u32 - 1 {
            assert!(ask(0, &[9, k], 0.0, true));
        }
        assert!(!ask(0, &[1, 2], 0.0, true));
        assert!(ask(0, &[1, 3], 0.0, true));
    }
}
