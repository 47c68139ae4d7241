//! How much of a sphere the other spheres of its body leave to be seen.

use super::{MOST_COEFFICIENTS, SurfaceSamples, cell_sums, directions};
use crate::Sphere;
use crate::order::{Ball, share_of};
use glam::Vec3;
use sh_core::{ROOT_FOUR_PI, Routines};

/// How far away the body is looked at from, over its radius.
const AWAY: f32 = 8.0;

impl SurfaceSamples {
    /// Finds for each sphere which share of its disc the other `spheres` of its body leave to be seen from afar, by
    /// direction ([`exposed`](Self::exposed)): what a receiver finds that looks at sphere by sphere. Spheres without points
    /// hide nothing of those that they intersect.
    ///
    /// Takes some milliseconds for 64 spheres, and grows with the square of their number. Where spheres move against each
    /// other, as those of a skin do, what was found for its rest pose serves on.
    pub fn expose(&mut self, spheres: &[Sphere]) {
        let count = self.spheres().min(spheres.len());
        let spheres = &spheres[..count];
        let centers = || spheres.iter().map(|s| Vec3::from(s.center));
        let middle = centers().sum::<Vec3>() / count.max(1) as f32;
        let reach =
            |radius: f32, s: &Sphere| radius.max(middle.distance(s.center.into()) + s.radius);
        let radius = spheres.iter().fold(0.0, reach);
        self.exposed.clear();
        self.exposed
            .resize(self.spheres(), [0.0; MOST_COEFFICIENTS]);
        for (direction, cell) in directions().iter().zip(cell_sums()) {
            let from = middle + AWAY * radius * Vec3::from(*direction);
            let mut seen: Vec<(usize, Disc)> = (spheres.iter())
                .map(|s| Disc::new(s, from))
                .enumerate()
                .collect();
            // From the nearest on.
            seen.sort_by(|a, b| a.1.power.total_cmp(&b.1.power));
            for at in 0..seen.len() {
                let (i, own) = &seen[at];
                let mut left = 1.0;
                for (place, (j, other)) in seen.iter().enumerate() {
                    let cosine = own.towards.dot(other.towards);
                    if at == place || cosine <= own.cosine * other.cosine - own.sine * other.sine {
                        continue;
                    }
                    let apart = own.ball.center.distance(other.ball.center);
                    if self.of(*j).is_empty() && apart < own.ball.radius + other.ball.radius {
                        continue;
                    }
                    let away = cosine.clamp(-1.0, 1.0).acos();
                    let [a, b] = [own, other].map(|disc| disc.sine.asin());
                    let covered = <[f32; 4]>::disc_covered(a, b, away);
                    let share = share_of([&own.ball, &other.ball], from);
                    // What is seen of it takes away, as in the passes.
                    let part = match place < at {
                        true => 1.0 + (other.left - 1.0) * (2.0 * share - 1.0).max(0.0),
                        false => 1.0,
                    };
                    left -= covered * share * part;
                }
                let left = left.max(0.0);
                for (sum, y) in self.exposed[*i].iter_mut().zip(cell) {
                    *sum += left * y;
                }
                seen[at].1.left = left;
            }
        }
    }

    /// The share of a sphere's disc that its body leaves to be seen, as an SH function of order 6 of the direction towards
    /// whoever looks, in the frame of the sphere's directions; 1 everywhere until [`expose`](Self::expose) has found it, and
    /// where spheres do not hide each other `within_bodies` ([`Blocking::within_bodies`](crate::Blocking::within_bodies)).
    ///
    /// ```
    /// use sh_scene::{Sphere, SurfacePoint, SurfaceSamples};
    /// let mut samples = SurfaceSamples::default();
    /// samples.push([SurfacePoint::default()]);
    /// samples.push([SurfacePoint::default()]);
    /// let mean = |samples: &SurfaceSamples| samples.exposed(0, true)[0] / sh_core::ROOT_FOUR_PI as f32;
    /// assert_eq!(mean(&samples), 1.0);
    /// // Two that are the same: each has half.
    /// samples.expose(&[Sphere { center: [0.0, 1.0, 0.0], radius: 0.5 }; 2]);
    /// assert!((mean(&samples) - 0.5).abs() < 1e-3);
    /// assert_eq!(samples.exposed(0, false)[0], sh_core::ROOT_FOUR_PI as f32);
    /// ```
    pub fn exposed(&self, sphere: usize, within_bodies: bool) -> [f32; MOST_COEFFICIENTS] {
        let mut all = [0.0; MOST_COEFFICIENTS];
        all[0] = ROOT_FOUR_PI as f32;
        let found = self.exposed.get(sphere).filter(|_| within_bodies);
        found.copied().unwrap_or(all)
    }
}

/// A sphere as it is seen from a place.
struct Disc {
    ball: Ball,
    towards: Vec3,
    sine: f32,
    cosine: f32,
    power: f32,
    /// What nearer ones leave of it.
    left: f32,
}

impl Disc {
    fn new(sphere: &Sphere, from: Vec3) -> Self {
        let ball = Ball::new(sphere.center, sphere.radius);
        let to = ball.center - from;
        let distance = to.length();
        let sine = (sphere.radius / distance.max(f32::MIN_POSITIVE)).min(1.0);
        Self {
            ball,
            towards: to / distance.max(f32::MIN_POSITIVE),
            sine,
            cosine: (1.0 - sine * sine).sqrt(),
            power: ball.power(from),
            left: 1.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::SurfacePoint;

    fn exposed(spheres: &[[f32; 4]], empty: usize) -> Vec<f32> {
        let mut samples = SurfaceSamples::default();
        for i in 0..spheres.len() {
            samples.push((i != empty).then(SurfacePoint::default));
        }
        let ball = |&[x, y, z, radius]: &[f32; 4]| Sphere {
            center: [x, y, z],
            radius,
        };
        samples.expose(&spheres.iter().map(ball).collect::<Vec<_>>());
        let mean = |i| samples.exposed(i, true)[0] / ROOT_FOUR_PI as f32;
        (0..spheres.len()).map(mean).collect()
    }

    #[test]
    fn what_lies_within_another_is_hidden_and_what_is_far_apart_is_not() {
        let spheres = [
            [0.0, 0.0, 0.0, 2.0],
            [0.2, 0.0, 0.0, 0.5],
            [50.0, 0.0, 0.0, 1.0],
        ];
        let found = exposed(&spheres, usize::MAX);
        assert!(
            found[0] > 0.95 && found[1] < 0.6 && found[2] > 0.98,
            "{found:?}"
        );
        // A large one without points lies inside of the body.
        assert!(exposed(&spheres, 0)[1] > 0.98);
    }

    /// The mean cross-section of a chain, by rays, is that of its spheres as much as they are exposed.
    #[test]
    fn a_chain_is_seen_as_large_as_it_is() {
        let chain = [
            [0.0, 0.0, 0.0, 1.0],
            [1.2, 0.1, 0.0, 0.8],
            [2.3, 0.0, 0.2, 1.0],
        ];
        let found = exposed(&chain, usize::MAX);
        let ours: f32 = chain.iter().zip(&found).map(|(s, e)| s[3] * s[3] * e).sum();
        let (mut hits, mut all) = (0, 0);
        let half = 2.5_f32;
        for direction in directions() {
            let (x, y) = Vec3::from(*direction).any_orthonormal_pair();
            for step in 0..60 * 60 {
                let at = |k: i32| half * ((k as f32 + 0.5) / 30.0 - 1.0);
                let p = Vec3::new(1.2, 0.0, 0.1) + at(step % 60) * x + at(step / 60) * y;
                let met = |s: &[f32; 4]| {
                    (p - Vec3::from_slice(s))
                        .cross(Vec3::from(*direction))
                        .length()
                        < s[3]
                };
                hits += i32::from(chain.iter().any(met));
                all += 1;
            }
        }
        let truth = hits as f32 / all as f32 * 4.0 * half * half / std::f32::consts::PI;
        assert!((ours / truth - 1.0).abs() < 0.05, "{ours} {truth}");
    }
}
