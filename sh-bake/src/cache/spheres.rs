//! Sphere sets on disk, so that a mesh is fitted once: found by its positions, its triangles and the count.

use super::folder::{Cache, Magic, fours, named};
use crate::spheres::{FIT_VERSION, SphereSet};
use sh_scene::{Mesh, Sphere};
use sha2::{Digest, Sha256};

const MAGIC: &Magic = b"gaunt spheres 1\n";
/// No file of ours is larger.
const LARGEST: u64 = 1 << 24;

impl Cache {
    /// The set of `count` spheres that was kept for these meshes, if it is there and whole.
    pub(crate) fn find(&self, meshes: &[&Mesh], count: usize) -> Option<SphereSet> {
        let set = decoded(&self.read(&name(meshes, count), MAGIC, LARGEST)?)?;
        (set.spheres.len() <= count.max(1)).then_some(set)
    }

    /// Keeps a set, if it can.
    pub(crate) fn keep(&self, meshes: &[&Mesh], count: usize, set: &SphereSet) {
        self.write(&name(meshes, count), MAGIC, &encoded(set));
    }
}

fn name(meshes: &[&Mesh], count: usize) -> String {
    let mut hash = Sha256::new();
    hash.update(MAGIC);
    hash.update(FIT_VERSION.to_le_bytes());
    hash.update((count as u64).to_le_bytes());
    for mesh in meshes {
        hash.update((mesh.positions.len() as u64).to_le_bytes());
        hash.update((mesh.triangles.len() as u64).to_le_bytes());
        for corner in mesh.positions.iter().flatten() {
            hash.update(corner.to_le_bytes());
        }
        for index in mesh.triangles.iter().flatten() {
            hash.update(index.to_le_bytes());
        }
    }
    named(hash) + ".spheres"
}

/// A set as bytes: the ratio (not a number for none), then the spheres as four numbers each.
fn encoded(set: &SphereSet) -> Vec<u8> {
    let ratio = set.outside_volume_ratio.unwrap_or(f32::NAN);
    let spheres = set.spheres.iter().flat_map(|s| {
        let [x, y, z] = s.center;
        [x, y, z, s.radius]
    });
    let numbers = std::iter::once(ratio).chain(spheres);
    numbers.flat_map(f32::to_le_bytes).collect()
}

fn decoded(bytes: &[u8]) -> Option<SphereSet> {
    let numbers = fours(bytes, f32::from_le_bytes)?;
    let (ratio, numbers) = numbers.split_first()?;
    let (spheres, rest) = numbers.as_chunks::<4>();
    rest.is_empty().then(|| SphereSet {
        spheres: spheres
            .iter()
            .map(|&[x, y, z, radius]| Sphere {
                center: [x, y, z],
                radius,
            })
            .collect(),
        outside_volume_ratio: Some(*ratio).filter(|ratio| !ratio.is_nan()),
    })
}
