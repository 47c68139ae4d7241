//! Sets of circular blockers as a receiver's horizon leaves them, with what they do to its light.
//!
//! The shadow pass never meets a blocker that its receiver's horizon cuts: what stands for it touches the horizon
//! (`sh_core::seen`). So these sets lie wholly above the horizon of a normal, which is uniform on the sphere.

use crate::basis::basis;
use crate::blockers::Numbers;
use crate::vec3::{Vec3, add, dot, frame, normalize, scale};
use crate::visibility::Cap;
use crate::zonal::cosine;
use std::f64::consts::{PI, TAU};

/// A kind of sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// 1 to 12 caps of 3° to 45°.
    Separate,
    /// 1 to 4 caps of 2° to 9°.
    Few,
    /// One cap of 1° to 89°.
    Single,
    /// 1 to 3 caps of 5° to 80°.
    Large,
    /// 1 to 4 caps of 3° to 60° that touch the horizon.
    Touching,
    /// One cap of 80° to 90°.
    Half,
    /// 2 to 24 caps of 8° to 45° that nearly coincide.
    Heavy,
    /// 2 to 39 caps of 2° to 18° that overlap as the spheres of a body do; those of a set share a weight.
    Body,
    /// 16 to 47 caps of 20° to 60°.
    Enclosing,
    /// 2 to 128 times the same cap of 5° to 80°.
    Stacked,
}

impl Kind {
    /// All of them.
    pub const ALL: [Self; 10] = [
        Self::Separate,
        Self::Few,
        Self::Single,
        Self::Large,
        Self::Touching,
        Self::Half,
        Self::Heavy,
        Self::Body,
        Self::Enclosing,
        Self::Stacked,
    ];
}

/// A receiver and its blockers.
#[derive(Clone, Debug)]
pub struct Set {
    /// The receiver's normal, a unit vector.
    pub normal: Vec3,
    /// What blocks its light.
    pub caps: Vec<Cap>,
}

/// `count` sets of a kind. A seed gives the same sets everywhere.
///
/// ```
/// use sh_reference::shaded::{Kind, sets};
/// let sets = sets(Kind::Few, 1, 10);
/// assert!(sets.iter().all(|set| (1..=4).contains(&set.caps.len())));
/// ```
pub fn sets(kind: Kind, seed: u64, count: usize) -> Vec<Set> {
    let mut numbers = Numbers::new(seed.wrapping_mul(16).wrapping_add(kind as u64));
    (0..count).map(|_| set(kind, &mut numbers)).collect()
}

fn set(kind: Kind, numbers: &mut Numbers) -> Set {
    let normal = numbers.direction();
    let above = |numbers: &mut Numbers, from: f64, to: f64| {
        let angle = numbers.between(from, to).to_radians();
        let height = numbers.between(angle.sin(), 1.0);
        Cap {
            axis: at(normal, height, numbers.between(0.0, TAU)),
            angle,
        }
    };
    let many = |numbers: &mut Numbers, counts: [usize; 2], degrees: [f64; 2]| -> Vec<Cap> {
        let count = numbers.whole(counts[0], counts[1]);
        (0..count)
            .map(|_| above(numbers, degrees[0], degrees[1]))
            .collect()
    };
    let caps = match kind {
        Kind::Separate => many(numbers, [1, 12], [3.0, 45.0]),
        Kind::Few => many(numbers, [1, 4], [2.0, 9.0]),
        Kind::Single => many(numbers, [1, 1], [1.0, 89.0]),
        Kind::Large => many(numbers, [1, 3], [5.0, 80.0]),
        Kind::Half => many(numbers, [1, 1], [80.0, 90.0]),
        Kind::Enclosing => many(numbers, [16, 47], [20.0, 60.0]),
        Kind::Touching => {
            let count = numbers.whole(1, 4);
            let cap = |_| {
                let angle = numbers.between(3.0, 60.0).to_radians();
                let turn = numbers.between(0.0, TAU);
                Cap {
                    axis: at(normal, angle.sin(), turn),
                    angle,
                }
            };
            (0..count).map(cap).collect()
        }
        Kind::Stacked => {
            let count = 1 << numbers.whole(1, 7);
            vec![above(numbers, 5.0, 80.0); count]
        }
        Kind::Heavy => {
            let whole = above(numbers, 11.0, 36.0);
            let count = numbers.whole(2, 24);
            let cap = |_| {
                let angle = whole.angle * numbers.between(0.75, 1.25);
                let away = angle * numbers.between(0.0, 0.35);
                let axis = add(whole.axis, scale(numbers.direction(), away.tan()));
                lifted(normal, normalize(axis), angle)
            };
            (0..count).map(cap).collect()
        }
        Kind::Body => {
            let middle = above(numbers, 8.0, 8.0).axis;
            let spread = numbers.between(0.1, 0.5);
            let size = numbers.between(4.0, 18.0);
            let count = numbers.whole(8, 39);
            let cap = |_| {
                let away = spread * numbers.between(0.0, 1.7);
                let axis = normalize(add(middle, scale(numbers.direction(), away)));
                let angle = (size * numbers.between(0.4, 1.0)).to_radians();
                Cap { axis, angle }
            };
            let caps: Vec<Cap> = (0..count).map(cap).collect();
            let above: Vec<Cap> = caps
                .into_iter()
                .filter(|cap| dot(cap.axis, normal) > cap.angle.sin())
                .collect();
            if above.len() < 2 {
                return set(kind, numbers);
            }
            above
        }
    };
    Set { normal, caps }
}

/// The direction at a height over the horizon of a normal.
fn at(normal: Vec3, height: f64, turn: f64) -> Vec3 {
    let [x, y] = frame(normal);
    let flat = (1.0 - height * height).max(0.0).sqrt();
    let (sin, cos) = turn.sin_cos();
    let aside = add(scale(x, flat * cos), scale(y, flat * sin));
    add(scale(normal, height), aside)
}

/// A cap raised as far as it has to be to lie above the horizon.
fn lifted(normal: Vec3, axis: Vec3, angle: f64) -> Cap {
    let height = dot(axis, normal);
    if height >= angle.sin() {
        return Cap { axis, angle };
    }
    let aside = add(axis, scale(normal, -height));
    let raised = add(
        scale(normal, angle.sin()),
        scale(normalize(aside), angle.cos()),
    );
    Cap {
        axis: raised,
        angle,
    }
}

/// Directions of [`transfer`].
const DIRECTIONS: usize = 8192;

/// The first n² coefficients of the cosine lobe over π times the visibility past a set's caps: its dot product with light is
/// reflected radiance. From 8192 directions evenly over the sphere, what is hidden taken away from the exact lobe; right to
/// about 1e-3.
///
/// ```
/// use sh_reference::shaded::{Set, transfer};
/// let clear = Set { normal: [0.0, 1.0, 0.0], caps: vec![] };
/// assert!((transfer(4, &clear)[0] - 1.0 / (4.0 * std::f64::consts::PI).sqrt()).abs() < 1e-12);
/// ```
pub fn transfer(order: usize, set: &Set) -> Vec<f64> {
    let mut sum = cosine(order, set.normal);
    let edges: Vec<f64> = set.caps.iter().map(|cap| cap.angle.cos()).collect();
    let golden = PI * (3.0 - 5.0_f64.sqrt());
    for i in 0..DIRECTIONS {
        let z = 1.0 - (2.0 * i as f64 + 1.0) / DIRECTIONS as f64;
        let flat = (1.0 - z * z).sqrt();
        let (sin, cos) = (golden * i as f64).sin_cos();
        let direction = [flat * cos, flat * sin, z];
        let facing = dot(direction, set.normal);
        let mut caps = set.caps.iter().zip(&edges);
        if facing > 0.0 && caps.any(|(cap, edge)| dot(cap.axis, direction) > *edge) {
            let hidden = facing / PI * 4.0 * PI / DIRECTIONS as f64;
            for (sum, y) in sum.iter_mut().zip(basis(order, direction)) {
                *sum -= hidden * y;
            }
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets_are_above_the_horizon() {
        for kind in Kind::ALL {
            for set in sets(kind, 3, 50) {
                assert!(!set.caps.is_empty());
                for cap in &set.caps {
                    let height = dot(cap.axis, set.normal);
                    assert!(height >= cap.angle.sin() - 1e-9, "{kind:?} {cap:?}");
                }
            }
        }
    }

    /// One cap takes sin² θ times the cosine of an even sky's light.
    #[test]
    fn one_cap_takes_what_it_takes() {
        for set in sets(Kind::Single, 5, 40) {
            let cap = set.caps[0];
            let taken = cap.angle.sin().powi(2) * dot(cap.axis, set.normal);
            let light = transfer(2, &set)[0] * (4.0 * PI).sqrt();
            assert!((1.0 - taken - light).abs() < 4e-3, "{cap:?}: {light}");
        }
    }
}
