//! The truth over many receivers: paths on all threads.

use crate::Error;
use clap::ValueEnum;
use rayon::prelude::*;
use sh_reference::paths::{self, PathTracer, Radiance};
use sh_scene::{Receiver, Scene, Settings};
use std::sync::atomic::{AtomicUsize, Ordering};

/// The light that the truth is given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Source {
    /// The environment map and lamps as they are.
    #[default]
    Map,
    /// What spherical harmonics of the scene's order make of them, as the passes have it.
    Projected,
}

impl From<Source> for paths::Source {
    fn from(source: Source) -> Self {
        match source {
            Source::Map => Self::Map,
            Source::Projected => Self::Projected,
        }
    }
}

/// How often bodies reflect in a scene: 0 where nothing is said of indirect light.
pub fn bounces(settings: &Settings) -> u32 {
    settings.indirect.map_or(0, |indirect| indirect.bounces)
}

/// A path tracer for a scene whose meshes and maps have been checked.
///
/// # Errors
/// Where the scene has no light.
pub fn tracer(scene: &Scene, options: paths::Options) -> Result<PathTracer<'_>, Error> {
    Ok(PathTracer::new(scene, options)?)
}

/// What receivers reflect at albedo 1, black where there is none to light. `first` is the number of the first among all,
/// from which its random numbers follow: receivers may be given in any portions. `progress` is called with the finished
/// part now and then, from any thread.
pub fn trace(
    tracer: &PathTracer,
    receivers: &[Receiver],
    first: usize,
    paths: u32,
    progress: &(dyn Fn(f32) + Sync),
) -> Vec<Radiance> {
    each(receivers, progress, |i, receiver| {
        let [point, normal] = place(receiver);
        tracer.radiance(point, normal, paths, (first + i) as u32)
    })
}

/// The mean of what those receivers that mirror light see in their lobe, looked at from `eye`; black for all others. As
/// [`trace`] for the rest.
pub fn trace_mirrored(
    tracer: &PathTracer,
    (receivers, eye): (&[Receiver], [f32; 3]),
    first: usize,
    paths: u32,
    progress: &(dyn Fn(f32) + Sync),
) -> Vec<Radiance> {
    each(receivers, progress, |i, receiver| {
        let Some(roughness) = receiver.roughness() else {
            return Radiance::default();
        };
        let [point, normal] = place(receiver);
        let away = [0, 1, 2].map(|k| f64::from(eye[k]) - point[k]);
        let far = away.iter().map(|c| c * c).sum::<f64>().sqrt();
        let view = away.map(|c| c / far.max(f64::MIN_POSITIVE));
        let lobe = (view, f64::from(roughness));
        tracer.mirrored([point, normal], lobe, paths, (first + i) as u32)
    })
}

fn place(receiver: &Receiver) -> [[f64; 3]; 2] {
    [receiver.position, receiver.normal].map(|v| v.map(f64::from))
}

/// Something of every receiver that is there, on all threads.
fn each(
    receivers: &[Receiver],
    progress: &(dyn Fn(f32) + Sync),
    found: impl Fn(usize, &Receiver) -> Radiance + Sync,
) -> Vec<Radiance> {
    let done = AtomicUsize::new(0);
    let one = |(i, receiver): (usize, &Receiver)| {
        let finished = 1 + done.fetch_add(1, Ordering::Relaxed);
        if finished.is_multiple_of(512) {
            progress(finished as f32 / receivers.len() as f32);
        }
        if receiver.covered == 0 {
            return Radiance::default();
        }
        found(i, receiver)
    };
    receivers.par_iter().enumerate().map(one).collect()
}

/// In single precision.
pub fn narrow(radiance: [f64; 3]) -> [f32; 3] {
    radiance.map(|c| c as f32)
}
