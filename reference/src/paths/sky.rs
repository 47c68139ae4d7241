//! The light from all around that paths end in: a map of texels, or the SH vector that the passes have in its place.

use crate::basis::{basis, order_of};
use crate::environment::{solid_angle, texel};
use crate::vec3::Vec3;
use sh_scene::{EnvironmentMap, Ground, Light};
use std::f64::consts::{PI, TAU};

/// Radiance over directions.
pub(super) enum Sky<'a> {
    Map(MapSky<'a>),
    /// Coefficients of red, green and blue. It may be negative where it rings.
    Projected([Vec<f64>; 3]),
}

impl Sky<'_> {
    pub fn projected(light: &Light) -> Self {
        let channel = |c: usize| light.coefficients.iter().map(move |k| f64::from(k[c]));
        Sky::Projected([0, 1, 2].map(|c| channel(c).collect()))
    }

    /// Radiance from a unit direction.
    pub fn radiance(&self, direction: Vec3) -> [f64; 3] {
        match self {
            Sky::Map(map) => map.radiance(direction),
            Sky::Projected(channels) => {
                let y = basis(order_of(channels[0].len()), direction);
                let value = |channel: &Vec<f64>| channel.iter().zip(&y).map(|(c, y)| c * y).sum();
                channels.each_ref().map(value)
            }
        }
    }

    /// A direction drawn by two numbers in 0..1, if this sky draws any.
    pub fn sample(&self, pair: [f64; 2]) -> Option<Sample> {
        match self {
            Sky::Map(map) => map.sample(pair),
            // Smooth: the cosine alone does.
            Sky::Projected(_) => None,
        }
    }

    /// The density, per steradian, with which [`sample`](Self::sample) draws a direction.
    pub fn density(&self, direction: Vec3) -> f64 {
        match self {
            Sky::Map(map) => map.density(direction),
            Sky::Projected(_) => 0.0,
        }
    }
}

/// A direction that was drawn.
pub(super) struct Sample {
    pub direction: Vec3,
    /// Density of the draw, per steradian.
    pub density: f64,
    /// Radiance from there.
    pub radiance: [f64; 3],
}

/// A map of texels of constant radiance, as `sh_scene::Light::project` takes it: where there is a ground, everything
/// below the horizon is what the open ground shows, its albedo times the irradiance of the upper half over π.
///
/// Directions are drawn in proportion to luminance: a row by its share, a texel of the row by its own, and evenly over
/// the solid angle of the texel. Below a horizon none are drawn: the cosine finds what is even.
pub(super) struct MapSky<'a> {
    map: &'a EnvironmentMap,
    below: Option<[f64; 3]>,
    /// Luminance times solid angle of all rows before each, and of all rows at the end.
    rows: Vec<f64>,
    /// Luminance of all texels of a row before each, and of all of them at the end; row after row.
    columns: Vec<f64>,
}

impl<'a> MapSky<'a> {
    /// # Panics
    /// If the map does not have `width · height` pixels, or none.
    pub fn new(map: &'a EnvironmentMap, ground: Option<Ground>) -> Self {
        let width = map.width as usize;
        assert!(
            !map.pixels.is_empty() && map.pixels.len() == width * map.height as usize,
            "a map of {width} by {} texels",
            map.height
        );
        let below = ground.map(|ground| {
            let up = map.upper_irradiance();
            [0, 1, 2].map(|c| f64::from(ground.albedo[c]) * up[c])
        });
        let mut sky = Self {
            map,
            below,
            rows: vec![0.0],
            columns: Vec::new(),
        };
        let mut all = 0.0;
        for (y, row) in map.pixels.chunks_exact(width).enumerate() {
            let mut row_sum = 0.0;
            sky.columns.push(row_sum);
            for pixel in row {
                row_sum += luminance(*pixel);
                sky.columns.push(row_sum);
            }
            all += row_sum * sky.texel_area(y);
            sky.rows.push(all);
        }
        sky
    }

    /// Solid angle of what a row's texels show of the sky.
    fn texel_area(&self, row: usize) -> f64 {
        let (width, height) = (self.map.width as usize, self.map.height as usize);
        match self.below {
            Some(_) if 2 * row >= height => 0.0,
            // The row that the horizon halves.
            Some(_) if 2 * row + 1 == height => 0.5 * solid_angle(row, width, height),
            _ => solid_angle(row, width, height),
        }
    }

    fn radiance(&self, direction: Vec3) -> [f64; 3] {
        match self.below {
            Some(below) if direction[1] < 0.0 => below,
            _ => self.map.pixels[self.index(direction)].map(f64::from),
        }
    }

    fn index(&self, direction: Vec3) -> usize {
        let width = self.map.width as usize;
        let [column, row] = texel(direction, width, self.map.height as usize);
        row * width + column
    }

    fn sum(&self) -> f64 {
        self.rows[self.map.height as usize]
    }

    fn density(&self, direction: Vec3) -> f64 {
        if self.sum() <= 0.0 || (self.below.is_some() && direction[1] < 0.0) {
            return 0.0;
        }
        luminance(self.map.pixels[self.index(direction)]) / self.sum()
    }

    fn sample(&self, [u, v]: [f64; 2]) -> Option<Sample> {
        let (width, height) = (self.map.width as usize, self.map.height as usize);
        if self.sum() <= 0.0 {
            return None;
        }
        let (row, down) = find(&self.rows, v);
        let start = row * (width + 1);
        let (column, across) = find(&self.columns[start..=start + width], u);
        let edge = |row: usize| match self.below {
            Some(_) => (PI * row as f64 / height as f64).cos().max(0.0),
            None => (PI * row as f64 / height as f64).cos(),
        };
        let (top, bottom) = (edge(row), edge(row + 1));
        let y = top + down * (bottom - top);
        let flat = ((1.0 - y) * (1.0 + y)).max(0.0).sqrt();
        let phi = TAU * (column as f64 + across) / width as f64 - PI;
        let pixel = self.map.pixels[row * width + column];
        Some(Sample {
            direction: [flat * phi.sin(), y, -flat * phi.cos()],
            density: luminance(pixel) / self.sum(),
            radiance: pixel.map(f64::from),
        })
    }
}

/// The step of a sum that a share of its end falls into, and where within it, 0 to 1.
fn find(sums: &[f64], share: f64) -> (usize, f64) {
    let target = share * sums[sums.len() - 1];
    // The first step that ends above the target has a width.
    let step = sums[1..].partition_point(|end| *end <= target);
    let step = step.min(sums.len() - 2);
    let width = sums[step + 1] - sums[step];
    let part = if width > 0.0 {
        (target - sums[step]) / width
    } else {
        0.5
    };
    (step, part.clamp(0.0, 1.0))
}

/// Rec.709; 0 where it is none.
fn luminance([r, g, b]: [f32; 3]) -> f64 {
    let sum = 0.2126 * f64::from(r) + 0.7152 * f64::from(g) + 0.0722 * f64::from(b);
    if sum > 0.0 && sum.is_finite() {
        sum
    } else {
        0.0
    }
}
