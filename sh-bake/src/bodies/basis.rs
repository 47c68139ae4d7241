//! The functions in which irradiance of a scene's bodies is told.

use super::once::{Bake, once};
use crate::basis::{BASIS_VERSION, irradiance_basis};
use crate::cache::{Baked, Cache, Ingredients, Key, fours};
use crate::progress::Progress;
use crate::surface::Part;
use sh_scene::basis::{BasisParts, MOST_COEFFICIENTS, Patch};
use sh_scene::{BasisSample, IrradianceBasis, Object};
use std::ops::Range;
use std::sync::Arc;
use std::time::Duration;

/// A body's functions, as far as a person wants to know.
#[derive(Clone, Debug)]
pub struct BasisReport {
    /// The name of the first of its objects.
    pub name: String,
    /// How many functions it has; 0 where nothing of it can be lit.
    pub functions: usize,
    /// What they tell of the light that they were found by, 0 to 1.
    pub held: f32,
    /// What they take.
    pub bytes: usize,
    /// Time for finding them, there or in the cache.
    pub time: Duration,
    /// Whether they come from the cache.
    pub cached: bool,
}

/// Finds `count` functions for each of some bodies, each of which is some of the objects: the first gets them. Bodies that are
/// alike share them and are reported once.
pub(crate) fn tell(
    objects: &mut [Object],
    bodies: &[Range<usize>],
    count: usize,
    cache: Option<&Cache>,
    progress: &(dyn Fn(Progress) + Sync),
) -> Vec<BasisReport> {
    let told = |body: &Range<usize>| Told {
        parts: objects[body.clone()]
            .iter()
            .map(|o| (&o.mesh, &o.material))
            .collect(),
        count,
    };
    let wanted: Vec<Told> = bodies.iter().map(told).collect();
    let found = once(&wanted, cache, progress);
    let mut reports = Vec::new();
    let mut shared = std::collections::HashMap::new();
    for (body, found) in bodies.iter().zip(found) {
        let object = &mut objects[body.start];
        // What is shared stays one: it is known again by that.
        let basis = shared
            .entry(Arc::as_ptr(&found.what))
            .or_insert_with(|| found.what.0.clone().map(Arc::new));
        object.basis.clone_from(basis);
        if found.first {
            let basis = found.what.0.as_ref();
            reports.push(BasisReport {
                name: object.name.clone(),
                functions: basis.map_or(0, IrradianceBasis::count),
                held: basis.map_or(0.0, |basis| basis.held(count)),
                bytes: basis.map_or(0, IrradianceBasis::bytes),
                time: found.time,
                cached: found.cached,
            });
        }
    }
    reports
}

/// A body whose irradiance is to be told: found by all that light may meet.
struct Told<'a> {
    parts: Vec<Part<'a>>,
    count: usize,
}

/// Functions of a body, if anything of it can be lit.
#[derive(Debug, PartialEq)]
pub(crate) struct Kept(Option<IrradianceBasis>);

/// Steps of progress.
const STEPS: usize = 100;

impl Bake for Told<'_> {
    type Baked = Kept;

    const STAGE: &'static str = "finding functions of irradiance";

    fn key(&self) -> Key {
        let mut key = Ingredients::<Kept>::new();
        key.whole([self.count as u32]);
        for (mesh, material) in &self.parts {
            key.surface(mesh, material);
        }
        key.key()
    }

    fn steps(&self) -> usize {
        STEPS
    }

    fn make(&self, tell: &(dyn Fn(usize) + Sync)) -> Kept {
        let done = |part: f32| tell((part * STEPS as f32) as usize);
        Kept(irradiance_basis(&self.parts, self.count, &done))
    }

    fn kept(&self, kept: Kept) -> Option<Kept> {
        let fits = kept.0.as_ref().is_none_or(|b| b.count() <= self.count);
        fits.then_some(kept)
    }
}

/// Numbers of a sample, of a patch, and of what a function gives another.
const SAMPLE: usize = 9;
const PATCH: usize = size_of::<Patch>() / 4;
const OWN: usize = 3;

impl Baked for Kept {
    const NAME: &str = "basis";
    const VERSION: u32 = BASIS_VERSION;
    const MOST: u64 = 1 << 25;

    /// How many functions, samples, patches and pairs of a patch with what its body gives it there are, the area of a sample,
    /// and everything else; nothing of a body of which nothing can be lit.
    fn encoded(&self) -> Vec<u8> {
        let Some(basis) = &self.0 else {
            return Vec::new();
        };
        let parts = basis.parts();
        let counts = [
            basis.count(),
            parts.samples.len(),
            basis.patches(),
            parts.own.len(),
        ];
        let mut bytes = Vec::new();
        for count in counts {
            bytes.extend((count as u32).to_le_bytes());
        }
        let samples = parts.samples.iter();
        let samples = samples.flat_map(|s| [s.position, s.normal, s.albedo].concat());
        let patches: &[f32] = bytemuck::cast_slice(&parts.patches);
        let numbers = std::iter::once(parts.area)
            .chain(samples)
            .chain(parts.values.iter().copied())
            .chain(patches.iter().copied())
            .chain(parts.lobes.as_flattened().iter().copied())
            .chain(parts.own.as_flattened().iter().copied())
            .chain(parts.held.iter().copied());
        bytes.extend(numbers.flat_map(f32::to_le_bytes));
        bytes
    }

    fn decoded(bytes: &[u8]) -> Option<Self> {
        if bytes.is_empty() {
            return Some(Self(None));
        }
        let (head, rest) = bytes.split_at_checked(16)?;
        let counts = fours(head, u32::from_le_bytes)?;
        let [count, samples, patches, own] = counts[..] else {
            return None;
        };
        let [count, samples, patches, own] = [count, samples, patches, own].map(|x| x as usize);
        let numbers = fours(rest, f32::from_le_bytes)?;
        let mut rest = &numbers[..];
        let mut take = |many: usize, each: usize| {
            let (taken, left) = rest.split_at_checked(many.checked_mul(each)?)?;
            rest = left;
            Some(taken)
        };
        let area = take(1, 1)?[0];
        let sample = |x: &[f32; SAMPLE]| {
            let [a, b, c, d, e, f, g, h, i] = *x;
            BasisSample {
                position: [a, b, c],
                normal: [d, e, f],
                albedo: [g, h, i],
            }
        };
        let parts = BasisParts {
            samples: take(samples, SAMPLE)?
                .as_chunks()
                .0
                .iter()
                .map(sample)
                .collect(),
            area,
            values: take(samples, count)?.to_vec(),
            patches: bytemuck::cast_slice(take(patches, PATCH)?).to_vec(),
            lobes: take(patches, MOST_COEFFICIENTS)?.as_chunks().0.to_vec(),
            own: take(own, OWN)?.as_chunks().0.to_vec(),
            held: take(count, 1)?.to_vec(),
        };
        if !rest.is_empty() {
            return None;
        }
        Some(Self(Some(IrradianceBasis::new(parts)?)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use sh_scene::Material;

    #[test]
    fn functions_come_back_bit_by_bit() {
        let mesh = crate::shapes::rounded_box(glam::Vec3::ONE, 0.1);
        let white = Material::diffuse([1.0, 0.5, 0.2]);
        let kept = Kept(irradiance_basis(&[(&mesh, &white)], 5, &|_| {}));
        let bytes = kept.encoded();
        assert_eq!(Kept::decoded(&bytes), Some(kept));
        assert_eq!(Kept::decoded(&Kept(None).encoded()), Some(Kept(None)));
        for cut in (1..bytes.len()).step_by(997).chain([bytes.len() - 4]) {
            assert_eq!(Kept::decoded(&bytes[..cut]), None, "{cut}");
        }
        let mut wrong = bytes.clone();
        // A sample that is nowhere is no body's, but only numbers that are told count: the first function's.
        let at = 16 + 4 * (1 + 1024 * SAMPLE);
        wrong[at..at + 4].copy_from_slice(&f32::NAN.to_le_bytes());
        assert_eq!(Kept::decoded(&wrong), None);
    }
}
