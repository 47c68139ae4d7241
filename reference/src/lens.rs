//! The part that two discs have in common, in the plane and on the sphere.

use std::f64::consts::{PI, TAU};

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

/// Which part of a disc on the sphere of angular radius `a` another of radius `b` covers whose middle is `d` away, by solid
/// angle; radii in 0..=π/2, distances in 0..=π. Where the edges cross, both discs are cut into sectors at the crossings, and
/// the area follows from the angles of the triangle of both middles and a crossing (Tovchigrechko and Vakser 2001, "How common
/// is the funnel-like energy landscape in protein-protein interactions?"). Differences of angles of about 1 are left for small
/// discs: it errs by about 1e-16 over the fourth power of the smaller radius.
///
/// ```
/// use sh_reference::lens::covered_on_sphere;
/// use std::f64::consts::FRAC_PI_2;
/// assert_eq!(covered_on_sphere(0.2, 0.3, 0.6), 0.0);
/// // A half space covers half of a disc around a point of its edge, and a quarter turn of another half space half.
/// assert!((covered_on_sphere(0.3, FRAC_PI_2, FRAC_PI_2) - 0.5).abs() < 1e-12);
/// assert!((covered_on_sphere(FRAC_PI_2, FRAC_PI_2, FRAC_PI_2) - 0.5).abs() < 1e-12);
/// ```
pub fn covered_on_sphere(a: f64, b: f64, d: f64) -> f64 {
    // 1 − cos without cancellation, times 2π.
    let area = |angle: f64| 2.0 * TAU * (0.5 * angle).sin().powi(2);
    if a <= 0.0 || d >= a + b {
        return 0.0;
    }
    if d <= b - a {
        return 1.0;
    }
    if d <= a - b {
        return area(b) / area(a);
    }
    // The angle of a triangle of these sides that is opposite to the first.
    let angle = |opposite: f64, p: f64, q: f64| {
        let cosine = (opposite.cos() - p.cos() * q.cos()) / (p.sin() * q.sin());
        cosine.clamp(-1.0, 1.0).acos()
    };
    let (at_a, at_b, at_crossing) = (angle(b, a, d), angle(a, b, d), angle(d, a, b));
    let common = 2.0 * (PI - at_crossing - at_a * a.cos() - at_b * b.cos());
    common / area(a)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampled::directions;
    use crate::vec3::angle;

    #[test]
    fn the_lens_on_the_sphere_is_what_directions_say() {
        for (a, b, d) in [
            (1.4, 1.4, 1.4),
            (0.7, 1.2, 0.9),
            (1.5, 0.3, 1.4),
            (0.3, 0.4, 0.2),
            (1.2, 0.5, 0.3),
        ] {
            let (middle, other) = ([0.0, 0.0, 1.0], [f64::sin(d), 0.0, f64::cos(d)]);
            let (mut within, mut both) = (0, 0);
            for s in directions(1_000_000).filter(|s| angle(*s, middle) < a) {
                within += 1;
                both += usize::from(angle(s, other) < b);
            }
            let counted = both as f64 / within as f64;
            let found = covered_on_sphere(a, b, d);
            assert!(
                (found - counted).abs() < 1e-3,
                "{a} {b} {d}: {found} {counted}"
            );
        }
    }

    #[test]
    fn small_discs_on_the_sphere_are_flat() {
        for (ratio, depth) in [(1.0, 0.5), (0.3, 0.2), (0.7, 0.9)] {
            let (large, small) = (0.02, 0.02 * ratio);
            let d = large + small - 2.0 * small * depth;
            let found = covered_on_sphere(small, large, d);
            assert!(
                (found - covered(ratio, depth)).abs() < 1e-4,
                "{ratio} {depth}: {found}"
            );
        }
    }

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
