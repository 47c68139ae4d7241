//! The directions in which spheres are seen, and the cells around them.

use super::{DIRECTIONS, MOST_COEFFICIENTS};
use glam::{DVec3, Vec3};
use sh_core::Sh6d;
use std::sync::LazyLock;

/// The directions, unit vectors in a fixed order: the icosahedron's 12 corners, two on each of its 30 edges, one in
/// the middle of each of its 20 faces. Neighbours are 20.1° to 23.8° apart.
///
/// ```
/// use sh_scene::surface::{DIRECTIONS, directions};
/// let opposite = |d: &[f32; 3]| directions().iter().any(|e| (0..3).all(|k| (d[k] + e[k]).abs() < 1e-6));
/// assert_eq!(directions().iter().filter(|d| opposite(d)).count(), DIRECTIONS);
/// ```
pub fn directions() -> &'static [[f32; 3]; DIRECTIONS] {
    static ALL: LazyLock<[[f32; 3]; DIRECTIONS]> =
        LazyLock::new(|| geodesic().map(|d| d.as_vec3().to_array()));
    &ALL
}

/// The direction in whose Voronoi cell a vector of any length but 0 lies: the nearest, of several the first.
///
/// ```
/// use sh_scene::surface::{cell_of, directions};
/// assert_eq!(cell_of(directions()[50].map(|c| 7.0 * c).into()), 50);
/// ```
pub fn cell_of(direction: Vec3) -> usize {
    let mut nearest = (0, f32::NEG_INFINITY);
    for (j, d) in directions().iter().enumerate() {
        let cosine = direction.dot(Vec3::from(*d));
        if cosine > nearest.1 {
            nearest = (j, cosine);
        }
    }
    nearest.0
}

/// All directions from the nearest to each of them on, which is itself.
pub(super) fn neighbors() -> &'static [[u8; DIRECTIONS]; DIRECTIONS] {
    static ALL: LazyLock<[[u8; DIRECTIONS]; DIRECTIONS]> = LazyLock::new(|| {
        let all = directions().map(Vec3::from);
        all.map(|d| {
            let mut order: [u8; DIRECTIONS] = std::array::from_fn(|k| k as u8);
            // Coarse, so that those that are equally far stay in order whatever the rounding.
            let away = |k: u8| ((1.0 - d.dot(all[usize::from(k)])) * 1e4).round() as u32;
            order.sort_by_key(|&k| away(k));
            order
        })
    });
    &ALL
}

/// Unit vectors that each stand for the same solid angle, 4π over their number, `2 * bands * columns`: the sphere is cut
/// into `bands` of equal height, and in each lie two circles at the points of Gauss's rule, so that sums over all of
/// them are integrals to the fourth order of a band's height. Each circle is turned against the one before by the golden
/// section, so that no two line up.
///
/// ```
/// use sh_scene::surface::stratified;
/// let all: Vec<_> = stratified(8, 16).collect();
/// let mean = all.iter().map(|d| f64::from(d.z * d.z)).sum::<f64>() / all.len() as f64;
/// assert!(all.len() == 256 && (mean - 1.0 / 3.0).abs() < 1e-6);
/// ```
pub fn stratified(bands: usize, columns: usize) -> impl Iterator<Item = Vec3> {
    /// The fractional part of the golden section.
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let half = 1.0 / bands as f64;
    (0..2 * bands).flat_map(move |row| {
        let side = if row % 2 == 0 { 1.0 } else { -1.0 };
        let middle = 1.0 - ((row / 2 * 2 + 1) as f64) * half;
        let z = middle + side * half / 3.0_f64.sqrt();
        let around = (1.0 - z * z).sqrt();
        let turn = (row as f64 * GOLDEN).fract();
        (0..columns).map(move |column| {
            let part = (column as f64 + turn) / columns as f64;
            let (sin, cos) = (std::f64::consts::TAU * part).sin_cos();
            DVec3::new(around * cos, around * sin, z).as_vec3()
        })
    })
}

/// The integral of every y_lm up to order 6 over each direction's Voronoi cell, to 1e-7 (eq. 10, where random directions
/// sum it up). A lower order's come first. Takes a millisecond the first time.
///
/// A cell is a polygon of great arcs. It is cut into triangles (d, v, w) from its direction to its edges, and ω = p/|p|
/// takes each from its plane to the sphere, where dω = d · (v × w) u du dt / |p|³ for p = d + u (v − d) + u t (w − v).
///
/// ```
/// use sh_scene::surface::cell_sums;
/// // A white furnace: the same light in all cells is a constant.
/// let constant: f32 = cell_sums().iter().map(|cell| cell[0]).sum();
/// assert!((constant - (4.0 * std::f32::consts::PI).sqrt()).abs() < 1e-5);
/// ```
pub fn cell_sums() -> &'static [[f32; MOST_COEFFICIENTS]; DIRECTIONS] {
    static ALL: LazyLock<[[f32; MOST_COEFFICIENTS]; DIRECTIONS]> = LazyLock::new(|| {
        let all = geodesic();
        std::array::from_fn(|j| {
            let corners = corners(&all, j);
            let next = corners.iter().cycle().skip(1);
            let mut sums = Sh6d::default();
            for (v, w) in corners.iter().zip(next) {
                sums += over_triangle(all[j], *v, *w);
            }
            sums.0.map(|sum| sum as f32)
        })
    });
    &ALL
}

/// The corners of a direction's Voronoi cell, counter-clockwise seen from outside: each as far from the direction as from
/// two neighbours.
fn corners(all: &[DVec3; DIRECTIONS], j: usize) -> Vec<DVec3> {
    let d = all[j];
    let (x, y) = d.any_orthonormal_pair();
    // 20° to 24° away; all others are more than 37° away.
    let near = |n: &&DVec3| **n != d && n.dot(d) > 30.0_f64.to_radians().cos();
    let mut near: Vec<DVec3> = all.iter().filter(near).copied().collect();
    let around = |n: &DVec3| n.dot(y).atan2(n.dot(x));
    near.sort_by(|a, b| around(a).total_cmp(&around(b)));
    let next = near.iter().cycle().skip(1);
    let corner = |(n, m): (&DVec3, &DVec3)| (*n - d).cross(*m - d).normalize();
    near.iter().zip(next).map(corner).collect()
}

/// The integral of every y_lm over the part of the sphere that a triangle covers, seen from the centre.
fn over_triangle(d: DVec3, v: DVec3, w: DVec3) -> Sh6d {
    /// Gauss–Legendre nodes and weights, 5 points on −1..1: exact to degree 9.
    const GAUSS: [(f64, f64); 5] = [
        (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
        (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
        (0.0, 0.568_888_888_888_888_9),
        (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
        (0.906_179_845_938_664, 0.236_926_885_056_189_1),
    ];
    let unit = GAUSS.map(|(node, weight)| (0.5 + 0.5 * node, 0.5 * weight));
    let volume = d.dot(v.cross(w));
    let mut sum = Sh6d::default();
    for (u, across) in unit {
        for (t, along) in unit {
            let p = d + (v - d) * u + (w - v) * (u * t);
            let length = p.length();
            let share = volume * u / length.powi(3) * across * along;
            sum += Sh6d::basis(p / length) * share;
        }
    }
    sum
}

/// The vertices of the icosahedron's geodesic sphere of frequency 3: each of its faces is cut into nine, and what that
/// gives is moved to the sphere.
fn geodesic() -> [DVec3; DIRECTIONS] {
    let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let mut corners = Vec::with_capacity(12);
    for a in [1.0, -1.0] {
        for b in [golden, -golden] {
            corners.extend([
                DVec3::new(0.0, a, b),
                DVec3::new(a, b, 0.0),
                DVec3::new(b, 0.0, a),
            ]);
        }
    }
    // Corners on an edge are 2 apart, all others more than 3.
    let joined = |i: usize, j: usize| corners[i].distance_squared(corners[j]) < 5.0;
    let mut all: Vec<DVec3> = corners.iter().map(|c| c.normalize()).collect();
    for i in 0..12 {
        for j in (i + 1..12).filter(|&j| joined(i, j)) {
            let (a, b) = (corners[i], corners[j]);
            all.extend([(a * 2.0 + b).normalize(), (a + b * 2.0).normalize()]);
        }
    }
    for i in 0..12 {
        for j in (i + 1..12).filter(|&j| joined(i, j)) {
            for k in (j + 1..12).filter(|&k| joined(i, k) && joined(j, k)) {
                all.push((corners[i] + corners[j] + corners[k]).normalize());
            }
        }
    }
    std::array::from_fn(|j| all[j])
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn the_directions_are_unit_vectors_of_an_even_net() {
        assert_eq!(geodesic().len(), DIRECTIONS);
        for (j, d) in directions().iter().enumerate() {
            let d = Vec3::from(*d);
            assert!((d.length() - 1.0).abs() < 1e-6);
            let others = directions().iter().enumerate().filter(|(k, _)| *k != j);
            let mut angles: Vec<f32> = others
                .map(|(_, e)| d.angle_between(Vec3::from(*e)).to_degrees())
                .collect();
            angles.sort_by(f32::total_cmp);
            // Five neighbours at a corner of the icosahedron, six elsewhere.
            let neighbours = if j < 12 { 5 } else { 6 };
            assert!(
                angles[0] > 20.0 && angles[neighbours - 1] < 23.9,
                "{j}: {angles:?}"
            );
            assert!(angles[neighbours] > 37.0, "{j}: {angles:?}");
        }
    }

    #[test]
    fn every_direction_is_in_its_own_cell() {
        for (j, d) in directions().iter().enumerate() {
            assert_eq!(cell_of(Vec3::from(*d)), j);
        }
    }

    #[test]
    fn all_cells_together_are_the_sphere() {
        for i in 0..MOST_COEFFICIENTS {
            let sum: f64 = cell_sums().iter().map(|cell| f64::from(cell[i])).sum();
            let expected = if i == 0 { (4.0 * PI).sqrt() } else { 0.0 };
            assert!((sum - expected).abs() < 2e-6, "coefficient {i}: {sum}");
        }
    }

    #[test]
    fn cells_are_as_even_as_the_geodesic_sphere_makes_them() {
        let area = |cell: &[f32; MOST_COEFFICIENTS]| f64::from(cell[0]) * (4.0 * PI).sqrt();
        let mean = 4.0 * PI / DIRECTIONS as f64;
        let kinds = [(0..12, "corners"), (12..72, "edges"), (72..92, "faces")];
        for (range, kind) in kinds {
            let areas: Vec<f64> = cell_sums()[range].iter().map(area).collect();
            let (low, high) = areas.iter().fold((f64::MAX, 0.0_f64), |(low, high), a| {
                (low.min(*a), high.max(*a))
            });
            // Cells of a kind are alike by symmetry.
            assert!(high - low < 1e-6 * mean, "{kind}: {low} to {high}");
            assert!(
                low > 0.7 * mean && high < 1.2 * mean,
                "{kind}: {low} to {high}"
            );
        }
    }

    #[test]
    fn cells_hold_what_is_nearest_to_their_directions() {
        let mut counts = [[0.0; MOST_COEFFICIENTS]; DIRECTIONS];
        let all = 2 * 200 * 800;
        for d in stratified(200, 800) {
            let y = Sh6d::basis(d.as_dvec3());
            for (count, y) in counts[cell_of(d)].iter_mut().zip(y.0) {
                *count += y * 4.0 * PI / f64::from(all);
            }
        }
        for (found, sums) in counts.iter().zip(cell_sums()) {
            for (found, sum) in found.iter().zip(sums) {
                assert!((found - f64::from(*sum)).abs() < 0.003, "{found} {sum}");
            }
        }
    }

    #[test]
    fn a_cell_shines_into_its_own_direction() {
        for (cell, d) in cell_sums().iter().zip(directions()) {
            let shining = sh_core::Sh(*cell);
            let ahead = shining.evaluate(*d);
            let behind = shining.evaluate(d.map(|c| -c));
            assert!(
                ahead > 0.25 && behind.abs() < 0.2 * ahead,
                "{ahead} {behind}"
            );
        }
    }

    #[test]
    fn stratified_vectors_are_unit_vectors() {
        assert!(stratified(3, 5).all(|d| (d.length() - 1.0).abs() < 1e-6));
        assert_eq!(stratified(3, 5).count(), 30);
    }
}
