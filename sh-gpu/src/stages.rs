//! The passes of a plan on the GPU, bound to the buffers of a frame: what is recorded of each.

use crate::bases::{Bases, Gathering};
use crate::plain::Plain;
use crate::punctual::PunctualPass;
use crate::surfaces::Surfaces;
use crate::views::Views;
use crate::{
    Bands, Bodies, Bound, GbufferPass, IrradiancePass, LightGatherPass, ResolvePass, ShadowPass,
    UpsampleBound, UpsamplePass,
};
use sh_scene::{Domain, Pass};
use std::sync::Arc;
use wgpu::{Buffer, CommandEncoder, ComputePassTimestampWrites};

/// One pass of the plan, with what it binds for every band.
#[derive(Debug)]
pub(crate) struct Stage {
    pub pass: &'static Pass,
    pub at: Domain,
    /// How often a frame records it.
    pub turns: usize,
    pub work: Work,
}

/// A pass and what it is bound to, band by band. Those that several passes of a plan share are one.
#[derive(Debug)]
pub(crate) enum Work {
    Points {
        surfaces: Arc<Surfaces>,
        bound: Bound,
        /// What is cleared: light that bodies have sent.
        sent: Buffer,
    },
    LightUpdate {
        surfaces: Arc<Surfaces>,
        bound: Bound,
    },
    /// Points of patches.
    PatchPoints {
        bases: Arc<Bases>,
        bound: Bound,
        /// What is cleared: light that bodies have sent.
        sent: Buffer,
    },
    BasisUpdate {
        bases: Arc<Bases>,
        bound: Bound,
    },
    Gbuffer {
        pass: GbufferPass,
        bound: Vec<Bound>,
    },
    Irradiance {
        pass: IrradiancePass,
        bound: Vec<Bound>,
    },
    Shadow {
        pass: Arc<ShadowPass>,
        bound: Vec<Bound>,
    },
    LightGather {
        pass: Arc<LightGatherPass>,
        bound: Vec<Bound>,
        /// What has to be cleared before the first band, or in every turn.
        cleared: Option<Buffer>,
    },
    BasisGather {
        bases: Arc<Bases>,
        bound: Vec<Bound>,
        /// What has to be cleared before the first band, or in every turn.
        cleared: Option<Buffer>,
    },
    LightView {
        views: Arc<Views>,
    },
    Punctual {
        pass: PunctualPass,
        bound: Vec<Bound>,
    },
    Shares {
        pass: Arc<UpsamplePass>,
        bound: Vec<Bound>,
    },
    Upsample {
        pass: Arc<UpsamplePass>,
        bound: Vec<UpsampleBound>,
    },
    Scatter {
        pass: Arc<UpsamplePass>,
        bound: Vec<UpsampleBound>,
    },
    Resolve {
        pass: ResolvePass,
        bound: Vec<Bound>,
    },
    Plain(Plain),
}

/// What a stage is recorded with.
#[derive(Clone, Copy)]
pub(crate) struct Recording<'a> {
    /// The bands of the stage's domain.
    pub bands: &'a Bands,
    /// Which of them; 0 where the stage has none.
    pub band: u32,
    pub bodies: &'a Bodies,
    /// Whether what it makes is on the device as it would be made.
    pub kept: bool,
    /// The queries of begin and end.
    pub stamps: Option<(&'a wgpu::QuerySet, [u32; 2])>,
}

impl Stage {
    /// Records a band of it, or all of it where it has none.
    pub fn record(&self, encoder: &mut CommandEncoder, recording: Recording) {
        let Recording {
            bands,
            band,
            bodies,
            kept,
            stamps,
        } = recording;
        let writes = stamps.map(|(query_set, [begin, end])| ComputePassTimestampWrites {
            query_set,
            beginning_of_pass_write_index: Some(begin),
            end_of_pass_write_index: Some(end),
        });
        if kept {
            // Timestamps are written all the same: whoever reads them waits for them.
            if writes.is_some() {
                encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
                    label: Some("gaunt pass, unchanged"),
                    timestamp_writes: writes,
                });
            }
            return;
        }
        let at = band as usize;
        match &self.work {
            Work::Points {
                surfaces,
                bound,
                sent,
            } => {
                encoder.clear_buffer(sent, 0, None);
                surfaces.record_points(encoder, bound, writes);
            }
            Work::LightUpdate { surfaces, bound } => {
                surfaces.record_update(encoder, bound, writes);
            }
            Work::PatchPoints { bases, bound, sent } => {
                encoder.clear_buffer(sent, 0, None);
                bases.record_points(encoder, bound, writes);
            }
            Work::BasisUpdate { bases, bound } => bases.record_update(encoder, bound, writes),
            Work::BasisGather {
                bases,
                bound,
                cleared,
            } => {
                if let (0, Some(cleared)) = (band, cleared) {
                    encoder.clear_buffer(cleared, 0, None);
                }
                bases.record_gather(encoder, &bound[at], gathering(self.at), writes);
            }
            Work::Gbuffer { pass, bound } => {
                pass.record(encoder, bands, band, bodies, &bound[at], stamps);
            }
            Work::LightView { views } => views.record(encoder, bodies, stamps),
            Work::Punctual { pass, bound } => pass.record(encoder, &bound[at], writes),
            Work::Irradiance { pass, bound } => pass.record(encoder, &bound[at], writes),
            Work::Shadow { pass, bound } => pass.record(encoder, &bound[at], writes),
            Work::LightGather {
                pass,
                bound,
                cleared,
            } => {
                if let (0, Some(cleared)) = (band, cleared) {
                    encoder.clear_buffer(cleared, 0, None);
                }
                pass.record(encoder, &bound[at], writes);
            }
            Work::Shares { pass, bound } => pass.record_shares(encoder, &bound[at], writes),
            Work::Upsample { pass, bound } => {
                pass.record(encoder, bands, band, &bound[at], writes);
            }
            Work::Scatter { pass, bound } => {
                pass.record_scatter(encoder, bands, band, &bound[at], writes);
            }
            Work::Resolve { pass, bound } => {
                pass.record(encoder, bands, band, &bound[at], writes);
            }
            Work::Plain(plain) => plain.record(encoder, bands, band, writes),
        }
    }

    /// How many dispatches and draws a frame records; `drawn` is what is drawn of a band.
    pub fn dispatches(&self, drawn: usize) -> usize {
        let all = |bounds: &[Bound]| bounds.iter().map(Bound::dispatches).sum::<usize>();
        let once = match &self.work {
            Work::Points { bound, .. } => bound.dispatches(),
            Work::PatchPoints { bound, .. } => bound.dispatches(),
            Work::LightUpdate { surfaces, bound } => surfaces.update_dispatches(bound),
            Work::BasisUpdate { bases, bound } => bases.update_dispatches(bound),
            Work::Gbuffer { bound, .. } => all(bound) + bound.len() * drawn,
            Work::LightView { views } => views.dispatches(drawn),
            Work::Irradiance { bound, .. }
            | Work::Punctual { bound, .. }
            | Work::Shadow { bound, .. }
            | Work::LightGather { bound, .. }
            | Work::BasisGather { bound, .. }
            | Work::Shares { bound, .. }
            | Work::Resolve { bound, .. }
            | Work::Plain(Plain { bound, .. }) => all(bound),
            Work::Upsample { bound, .. } => bound.iter().map(UpsampleBound::dispatches).sum(),
            Work::Scatter { bound, .. } => {
                let bands = bound.iter().map(UpsampleBound::scatter_dispatches);
                bands.sum()
            }
        };
        once * self.turns
    }

    /// Bytes that have been uploaded for it alone since it was made.
    pub fn uploaded(&self) -> u64 {
        match &self.work {
            Work::Irradiance { pass, .. } => pass.uploaded(),
            _ => 0,
        }
    }

    /// Bytes of GPU memory of a pass that this stage owns; those that several stages share are not counted.
    pub fn bytes(&self) -> Option<u64> {
        Some(match &self.work {
            Work::Points { surfaces, .. } => surfaces.bytes(),
            Work::PatchPoints { bases, .. } => bases.bytes(),
            Work::Gbuffer { pass, .. } => pass.bytes(),
            Work::LightView { views } => views.bytes(),
            Work::Irradiance { pass, .. } => pass.bytes(),
            Work::Resolve { pass, .. } => pass.bytes(),
            _ => return None,
        })
    }
}

/// Who gathers what patches send in a domain.
pub(crate) fn gathering(at: Domain) -> Gathering {
    match at {
        Domain::Patches => Gathering::Points,
        Domain::Gloss => Gathering::Gloss,
        _ => Gathering::Seen,
    }
}
