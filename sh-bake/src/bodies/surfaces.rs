//! The surfaces of a scene's bodies.

use crate::cache::{Cache, surface_key};
use crate::progress::Progress;
use crate::surface::{Part, bake_with};
use rayon::prelude::*;
use sh_scene::{Object, SurfaceSamples};
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

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

/// Samples found, how long it took, and whether they were in the cache.
type Found = (SurfaceSamples, Duration, bool);

/// Samples the surfaces of bodies, each of which is some of the objects, the first with the spheres of all. Bodies that
/// are alike are sampled once and reported once.
pub(crate) fn sample(
    objects: &mut [Object],
    bodies: &[Range<usize>],
    cache: Option<&Cache>,
    progress: &(dyn Fn(Progress) + Sync),
) -> Vec<SurfaceReport> {
    /// Steps of a sphere.
    const STEPS: usize = 100;
    let parts = |body: &Range<usize>| -> Vec<Part> {
        let objects = objects[body.clone()].iter();
        objects.map(|o| (&o.mesh, &o.material)).collect()
    };
    let spheres = |body: &Range<usize>| &objects[body.start].spheres[..];
    let mut wanted: BTreeMap<String, usize> = BTreeMap::new();
    let mut keys = Vec::new();
    for (b, body) in bodies.iter().enumerate() {
        let key = surface_key(&parts(body), spheres(body));
        wanted.entry(key.clone()).or_insert(b);
        keys.push(key);
    }
    let total = wanted
        .values()
        .map(|&b| STEPS * spheres(&bodies[b]).len())
        .sum();
    let sum = AtomicUsize::new(0);
    let tell = |more: usize| {
        let done = sum.fetch_add(more, Ordering::Relaxed) + more;
        let stage = "sampling surfaces";
        progress(Progress { stage, done, total });
    };
    tell(0);
    let find = |(key, b): (&String, &usize)| {
        let (start, body) = (Instant::now(), &bodies[*b]);
        let (parts, spheres) = (parts(body), spheres(body));
        let found = cache.and_then(|cache| cache.find_surface(key, spheres.len()));
        let cached = found.is_some();
        if cached {
            tell(STEPS * spheres.len());
        }
        let mut samples = found.unwrap_or_else(|| {
            let samples = bake_with(&parts, spheres, &|| tell(STEPS));
            if let Some(cache) = cache {
                cache.keep_surface(key, &samples);
            }
            samples
        });
        if cached {
            samples.expose(spheres);
        }
        (key.clone(), (samples, start.elapsed(), cached))
    };
    let found: Vec<(String, Found)> = wanted.par_iter().map(find).collect();
    let found: BTreeMap<String, Found> = found.into_iter().collect();

    let mut reports = Vec::new();
    for (b, (body, key)) in bodies.iter().zip(&keys).enumerate() {
        let Some((samples, time, cached)) = found.get(key) else {
            continue;
        };
        let object = &mut objects[body.start];
        object.surface = samples.clone();
        if wanted.get(key) == Some(&b) {
            reports.push(SurfaceReport {
                name: object.name.clone(),
                spheres: samples.spheres(),
                points: samples.points.len(),
                bytes: samples.bytes(),
                time: *time,
                cached: *cached,
            });
        }
    }
    reports
}
