//! Shadows by casting rays: what a renderer without this library would do.

use glam::{Vec3, Vec3A};
use obvhs::BvhBuildParams;
use obvhs::cwbvh::CwBvh;
use obvhs::cwbvh::builder::build_cwbvh_from_tris;
use obvhs::ray::Ray;
use obvhs::rt_triangle::RtTriangle;
use obvhs::triangle::Triangle;
use sh_scene::Receiver;
use std::f32::consts::TAU;
use std::time::Duration;

/// Metres that a ray starts above its surface, and the nearest hit that counts.
const OFFSET: f32 = 1e-3;

/// Independent sets of directions; each receiver takes one of them, turned about its normal.
const SETS: u32 = 64;

/// Triangles, ready for rays.
pub struct Caster {
    hierarchy: CwBvh,
    triangles: Vec<RtTriangle>,
}

impl Caster {
    /// Builds the hierarchy: a wide one of compressed nodes, with the builder's settings for fast rays.
    pub fn new(triangles: &[Triangle]) -> Self {
        let params = BvhBuildParams::very_slow_build();
        let hierarchy = build_cwbvh_from_tris(triangles, params, &mut Duration::default());
        let order = &hierarchy.primitive_indices;
        let triangles = order
            .iter()
            .map(|&i| (&triangles[i as usize]).into())
            .collect();
        Self {
            hierarchy,
            triangles,
        }
    }

    /// How many triangles rays are tested against at most.
    pub fn triangles(&self) -> usize {
        self.triangles.len()
    }

    /// Whether nothing is in the way; the first hit found ends the search.
    #[inline]
    pub fn open(&self, origin: Vec3A, direction: Vec3A) -> bool {
        // + 0 turns -0 into 0, of which the hierarchy's slab test has two opinions.
        let ray = Ray::new(origin, direction + Vec3A::ZERO, 0.0, f32::INFINITY);
        self.hierarchy
            .ray_traverse_miss(ray, |ray, i| self.triangles[i].intersect(ray))
    }

    /// Radiance that albedo 1 reflects at a receiver under `N` lights, each told by its radiance from a direction: the
    /// mean over the rays of one set of samples. `index` is the receiver's number, from which its set follows.
    #[inline]
    pub fn shade<const N: usize>(
        &self,
        receiver: &Receiver,
        index: usize,
        samples: &Samples,
        light: impl Fn(Vec3A) -> [Vec3A; N],
    ) -> [Vec3A; N] {
        let origin = Vec3A::from(receiver.position) + Vec3A::from(receiver.normal) * OFFSET;
        samples.mean(receiver, index, |direction| {
            self.open(origin, direction).then(|| light(direction))
        })
    }
}

/// Directions in proportion to the cosine about +Z: Sobol points in two dimensions with Owen's scrambling, of which
/// each set has another.
pub struct Samples {
    sets: Vec<Vec<Vec3A>>,
    seed: u32,
}

impl Samples {
    /// Sets of `count` directions, best a power of two.
    pub fn new(count: u32, seed: u32) -> Self {
        let set = |set: u32| {
            let [first, second] = [0, 1].map(|k| hash(2 * (set + SETS * seed) + k));
            let direction = |i: u32| {
                let u = unit(scrambled(i.reverse_bits(), first));
                let v = unit(scrambled(sobol(i), second));
                let (sin, cos) = (TAU * v).sin_cos();
                let flat = u.sqrt();
                Vec3A::new(flat * cos, flat * sin, (1.0 - u).max(0.0).sqrt())
            };
            (0..count).map(direction).collect()
        };
        Self {
            sets: (0..SETS).map(set).collect(),
            seed,
        }
    }

    /// The mean of `value` over the directions about a receiver's normal; none counts as 0.
    #[inline]
    pub fn mean<const N: usize>(
        &self,
        receiver: &Receiver,
        index: usize,
        mut value: impl FnMut(Vec3A) -> Option<[Vec3A; N]>,
    ) -> [Vec3A; N] {
        let random = hash(hash(index as u32) ^ self.seed);
        let set = &self.sets[(random % SETS) as usize];
        let normal = Vec3::from(receiver.normal);
        let (x, y) = normal.any_orthonormal_pair();
        let (sin, cos) = (TAU * unit(hash(random))).sin_cos();
        let [x, y, z] = [x * cos + y * sin, y * cos - x * sin, normal].map(Vec3A::from);
        let mut sum = [Vec3A::ZERO; N];
        for local in set {
            if let Some(value) = value(x * local.x + y * local.y + z * local.z) {
                for (sum, value) in sum.iter_mut().zip(value) {
                    *sum += value;
                }
            }
        }
        sum.map(|sum| sum / set.len() as f32)
    }
}

/// 0 to 1, without 1.
fn unit(bits: u32) -> f32 {
    (bits >> 8) as f32 / (1 << 24) as f32
}

/// The second dimension of Sobol's points (Kollig & Keller 2002, "Efficient multidimensional sampling").
fn sobol(mut i: u32) -> u32 {
    let (mut bits, mut column) = (0, 1 << 31);
    while i > 0 {
        if i & 1 == 1 {
            bits ^= column;
        }
        i >>= 1;
        column ^= column >> 1;
    }
    bits
}

/// Owen's scrambling by a hash (Laine & Karras 2011; Burley 2020, "Practical hash-based Owen scrambling").
fn scrambled(bits: u32, seed: u32) -> u32 {
    let mut x = bits.reverse_bits().wrapping_add(seed);
    for factor in [0x6c50_b47c_u32, 0xb82f_1e52, 0xc7af_e638, 0x8d22_f6e6] {
        x ^= x.wrapping_mul(factor);
    }
    x.reverse_bits()
}

/// The finaliser of MurmurHash3.
fn hash(mut x: u32) -> u32 {
    x = (x ^ 0x9e37_79b9 ^ (x >> 16)).wrapping_mul(0x85eb_ca6b);
    x = (x ^ (x >> 13)).wrapping_mul(0xc2b2_ae35);
    x ^ (x >> 16)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::capsule::Capsule;

    const UP: Receiver = Receiver {
        position: [0.0; 3],
        covered: 1,
        normal: [0.0, 1.0, 0.0],
        object: 0,
    };

    /// A square of 2 km, upright at x = 1e-2 m, or above everything.
    fn wall(flat: bool) -> Caster {
        let corner = |u: f32, v: f32| match flat {
            true => Vec3A::new(1e3 * u, 5.0, 1e3 * v),
            false => Vec3A::new(1e-2, 1e3 * u, 1e3 * v),
        };
        let [a, b, c, d] =
            [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(u, v)| corner(u, v));
        Caster::new(&[
            Triangle {
                v0: a,
                v1: b,
                v2: c,
            },
            Triangle {
                v0: a,
                v1: c,
                v2: d,
            },
        ])
    }

    #[test]
    fn half_the_sky_is_half_the_light_and_all_of_it_none() {
        let samples = Samples::new(1024, 1);
        for index in 0..20 {
            let [half] = wall(false).shade(&UP, index, &samples, |_| [Vec3A::ONE]);
            assert!((half.x - 0.5).abs() < 0.02, "{half}");
            let [none] = wall(true).shade(&UP, index, &samples, |_| [Vec3A::ONE]);
            assert!(none.x < 0.01, "{none}");
        }
    }

    #[test]
    fn in_the_open_means_converge_to_the_integral_faster_than_random_numbers() {
        // ∫ (y² over the hemisphere) cos / π = 1/2 about +Y; the square of x or z has 1/4.
        let error = |count: u32| {
            let samples = Samples::new(count, 7);
            let square = (0..64).map(|index| {
                let [mean] = samples.mean(&UP, index, |d| Some([d * d]));
                f64::from((mean - Vec3A::new(0.25, 0.5, 0.25)).length_squared())
            });
            (square.sum::<f64>() / 64.0).sqrt()
        };
        let [few, many] = [error(16), error(256)];
        assert!(few < 0.05 && many < few / 8.0, "{few} {many}");
    }

    #[test]
    fn triangles_close_a_capsule() {
        let capsule = Capsule {
            from: Vec3::new(0.0, 1.0, 0.0),
            to: Vec3::new(0.4, 1.5, 0.3),
            radius: 0.2,
        };
        let mut triangles = Vec::new();
        capsule.triangles(24, &mut triangles);
        let area: f32 = triangles
            .iter()
            .map(|t| 0.5 * (t.v1 - t.v0).cross(t.v2 - t.v0).length())
            .sum();
        let exact = TAU * 0.2 * (capsule.from.distance(capsule.to) + 0.4);
        assert!((area / exact - 1.0).abs() < 0.02, "{area} {exact}");
        // From inside no ray gets out.
        let caster = Caster::new(&triangles);
        let middle = Vec3A::from(capsule.from.lerp(capsule.to, 0.3));
        for set in &Samples::new(64, 3).sets {
            for d in set {
                assert!(!caster.open(middle, *d) && !caster.open(middle, -*d));
            }
        }
    }
}
