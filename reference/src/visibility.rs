//! Binary visibility past many blockers, and the light that is left.
//!
//! A sphere seen from a point outside it covers a cap of directions; several cover the union of their caps
//! (eq. 7 of Ren 2006, multiplied over blockers). [`project`] and [`irradiance`] divide the sphere of
//! directions into cells of a cube map and split those a cap's edge may cross, until the undecided ones
//! together cover no more than a given solid angle. Decided cells are integrated by Gauss–Legendre, so
//! what is undecided bounds the error.
//!
//! [`project_dense`] and [`irradiance_dense`] ask any other visibility (triangles, see
//! [`crate::raycast`]) once per cell of a regular grid and estimate their error from a grid half as fine.

use crate::basis::{basis, norm};
use crate::quadrature::{Estimate, accumulate, gauss_legendre};
use crate::vec3::{Vec3, angle, dot, length, normalize, scale, sub, widen};
use sh_scene::Sphere;
use std::f64::consts::{FRAC_PI_2, PI};

/// Directions within `angle` (radians) of the unit vector `axis`: those a sphere blocks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cap {
    /// Unit vector towards the blocker.
    pub axis: [f64; 3],
    /// Angular radius, in 0..=π.
    pub angle: f64,
}

/// The caps that spheres cover, seen from `point`: asin(r/D) about the centre for a sphere at distance
/// D > r, everything for one that holds the point, nothing for one of radius 0. These are spheres as they
/// are, without the self-shadow rules of section 6.2.
///
/// ```
/// let sphere = sh_scene::Sphere { center: [0.0, 2.0, 0.0], radius: 1.0 };
/// let caps = sh_reference::visibility::caps([0.0; 3], &[sphere]);
/// assert!((caps[0].angle - std::f64::consts::FRAC_PI_6).abs() < 1e-15);
/// ```
pub fn caps(point: [f64; 3], spheres: &[Sphere]) -> Vec<Cap> {
    let cap = |sphere: &Sphere| {
        let (to, radius) = (sub(widen(sphere.center), point), f64::from(sphere.radius));
        let distance = length(to);
        if distance <= radius {
            Cap {
                axis: [0.0, 0.0, 1.0],
                angle: PI,
            }
        } else {
            Cap {
                axis: normalize(to),
                angle: (radius / distance).asin(),
            }
        }
    };
    spheres
        .iter()
        .filter(|sphere| sphere.radius > 0.0)
        .map(cap)
        .collect()
}

/// Whether nothing blocks the unit vector `direction`.
pub fn visible(caps: &[Cap], direction: [f64; 3]) -> bool {
    caps.iter()
        .all(|cap| angle(cap.axis, direction) > cap.angle)
}

/// SH vector of the visibility past `caps`. The L2 norm of its error is at most `error`: the undecided
/// solid angle times ‖y(s)‖ = order/√4π, plus rounding. It stops where that solid angle is at most
/// `tolerance` steradians or a million cells are undecided; 1e-3 takes about a second and is in fact
/// right to some 1e-5.
///
/// ```
/// use sh_reference::{cap, visibility::{Cap, project}};
/// let found = project(3, &[Cap { axis: [0.0, 0.0, 1.0], angle: 0.5 }], 1e-2);
/// assert!(found.error < 3e-2);
/// assert!((found.coefficients[6] - cap::visibility(3, 0.5)[2]).abs() < found.error);
/// ```
pub fn project(order: usize, caps: &[Cap], tolerance: f64) -> Estimate {
    let integral = integrate(order * order, caps, tolerance, |s, k, sum| {
        accumulate(sum, k, &basis(order, s))
    });
    let error = integral.undecided * order as f64 / (4.0 * PI).sqrt() + 1e-12;
    Estimate {
        coefficients: integral.sum,
        error,
    }
}

/// Red, green and blue with an error common to all three.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Radiance {
    /// Radiance reflected by a white diffuse surface: irradiance over π.
    pub value: [f64; 3],
    /// How far any channel may be off.
    pub error: f64,
}

/// ∫ light(s) V(s) max(s·N, 0)/π ds behind `caps`, for the unit vector `normal`: what a white surface
/// reflects. The horizon is treated as one cap more. `error` is the undecided solid angle times the
/// largest integrand seen in it; the light is taken to be as smooth as an SH vector of order 12 or less
/// (for a map of texels, use [`irradiance_dense`]).
///
/// ```
/// use sh_reference::visibility::{Cap, irradiance};
/// // A sphere straight above of angular radius 30° blocks sin² 30° of a white sky's light.
/// let cap = Cap { axis: [0.0, 1.0, 0.0], angle: std::f64::consts::FRAC_PI_6 };
/// let found = irradiance(&[cap], [0.0, 1.0, 0.0], 1e-2, |_| [1.0; 3]);
/// assert!((found.value[0] - 0.75).abs() < 1e-3);
/// ```
pub fn irradiance(
    caps: &[Cap],
    normal: [f64; 3],
    tolerance: f64,
    light: impl Fn([f64; 3]) -> [f64; 3],
) -> Radiance {
    let mut all = caps.to_vec();
    all.push(Cap {
        axis: scale(normal, -1.0),
        angle: FRAC_PI_2,
    });
    let reflected = |s: Vec3| light(s).map(|c| c * dot(s, normal).max(0.0) / PI);
    let integral = integrate(3, &all, tolerance, |s, k, sum| {
        accumulate(sum, k, &reflected(s))
    });
    let largest = integral
        .undecided_at
        .iter()
        .flat_map(|s| reflected(*s))
        .fold(0.0, |a: f64, b| a.max(b.abs()));
    Radiance {
        value: [0, 1, 2].map(|c| integral.sum[c]),
        error: integral.undecided * largest + 1e-12,
    }
}

/// A cell of a cube map: directions (1, a, b)/√(1+a²+b²), their coordinates permuted and signed by the face,
/// for a and b within `half` of the middle.
#[derive(Clone, Copy)]
struct Cell {
    face: usize,
    a: f64,
    b: f64,
    half: f64,
}

impl Cell {
    /// The six faces cut into `count²` cells each.
    fn grid(count: usize) -> impl Iterator<Item = Cell> {
        let half = 1.0 / count as f64;
        let middle = move |i: usize| (2 * i + 1) as f64 * half - 1.0;
        (0..6 * count * count).map(move |i| {
            let (face, within) = (i / (count * count), i % (count * count));
            Cell {
                face,
                a: middle(within % count),
                b: middle(within / count),
                half,
            }
        })
    }

    fn direction(&self, a: f64, b: f64) -> Vec3 {
        let forward = if self.face < 3 { 1.0 } else { -1.0 };
        let mut s = [forward, a, b];
        s.rotate_right(self.face % 3);
        normalize(s)
    }

    fn center(&self) -> Vec3 {
        self.direction(self.a, self.b)
    }

    fn corners(&self) -> [Vec3; 4] {
        let Cell { a, b, half, .. } = *self;
        [(-half, -half), (half, -half), (-half, half), (half, half)]
            .map(|(da, db)| self.direction(a + da, b + db))
    }

    /// In steradians: the solid angle of 0..a, 0..b is atan(ab/√(1+a²+b²)).
    fn solid_angle(&self) -> f64 {
        let quadrant = |a: f64, b: f64| (a * b).atan2((1.0 + a * a + b * b).sqrt());
        let Cell { a, b, half, .. } = *self;
        quadrant(a + half, b + half) - quadrant(a - half, b + half) - quadrant(a + half, b - half)
            + quadrant(a - half, b - half)
    }

    fn split(&self) -> [Cell; 4] {
        let half = 0.5 * self.half;
        [(-half, -half), (half, -half), (-half, half), (half, half)].map(|(da, db)| Cell {
            a: self.a + da,
            b: self.b + db,
            half,
            ..*self
        })
    }

    /// Whether all of the cell is visible, all blocked by one cap, or neither is certain. The cell's edges
    /// are great circles, so no point of it is farther from its centre than a corner.
    fn decide(&self, caps: &[Cap]) -> Option<bool> {
        let center = self.center();
        let reach = self
            .corners()
            .iter()
            .map(|corner| angle(center, *corner))
            .fold(0.0, f64::max);
        let mut clear = true;
        for cap in caps {
            let away = angle(center, cap.axis);
            if away + reach <= cap.angle || cap.angle >= PI {
                return Some(false);
            }
            clear &= away - reach > cap.angle;
        }
        clear.then_some(true)
    }

    /// Hands nodes and weights of a Gauss–Legendre rule over the cell to `add`; the density of solid angle is
    /// (1+a²+b²)^{−3/2}.
    fn each_node(&self, count: usize, mut add: impl FnMut(Vec3, f64)) {
        for (a, da) in gauss_legendre(count, self.a - self.half, self.a + self.half) {
            for (b, db) in gauss_legendre(count, self.b - self.half, self.b + self.half) {
                add(
                    self.direction(a, b),
                    da * db * (1.0 + a * a + b * b).powf(-1.5),
                );
            }
        }
    }
}

struct Integral {
    sum: Vec<f64>,
    /// Solid angle of the cells an edge may cross, in steradians.
    undecided: f64,
    /// Their centres.
    undecided_at: Vec<Vec3>,
}

/// ∫ V(s) f(s) ds for a function of `count` values, given as `add(s, k, sum)`: `sum += k f(s)`.
fn integrate(
    count: usize,
    caps: &[Cap],
    tolerance: f64,
    add: impl Fn(Vec3, f64, &mut [f64]),
) -> Integral {
    let mut sum = vec![0.0; count];
    let mut cells: Vec<Cell> = Cell::grid(4).collect();
    for level in 0usize.. {
        // On a cell of half width h the rule's error falls about as (h/2)^(2·nodes): 1e-12 up to order 12.
        let nodes = 12usize.saturating_sub(2 * level).max(3);
        let mut whole = |cell: &Cell| cell.each_node(nodes, |s, k| add(s, k, &mut sum));
        cells.retain(|cell| {
            let decision = cell.decide(caps);
            if decision == Some(true) {
                whole(cell);
            }
            decision.is_none()
        });
        let undecided = cells.iter().map(Cell::solid_angle).sum();
        if undecided <= tolerance || cells.len() > 1 << 20 {
            // Their centre speaks for them.
            cells
                .iter()
                .filter(|cell| visible(caps, cell.center()))
                .for_each(whole);
            return Integral {
                sum,
                undecided,
                undecided_at: cells.iter().map(Cell::center).collect(),
            };
        }
        cells = cells.iter().flat_map(Cell::split).collect();
    }
    unreachable!("the undecided solid angle falls, or the number of cells grows, with every level")
}

/// SH vector of any visibility (a share in 0..=1), asked once in the middle of each of `6·grid²` cells.
/// `error` is the distance to the vector from a grid half as fine, which for edges is two or three times
/// the truth: about 0.4·grid^(−3/2) for one edge round the sphere.
///
/// ```
/// let half = sh_reference::visibility::project_dense(2, 64, |[_, y, _]| if y > 0.0 { 1.0 } else { 0.0 });
/// assert!((half.coefficients[0] - std::f64::consts::PI.sqrt()).abs() < 1e-3);
/// ```
///
/// # Panics
/// If `grid` is less than 2.
pub fn project_dense(
    order: usize,
    grid: usize,
    mut visible: impl FnMut([f64; 3]) -> f64,
) -> Estimate {
    let (coefficients, coarse) = dense(order * order, grid, |s, k, sum| {
        accumulate(sum, k * visible(s), &basis(order, s))
    });
    let error = norm(
        &coefficients
            .iter()
            .zip(&coarse)
            .map(|(a, b)| a - b)
            .collect::<Vec<_>>(),
    );
    Estimate {
        coefficients,
        error,
    }
}

/// ∫ light(s) V(s) max(s·N, 0)/π ds with light and visibility asked once in each of `6·grid²` cells; `error` is
/// the largest difference to a grid half as fine.
///
/// # Panics
/// If `grid` is less than 2.
pub fn irradiance_dense(
    normal: [f64; 3],
    grid: usize,
    mut visible: impl FnMut([f64; 3]) -> f64,
    light: impl Fn([f64; 3]) -> [f64; 3],
) -> Radiance {
    let (fine, coarse) = dense(3, grid, |s, k, sum| {
        let cosine = dot(s, normal);
        if cosine > 0.0 {
            accumulate(sum, k * visible(s) * cosine / PI, &light(s));
        }
    });
    let error = fine
        .iter()
        .zip(&coarse)
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max);
    Radiance {
        value: [0, 1, 2].map(|c| fine[c]),
        error,
    }
}

/// The sum over a grid, and that over a grid half as fine.
fn dense(
    count: usize,
    grid: usize,
    mut add: impl FnMut(Vec3, f64, &mut [f64]),
) -> (Vec<f64>, Vec<f64>) {
    assert!(grid >= 2, "a grid of {grid} has none half as fine");
    let mut over = |grid| {
        let mut sum = vec![0.0; count];
        for cell in Cell::grid(grid) {
            add(cell.center(), cell.solid_angle(), &mut sum);
        }
        sum
    };
    (over(grid), over(grid / 2))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cap;
    use crate::testing::{assert_close, directions, numbers};
    use crate::vec3::add;
    use crate::zonal::{cosine, rotated};

    #[test]
    fn cells_make_up_the_sphere() {
        for count in [1, 2, 5] {
            let sum: f64 = Cell::grid(count).map(|cell| cell.solid_angle()).sum();
            assert!((sum - 4.0 * PI).abs() < 1e-12);
        }
        for cell in Cell::grid(3) {
            let mut by_nodes = 0.0;
            cell.each_node(12, |_, k| by_nodes += k);
            assert!((by_nodes - cell.solid_angle()).abs() < 1e-12);
            let of_parts: f64 = cell.split().iter().map(Cell::solid_angle).sum();
            assert!((of_parts - cell.solid_angle()).abs() < 1e-14);
        }
    }

    #[test]
    fn nothing_in_the_way_is_one_to_rounding() {
        let free = project(10, &[], 1e-3);
        let mut one = vec![0.0; 100];
        one[0] = (4.0 * PI).sqrt();
        assert_close(&free.coefficients, &one, 1e-12);
        assert!(free.error < 1e-11);
    }

    #[test]
    fn one_cap_is_its_closed_form() {
        for (i, axis) in directions(6).into_iter().enumerate() {
            let angle = 0.1 + 0.45 * i as f64;
            let found = project(4, &[Cap { axis, angle }], 2e-2);
            let truth = rotated(&cap::visibility(4, angle), axis);
            let off = norm(
                &found
                    .coefficients
                    .iter()
                    .zip(&truth)
                    .map(|(a, b)| a - b)
                    .collect::<Vec<_>>(),
            );
            assert!(
                off < found.error,
                "{off:e} above the bound {:e}",
                found.error
            );
            assert!(off < 1e-3, "{off:e}");
        }
    }

    #[test]
    fn disjoint_caps_add_and_nested_ones_do_not() {
        let small = Cap {
            axis: [1.0, 0.0, 0.0],
            angle: 0.3,
        };
        let around = Cap {
            axis: normalize([1.0, 0.1, 0.0]),
            angle: 0.6,
        };
        let apart = Cap {
            axis: [0.0, -1.0, 0.0],
            angle: 0.7,
        };
        let found = project(3, &[small, around, apart], 1e-2);
        let mut truth = rotated(&cap::visibility(3, 0.6), around.axis);
        accumulate(
            &mut truth,
            -1.0,
            &rotated(&cap::blocked(3, 0.7), apart.axis),
        );
        assert_close(&found.coefficients, &truth, 1e-3);
    }

    #[test]
    fn overlapping_caps_agree_with_the_dense_grid() {
        let caps: Vec<Cap> = directions(5)
            .into_iter()
            .map(|axis| Cap { axis, angle: 0.8 })
            .collect();
        let adaptive = project(4, &caps, 1e-2);
        let dense = project_dense(4, 256, |s| if visible(&caps, s) { 1.0 } else { 0.0 });
        let off = norm(
            &adaptive
                .coefficients
                .iter()
                .zip(&dense.coefficients)
                .map(|(a, b)| a - b)
                .collect::<Vec<_>>(),
        );
        assert!(off < adaptive.error + dense.error && off < 2e-3, "{off:e}");
    }

    #[test]
    fn spheres_cover_caps() {
        let spheres = [
            Sphere {
                center: [0.0, 0.0, 4.0],
                radius: 2.0,
            },
            Sphere {
                center: [1.0, 1.0, 1.0],
                radius: 0.0,
            },
            Sphere {
                center: [0.1, 0.0, 0.0],
                radius: 0.5,
            },
        ];
        let found = caps([0.0; 3], &spheres);
        assert_eq!(found.len(), 2);
        assert!((found[0].angle - PI / 6.0).abs() < 1e-15 && found[0].axis == [0.0, 0.0, 1.0]);
        assert_eq!(found[1].angle, PI);
        assert!(
            project(2, &found, 1e-3)
                .coefficients
                .iter()
                .all(|&c| c == 0.0)
        );
    }

    #[test]
    fn a_sphere_blocks_the_rays_that_meet_it() {
        let sphere = Sphere {
            center: [1.0, -2.0, 0.5],
            radius: 1.5,
        };
        let point = [-1.0, 0.5, 1.0];
        let caps = caps(point, &[sphere]);
        let mut blocked = 0;
        for s in directions(2000) {
            // Nearest approach of the ray to the centre.
            let to = sub(widen(sphere.center), point);
            let nearest = add(point, scale(s, dot(to, s).max(0.0)));
            let meets = length(sub(widen(sphere.center), nearest)) <= 1.5;
            assert_eq!(visible(&caps, s), !meets);
            blocked += usize::from(meets);
        }
        assert!(blocked > 50);
    }

    #[test]
    fn irradiance_without_blockers_is_the_cosine_lobe() {
        let light = numbers(31, 16);
        for normal in directions(4) {
            let found = irradiance(&[], normal, 1e-2, |s| {
                [crate::basis::evaluate(&light, s), 1.0, 0.0]
            });
            let truth = crate::basis::dot(&light, &cosine(4, normal));
            assert!(
                (found.value[0] - truth).abs() < 1e-4,
                "{} instead of {truth}",
                found.value[0]
            );
            assert!((found.value[1] - 1.0).abs() < 1e-4 && found.value[2] == 0.0);
            assert!(found.error < 1e-3);
        }
    }

    #[test]
    fn irradiance_behind_a_tilted_sphere() {
        // A cap wholly above the horizon, its axis tilted by t: it blocks sin² θ cos t of a white sky's light
        // (the form factor of a sphere).
        let (angle, tilt) = (0.5f64, 0.8f64);
        let cap = Cap {
            axis: [tilt.sin(), tilt.cos(), 0.0],
            angle,
        };
        let truth = 1.0 - angle.sin().powi(2) * tilt.cos();
        let found = irradiance(&[cap], [0.0, 1.0, 0.0], 1e-2, |_| [1.0; 3]);
        assert!(
            (found.value[0] - truth).abs() < found.error && (found.value[0] - truth).abs() < 1e-4
        );
        let dense = irradiance_dense(
            [0.0, 1.0, 0.0],
            128,
            |s| f64::from(u8::from(visible(&[cap], s))),
            |_| [1.0; 3],
        );
        assert!((dense.value[0] - truth).abs() < 2e-3 && dense.error < 1e-2);
    }
}
