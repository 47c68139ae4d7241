//! What spheres send on, with what it takes to find it.

use super::cut::Cuts;
use super::emission::Emission;
use super::light_cuts::LightCuts;
use sh_scene::{Forest, Receiver};
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
    /// Light that bodies have sent, on the first of them.
    pub sent: Vec<[f32; 3]>,
    /// How many take it, if not all, in how many clusters.
    pub few: Option<[usize; 2]>,
}

impl SphericalLights {
    /// Bodies that shine by themselves, each with as many of the forest's spheres, one after another, and with one radiance
    /// (linear Rec.709) in every direction; `order`, 2 to 6, is that in which they will be gathered.
    ///
    /// ```
    /// use sh_cpu::SphericalLights;
    /// use sh_scene::{Forest, Sphere};
    /// let ball = [Sphere { center: [0.0; 3], radius: 1.0 }];
    /// let lamp = SphericalLights::even(&Forest::new(&ball, &[1]), 4, &[(1, [2.0, 1.0, 0.5])]);
    /// assert_eq!(lamp.brightest(), [2.0, 1.0, 0.5]);
    /// ```
    pub fn even(forest: &Forest, order: usize, bodies: &[(usize, [f32; 3])]) -> Self {
        Self {
            emission: Emission::even(forest, order, bodies),
            ..Self::default()
        }
    }

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
