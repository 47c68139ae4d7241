//! The functions of a body.

use super::samples::{BasisSample, samples};
use super::singular::{dot, singular};
use super::training::{RAYS, Training, training};
use crate::rays::Rays;
use sh_scene::{Material, Mesh};

/// Functions on a body's surface in which its irradiance is written: Ψ₀ = 1, and others that are at right angles to it and
/// to each other, in the order of how much they tell. The mean of Ψᵢ² over the surface is 1.
///
/// ```
/// use sh_bake::{IrradianceBasis, shapes};
/// use sh_scene::Material;
/// let (knot, white) = (shapes::torus_knot(2, 3, 1.0, 0.4, 0.25), Material { albedo: [1.0; 3], texture: None });
/// let basis = IrradianceBasis::bake(&[(&knot, &white)], 16, &|_| {}).unwrap();
/// // Of all lights that it was taught by, 16 functions tell most.
/// assert!(basis.held(16) > 0.8);
/// // Light that falls evenly is the first function alone.
/// let even = vec![[0.5, 1.0, 2.0]; basis.samples().len()];
/// assert!((basis.weights(&even)[0][2] - 2.0).abs() < 1e-5);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct IrradianceBasis {
    samples: Vec<BasisSample>,
    /// Function by function.
    values: Vec<f32>,
    own: Vec<[f32; 3]>,
    held: Vec<f32>,
}

impl IrradianceBasis {
    /// Points on the surface.
    pub const SAMPLES: usize = 1024;

    /// The most functions there may be.
    pub const MOST: usize = 64;

    /// Finds at most `most` functions (at least one) for a body that is made of these parts; none for one without a triangle
    /// of any extent. Takes a second or two on two cores. The same input gives the same functions, whatever the number of
    /// threads. Telling `progress` the part that is done, 0 to 1, from several threads.
    ///
    /// # Panics
    /// Where singular values are wrong: what they are taken from is put together again each time, to see.
    pub fn bake(
        parts: &[(&Mesh, &Material)],
        most: usize,
        progress: &(dyn Fn(f32) + Sync),
    ) -> Option<Self> {
        let rays = Rays::of(parts)?;
        let samples = samples(parts, Self::SAMPLES);
        if samples.is_empty() {
            return None;
        }
        let done = std::sync::atomic::AtomicUsize::new(0);
        let tell = || {
            let done = 1 + done.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
            progress(0.8 * done as f32 / samples.len() as f32);
        };
        let Training { columns, met } = training(&samples, &rays, &tell);
        let (functions, held) = functions(&columns, samples.len(), most.clamp(1, Self::MOST));
        let own = own(&functions, &samples, &met);
        progress(1.0);
        let values = functions.iter().flatten().map(|x| *x as f32).collect();
        Some(Self {
            samples,
            values,
            own,
            held,
        })
    }

    /// How many functions there are.
    pub fn count(&self) -> usize {
        self.held.len()
    }

    /// The points, each for as much area as the others.
    pub fn samples(&self) -> &[BasisSample] {
        &self.samples
    }

    /// The values of function `i`, point by point.
    pub fn function(&self, i: usize) -> &[f32] {
        &self.values[i * self.samples.len()..][..self.samples.len()]
    }

    /// How much of the lights that the body was taught by the first `count` functions tell: the share of their mean square,
    /// 0 to 1.
    pub fn held(&self, count: usize) -> f32 {
        self.held[count.clamp(1, self.count()) - 1]
    }

    /// The weights of irradiance that is told point by point: of each function a mean over the surface.
    pub fn weights(&self, irradiance: &[[f32; 3]]) -> Vec<[f32; 3]> {
        let weight = |i: usize| {
            let mut sum = [0.0; 3];
            for (value, light) in self.function(i).iter().zip(irradiance) {
                for (sum, light) in sum.iter_mut().zip(light) {
                    *sum += value * light;
                }
            }
            sum.map(|sum| sum / self.samples.len() as f32)
        };
        (0..self.count()).map(weight).collect()
    }

    /// Irradiance at a point, by the weights of the first functions.
    pub fn irradiance(&self, weights: &[[f32; 3]], sample: usize) -> [f32; 3] {
        let mut sum = [0.0; 3];
        for (i, weight) in weights.iter().enumerate().take(self.count()) {
            let value = self.function(i)[sample];
            for (sum, weight) in sum.iter_mut().zip(weight) {
                *sum += value * weight;
            }
        }
        sum
    }

    /// The weights of the light that the body sends itself, where irradiance of these weights is reflected once.
    pub fn bounced(&self, weights: &[[f32; 3]]) -> Vec<[f32; 3]> {
        let count = self.count();
        let row = |i: usize| {
            let mut sum = [0.0; 3];
            for (own, weight) in self.own[i * count..][..count].iter().zip(weights) {
                for ((sum, own), weight) in sum.iter_mut().zip(own).zip(weight) {
                    *sum += own * weight;
                }
            }
            sum
        };
        (0..count).map(row).collect()
    }
}

/// The functions, and how much of the columns so many of them tell.
fn functions(columns: &[Vec<f64>], samples: usize, most: usize) -> (Vec<Vec<f64>>, Vec<f32>) {
    let count = samples as f64;
    let mean = |column: &Vec<f64>| column.iter().sum::<f64>() / count;
    let all: f64 = columns.iter().map(|c| dot(c, c)).sum();
    let even: f64 = columns.iter().map(|c| mean(c).powi(2) * count).sum();
    let rest = |column: &Vec<f64>| {
        let mean = mean(column);
        column.iter().map(|x| x - mean).collect()
    };
    let rest: Vec<Vec<f64>> = columns.iter().map(rest).collect();
    let found = singular(rest.clone());
    let error = found.error(&rest);
    assert!(error < 1e-9, "singular values are off by {error}");
    let share = |told: f64| if all > 0.0 { (told / all) as f32 } else { 1.0 };
    let (mut functions, mut held) = (vec![vec![1.0; samples]], vec![share(even)]);
    let mut told = even;
    // What is left of rounding tells nothing.
    let least = found.values.first().map_or(0.0, |most| most * 1e-9);
    for (value, left) in found.values.iter().zip(&found.left).take(most - 1) {
        if *value <= least || *value * value <= all * 1e-16 {
            break;
        }
        told += value * value;
        functions.push(left.iter().map(|x| x * count.sqrt()).collect());
        held.push(share(told));
    }
    (functions, held)
}

/// What the body gives itself of each function, in each function, row by row.
fn own(functions: &[Vec<f64>], samples: &[BasisSample], met: &[Vec<u32>]) -> Vec<[f32; 3]> {
    let count = functions.len();
    // For each function what falls on each point of it.
    let fallen = |function: &Vec<f64>| -> Vec<[f64; 3]> {
        let on = |met: &Vec<u32>| {
            let mut sum = [0.0; 3];
            for &at in met {
                let (albedo, value) = (samples[at as usize].albedo, function[at as usize]);
                for (sum, albedo) in sum.iter_mut().zip(albedo) {
                    *sum += f64::from(albedo) * value;
                }
            }
            sum.map(|sum| sum / RAYS as f64)
        };
        met.iter().map(on).collect()
    };
    let fallen: Vec<Vec<[f64; 3]>> = functions.iter().map(fallen).collect();
    let mut own = Vec::with_capacity(count * count);
    for row in functions {
        for fallen in &fallen {
            let mut sum = [0.0; 3];
            for (value, fallen) in row.iter().zip(fallen) {
                for (sum, fallen) in sum.iter_mut().zip(fallen) {
                    *sum += value * fallen;
                }
            }
            own.push(sum.map(|sum| (sum / samples.len() as f64) as f32));
        }
    }
    own
}
