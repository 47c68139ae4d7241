//! The sum of all blockers' log visibilities at a receiver (Ren et al. 2006, equation 38).

use sh_core::{Lane, Routines};
use sh_scene::Blocker;

/// Smallest divisor, in metres: far below any distance that matters, far above the point where its
/// reciprocal overflows.
const TINY: f64 = 1e-30;

/// Smallest square of the distance of a sphere that counts in the place of another, over the square of the other's.
const FOOT: f64 = 1e-6;

/// Blockers whose replacements are worked out before any is added: the chain of square roots and divisions of
/// one is long, and in a short loop of their own the processor overlaps several. More than it overlaps would only have
/// to be stored and loaded again.
const BATCH: usize = 8;

/// What casts shadows on a group of receivers.
#[derive(Clone, Copy, Debug, Default)]
pub struct Blockers<'a> {
    /// Those that lie wholly in front of every receiver's tangent plane.
    pub front: &'a [Blocker],
    /// Those of which each receiver has to find out.
    pub across: &'a [Blocker],
}

/// `sum`, on the scale of [`Routines::accumulate_blocker`], plus the blockers' log visibilities, to be inlined into [`crate::Outline::accumulate`].
///
/// Cost per receiver and blocker at order 4: about 115 operations, a division and two square roots for one in
/// front; for one across the tangent plane 50 more, with another division and another square root. A blocker behind the
/// tangent planes of all receivers in a group of lanes costs one dot product.
#[inline(always)]
pub(crate) fn accumulated<L: Lane, const C: usize>(
    sum: &[L; C],
    position: [L; 3],
    normal: [L; 3],
    blockers: Blockers,
) -> [L; C]
where
    [L; C]: Routines<L>,
{
    let zero = position[0].lift(0.0);
    let mut sum = *sum;
    let nothing = Seen {
        sine: zero,
        cosine: zero,
        direction: [zero; 3],
    };
    let mut batch = [nothing; BATCH];
    for blockers in blockers.front.chunks(BATCH) {
        for (seen, blocker) in batch.iter_mut().zip(blockers) {
            let center = each(|k| zero.lift(f64::from(blocker.center[k])) - position[k]);
            *seen = as_it_is(center, zero.lift(f64::from(blocker.radius)));
        }
        add_all(&mut sum, batch.iter().zip(blockers));
    }
    // Blockers that are behind all lanes are passed over, so that batches are full.
    let mut counting = [&Blocker::NONE; BATCH];
    let mut count = 0;
    for blocker in blockers.across {
        let center = each(|k| zero.lift(f64::from(blocker.center[k])) - position[k]);
        let radius = zero.lift(f64::from(blocker.radius));
        let height = dot(center, normal);
        if L::any((-radius).lt(height)) {
            batch[count] = if L::any(height.lt(radius)) {
                replace(center, normal, height, radius)
            } else {
                as_it_is(center, radius)
            };
            counting[count] = blocker;
            count += 1;
            if count == BATCH {
                add_all(&mut sum, batch.iter().zip(counting));
                count = 0;
            }
        }
    }
    add_all(&mut sum, batch.iter().zip(counting).take(count));
    sum
}

/// Adds blockers as they are seen.
#[inline(always)]
fn add_all<'a, L: Lane + 'a, const C: usize>(
    sum: &mut [L; C],
    blockers: impl Iterator<Item = (&'a Seen<L>, &'a Blocker)>,
) where
    [L; C]: Routines<L>,
{
    for (seen, blocker) in blockers {
        // A sine of 0 adds exactly 0.
        *sum = seen.added(sum, &blocker.weights);
    }
}

/// A blocker as the receiver sees it: sine and cosine of its angular radius (0..=90°), and the direction of
/// its centre. A sine of 0 means that it does not count.
#[derive(Clone, Copy)]
pub(crate) struct Seen<L> {
    pub(crate) sine: L,
    pub(crate) cosine: L,
    pub(crate) direction: [L; 3],
}

impl<L: Lane> Seen<L> {
    /// A sphere for a group of receivers: `in_front`, if it lies wholly in front of their tangent planes.
    #[inline(always)]
    pub(crate) fn of(blocker: &Blocker, in_front: bool, position: [L; 3], normal: [L; 3]) -> Self {
        let zero = position[0].lift(0.0);
        let center = each(|k| zero.lift(f64::from(blocker.center[k])) - position[k]);
        let radius = zero.lift(f64::from(blocker.radius));
        if in_front {
            as_it_is(center, radius)
        } else {
            replace(center, normal, dot(center, normal), radius)
        }
    }

    /// `sum`, on the scale of [`Routines::accumulate_blocker`], plus this blocker with its weights.
    #[inline(always)]
    pub(crate) fn added<const C: usize>(&self, sum: &[L; C], weights: &[f32; 8]) -> [L; C]
    where
        [L; C]: Routines<L>,
    {
        let weights = <[L; C]>::zonal_from(
            #[inline(always)]
            |l| self.sine.lift(f64::from(weights[l])),
        );
        sum.accumulate_blocker(self.sine, self.cosine, self.direction, weights)
    }
}

/// A sphere as it is. `center` is seen from the receiver.
#[inline(always)]
fn as_it_is<L: Lane>(center: [L; 3], radius: L) -> Seen<L> {
    let (zero, one) = (radius.lift(0.0), radius.lift(1.0));
    let square = dot(center, center);
    let inverse = one / square.sqrt().max(radius.lift(TINY));
    let beside = (-radius).mul_add(radius, square).max(zero);
    Seen {
        sine: (radius * inverse).min(one),
        cosine: (beside.sqrt() * inverse).min(one),
        direction: each(|k| center[k] * inverse),
    }
}

/// The self-shadow rule of Ren et al. 2006, section 6.2, in a form without jumps.
///
/// `center` is the sphere's centre seen from the receiver, `height` = c its height above the tangent plane. In
/// front (c ≥ r) the sphere counts as it is, behind (c ≤ -r) not at all. Between, a sphere counts that touches
/// the plane from the front at the foot of the centre,
///
/// ```text
/// d = √(r² - c²)                                radius of the circle that the plane cuts from the sphere
/// a = clamp((|foot - p|² / d² - 1) / 3, 0, 1)    0 inside of that circle, 1 from twice its radius on
/// ρ = (1 - a) max(c, 0) + a (r + c) / 2         radius of the sphere that counts, and height of its centre
/// ```
///
/// Ren et al. let a grow with the distance; here it grows with its square, which needs no root.
///
/// The rule has one point of discontinuity, the receiver at the sphere's very centre: there the cap jumps
/// from half the sky to nothing however it is approached, and nothing is what counts.
#[inline(always)]
fn replace<L: Lane>(center: [L; 3], normal: [L; 3], height: L, radius: L) -> Seen<L> {
    let (zero, one, tiny) = (height.lift(0.0), height.lift(1.0), height.lift(TINY));
    let square = dot(center, center);
    let foot_squared = (-height).mul_add(height, square).max(zero);
    let circle_squared = ((radius - height) * (radius + height)).max(tiny);
    let outside = foot_squared / circle_squared - one;
    let a = (outside * height.lift(1.0 / 3.0)).max(zero).min(one);
    // (1 - a) inner + a (r + c) / 2, which is (r + c) / 2 for a = 1.
    let inner = height.max(zero);
    let half = (radius + height) * height.lift(0.5);
    let touching = a.mul_add(half - inner, inner).max(zero);
    // What is not cut is looked at as by `as_it_is`, to the bit: a receiver does not see how others in its group do.
    let cuts = height.lt(radius);
    let counted = L::select(cuts, touching, radius);
    let shift = L::select(cuts, touching - height, zero);
    let distance_squared = L::select(cuts, touching.mul_add(touching, foot_squared), square);
    // Under the foot, where nothing counts, a distance that cancels to 0 would make the direction endless.
    let distance_squared = distance_squared.max(square * height.lift(FOOT));
    let inverse = one / distance_squared.sqrt().max(tiny);
    let sine = (counted * inverse).min(one);
    // The sphere touches the plane at the foot.
    let whole = (-radius).mul_add(radius, square).max(zero);
    let beside = L::select(cuts, foot_squared, whole);
    let counts = (-radius).lt(height);
    Seen {
        sine: L::select(counts, sine, zero),
        cosine: (beside.sqrt() * inverse).min(one),
        direction: each(|k| shift.mul_add(normal[k], center[k]) * inverse),
    }
}

/// Three values. (The standard library's `from_fn` is not always inlined, and would then be compiled without
/// the instruction set.)
#[inline(always)]
pub(crate) fn each<L>(value: impl Fn(usize) -> L) -> [L; 3] {
    [value(0), value(1), value(2)]
}

#[inline(always)]
pub(crate) fn dot<L: Lane>(a: [L; 3], b: [L; 3]) -> L {
    a[0].mul_add(b[0], a[1].mul_add(b[1], a[2] * b[2]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use sh_scene::Sphere;

    /// The largest change of any log coefficient between neighbouring steps of a receiver's way past a sphere
    /// of radius 1 around the origin, in f64.
    fn largest_step(steps: u32, line: fn(f64) -> [[f64; 3]; 2]) -> f64 {
        let ball = [Blocker::new(Sphere {
            center: [0.0; 3],
            radius: 1.0,
        })];
        let at = |i: u32| {
            let [position, normal] = line(f64::from(i) / f64::from(steps));
            let length = dot(normal, normal).sqrt();
            accumulated(
                &[0.0; 16],
                position,
                normal.map(|x| x / length),
                Blockers {
                    front: &[],
                    across: &ball,
                },
            )
        };
        let change = |i: u32| {
            let (a, b) = (at(i), at(i + 1));
            a.iter()
                .zip(b)
                .map(|(a, b)| (a - b).abs())
                .fold(0.0, f64::max)
        };
        (0..steps).map(change).fold(0.0, f64::max)
    }

    #[test]
    fn the_log_visibility_has_no_jump() {
        type Line = fn(f64) -> [[f64; 3]; 2];
        let lines: [(&str, Line); 6] = [
            ("out along the plane, centre in front", |t| {
                [[0.05 + 3.0 * t, -0.4, 0.1], [0.0, 1.0, 0.0]]
            }),
            ("out along the plane, centre behind", |t| {
                [[0.05 + 3.0 * t, 0.4, 0.1], [0.0, 1.0, 0.0]]
            }),
            ("from wholly in front to wholly behind, inside", |t| {
                [[0.3, -1.5 + 3.0 * t, 0.2], [0.0, 1.0, 0.0]]
            }),
            ("from wholly in front to wholly behind, beside", |t| {
                [[1.4, -1.5 + 3.0 * t, 0.2], [0.0, 1.0, 0.0]]
            }),
            ("out through the side at a slant", |t| {
                [[-0.2 + 2.0 * t, -0.5 + t, 0.3], [0.3, 1.0, -0.2]]
            }),
            ("turning in place", |t| {
                let (sin, cos) = (6.0 * t).sin_cos();
                [[1.3, 0.2, 0.0], [sin, cos, 0.2]]
            }),
        ];
        for (name, line) in lines {
            // 64 times finer steps: a slope's steps become 64 times smaller, those of a square root 8 times,
            // those of a jump stay.
            let (coarse, fine) = (largest_step(500, line), largest_step(32_000, line));
            assert!(coarse > 1e-4, "{name}: nothing happens");
            assert!(fine < coarse / 7.0, "{name}: {coarse} then {fine}");
        }
    }

    #[test]
    fn in_front_both_ways_agree() {
        let ball = [Blocker::new(Sphere {
            center: [0.4, 3.0, -0.2],
            radius: 1.2,
        })];
        let sum = |front: &[Blocker], across: &[Blocker]| {
            let blockers = Blockers { front, across };
            accumulated(&[0.5; 25], [0.1_f64, 0.2, 0.3], [0.0, 1.0, 0.0], blockers)
        };
        let (front, across) = (sum(&ball, &[]), sum(&[], &ball));
        for (a, b) in front.iter().zip(across) {
            assert!((a - b).abs() < 1e-12, "{a} {b}");
        }
    }

    #[test]
    fn the_rule_replaces_spheres_as_stated() {
        let blocker =
            |center: [f64; 3], radius: f64| replace(center, [0.0, 1.0, 0.0], center[1], radius);
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{a} is not {b}");
        // In front: as it is, sin θ = r / D.
        let whole = blocker([3.0, 4.0, 0.0], 2.0);
        near(whole.sine, 0.4);
        near(whole.cosine, 0.84_f64.sqrt());
        near(whole.direction[1], 0.8);
        // Behind, and touching from behind: nothing.
        assert_eq!(blocker([3.0, -2.5, 0.0], 2.0).sine, 0.0);
        assert_eq!(blocker([3.0, -2.0, 0.0], 2.0).sine, 0.0);
        // Cut, receiver inside the circle (radius √(25 - 9) = 4): radius max(c, 0), touching the plane.
        let inside = blocker([1.0, 3.0, 0.0], 5.0);
        near(inside.sine, 3.0 / 10.0_f64.sqrt());
        near(inside.cosine, 1.0 / 10.0_f64.sqrt());
        assert_eq!(blocker([1.0, -3.0, 0.0], 5.0).sine, 0.0);
        // From twice the circle's radius on: radius (r + c) / 2.
        let outside = blocker([8.0, -3.0, 0.0], 5.0);
        near(outside.sine, 1.0 / 65.0_f64.sqrt());
        near(outside.direction[0], 8.0 / 65.0_f64.sqrt());
        // Half way between in squares, half of each: ρ = (1 - ½)·3 + ½·(5 + 3)/2.
        let between = blocker([40.0_f64.sqrt(), 3.0, 0.0], 5.0);
        near(between.sine, 3.5 / (40.0 + 3.5 * 3.5_f64).sqrt());
    }
}
