//! The tables of a scene file that are about the whole scene.

use super::content::{CameraName, SceneFile};
use crate::error::Error;
use crate::keys::{FAR, Section, albedo, beside};
use glam::Vec3;
use sh_core::ORDERS;
use sh_scene::{Camera, Limits};
use std::path::Path;

/// Keys of [environment].
pub(super) const ENVIRONMENT: [&str; 6] =
    ["map", "rotation", "turn", "intensity", "sun", "enabled"];
/// Keys of [ground].
pub(super) const GROUND: [&str; 3] = ["height", "albedo", "enabled"];
/// Keys of [camera].
pub(super) const CAMERA: [&str; 4] = ["eye", "target", "fov", "name"];
/// Keys of [settings].
pub(super) const SETTINGS: [&str; 7] = [
    "order",
    "accumulation_order",
    "window",
    "shadows",
    "half_resolution",
    "blocker_angle",
    "gloss",
];

impl SceneFile {
    /// `path` is what the map's path is relative to.
    pub(super) fn read_environment(&mut self, s: &Section, path: &Path) -> Result<(), Error> {
        self.map = s.string("map")?.map(|map| beside(path, map));
        let rotation = s.number("rotation", "of degrees", |n| n.abs() < FAR)?;
        self.rotation = rotation.unwrap_or(0.0).to_radians();
        let turn = s.number("turn", "of degrees a second", |n| n.abs() < FAR)?;
        self.turn = turn.unwrap_or(0.0);
        self.intensity = s
            .number("intensity", "from 0 to 1e6", |n| (0.0..=1e6).contains(&n))?
            .unwrap_or(1.0);
        self.sky = s.boolean("enabled")?.unwrap_or(true);
        self.lift = match s.string("sun")? {
            None | Some("keep") => false,
            Some("lift") => true,
            Some(other) => {
                let message = format!("is \"{other}\", but it has to be \"keep\" or \"lift\".");
                return Err(s.error("sun", message));
            }
        };
        if self.lift && self.turn != 0.0 {
            return Err(s.error(
                "sun",
                "has no place beside environment.turn: a sun that is lifted stands still.",
            ));
        }
        Ok(())
    }

    pub(super) fn read_ground(&mut self, s: &Section) -> Result<(), Error> {
        self.ground = s.boolean("enabled")?.unwrap_or(true);
        self.ground_height = s.number("height", "of metres", |n| n.abs() < FAR)?;
        self.ground_albedo = albedo(s)?.unwrap_or(self.ground_albedo);
        Ok(())
    }

    pub(super) fn read_camera(&mut self, s: &Section) -> Result<(), Error> {
        self.eye = s.triple("eye", "of metres", false, |n| n.abs() < FAR)?;
        self.target = s.triple("target", "of metres", false, |n| n.abs() < FAR)?;
        let fov = s.number("fov", "of degrees from 1 to 170", |n| {
            (1.0..=170.0).contains(&n)
        })?;
        self.fov = fov.map(f32::to_radians);
        self.view = s.string_or_count("name")?.map(|name| CameraName {
            name,
            line: s.line("name"),
        });
        if self.view.is_some()
            && let Some(key) = ["eye", "target"].into_iter().find(|key| s.has(key))
        {
            return Err(s.error(key, "has no place beside camera.name: the file says it."));
        }
        if let (Some(eye), Some(target)) = (self.eye, self.target) {
            let target = Vec3::from(target);
            if Vec3::from(eye).distance(target) < Camera::nearest(target) {
                return Err(s.error(
                    "target",
                    "is the same point as camera.eye, as far as single precision can tell, so there is \
                     nowhere to look.",
                ));
            }
        }
        Ok(())
    }

    pub(super) fn read_settings(&mut self, s: &Section) -> Result<(), Error> {
        let settings = &mut self.settings;
        if let Some(order) = s.count("order", ORDERS)? {
            *settings = settings.with_order(order);
        }
        if let Some(accumulation) = s.count("accumulation_order", ORDERS)? {
            if accumulation < settings.order {
                let order = settings.order;
                let message = format!(
                    "is {accumulation}, but it has to be a whole number from the order, {order}, to 6."
                );
                return Err(s.error("accumulation_order", message));
            }
            settings.accumulation = accumulation;
        }
        if let Some(window) = s.number("window", "above 0", |n| n > 0.0)? {
            settings.window = Some(window);
        }
        settings.shadows = s.boolean("shadows")?.unwrap_or(true);
        settings.gloss = s.boolean("gloss")?.unwrap_or(settings.gloss);
        let half = s.boolean("half_resolution")?;
        settings.half_resolution = half.unwrap_or(settings.half_resolution);
        // Beyond 30° a node's logarithm is no measure for that of its leaves.
        let angle = s.number("blocker_angle", "of degrees from 0 to 30", |n| {
            (0.0..=30.0).contains(&n)
        })?;
        if let Some(angle) = angle {
            settings.limits = match angle {
                0.0 => Limits::LEAVES,
                angle => Limits {
                    sin_max: angle.to_radians().sin(),
                    ..settings.limits
                },
            };
        }
        Ok(())
    }
}
