//! A plan on the CPU.

use super::measured::{FRAMES, Idle, Measured, idle, kept, median, middle_and_spread, pose};
use crate::Error;
use sh_bake::Loaded;
use sh_cpu::Frames;
use sh_scene::{Plan, View};
use std::time::Instant;

/// Runs some frames; a dispatch is a task that is handed to the threads.
pub(super) fn measure(loaded: &mut Loaded, plan: &Plan, view: &View) -> Result<Measured, Error> {
    let size = (view.width, view.height);
    let mut frames = Frames::default();
    frames.start(&loaded.scene, plan);
    let mut last = frames.render(&loaded.scene, plan, size, &|_| {})?;
    let mut times = vec![Vec::new(); plan.passes.len()];
    let mut whole = Vec::new();
    for number in 1..=FRAMES {
        pose(loaded, number);
        let start = Instant::now();
        last = frames.render(&loaded.scene, plan, size, &|_| {})?;
        whole.push(start.elapsed().as_secs_f64() * 1e3);
        for (times, work) in times.iter_mut().zip(&last.work) {
            times.push(work.time.as_secs_f64() * 1e3);
        }
    }
    let nodes = frames.nodes();
    let mut all = idle(&loaded.scene, plan, &last.changes, nodes);
    let tasks: Vec<u64> = last.work.iter().map(|work| work.tasks).collect();
    all.extend(kept(plan, &tasks));
    let mut add = |name, reason| all.push(Idle { name, reason });
    if last.too_small > 0 {
        let count = last.too_small;
        add(
            "spheres",
            format!("{count} times a node of a cluster's cut was too small to matter there."),
        );
    }
    if last.lamps_below > 0 {
        let count = last.lamps_below;
        add(
            "lamps",
            format!("{count} times a lamp was below the horizon of a cluster."),
        );
    }
    Ok(Measured {
        dispatches: tasks,
        ms: times.into_iter().map(median).collect(),
        frame_ms: middle_and_spread(whole),
        memory: last.buffers,
        changes: last.changes,
        idle: all,
        clock: "wall",
    })
}
