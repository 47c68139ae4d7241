//! The shadow pass: environment light through the visibility of all blocker spheres (Ren et al. 2006,
//! "Real-time soft shadows in dynamic scenes using spherical harmonic exponentiation").
//!
//! For a receiver at p with normal N, with one blocker after another:
//! 1. the self-shadow rule says which sphere counts in its place ([`replace`]),
//! 2. the logarithm of that sphere's visibility, a zonal function of its angular radius, is turned towards it
//!    and added: f += F(θ) y(s) (equation 34).
//!
//! Then g = exp(f) (section 4, by [`Routines::exp_saturating`]) is the visibility of all blockers together, and
//! a channel's radiance is the triple product of light, cosine lobe and visibility,
//! (L, H(N), g) = L · (g * H(N)), held between 0 and the radiance without blockers.
//!
//! Steps 1 and 2 and the exponential may be of a higher order than the light, the order of accumulation: of
//! the visibility that they give, the bands that the light has are more accurate than those of a sum that
//! was cut off before the exponential, which couples all bands.
//!
//! Cost per receiver and sphere at order 4: about 150 operations, 2 divisions and 4 square roots, of which a
//! sphere wholly in front needs half. A sphere behind the tangent planes of all receivers in a group of
//! lanes costs one dot product.

use crate::drive::{Kernel, MAX_ORDER, check_light, drive};
use crate::irradiance::{reflected, unblocked};
use crate::outline::{Outline, OutlineAll};
use crate::{Error, Path};
use sh_core::{Lane, Routines};
use sh_scene::{Light, Receiver, Sphere};

/// Smallest divisor, in metres: far below any distance that matters, far above the point where its
/// reciprocal overflows.
const TINY: f64 = 1e-30;

/// Spheres whose replacements are worked out before any is added: the chain of square roots and divisions of
/// one is long, and in a short loop of their own the processor overlaps several.
const BATCH: usize = 32;

/// Writes the radiance that albedo 1 reflects at every receiver under `light`, shadowed by `spheres`.
/// Receivers that are not covered get 0. Every value lies between 0 and that of [`crate::irradiance`].
///
/// `accumulation` is the order in which the blockers' logarithms are summed and exponentiated, from the light's
/// order to 6; the cost of a blocker grows with its square.
///
/// # Errors
/// Where an order is none that there is, or a length does not fit; nothing is written then.
pub fn shadow(
    receivers: &[Receiver],
    spheres: &[Sphere],
    light: &Light,
    accumulation: usize,
    radiance: &mut [[f32; 3]],
) -> Result<(), Error> {
    let path = Path::best();
    shadow_on(path, receivers, spheres, light, accumulation, radiance)
}

/// [`shadow`] on a vector path of the caller's choice.
pub fn shadow_on(
    path: Path,
    receivers: &[Receiver],
    spheres: &[Sphere],
    light: &Light,
    accumulation: usize,
    radiance: &mut [[f32; 3]],
) -> Result<(), Error> {
    check_light(light)?;
    if !(light.order..=MAX_ORDER).contains(&accumulation) {
        return Err(Error::Accumulation {
            order: light.order,
            accumulation,
        });
    }
    drive(
        path,
        receivers,
        light,
        radiance,
        &Shadowed {
            spheres,
            light: &light.coefficients,
            accumulation,
        },
    )
}

struct Shadowed<'a> {
    spheres: &'a [Sphere],
    light: &'a [[f32; 3]],
    accumulation: usize,
}

impl Kernel for Shadowed<'_> {
    #[inline(always)]
    fn shade<L: OutlineAll + Outline<C>, const C: usize>(
        &self,
        position: [L; 3],
        normal: [L; 3],
    ) -> [L; 3]
    where
        [L; C]: Routines<L>,
    {
        shade::<L, C>(
            position,
            normal,
            self.spheres,
            self.light,
            self.accumulation,
        )
    }
}

/// Radiance of albedo 1 in three channels, for one group of receivers under light of `C` coefficients;
/// `accumulation` as in [`shadow`].
#[inline(always)]
pub fn shade<L: OutlineAll + Outline<C>, const C: usize>(
    position: [L; 3],
    normal: [L; 3],
    spheres: &[Sphere],
    light: &[[f32; 3]],
    accumulation: usize,
) -> [L; 3]
where
    [L; C]: Routines<L>,
{
    let zero = position[0].lift(0.0);
    let mut visibility = [zero; C];
    match accumulation {
        2 => lower_bands::<L, 4>(position, normal, spheres, &mut visibility),
        3 => lower_bands::<L, 9>(position, normal, spheres, &mut visibility),
        4 => lower_bands::<L, 16>(position, normal, spheres, &mut visibility),
        5 => lower_bands::<L, 25>(position, normal, spheres, &mut visibility),
        _ => lower_bands::<L, 36>(position, normal, spheres, &mut visibility),
    }
    let open = unblocked::<L, C>(normal, light);
    let shadowed = reflected(
        &<L as Outline<C>>::product_cosine(&visibility, normal),
        light,
    );
    // What is not a number fails the comparison.
    each(|c| L::select(zero.lt(shadowed[c]), shadowed[c].min(open[c]), zero))
}

/// The first coefficients of the visibility that is accumulated with `A` of them.
#[inline(always)]
fn lower_bands<L: Outline<A>, const A: usize>(
    position: [L; 3],
    normal: [L; 3],
    spheres: &[Sphere],
    visibility: &mut [L],
) where
    [L; A]: Routines<L>,
{
    let accumulated = L::visibility(position, normal, spheres);
    for (slot, coefficient) in visibility.iter_mut().zip(accumulated) {
        *slot = coefficient;
    }
}

/// The visibility past all blockers together, with `C` coefficients: what [`Outline::visibility`] computes,
/// to be inlined there.
#[inline(always)]
pub(crate) fn visibility_past<L: Lane, const C: usize>(
    position: [L; 3],
    normal: [L; 3],
    spheres: &[Sphere],
) -> [L; C]
where
    [L; C]: Routines<L>,
{
    accumulate::<L, C>(position, normal, spheres).exp_saturating()
}

/// The sum of the blockers' log visibilities.
#[inline(always)]
fn accumulate<L: Lane, const C: usize>(
    position: [L; 3],
    normal: [L; 3],
    spheres: &[Sphere],
) -> [L; C]
where
    [L; C]: Routines<L>,
{
    let zero = position[0].lift(0.0);
    let mut sum = [zero; C];
    let nothing = Blocker {
        sine: zero,
        cosine: zero,
        direction: [zero; 3],
    };
    let mut batch = [nothing; BATCH];
    for spheres in spheres.chunks(BATCH) {
        let mut count = 0;
        for sphere in spheres {
            let center = each(|k| zero.lift(f64::from(sphere.center[k])) - position[k]);
            let radius = zero.lift(f64::from(sphere.radius));
            let height = dot(center, normal);
            if L::any((-radius).lt(height)) {
                batch[count] = replace(center, normal, height, radius);
                count += 1;
            }
        }
        for blocker in &batch[..count] {
            // A sine of 0 adds exactly 0.
            sum = sum.add_cap_log_saturating(blocker.sine, blocker.cosine, blocker.direction);
        }
    }
    sum
}

/// A blocker as the receiver sees it: sine and cosine of its angular radius (0..=90°), and the direction of
/// its centre. A sine of 0 means that it does not count.
#[derive(Clone, Copy)]
struct Blocker<L> {
    sine: L,
    cosine: L,
    direction: [L; 3],
}

/// The self-shadow rule of Ren et al. 2006, section 6.2, in a form without jumps.
///
/// `center` is the sphere's centre seen from the receiver, `height` = c its height above the tangent plane. In
/// front (c ≥ r) the sphere counts as it is, behind (c ≤ -r) not at all. Between, a sphere counts that touches
/// the plane from the front at the foot of the centre,
///
/// ```text
/// d = √(r² - c²)                                radius of the circle that the plane cuts from the sphere
/// a = clamp((|foot - p| - d) / d, 0, 1)         0 inside of that circle, 1 from twice its radius on
/// ρ = (1 - a) max(c, 0) + a (r + c) / 2         radius of the sphere that counts, and height of its centre
/// ```
///
/// The rule has one point of discontinuity, the receiver at the sphere's very centre: there the cap jumps
/// from half the sky to nothing however it is approached, and nothing is what counts.
#[inline(always)]
fn replace<L: Lane>(center: [L; 3], normal: [L; 3], height: L, radius: L) -> Blocker<L> {
    let (zero, one, tiny) = (height.lift(0.0), height.lift(1.0), height.lift(TINY));
    let foot = each(|k| center[k] - height * normal[k]);
    let foot_squared = dot(foot, foot);
    // Where no receiver's plane cuts the sphere, most of the time, this is all that is needed.
    let (mut counted, mut raised) = (radius, height);
    if L::any(height.lt(radius)) {
        let circle = ((radius - height) * (radius + height)).max(zero).sqrt();
        let outside = (foot_squared.sqrt() - circle) / circle.max(tiny);
        let a = outside.max(zero).min(one);
        let touching = (one - a) * height.max(zero) + a * (radius + height) * height.lift(0.5);
        let touching = touching.max(zero);
        let cuts = height.lt(radius);
        counted = L::select(cuts, touching, radius);
        raised = L::select(cuts, touching, height);
    }
    let direction = each(|k| foot[k] + raised * normal[k]);
    let distance = (foot_squared + raised * raised).sqrt();
    let inverse = one / distance.max(tiny);
    // distance² - radius², without the cancellation where the sphere touches the plane.
    let tangent = (foot_squared + (raised - counted) * (raised + counted))
        .max(zero)
        .sqrt();
    let counts = (-radius).lt(height);
    Blocker {
        sine: L::select(counts, (counted * inverse).min(one), zero),
        cosine: (tangent * inverse).min(one),
        direction: each(|k| direction[k] * inverse),
    }
}

/// Three values. (The standard library's `from_fn` is not always inlined, and would then be compiled without
/// the instruction set.)
#[inline(always)]
fn each<L>(value: impl Fn(usize) -> L) -> [L; 3] {
    [value(0), value(1), value(2)]
}

#[inline(always)]
fn dot<L: Lane>(a: [L; 3], b: [L; 3]) -> L {
    a[0].mul_add(b[0], a[1].mul_add(b[1], a[2] * b[2]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The largest change of any log coefficient between neighbouring steps of a receiver's way past a sphere
    /// of radius 1 around the origin, in f64.
    fn largest_step(steps: u32, line: fn(f64) -> [[f64; 3]; 2]) -> f64 {
        let ball = [Sphere {
            center: [0.0; 3],
            radius: 1.0,
        }];
        let at = |i: u32| {
            let [position, normal] = line(f64::from(i) / f64::from(steps));
            let length = dot(normal, normal).sqrt();
            accumulate::<f64, 16>(position, normal.map(|x| x / length), &ball)
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
        // Half way between, half of each: ρ = (1 - ½)·3 + ½·(5 + 3)/2.
        let between = blocker([6.0, 3.0, 0.0], 5.0);
        near(between.sine, 3.5 / (36.0 + 3.5 * 3.5_f64).sqrt());
    }
}
