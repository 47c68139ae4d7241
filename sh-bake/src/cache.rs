//! Sphere sets kept on disk, so that a mesh is fitted once.
//!
//! A set is found by what it was fitted to: its file is named after a SHA-256 hash of the positions, the triangles, the
//! count and the version of the fit. So nothing is ever out of date, and the folder can be emptied at any moment. A
//! file ends in a hash of all before it; one that is cut off or changed is as good as none, and is replaced. Files are
//! written under another name first, so that several programs can share the folder. Where it cannot be written,
//! nothing is kept, and that is no error.

use crate::SphereSet;
use crate::spheres::FIT_VERSION;
use sh_scene::{Mesh, Sphere};
use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

/// The first bytes of a file.
const MAGIC: &[u8; 16] = b"gaunt spheres 1\n";
/// The last bytes of a file are a hash of this length.
const HASH: usize = 32;
/// No file of ours is larger.
const LARGEST: u64 = 1 << 24;

/// A folder of sphere sets.
///
/// ```no_run
/// use sh_bake::{Cache, default_scene};
/// let cache = Cache::of_user();
/// let (_, report) = default_scene(cache.as_ref(), &|_| {});
/// println!("{} sets were there already", report.fits.iter().filter(|fit| fit.cached).count());
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cache {
    folder: PathBuf,
}

impl Cache {
    /// The environment variable that names another folder than the user's own, or none at all where it is empty.
    pub const VARIABLE: &str = "GAUNT_CACHE";

    /// A cache in this folder, which is made when the first set is kept.
    pub fn at(folder: impl Into<PathBuf>) -> Self {
        Self {
            folder: folder.into(),
        }
    }

    /// The user's own: in the folder that [`Cache::VARIABLE`] names, or else in `gaunt` in the folder that the system
    /// has for such things (`~/.cache` on Linux). None where the variable is empty or there is no such folder.
    pub fn of_user() -> Option<Self> {
        match std::env::var_os(Self::VARIABLE) {
            Some(folder) if folder.is_empty() => None,
            Some(folder) => Some(Self::at(folder)),
            None => dirs::cache_dir().map(|folder| Self::at(folder.join("gaunt"))),
        }
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The set of `count` spheres that was kept for these meshes, if it is there and whole.
    pub(crate) fn find(&self, meshes: &[&Mesh], count: usize) -> Option<SphereSet> {
        let path = self.path(meshes, count);
        let length = std::fs::metadata(&path).ok()?.len();
        let bytes = (length <= LARGEST).then(|| std::fs::read(&path).ok())??;
        let set = decoded(&bytes)?;
        (set.spheres.len() <= count.max(1)).then_some(set)
    }

    /// Keeps a set, if it can.
    pub(crate) fn keep(&self, meshes: &[&Mesh], count: usize, set: &SphereSet) {
        static NUMBER: AtomicUsize = AtomicUsize::new(0);
        let path = self.path(meshes, count);
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        let part = path.with_extension(format!("{}-{number}.part", std::process::id()));
        let written = std::fs::create_dir_all(&self.folder)
            .and_then(|()| std::fs::write(&part, encoded(set)))
            .and_then(|()| std::fs::rename(&part, &path));
        if written.is_err() {
            // What cannot be kept is fitted again next time.
            let _ = std::fs::remove_file(&part);
        }
    }

    fn path(&self, meshes: &[&Mesh], count: usize) -> PathBuf {
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
        let name: String = hash
            .finalize()
            .iter()
            .map(|byte| format!("{byte:02x}"))
            .collect();
        self.folder.join(name + ".spheres")
    }
}

/// A set as bytes: [`MAGIC`], the ratio (not a number for none), the spheres as four numbers each, the hash.
fn encoded(set: &SphereSet) -> Vec<u8> {
    let mut bytes = MAGIC.to_vec();
    bytes.extend(set.outside_volume_ratio.unwrap_or(f32::NAN).to_le_bytes());
    for Sphere {
        center: [x, y, z],
        radius,
    } in &set.spheres
    {
        bytes.extend(
            [x, y, z, radius]
                .into_iter()
                .flat_map(|number| number.to_le_bytes()),
        );
    }
    let hash = Sha256::digest(&bytes);
    bytes.extend(hash);
    bytes
}

fn decoded(bytes: &[u8]) -> Option<SphereSet> {
    let (content, hash) = bytes.split_at_checked(bytes.len().checked_sub(HASH)?)?;
    let numbers = content.strip_prefix(MAGIC)?;
    if Sha256::digest(content)[..] != *hash || numbers.len() % 16 != 4 {
        return None;
    }
    let number = |four: &[u8]| four.try_into().ok().map(f32::from_le_bytes);
    let (ratio, spheres) = numbers.split_at(4);
    let sphere = |sixteen: &[u8]| {
        let part = |k: usize| number(&sixteen[4 * k..4 * k + 4]);
        Some(Sphere {
            center: [part(0)?, part(1)?, part(2)?],
            radius: part(3)?,
        })
    };
    Some(SphereSet {
        spheres: spheres
            .chunks_exact(16)
            .map(sphere)
            .collect::<Option<_>>()?,
        outside_volume_ratio: number(ratio).filter(|ratio| !ratio.is_nan()),
    })
}
