//! A plan on the GPU.

use super::measured::{FRAMES, Idle, Measured, idle, kept, median, middle_and_spread, pose};
use crate::Error;
use crate::gpu::{Gpu, Stamps};
use sh_bake::Loaded;
use sh_gpu::Renderer;
use sh_scene::{Plan, Tracker, View};
use std::time::Instant;

/// Runs some frames. Times are the device's own; where its clock is none, every part of a frame is submitted by itself
/// and waited for.
pub(super) fn measure(
    gpu: &Gpu,
    loaded: &mut Loaded,
    plan: &Plan,
    view: &View,
) -> Result<Measured, Error> {
    let queue = &gpu.queue;
    let renderer = Renderer::new(&gpu.device, queue, &loaded.scene, plan, view)?;
    let stamps = Stamps::new(gpu, renderer.timestamps());
    let mut tracker = Tracker::default();
    let mut times = vec![Vec::new(); plan.passes.len()];
    let mut whole = Vec::new();
    let (mut uploaded, mut dispatches) = (0, Vec::new());
    for number in 0..=FRAMES {
        if number > 0 {
            pose(loaded, number);
        }
        let start = Instant::now();
        let scene = &loaded.scene;
        tracker.relight(scene)?;
        if plan.is_blocked() {
            tracker.place(scene);
        }
        if number > 0 && loaded.motion.bends() {
            renderer.update_meshes(queue, scene)?;
        }
        if number > 0 && loaded.motion.turns() {
            renderer.update_environment(queue, &scene.environment)?;
        }
        let before = renderer.uploaded();
        if let Some(light) = tracker.light() {
            renderer.prepare(queue, scene, tracker.forest(), light, view)?;
        }
        uploaded = renderer.uploaded() - before;
        dispatches = renderer.dispatches();
        let mut spent = vec![0.0; plan.passes.len()];
        match &stamps {
            Some(stamps) => {
                gpu.submit(|encoder| {
                    renderer.record(encoder, Some(stamps.queries()));
                    stamps.resolve(encoder);
                })?;
                let read = stamps.read(gpu)?;
                let times = renderer.times(&read, queue.get_timestamp_period());
                for (spent, (_, nanoseconds)) in spent.iter_mut().zip(times) {
                    *spent = nanoseconds * 1e-6;
                }
            }
            None => {
                gpu.submit(|_| {})?;
                for part in 0..renderer.parts() {
                    let start = Instant::now();
                    let mut pass = None;
                    gpu.submit(|encoder| pass = renderer.record_part(encoder, part))?;
                    if let Some(pass) = pass {
                        spent[pass] += start.elapsed().as_secs_f64() * 1e3;
                    }
                }
            }
        }
        renderer.submitted();
        if number > 0 {
            whole.push(start.elapsed().as_secs_f64() * 1e3);
            for (times, spent) in times.iter_mut().zip(spent) {
                times.push(spent);
            }
        }
    }
    let nodes = tracker.forest().nodes().len();
    let changes = tracker.changes().clone();
    let mut all = idle(&loaded.scene, plan, &changes, nodes);
    let dispatches: Vec<u64> = dispatches.into_iter().map(|count| count as u64).collect();
    all.extend(kept(plan, &dispatches));
    let reason = format!("Only what is different is uploaded: {uploaded} bytes a frame.");
    let name = "uploads";
    all.push(Idle { name, reason });
    Ok(Measured {
        dispatches,
        ms: times.into_iter().map(median).collect(),
        frame_ms: middle_and_spread(whole),
        memory: renderer.buffers(),
        changes,
        idle: all,
        clock: match stamps {
            Some(_) => "timestamps of the device",
            None => "wall, each part of a frame submitted by itself",
        },
    })
}
