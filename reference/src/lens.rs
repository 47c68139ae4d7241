//! The part that two discs in the plane have in common.

/// Which part of the smaller of two discs the larger covers, by the inverse cosines of the lens between them. `ratio` is
/// the smaller radius over the larger, in 0..=1; `depth` how far the smaller has entered the larger, over its own
/// diameter: 0 where they touch, 1 where it is within.
///
/// ```
/// use sh_reference::lens::covered;
/// assert_eq!((covered(0.5, 0.0), covered(0.5, 1.0)), (0.0, 1.0));
/// // A straight edge through the middle.
/// assert!((covered(1e-3, 0.5) - 0.5).abs() < 1e-3);
/// ```
pub fn covered(ratio: f64, depth: f64) -> f64 {
    let (small, large) = (ratio, 1.0);
    let d = large + small - 2.0 * small * depth;
    if depth <= 0.0 {
        return 0.0;
    }
    if depth >= 1.0 {
        return 1.0;
    }
    let sector = |own: f64, other: f64| {
        let cosine = (d * d + own * own - other * other) / (2.0 * d * own);
        own * own * cosine.clamp(-1.0, 1.0).acos()
    };
    let kite =
        (small + large - d) * (d + small - large) * (d - small + large) * (d + small + large);
    let lens = sector(small, large) + sector(large, small) - 0.5 * kite.max(0.0).sqrt();
    lens / (std::f64::consts::PI * small * small)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lens_is_what_points_say() {
        for (ratio, depth) in [(1.0, 0.5), (0.3, 0.2), (0.7, 0.9), (0.05, 0.4)] {
            let d = 1.0 + ratio - 2.0 * ratio * depth;
            let side = 1000;
            let at = |i: usize| ratio * (2.0 * (i as f64 + 0.5) / side as f64 - 1.0);
            let (mut within, mut both) = (0, 0);
            for (x, y) in (0..side * side).map(|i| (at(i % side), at(i / side))) {
                if x * x + y * y < ratio * ratio {
                    within += 1;
                    both += usize::from((x - d).powi(2) + y * y < 1.0);
                }
            }
            let counted = both as f64 / within as f64;
            assert!(
                (covered(ratio, depth) - counted).abs() < 1e-3,
                "{ratio} {depth}"
            );
        }
    }
}
