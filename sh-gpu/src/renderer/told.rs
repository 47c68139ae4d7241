//! What a renderer tells of itself: memory, pipelines, dispatches, uploads and times.

use super::Renderer;
use crate::stages::Stage;
use crate::{Bands, Pipelines};
use sh_scene::passes::{LIGHT_GATHER, UPSAMPLE};
use sh_scene::resource::{BLOCKERS, RECEIVERS};
use sh_scene::{Domain, Pass};
use std::borrow::Cow;

impl Renderer {
    /// What light that is sent on depends on, in bytes that have been uploaded.
    pub(super) fn lights_uploaded(&self) -> u64 {
        let inputs = self.inputs.as_ref().map_or(0, |inputs| inputs.uploaded());
        let gather = self.gather.as_ref().map_or(0, |pass| pass.uploaded());
        let surfaces = self.surfaces.as_ref().map_or(0, |s| s.uploaded());
        let bases = self.bases.as_ref().map_or(0, |bases| bases.uploaded());
        let views = self.views.as_ref().map_or(0, |views| views.uploaded());
        inputs
            + gather
            + surfaces
            + bases
            + views
            + self.stages.iter().map(Stage::uploaded).sum::<u64>()
    }

    /// The same, with the bodies where lights look at these.
    pub(super) fn seen_uploaded(&self) -> u64 {
        let bodies = self.views.as_ref().map_or(0, |_| self.bodies.uploaded());
        self.lights_uploaded() + bodies
    }

    /// Bytes that [`prepare`](Self::prepare) has uploaded since the renderer was made. A frame that is like the one before
    /// it uploads none.
    pub fn uploaded(&self) -> u64 {
        let halves = self.halves.as_ref().map_or(0, Bands::uploaded);
        let views = self.bands.uploaded() + halves;
        views + self.bodies.uploaded() + self.lights_uploaded()
    }

    /// Bytes of GPU memory: what the passes hand each other buffer by buffer, then what each part owns.
    pub fn bytes(&self) -> Vec<(Cow<'static, str>, u64)> {
        let buffers = self.buffers().into_iter();
        buffers.map(|buffer| (buffer.name, buffer.bytes)).collect()
    }

    /// The pipelines that it is made of.
    pub fn pipelines(&self) -> &Pipelines {
        &self.pipelines
    }

    /// How many dispatches and draws [`record`](Self::record) would record now for each pass of the plan, in its order:
    /// none for those that find what spheres send on, where nothing has changed since they were submitted.
    pub fn dispatches(&self) -> Vec<usize> {
        let sent = self.sent.is_current();
        let of = |stage: &Stage| match stage.at.is_kept() && sent {
            true => 0,
            false => stage.dispatches(self.drawn),
        };
        self.stages.iter().map(of).collect()
    }

    /// All memory, each part with the pass of the plan that owns or first writes it.
    pub fn buffers(&self) -> Vec<sh_scene::Buffer> {
        let seen = self.plan.maker(RECEIVERS, Domain::Samples);
        let first = |pass: &Pass| self.plan.passes.iter().position(|p| p.is(pass));
        let mut slots = self.plan.passes.iter().map(|pass| pass.slots());
        let blocked = slots.position(|slots| slots.iter().any(|s| s.resource == BLOCKERS));
        let halves = self.halves.as_ref().map_or(0, Bands::bytes);
        let own = [
            ("bodies", seen, Some(self.bodies.bytes())),
            ("bands", seen, Some(self.bands.bytes() + halves)),
            (
                "light_and_blockers",
                blocked,
                self.inputs.as_ref().map(|inputs| inputs.bytes()),
            ),
            (
                "light_gather",
                first(&LIGHT_GATHER),
                self.gather.as_ref().map(|pass| pass.bytes()),
            ),
            (
                "upsample",
                first(&UPSAMPLE),
                self.upsample.as_ref().map(|pass| pass.bytes()),
            ),
        ];
        let own = own.into_iter();
        let own = own.filter_map(|(name, pass, bytes)| Some((name.into(), pass?, bytes?)));
        let stages = self.stages.iter().enumerate();
        let stages =
            stages.filter_map(|(at, stage)| Some((stage.pass.name.into(), at, stage.bytes()?)));
        let all = self.buffers.told().chain(own).chain(stages);
        all.map(|(name, pass, bytes)| sh_scene::Buffer { name, pass, bytes })
            .collect()
    }

    /// How many timestamps a frame writes.
    pub fn timestamps(&self) -> u32 {
        2 * self.steps.len() as u32
    }

    /// The time each pass of the plan took, over all bands, in nanoseconds, from a frame's timestamps and
    /// `Queue::get_timestamp_period`.
    pub fn times(&self, timestamps: &[u64], period: f32) -> Vec<(&'static str, f64)> {
        let passes = self.stages.iter();
        let mut times: Vec<_> = passes.map(|stage| (stage.pass.name, 0.0)).collect();
        for (step, [begin, end]) in self.steps.iter().zip(timestamps.as_chunks().0) {
            times[step.pass].1 += end.saturating_sub(*begin) as f64 * f64::from(period);
        }
        times
    }
}
