//! Clustering of points.

use glam::Vec3;

/// Rounds at most; what is clustered here settles in fewer, or moves little after that.
const ROUNDS: usize = 12;

/// Lloyd 1982: at most `count` groups, none empty, of the points named in `members`, by nearest centre. `members` lie
/// along a curve, so that the first centres, taken at even steps, are spread out.
pub(crate) fn lloyd<const D: usize>(
    points: &[[f32; D]],
    members: &[usize],
    count: usize,
) -> Vec<Vec<usize>> {
    let count = count.min(members.len());
    let mut centers: Vec<[f32; D]> = (0..count)
        .map(|k| points[members[(2 * k + 1) * members.len() / (2 * count)]])
        .collect();
    let mut owner = vec![usize::MAX; members.len()];
    for _ in 0..ROUNDS {
        let mut changed = false;
        for (owner, &i) in owner.iter_mut().zip(members) {
            let nearest = nearest(&centers, &points[i]);
            changed |= nearest != *owner;
            *owner = nearest;
        }
        if !changed {
            break;
        }
        let mut sums = vec![([0.0; D], 0.0); count];
        for (&owner, &i) in owner.iter().zip(members) {
            let (sum, n) = &mut sums[owner];
            for (sum, x) in sum.iter_mut().zip(points[i]) {
                *sum += x;
            }
            *n += 1.0;
        }
        for (center, (sum, n)) in centers.iter_mut().zip(sums) {
            if n > 0.0 {
                *center = sum.map(|x: f32| x / n);
            }
        }
    }
    let mut groups = vec![Vec::new(); count];
    for (&owner, &i) in owner.iter().zip(members) {
        groups[owner].push(i);
    }
    groups.retain(|group| !group.is_empty());
    groups
}

/// The first of the centres that are nearest.
fn nearest<const D: usize>(centers: &[[f32; D]], point: &[f32; D]) -> usize {
    let mut best = (f32::INFINITY, 0);
    for (k, center) in centers.iter().enumerate() {
        let mut square = 0.0;
        for (a, b) in center.iter().zip(point) {
            square += (a - b) * (a - b);
        }
        if square < best.0 {
            best = (square, k);
        }
    }
    best.1
}

/// Indices of the points along Morton's curve through their bounding box: neighbours on it are near each other.
pub(crate) fn curve(points: &[[f32; 3]]) -> Vec<usize> {
    let all = || points.iter().map(|p| Vec3::from(*p));
    let low = all().fold(Vec3::INFINITY, Vec3::min);
    let high = all().fold(Vec3::NEG_INFINITY, Vec3::max);
    let scale = 1023.0 / (high - low).max_element().max(f32::MIN_POSITIVE);
    let spread = |x: f32| {
        // A number that is not finite becomes 0.
        let x = x as u32 & 1023;
        (0..10).fold(0, |bits, k| bits | (x >> k & 1) << (3 * k))
    };
    let key = |p: [f32; 3]| {
        let cell = (Vec3::from(p) - low) * scale;
        spread(cell.x) | spread(cell.y) << 1 | spread(cell.z) << 2
    };
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by_cached_key(|&i| key(points[i]));
    order
}
