//! The surfaces of a scene's bodies.

use super::once::{Bake, once};
use crate::cache::{Baked, Cache, Ingredients, Key, fours};
use crate::progress::Progress;
use crate::surface::{Part, SURFACE_VERSION, bake_with};
use sh_scene::surface::DIRECTIONS;
use sh_scene::{Object, Sphere, SurfacePoint, SurfaceSamples};
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

/// A body's surface samples, as far as a person wants to know.
#[derive(Clone, Debug)]
pub struct SurfaceReport {
    /// The name of the first of its objects.
    pub name: String,
    /// How many spheres it has.
    pub spheres: usize,
    /// How many points they have together.
    pub points: usize,
    /// What the samples take.
    pub bytes: usize,
    /// Time for sampling, or for finding the samples in the cache.
    pub time: Duration,
    /// Whether the samples come from the cache.
    pub cached: bool,
}

/// Samples the surfaces of bodies, each of which is some of the objects, the first with the spheres of all. Bodies that
/// are alike are sampled once and reported once.
pub(crate) fn sample(
    objects: &mut [Object],
    bodies: &[Range<usize>],
    cache: Option<&Cache>,
    progress: &(dyn Fn(Progress) + Sync),
) -> Vec<SurfaceReport> {
    let sampled = |body: &Range<usize>| Surface {
        parts: objects[body.clone()]
            .iter()
            .map(|o| (&o.mesh, &o.material))
            .collect(),
        spheres: &objects[body.start].spheres,
    };
    let wanted: Vec<Surface> = bodies.iter().map(sampled).collect();
    let found = once(&wanted, cache, progress);
    let mut reports = Vec::new();
    for (body, found) in bodies.iter().zip(found) {
        let object = &mut objects[body.start];
        let samples = &found.what;
        object.surface = SurfaceSamples::clone(samples);
        if found.first {
            reports.push(SurfaceReport {
                name: object.name.clone(),
                spheres: samples.spheres(),
                points: samples.points.len(),
                bytes: samples.bytes(),
                time: found.time,
                cached: found.cached,
            });
        }
    }
    reports
}

/// The surface around a body's spheres: found by all that its rays may meet.
struct Surface<'a> {
    parts: Vec<Part<'a>>,
    spheres: &'a [Sphere],
}

impl Bake for Surface<'_> {
    type Baked = SurfaceSamples;

    const STAGE: &'static str = "sampling surfaces";

    fn key(&self) -> Key {
        let mut key = Ingredients::<SurfaceSamples>::new();
        key.spheres(self.spheres);
        for (mesh, material) in &self.parts {
            key.surface(mesh, material);
        }
        key.key()
    }

    fn steps(&self) -> usize {
        self.spheres.len()
    }

    fn make(&self, tell: &(dyn Fn(usize) + Sync)) -> SurfaceSamples {
        let done = AtomicUsize::new(0);
        bake_with(&self.parts, self.spheres, &|| {
            tell(done.fetch_add(1, Ordering::Relaxed) + 1);
        })
    }

    fn kept(&self, mut kept: SurfaceSamples) -> Option<SurfaceSamples> {
        if kept.spheres() != self.spheres.len() {
            return None;
        }
        kept.expose(self.spheres);
        Some(kept)
    }
}

/// Numbers of a point: position, normal, albedo, share, direction.
const NUMBERS: usize = 11;

impl Baked for SurfaceSamples {
    const NAME: &str = "surface";
    const VERSION: u32 = SURFACE_VERSION;
    /// It holds 4096 spheres.
    const MOST: u64 = 1 << 25;

    /// How many spheres there are, how many points each has, and the points.
    fn encoded(&self) -> Vec<u8> {
        let mut bytes = (self.spheres() as u32).to_le_bytes().to_vec();
        for i in 0..self.spheres() {
            bytes.extend((self.of(i).len() as u32).to_le_bytes());
        }
        for point in &self.points {
            for number in [point.position, point.normal, point.albedo].as_flattened() {
                bytes.extend(number.to_le_bytes());
            }
            bytes.extend(point.share.to_le_bytes());
            bytes.extend(point.direction.to_le_bytes());
        }
        bytes
    }

    fn decoded(bytes: &[u8]) -> Option<Self> {
        let words = fours(bytes, u32::from_le_bytes)?;
        let (count, words) = words.split_first()?;
        let (counts, words) = words.split_at_checked(*count as usize)?;
        let (points, rest) = words.as_chunks::<NUMBERS>();
        let total: u64 = counts.iter().map(|n| u64::from(*n)).sum();
        let known = |point: &[u32; NUMBERS]| (point[NUMBERS - 1] as usize) < DIRECTIONS;
        if !rest.is_empty() || total != points.len() as u64 || !points.iter().all(known) {
            return None;
        }
        let mut points =
            points.iter().map(
                |&[a, b, c, d, e, f, g, h, i, share, direction]| SurfacePoint {
                    position: [a, b, c].map(f32::from_bits),
                    normal: [d, e, f].map(f32::from_bits),
                    albedo: [g, h, i].map(f32::from_bits),
                    share: f32::from_bits(share),
                    direction,
                    ..Default::default()
                },
            );
        let mut samples = SurfaceSamples::default();
        for count in counts {
            samples.push(points.by_ref().take(*count as usize));
        }
        Some(samples)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_come_back_bit_by_bit() {
        let mut samples = SurfaceSamples::default();
        samples.push((0..3).map(|k| SurfacePoint {
            position: [k as f32, 0.1, -2.0],
            direction: 30 * k,
            normal: [0.0, 1.0, 0.0],
            albedo: [0.2, 0.4, 0.6],
            share: 0.75,
            ..Default::default()
        }));
        samples.push([]);
        assert_eq!(
            SurfaceSamples::decoded(&samples.encoded()),
            Some(samples.clone())
        );
        let none = SurfaceSamples::default();
        assert_eq!(SurfaceSamples::decoded(&none.encoded()), Some(none));
        let bytes = samples.encoded();
        for cut in 0..bytes.len() {
            assert_eq!(SurfaceSamples::decoded(&bytes[..cut]), None, "{cut}");
        }
        let mut far = bytes.clone();
        let last = far.len() - 4;
        far[last] = 92;
        assert_eq!(
            SurfaceSamples::decoded(&far),
            None,
            "a direction that there is not"
        );
    }
}
