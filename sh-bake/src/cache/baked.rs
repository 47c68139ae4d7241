//! What is kept: what it is found by, and its bytes.

use super::folder::Cache;
use sh_scene::{Material, Mesh, Sphere};
use sha2::{Digest, Sha256};
use std::marker::PhantomData;

/// Something that is found once and kept on disk.
pub(crate) trait Baked: Sized {
    /// What it is called: the ending of its files, and the first word in them.
    const NAME: &str;
    /// Changes whenever the same input may give something else than before: what was kept is then of no use.
    const VERSION: u32;
    /// No file of it is larger, in bytes.
    const MOST: u64;

    /// As bytes.
    fn encoded(&self) -> Vec<u8>;

    /// From such bytes; none where they are no such thing.
    fn decoded(bytes: &[u8]) -> Option<Self>;
}

/// What something is found by: a hash of all that decides it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Key(String);

/// A key in the making.
pub(crate) struct Ingredients<T> {
    hash: Sha256,
    of: PhantomData<T>,
}

impl<T: Baked> Ingredients<T> {
    /// Nothing but the version.
    pub fn new() -> Self {
        let mut hash = Sha256::new();
        hash.update(magic::<T>());
        hash.update(T::VERSION.to_le_bytes());
        let of = PhantomData;
        Self { hash, of }
    }

    /// Numbers, and how many.
    pub fn numbers(&mut self, numbers: impl IntoIterator<Item = f32>) -> &mut Self {
        self.bytes(numbers.into_iter().flat_map(f32::to_le_bytes).collect())
    }

    /// Whole numbers, and how many.
    pub fn whole(&mut self, numbers: impl IntoIterator<Item = u32>) -> &mut Self {
        self.bytes(numbers.into_iter().flat_map(u32::to_le_bytes).collect())
    }

    /// Bytes, and how many.
    pub fn bytes(&mut self, bytes: Vec<u8>) -> &mut Self {
        self.hash.update((bytes.len() as u64).to_le_bytes());
        self.hash.update(bytes);
        self
    }

    /// The shape of a mesh: positions, normals, triangles.
    pub fn mesh(&mut self, mesh: &Mesh) -> &mut Self {
        for vectors in [&mesh.positions, &mesh.normals] {
            self.numbers(vectors.as_flattened().iter().copied());
        }
        self.whole(mesh.triangles.as_flattened().iter().copied())
    }

    /// A mesh and how it reflects: shape, colours and texture.
    pub fn surface(&mut self, mesh: &Mesh, material: &Material) -> &mut Self {
        self.mesh(mesh);
        self.numbers(mesh.colors.as_flattened().iter().copied());
        self.numbers(mesh.uvs.as_flattened().iter().copied());
        self.numbers(material.albedo);
        if let Some(texture) = &material.texture {
            self.whole([texture.width, texture.height]);
            self.bytes(texture.rgba.clone());
        }
        self
    }

    /// Spheres.
    pub fn spheres(&mut self, spheres: &[Sphere]) -> &mut Self {
        let numbers = spheres.iter().flat_map(|s| {
            let [x, y, z] = s.center;
            [x, y, z, s.radius]
        });
        self.numbers(numbers)
    }

    /// The key.
    pub fn key(&mut self) -> Key {
        let digits = self.hash.finalize_reset();
        Key(digits.iter().map(|byte| format!("{byte:02x}")).collect())
    }
}

impl Cache {
    /// What was kept under a key, if it is there and whole.
    pub(crate) fn find<T: Baked>(&self, key: &Key) -> Option<T> {
        T::decoded(&self.read(&name::<T>(key), &magic::<T>(), T::MOST)?)
    }

    /// Keeps something under a key, if it can.
    pub(crate) fn keep<T: Baked>(&self, key: &Key, what: &T) {
        self.write(&name::<T>(key), &magic::<T>(), &what.encoded());
    }
}

fn name<T: Baked>(key: &Key) -> String {
    format!("{}.{}", key.0, T::NAME)
}

/// The first bytes of a file say what it holds.
fn magic<T: Baked>() -> Vec<u8> {
    format!("gaunt {} 1\n", T::NAME).into_bytes()
}

/// Numbers of four bytes each, or none where a byte is left over.
pub(crate) fn fours<T>(bytes: &[u8], from: fn([u8; 4]) -> T) -> Option<Vec<T>> {
    let (fours, rest) = bytes.as_chunks::<4>();
    rest.is_empty()
        .then(|| fours.iter().map(|four| from(*four)).collect())
}
