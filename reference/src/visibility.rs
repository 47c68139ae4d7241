//! Binary visibility past many blockers, and the light that is left.
//!
//! A sphere seen from a point outside it covers a cap of directions; several cover the union of their caps
//! (eq. 7 of Ren 2006, multiplied over blockers). [`project`] and [`irradiance`] divide the sphere of
//! directions into cells of a cube map and split those a cap's edge may cross, until the undecided ones
//! together cover no more than a given solid angle. Decided cells are integrated by Gauss–Legendre, so
//! what is undecided bounds the error.
//!
//! For any other visibility, and for light that is not smooth, see [`crate::sampled`].

use crate::basis::basis;
use crate::cells::{Cell, rule_at};
use crate::quadrature::{Estimate, accumulate};
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
/// `tolerance` steradians or a million cells are undecided. Time grows as (length of all edges)²/tolerance;
/// eight caps of 30° at 1e-2 take about a second and are in fact right to 1e-5, at 0.1 to 1e-4.
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
/// (for a map of texels, use [`crate::sampled::irradiance`]).
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

/// ∫ V(s) f(s) ds.
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
    let mut level = 0;
    loop {
        let rule = rule_at(level);
        let mut whole = |cell: &Cell| cell.each_node(&rule, |s, k| add(s, k, &mut sum));
        cells.retain(|cell| {
            let decision = decide(cell, caps);
            if decision == Some(true) {
                whole(cell);
            }
            decision.is_none()
        });
        let undecided = cells.iter().map(Cell::solid_angle).sum();
        if undecided <= tolerance || cells.len() > 1 << 20 {
            // Their centres speak for them.
            cells
                .iter()
                .filter(|cell| visible(caps, cell.center()))
                .for_each(whole);
            let undecided_at = cells.iter().map(Cell::center).collect();
            return Integral {
                sum,
                undecided,
                undecided_at,
            };
        }
        cells = cells.iter().flat_map(Cell::split).collect();
        level += 1;
    }
}

/// Whether all of a cell is visible, all blocked by one cap, or neither is certain.
fn decide(cell: &Cell, caps: &[Cap]) -> Option<bool> {
    let (center, reach) = (cell.center(), cell.reach());
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::basis::distance;
    use crate::cap;
    use crate::sampled;
    use crate::testing::{assert_close, directions, numbers};
    use crate::vec3::add;
    use crate::zonal::{cosine, rotated};

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
            let off = distance(&found.coefficients, &truth);
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
        let dense = sampled::project(4, 200_000, |s| if visible(&caps, s) { 1.0 } else { 0.0 });
        let off = distance(&adaptive.coefficients, &dense.coefficients);
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
        let dense = sampled::irradiance(
            [0.0, 1.0, 0.0],
            20_000,
            |s| f64::from(u8::from(visible(&[cap], s))),
            |_| [1.0; 3],
        );
        assert!((dense.value[0] - truth).abs() < 2e-3 && dense.error < 1e-2);
    }
}
