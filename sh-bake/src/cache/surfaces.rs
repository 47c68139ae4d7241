//! Surface samples on disk, so that a body is sampled once: found by all that its rays may meet.

use super::folder::{Cache, Magic, fours, named};
use crate::surface::{Part, SURFACE_VERSION};
use sh_scene::surface::DIRECTIONS;
use sh_scene::{Sphere, SurfacePoint, SurfaceSamples};
use sha2::{Digest, Sha256};

const MAGIC: &Magic = b"gaunt surface 1\n";
/// No file of ours is larger: it holds 4096 spheres.
const LARGEST: u64 = 1 << 25;
/// Numbers of a point: position, normal, albedo, share, direction.
const NUMBERS: usize = 11;

impl Cache {
    /// The samples that were kept under a key for so many spheres, if they are there and whole.
    pub(crate) fn find_surface(&self, key: &str, spheres: usize) -> Option<SurfaceSamples> {
        let bytes = self.read(&(key.to_owned() + ".surface"), MAGIC, LARGEST)?;
        decoded(&bytes).filter(|samples| samples.spheres() == spheres)
    }

    /// Keeps samples under a key, if it can.
    pub(crate) fn keep_surface(&self, key: &str, samples: &SurfaceSamples) {
        self.write(&(key.to_owned() + ".surface"), MAGIC, &encoded(samples));
    }
}

/// What a body's samples are found by: a hash of its shape, its colours and its spheres.
pub(crate) fn key(parts: &[Part], spheres: &[Sphere]) -> String {
    let mut hash = Sha256::new();
    hash.update(MAGIC);
    hash.update(SURFACE_VERSION.to_le_bytes());
    let mut numbers = |numbers: &mut dyn Iterator<Item = f32>| {
        let bytes: Vec<u8> = numbers.flat_map(f32::to_le_bytes).collect();
        hash.update((bytes.len() as u64).to_le_bytes());
        hash.update(bytes);
    };
    numbers(&mut spheres.iter().flat_map(|s| {
        let [x, y, z] = s.center;
        [x, y, z, s.radius]
    }));
    for (mesh, material) in parts {
        for vectors in [&mesh.positions, &mesh.normals, &mesh.colors] {
            numbers(&mut vectors.as_flattened().iter().copied());
        }
        numbers(&mut mesh.uvs.as_flattened().iter().copied());
        numbers(&mut material.albedo.into_iter());
    }
    for (mesh, material) in parts {
        hash.update((mesh.triangles.len() as u64).to_le_bytes());
        for index in mesh.triangles.as_flattened() {
            hash.update(index.to_le_bytes());
        }
        if let Some(texture) = &material.texture {
            hash.update(texture.width.to_le_bytes());
            hash.update(texture.height.to_le_bytes());
            hash.update(&texture.rgba);
        }
    }
    named(hash)
}

/// Samples as bytes: how many spheres there are, how many points each has, and the points.
fn encoded(samples: &SurfaceSamples) -> Vec<u8> {
    let mut bytes = (samples.spheres() as u32).to_le_bytes().to_vec();
    for i in 0..samples.spheres() {
        bytes.extend((samples.of(i).len() as u32).to_le_bytes());
    }
    for point in &samples.points {
        for number in [point.position, point.normal, point.albedo].as_flattened() {
            bytes.extend(number.to_le_bytes());
        }
        bytes.extend(point.share.to_le_bytes());
        bytes.extend(point.direction.to_le_bytes());
    }
    bytes
}

fn decoded(bytes: &[u8]) -> Option<SurfaceSamples> {
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
        assert_eq!(decoded(&encoded(&samples)), Some(samples.clone()));
        let none = SurfaceSamples::default();
        assert_eq!(decoded(&encoded(&none)), Some(none));
        let bytes = encoded(&samples);
        for cut in 0..bytes.len() {
            assert_eq!(decoded(&bytes[..cut]), None, "{cut}");
        }
        let mut far = bytes.clone();
        let last = far.len() - 4;
        far[last] = 92;
        assert_eq!(decoded(&far), None, "a direction that there is not");
    }
}
