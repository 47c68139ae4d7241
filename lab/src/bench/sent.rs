//! Light that the spheres of a scene's bodies send on: what a host keeps of it from frame to frame.

use super::surface::Surface;
use super::world::ORDER;
use gaunt::Error;
use glam::Affine3A;
use sh_cpu::{
    CutOptions, LightCutOptions, LightCuts, LightGather, LightUpdate, Path, SphericalLights,
    light_gather,
};
use sh_scene::{Body, Forest, Indirect, Light, Limits, Receiver};
use std::ops::Range;

/// What sends light on, and what arrives of it.
pub struct Sent {
    /// How.
    pub indirect: Indirect,
    /// The spheres that light each cluster.
    pub cuts: LightCuts,
    /// What a frame computes.
    pub radiance: Vec<[f32; 3]>,
    surfaces: Vec<Surface>,
    lights: SphericalLights,
}

impl Sent {
    /// Nothing yet, for bodies with these surfaces.
    pub fn new(indirect: Indirect, surfaces: Vec<Surface>, receivers: usize) -> Self {
        Self {
            indirect,
            cuts: LightCuts::default(),
            radiance: vec![[0.0; 3]; receivers],
            surfaces,
            lights: SphericalLights::default(),
        }
    }

    /// How many points the surfaces have.
    pub fn points(&self) -> usize {
        self.surfaces.iter().map(|s| s.now.points.len()).sum()
    }

    /// Moves the surfaces along with all segments, body by body.
    pub fn pose(&mut self, poses: &[Affine3A]) {
        let mut rest = poses;
        for surface in &mut self.surfaces {
            let (own, others) = rest.split_at(surface.segments);
            surface.pose(own);
            rest = others;
        }
    }

    /// Finds what every sphere sends on.
    ///
    /// # Errors
    /// Where the pass refuses what it is given, which does not happen.
    pub fn update(
        &mut self,
        path: Path,
        forest: &Forest,
        light: &Light,
        limits: Limits,
    ) -> Result<(), Error> {
        let bodies = self.surfaces.iter().map(|surface| Body {
            surface: &surface.now,
            transform: Affine3A::IDENTITY,
            spheres: surface.now.spheres(),
        });
        let update = LightUpdate {
            indirect: self.indirect,
            limits,
            accumulation: ORDER,
        };
        Ok(self.lights.update(path, bodies, forest, light, update)?)
    }

    /// Finds the spheres that light each cluster.
    pub fn find(
        &mut self,
        path: Path,
        receivers: &[Receiver],
        clusters: &[Range<usize>],
        forest: &Forest,
        limits: Limits,
    ) {
        let options = LightCutOptions {
            cut: CutOptions {
                limits,
                ratios: true,
                accumulation: ORDER,
            },
            blocking: self.indirect.blocking,
        };
        let lights = &self.lights;
        self.cuts
            .find(path, receivers, clusters, forest, lights, options);
    }

    /// Gathers what they send on.
    ///
    /// # Errors
    /// Where the pass refuses what it is given, which does not happen.
    pub fn gather(
        &mut self,
        path: Path,
        receivers: &[Receiver],
        clusters: &[Range<usize>],
    ) -> Result<(), Error> {
        let gather = LightGather {
            clusters,
            cuts: &self.cuts,
            lights: &self.lights,
            eye: None,
        };
        light_gather(path, receivers, &gather, &mut self.radiance)?;
        Ok(())
    }
}
