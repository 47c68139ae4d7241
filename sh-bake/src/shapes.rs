//! Meshes made by code: what the built-in scene and tests are made of.
//!
//! All are closed, stand upright about +Y with their centre in the origin, face outward, are smooth where
//! the shape is smooth and split along hard edges.

mod bend;
mod merged;

pub use bend::Bend;
pub use merged::{Limb, merged};

use glam::{Quat, Vec3};
use sh_scene::Mesh;
use std::collections::HashMap;
use std::f32::consts::{FRAC_PI_2, TAU};

/// A ball: an icosahedron whose triangles are cut in four `levels` times (at most 7).
///
/// ```
/// let mesh = sh_bake::shapes::ball(2.0, 1);
/// assert_eq!(mesh.triangles.len(), 80);
/// ```
pub fn ball(radius: f32, levels: u32) -> Mesh {
    let g = (1.0 + 5.0_f32.sqrt()) / 2.0;
    let mut points: Vec<Vec3> = Vec::new();
    for (a, b) in [(1.0, g), (-1.0, g), (1.0, -g), (-1.0, -g)] {
        points.extend([
            Vec3::new(0.0, a, b),
            Vec3::new(a, b, 0.0),
            Vec3::new(b, 0.0, a),
        ]);
    }
    let mut triangles = Vec::new();
    let edge = |a: usize, b: usize| (points[a].distance(points[b]) - 2.0).abs() < 1e-4;
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if edge(a, b) && edge(b, c) && edge(c, a) {
                    let outward = (points[b] - points[a])
                        .cross(points[c] - points[a])
                        .dot(points[a]);
                    let [a, b, c] = [a as u32, b as u32, c as u32];
                    triangles.push(if outward > 0.0 { [a, b, c] } else { [a, c, b] });
                }
            }
        }
    }
    for _ in 0..levels.min(7) {
        let mut middles = HashMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                points
                    .push((points[a as usize].normalize() + points[b as usize].normalize()) * 0.5);
                points.len() as u32 - 1
            })
        };
        triangles = triangles
            .iter()
            .flat_map(|&[a, b, c]| {
                let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
            })
            .collect();
    }
    let normals: Vec<[f32; 3]> = points.iter().map(|p| p.normalize().to_array()).collect();
    let positions = normals.iter().map(|n| n.map(|c| c * radius)).collect();
    Mesh {
        positions,
        normals,
        triangles,
        ..Mesh::default()
    }
}

/// A grid of points wrapped into a surface.
struct Grid {
    columns: u32,
    rows: u32,
}

impl Grid {
    /// The triangles between points `(column, row)` numbered row by row. A grid that is `closed` in a
    /// direction joins its last points to its first.
    fn triangles(&self, closed: [bool; 2]) -> Vec<[u32; 3]> {
        let cells = |count: u32, closed: bool| if closed { count } else { count - 1 };
        let mut triangles = Vec::new();
        for row in 0..cells(self.rows, closed[1]) {
            for column in 0..cells(self.columns, closed[0]) {
                let at = |c: u32, r: u32| c % self.columns + r % self.rows * self.columns;
                let [a, b] = [at(column, row), at(column + 1, row)];
                let [c, d] = [at(column + 1, row + 1), at(column, row + 1)];
                triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
        triangles
    }
}

/// A torus knot that winds `p` times about the axis and `q` times about its ring, as a tube; p = 1 and
/// q = 0 is a plain torus. `ring` is the radius of the ring, `swing` that of the winding about it, `tube`
/// the tube's.
pub fn torus_knot(p: u32, q: u32, ring: f32, swing: f32, tube: f32) -> Mesh {
    let grid = Grid {
        columns: 20,
        rows: 96 * p.max(1),
    };
    let curve = |t: f32| {
        let (around, about) = (t * p as f32, t * q as f32);
        let out = ring + swing * about.cos();
        Vec3::new(out * around.cos(), swing * about.sin(), out * around.sin())
    };
    let mut mesh = Mesh {
        triangles: grid.triangles([true, true]),
        ..Mesh::default()
    };
    for row in 0..grid.rows {
        let t = TAU * row as f32 / grid.rows as f32;
        let center = curve(t);
        let forward = (curve(t + 1e-3) - curve(t - 1e-3)).normalize();
        // The tube's frame leans on the direction from the ring's own centre line: it comes round to itself.
        let spoke = Vec3::new((t * p as f32).cos(), 0.0, (t * p as f32).sin());
        let outward = if q == 0 { spoke } else { center - spoke * ring };
        let side = forward.cross(outward).normalize();
        let up = side.cross(forward);
        for column in 0..grid.columns {
            let (sin, cos) = (TAU * column as f32 / grid.columns as f32).sin_cos();
            let normal = up * cos - side * sin;
            mesh.normals.push(normal.to_array());
            mesh.positions.push((center + normal * tube).to_array());
        }
    }
    outward(mesh)
}

/// A rectangle in the plane of X and Y about the origin that faces +Z, as a grid of so many cells: a wall, as it is seen from
/// within a room.
///
/// ```
/// let wall = sh_bake::shapes::panel([4.0, 3.0], [8, 6]);
/// assert_eq!((wall.positions.len(), wall.triangles.len()), (63, 96));
/// ```
pub fn panel([width, height]: [f32; 2], cells: [u32; 2]) -> Mesh {
    let [columns, rows] = cells.map(|count| count.max(1) + 1);
    let along = |i: u32, count: u32, size: f32| size * (i as f32 / (count - 1) as f32 - 0.5);
    let points = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
    let positions: Vec<[f32; 3]> = points
        .map(|(column, row)| [along(column, columns, width), along(row, rows, height), 0.0])
        .collect();
    Mesh {
        normals: vec![[0.0, 0.0, 1.0]; positions.len()],
        positions,
        triangles: Grid { columns, rows }.triangles([false, false]),
        ..Mesh::default()
    }
}

/// A box with its edges rounded by `bevel` (at most half its smallest side).
pub fn rounded_box(size: Vec3, bevel: f32) -> Mesh {
    let bevel = bevel.clamp(0.0, size.min_element() * 0.5);
    let inner = size * 0.5 - bevel;
    // Places across a face: the round part in four steps on both sides, the flat part in one.
    let steps: Vec<(f32, f32)> = (0..=4)
        .map(|k| (-1.0, FRAC_PI_2 / 2.0 * (k as f32 / 4.0 - 1.0)))
        .chain((0..=4).map(|k| (1.0, FRAC_PI_2 / 2.0 * k as f32 / 4.0)))
        .collect();
    let grid = Grid {
        columns: steps.len() as u32,
        rows: steps.len() as u32,
    };
    let mut mesh = Mesh::default();
    for axis in 0..3 {
        for sign in [-1.0, 1.0] {
            let first = mesh.positions.len() as u32;
            for &(side_v, angle_v) in &steps {
                for &(side_u, angle_u) in &steps {
                    let (mut corner, mut normal) = (Vec3::ZERO, Vec3::ZERO);
                    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
                    (corner[axis], normal[axis]) = (sign, sign);
                    (corner[u], normal[u]) = (side_u, angle_u.tan());
                    (corner[v], normal[v]) = (side_v, angle_v.tan());
                    let normal = normal.normalize();
                    mesh.normals.push(normal.to_array());
                    mesh.positions
                        .push((corner * inner + normal * bevel).to_array());
                }
            }
            let flip = sign < 0.0;
            mesh.triangles
                .extend(grid.triangles([false, false]).iter().map(|&[a, b, c]| {
                    if flip {
                        [a + first, c + first, b + first]
                    } else {
                        [a + first, b + first, c + first]
                    }
                }));
        }
    }
    mesh
}

/// A body of revolution about +Y: `profile` is a list of smooth strips from bottom to top, each of points
/// (radius, height, normal outward, normal upward); between strips the edge is hard. The first point and
/// the last lie on the axis.
fn revolved(profile: &[Vec<[f32; 4]>], turn: impl Fn(f32) -> f32) -> Mesh {
    const AROUND: u32 = 64;
    let mut mesh = Mesh::default();
    for strip in profile {
        let first = mesh.positions.len() as u32;
        for &[radius, height, out, up] in strip {
            for column in 0..AROUND {
                let spin =
                    Quat::from_rotation_y(turn(height) + TAU * column as f32 / AROUND as f32);
                mesh.positions
                    .push((spin * Vec3::new(radius, height, 0.0)).to_array());
                mesh.normals
                    .push((spin * Vec3::new(out, up, 0.0)).normalize().to_array());
            }
        }
        let grid = Grid {
            columns: AROUND,
            rows: strip.len() as u32,
        };
        mesh.triangles.extend(
            grid.triangles([true, false])
                .iter()
                .map(|t| t.map(|i| i + first)),
        );
    }
    outward(mesh)
}

/// A capsule: a cylinder of `length` between two half balls of `radius`.
pub fn capsule(radius: f32, length: f32) -> Mesh {
    let cap = |from: f32, shift: f32| {
        (0..=16).map(move |k| {
            let (sin, cos) = (from + FRAC_PI_2 * k as f32 / 16.0).sin_cos();
            [radius * cos.max(0.0), radius * sin + shift, cos, sin]
        })
    };
    revolved(
        &[cap(-FRAC_PI_2, -length / 2.0)
            .chain(cap(0.0, length / 2.0))
            .collect()],
        |_| 0.0,
    )
}

/// A cone that stands on its base, the middle of its height in the origin.
pub fn cone(radius: f32, height: f32) -> Mesh {
    let (low, high) = (-height / 2.0, height / 2.0);
    let side = (0..=24).map(|k| {
        let t = k as f32 / 24.0;
        [radius * (1.0 - t), low + t * (high - low), height, radius]
    });
    revolved(
        &[
            vec![[0.0, low, 0.0, -1.0], [radius, low, 0.0, -1.0]],
            side.collect(),
        ],
        |_| 0.0,
    )
}

/// A cylinder, the middle of its height in the origin.
pub fn cylinder(radius: f32, height: f32) -> Mesh {
    let (low, high) = (-height / 2.0, height / 2.0);
    let strips = [
        vec![[0.0, low, 0.0, -1.0], [radius, low, 0.0, -1.0]],
        vec![[radius, low, 1.0, 0.0], [radius, high, 1.0, 0.0]],
        vec![[radius, high, 0.0, 1.0], [0.0, high, 0.0, 1.0]],
    ];
    revolved(&strips, |_| 0.0)
}

/// A square column of half side `half`, twisted by `twist` radians over its `height`.
pub fn twisted_column(half: f32, height: f32, twist: f32) -> Mesh {
    const ROWS: u32 = 48;
    const ACROSS: u32 = 8;
    let mut mesh = Mesh::default();
    let place = |u: f32, v: f32, y: f32, side: f32| {
        Quat::from_rotation_y(twist * y / height + side) * Vec3::new(u, y, v)
    };
    // Each side is its own patch, and so are the ends: the edges between them are hard.
    for side in 0..4 {
        let side = FRAC_PI_2 * side as f32;
        let first = mesh.positions.len() as u32;
        for row in 0..=ROWS {
            let y = height * (row as f32 / ROWS as f32 - 0.5);
            for column in 0..=ACROSS {
                let u = half * (2.0 * column as f32 / ACROSS as f32 - 1.0);
                let p = place(u, half, y, side);
                let along =
                    place(u + half * 1e-2, half, y, side) - place(u - half * 1e-2, half, y, side);
                let e = height * 1e-3;
                let upward = place(u, half, y + e, side) - place(u, half, y - e, side);
                mesh.positions.push(p.to_array());
                mesh.normals
                    .push(along.cross(upward).normalize().to_array());
            }
        }
        let grid = Grid {
            columns: ACROSS + 1,
            rows: ROWS + 1,
        };
        mesh.triangles.extend(
            grid.triangles([false, false])
                .iter()
                .map(|t| t.map(|i| i + first)),
        );
    }
    for (y, normal) in [(-height / 2.0, Vec3::NEG_Y), (height / 2.0, Vec3::Y)] {
        let first = mesh.positions.len() as u32;
        for row in 0..=ACROSS {
            for column in 0..=ACROSS {
                let [u, v] = [column, row].map(|k| half * (2.0 * k as f32 / ACROSS as f32 - 1.0));
                mesh.positions.push(place(u, v, y, 0.0).to_array());
                mesh.normals.push(normal.to_array());
            }
        }
        let grid = Grid {
            columns: ACROSS + 1,
            rows: ACROSS + 1,
        };
        mesh.triangles.extend(
            grid.triangles([false, false])
                .iter()
                .map(|t| t.map(|i| i + first)),
        );
    }
    outward(mesh)
}

/// Turns each triangle so that it faces the way its normals point, and drops those without area (at a
/// pole of a grid).
fn outward(mut mesh: Mesh) -> Mesh {
    let vec = |list: &[[f32; 3]], i: u32| Vec3::from(list[i as usize]);
    let (positions, normals) = (&mesh.positions, &mesh.normals);
    mesh.triangles.retain_mut(|t| {
        let [a, b, c] = t.map(|i| vec(positions, i));
        let facing = (b - a).cross(c - a);
        if facing.dot(t.map(|i| vec(normals, i)).iter().sum()) < 0.0 {
            t.swap(1, 2);
        }
        let longest = (b - a).length_squared().max((c - a).length_squared());
        facing.length() > 1e-5 * longest
    });
    mesh
}
