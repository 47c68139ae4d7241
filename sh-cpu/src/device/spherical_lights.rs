//! What spheres send on, with what it takes to find it.

use super::cut::Cuts;
use super::emission::Emission;
use super::light_cuts::LightCuts;
use sh_scene::Receiver;
use std::ops::Range;

/// What the spheres of all bodies send on, as SH vectors in world space: for every node of a forest. Its memory is kept
/// from frame to frame.
#[derive(Clone, Debug, Default)]
pub struct SphericalLights {
    pub(crate) emission: Emission,
    pub(crate) room: Room,
}

/// What finding it takes, where no plan is worked off.
#[derive(Clone, Debug, Default)]
pub(crate) struct Room {
    pub points: Points,
    pub cuts: Cuts,
    pub light_cuts: LightCuts,
}

/// Points of surfaces as receivers, with their light.
#[derive(Clone, Debug, Default)]
pub(crate) struct Points {
    pub receivers: Vec<Receiver>,
    /// Those of each sphere.
    pub clusters: Vec<Range<usize>>,
    /// Light that no body has sent.
    pub radiance: Vec<[f32; 3]>,
    /// Light that bodies have sent.
    pub sent: Vec<[f32; 3]>,
}

impl SphericalLights {
    /// The SH order of what is sent on: that of the light.
    pub fn order(&self) -> usize {
        self.emission.order()
    }

    /// What a node of the forest emits: radiance as a function of the direction from its centre, coefficient by
    /// coefficient in three channels.
    pub fn emission(&self, node: u32) -> &[[f32; 3]] {
        self.emission.of(node)
    }

    /// No part of any surface sends on more radiance than this.
    pub fn brightest(&self) -> [f32; 3] {
        self.emission.brightest()
    }

    /// Bytes of what nodes emit.
    pub(crate) fn bytes(&self) -> usize {
        self.emission.bytes()
    }
}
