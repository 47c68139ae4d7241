//! Weights of spheres on disk, so that a body is weighed once: found by its shape in all poses that were looked at, its
//! spheres, where up is, and what the shadow pass makes of blockers.

use super::folder::{Cache, Magic, fours, named};
use crate::weights::{Pose, WEIGHTS_VERSION, log, transfer};
use glam::DVec3;
use sh_core::seen::Seen;
use sha2::{Digest, Sha256};

const MAGIC: &Magic = b"gaunt weights 1\n";
/// No file of ours is larger: it holds 4096 weights.
const LARGEST: u64 = 1 << 15;

impl Cache {
    /// The weights that were kept under a key for so many spheres, if they are there and whole.
    pub(crate) fn find_weights(&self, key: &str, spheres: usize) -> Option<Vec<f32>> {
        let bytes = self.read(&(key.to_owned() + ".weights"), MAGIC, LARGEST)?;
        let weights = fours(&bytes, f32::from_le_bytes)?;
        (weights.len() == spheres && weights.iter().all(|w| *w >= 0.0)).then_some(weights)
    }

    /// Keeps weights under a key, if it can.
    pub(crate) fn keep_weights(&self, key: &str, weights: &[f32]) {
        let bytes: Vec<u8> = weights.iter().flat_map(|w| w.to_le_bytes()).collect();
        self.write(&(key.to_owned() + ".weights"), MAGIC, &bytes);
    }
}

/// What a body's weights are found by.
pub(crate) fn key(poses: &[Pose], up: DVec3) -> String {
    let mut hash = Sha256::new();
    hash.update(MAGIC);
    hash.update(WEIGHTS_VERSION.to_le_bytes());
    // Whatever is fitted anew in the shadow pass shows here.
    for sine in [0.1, 0.5, 0.9, 1.0] {
        let cosine = f64::sqrt(1.0 - sine * sine);
        let seen = Seen {
            sine,
            cosine,
            direction: [0.6, 0.0, 0.8],
        };
        for number in transfer(&log(&seen), [0.0, 1.0, 0.0]) {
            hash.update((number as f32).to_le_bytes());
        }
    }
    for number in up.to_array() {
        hash.update(number.to_le_bytes());
    }
    for pose in poses {
        hash.update((pose.spheres.len() as u64).to_le_bytes());
        for sphere in &pose.spheres {
            let [x, y, z] = sphere.center;
            for number in [x, y, z, sphere.radius] {
                hash.update(number.to_le_bytes());
            }
        }
        for mesh in &pose.meshes {
            hash.update((mesh.positions.len() as u64).to_le_bytes());
            hash.update((mesh.triangles.len() as u64).to_le_bytes());
            let vectors = mesh.positions.iter().chain(&mesh.normals).flatten();
            for number in vectors {
                hash.update(number.to_le_bytes());
            }
            for index in mesh.triangles.iter().flatten() {
                hash.update(index.to_le_bytes());
            }
        }
    }
    named(hash)
}
