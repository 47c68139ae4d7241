//! The solid inside a mesh, as columns: how much of a sphere lies outside it.
//!
//! A grid of parallel lines runs through the mesh along its longest axis. Along each line the crossings
//! with the surface are exact; where the winding number is not zero the line is inside. Of a mesh with holes that is
//! what is more than half enclosed ([`super::winding`]), which may end between two crossings. The volume of a
//! sphere outside the solid is then an integral over the sphere's disc of how much of each chord is
//! outside, taken at points spread evenly by the golden angle, each on its nearest line.

use super::closed::is_closed;
use super::winding::{INSIDE, Winding};
use glam::DVec3;
use rayon::prelude::*;

/// Lines across the longer of the two cross axes.
const LINES: usize = 128;
/// The same for an open mesh, and the number of places along a line of full length: each costs a winding number.
const OPEN_LINES: usize = 64;

/// Columns of inside and outside.
pub(crate) struct Solid {
    /// The axis the lines run along, and the two others.
    axes: [usize; 3],
    /// Where the grid begins on the cross axes, how far its lines are apart, and how many there are.
    origin: [f64; 2],
    spacing: [f64; 2],
    counts: [usize; 2],
    /// Of line (i, j), `intervals[starts[n]..starts[n + 1]]` with n = i + j · counts[0] are inside.
    starts: Vec<u32>,
    intervals: Vec<[f64; 2]>,
    /// The same for [`Solid::outside`], with lines all around that have nothing inside: counts[0] + 2 in a row.
    lines: Vec<Line>,
}

/// What of a line is inside: one interval, empty where there is none, and the place of more of them, which are rare.
#[derive(Clone, Copy)]
struct Line {
    first: [f64; 2],
    more: [u32; 2],
}

impl Line {
    const EMPTY: Self = Self {
        first: [f64::INFINITY, f64::NEG_INFINITY],
        more: [0; 2],
    };
}

impl Solid {
    /// The solid inside the mesh; one that is empty where it encloses nothing.
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
            spacing: [1.0; 2],
            counts: [0; 2],
            starts: vec![0],
            intervals: Vec::new(),
            lines: vec![Line::EMPTY; 4],
        };
        let closed = is_closed(points, triangles);
        if widest <= 0.0 {
            return empty;
        }
        let finest = widest / if closed { LINES } else { OPEN_LINES } as f64;
        let counts = [1, 2].map(|k| ((extent[axes[k]] / finest).ceil() as usize).max(1));
        // Each line stands for a cell about it; the cells tile the box without a rest.
        let spacing =
            [0, 1].map(|k| (extent[axes[k + 1]] / counts[k] as f64).max(f64::MIN_POSITIVE));
        let origin = [1, 2].map(|k| low[axes[k]]);
        let mut solid = Self {
            origin,
            spacing,
            counts,
            ..empty
        };
        let crossings = solid.crossings(points, triangles);
        if closed {
            solid.fill(crossings.into_iter().map(between));
        } else {
            let winding = Winding::new(points, triangles);
            let step = extent[along] / OPEN_LINES as f64;
            let enclosed = |(n, line): (usize, Vec<(f64, i32)>)| {
                let [across, up] = solid.line(n % counts[0], n / counts[0]);
                let number = |at: f64| winding.at(solid.point(at, across, up)).abs();
                enclosed(line, [low[along], high[along]], step, number)
            };
            let inside: Vec<Vec<[f64; 2]>> = crossings
                .into_par_iter()
                .enumerate()
                .map(enclosed)
                .collect();
            solid.fill(inside.into_iter());
        }
        solid
    }

    /// Keeps what of each line is inside.
    fn fill(&mut self, lines: impl Iterator<Item = Vec<[f64; 2]>>) {
        let [across, up] = self.counts;
        self.lines = vec![Line::EMPTY; (across + 2) * (up + 2)];
        for (n, line) in lines.enumerate() {
            let start = self.intervals.len() as u32;
            let end = start + line.len() as u32;
            if let Some(first) = line.first() {
                self.lines[n % across + 1 + (n / across + 1) * (across + 2)] = Line {
                    first: *first,
                    more: [start + 1, end],
                };
            }
            self.intervals.extend(line);
            self.starts.push(end);
        }
    }

    /// The point at a place along the lines and on the cross axes.
    fn point(&self, along: f64, across: f64, up: f64) -> DVec3 {
        let mut point = DVec3::ZERO;
        point[self.axes[0]] = along;
        point[self.axes[1]] = across;
        point[self.axes[2]] = up;
        point
    }

    /// Where each line crosses the surface, in order, and how the winding number changes there.
    fn crossings(&self, points: &[DVec3], triangles: &[[u32; 3]]) -> Vec<Vec<(f64, i32)>> {
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
                let line = |x: f64| (x - self.origin[k]) / self.spacing[k];
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
        for line in &mut crossings {
            line.sort_by(|a, b| a.0.total_cmp(&b.0));
        }
        crossings
    }

    /// Where line (i, j) stands on the cross axes. The shift is irrational, so that lines do not meet
    /// corners and edges that lie on a grid of their own.
    fn line(&self, i: usize, j: usize) -> [f64; 2] {
        const SHIFT: [f64; 2] = [0.488_613_9, 0.512_720_7];
        [
            self.origin[0] + (i as f64 + SHIFT[0]) * self.spacing[0],
            self.origin[1] + (j as f64 + SHIFT[1]) * self.spacing[1],
        ]
    }

    /// The solid's volume; 0 where the mesh encloses nothing.
    pub(crate) fn volume(&self) -> f64 {
        let length: f64 = self.intervals.iter().map(|[from, to]| to - from).sum();
        length * self.spacing[0] * self.spacing[1]
    }

    /// Points inside, on a grid: how far they are apart, and about `count` of them.
    pub(crate) fn grid(&self, count: usize) -> (f64, Vec<DVec3>) {
        let step = (self.volume() / count.max(1) as f64).cbrt();
        let mut points = Vec::new();
        if step <= 0.0 {
            return (0.0, points);
        }
        let stride = self
            .spacing
            .map(|spacing| (step / spacing).round().max(1.0) as usize);
        for j in (stride[1] / 2..self.counts[1]).step_by(stride[1]) {
            for i in (stride[0] / 2..self.counts[0]).step_by(stride[0]) {
                let line = i + j * self.counts[0];
                let [across, up] = self.line(i, j);
                for [enter, leave] in
                    &self.intervals[self.starts[line] as usize..self.starts[line + 1] as usize]
                {
                    let first = (enter / step).ceil() as i64;
                    for at in (first..)
                        .map(|k| k as f64 * step)
                        .take_while(|at| at < leave)
                    {
                        points.push(self.point(at, across, up));
                    }
                }
            }
        }
        (step, points)
    }

    /// How much of a sphere lies outside the solid, by the chords over the points of `disc`.
    pub(crate) fn outside(&self, center: DVec3, radius: f64, disc: &Disc) -> f64 {
        // The search spends a third of its time here: nothing branches but for the rare second interval.
        let mut length = 0.0;
        let [along, across, up] = self.axes.map(|axis| center[axis]);
        let width = self.counts[0] + 2;
        // Which line, from 1; 0 and one more than there are stand for what is beside them.
        let place = |at: f64, count: usize| {
            let cell = lesser(greater(at, 0.0), count as f64) as u32 + 1;
            (cell * u32::from(at >= 0.0)) as usize
        };
        let inside = |from: f64, to: f64, [enter, leave]: [f64; 2]| {
            let (first, last) = (greater(from, enter), lesser(to, leave));
            greater(last - first, 0.0)
        };
        for &[x, y, half] in &disc.0 {
            let half = half * radius;
            let (from, to) = (along - half, along + half);
            length += to - from;
            let i = (across + x * radius - self.origin[0]) / self.spacing[0];
            let j = (up + y * radius - self.origin[1]) / self.spacing[1];
            let line = &self.lines[place(i, self.counts[0]) + place(j, self.counts[1]) * width];
            length -= inside(from, to, line.first);
            if line.more[0] < line.more[1] {
                for &more in &self.intervals[line.more[0] as usize..line.more[1] as usize] {
                    length -= inside(from, to, more);
                }
            }
        }
        length * std::f64::consts::PI * radius * radius / disc.0.len() as f64
    }
}

/// The lesser of two numbers: one instruction, where [`f64::min`] has to look for what is no number.
fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// The greater of two numbers, as [`lesser`].
pub(super) fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// What of a line lies inside a closed mesh.
fn between(line: Vec<(f64, i32)>) -> Vec<[f64; 2]> {
    let (mut winding, mut entry) = (0, 0.0);
    let mut inside = Vec::new();
    for (at, turn) in line {
        if winding == 0 {
            entry = at;
        }
        winding += turn;
        if winding == 0 && at > entry {
            inside.push([entry, at]);
        }
    }
    if winding != 0 {
        // The line grazes an edge or a corner: better outside than wrong.
        inside.clear();
    }
    inside
}

/// What of a line is more than half enclosed by an open mesh. From one crossing to the next the winding number changes
/// smoothly: it is taken about every `step`, and between two places as on a straight line.
fn enclosed(
    line: Vec<(f64, i32)>,
    [low, high]: [f64; 2],
    step: f64,
    number: impl Fn(f64) -> f64,
) -> Vec<[f64; 2]> {
    let mut inside: Vec<[f64; 2]> = Vec::new();
    let mut add = |from: f64, to: f64| match inside.last_mut() {
        Some(last) if last[1] >= from => last[1] = to,
        _ if to > from => inside.push([from, to]),
        _ => {}
    };
    let mut from = low;
    for to in line.into_iter().map(|(at, _)| at).chain([high]) {
        let places = ((to - from) / step).ceil().max(1.0);
        let width = (to - from) / places;
        let mut last: Option<(f64, f64)> = None;
        let mut entry = from;
        for k in 0..places as usize {
            let at = from + (k as f64 + 0.5) * width;
            let now = number(at);
            if let Some((before, was)) = last
                && (was > INSIDE) != (now > INSIDE)
            {
                let turn = before + (at - before) * (INSIDE - was) / (now - was);
                if now > INSIDE {
                    entry = turn;
                } else {
                    add(entry, turn);
                }
            }
            last = Some((at, now));
        }
        if last.is_some_and(|(_, now)| now > INSIDE) {
            add(entry, to);
        }
        from = to;
    }
    inside
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
    fn all_that_is_inside_along_a_line_counts() {
        let (mut points, mut triangles) = cube();
        // Three cubes in a row, with gaps, so that lines are inside three times.
        for k in 1..3 {
            let (more, faces) = cube();
            points.extend(more.iter().map(|p| p + DVec3::Y * (1.5 * f64::from(k))));
            triangles.extend(faces.iter().map(|t| t.map(|i| i + 8 * k)));
        }
        let solid = Solid::new(&points, &triangles);
        let ball = 4.0 / 3.0 * std::f64::consts::PI * 27.0;
        let around = solid.outside(DVec3::new(0.5, 2.0, 0.5), 3.0, &Disc::new(4096));
        assert!((around - (ball - 3.0)).abs() < 0.05, "{around}");
    }

    #[test]
    fn a_cube_with_a_hole_is_solid_where_it_is_more_than_half_enclosed() {
        let (points, mut triangles) = cube();
        // One side is open: the solid ends a little inside of it, in a bowl.
        triangles.truncate(10);
        let solid = Solid::new(&points, &triangles);
        assert!(
            solid.volume() > 0.85 && solid.volume() < 1.0,
            "{}",
            solid.volume()
        );
        let disc = Disc::new(4096);
        let deep = solid.outside(DVec3::new(0.5, 0.5, 0.3), 0.25, &disc);
        assert!(deep.abs() < 1e-9, "{deep}");
        // Two sides are left: they enclose nothing by half.
        triangles.truncate(2);
        assert_eq!(Solid::new(&points, &triangles).volume(), 0.0);
    }
}
