//! The `light_update` pass: what every sphere of a body sends on (Guerrero et al. 2008, section 5).
//!
//! Points of the surface around a sphere are receivers like any others: the shadow pass lights them, all at once. Each
//! sends on its radiance times the albedo of its direction's Voronoi cell, and the sum over all of them, in spherical
//! harmonics, is what the sphere emits (equation 10), turned to world space. The paper leaves it as it is and turns the
//! weights at every receiver; there are many more receivers than spheres.
//!
//! A node of the forest that stands for several spheres emits their mean by cross-section; what is left between its light
//! and theirs is made up for each cluster (section 7.3, [`crate::LightCuts`]).
//!
//! With several bounces the light that spheres send on is gathered at the points as well, once a bounce.

mod body;
mod emit;
mod points;

pub use body::Body;

use super::light_gather::{LightGather, light_gather};
use crate::device::cut::CutOptions;
use crate::device::light_order::LightCutOptions;
use crate::device::spherical_lights::{Points, SphericalLights};
use crate::error::Error;
use crate::lanes::path::Path;
use sh_scene::{Forest, Indirect, Light, Limits};

/// How light is sent on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightUpdate {
    /// How often, and what hides what.
    pub indirect: Indirect,
    /// How coarse the spheres may be that shade and light the points.
    pub limits: Limits,
    /// The order of accumulation of the points' shadows, from the light's order to 6.
    pub accumulation: usize,
}

impl SphericalLights {
    /// Finds what every node of `forest` sends on of `light`, as everything stands now. The forest is that of all
    /// `bodies`' spheres.
    ///
    /// # Errors
    /// Where the light is none, or the bodies do not have the forest's spheres.
    pub fn update<'a>(
        &mut self,
        path: Path,
        bodies: impl IntoIterator<Item = Body<'a>> + Clone,
        forest: &Forest,
        light: &Light,
        update: LightUpdate,
    ) -> Result<(), Error> {
        let spheres: usize = bodies.clone().into_iter().map(|body| body.spheres).sum();
        if spheres != forest.spheres() {
            return Err(Error::Length {
                buffer: "bodies",
                expected: forest.spheres(),
                found: spheres,
            });
        }
        self.emission.order = light.order;
        self.points.place(bodies.clone());
        self.emission
            .own(bodies.clone().into_iter().map(|body| body.spheres), forest);
        let cut = CutOptions {
            limits: update.limits,
            ratios: true,
            accumulation: update.accumulation,
        };
        self.points.shade(path, forest, light, cut)?;
        let within_bodies = update.indirect.blocking.within_bodies();
        self.emission
            .emit(&self.points, bodies.clone(), forest, within_bodies)?;
        for _ in 1..update.indirect.bounces {
            let mut cuts = std::mem::take(&mut self.light_cuts);
            let mut points = std::mem::take(&mut self.points);
            let Points {
                receivers,
                clusters,
                indirect,
                ..
            } = &mut points;
            let options = LightCutOptions {
                cut: CutOptions {
                    accumulation: light.order,
                    ..cut
                },
                blocking: update.indirect.blocking,
            };
            cuts.find(path, receivers, clusters, forest, self, options);
            let gather = LightGather {
                clusters,
                cuts: &cuts,
                lights: self,
            };
            let gathered = light_gather(path, receivers, &gather, indirect);
            (self.light_cuts, self.points) = (cuts, points);
            gathered?;
            self.emission
                .emit(&self.points, bodies.clone(), forest, within_bodies)?;
        }
        Ok(())
    }
}
