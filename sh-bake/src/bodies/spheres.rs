//! The sphere sets of a scene's meshes.

use super::once::Bake;
use crate::cache::{Baked, Ingredients, Key, fours};
use crate::spheres::{FIT_VERSION, SphereSet};
use sh_scene::{Mesh, Sphere};

/// A set of at most `count` spheres for the parts of a mesh.
pub(crate) struct Fit<'a> {
    pub parts: Vec<&'a Mesh>,
    pub count: usize,
}

/// Steps of a mesh for each of its spheres, and as if it had some more: what a fit takes whatever its size.
const STEPS: usize = 100;
const MORE: usize = 8;

impl Bake for Fit<'_> {
    type Baked = SphereSet;

    const STAGE: &'static str = "fitting spheres";

    fn key(&self) -> Key {
        let mut key = Ingredients::<SphereSet>::new();
        key.whole([self.count as u32]);
        for mesh in &self.parts {
            key.numbers(mesh.positions.as_flattened().iter().copied());
            key.whole(mesh.triangles.as_flattened().iter().copied());
        }
        key.key()
    }

    fn steps(&self) -> usize {
        STEPS * (self.count + MORE)
    }

    fn make(&self, tell: &(dyn Fn(usize) + Sync)) -> SphereSet {
        let steps = self.steps() as f32;
        SphereSet::fit_with(&self.parts, self.count, &|part| {
            tell((part * steps) as usize);
        })
    }

    fn kept(&self, kept: SphereSet) -> Option<SphereSet> {
        Some(kept).filter(|set| set.spheres.len() <= self.count.max(1))
    }
}

impl Baked for SphereSet {
    const NAME: &str = "spheres";
    const VERSION: u32 = FIT_VERSION;
    const MOST: u64 = 1 << 24;

    /// The ratio (not a number for none), then the spheres as four numbers each.
    fn encoded(&self) -> Vec<u8> {
        let ratio = self.outside_volume_ratio.unwrap_or(f32::NAN);
        let spheres = self.spheres.iter().flat_map(|s| {
            let [x, y, z] = s.center;
            [x, y, z, s.radius]
        });
        let numbers = std::iter::once(ratio).chain(spheres);
        numbers.flat_map(f32::to_le_bytes).collect()
    }

    fn decoded(bytes: &[u8]) -> Option<Self> {
        let numbers = fours(bytes, f32::from_le_bytes)?;
        let (ratio, numbers) = numbers.split_first()?;
        let (spheres, rest) = numbers.as_chunks::<4>();
        rest.is_empty().then(|| Self {
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
}
