//! Finding things once for all bodies that are alike, side by side, or taking them from the cache.

use crate::cache::{Baked, Cache, Key};
use crate::progress::Progress;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// What has to be found for a body.
pub(crate) trait Bake: Sync {
    /// What that is.
    type Baked: Baked + Send + Sync;

    /// What is being done, as progress tells it.
    const STAGE: &'static str;

    /// What it is found by. Bodies with one key get the same.
    fn key(&self) -> Key;

    /// How many steps of progress it takes.
    fn steps(&self) -> usize;

    /// Finds it, telling how many of the steps are done.
    fn make(&self, tell: &(dyn Fn(usize) + Sync)) -> Self::Baked;

    /// What was kept, with what is not on disk; none where it cannot be this body's.
    fn kept(&self, kept: Self::Baked) -> Option<Self::Baked>;
}

/// What was found for a body.
pub(crate) struct Found<T> {
    /// It.
    pub what: Arc<T>,
    /// Time for finding it, or for reading it from the cache.
    pub time: Duration,
    /// Whether it comes from the cache.
    pub cached: bool,
    /// Whether no body before is alike.
    pub first: bool,
}

/// Finds what each body needs, in their order.
pub(crate) fn once<B: Bake>(
    bodies: &[B],
    cache: Option<&Cache>,
    progress: &(dyn Fn(Progress) + Sync),
) -> Vec<Found<B::Baked>> {
    let keys: Vec<Key> = bodies.iter().map(Bake::key).collect();
    let mut first = BTreeMap::new();
    let alike: Vec<usize> = (keys.iter().enumerate())
        .map(|(body, key)| *first.entry(key).or_insert(body))
        .collect();
    let firsts: Vec<usize> = (0..bodies.len()).filter(|&b| alike[b] == b).collect();
    let total = firsts.iter().map(|&body| bodies[body].steps()).sum();
    let sum = AtomicUsize::new(0);
    let tell = |more: usize| {
        let done = sum.fetch_add(more, Ordering::Relaxed) + more;
        let stage = B::STAGE;
        progress(Progress { stage, done, total });
    };
    tell(0);
    let find = |&index: &usize| {
        let (start, body, key) = (Instant::now(), &bodies[index], &keys[index]);
        // Steps are told from several threads in any order: what counts is the largest so far.
        let (all, told) = (body.steps(), AtomicUsize::new(0));
        let done = |steps: usize| {
            let before = told.fetch_max(steps.min(all), Ordering::Relaxed);
            tell(steps.min(all).saturating_sub(before));
        };
        let kept = cache.and_then(|cache| cache.find(key));
        let kept = kept.and_then(|kept| body.kept(kept));
        let cached = kept.is_some();
        let what = kept.unwrap_or_else(|| {
            let what = body.make(&done);
            if let Some(cache) = cache {
                cache.keep(key, &what);
            }
            what
        });
        done(all);
        (index, (Arc::new(what), start.elapsed(), cached))
    };
    let found: BTreeMap<usize, _> = firsts.par_iter().map(find).collect();
    let all = alike.iter().enumerate();
    all.map(|(body, alike)| {
        let (what, time, cached) = &found[alike];
        Found {
            what: Arc::clone(what),
            time: *time,
            cached: *cached,
            first: *alike == body,
        }
    })
    .collect()
}
