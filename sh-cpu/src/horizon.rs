//! Lamps below the horizon of a whole cluster.
//!
//! A receiver with normal N in the open gets of a lamp in direction d, in the bands of the light's order,
//!
//! ```text
//! f(x, s) = Σ_l z_l(s) h_l P_l(x)      x = N · d,   s = the square of the sine of the lamp's angular radius
//! ```
//!
//! with the zonal coefficients z of the lamp and h of the cosine lobe. The shadow pass holds what a lamp gives within 0
//! and f, so that where f is not above 0 it gives exactly 0, whatever blocks it, and needs no computing. A cluster's
//! bounds say where x and s lie; f is looked at in steps, with what it may rise by in between.
//!
//! At orders 5 and 6 f is below 0 for all that faces away from a lamp by more than 108°; at order 4 it is from 116° to
//! 160°, and farther away some light leaks through, which is computed. At orders 2 and 3 the lobe is so wide that
//! nothing is dark.

use glam::Vec3;
use sh_core::{Routines, cap};
use sh_scene::{Bounds, Emitter};

/// Steps in which the range of x is looked at.
const STEPS: usize = 32;

/// f over z_0 h_0 has to be below minus this, so that what single precision computes is not above 0.
const MARGIN: f64 = 1e-4;

/// The largest s, up to which f is nearly a straight line in it.
const LARGEST: f64 = 0.5;

/// Nothing that faces a lamp more than this is below the horizon at any order.
const HIGHEST: f64 = -0.2;

/// Whether a lamp gives nothing to any receiver within these bounds.
pub(crate) fn is_below(emitter: &Emitter, bounds: &Bounds, order: usize) -> bool {
    let center = Vec3::from(emitter.center);
    let towards = center - emitter.local * bounds.center;
    let (distance, reach) = (towards.length(), emitter.local * bounds.radius);
    // Rounding of the bounds and of single precision moves them by less.
    let reach = reach + 1e-5 * (reach + distance);
    if !(distance > reach && distance.is_finite()) {
        return false;
    }
    let [cosine, sine] = bounds.cone.map(f64::from);
    let normals = sine.atan2(cosine);
    let spread = f64::from(reach / distance).asin();
    let middle = f64::from(towards.dot(bounds.axis) / distance)
        .clamp(-1.0, 1.0)
        .acos();
    let least = (middle - normals - spread).max(0.0).cos();
    let most = (middle + normals + spread).min(std::f64::consts::PI).cos();
    let square = |distance: f32| (f64::from(emitter.radius) / f64::from(distance)).powi(2);
    let squares = [square(distance + reach), square(distance - reach)];
    // What is not a number is not below.
    if !(least < HIGHEST && squares[1] < LARGEST) {
        return false;
    }
    let bend = squares[1] - squares[0];
    squares.iter().all(|&square| {
        let weights = weights(emitter, square, order);
        let step = (least - most) / STEPS as f64;
        let rise = curvature(&weights) * step * step / 8.0 + bend * bend / 8.0;
        (0..=STEPS).all(|i| value(&weights, most + step * i as f64) + rise < -MARGIN)
    })
}

/// z_l h_l over z_0 h_0.
fn weights(emitter: &Emitter, square: f64, order: usize) -> [f64; 6] {
    let hidden = cap::visibility::<36>(square.sqrt().asin());
    let cosine = (1.0 - square).max(0.0).sqrt();
    let mean = square / (1.0 + cosine) * 0.5 * sh_core::ROOT_FOUR_PI;
    let lobe = <[f64; 36]>::cosine([0.0, 0.0, 1.0]);
    let mut all = [0.0; 6];
    for (l, weight) in all.iter_mut().enumerate().take(order) {
        let shown = if l == 0 { mean } else { -hidden[l] };
        *weight = shown * f64::from(emitter.gains[l]) * lobe[l * l + l];
    }
    let first = all[0];
    all.map(|weight| weight / first)
}

/// Σ w_l P_l(x).
fn value(weights: &[f64; 6], x: f64) -> f64 {
    let (mut before, mut now, mut sum) = (0.0, 1.0, 0.0);
    for (l, weight) in weights.iter().enumerate() {
        sum += weight * now;
        // (l + 1) P_(l+1) = (2l + 1) x P_l − l P_(l−1)
        let next = ((2 * l + 1) as f64 * x * now - l as f64 * before) / (l + 1) as f64;
        (before, now) = (now, next);
    }
    sum
}

/// No second derivative of Σ w_l P_l is larger: that of P_l is largest at 1, (l − 1) l (l + 1) (l + 2) / 8.
fn curvature(weights: &[f64; 6]) -> f64 {
    let of = |(l, weight): (usize, &f64)| {
        let l = l as f64;
        weight.abs() * (l - 1.0) * l * (l + 1.0) * (l + 2.0) / 8.0
    };
    weights.iter().enumerate().map(of).sum()
}
