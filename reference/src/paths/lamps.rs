//! Discs in the sky and glowing balls, as shapes or as the SH vectors that the passes have in their place.

use crate::cap;
use crate::vec3::{Vec3, add, dot, frame, length, scale, sub, widen};
use crate::zonal;
use sh_scene::Emitter;
use std::f64::consts::{PI, TAU};

/// A light of even radiance: what a point sees of it is a cap of the sphere of directions.
pub(super) struct Lamp {
    /// Towards a distant light, or the centre of a ball.
    center: Vec3,
    /// Sine of a distant light's angular radius, or the radius of a ball.
    radius: f64,
    local: bool,
    pub radiance: [f64; 3],
    gains: Vec<f64>,
}

/// A direction towards a lamp.
pub(super) struct Sample {
    pub direction: Vec3,
    /// Density of the draw, per steradian.
    pub density: f64,
    /// Metres to the lamp: what lies farther away is not in its light's way.
    pub distance: f64,
}

impl Lamp {
    pub fn new(emitter: &Emitter, order: usize) -> Self {
        Self {
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
        Sample {
            direction,
            density: 1.0 / (TAU * height),
            distance: self.surface(towards, direction),
        }
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

    /// The lobe that stands for it among the passes, seen from a point.
    pub fn lobe(&self, from: Vec3) -> Lobe {
        let towards = self.towards(from);
        let far = length(towards);
        let angle = (self.radius / far.max(f64::MIN_POSITIVE)).min(1.0).asin();
        let bands = cap::blocked(self.gains.len(), angle);
        Lobe {
            axis: unit(towards),
            bands: bands.iter().zip(&self.gains).map(|(z, g)| z * g).collect(),
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

/// A lamp's windowed SH vector. Its value in a direction is a share of the lamp's radiance, which may be negative
/// where it rings.
pub(super) struct Lobe {
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
