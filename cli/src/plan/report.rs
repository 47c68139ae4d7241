//! What `gaunt plan` tells: for a person and as JSON.

use super::measured::{Idle, Measured};
use crate::render::Choice;
use serde::Serialize;
use sh_scene::{Plan, View};
use std::borrow::Cow;
use std::fmt;

/// A pass of the plan, why it is there and what it costs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Planned {
    /// Its name.
    pub name: &'static str,
    /// What it computes an element for: samples, halves, pixels, spheres or points.
    pub at: &'static str,
    /// A sentence.
    pub reason: String,
    /// Dispatches and draws on a GPU, tasks that are handed to the threads on the CPU.
    pub dispatches: u64,
    /// What it keeps and writes.
    pub bytes: u64,
    /// Milliseconds a frame, measured.
    pub ms: f64,
    /// Milliseconds a frame that the number of operations lets expect on the CPU; none on a GPU.
    pub estimated_ms: Option<f64>,
}

/// A buffer or texture, or several.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Memory {
    /// What is in it.
    pub name: Cow<'static, str>,
    /// The pass that owns or first writes it.
    pub pass: &'static str,
    /// Its size.
    pub bytes: u64,
}

/// A plan and its cost.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// The scene.
    pub scene: String,
    /// `cpu` or `gpu`.
    pub backend: &'static str,
    /// What computed.
    pub device: String,
    /// Why that backend: a sentence.
    pub reason: String,
    /// What is counted as dispatches.
    pub dispatches_are: &'static str,
    /// How times were taken.
    pub clock: &'static str,
    /// Pixels across and down.
    pub size: [u32; 2],
    /// The passes, in order.
    pub passes: Vec<Planned>,
    /// What the scene does without.
    pub left_out: Vec<Idle>,
    /// What was no work in the last frame, because it had not changed or does not matter.
    pub idle: Vec<Idle>,
    /// Memory, pass by pass.
    pub buffers: Vec<Memory>,
    /// The pipelines that a GPU compiles for it.
    pub shaders: Vec<String>,
    /// All of them together.
    pub bytes: u64,
    /// Milliseconds of a whole frame.
    pub frame_ms: f64,
    /// By how many of them a half of all frames differ from that.
    pub spread_ms: f64,
    /// Nodes of the tree of blockers that were renewed in the last frame.
    pub renewed_nodes: usize,
    /// How many times the last frame projected the environment.
    pub projections: usize,
}

impl Report {
    pub(super) fn new(
        scene: String,
        plan: &Plan,
        view: &View,
        choice: &Choice,
        measured: Measured,
        estimates: Vec<f64>,
    ) -> Self {
        let on_gpu = choice.gpu.is_some();
        let of_pass = |index: usize| {
            let own = measured.memory.iter().filter(|b| b.pass == index);
            own.map(|buffer| buffer.bytes).sum()
        };
        let passes = plan.passes.iter().enumerate().map(|(i, pass)| Planned {
            name: pass.name(),
            at: pass.at.name(),
            reason: pass.reason.clone(),
            dispatches: measured.dispatches[i],
            bytes: of_pass(i),
            ms: measured.ms[i],
            estimated_ms: (!on_gpu).then_some(estimates[i]),
        });
        let passes: Vec<_> = passes.collect();
        let left = plan.left_out.iter().map(|left| Idle {
            name: left.name,
            reason: left.reason.clone(),
        });
        let memory = measured.memory.iter().map(|buffer| Memory {
            name: buffer.name.clone(),
            pass: plan.passes[buffer.pass].name(),
            bytes: buffer.bytes,
        });
        Self {
            scene,
            backend: if on_gpu { "gpu" } else { "cpu" },
            device: match &choice.gpu {
                Some(gpu) => gpu.name.clone(),
                None => format!("the CPU on {} threads", rayon::current_num_threads()),
            },
            reason: choice.reason.clone(),
            dispatches_are: match on_gpu {
                true => "dispatches and draws",
                false => "tasks handed to the threads",
            },
            clock: measured.clock,
            size: [view.width, view.height],
            bytes: passes.iter().map(|pass| pass.bytes).sum(),
            left_out: left.collect(),
            idle: measured.idle,
            buffers: memory.collect(),
            shaders: plan.shaders.iter().map(ToString::to_string).collect(),
            frame_ms: measured.frame_ms[0],
            spread_ms: measured.frame_ms[1],
            renewed_nodes: measured.changes.nodes,
            projections: measured.changes.projections,
            passes,
        }
    }

    /// Dispatches of all passes together.
    pub fn dispatches(&self) -> u64 {
        self.passes.iter().map(|pass| pass.dispatches).sum()
    }
}

/// Bytes for a person.
pub(super) fn megabytes(bytes: u64) -> String {
    format!("{:.2} MB", bytes as f64 * 1e-6)
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [width, height] = self.size;
        writeln!(
            f,
            "{}, {width} x {height} pixels, on {}.",
            self.scene, self.device
        )?;
        writeln!(f, "{}\n", self.reason)?;
        let header = [
            "pass",
            "at",
            "dispatches",
            "memory",
            "estimated",
            "measured",
        ];
        let [pass, at, dispatches, memory, estimated, ms] = header;
        writeln!(
            f,
            "{pass:<13}{at:<9}{dispatches:>10}{memory:>13}{estimated:>13}{ms:>13}"
        )?;
        for pass in &self.passes {
            let bytes = megabytes(pass.bytes);
            let estimated = pass
                .estimated_ms
                .map_or("".into(), |ms| format!("{ms:.2} ms"));
            let ms = format!("{:.2} ms", pass.ms);
            let Planned {
                name,
                at,
                dispatches,
                ..
            } = pass;
            writeln!(
                f,
                "{name:<13}{at:<9}{dispatches:>10}{bytes:>13}{estimated:>13}{ms:>13}"
            )?;
        }
        let (count, bytes) = (self.dispatches(), megabytes(self.bytes));
        let frame = format!("{:.2} ms", self.frame_ms);
        writeln!(
            f,
            "{:<22}{count:>10}{bytes:>13}{:>13}{frame:>13}",
            "frame", ""
        )?;
        writeln!(
            f,
            "\nDispatches are {}; times are medians, clock: {}.",
            self.dispatches_are, self.clock
        )?;
        writeln!(f, "\nWhy")?;
        for Planned { name, reason, .. } in &self.passes {
            writeln!(f, "  {name:<13}{reason}")?;
        }
        let lists = [
            ("Left out", &self.left_out),
            ("No work in the last frame", &self.idle),
        ];
        for (title, list) in lists {
            if !list.is_empty() {
                writeln!(f, "\n{title}")?;
            }
            for Idle { name, reason } in list {
                writeln!(f, "  {name:<13}{reason}")?;
            }
        }
        writeln!(f, "\nMemory")?;
        for Memory { name, pass, bytes } in &self.buffers {
            writeln!(f, "  {pass:<13}{name:<34}{bytes:>12} bytes")?;
        }
        write!(f, "\nShaders, on a GPU")?;
        for shader in &self.shaders {
            write!(f, "\n  {shader}")?;
        }
        Ok(())
    }
}
