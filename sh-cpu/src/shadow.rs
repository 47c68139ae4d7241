//! The shadow pass: environment light through the visibility of all blocker spheres (Ren et al. 2006,
//! "Real-time soft shadows in dynamic scenes using spherical harmonic exponentiation").
//!
//! For a receiver at p with normal N, with one blocker after another:
//! 1. the self-shadow rule says which sphere counts in its place ([`replace`]),
//! 2. the logarithm of that sphere's visibility, a zonal function of its angular radius, is turned towards it
//!    and added: f += F(θ) y(s) (equation 34).
//!
//! Then g = exp(f) (section 4) is the visibility of all blockers together, and a channel's radiance is the
//! triple product of light, cosine lobe and visibility, (L, H(N), g) = L · (g * H(N)), held between 0 and the
//! radiance without blockers.
//!
//! Cost per receiver and sphere at order 4: about 150 operations, 2 divisions and 4 square roots, of which a
//! sphere wholly in front needs half. A sphere behind the tangent planes of all receivers in a group of
//! lanes costs one dot product.

use crate::drive::{Kernel, drive};
use crate::exponential::exponential;
use crate::irradiance::{light_dot, unblocked};
use crate::outline::Outline;
use crate::{Error, Path};
use sh_core::{Lane, Routines};
use sh_scene::{Light, Receiver, Sphere};

/// Smallest divisor, in metres: far below any distance that matters, far above the point where its
/// reciprocal overflows.
const TINY: f64 = 1e-30;

/// Writes the radiance that albedo 1 reflects at every receiver under `light`, shadowed by `spheres`.
/// Receivers that are not covered get 0. Every value lies between 0 and that of [`crate::irradiance`].
pub fn shadow(
    receivers: &[Receiver],
    spheres: &[Sphere],
    light: &Light,
    radiance: &mut [[f32; 3]],
) -> Result<(), Error> {
    shadow_on(Path::best(), receivers, spheres, light, radiance)
}

/// [`shadow`] on a vector path of the caller's choice.
pub fn shadow_on(
    path: Path,
    receivers: &[Receiver],
    spheres: &[Sphere],
    light: &Light,
    radiance: &mut [[f32; 3]],
) -> Result<(), Error> {
    drive(
        path,
        receivers,
        light,
        radiance,
        &Shadowed {
            spheres,
            light: &light.coefficients,
        },
    )
}

struct Shadowed<'a> {
    spheres: &'a [Sphere],
    light: &'a [[f32; 3]],
}

impl Kernel for Shadowed<'_> {
    #[inline(always)]
    fn shade<L: Outline<C>, const C: usize>(&self, position: [L; 3], normal: [L; 3]) -> [L; 3]
    where
        [L; C]: Routines<L>,
    {
        shade::<L, C>(position, normal, self.spheres, self.light)
    }
}

/// Radiance of albedo 1 in three channels, for one group of receivers.
#[inline(always)]
pub fn shade<L: Outline<C>, const C: usize>(
    position: [L; 3],
    normal: [L; 3],
    spheres: &[Sphere],
    light: &[[f32; 3]],
) -> [L; 3]
where
    [L; C]: Routines<L>,
{
    let zero = position[0].lift(0.0);
    let log_visibility = accumulate::<L, C>(position, normal, spheres);
    let visibility = exponential(&log_visibility);
    let open = unblocked::<L, C>(normal, light);
    let shadowed = light_dot(&L::product_cosine(&visibility, normal), light);
    // A sum of blockers beyond the range of the series is not a number, and fails the comparison.
    core::array::from_fn(|c| L::select(zero.lt(shadowed[c]), shadowed[c].min(open[c]), zero))
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
    for sphere in spheres {
        let center: [L; 3] =
            core::array::from_fn(|k| zero.lift(f64::from(sphere.center[k])) - position[k]);
        let radius = zero.lift(f64::from(sphere.radius));
        let height = dot(center, normal);
        if !L::any((-radius).lt(height)) {
            continue;
        }
        let blocker = replace(center, normal, height, radius);
        // A sine of 0 adds exactly 0.
        sum = sum.add_cap_log(blocker.sine, blocker.cosine, blocker.direction);
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
    let foot: [L; 3] = core::array::from_fn(|k| center[k] - height * normal[k]);
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
    let direction: [L; 3] = core::array::from_fn(|k| foot[k] + raised * normal[k]);
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
        direction: direction.map(|x| x * inverse),
    }
}

#[inline(always)]
fn dot<L: Lane>(a: [L; 3], b: [L; 3]) -> L {
    a[0].mul_add(b[0], a[1].mul_add(b[1], a[2] * b[2]))
}
