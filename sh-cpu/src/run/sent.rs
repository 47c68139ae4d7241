//! What spheres send on, for whoever works off no plan.

use super::work::Stages;
use crate::device::spherical_lights::{Room, SphericalLights};
use crate::error::Error;
use crate::lanes::path::Path;
use crate::passes::points::place;
use crate::store::{Counts, Spheres};
use sh_scene::{Body, Forest, Indirect, Light, Limits, Settings};

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
    /// Finds what every node of `forest` sends on of `light`, as everything stands now: the passes `points`, `shadow` and
    /// `light_update`, and for each further bounce `light_gather` and `light_update` again. The forest is that of all
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
        let mut room = std::mem::take(&mut self.room);
        let Room {
            points,
            cuts,
            light_cuts,
        } = &mut room;
        let (mut patch_lights, mut patch_cuts, mut point_cuts) = Default::default();
        let mut spheres = Spheres {
            path,
            forest,
            light,
            settings: Settings {
                order: light.order,
                accumulation: update.accumulation,
                limits: update.limits,
                indirect: Some(update.indirect),
                ..Settings::default()
            },
            cuts,
            lights: self,
            light_cuts,
            patch_lights: &mut patch_lights,
            patch_cuts: &mut patch_cuts,
            point_cuts: &mut point_cuts,
            counts: Counts::default(),
        };
        let mut stages = Stages::default();
        let mut steps = || {
            place(bodies.clone(), points);
            spheres.shade(&mut points.set(), &mut stages)?;
            spheres.update(points, bodies.clone())?;
            for _ in 1..update.indirect.bounces {
                points.sent = spheres.gather(&points.set(), &mut stages)?;
                spheres.update(points, bodies.clone())?;
            }
            Ok(())
        };
        let done = steps();
        self.room = room;
        done
    }
}
