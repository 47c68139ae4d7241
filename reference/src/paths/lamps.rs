//! Discs in the sky and glowing balls, as shapes or as the SH vectors that the passes have in their place.
//!
//! A ball with a distribution is as bright as that says where a line of sight meets its surface. In the passes' place it
//! has the mean radiance of what is seen of it (Guerrero et al. 2008, equations 16 to 18, by solid angle), in the bands
//! that they have.

use crate::ball;
use crate::basis::basis;
use crate::cap;
use crate::horizon;
use crate::vec3::{Vec3, add, dot, frame, length, scale, sub, widen};
use crate::zonal;
use sh_scene::{Distribution, Emitter};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::sync::OnceLock;

/// What a point sees of it is a cap of the sphere of directions.
pub(super) struct Lamp {
    /// Towards a distant light, or the centre of a ball.
    center: Vec3,
    /// Sine of a distant light's angular radius, or the radius of a ball.
    radius: f64,
    local: bool,
    radiance: [f64; 3],
    gains: Vec<f64>,
    /// How bright it is where, in parts of the radiance: SH coefficients; none of an even one.
    distribution: Vec<[f64; 3]>,
}

/// A direction towards a lamp.
pub(super) struct Sample {
    pub direction: Vec3,
    /// What comes from there.
    pub radiance: [f64; 3],
    /// Density of the draw, per steradian.
    pub density: f64,
    /// Metres to the lamp: what lies farther away is not in its light's way.
    pub distance: f64,
}

impl Lamp {
    /// The lamp that a pass of this order has, but with all of its distribution where one is given.
    pub fn new(emitter: &Emitter, order: usize, whole: Option<&Distribution>) -> Self {
        let of_pass = emitter.distribution[..order * order].iter();
        let distribution = match whole {
            _ if emitter.order == 0 => Vec::new(),
            Some(whole) => whole.coefficients().map(|k| k.map(f64::from)).to_vec(),
            None => of_pass
                .map(|&[r, g, b, _]| [r, g, b].map(f64::from))
                .collect(),
        };
        Self {
            distribution,
            center: widen(emitter.center),
            radius: f64::from(emitter.radius),
            local: emitter.local != 0.0,
            radiance: emitter.radiance.map(f64::from),
            gains: emitter.gains[..order]
                .iter()
                .map(|g| f64::from(*g))
                .collect(),
        }
    }

    /// A direction of the cap, drawn evenly by two numbers in 0..1. Inside a ball every direction ends at it.
    pub fn sample(&self, from: Vec3, [u, v]: [f64; 2]) -> Sample {
        let towards = self.towards(from);
        let far = length(towards);
        // 1 − the cosine of the cap's radius, without cancellation.
        let height = if far <= self.radius {
            2.0
        } else {
            let sine = self.radius / far;
            sine * sine / (1.0 + (1.0 - sine * sine).sqrt())
        };
        let axis = unit(towards);
        let [x, y] = frame(axis);
        let depth = u * height;
        let flat = (depth * (2.0 - depth)).max(0.0).sqrt();
        let (sin, cos) = (TAU * v).sin_cos();
        let aside = add(scale(x, flat * cos), scale(y, flat * sin));
        let direction = add(scale(axis, 1.0 - depth), aside);
        let distance = self.surface(towards, direction);
        Sample {
            direction,
            radiance: self.shown(sub(scale(direction, distance), towards)),
            density: 1.0 / (TAU * height),
            distance,
        }
    }

    /// The radiance of the surface in a direction from the centre, of any length.
    fn shown(&self, from_center: Vec3) -> [f64; 3] {
        if self.distribution.is_empty() {
            return self.radiance;
        }
        let basis = basis(self.distribution.len().isqrt(), unit(from_center));
        self.weighed(&basis)
    }

    /// The mean radiance of what is seen of it.
    fn mean(&self, towards: Vec3) -> [f64; 3] {
        if self.distribution.is_empty() {
            return self.radiance;
        }
        let angle = (self.radius / length(towards)).min(1.0).asin();
        let means = means(angle);
        let back = unit(scale(towards, -1.0));
        let mut weights = basis(self.distribution.len().isqrt(), back);
        for (i, weight) in weights.iter_mut().enumerate() {
            *weight *= means[i.isqrt()];
        }
        self.weighed(&weights)
    }

    /// The distribution dotted with weights, not below 0, times the radiance.
    fn weighed(&self, weights: &[f64]) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (y, coefficient) in weights.iter().zip(&self.distribution) {
            sum = add(sum, scale(*coefficient, *y));
        }
        std::array::from_fn(|c| sum[c].max(0.0) * self.radiance[c])
    }

    /// How far its surface is in a direction that meets it: the near side from outside, the far side from inside.
    fn surface(&self, towards: Vec3, direction: Vec3) -> f64 {
        if !self.local {
            return f64::INFINITY;
        }
        let along = dot(towards, direction);
        let inside = dot(towards, towards) - self.radius * self.radius;
        let half = (along * along - inside).max(0.0).sqrt();
        if inside > 0.0 {
            along - half
        } else {
            along + half
        }
    }

    /// The lobe that stands for it among the passes, seen from a point with a normal: of that size that it gives as much in
    /// the open as the lamp does.
    pub fn lobe(&self, from: Vec3, normal: Vec3) -> Lobe {
        let towards = self.towards(from);
        let far = length(towards);
        let angle = (self.radius / far.max(f64::MIN_POSITIVE)).min(1.0).asin();
        let bands = cap::blocked(self.gains.len(), angle);
        let bands: Vec<f64> = bands.iter().zip(&self.gains).map(|(z, g)| z * g).collect();
        let axis = unit(towards);
        let (sine, facing) = (angle.sin().max(f64::MIN_POSITIVE), dot(axis, normal));
        let shown = horizon::share(facing / sine, 1.0 / sine);
        let lobe = zonal::cosine(bands.len(), normal);
        let open: f64 = zonal::rotated(&bands, axis)
            .iter()
            .zip(&lobe)
            .map(|(a, b)| a * b)
            .sum();
        let size = if open > 0.0 { shown / open } else { 0.0 };
        Lobe {
            radiance: scale(self.mean(towards), size),
            axis,
            bands,
            distance: if self.local { far } else { f64::INFINITY },
        }
    }

    fn towards(&self, from: Vec3) -> Vec3 {
        if self.local {
            sub(self.center, from)
        } else {
            self.center
        }
    }
}

/// [`ball::means`] of six bands, for an angular radius from 0 to π/2: between steps of a third of a degree, where they
/// are off by less than 1e-4.
fn means(angle: f64) -> [f64; 6] {
    const STEPS: usize = 270;
    static TABLE: OnceLock<Vec<[f64; 6]>> = OnceLock::new();
    let table = TABLE.get_or_init(|| {
        let step = |i: usize| {
            let sine = (FRAC_PI_2 * i as f64 / STEPS as f64).sin();
            let means = ball::means(6, sine.min(1.0 - 1e-9));
            std::array::from_fn(|l| means[l])
        };
        (0..=STEPS).map(step).collect()
    });
    let place = (angle / FRAC_PI_2 * STEPS as f64).clamp(0.0, STEPS as f64);
    let below = (place as usize).min(STEPS - 1);
    let part = place - below as f64;
    std::array::from_fn(|l| table[below][l] * (1.0 - part) + table[below + 1][l] * part)
}

/// A lamp's windowed SH vector. Its value in a direction is a share of the lamp's radiance, which may be negative
/// where it rings.
pub(super) struct Lobe {
    /// That of the lamp, as far as it is seen.
    pub radiance: [f64; 3],
    axis: Vec3,
    bands: Vec<f64>,
    /// Metres to the lamp's centre.
    pub distance: f64,
}

impl Lobe {
    pub fn value(&self, direction: Vec3) -> f64 {
        zonal::evaluate(&self.bands, dot(self.axis, direction).clamp(-1.0, 1.0))
    }
}

fn unit(v: Vec3) -> Vec3 {
    let length = length(v);
    if length > 0.0 {
        scale(v, 1.0 / length)
    } else {
        // At the centre of a ball every direction is as good.
        [0.0, 1.0, 0.0]
    }
}

/// A direction about a normal in proportion to the cosine with it (density cos/π), drawn by two numbers in 0..1.
pub(super) fn cosine(normal: Vec3, [u, v]: [f64; 2]) -> Vec3 {
    let [x, y] = frame(normal);
    let (sin, cos) = (TAU * v).sin_cos();
    let flat = u.sqrt();
    let aside = add(scale(x, flat * cos), scale(y, flat * sin));
    add(aside, scale(normal, (1.0 - u).max(0.0).sqrt()))
}

/// The density of [`cosine`], per steradian; 0 below the surface.
pub(super) fn cosine_density(normal: Vec3, direction: Vec3) -> f64 {
    dot(normal, direction).max(0.0) / PI
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_between_steps_are_those_of_rays() {
        for i in 0..100 {
            let angle = FRAC_PI_2 * (f64::from(i) + 0.37) / 100.0;
            let exact = ball::means(6, angle.sin());
            for (found, exact) in means(angle).iter().zip(exact) {
                assert!((found - exact).abs() < 1e-4, "{angle}: {found} {exact}");
            }
        }
    }
}
