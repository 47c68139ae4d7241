//! Whether a mesh has a border.

use glam::DVec3;
use std::collections::HashMap;

/// Whether every edge is passed as often one way as the other: then the surface has no border and winding
/// numbers are whole. Vertices within a millionth of the mesh's size of each other count as one.
pub(super) fn is_closed(points: &[DVec3], triangles: &[[u32; 3]]) -> bool {
    let used = || triangles.iter().flatten().map(|&i| points[i as usize]);
    let low = used().fold(DVec3::INFINITY, DVec3::min);
    let high = used().fold(DVec3::NEG_INFINITY, DVec3::max);
    let near = 1e-6 * (high - low).max_element();
    let place = welded(points, near.max(f64::MIN_POSITIVE));
    let mut balance: HashMap<[u32; 2], i32> = HashMap::new();
    for t in triangles {
        for k in 0..3 {
            let (a, b) = (place[t[k] as usize], place[t[(k + 1) % 3] as usize]);
            if a != b {
                *balance.entry([a.min(b), a.max(b)]).or_default() += if a < b { 1 } else { -1 };
            }
        }
    }
    !triangles.is_empty() && balance.values().all(|b| *b == 0)
}

/// For each point a number that it shares with an earlier point at most `near` away, if there is one.
fn welded(points: &[DVec3], near: f64) -> Vec<u32> {
    let mut cells: HashMap<[i64; 3], Vec<u32>> = HashMap::new();
    let cell = |p: DVec3| (p / (2.0 * near)).to_array().map(|c| c.floor() as i64);
    let mut place = Vec::with_capacity(points.len());
    for (i, &p) in points.iter().enumerate() {
        // A cell is twice as wide as points may be apart: the 8 cells around it hold all that are near.
        let corners = (0..8).map(|k| {
            let side = |bit: u32| if k >> bit & 1 == 1 { near } else { -near };
            cell(p + DVec3::new(side(0), side(1), side(2)))
        });
        let mut around = corners.filter_map(|c| cells.get(&c)).flatten().copied();
        let earlier = around.find(|&j| points[j as usize].distance(p) <= near);
        if earlier.is_none() {
            cells.entry(cell(p)).or_default().push(i as u32);
        }
        place.push(earlier.unwrap_or(i as u32));
    }
    place
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes;

    #[test]
    fn only_what_has_no_border_is_closed() {
        let mesh = shapes::rounded_box(glam::Vec3::ONE, 0.1);
        let points: Vec<DVec3> = mesh
            .positions
            .iter()
            .map(|p| DVec3::from(p.map(f64::from)))
            .collect();
        assert!(is_closed(&points, &mesh.triangles));
        assert!(!is_closed(&points, &mesh.triangles[1..]));
        assert!(!is_closed(&points, &[]));
    }

    #[test]
    fn vertices_at_one_place_are_one() {
        let mesh = shapes::ball(1.0, 1);
        let point = |i: &u32| DVec3::from(mesh.positions[*i as usize].map(f64::from));
        let split: Vec<DVec3> = mesh.triangles.iter().flatten().map(point).collect();
        let soup: Vec<[u32; 3]> = (0..mesh.triangles.len() as u32)
            .map(|t| [3 * t, 3 * t + 1, 3 * t + 2])
            .collect();
        assert!(is_closed(&split, &soup));
    }
}
