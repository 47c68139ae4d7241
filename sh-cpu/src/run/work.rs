//! What a frame was: time, tasks and memory.

use sh_scene::{Buffer, Plan};
use std::time::{Duration, Instant};

/// What a pass of a plan took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Wall time, that of finding spheres included, and for `upsample` that of what it had to shade anew.
    pub time: Duration,
    /// Tasks that were handed to the threads: tiles, clusters of receivers, rows of pixels or spheres. 0: there was
    /// nothing to do, because nothing had changed.
    pub tasks: u64,
    /// Bytes that the pass keeps and writes.
    pub bytes: u64,
}

/// What is told of each pass of a plan.
pub(super) struct Ledger {
    pub work: Vec<Work>,
    pub buffers: Vec<Buffer>,
}

impl Ledger {
    pub fn new(plan: &Plan) -> Self {
        Self {
            work: vec![Work::default(); plan.passes.len()],
            buffers: Vec::new(),
        }
    }

    /// Runs a pass, or a band of it, of so many tasks; `work` may tell of more.
    pub fn pass<T>(&mut self, pass: usize, work: impl FnOnce(&mut u64) -> T) -> T {
        let start = Instant::now();
        let mut tasks = 0;
        let result = work(&mut tasks);
        self.work[pass].time += start.elapsed();
        self.work[pass].tasks += tasks;
        result
    }

    /// Tells of memory; if it has grown since it was told of last, of the larger size.
    pub fn holds(&mut self, pass: usize, name: &'static str, bytes: usize) {
        let bytes = bytes as u64;
        let known = self.buffers.iter_mut();
        match known.into_iter().find(|b| b.pass == pass && b.name == name) {
            Some(buffer) => buffer.bytes = buffer.bytes.max(bytes),
            None => self.buffers.push(Buffer {
                name: name.into(),
                pass,
                bytes,
            }),
        }
    }

    /// Work with the bytes of its buffers.
    pub fn finish(mut self) -> (Vec<Work>, Vec<Buffer>) {
        for buffer in &self.buffers {
            self.work[buffer.pass].bytes += buffer.bytes;
        }
        (self.work, self.buffers)
    }
}

/// Adds up the time of stages.
#[derive(Default)]
pub(super) struct Stages(pub Vec<(&'static str, Duration)>);

impl Stages {
    pub fn time<T>(&mut self, stage: &'static str, work: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let result = work();
        let spent = start.elapsed();
        match self.0.iter_mut().find(|(name, _)| *name == stage) {
            Some((_, sum)) => *sum += spent,
            None => self.0.push((stage, spent)),
        }
        result
    }
}
