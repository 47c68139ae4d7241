//! The folder, and files that are whole or as good as none.

use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

/// The last bytes of a file are a hash of this length.
const HASH: usize = 32;

/// A folder of sphere sets and surface samples.
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

    /// What a file holds between its magic and its hash, if it is there, whole, and no longer than `most` bytes.
    pub(super) fn read(&self, name: &str, magic: &[u8], most: u64) -> Option<Vec<u8>> {
        let path = self.folder.join(name);
        let length = std::fs::metadata(&path).ok()?.len();
        let mut bytes = (length <= most).then(|| std::fs::read(&path).ok())??;
        let end = bytes.len().checked_sub(HASH)?;
        let whole = Sha256::digest(&bytes[..end])[..] == bytes[end..];
        if !whole || !bytes.starts_with(magic) {
            return None;
        }
        bytes.truncate(end);
        bytes.drain(..magic.len());
        Some(bytes)
    }

    /// Writes a file, if it can.
    pub(super) fn write(&self, name: &str, magic: &[u8], content: &[u8]) {
        static NUMBER: AtomicUsize = AtomicUsize::new(0);
        let path = self.folder.join(name);
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        let part = path.with_extension(format!("{}-{number}.part", std::process::id()));
        let mut bytes = [magic, content].concat();
        let hash = Sha256::digest(&bytes);
        bytes.extend(hash);
        let written = std::fs::create_dir_all(&self.folder)
            .and_then(|()| std::fs::write(&part, bytes))
            .and_then(|()| std::fs::rename(&part, &path));
        if written.is_err() {
            // What cannot be kept is made again next time.
            let _ = std::fs::remove_file(&part);
        }
    }
}
