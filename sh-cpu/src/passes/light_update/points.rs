//! Points of surfaces as receivers.

use super::body::{Body, rotation};
use crate::device::cut::CutOptions;
use crate::device::spherical_lights::Points;
use crate::error::Error;
use crate::lanes::path::Path;
use crate::passes::shadow::{Shadow, shadow_clusters};
use glam::Vec3;
use sh_scene::{Forest, Light, Receiver};

impl Points {
    /// Puts all points where they are now.
    pub(super) fn place<'a>(&mut self, bodies: impl IntoIterator<Item = Body<'a>>) {
        self.receivers.clear();
        self.clusters.clear();
        for (object, body) in bodies.into_iter().enumerate() {
            let turn = rotation(&body.transform);
            for sphere in 0..body.spheres {
                let first = self.receivers.len();
                let points = body.surface.of(sphere).iter().map(|point| Receiver {
                    position: body
                        .transform
                        .transform_point3(point.position.into())
                        .into(),
                    covered: 1,
                    normal: (turn * Vec3::from(point.normal)).into(),
                    object: object as u32 + 1,
                });
                self.receivers.extend(points);
                self.clusters.push(first..self.receivers.len());
            }
        }
        let count = self.receivers.len();
        self.direct.resize(count, [0.0; 3]);
        self.indirect.clear();
        self.indirect.resize(count, [0.0; 3]);
    }

    /// Lights them.
    pub(super) fn shade(
        &mut self,
        path: Path,
        forest: &Forest,
        light: &Light,
        cut: CutOptions,
    ) -> Result<(), Error> {
        self.cuts
            .bound(&self.receivers, &self.clusters, 0..self.clusters.len());
        self.cuts.dim(light);
        self.cuts.find(path, forest, light, cut);
        let shadow = Shadow {
            clusters: &self.clusters,
            cuts: &self.cuts,
            light,
            accumulation: cut.accumulation,
            baked: None,
        };
        shadow_clusters(path, &self.receivers, &shadow, &mut self.direct)
    }
}
