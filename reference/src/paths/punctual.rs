//! Spots, points and suns: balls and discs of even radiance, or places without a size.

use super::lamps::Sample;
use crate::vec3::{Vec3, add, dot, frame, length, scale, sub, widen};
use sh_scene::PunctualRecord;
use std::f64::consts::{PI, TAU};

/// A light, as its record has it.
pub(super) struct Punctual {
    position: Vec3,
    radius: f64,
    axis: Vec3,
    outer: f64,
    steep: f64,
    intensity: [f64; 3],
    distant: bool,
}

impl Punctual {
    pub fn new(record: &PunctualRecord) -> Self {
        Self {
            position: widen(record.position),
            radius: f64::from(record.radius),
            axis: widen(record.axis),
            outer: f64::from(record.outer),
            steep: f64::from(record.steep),
            intensity: record.radiance.map(|c| f64::from(c) * PI),
            distant: record.distant != 0.0,
        }
    }

    /// A direction towards it, drawn evenly over what is seen of it by two numbers in 0..1; of one without a size the only one there
    /// is, and its irradiance across that in the place of radiance over a density.
    pub fn sample(&self, from: Vec3, [u, v]: [f64; 2]) -> Sample {
        let towards = match self.distant {
            true => self.position,
            false => sub(self.position, from),
        };
        let far = length(towards).max(1e-9);
        let axis = scale(towards, 1.0 / far);
        // In the cone, what the whole ball gives is that of its middle.
        let cosine = -dot(axis, self.axis);
        let within = ((self.outer - (1.0 - cosine)) * self.steep).clamp(0.0, 1.0);
        let fade = if self.distant { 1.0 } else { within * within };
        // The sine of the angular radius.
        let sine = match self.distant {
            true => self.radius / (1.0 + self.radius * self.radius).sqrt(),
            false => (self.radius / far).min(1.0),
        };
        if sine == 0.0 {
            let square = if self.distant { 1.0 } else { far * far };
            return Sample {
                direction: axis,
                radiance: scale(self.intensity, fade / square),
                density: 1.0,
                distance: if self.distant { f64::INFINITY } else { far },
            };
        }
        let height = sine * sine / (1.0 + (1.0 - sine * sine).sqrt());
        let [x, y] = frame(axis);
        let depth = u * height;
        let flat = (depth * (2.0 - depth)).max(0.0).sqrt();
        let (sin, cos) = (TAU * v).sin_cos();
        let aside = add(scale(x, flat * cos), scale(y, flat * sin));
        let direction = add(scale(axis, 1.0 - depth), aside);
        // A disc's irradiance is that of its radiance over π sin²; a ball's intensity that over π r².
        let area = match self.distant {
            true => PI * sine * sine,
            false => PI * self.radius * self.radius,
        };
        let along = dot(towards, direction);
        let inside = dot(towards, towards) - self.radius * self.radius;
        Sample {
            direction,
            radiance: scale(self.intensity, fade / area),
            density: 1.0 / (TAU * height),
            distance: match self.distant {
                true => f64::INFINITY,
                false => along - (along * along - inside).max(0.0).sqrt(),
            },
        }
    }
}
