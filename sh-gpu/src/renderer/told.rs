//! What a renderer tells of itself: memory, pipelines, dispatches, uploads and times.

use super::Renderer;
use crate::stages::Stage;
use crate::{Bands, LightGatherPass, Pipelines, ShadowPass};
use sh_scene::PassKind;

impl Renderer {
    /// What light that is sent on depends on, in bytes that have been uploaded.
    pub(super) fn lights_uploaded(&self) -> u64 {
        let shadow = self.shadow.as_ref().map_or(0, ShadowPass::uploaded);
        let gather = self.gather.as_ref().map_or(0, LightGatherPass::uploaded);
        shadow + gather + self.stages.iter().map(Stage::uploaded).sum::<u64>()
    }

    /// Bytes that [`prepare`](Self::prepare) has uploaded since the renderer was made. A frame that is like the one before
    /// it uploads none.
    pub fn uploaded(&self) -> u64 {
        let halves = self.halves.as_ref().map_or(0, Bands::uploaded);
        let views = self.bands.uploaded() + halves;
        views + self.bodies.uploaded() + self.lights_uploaded()
    }

    /// Bytes of GPU memory: what the passes hand each other buffer by buffer, then what each part owns.
    pub fn bytes(&self) -> Vec<(&'static str, u64)> {
        let mut all = self.shared_parts();
        all.extend(self.stages.iter().filter_map(Stage::bytes));
        all
    }

    /// Bytes of what belongs to no stage alone.
    fn shared_parts(&self) -> Vec<(&'static str, u64)> {
        let mut all = self.shared.clone();
        all.push(("bodies", self.bodies.bytes()));
        let halves = self.halves.as_ref().map_or(0, Bands::bytes);
        all.push(("bands", self.bands.bytes() + halves));
        all.extend(self.shadow.as_ref().map(|pass| ("shadow", pass.bytes())));
        all.extend(
            self.gather
                .as_ref()
                .map(|pass| ("light_gather", pass.bytes())),
        );
        all
    }

    /// The pipelines that it is made of.
    pub fn pipelines(&self) -> &Pipelines {
        &self.pipelines
    }

    /// How many dispatches and draws [`record`](Self::record) would record now for each pass of the plan, in its order:
    /// none for [`PassKind::LightUpdate`] where nothing has changed since it was submitted.
    pub fn dispatches(&self) -> Vec<usize> {
        let sent = self.sent.is_current();
        let of = |stage: &Stage| match stage.kind == PassKind::LightUpdate && sent {
            true => 0,
            false => stage.dispatches(self.drawn),
        };
        self.stages.iter().map(of).collect()
    }

    /// All memory, each part with the pass of the plan that owns or first writes it.
    pub fn buffers(&self) -> Vec<sh_scene::Buffer> {
        let of = |kind, half| {
            let own = |stage: &Stage| stage.kind == kind && stage.half == half;
            self.stages.iter().position(own)
        };
        let first =
            |kinds: &[(PassKind, bool)]| kinds.iter().find_map(|&(kind, half)| of(kind, half));
        let (shadow, gather) = (PassKind::Shadow, PassKind::LightGather);
        let shading = [
            (shadow, true),
            (shadow, false),
            (PassKind::Irradiance, false),
        ];
        let parts = self.shared_parts();
        let mut all: Vec<_> = parts
            .into_iter()
            .map(|(name, bytes)| {
                let pass = match name {
                    "half_receivers" => of(PassKind::Gbuffer, true),
                    "half_radiance" => of(shadow, true),
                    "half_sent" => of(gather, true),
                    "radiance" => of(PassKind::Upsample, false).or(first(&shading[1..])),
                    "shadow" => first(&shading),
                    "light_gather" => first(&[(gather, true), (gather, false)]),
                    "picture" => of(PassKind::Resolve, false),
                    _ => of(PassKind::Gbuffer, false),
                };
                (name, pass.unwrap_or(0), bytes)
            })
            .collect();
        let own = self.stages.iter().enumerate();
        all.extend(own.filter_map(|(pass, stage)| {
            let (name, bytes) = stage.bytes()?;
            Some((name, pass, bytes))
        }));
        let buffer = |(name, pass, bytes)| sh_scene::Buffer { name, pass, bytes };
        all.into_iter().map(buffer).collect()
    }

    /// How many timestamps a frame writes.
    pub fn timestamps(&self) -> u32 {
        2 * self.steps().count() as u32
    }

    /// The time each pass of the plan took, over all bands, in nanoseconds, from a frame's timestamps and
    /// `Queue::get_timestamp_period`.
    pub fn times(&self, timestamps: &[u64], period: f32) -> Vec<(PassKind, f64)> {
        let mut times: Vec<_> = self.stages.iter().map(|stage| (stage.kind, 0.0)).collect();
        for ((stage, _), [begin, end]) in self.steps().zip(timestamps.as_chunks().0) {
            let spent = end.saturating_sub(*begin) as f64 * f64::from(period);
            let same = |other: &Stage| std::ptr::eq(other, stage);
            if let Some(index) = self.stages.iter().position(same) {
                times[index].1 += spent;
            }
        }
        times
    }
}
