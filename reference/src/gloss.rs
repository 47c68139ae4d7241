//! The lobe in which a polished surface mirrors light: GGX, in f64, by its definition.
//!
//! With the normal n, the direction v to the viewer, a light in the direction l and h half way between these, α the square of the
//! roughness, of the radiance that comes from l is mirrored, without Fresnel's reflectance and with the cosine,
//!
//! ```text
//! D(n · h) G(n · l, n · v) / (4 n · v)
//! D(c) = α² / (π (c² (α² − 1) + 1)²)                     Walter et al. 2007, equation 33
//! G(a, b) = 1 / (1 + Λ(a) + Λ(b))                        Heitz 2014, equation 99
//! Λ(c) = (√(1 + α² (1 / c² − 1)) − 1) / 2                Heitz 2014, equation 72
//! ```
//!
//! Directions are drawn by the normals that the viewer sees (Heitz, "Sampling the GGX Distribution of Visible Normals", 2018): the
//! density of a direction is then D / ((1 + Λ(n · v)) 4 n · v).

use crate::vec3::{Vec3, add, cross, dot, frame, length, normalize, scale, sub};
use std::f64::consts::{PI, TAU};

/// The lobe of a place, over its own sum: its mean of an even sky is the sky.
#[derive(Clone, Copy, Debug)]
pub struct Gloss {
    alpha: f64,
    normal: Vec3,
    view: Vec3,
    facing: f64,
    energy: f64,
}

/// The least α that is told apart from a mirror's.
const SMOOTHEST: f64 = 1e-4;

/// Points of the square that sums are taken over, and by how many of them the second number goes on from one to the next: two
/// Fibonacci numbers. A lattice has no rows along which a horizon or a ring could run, as a grid has.
const POINTS: [usize; 2] = [4181, 2584];

impl Gloss {
    /// That of a surface of a roughness 0..1 with a unit normal, seen from a unit direction above it.
    ///
    /// ```
    /// use sh_reference::gloss::Gloss;
    /// let mirror = Gloss::new(0.02, [0.0, 1.0, 0.0], [0.6, 0.8, 0.0]);
    /// let (direction, weight) = mirror.sample([0.3, 0.7]).unwrap();
    /// assert!(direction[0] < -0.59 && (weight - 1.0).abs() < 0.01);
    /// ```
    pub fn new(roughness: f64, normal: [f64; 3], view: [f64; 3]) -> Self {
        let facing = dot(normal, view).max(1e-3);
        let mut gloss = Self {
            alpha: (roughness * roughness).max(SMOOTHEST),
            normal,
            view,
            facing,
            energy: 1.0,
        };
        gloss.energy = gloss.sum(|_| 1.0);
        gloss
    }

    /// What the surface mirrors of an even sky, if it absorbs nothing and light meets it once.
    ///
    /// ```
    /// use sh_reference::gloss::Gloss;
    /// let [up, aside] = [[0.0, 1.0, 0.0], [0.6, 0.8, 0.0]];
    /// assert!(Gloss::new(0.1, up, aside).energy() > 0.99);
    /// assert!(Gloss::new(1.0, up, up).energy() < 0.35);
    /// ```
    pub fn energy(&self) -> f64 {
        self.energy
    }

    /// The same times (1 − h · v)⁵: the part that Fresnel's reflectance, as Schlick 1994 has it, adds at grazing angles.
    ///
    /// ```
    /// # use sh_reference::gloss::Gloss;
    /// let smooth = Gloss::new(0.02, [0.0, 1.0, 0.0], [0.8, 0.6, 0.0]);
    /// assert!((smooth.grazing() - 0.4_f64.powi(5)).abs() < 1e-3);
    /// ```
    pub fn grazing(&self) -> f64 {
        self.sum(|direction| {
            let half = normalize(add(direction, self.view));
            (1.0 - dot(half, self.view)).max(0.0).powi(5)
        })
    }

    /// The sum of a function over the lobe, before it is divided by its own.
    pub fn sum(&self, f: impl Fn([f64; 3]) -> f64) -> f64 {
        let [points, step] = POINTS;
        let mut sum = 0.0;
        for i in 0..points {
            let pair = [i, i * step % points].map(|c| (c as f64 + 0.5) / points as f64);
            if let Some((direction, weight)) = self.drawn(pair) {
                sum += weight * f(direction);
            }
        }
        sum / points as f64
    }

    /// A direction by two numbers in 0..1, and what light from there counts; none that is below the surface, which counts
    /// nothing. The mean of what directions count is 1.
    ///
    /// ```
    /// # use sh_reference::gloss::Gloss;
    /// let gloss = Gloss::new(0.5, [0.0, 1.0, 0.0], [0.6, 0.8, 0.0]);
    /// let (direction, weight) = gloss.sample([0.1, 0.6]).unwrap();
    /// // What is drawn more often counts less.
    /// assert!((weight * gloss.density(direction) - gloss.value(direction)).abs() < 1e-9);
    /// ```
    pub fn sample(&self, pair: [f64; 2]) -> Option<([f64; 3], f64)> {
        let (direction, weight) = self.drawn(pair)?;
        Some((direction, weight / self.energy))
    }

    /// How often a direction is drawn, per steradian.
    ///
    /// ```
    /// # use sh_reference::gloss::Gloss;
    /// let gloss = Gloss::new(0.5, [0.0, 1.0, 0.0], [0.6, 0.8, 0.0]);
    /// assert!(gloss.density([-0.6, 0.8, 0.0]) > gloss.density([0.0, 1.0, 0.0]));
    /// ```
    pub fn density(&self, direction: [f64; 3]) -> f64 {
        let masked = 1.0 + self.lambda(self.facing);
        self.facets(direction) / (masked * 4.0 * self.facing)
    }

    /// The lobe: light from a direction counts so much, per steradian. It sums up to 1.
    ///
    /// ```
    /// # use sh_reference::gloss::Gloss;
    /// let gloss = Gloss::new(0.5, [0.0, 1.0, 0.0], [0.6, 0.8, 0.0]);
    /// assert_eq!(gloss.value([0.0, -1.0, 0.0]), 0.0);
    /// ```
    pub fn value(&self, direction: [f64; 3]) -> f64 {
        let height = dot(self.normal, direction);
        if height <= 0.0 {
            return 0.0;
        }
        let seen = 1.0 / (1.0 + self.lambda(self.facing) + self.lambda(height));
        self.facets(direction) * seen / (4.0 * self.facing * self.energy)
    }

    /// D of the normal half way to a direction.
    fn facets(&self, direction: Vec3) -> f64 {
        let half = add(direction, self.view);
        let cosine = dot(self.normal, half) / length(half).max(f64::MIN_POSITIVE);
        let square = self.alpha * self.alpha;
        square / (PI * (cosine * cosine * (square - 1.0) + 1.0).powi(2))
    }

    fn lambda(&self, cosine: f64) -> f64 {
        let slope = 1.0 / (cosine * cosine) - 1.0;
        0.5 * ((1.0 + self.alpha * self.alpha * slope.max(0.0)).sqrt() - 1.0)
    }

    /// A direction, and what it counts before that is divided by the energy.
    fn drawn(&self, [u, v]: [f64; 2]) -> Option<(Vec3, f64)> {
        let [x, y] = frame(self.normal);
        let a = self.alpha;
        // The view above a surface that is stretched to roughness 1.
        let stretched = normalize([a * dot(self.view, x), a * dot(self.view, y), self.facing]);
        let (root, (sin, cos)) = (u.sqrt(), (TAU * v).sin_cos());
        // Even over what is seen of a hemisphere: half a disc, and half of one that is foreshortened, which leans with the normal.
        let level = [-stretched[1], stretched[0], 0.0];
        let s = match length(level) {
            0.0 => [1.0, 0.0, 0.0],
            far => scale(level, 1.0 / far),
        };
        let t = cross(stretched, s);
        let along = root * cos;
        let part = 0.5 * (1.0 + stretched[2]);
        let across = (1.0 - part) * (1.0 - along * along).max(0.0).sqrt() + part * root * sin;
        let up = (1.0 - along * along - across * across).max(0.0).sqrt();
        let facet = add(add(scale(s, along), scale(t, across)), scale(stretched, up));
        let facet = normalize([a * facet[0], a * facet[1], facet[2].max(1e-9)]);
        let half = add(
            add(scale(x, facet[0]), scale(y, facet[1])),
            scale(self.normal, facet[2]),
        );
        let direction = sub(scale(half, 2.0 * dot(half, self.view)), self.view);
        let height = dot(direction, self.normal);
        let masked = 1.0 + self.lambda(self.facing);
        (height > 0.0).then(|| (direction, masked / (masked + self.lambda(height))))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quadrature::Rule;

    const UP: Vec3 = [0.0, 1.0, 0.0];

    fn view(facing: f64) -> Vec3 {
        [(1.0 - facing * facing).sqrt(), facing, 0.0]
    }

    /// What is drawn is the lobe: sums by draws are those by quadrature, of three functions of the direction. A frame that is turned
    /// the wrong way or a density that is off shows in the second and third.
    #[test]
    fn draws_are_the_lobe() {
        let rule = Rule::sphere(240);
        for roughness in [0.35, 0.6, 1.0] {
            for facing in [0.2, 0.5, 0.9, 1.0] {
                let gloss = Gloss::new(roughness, UP, view(facing));
                for f in [
                    (|_| 1.0) as fn(Vec3) -> f64,
                    |d: Vec3| d[0],
                    |d: Vec3| d[1] * d[1] + 0.5 * d[0] * d[1],
                ] {
                    let drawn = gloss.sum(f) / gloss.energy();
                    let whole: f64 = rule.integrate(|d| gloss.value(d) * f(d));
                    assert!(
                        (drawn - whole).abs() < 4e-3,
                        "{roughness}, {facing}: {drawn} {whole}"
                    );
                }
            }
        }
    }

    /// A mirror sends what comes from the mirrored direction, all of it.
    #[test]
    fn a_smooth_surface_is_a_mirror() {
        let gloss = Gloss::new(0.03, UP, view(0.6));
        assert!((gloss.energy() - 1.0).abs() < 1e-4);
        let mean = [0, 1].map(|k| gloss.sum(|d| d[k]));
        assert!(
            (mean[0] + 0.8).abs() < 1e-3 && (mean[1] - 0.6).abs() < 1e-3,
            "{mean:?}"
        );
        // Fresnel's reflectance there, as Schlick has it.
        assert!((gloss.grazing() - 0.4_f64.powi(5)).abs() < 1e-3);
    }

    /// Light and eye may change places.
    #[test]
    fn the_lobe_is_reciprocal() {
        let (a, b) = (view(0.3), normalize([-0.2, 0.7, 0.5]));
        let [to, back] = [(a, b), (b, a)].map(|(from, towards)| {
            let gloss = Gloss::new(0.5, UP, from);
            gloss.value(towards) * gloss.energy() / dot(UP, towards)
        });
        assert!((to - back).abs() < 1e-12 * to, "{to} {back}");
    }
}
