//! The solid inside a closed mesh, as columns: how much of a sphere lies outside it.
//!
//! A grid of parallel lines runs through the mesh along its longest axis. Along each line the crossings
//! with the surface are exact; where the winding number is not zero the line is inside. The volume of a
//! sphere outside the solid is then an integral over the sphere's disc of how much of each chord is
//! outside, taken at points spread evenly by the golden angle, each on its nearest line.

use glam::DVec3;
use std::collections::HashMap;

/// Lines across the longer of the two cross axes.
const LINES: usize = 128;

/// Columns of inside and outside.
pub(crate) struct Solid {
    /// The axis the lines run along, and the two others.
    axes: [usize; 3],
    /// Where the grid begins on the cross axes, how far its lines are apart, and how many there are.
    origin: [f64; 2],
    spacing: f64,
    counts: [usize; 2],
    /// Of line (i, j), `intervals[starts[n]..starts[n + 1]]` with n = i + j · counts[0] are inside.
    starts: Vec<u32>,
    intervals: Vec<[f64; 2]>,
}

impl Solid {
    /// The solid inside the mesh; one that is empty where the mesh is open.
    pub(crate) fn new(points: &[DVec3], triangles: &[[u32; 3]]) -> Self {
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for &i in triangles.iter().flatten() {
            low = low.min(points[i as usize]);
            high = high.max(points[i as usize]);
        }
        let extent = high - low;
        let along = extent.max_position();
        let axes = [along, (along + 1) % 3, (along + 2) % 3];
        let widest = extent[axes[1]].max(extent[axes[2]]);
        let empty = Self {
            axes,
            origin: [0.0; 2],
            spacing: 1.0,
            counts: [0; 2],
            starts: vec![0],
            intervals: Vec::new(),
        };
        if !is_closed(points, triangles) || widest <= 0.0 {
            return empty;
        }
        let spacing = widest / LINES as f64;
        let counts = [1, 2].map(|k| ((extent[axes[k]] / spacing).ceil() as usize).max(1));
        let origin = [1, 2].map(|k| low[axes[k]]);
        let mut solid = Self {
            origin,
            spacing,
            counts,
            ..empty
        };
        solid.fill(points, triangles);
        solid
    }

    /// Finds where the lines cross the surface, and keeps what is between.
    fn fill(&mut self, points: &[DVec3], triangles: &[[u32; 3]]) {
        let mut crossings: Vec<Vec<(f64, i32)>> = vec![Vec::new(); self.counts[0] * self.counts[1]];
        let flat = |p: DVec3| [p[self.axes[1]], p[self.axes[2]]];
        for t in triangles {
            let [a, b, c] = t.map(|i| points[i as usize]);
            let [pa, pb, pc] = [a, b, c].map(flat);
            let double_area = cross(pa, pb, pc);
            if double_area == 0.0 {
                continue;
            }
            let range = |k: usize| {
                let low = pa[k].min(pb[k]).min(pc[k]);
                let high = pa[k].max(pb[k]).max(pc[k]);
                let line = |x: f64| (x - self.origin[k]) / self.spacing;
                let first = (line(low).floor() - 1.0).max(0.0) as usize;
                let last = (line(high).ceil() + 1.0).max(0.0) as usize;
                first..last.min(self.counts[k])
            };
            for j in range(1) {
                for i in range(0) {
                    let q = self.line(i, j);
                    let weights = [cross(pb, pc, q), cross(pc, pa, q), cross(pa, pb, q)];
                    let inside =
                        weights.iter().all(|w| *w > 0.0) || weights.iter().all(|w| *w < 0.0);
                    if inside {
                        let along = |p: DVec3| p[self.axes[0]];
                        let at =
                            (weights[0] * along(a) + weights[1] * along(b) + weights[2] * along(c))
                                / (weights[0] + weights[1] + weights[2]);
                        let turn = if double_area > 0.0 { -1 } else { 1 };
                        crossings[i + j * self.counts[0]].push((at, turn));
                    }
                }
            }
        }
        for mut line in crossings {
            line.sort_by(|a, b| a.0.total_cmp(&b.0));
            let (mut winding, mut entry) = (0, 0.0);
            let before = self.intervals.len();
            for (at, turn) in line {
                if winding == 0 {
                    entry = at;
                }
                winding += turn;
                if winding == 0 && at > entry {
                    self.intervals.push([entry, at]);
                }
            }
            if winding != 0 {
                // The line grazes an edge or a corner: better outside than wrong.
                self.intervals.truncate(before);
            }
            self.starts.push(self.intervals.len() as u32);
        }
    }

    /// Where line (i, j) stands on the cross axes. The shift is irrational, so that lines do not meet
    /// corners and edges that lie on a grid of their own.
    fn line(&self, i: usize, j: usize) -> [f64; 2] {
        const SHIFT: [f64; 2] = [0.488_613_9, 0.512_720_7];
        [
            self.origin[0] + (i as f64 + SHIFT[0]) * self.spacing,
            self.origin[1] + (j as f64 + SHIFT[1]) * self.spacing,
        ]
    }

    /// The solid's volume; 0 for an open mesh.
    pub(crate) fn volume(&self) -> f64 {
        let length: f64 = self.intervals.iter().map(|[from, to]| to - from).sum();
        length * self.spacing * self.spacing
    }

    /// How much of a sphere lies outside the solid, by the chords over the points of `disc`.
    pub(crate) fn outside(&self, center: DVec3, radius: f64, disc: &Disc) -> f64 {
        let mut length = 0.0;
        let [along, across, up] = self.axes.map(|axis| center[axis]);
        for &[x, y, half] in &disc.0 {
            let half = half * radius;
            let (from, to) = (along - half, along + half);
            length += to - from;
            let i = (across + x * radius - self.origin[0]) / self.spacing;
            let j = (up + y * radius - self.origin[1]) / self.spacing;
            if i >= 0.0 && j >= 0.0 && i < self.counts[0] as f64 && j < self.counts[1] as f64 {
                let line = i as usize + j as usize * self.counts[0];
                let inside = self.starts[line] as usize..self.starts[line + 1] as usize;
                for &[enter, leave] in &self.intervals[inside] {
                    length -= (to.min(leave) - from.max(enter)).max(0.0);
                }
            }
        }
        length * std::f64::consts::PI * radius * radius / disc.0.len() as f64
    }
}

/// Points of the unit disc, spread evenly, each with the half chord of the unit sphere above it.
pub(crate) struct Disc(Vec<[f64; 3]>);

impl Disc {
    /// `count` points on Vogel's spiral, scaled so that they integrate the sphere's volume exactly.
    pub(crate) fn new(count: usize) -> Self {
        let golden = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
        let mut points: Vec<[f64; 3]> = (0..count)
            .map(|k| {
                let area = (k as f64 + 0.5) / count as f64;
                let (sin, cos) = (k as f64 * golden).sin_cos();
                [area.sqrt() * cos, area.sqrt() * sin, (1.0 - area).sqrt()]
            })
            .collect();
        let mean = points.iter().map(|p| p[2]).sum::<f64>() / count as f64;
        for p in &mut points {
            p[2] *= 2.0 / 3.0 / mean;
        }
        Self(points)
    }
}

/// Twice the signed area of a triangle in the plane.
fn cross(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Whether every edge is passed as often one way as the other: then the surface has no border and winding
/// numbers are whole. Vertices within a millionth of the mesh's size of each other count as one.
pub(crate) fn is_closed(points: &[DVec3], triangles: &[[u32; 3]]) -> bool {
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

    /// The unit cube, 0 to 1, outward.
    fn cube() -> (Vec<DVec3>, Vec<[u32; 3]>) {
        let points = (0..8)
            .map(|i| {
                DVec3::new(
                    f64::from(i & 1),
                    f64::from(i >> 1 & 1),
                    f64::from(i >> 2 & 1),
                )
            })
            .collect();
        let quads = [
            [0, 4, 6, 2],
            [1, 3, 7, 5],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 2, 3, 1],
            [4, 5, 7, 6],
        ];
        let triangles = quads
            .iter()
            .flat_map(|q| [[q[0], q[1], q[2]], [q[0], q[2], q[3]]])
            .collect();
        (points, triangles)
    }

    #[test]
    fn a_cube_has_its_volume_and_spheres_their_part_outside() {
        let (points, triangles) = cube();
        let solid = Solid::new(&points, &triangles);
        assert!((solid.volume() - 1.0).abs() < 1e-9, "{}", solid.volume());
        let disc = Disc::new(4096);
        let ball = 4.0 / 3.0 * std::f64::consts::PI;
        let inside = solid.outside(DVec3::splat(0.5), 0.4, &disc);
        assert!(inside.abs() < 1e-9, "{inside}");
        let around = solid.outside(DVec3::splat(0.5), 2.0, &disc);
        assert!((around - (8.0 * ball - 1.0)).abs() < 0.02, "{around}");
        // Half of a ball whose centre lies in a face, seven eighths of one in a corner.
        let face = solid.outside(DVec3::new(1.0, 0.5, 0.5), 0.3, &disc);
        assert!((face / (ball * 0.027) - 0.5).abs() < 0.01, "{face}");
        let corner = solid.outside(DVec3::ONE, 0.3, &disc);
        assert!((corner / (ball * 0.027) - 0.875).abs() < 0.01, "{corner}");
        let away = solid.outside(DVec3::splat(9.0), 0.5, &disc);
        assert!((away / (ball * 0.125) - 1.0).abs() < 1e-9, "{away}");
    }

    #[test]
    fn without_a_face_the_cube_is_open_and_encloses_nothing() {
        let (points, mut triangles) = cube();
        assert!(is_closed(&points, &triangles));
        triangles.pop();
        assert!(!is_closed(&points, &triangles));
        assert_eq!(Solid::new(&points, &triangles).volume(), 0.0);
    }

    #[test]
    fn vertices_at_one_place_are_one() {
        let (points, triangles) = cube();
        let split: Vec<DVec3> = triangles
            .iter()
            .flatten()
            .map(|&i| points[i as usize])
            .collect();
        let soup: Vec<[u32; 3]> = (0..12).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
        assert!(is_closed(&split, &soup));
    }
}
